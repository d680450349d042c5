#include "integrate/integrate.h"

#include "base/clones.h"
#include "base/inline.h"
#include "core/deferred_loops.h"
#include "group/group_members.h"
#include "particle/sphere_shape.h"

#include "base/banned.h"

/* Columns are processed in blocks of particles: first the factors of a block, then its coordinates as plain
 * arrays of numbers, three per particle. */
enum { BLOCK = 128 };

struct task {
	const struct ts_particles *p;
	struct ts_integration step;
	double inertia;
	int group;
};

/* kick/m and kick_omega/I of a block: of all its particles, where these are equal, or by coordinate. */
struct factors {
	bool equal;
	double of_all[2];
	double kick[3 * BLOCK], kick_omega[3 * BLOCK];
	int64_t in[3 * BLOCK]; /* 1: the particle is in the group; not set if all are */
};

/* Whether the particles have the same mass and radius. */
TS_INLINE bool all_equal(const double *restrict mass, const double *restrict radius, size_t n)
{
	int64_t others = 0;

#pragma omp simd reduction(+ : others)
	for (size_t i = 0; i < n; i++)
		others += (mass[i] != mass[0]) | (radius[i] != radius[0]);
	return others == 0;
}

TS_INLINE double kick_omega_of(const struct task *t, double mass, double radius)
{
	return t->step.kick_omega / mass / (t->inertia * radius * radius);
}

/* Divisions take more time than all the rest of a loop: equal particles share them. */
TS_INLINE void make_factors(const struct task *t, size_t from, size_t n, struct factors *f)
{
	const double *restrict mass = t->p->mass + from, *restrict radius = t->p->radius + from;
	const struct task s = *t;

	f->equal = all_equal(mass, radius, n);
	f->of_all[0] = s.step.kick / mass[0];
	f->of_all[1] = kick_omega_of(&s, mass[0], radius[0]);
	if (f->equal)
		return;
#pragma omp simd
	for (size_t i = 0; i < n; i++)
		f->kick[3 * i] = f->kick[3 * i + 1] = f->kick[3 * i + 2] = s.step.kick / mass[i];
	if (!(s.step.kick_omega != 0))
		return;
#pragma omp simd
	for (size_t i = 0; i < n; i++)
		f->kick_omega[3 * i] = f->kick_omega[3 * i + 1] = f->kick_omega[3 * i + 2] =
			kick_omega_of(&s, mass[i], radius[i]);
}

TS_INLINE void find_members(const struct task *t, size_t from, size_t n, struct factors *f)
{
	const uint32_t *mask = t->p->mask + from;

#pragma omp simd
	for (size_t i = 0; i < n; i++)
		f->in[3 * i] = f->in[3 * i + 1] = f->in[3 * i + 2] = mask[i] >> t->group & 1u;
}

/* to += factor * from; `factors`: one factor for each number, or NULL: `factor` for all. `in`: which numbers
 * change, NULL: all. */
TS_INLINE void add_scaled(double *restrict to, const double *restrict from, const double *restrict factors,
			  double factor, const int64_t *restrict in, size_t n)
{
#pragma omp simd
	for (size_t k = 0; k < n; k++) {
		double sum = to[k] + (factors ? factors[k] : factor) * from[k];

		to[k] = !in || in[k] ? sum : to[k];
	}
}

TS_INLINE void advance_block(const struct task *t, size_t from, size_t n, const struct factors *f, bool equal,
			     const int64_t *in)
{
	const struct ts_particles *p = t->p;
	const struct ts_integration *s = &t->step;

	if (s->drift_first != 0)
		add_scaled(p->x[from], p->v[from], NULL, s->drift_first, in, 3 * n);
	if (s->kick != 0)
		add_scaled(p->v[from], p->f[from], equal ? NULL : f->kick, f->of_all[0], in, 3 * n);
	if (s->kick_omega != 0)
		add_scaled(p->omega[from], p->torque[from], equal ? NULL : f->kick_omega, f->of_all[1], in,
			   3 * n);
	if (s->drift != 0)
		add_scaled(p->x[from], p->v[from], NULL, s->drift, in, 3 * n);
}

TS_CLONES
static void advance_all(const struct task *t, size_t from, size_t n)
{
	struct factors f;

	make_factors(t, from, n, &f);
	if (f.equal)
		advance_block(t, from, n, &f, true, NULL);
	else
		advance_block(t, from, n, &f, false, NULL);
}

TS_CLONES
static void advance_members(const struct task *t, size_t from, size_t n)
{
	struct factors f;

	find_members(t, from, n, &f);
	make_factors(t, from, n, &f);
	advance_block(t, from, n, &f, f.equal, f.in);
}

static void advance_share(void *context, size_t from, size_t to)
{
	const struct task *t = context;

	for (; from < to; from += BLOCK) {
		size_t n = to - from < BLOCK ? to - from : BLOCK;
		size_t members = t->group == 0 ? n : ts_group_members(t->p, t->group, from, from + n);

		if (members == n)
			advance_all(t, from, n);
		else if (members)
			advance_members(t, from, n);
	}
}

void ts_integrate(struct tsim *sim, int group, const struct ts_integration *step)
{
	const struct ts_particles *p = sim->particles;
	struct task task = { p, *step, ts_inertia_factor(sim), group };

	if (!p->omega || !p->torque)
		task.step.kick_omega = 0;
	TS_DEFER_LOOP(sim, p->n, advance_share, &task);
}
