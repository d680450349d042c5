#include "bond/bonds.h"
#include "particle/particles.h"

#include <math.h>

#include "base/banned.h"

enum { COLUMNS = 11 };

static bool counts(const struct ts_instance *self, const struct tsim *sim, size_t b)
{
	const int32_t *row = sim->bonds->row[b];

	return ts_in_group(sim->particles, (size_t)row[0], self->group) &&
	       ts_in_group(sim->particles, (size_t)row[1], self->group);
}

static enum ts_status eval_count(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	out->data[0] = 0;
	for (size_t b = 0; b < sim->bonds->n; b++)
		out->data[0] += counts(self, sim, b);
	return TS_OK;
}

static enum ts_status eval_peratom(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	TS_TRY(ts_table_resize(out, sim->particles->n, 1));
	for (size_t i = 0; i < sim->particles->n; i++)
		out->data[i] = 0;
	for (size_t b = 0; b < sim->bonds->n; b++)
		for (int s = 0; counts(self, sim, b) && s < 2; s++)
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

		if (!counts(self, sim, b))
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

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	(void)self;
	sim->bonds->shown = true; /* the list has tensions */
	return TS_OK;
}

static const char *const names[] = {
	"i", "j", "type", "rest", "tension", "xi", "yi", "zi", "xj", "yj", "zj"
};
static const struct ts_value values[] = {
	{ "count", "", "bonds that hold", TS_SCALAR, 1, NULL, eval_count },
	{ "coordination", "", "bonds of each particle", TS_PERATOM, 1, NULL, eval_peratom },
	{ "list", "", "one row per bond, with the places of both partners", TS_LOCAL, COLUMNS, names,
	  eval_local },
	{ .name = NULL },
};

TS_STYLE(compute, ts_style, ts_compute_bonds)
const struct ts_style ts_compute_bonds = {
	.name = "bonds",
	.kind = TS_KIND_COMPUTE,
	.summary = "number, coordination and list of the bonds",
	.doc = "Of bonds with both partners in the group: c_ID is their number, c_ID per particle the number "
	       "of its bonds, c_ID[k] in dump local the list. Tension is that of the last force computation, "
	       "> 0 pulling.",
	.example = "compute nb rock bonds\ndump b all local/vtk 1000 post/bonds*.vtp c_nb",
	.values = values,
	.init = init,
};
