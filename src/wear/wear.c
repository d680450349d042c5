#include "wear/wear.h"

#include <math.h>

#include "core/archive.h"
#include "impact/impacts.h"
#include "math/constants.h"
#include "math/exactsum.h"
#include "math/vec3.h"
#include "particle/particles.h"
#include "wall/shared_contacts.h"

#include "base/banned.h"

/* ---- surface and elements ---- */

enum ts_status ts_wear_find_surface(struct ts_instance *self, struct tsim *sim, const struct ts_wear_law *law)
{
	struct ts_wear *w = self->state;
	struct ts_word id = { .text = w->surface_id, .place = *ts_instance_word(self, w->surface_id) };

	w->law = law;
	TS_TRY(ts_surface_require(sim, &id, &w->surface));
	return ts_surface_rows_init(sim, &w->rows, &w->surface, TS_WEAR_SUMS, &id.place);
}

enum ts_status ts_wear_init(struct ts_instance *self, struct tsim *sim, const struct ts_wear_law *law)
{
	TS_TRY(ts_wear_find_surface(self, sim, law));
	return ts_evolution_init(self, sim);
}

const struct ts_instance *ts_wear_surface(const struct ts_instance *self)
{
	return ((const struct ts_wear *)self->state)->surface.by;
}

static enum ts_status sums_of(struct tsim *sim, struct ts_wear *w, size_t element, struct ts_wear_sums **out)
{
	double *at;

	TS_TRY(ts_surface_rows_at(sim, &w->rows, element, &at));
	*out = (struct ts_wear_sums *)at;
	return TS_OK;
}

/* ---- a step ---- */

static enum ts_status remove_volume(struct tsim *sim, struct ts_wear *w, size_t element,
				    struct ts_wear_sums *s, double volume, const double normal[3])
{
	s->volume += volume;
	if (!w->evolution.on)
		return TS_OK;
	return ts_evolution_add(sim, &w->evolution, (size_t)w->rows.row[element] - 1, volume,
				ts_surface_is_back(&w->surface, element, normal));
}

static enum ts_status add_impact(struct ts_instance *self, struct tsim *sim, const struct ts_impact_event *e)
{
	struct ts_wear *w = self->state;
	struct ts_wear_sums *s;

	TS_TRY(sums_of(sim, w, (size_t)e->element, &s));
	s->hits += 1;
	s->mass += e->mass;
	s->speed += ts_impact_speed(e);
	s->angle += ts_impact_angle(e) * 180 / TS_PI;
	s->energy += ts_impact_energy(e);
	s->impulse += e->impulse;
	s->force = fmax(s->force, e->peak_force);
	if (!w->law->slide) /* else it is added step by step */
		s->work += e->work;
	return w->law->impact
		       ? remove_volume(sim, w, (size_t)e->element, s, w->law->impact(self, e), e->normal)
		       : TS_OK;
}

static enum ts_status add_slide(struct ts_instance *self, struct tsim *sim,
				const struct ts_surface_contact *c)
{
	struct ts_wear *w = self->state;
	struct ts_wear_sums *s;
	double v[3], power = ts_surface_contact_slip(c, v);
	struct ts_wear_slide slide = { .element = c->element,
				       .type = c->type,
				       .mass = c->mass,
				       .radius = c->radius,
				       .normal_force = fmax(ts_surface_contact_normal_force(c), 0),
				       .slip = ts_norm(v) * c->duration,
				       .work = power * c->duration };

	ts_scale(1, c->normal, slide.normal);
	ts_scale(1, c->velocity, slide.velocity);
	TS_TRY(sums_of(sim, w, c->element, &s));
	s->work += slide.work;
	return remove_volume(sim, w, c->element, s, w->law->slide(self, &slide), slide.normal);
}

