/* Per-particle numbers by the names scripts use. */
#include "particles/particles.h"

#include "base/banned.h"

typedef double quantity_fn(const struct ts_particles *p, size_t i);

struct quantity {
	const char *name;
	quantity_fn *value;
};

#define VECTOR_QUANTITY(name, column)                                                              \
	static double name##_x(const struct ts_particles *p, size_t i)                             \
	{                                                                                          \
		return p->column ? (double)p->column[i][0] : 0.0;                                  \
	}                                                                                          \
	static double name##_y(const struct ts_particles *p, size_t i)                             \
	{                                                                                          \
		return p->column ? (double)p->column[i][1] : 0.0;                                  \
	}                                                                                          \
	static double name##_z(const struct ts_particles *p, size_t i)                             \
	{                                                                                          \
		return p->column ? (double)p->column[i][2] : 0.0;                                  \
	}
VECTOR_QUANTITY(position, x)
VECTOR_QUANTITY(velocity, v)
VECTOR_QUANTITY(force, f)
VECTOR_QUANTITY(spin, omega)
VECTOR_QUANTITY(torque, torque)
VECTOR_QUANTITY(image, image)

static double id(const struct ts_particles *p, size_t i)
{
	return p->tag[i];
}

static double type(const struct ts_particles *p, size_t i)
{
	return p->type[i];
}

static double radius(const struct ts_particles *p, size_t i)
{
	return p->radius[i];
}

static double diameter(const struct ts_particles *p, size_t i)
{
	return 2 * p->radius[i];
}

static double mass(const struct ts_particles *p, size_t i)
{
	return p->mass[i];
}

static double density(const struct ts_particles *p, size_t i)
{
	double r = p->radius[i];

	return p->mass[i] / (4.18879020478639098462 * r * r * r); /* 4 pi / 3 */
}

static const struct quantity quantities[] = {
	{ "id", id },
	{ "type", type },
	{ "radius", radius },
	{ "diameter", diameter },
	{ "mass", mass },
	{ "density", density },
	{ "x", position_x },
	{ "y", position_y },
	{ "z", position_z },
	{ "vx", velocity_x },
	{ "vy", velocity_y },
	{ "vz", velocity_z },
	{ "fx", force_x },
	{ "fy", force_y },
	{ "fz", force_z },
	{ "omegax", spin_x },
	{ "omegay", spin_y },
	{ "omegaz", spin_z },
	{ "tqx", torque_x },
	{ "tqy", torque_y },
	{ "tqz", torque_z },
	{ "ix", image_x },
	{ "iy", image_y },
	{ "iz", image_z },
};
enum { NQUANTITIES = sizeof quantities / sizeof *quantities };

static const struct quantity *find(const char *name)
{
	for (int k = 0; k < NQUANTITIES; k++)
		if (ts_streq(quantities[k].name, name))
			return &quantities[k];
	return NULL;
}

bool ts_particles_has_quantity(const char *name)
{
	return find(name) != NULL;
}

void ts_particles_suggest_quantity(struct ts_suggest *suggest)
{
	for (int k = 0; k < NQUANTITIES; k++)
		ts_suggest_try(suggest, quantities[k].name);
}

enum ts_status ts_particles_quantity(struct tsim *sim, const char *name, struct ts_table *out)
{
	const struct ts_particles *p = sim->particles;
	const struct quantity *q = find(name);

	if (ts_table_resize(out, p->n, 1) != TS_OK)
		return ts_nomem(&sim->error);
	for (size_t i = 0; i < p->n; i++)
		out->data[i] = q->value(p, i);
	return TS_OK;
}
