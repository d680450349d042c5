/* Fix surface/heat: heat that particles conduct into a surface. */
#include <math.h>

#include "base/sort.h"
#include "core/archive.h"
#include "math/compensated.h"
#include "math/exactsum.h"
#include "particle/particles.h"
#include "wall/shared_contacts.h"
#include "wall/surface_rows.h"

#include "base/banned.h"

/* Of an element; all numbers of type double, for restart files. */
struct row {
	double power, step;		  /* power in the step of this number */
	struct ts_compensated_sum energy; /* so far */
};
enum { ROW = sizeof(struct row) / sizeof(double) };

struct state {
	const char *surface_id;
	struct ts_surface surface;
	struct ts_surface_rows rows; /* struct row */
	double steps;		     /* of the fix, so far */
	struct ts_parcel powers;     /* of the contacts in this step */
};

/* Heat flow of contact k of the surface, counted over all ranks, which the rank of its particle knows. */
struct power {
	size_t k;
	double value;
};

/* Temperatures are advanced before the heat is summed, so fix heat/gran must come first. */
static enum ts_status check_order(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_instances *fixes = &sim->instances[TS_KIND_FIX];
	const struct ts_heat *heat = ts_heat_of(sim);
	size_t k = 0;

	while (k < fixes->n && fixes->item[k] != self && (!heat || fixes->item[k]->state != heat))
		k++;
	if (heat && k < fixes->n && fixes->item[k] != self)
		return TS_OK;
	return ts_fail(&sim->error, TS_STATE, &self->where,
		       "fix surface/heat needs a fix heat/gran before it%s",
		       heat ? "" : ", and there is none");
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	struct ts_word id = { .text = s->surface_id, .place = *ts_instance_word(self, s->surface_id) };

	TS_TRY(check_order(self, sim));
	TS_TRY(ts_surface_require(sim, &id, &s->surface));
	if (isnan(ts_surface_temperature(&s->surface)))
		return ts_fail(&sim->error, TS_STATE, &id.place,
			       "surface '%s' conducts no heat: expected `temperature T` in the line of fix "
			       "%s",
			       id.text, id.text);
	return ts_surface_rows_init(sim, &s->rows, &s->surface, ROW, &id.place);
}

static const struct ts_instance *surface(const struct ts_instance *self)
{
	return ((const struct state *)self->state)->surface.by;
}

static enum ts_status plan(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report)
{
	const struct state *s = self->state;

	(void)report;
	ts_surface_warn_without_wall(self, sim, s->surface.by, s->surface_id);
	return TS_OK;
}

static int by_contact(const void *a, const void *b)
{
	const struct power *p = a, *q = b;

	return (p->k > q->k) - (p->k < q->k);
}

/* The heat flows of all contacts, in their order. */
static enum ts_status find_powers(struct tsim *sim, struct state *s)
{
	struct ts_surface_contacts contacts = ts_surface_heat_contacts(sim, s->surface.by);
	struct ts_parcel all = { 0 };
	struct ts_surface_contact c;
	struct power power = { 0 };
	enum ts_status status = TS_OK;

	s->powers.n = 0;
	for (; status == TS_OK && ts_surface_contacts_next(&contacts, &c); power.k++) {
		if (c.particle == SIZE_MAX) /* of another rank */
			continue;
		power.value = c.heat + c.conductance * ts_heat_mean_rise(ts_heat_of(sim), c.particle);
		status = ts_parcel_add(&s->powers, &power, sizeof power);
	}
	if (status == TS_OK && sim->division) {
		status = ts_world_share(sim->world, &s->powers, &all);
		ts_parcel_release(&s->powers);
		s->powers = all;
		ts_sort(all.data, all.n / sizeof power, sizeof power, by_contact);
	}
	return status == TS_OK ? TS_OK : ts_nomem(&sim->error);
}

static enum ts_status add_contact(struct tsim *sim, struct state *s, const struct ts_surface_contact *c,
				  double power)
{
	double *at;
	struct row *row;

	TS_TRY(ts_surface_rows_at(sim, &s->rows, c->element, &at));
	row = (struct row *)at;
	if (row->step < s->steps)
		row->power = 0;
	row->step = s->steps;
	row->power += power;
	ts_compensated_add(&row->energy, power * sim->clock.dt);
	return TS_OK;
}

/* When temperatures have been advanced. */
static enum ts_status final_integrate(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	struct ts_surface_contacts contacts;
	struct ts_surface_contact c;
	const struct power *power;

	s->steps++;
	TS_TRY(ts_shared_contacts_find(sim, s->surface.by));
	TS_TRY(find_powers(sim, s));
	power = (const struct power *)(const void *)s->powers.data;
	contacts = ts_surface_heat_contacts(sim, s->surface.by);
	for (; ts_surface_contacts_next(&contacts, &c); power++)
		if (ts_surface_contact_in_group(&c, self->group))
			TS_TRY(add_contact(sim, s, &c, power->value));
	return TS_OK;
}

/* ---- outputs ---- */

static const struct row *row_at(const struct state *s, size_t k)
{
	return (const struct row *)(s->rows.data + k * ROW);
}

static double energy_of(const struct state *s, size_t k)
{
	return ts_compensated_value(&row_at(s, k)->energy);
}

static double power_of(const struct state *s, size_t k)
{
	return row_at(s, k)->step < s->steps ? 0 : row_at(s, k)->power;
}

/* Exact sum over the elements, rounded once. */
static double total(const struct state *s, double (*of)(const struct state *s, size_t k))
{
	struct ts_exactsum sum = ts_exactsum_start();

	for (size_t k = 0; k < s->rows.n; k++)
		ts_exactsum_add(&sum, of(s, k));
	return ts_exactsum_value(&sum);
}