enum ts_status ts_wear_step(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_wear *w = self->state;
	struct ts_surface_impacts impacts = ts_surface_impacts(sim, w->surface.by);
	struct ts_surface_contacts contacts = ts_surface_contacts(sim, w->surface.by);
	const struct ts_surface_impact *impact;
	struct ts_surface_contact c;

	if (sim->run.in_setup) /* these forces belong to the step before */
		return TS_OK;
	if (w->law->slide)
		TS_TRY(ts_shared_contacts_find(sim, w->surface.by));
	while ((impact = ts_surface_impacts_next(&impacts)))
		if (ts_surface_impact_in_group(impact, self->group))
			TS_TRY(add_impact(self, sim, &impact->event));
	while (w->law->slide && ts_surface_contacts_next(&contacts, &c))
		if (ts_surface_contact_in_group(&c, self->group))
			TS_TRY(add_slide(self, sim, &c));
	return ts_evolution_update(self, sim);
}

enum ts_status ts_wear_plan(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report)
{
	const struct ts_wear *wear = self->state;

	(void)report;
	ts_surface_warn_without_wall(self, sim, wear->surface.by, wear->surface_id);
	return TS_OK;
}

/* ---- outputs ---- */

/* Sum of one member of struct ts_wear_sums over the elements: exact, rounded once. */
static double total(const struct ts_wear *w, size_t member)
{
	return w->rows.n ? ts_exactsum_of(w->rows.data + member, w->rows.n, TS_WEAR_SUMS) : 0;
}
#define TOTAL(w, f) total((w), offsetof(struct ts_wear_sums, f) / sizeof(double))
#define EVOLVED(w, f) \
	ts_evolution_total(&(w)->evolution, offsetof(struct ts_evolution_sums, f) / sizeof(double))

static enum ts_status eval_volume(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	(void)sim;
	out->data[0] = TOTAL(self->state, volume);
	return TS_OK;
}

static double quotient(double a, double b)
{
	return b > 0 ? a / b : 0;
}

static enum ts_status eval_totals(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct ts_wear *w = self->state;
	double volume = TOTAL(w, volume), mass = TOTAL(w, mass);
	double removed = isnan(w->density) ? 0 : w->density * volume;
	double taken = EVOLVED(w, taken), surplus = EVOLVED(w, surplus);
	double pending = fmax(volume - taken - surplus, 0); /* not -1e-27 by round-off */
	double totals[] = { volume,
			    quotient(volume, mass),
			    TOTAL(w, hits),
			    mass,
			    TOTAL(w, energy),
			    TOTAL(w, work),
			    removed,
			    quotient(removed, mass),
			    taken,
			    w->evolution.on ? pending : 0,
			    surplus,
			    EVOLVED(w, through) };

	(void)sim;
	for (size_t k = 0; k < sizeof totals / sizeof *totals; k++)
		out->data[k] = totals[k];
	return TS_OK;
}

static enum ts_status eval_hits(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	(void)sim;
	out->data[0] = TOTAL(self->state, hits);
	return TS_OK;
}

static enum ts_status eval_impact_totals(struct ts_instance *self, const struct tsim *sim,
					 struct ts_table *out)
{
	const struct ts_wear *w = self->state;

	(void)sim;
	out->data[0] = TOTAL(w, hits);
	out->data[1] = TOTAL(w, mass);
	out->data[2] = TOTAL(w, energy);
	out->data[3] = TOTAL(w, work);
	return TS_OK;
}

static const char *const total_names[] = { "volume",  "volume_per_mass",  "impacts",
					   "mass",    "energy",		  "work",
					   "removed", "removed_per_mass", "taken",
					   "pending", "surplus",	  "through" };
static const char *const impact_total_names[] = { "impacts", "mass", "energy", "work" };
static const char *const element_names[] = { "hits",   "speed", "angle", "energy", "work", "impulse", "force",
					     "volume", "depth", "x",	 "y",	   "z",	   "taken" };
static const char *const impact_names[] = { "hits",    "speed", "angle", "energy", "work",
					    "impulse", "force", "x",	 "y",	   "z" };
enum {
	TOTALS = sizeof total_names / sizeof *total_names,
	IMPACT_TOTALS = sizeof impact_total_names / sizeof *impact_total_names,
	COLUMNS = sizeof element_names / sizeof *element_names,
	IMPACT_COLUMNS = sizeof impact_names / sizeof *impact_names,
	/* columns before the coordinates of the centre */
	SUMS = COLUMNS - 4,
	IMPACT_SUMS = IMPACT_COLUMNS - 3,
	TAKEN = COLUMNS - 1
};

