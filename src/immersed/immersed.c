#include "immersed/immersed.h"

#include <math.h>
#include <string.h>

#include "math/vec3.h"

#include "base/alloc.h"
#include "base/parallel.h"

#include "base/banned.h"

/* Fraction of the old pressure gradient that is added in advance to the velocities of outer points. These
 * are not exactly free of divergence, as those inside are: with the whole gradient their pressure would
 * grow in each step. */
static const double OUTER_PRESSURE = 0.5;

/* Work of an outer point in iterations of a simple loop, for the number of threads. */
enum { OUTER_ROUNDS = 8 };

/* Velocity to be added at a point of component c for the fraction `share` of the old pressure gradient,
 * dt/rho dp/dx, which the projection subtracts again. 0 with the incremental projection, whose predictor
 * contains that gradient. */
static double pressure_part(const struct ts_fluid *fluid, int c, size_t at, int index, double dt,
			    double share)
{
	const struct ts_grid *grid = &fluid->grid;

	share = fluid->incremental ? 0 : share;
	return share * dt / fluid->density * (fluid->p[at] - fluid->p[at - (size_t)grid->stride[c]]) /
	       grid->gap[c][index];
}

/* Velocity to be added at a sample for the old pressure gradient: trilinear between the points around it. */
static double sample_pressure_part(const struct ts_fluid *fluid, int c, const struct ts_immersed_sample *b,
				   double dt)
{
	const struct ts_grid *grid = &fluid->grid;
	const ptrdiff_t *stride = grid->stride;
	const double *p = fluid->p + b->corner;
	double w[3][2] = { { 1 - b->t[0], b->t[0] }, { 1 - b->t[1], b->t[1] }, { 1 - b->t[2], b->t[2] } };
	double sum = 0;

	if (fluid->incremental)
		return 0;
	for (int m = 0; m < 2; m++)
		w[c][m] *= dt / fluid->density / grid->gap[c][b->index + m];
	for (int k = 0; k < (grid->dimensions > 2 ? 2 : 1); k++)
		for (int j = 0; j < 2; j++)
			for (int i = 0; i < 2; i++) {
				const double *at = p + i + j * stride[1] + k * stride[2];

				sum += w[0][i] * w[1][j] * w[2][k] * (at[0] - at[-stride[c]]);
			}
	return sum;
}

static inline double between(double a, double b, double t)
{
	return a * (1 - t) + b * t;
}

/* The value of a component at a sample, trilinear between the points around it. */
static double sample_velocity(const struct ts_grid *grid, const double *u, const struct ts_immersed_sample *b)
{
	const double *t = b->t, *at = u + b->corner, *beside = at + grid->stride[1];
	double plane = between(between(at[0], at[1], t[0]), between(beside[0], beside[1], t[0]), t[1]);

	if (grid->dimensions == 2)
		return plane;
	at += grid->stride[2];
	beside += grid->stride[2];
	return between(plane, between(between(at[0], at[1], t[0]), between(beside[0], beside[1], t[0]), t[1]),
		       t[2]);
}

static void force_inside(struct ts_immersed *ib, struct ts_fluid *fluid, int c, double dt)
{
#pragma omp parallel for num_threads(ts_fluid_team(fluid, ib->first[c + 1] - ib->first[c])) schedule(static)
	for (size_t k = ib->first[c]; k < ib->first[c + 1]; k++) {
		struct ts_immersed_point *p = &ib->point[k];

		p->before = fluid->u[c][p->at];
		if (!p->outside)
			fluid->u[c][p->at] =
				p->target + pressure_part(fluid, c, p->at, p->index, dt, p->deep ? 0 : 1);
	}
}

/* The part of the values of outer points that is the same in all iterations. */
static void begin_outer_points(struct ts_immersed *ib, const struct ts_fluid *fluid, int c, double dt)
{
	size_t first = ib->outer_first[c], end = ib->outer_first[c + 1];

#pragma omp parallel for num_threads(ts_fluid_team(fluid, OUTER_ROUNDS *(end - first))) schedule(static)
	for (size_t k = first; k < end; k++) {
		struct ts_immersed_outer *b = &ib->outer[k];
		const struct ts_immersed_point *p = &ib->point[b->point];

		b->fixed = b->surface + pressure_part(fluid, c, p->at, p->index, dt, OUTER_PRESSURE);
		for (int m = 0; m < 2; m++)
			b->fixed -= b->out[m].count *
				    (b->surface + sample_pressure_part(fluid, c, &b->out[m], dt));
	}
}

