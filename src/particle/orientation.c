#include "particle/orientation.h"

#include <math.h>
#include <string.h>

#include "base/parallel.h"
#include "math/quaternion.h"
#include "math/vec3.h"
#include "particle/columns.h"
#include "particle/particles.h"

#include "base/banned.h"

static const char NAME[] = "orientation";

static const struct ts_column *find_column(const struct ts_particles *p)
{
	for (size_t k = TS_NCOLUMN_BUILTIN; k < p->ncolumns; k++)
		if (p->column[k].width == 4 && !strcmp(p->column[k].name, NAME))
			return &p->column[k];
	return NULL;
}

static enum ts_status add_column(struct tsim *sim, size_t *index)
{
	static const double unit[4] = { 1, 0, 0, 0 };
	struct ts_particles *p = sim->particles;
	bool known = find_column(p);

	TS_TRY(ts_particles_need(sim, TS_NEED(OMEGA) | TS_NEED(TORQUE)));
	TS_TRY(ts_particles_add_column(sim, NAME, 4, TS_COL_NAMED, index));
	if (known)
		return TS_OK;
	TS_TRY(ts_particles_column_initial(sim, *index, unit));
	ts_particles_fill_initial(&p->column[*index], 0, p->n);
	return TS_OK;
}

enum ts_status ts_orientation_need(struct tsim *sim)
{
	size_t index;

	return add_column(sim, &index);
}

double (*ts_orientation(const struct tsim *sim))[4]
{
	const struct ts_column *c = find_column(sim->particles);

	return c ? c->data : NULL;
}

void ts_orientation_of(const struct tsim *sim, size_t i, double q[4])
{
	double(*all)[4] = ts_orientation(sim);

	for (int k = 0; k < 4; k++)
		q[k] = all ? all[i][k] : k == 0;
}

/* cos(a) and sin(a)/a, of x = a^2; for x < 0.02 by their series, to rounding. */
static void rotation_of(double x, double *cosine, double *sine)
{
	if (x < 0.02) {
		*cosine = 1 - x / 2 * (1 - x / 12 * (1 - x / 30 * (1 - x / 56 * (1 - x / 90))));
		*sine = 1 - x / 6 * (1 - x / 20 * (1 - x / 42 * (1 - x / 72)));
	} else {
		double a = sqrt(x);

		*cosine = cos(a);
		*sine = sin(a) / a;
	}
}

struct turning {
	double dt;
	double (*omega)[3], (*q)[4];
};

static void advance(void *context, size_t from, size_t to)
{
	const struct turning *t = context;

	for (size_t i = from; i < to; i++) {
		double turn[4], q[4], sine, norm;

		ts_scale(0.5 * t->dt, t->omega[i], turn + 1);
		rotation_of(ts_dot(turn + 1, turn + 1), &turn[0], &sine);
		ts_scale(sine, turn + 1, turn + 1);
		ts_quaternion_multiply(turn, t->q[i], q);
		/* |q| - 1 is a rounding error: one step of Newton for 1/|q| */
		norm = 1.5 - 0.5 * (q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
		for (int k = 0; k < 4; k++)
			t->q[i][k] = norm * q[k];
	}
}

void ts_orientation_advance(struct tsim *sim)
{
	struct turning t = { sim->clock.dt, sim->particles->omega, ts_orientation(sim) };

	if (t.q && t.omega)
		ts_parallel(ts_team(sim, sim->particles->n), sim->particles->n, advance, &t);
}

void ts_orientation_turn(const struct tsim *sim, size_t i, const double axis[3], double angle)
{
	double(*all)[4] = ts_orientation(sim), sine = sin(angle / 2);
	const double turn[4] = { cos(angle / 2), sine * axis[0], sine * axis[1], sine * axis[2] };
	double q[4];

	if (!all)
		return;
	ts_quaternion_multiply(turn, all[i], q);
	memcpy(all[i], q, sizeof q);
}

enum ts_status ts_orientation_archive(struct tsim *sim, struct ts_archive *archive)
{
	size_t index;

	TS_TRY(add_column(sim, &index));
	return ts_particles_archive_column(archive, sim, NAME, index);
}
