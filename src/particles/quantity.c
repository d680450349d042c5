/* Per-particle numbers by the names scripts use. */
#include "particles/body.h"
#include "particles/particles.h"

#include "base/banned.h"

typedef double quantity_fn(const struct tsim *sim, size_t i);

struct quantity {
	struct ts_quantity text;
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
	{ { "id", "", "identity, from 1" }, id },
	{ { "type", "", "type, from 1" }, type },
	{ { "radius", "length", "radius" }, radius },
	{ { "diameter", "length", "diameter" }, diameter },
	{ { "mass", "mass", "mass" }, mass },
	{ { "density", "density", "mass by volume" }, density },
	{ { "x", "length", "position" }, position_x },
	{ { "y", "length", "position" }, position_y },
	{ { "z", "length", "position" }, position_z },
	{ { "vx", "velocity", "velocity" }, velocity_x },
	{ { "vy", "velocity", "velocity" }, velocity_y },
	{ { "vz", "velocity", "velocity" }, velocity_z },
	{ { "fx", "force", "force at the last step" }, force_x },
	{ { "fy", "force", "force at the last step" }, force_y },
	{ { "fz", "force", "force at the last step" }, force_z },
	{ { "omegax", "1/time", "angular velocity" }, spin_x },
	{ { "omegay", "1/time", "angular velocity" }, spin_y },
	{ { "omegaz", "1/time", "angular velocity" }, spin_z },
	{ { "tqx", "force*length", "torque at the last step" }, torque_x },
	{ { "tqy", "force*length", "torque at the last step" }, torque_y },
	{ { "tqz", "force*length", "torque at the last step" }, torque_z },
	{ { "ix", "", "how often it has crossed the periodic box" }, image_x },
	{ { "iy", "", "how often it has crossed the periodic box" }, image_y },
	{ { "iz", "", "how often it has crossed the periodic box" }, image_z },
};
enum { NQUANTITIES = sizeof quantities / sizeof *quantities };

static const struct quantity *find(const char *name)
{
	for (int k = 0; k < NQUANTITIES; k++)
		if (ts_streq(quantities[k].text.name, name))
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
		ts_suggest_try(suggest, quantities[k].text.name);
}

const char *ts_particles_quantity_name(size_t k)
{
	return k < NQUANTITIES ? quantities[k].text.name : NULL;
}

const struct ts_quantity *ts_particles_quantity_text(size_t k)
{
	return k < NQUANTITIES ? &quantities[k].text : NULL;
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