/* The first `sums` columns of each element, the coordinates of its centre, and zeros: `columns` in all. */
static enum ts_status list_elements(const struct ts_wear *w, const struct tsim *sim, size_t sums,
				    size_t columns, struct ts_table *out)
{
	TS_TRY(ts_table_resize(out, w->rows.elements, columns));
	for (size_t k = 0; k < w->rows.elements; k++) {
		for (size_t c = 0; c < columns; c++)
			out->data[k * columns + c] = 0;
		ts_surface_centre(&w->surface, sim, k, out->data + k * columns + sums);
	}
	for (size_t k = 0; k < w->rows.n; k++) {
		const struct ts_wear_sums *s = ts_wear_sums(w, k);
		size_t element = (size_t)w->rows.touched[k];
		double column[SUMS] = {
			s->hits,
			quotient(s->speed, s->hits),
			quotient(s->angle, s->hits),
			s->energy,
			s->work,
			s->impulse,
			s->force,
			s->volume,
			quotient(s->volume, ts_surface_area(&w->surface, sim, element)),
		};

		for (size_t c = 0; c < sums; c++)
			out->data[element * columns + c] = column[c];
	}
	return TS_OK;
}

static enum ts_status eval_elements(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	struct ts_wear *w = self->state;

	TS_TRY(ts_surface_find_again(&w->surface, w->surface_id, &self->where, w->rows.elements));
	TS_TRY(list_elements(w, sim, SUMS, COLUMNS, out));
	for (size_t k = 0; k < w->evolution.n; k++)
		out->data[(size_t)w->rows.touched[k] * COLUMNS + TAKEN] = w->evolution.sums[k].taken;
	return TS_OK;
}

static enum ts_status eval_impacts(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	struct ts_wear *w = self->state;

	TS_TRY(ts_surface_find_again(&w->surface, w->surface_id, &self->where, w->rows.elements));
	return list_elements(w, sim, IMPACT_SUMS, IMPACT_COLUMNS, out);
}

const struct ts_value ts_wear_values[] = {
	{ "volume", "length^3", "volume removed", TS_SCALAR, 1, NULL, eval_volume },
	{ "totals",
	  "length^3, length^3/mass, -, mass, energy, energy, mass, -, length^3, length^3, length^3, -",
	  "totals: volume removed, volume per mass of the particles that have hit, number of impacts, mass "
	  "of the particles that have hit (once for each impact), their kinetic energy before, work of "
	  "friction, mass removed and this per mass of particles (0 without `density`); with `evolve yes` "
	  "the volume taken from the geometry, pending, and surplus, and the number of elements that are "
	  "worn through, else 0",
	  TS_VECTOR, TOTALS, total_names, eval_totals },
	{ "elements",
	  "-, velocity, degrees, energy, energy, force*time, force, length^3, length, length, length, "
	  "length, length^3",
	  "of each element: number of impacts, their mean speed, mean angle, kinetic energy before, work of "
	  "friction, impulse of the normal forces, largest normal force; volume removed, and divided by the "
	  "area; coordinates of its centre; volume taken from the geometry",
	  TS_SURFACE, COLUMNS, element_names, eval_elements },
	{ .name = NULL },
};

const struct ts_value ts_wear_impact_values[] = {
	{ "impacts", "-", "number of impacts", TS_SCALAR, 1, NULL, eval_hits },
	{ "totals", "-, mass, energy, energy",
	  "totals: number of impacts, mass of the particles that have hit (once for each impact), their "
	  "kinetic energy before, work of friction",
	  TS_VECTOR, IMPACT_TOTALS, impact_total_names, eval_impact_totals },
	{ "elements", "-, velocity, degrees, energy, energy, force*time, force, length, length, length",
	  "of each element: number of impacts, their mean speed, mean angle, kinetic energy before, work of "
	  "friction, impulse of the normal forces, largest normal force; coordinates of its centre",
	  TS_SURFACE, IMPACT_COLUMNS, impact_names, eval_impacts },
	{ .name = NULL },
};

