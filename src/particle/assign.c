#include "particle/assign.h"

#include <math.h>

#include "geom/box.h"
#include "particle/columns.h"
#include "particle/quantity.h"
#include "particle/sphere_shape.h"

#include "base/banned.h"

typedef void assign_fn(struct tsim *sim, size_t i, double value);

static void set_type(struct tsim *sim, size_t i, double value)
{
	sim->particles->type[i] = (int32_t)value;
}

/* The density stays. */
static void set_radius(struct tsim *sim, size_t i, double value)
{
	struct ts_particles *p = sim->particles;
	double density = p->mass[i] / ts_particle_volume(sim, p->radius[i]);

	p->radius[i] = value;
	p->mass[i] = density * ts_particle_volume(sim, value);
}

static void set_diameter(struct tsim *sim, size_t i, double value)
{
	set_radius(sim, i, 0.5 * value);
}

static void set_mass(struct tsim *sim, size_t i, double value)
{
	sim->particles->mass[i] = value;
}

static void set_density(struct tsim *sim, size_t i, double value)
{
	sim->particles->mass[i] = value * ts_particle_volume(sim, sim->particles->radius[i]);
}

/* A quantity that can be written: a component of a column, or a function that writes it. */
struct target {
	const char *name;
	enum ts_assign kind;
	enum ts_column_id column;
	int component;
	assign_fn *assign;
};

#define VECTOR_TARGETS(x_, y_, z_, kind, id)                                    \
	{ x_, kind, TS_COL_##id, 0, NULL }, { y_, kind, TS_COL_##id, 1, NULL }, \
	{                                                                       \
		z_, kind, TS_COL_##id, 2, NULL                                  \
	}

static const struct target targets[] = {
	VECTOR_TARGETS("x", "y", "z", TS_ASSIGN_MOTION, X),
	VECTOR_TARGETS("vx", "vy", "vz", TS_ASSIGN_MOTION, V),
	VECTOR_TARGETS("omegax", "omegay", "omegaz", TS_ASSIGN_MOTION, OMEGA),
	VECTOR_TARGETS("ix", "iy", "iz", TS_ASSIGN_MOTION, IMAGE),
	VECTOR_TARGETS("fx", "fy", "fz", TS_ASSIGN_FORCE, F),
	VECTOR_TARGETS("tqx", "tqy", "tqz", TS_ASSIGN_FORCE, TORQUE),
	{ "type", TS_ASSIGN_PROPERTY, TS_COL_TYPE, 0, set_type },
	{ "radius", TS_ASSIGN_PROPERTY, TS_COL_RADIUS, 0, set_radius },
	{ "diameter", TS_ASSIGN_PROPERTY, TS_COL_RADIUS, 0, set_diameter },
	{ "mass", TS_ASSIGN_PROPERTY, TS_COL_MASS, 0, set_mass },
	{ "density", TS_ASSIGN_PROPERTY, TS_COL_MASS, 0, set_density },
};
enum { NTARGETS = sizeof targets / sizeof *targets };

static const struct target *find_target(const char *name)
{
	for (int k = 0; k < NTARGETS; k++)
		if (ts_streq(targets[k].name, name))
			return &targets[k];
	return NULL;
}

enum ts_assign ts_particles_assignable(const struct tsim *sim, const char *name)
{
	const struct target *target = find_target(name);
	size_t k;

	if (target)
		return target->kind;
	return ts_particles_named_column(sim->particles, name, &k) ? TS_ASSIGN_MOTION : TS_ASSIGN_NOT;
}

/* Describes the values that are allowed if this one is not; NULL: it is. */
static const char *expected_value(const struct ts_particles *p, const struct target *target, double value)
{
	bool is_real = target->column != TS_COL_IMAGE && target->column != TS_COL_TYPE;

	if (!isfinite(value))
		return "a finite number";
	if (!is_real && !(value == rint(value) && fabs(value) <= TS_TURNS_MOST))
		return "a whole number";
	if (target->column == TS_COL_TYPE && !(value >= 1 && value <= p->ntypes))
		return "a type from 1 to the number in create_box";
	if (target->kind == TS_ASSIGN_PROPERTY && !(value > 0))
		return "a number > 0";
	return NULL;
}

static void write_value(struct tsim *sim, const struct target *target, size_t i, double value)
{
	struct ts_particles *p = sim->particles;

	if (target->assign)
		target->assign(sim, i, value);
	else if (target->column == TS_COL_IMAGE)
		p->image[i][target->component] = (int32_t)value;
	else
		((double *)p->column[target->column].data)[3 * i + (size_t)target->component] = value;
}

static enum ts_status fail_unknown(struct tsim *sim, const char *name)
{
	struct ts_suggest suggest = ts_suggest_start(name);

	if (ts_quantity_has(sim, name))
		return ts_fail(&sim->error, TS_STATE, NULL, "'%s' of particles cannot be written", name);
	for (int k = 0; k < NTARGETS; k++)
		ts_suggest_try(&suggest, targets[k].name);
	return ts_fail(&sim->error, TS_UNKNOWN, NULL, "particles have no '%s' that can be written%s", name,
		       ts_suggest_text(&suggest));
}

/* Writes one component of a column that a style has added. */
static enum ts_status assign_named(struct tsim *sim, const struct ts_column *c, size_t component,
				   const int32_t *row, const double *value, size_t n)
{
	for (size_t k = 0; k < n; k++)
		if (!isfinite(value[k]))
			return ts_fail(&sim->error, TS_RANGE, NULL, "value %zu for '%s' is not finite", k,
				       c->name);
	for (size_t k = 0; k < n; k++)
		((double *)c->data)[(row ? (size_t)row[k] : k) * c->width + component] = value[k];
	return TS_OK;
}

enum ts_status ts_particles_assign(struct tsim *sim, const char *name, const int32_t *row,
				   const double *value, size_t n)
{
	struct ts_particles *p = sim->particles;
	const struct target *target = find_target(name);
	size_t component;
	const struct ts_column *named = ts_particles_named_column(p, name, &component);

	if (named && !target)
		return assign_named(sim, named, component, row, value, n);
	if (!target)
		return fail_unknown(sim, name);
	for (size_t k = 0; k < n; k++) {
		size_t i = row ? (size_t)row[k] : k;
		const char *expected = expected_value(p, target, value[k]);

		if (expected)
			return ts_fail(&sim->error, TS_RANGE, NULL,
				       "%s of particle %d would be %g, expected %s", name, p->tag[i],
				       value[k], expected);
	}
	TS_TRY(ts_particles_need(sim, 1u << target->column));
	for (size_t k = 0; k < n; k++)
		write_value(sim, target, row ? (size_t)row[k] : k, value[k]);
	if (target->column == TS_COL_MASS || target->column == TS_COL_RADIUS)
		ts_particles_inverse_mass(p);
	return TS_OK;
}
