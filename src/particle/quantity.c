#include "particle/quantity.h"

#include <string.h>

#include "box/domain.h"
#include "particle/group_moments.h"
#include "particle/sphere_shape.h"

#include "base/banned.h"

struct quantity {
	struct ts_quantity text;
	ts_quantity_fn *value;
};

#define VECTOR_QUANTITY(name, column)                             \
	static double name##_x(const struct tsim *sim, size_t i)  \
	{                                                         \
		const struct ts_particles *p = sim->particles;    \
                                                                  \
		return p->column ? (double)p->column[i][0] : 0.0; \
	}                                                         \
	static double name##_y(const struct tsim *sim, size_t i)  \
	{                                                         \
		const struct ts_particles *p = sim->particles;    \
                                                                  \
		return p->column ? (double)p->column[i][1] : 0.0; \
	}                                                         \
	static double name##_z(const struct tsim *sim, size_t i)  \
	{                                                         \
		const struct ts_particles *p = sim->particles;    \
                                                                  \
		return p->column ? (double)p->column[i][2] : 0.0; \
	}
VECTOR_QUANTITY(position, x)
VECTOR_QUANTITY(velocity, v)
VECTOR_QUANTITY(force, f)
VECTOR_QUANTITY(spin, omega)
VECTOR_QUANTITY(torque, torque)
VECTOR_QUANTITY(image, image)

/* xu: unwrapped position; xs: position in units of the box, 0 to 1; xsu: unwrapped position in these
 * units. */
static double unwrapped_coordinate(const struct tsim *sim, size_t i, int k)
{
	double x[3];

	ts_unwrapped(sim, i, x);
	return x[k];
}

static double fractional_coordinate(const struct tsim *sim, double x, int k)
{
	const struct ts_box *box = &sim->domain->box;

	return (x - box->lo[k]) / ts_box_length(box, k);
}

#define POSITION_QUANTITY(name, k)                                                     \
	static double name##_unwrapped(const struct tsim *sim, size_t i)               \
	{                                                                              \
		return unwrapped_coordinate(sim, i, k);                                \
	}                                                                              \
	static double name##_scaled(const struct tsim *sim, size_t i)                  \
	{                                                                              \
		return fractional_coordinate(sim, sim->particles->x[i][k], k);         \
	}                                                                              \
	static double name##_scaled_unwrapped(const struct tsim *sim, size_t i)        \
	{                                                                              \
		return fractional_coordinate(sim, unwrapped_coordinate(sim, i, k), k); \
	}
POSITION_QUANTITY(x, 0)
POSITION_QUANTITY(y, 1)
POSITION_QUANTITY(z, 2)

static double particle_tag(const struct tsim *sim, size_t i)
{
	return sim->particles->tag[i];
}

static double particle_type(const struct tsim *sim, size_t i)
{
	return sim->particles->type[i];
}

static double particle_radius(const struct tsim *sim, size_t i)
{
	return sim->particles->radius[i];
}

static double particle_diameter(const struct tsim *sim, size_t i)
{
	return 2 * sim->particles->radius[i];
}

static double particle_mass(const struct tsim *sim, size_t i)
{
	return sim->particles->mass[i];
}

static double particle_density(const struct tsim *sim, size_t i)
{
	return sim->particles->material_density(sim, i);
}

static double particle_body(const struct tsim *sim, size_t i)
{
	return sim->particles->body ? sim->particles->body[i] : 0;
}

static double always_zero(const struct tsim *sim, size_t i)
{
	(void)sim, (void)i;
	return 0;
}

/* L = I omega; k: component. */
static double angular_momentum(const struct tsim *sim, size_t i, int k)
{
	return sim->particles->omega ? ts_inertia(sim, i) * sim->particles->omega[i][k] : 0;
}

static double angular_momentum_x(const struct tsim *sim, size_t i)
{
	return angular_momentum(sim, i, 0);
}

static double angular_momentum_y(const struct tsim *sim, size_t i)
{
	return angular_momentum(sim, i, 1);
}

static double angular_momentum_z(const struct tsim *sim, size_t i)
{
	return angular_momentum(sim, i, 2);
}