/* ---- saved state ---- */

enum ts_status ts_wear_archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *archive)
{
	struct ts_wear *w = self->state;

	TS_TRY(ts_surface_rows_archive(sim, &w->rows, archive));
	return ts_evolution_archive(archive, sim, &w->evolution, w->rows.n);
}

void ts_wear_fini(struct ts_instance *self)
{
	struct ts_wear *w = self->state;

	ts_surface_rows_release(&w->rows);
	ts_evolution_release(&w->evolution);
}

/* ---- manual ---- */

static const char evolving[] =
	"With `evolve yes` the surface recedes: every `evolve_every` steps the volume worn from an element "
	"since the last time is taken from the geometry. A column of a height field of area A is lowered by "
	"the volume over A, whether its top or its side was hit; with `layer L` it is lowered by whole "
	"voxels of height L, and the rest stays pending. Primitive walls keep their shape. Only one fix may "
	"change a surface; others may observe it.\n\n"
	"The material ends at the depth `thickness` below the original surface - the one that fix "
	"surface/voxel has defined, also after a restart or with another fix wear/... - or at the `base` of "
	"the field. An element that is worn down to there gives no more (`through stop`): what impacts wear "
	"from it is surplus. With `through open` the column is removed; as the wall is open only where all "
	"material is gone, the field needs a `base`, and the thickness, if given, must reach it. With "
	"`through error` the run ends. At any time\n\n"
	"  f_ID = f_ID[9] + f_ID[10] + f_ID[11]:   worn by the law = taken from the geometry + pending + "
	"surplus,\n\n"
	"and f_ID[9] is the volume by which the geometry has changed, to round-off. f_ID[8] of an element, "
	"its volume, and f_ID[9], its depth, are those of the law; the volume taken is f_ID[13].\n\n"
	"A particle that touches an element when it recedes loses the overlap, with its elastic energy, by "
	"which it recedes: intervals should be so short that this depth is small beside overlaps, or so long "
	"that touching particles are rare. Impacts after that see the new surface: angles and normals are "
	"those at tops, sides and edges of columns, so slopes of a scar count if columns are narrower than "
	"the particles. Volume that has not been taken when a run ends stays pending for the next run or the "
	"restart file.";
static const char evolving_meshes[] =
	"The nodes of a mesh recede along their normals, the mean of those of the triangles around weighted "
	"by area; the volume of a triangle goes to its three nodes, a third to each. The displacements are "
	"such that each node sweeps its volume exactly, also at the rim of an open mesh, where the volume "
	"ends at the walls that the rim sweeps. Windings may be mixed: those of a connected part are made "
	"consistent. The material is behind the side on which most has been worn. A part with a rim can be "
	"worn on both sides: if the other one has more than a tenth, the run ends with an error, as a sheet "
	"without thickness cannot recede both ways. A mesh that moves recedes in its own frame. dump "
	"mesh/vtk and dump mesh/stl write the worn mesh.\n\n"
	"A triangle gives at most `thickness` times the area that it has in the mesh as defined. With "
	"`through open`, which needs a `thickness`, it is then removed: particles pass, and its neighbours "
	"have a rim there. Dumps leave it out; it keeps its row in f_ID. Other uses of the mesh than as a "
	"wall (mass flow, insertion, bodies in a fluid) still see it. `layer` is refused, as are meshes with "
	"surface_vel, with an edge that more than two triangles share, or with parts that touch at a corner "
	"only.\n\n"
	"The run ends with an error that names the triangle if a triangle would turn by more than a right "
	"angle, become a needle, be folded onto its neighbour, or pass through another one of the mesh. "
	"Triangles should be larger than the scars are deep; volumes of single impacts are spread over three "
	"nodes, so that the mesh resolves scars wider than its triangles.";
const char *const ts_wear_doc_more[] = { evolving, evolving_meshes, NULL };
