#include "contact/contact_view.h"
#include "neigh/neigh.h"
#include "particle/particles.h"

#include <math.h>

#include "base/banned.h"

struct state {
	struct tsim *sim;
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	((struct state *)self->state)->sim = sim;
	sim->neigh->keep_forces = true;
	return TS_OK;
}

/* Whether pair r is a contact of two particles of the group. A contact across a periodic face is listed
 * twice: the entry whose i has the smaller identity counts. */
static bool is_counted(const struct ts_instance *self, const struct ts_particles *p,
		       const struct ts_contact_list *list, size_t r)
{
	size_t i = (size_t)list->i[r], j = (size_t)list->j[r];

	if (!ts_contact_touches(list, r) || !ts_in_group(p, i, self->group) ||
	    !ts_in_group(p, j, self->group))
		return false;
	if (j < p->n || p->tag[i] < p->tag[j])
		return true;
	return p->tag[i] == p->tag[j] && ts_contact_image(list, r) > TS_IMAGE_SELF;
}

static size_t count_contacts(const struct ts_instance *self, const struct tsim *sim)
{
	const struct ts_contact_list *list = &sim->neigh->contacts;
	size_t n = 0;

	for (size_t r = 0; r < list->n; r++)
		n += is_counted(self, sim->particles, list, r);
	return n;
}

static enum ts_status eval_count(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	TS_TRY(ts_contacts_require(((const struct state *)self->state)->sim, self));
	out->data[0] = (double)count_contacts(self, sim);
	return TS_OK;
}

static enum ts_status eval_peratom(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct ts_contact_list *list = &sim->neigh->contacts;
	const struct ts_particles *p = sim->particles;

	TS_TRY(ts_contacts_require(((const struct state *)self->state)->sim, self));
	TS_TRY(ts_table_resize(out, p->n, 1));
	for (size_t i = 0; i < p->n; i++)
		out->data[i] = 0;
	for (size_t r = 0; r < list->n; r++) {
		if (!ts_contact_touches(list, r))
			continue;
		if (ts_in_group(p, (size_t)list->i[r], self->group))
			out->data[list->i[r]] += 1;
		if ((size_t)list->j[r] < p->n && ts_in_group(p, (size_t)list->j[r], self->group))
			out->data[list->j[r]] += 1;
	}
	return TS_OK;
}

enum { COLUMNS = 15 };

static void write_row(const struct tsim *sim, size_t r, double row[COLUMNS])
{
	const struct ts_contact_list *list = &sim->neigh->contacts;
	const struct ts_particles *p = sim->particles;
	size_t i = (size_t)list->i[r], j = (size_t)list->j[r];
	bool swap = ts_contact_tag(list, r, 0) > ts_contact_tag(list, r, 1); /* the smaller identity first */
	size_t a = swap ? j : i, b = swap ? i : j;
	const double *force = ts_contact_force(list, ts_contact_kept(list, r));
	double d2 = 0;

	row[0] = p->tag[a];
	row[1] = p->tag[b];
	for (int k = 0; k < 3; k++) {
		double d = p->x[i][k] - p->x[j][k];

		d2 += d * d;
		row[3 + k] = p->x[a][k];
		row[6 + k] = p->x[b][k];
		row[9 + k] = swap ? -force[k] : force[k];
		row[12 + k] = 0.5 * (p->x[a][k] + p->x[b][k]);
	}
	row[2] = p->radius[i] + p->radius[j] - sqrt(d2);
}

static enum ts_status eval_local(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct ts_contact_list *list = &sim->neigh->contacts;
	size_t n = 0;

	TS_TRY(ts_contacts_forces(((const struct state *)self->state)->sim, self));
	TS_TRY(ts_table_resize(out, count_contacts(self, sim), COLUMNS));
	for (size_t r = 0; r < list->n; r++)
		if (is_counted(self, sim->particles, list, r))
			write_row(sim, r, out->data + COLUMNS * n++);
	return TS_OK;
}

static const char *const names[] = { "i",  "j",	 "overlap", "xi", "yi", "zi", "xj", "yj",
				     "zj", "fx", "fy",	    "fz", "x",	"y",  "z" };
static const struct ts_value values[] = {
	{ "count", "", "number of contacts between particles of the group", TS_SCALAR, 1, NULL, eval_count },
	{ "coordination", "", "contacts of each particle", TS_PERATOM, 1, NULL, eval_peratom },
	{ "list", "", "a row for each contact, with the force on i and the midpoint", TS_LOCAL, COLUMNS,
	  names, eval_local },
	{ .name = NULL },
};

static const struct ts_arg args[] = { TS_ARGS_END };

TS_STYLE(compute, ts_style, ts_compute_contacts)
const struct ts_style ts_compute_contacts = {
	.name = "contacts",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE,
	.summary = "number, coordination and list of the contacts",
	.doc = "c_ID is the number of touching pairs with both particles in the group, c_ID per particle its "
	       "number of contacts. c_ID[k] in dump local is the list of contacts: both IDs, overlap, both "
	       "positions, force on the first particle, midpoint of the centres. Contacts are those of the "
	       "last force computation.",
	.example = "compute nc all contacts\ndump c all local 1000 post/contacts*.txt c_nc[1] c_nc[2]",
	.args = args,
	.state_size = sizeof(struct state),
	.values = values,
	.init = init,
};
