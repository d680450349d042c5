/* Per-particle numbers by the names scripts use. */
#include "particles/body.h"
#include "particles/particles.h"

#include "base/banned.h"

typedef double quantity_fn(const struct tsim *sim, size_t i);

struct quantity {
	const char *name;
	quantity_fn *value;
};

#define VECTOR_QUANTITY(name, column)                                                              \
	static double name##_x(const struct tsim *sim, size_t i)                             \
	{                                                                                          \
		const struct ts_particles *p = sim->particles;                                     \
                                                                                                   \
		return p->column ? (double)p->column[i][0] : 0.0;                                  \
	}                                                                                          \
	static double name##_y(const struct tsim *sim, size_t i)                             \
	{                                                                                          \
		const struct ts_particles *p = sim->particles;                                     \
                                                                                                   \
		return p->column ? (double)p->column[i][1] : 0.0;                                  \
	}                                                                                          \
	static double name##_z(const struct tsim *sim, size_t i)                             \
	{                                                                                          \
		const struct ts_particles *p = sim->particles;                                     \
                                                                                                   \
		return p->column ? (double)p->column[i][2] : 0.0;                                  \
	}
VECTOR_QUANTITY(position, x)
VECTOR_QUANTITY(velocity, v)
VECTOR_QUANTITY(force, f)
VECTOR_QUANTITY(spin, omega)
VECTOR_QUANTITY(torque, torque)
VECTOR_QUANTITY(image, image)

static double id(const struct tsim *sim, size_t i)
{
	return sim->particles->tag[i];
}

static double type(const struct tsim *sim, size_t i)
{
	return sim->particles->type[i];
}

static double radius(const struct tsim *sim, size_t i)
{
	return sim->particles->radius[i];
}

static double diameter(const struct tsim *sim, size_t i)
{
	return 2 * sim->particles->radius[i];
}

static double mass(const struct tsim *sim, size_t i)
{
	return sim->particles->mass[i];
}

static double density(const struct tsim *sim, size_t i)
{
	return sim->particles->mass[i] / ts_body_volume(sim, sim->particles->radius[i]);
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

const char *ts_particles_quantity_name(size_t k)
{
	return k < NQUANTITIES ? quantities[k].name : NULL;
}

enum ts_status ts_particles_quantity(struct tsim *sim, const char *name, struct ts_table *out)
{
	const struct ts_particles *p = sim->particles;
	const struct quantity *q = find(name);

	if (ts_table_resize(out, p->n, 1) != TS_OK)
		return ts_nomem(&sim->error);
	for (size_t i = 0; i < p->n; i++)
		out->data[i] = q->value(sim, i);
	return TS_OK;
}