static double outer_target_velocity(const struct ts_immersed *ib, const struct ts_fluid *fluid, int c,
				    const struct ts_immersed_outer *b)
{
	double before = ib->point[b->point].before, u = b->fixed;

	for (int m = 0; m < 2; m++)
		u += b->out[m].count * sample_velocity(&fluid->grid, fluid->u[c], &b->out[m]);
	return before + b->weight * (u - before);
}

/* All new values are computed from the old velocities: samples of an outer point may include other outer
 * points. */
static void force_outer_points(struct ts_immersed *ib, struct ts_fluid *fluid, int c)
{
	size_t first = ib->outer_first[c], end = ib->outer_first[c + 1];

#pragma omp parallel num_threads(ts_fluid_team(fluid, OUTER_ROUNDS *(end - first)))
	{
#pragma omp for schedule(static)
		for (size_t k = first; k < end; k++)
			ib->outer[k].next = outer_target_velocity(ib, fluid, c, &ib->outer[k]);
#pragma omp for schedule(static)
		for (size_t k = first; k < end; k++)
			fluid->u[c][ib->point[ib->outer[k].point].at] = ib->outer[k].next;
	}
}

/* Adds the impulse of the forcing at one point, and its moment, to the sums of the part. */
static void add_impulse(struct ts_immersed *ib, const struct ts_fluid *fluid, int c, size_t k)
{
	const struct ts_immersed_point *p = &ib->point[k];
	double *sum = ib->sums[p->part].stage,
	       e = fluid->void_fraction ? fluid->void_fraction_face[c][p->at] : 1;
	double impulse = fluid->density * e * p->volume * (fluid->u[c][p->at] - p->before);
	int a = (c + 1) % 3, b = (c + 2) % 3;

	sum[c] += impulse;
	sum[3 + a] += p->arm[b] * impulse;
	sum[3 + b] -= p->arm[a] * impulse;
}

/* The first point of component c of this part or a later one: points are sorted by part. */
static size_t first_point(const struct ts_immersed *ib, int c, size_t part)
{
	size_t low = ib->first[c], high = ib->first[c + 1];

	while (low < high) {
		size_t middle = low + (high - low) / 2;

		if ((size_t)ib->point[middle].part < part)
			low = middle + 1;
		else
			high = middle;
	}
	return low;
}

/* Sums of parts in parallel, each part by one thread, so that the order of its sum is fixed. */
struct part_task {
	struct ts_immersed *ib;
	const struct ts_fluid *fluid;
};

static void parts_in_parallel(struct ts_immersed *ib, const struct ts_fluid *fluid, size_t parts,
			      ts_range_fn *share, void *task)
{
	int team = ts_fluid_team(fluid, ib->npoints);

	ts_parallel(parts < (size_t)team ? (int)parts : team, parts, share, task);
}

static void add_part_impulses(void *context, size_t from, size_t to)
{
	const struct part_task *task = context;

	for (int c = 0; c < task->fluid->grid.dimensions; c++)
		for (size_t k = first_point(task->ib, c, from), end = first_point(task->ib, c, to); k < end;
		     k++)
			add_impulse(task->ib, task->fluid, c, k);
}

void ts_immersed_begin_step(struct ts_immersed *ib, size_t parts)
{
	if (parts)
		memset(ib->sums, 0, parts * sizeof *ib->sums);
	ib->first_dt = 0;
}

void ts_immersed_end_substep(struct ts_immersed *ib, size_t parts)
{
	for (size_t k = 0; k < parts; k++) {
		struct ts_immersed_sums *s = &ib->sums[k];

		ts_add(s->impulse, s->stage, s->impulse);
		ts_add(s->angular_impulse, s->stage + 3, s->angular_impulse);
		memset(s->stage, 0, sizeof s->stage);
	}
	ib->first_dt = 0;
}

/* A step of several stages s, each u <- keep_s u_0 + take_s (u + dt ...) with dt_s = take_s dt and take_0
 * = 1: the impulses of earlier stages are multiplied by take_s. */