static enum ts_status eval_energy(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	(void)sim;
	out->data[0] = total(self->state, energy_of);
	return TS_OK;
}

static enum ts_status eval_totals(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	(void)sim;
	out->data[0] = total(self->state, power_of);
	out->data[1] = total(self->state, energy_of);
	return TS_OK;
}

static const char *const names[] = { "power", "energy", "flux", "x", "y", "z" };
enum { COLUMNS = sizeof names / sizeof *names, TOTALS = 2 };

static enum ts_status eval_elements(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	struct state *s = self->state;

	TS_TRY(ts_surface_find_again(&s->surface, s->surface_id, &self->where, s->rows.elements));
	TS_TRY(ts_table_resize(out, s->rows.elements, COLUMNS));
	for (size_t k = 0; k < s->rows.elements; k++) {
		double *to = out->data + k * COLUMNS;
		size_t row = (size_t)s->rows.row[k];

		to[0] = row ? power_of(s, row - 1) : 0;
		to[1] = row ? energy_of(s, row - 1) : 0;
		to[2] = row ? to[0] / ts_surface_area(&s->surface, sim, k) : 0;
		ts_surface_centre(&s->surface, sim, k, to + 3);
	}
	return TS_OK;
}

static const struct ts_value values[] = {
	{ "energy", "energy", "heat that has flowed into the surface", TS_SCALAR, 1, NULL, eval_energy },
	{ "totals", "energy/time, energy",
	  "totals: heat flow into the surface in the last step, heat that has flowed into it", TS_VECTOR,
	  TOTALS, names, eval_totals },
	{ "elements", "energy/time, energy, energy/(time*length^2), length, length, length",
	  "of each element: heat flow into it in the last step, heat that has flowed into it, heat flow "
	  "divided by the area; coordinates of its centre",
	  TS_SURFACE, COLUMNS, names, eval_elements },
	{ .name = NULL },
};

/* ---- saved state ---- */

static enum ts_status archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *archive)
{
	struct state *s = self->state;

	TS_TRY(ts_archive_fixed(archive, "steps", TS_SAVED_F64, &s->steps, 1));
	return ts_surface_rows_archive(sim, &s->rows, archive);
}

static void fini(struct ts_instance *self)
{
	struct state *s = self->state;

	ts_surface_rows_release(&s->rows);
	ts_parcel_release(&s->powers);
}

static const struct ts_arg args[] = {
	TS_WORD("surface", struct state, surface_id, .flags = TS_STATEFUL,
		.help = "ID of a fix mesh/surface, of a fix surface/voxel, or of a fix wall/gran with planes "
			"or a cylinder; it has a `temperature`"),
	TS_ARGS_END,
};

TS_STYLE(fix, ts_style, ts_fix_surface_heat)
const struct ts_style ts_fix_surface_heat = {
	.name = "surface/heat",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_OWN | TS_RANKS_OUTPUTS,
	.summary = "heat that particles conduct into the elements of a surface",
	.doc = "In each step each contact of a particle of the group, of temperature T_i, with the surface, "
	       "of temperature T, conducts the heat flow\n\n"
	       "  Q = h (T_i - T)\n\n"
	       "into the element in contact; the conductance h is that of fix heat/gran and fix wall/gran "
	       "(`contact_area`). The element receives the energy Q dt. Q is positive where particles heat "
	       "the surface, negative where they cool it. With `scheme exact` of fix heat/gran T_i is the "
	       "mean temperature of the particle over the step. So the energy of all elements of all "
	       "surfaces is what the particles of fix heat/gran lose at walls, to round-off. Immobile "
	       "particles conduct heat, too. Particles that do not belong to the group of fix heat/gran keep "
	       "their temperature, but heat the surface. The temperature of the surface does not change.\n\n"
	       "The elements of a mesh are its triangles, those of a height field its columns, those of a "
	       "primitive wall its planes or cylinders, whose area is that within the box (of a cylinder of "
	       "which no part is: all). A particle that touches several elements of a mesh - at an edge or a "
	       "corner - has contacts with those that fix wall/gran counts as contacts, each with its own "
	       "heat flow; coplanar neighbours are one contact. dump mesh/vtk (of meshes), dump voxel/vtk "
	       "(of height fields), dump local, compute reduce and formulas read f_ID[1..6] of each element; "
	       "f_ID is the energy of the whole surface, and f_ID[1..2] are its totals elsewhere. Sums over "
	       "elements are exact, as those of compute reduce. Elements without contacts have zeros.\n\n"
	       "fix heat/gran must come before this fix, and the surface must have a temperature. Walls with "
	       "`impact exact` conduct no heat and are refused.\n\n"
	       "Related: fix heat/gran, fix wall/gran, fix mesh/surface, fix surface/voxel.",
	.example = "fix heat all heat/gran initial_temperature 373.15\n"
		   "fix chute all mesh/surface file chute.stl type 2 temperature 293.15\n"
		   "fix floor all wall/gran model hertz tangential history mesh n_meshes 1 meshes chute\n"
		   "fix warmed all surface/heat surface chute\n"
		   "dump warmed all mesh/vtk 1000 post/chute*.vtk f_warmed[2] chute",
	.args = args,
	.state_size = sizeof(struct state),
	.archive = archive,
	.values = values,
	.surface = surface,
	.observes = TS_OBSERVES_CONTACTS,
	.init = init,
	.hook[TS_STAGE_FINAL_INTEGRATE] = final_integrate,
	.plan = plan,
	.fini = fini,
};
