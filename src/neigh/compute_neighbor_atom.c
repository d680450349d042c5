/* Compute neighbor/atom: number of neighbours of each particle. */
#include "contact/contact_view.h"
#include "neigh/neigh.h"

#include "base/banned.h"

struct state {
	struct tsim *sim;
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	((struct state *)self->state)->sim = sim;
	sim->neigh->skin_observed = true;
	return TS_OK;
}

/* A pair across a periodic face is listed once for each side: each entry counts for its own local particle.
 */
static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct ts_particles *p = sim->particles;
	const struct ts_contact_list *list = &sim->neigh->contacts;

	TS_TRY(ts_contacts_require(((const struct state *)self->state)->sim, self));
	TS_TRY(ts_table_resize(out, p->n, 1));
	for (size_t i = 0; i < p->n; i++)
		out->data[i] = 0;
	for (size_t r = 0; r < list->n; r++) {
		size_t end[2] = { (size_t)list->i[r], (size_t)list->j[r] };

		for (int s = 0; s < 2; s++)
			if (end[s] < p->n && ts_in_group(p, end[s], self->group))
				out->data[end[s]] += 1;
	}
	return TS_OK;
}

static const struct ts_value values[] = {
	{ "neighbours", "", "number of neighbours; 0 outside the group", TS_PERATOM, 1, NULL, eval },
	{ .name = NULL },
};

static const struct ts_arg args[] = { TS_ARGS_END };

TS_STYLE(compute, ts_style, ts_compute_neighbor_atom)
const struct ts_style ts_compute_neighbor_atom = {
	.name = "neighbor/atom",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE,
	.summary = "Number of neighbours of each particle",
	.doc = "Number of other particles, of any group, that were nearer than the sum of the radii plus the "
	       "skin (command neighbor) when the neighbour list was built last. Periodic images count, "
	       "excluded pairs do not. As long as this compute exists, the list is built with the given "
	       "skin.",
	.example = "compute n all neighbor/atom\ncompute mean all reduce ave c_n",
	.args = args,
	.state_size = sizeof(struct state),
	.values = values,
	.init = init,
};