static void scale_stage_sums(struct ts_immersed *ib, double dt, size_t parts)
{
	if (!(ib->first_dt > 0))
		ib->first_dt = dt;
	for (size_t k = 0; k < parts; k++)
		for (int d = 0; d < 6; d++)
			ib->sums[k].stage[d] *= dt / ib->first_dt;
}

void ts_immersed_force(struct ts_immersed *ib, struct ts_fluid *fluid, size_t parts, double dt,
		       int iterations)
{
	const int dimensions = fluid->grid.dimensions;

	scale_stage_sums(ib, dt, parts);
	for (int c = 0; c < dimensions; c++) {
		force_inside(ib, fluid, c, dt);
		begin_outer_points(ib, fluid, c, dt);
	}
	for (int m = 0; m < iterations && ib->nouter; m++) {
		if (ib->reads_ghosts)
			ts_fluid_fill_velocity(fluid, fluid->u);
		for (int c = 0; c < dimensions; c++)
			force_outer_points(ib, fluid, c);
	}
	parts_in_parallel(ib, fluid, parts, add_part_impulses, &(struct part_task){ ib, fluid });
}

/* Sums over the fluid inside one part, of one component. */
struct mean {
	double volume, u, x[3], xu[3];
};

static void mean_of_points(const struct ts_immersed *ib, const struct ts_fluid *fluid, int c, size_t from,
			   size_t to, struct mean *mean)
{
	for (size_t k = first_point(ib, c, from), end = first_point(ib, c, to); k < end; k++) {
		const struct ts_immersed_point *p = &ib->point[k];
		struct mean *m = &mean[p->part];
		double volume = p->solid * p->volume, u = fluid->u[c][p->at];

		m->volume += volume;
		m->u += volume * u;
		for (int d = 0; d < 3; d++) {
			m->x[d] += volume * p->arm[d];
			m->xu[d] += volume * p->arm[d] * u;
		}
	}
}

/* (x - X) x u, X the mean position of the points of each component: exactly 0 in uniform flow. */
static void add_mean_torque(struct ts_immersed_sums *s, int c, const struct mean *m, int dimensions)
{
	int a = (c + 1) % 3, b = (c + 2) % 3;
	double v = m->volume;

	if (!(v > 0))
		return;
	s->volume += v / dimensions;
	s->velocity[c] = m->u / v;
	s->spin[a] += m->xu[b] / v - m->x[b] / v * (m->u / v);
	s->spin[b] -= m->xu[a] / v - m->x[a] / v * (m->u / v);
}

struct mean_task {
	struct ts_immersed *ib;
	const struct ts_fluid *fluid;
	struct mean *mean;
};

static void mean_parts(void *context, size_t from, size_t to)
{
	const struct mean_task *task = context;
	const int dimensions = task->fluid->grid.dimensions;

	for (size_t k = from; k < to; k++) {
		struct ts_immersed_sums *s = &task->ib->sums[k];

		s->volume = 0;
		memset(s->velocity, 0, sizeof s->velocity);
		memset(s->spin, 0, sizeof s->spin);
	}
	for (int c = 0; c < dimensions; c++) {
		memset(task->mean + from, 0, (to - from) * sizeof *task->mean);
		mean_of_points(task->ib, task->fluid, c, from, to, task->mean);
		for (size_t k = from; k < to; k++)
			add_mean_torque(&task->ib->sums[k], c, &task->mean[k], dimensions);
	}
}

enum ts_status ts_immersed_inner_fluid(struct ts_immersed *ib, const struct ts_fluid *fluid, size_t parts)
{
	struct mean *mean = ts_alloc(parts, sizeof *mean);

	if (!mean)
		return TS_NOMEM;
	parts_in_parallel(ib, fluid, parts, mean_parts, &(struct mean_task){ ib, fluid, mean });
	ts_free(mean);
	return TS_OK;
}

double ts_immersed_slip(const struct ts_immersed *ib, const struct ts_fluid *fluid)
{
	double most = 0;

	for (int c = 0; c < fluid->grid.dimensions; c++)
#pragma omp parallel for num_threads(ts_fluid_team(fluid, ib->npoints / 3)) schedule(static) \
	reduction(max                                                                        \
		  : most)
		for (size_t k = ib->first[c]; k < ib->first[c + 1]; k++) {
			const struct ts_immersed_point *p = &ib->point[k];

			if (!p->outside && !p->deep)
				most = fmax(most, fabs(fluid->u[c][p->at] - p->target));
		}
	return most;
}
