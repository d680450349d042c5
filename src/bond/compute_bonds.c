#include "bond/bonds.h"
#include "particle/particles.h"

#include <math.h>

#include "base/banned.h"

enum { COLUMNS = 11 };

static bool is_in_group(const struct ts_instance *self, const struct tsim *sim, size_t b)
{
	const int32_t *row = sim->bonds->row[b];

	return ts_in_group(sim->particles, (size_t)row[0], self->group) &&
	       ts_in_group(sim->particles, (size_t)row[1], self->group);
}

static enum ts_status eval_count(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	out->data[0] = 0;
	for (size_t b = 0; b < sim->bonds->n; b++)
		out->data[0] += is_in_group(self, sim, b);
	return TS_OK;
}

static enum ts_status eval_peratom(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	TS_TRY(ts_table_resize(out, sim->particles->n, 1));
	for (size_t i = 0; i < sim->particles->n; i++)
		out->data[i] = 0;
	for (size_t b = 0; b < sim->bonds->n; b++)
		for (int s = 0; is_in_group(self, sim, b) && s < 2; s++)
			out->data[sim->bonds->row[b][s]] += 1;
	return TS_OK;
}

static enum ts_status eval_local(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct ts_bonds *bonds = sim->bonds;
	const struct ts_particles *p = sim->particles;
	size_t n = 0;

	TS_TRY(ts_table_resize(out, bonds->n, COLUMNS));
	for (size_t b = 0; b < bonds->n; b++) {
		double *row = out->data + COLUMNS * n;

		if (!is_in_group(self, sim, b))
			continue;
		n++;
		row[0] = bonds->tag[b][0];
		row[1] = bonds->tag[b][1];
		row[2] = bonds->type[b];
		row[3] = bonds->rest[b];
		row[4] = bonds->tension[b];
		for (int k = 0; k < 3; k++) {
			row[5 + k] = p->x[bonds->row[b][0]][k];
			row[8 + k] = p->x[bonds->row[b][1]][k];
		}
	}
	return ts_table_resize(out, n, COLUMNS);
}

static enum ts_status request_tensions(struct ts_instance *self, struct tsim *sim)
{
	(void)self;
	sim->bonds->shown = true; /* the list contains tensions */
	return TS_OK;
}

static const char *const names[] = {
	"i", "j", "type", "rest", "tension", "xi", "yi", "zi", "xj", "yj", "zj"
};
static const struct ts_value values[] = {
	{ "count", "", "number of bonds", TS_SCALAR, 1, NULL, eval_count },
	{ "coordination", "", "number of bonds of each particle", TS_PERATOM, 1, NULL, eval_peratom },
	{ "list", "", "one row per bond, with the positions of both partners", TS_LOCAL, COLUMNS, names,
	  eval_local },
	{ .name = NULL },
};

TS_STYLE(compute, ts_style, ts_compute_bonds)
const struct ts_style ts_compute_bonds = {
	.name = "bonds",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE,
	.summary = "number, coordination number and list of bonds",
	.doc = "Considers bonds with both partners in the group. The scalar c_ID is their number, the "
	       "per-atom vector c_ID the number of bonds of each particle, and the local array c_ID[k] (dump "
	       "local) lists them: IDs i and j of the partners, bond type, rest length, tension and the "
	       "positions of both. The tension is the force along the bond in the last force computation, > "
	       "0 attractive.",
	.example = "compute nb rock bonds\ndump b all local/vtk 1000 post/bonds*.vtp c_nb",
	.values = values,
	.init = request_tensions,
};