static const struct quantity quantities[] = {
	{ { "id", "", "atom ID, 1 or larger" }, particle_tag },
	{ { "type", "", "type, 1 or larger" }, particle_type },
	{ { "radius", "length", "radius" }, particle_radius },
	{ { "diameter", "length", "diameter" }, particle_diameter },
	{ { "mass", "mass", "mass" }, particle_mass },
	{ { "density", "density", "mass / volume; in a clump the density of its material" },
	  particle_density },
	{ { "mol", "",
	    "molecule number of fix property/atom mol; without that fix id of the rigid body, or 0" },
	  particle_body },
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
	{ { "xu", "length", "unwrapped position" }, x_unwrapped },
	{ { "yu", "length", "unwrapped position" }, y_unwrapped },
	{ { "zu", "length", "unwrapped position" }, z_unwrapped },
	{ { "xs", "", "scaled position, 0 to 1 across the box" }, x_scaled },
	{ { "ys", "", "scaled position, 0 to 1 across the box" }, y_scaled },
	{ { "zs", "", "scaled position, 0 to 1 across the box" }, z_scaled },
	{ { "xsu", "", "scaled and unwrapped position" }, x_scaled_unwrapped },
	{ { "ysu", "", "scaled and unwrapped position" }, y_scaled_unwrapped },
	{ { "zsu", "", "scaled and unwrapped position" }, z_scaled_unwrapped },
	{ { "ix", "", "image flag: net number of crossings of the periodic box" }, image_x },
	{ { "iy", "", "image flag: net number of crossings of the periodic box" }, image_y },
	{ { "iz", "", "image flag: net number of crossings of the periodic box" }, image_z },
	{ { "proc", "", "processor: always 0" }, always_zero },
	{ { "thread", "", "thread: always 0, results do not depend on threads" }, always_zero },
	{ { "angmomx", "mass*length^2/time", "angular momentum about its centre, I omega" },
	  angular_momentum_x },
	{ { "angmomy", "mass*length^2/time", "angular momentum about its centre, I omega" },
	  angular_momentum_y },
	{ { "angmomz", "mass*length^2/time", "angular momentum about its centre, I omega" },
	  angular_momentum_z },
};
enum { NQUANTITIES = sizeof quantities / sizeof *quantities };

static const struct quantity *find_quantity(const char *name)
{
	for (int k = 0; k < NQUANTITIES; k++)
		if (ts_streq(quantities[k].text.name, name))
			return &quantities[k];
	return NULL;
}

const struct ts_column *ts_particles_named_column(const struct ts_particles *p, const char *name, size_t *k)
{
	size_t n = strcspn(name, "["), digits = strcspn(name + n, "]");
	char index[16] = "";
	int64_t column = 1;

	*k = 0;
	if (name[n]) {
		if (digits < 2 || digits > sizeof index || !ts_streq(name + n + digits, "]"))
			return NULL;
		memcpy(index, name + n + 1, digits - 1);
		if (!ts_parse_int(index, &column) || column < 0)
			return NULL;
	}
	for (size_t j = TS_NCOLUMN_BUILTIN; j < p->ncolumns; j++) {
		const struct ts_column *c = &p->column[j];

		if (!(c->flags & TS_COL_NAMED) || strlen(c->name) != n || strncmp(c->name, name, n) != 0)
			continue;
		if (!name[n] || !column) /* as in LIGGGHTS, [0] denotes a scalar */
			return c->width == 1 ? c : NULL;
		*k = (size_t)column - 1;
		return *k < c->width ? c : NULL;
	}
	return NULL;
}

bool ts_particles_has_quantity(const struct tsim *sim, const char *name)
{
	size_t k;

	return find_quantity(name) || ts_particles_named_column(sim->particles, name, &k);
}

bool ts_particles_keeps_quantity(const struct tsim *sim, const char *name)
{
	size_t k;

	return !find_quantity(name) && ts_particles_named_column(sim->particles, name, &k);
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

ts_quantity_fn *ts_particles_quantity_fn(const struct tsim *sim, const char *name)
{
	const struct quantity *q = find_quantity(name);
	size_t k;

	return q && !ts_particles_named_column(sim->particles, name, &k) ? q->value : NULL;
}

enum ts_status ts_particles_quantity(struct tsim *sim, const char *name, struct ts_table *out)
{
	const struct ts_particles *p = sim->particles;
	const struct quantity *q = find_quantity(name);
	const struct ts_column *named;
	size_t k;

	if (ts_table_resize(out, p->n, 1) != TS_OK)
		return ts_nomem(&sim->error);
	named = ts_particles_named_column(p, name,
					  &k); /* before built-in names, since `mol` may be a column */
	for (size_t i = 0; i < p->n; i++)
		out->data[i] = named ? ((const double *)named->data)[i * named->width + k] : q->value(sim, i);
	return TS_OK;
}
