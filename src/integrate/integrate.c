#include "integrate/integrate.h"

#include "base/clones.h"
#include "base/inline.h"
#include "core/deferred_loops.h"
#include "group/group_members.h"
#include "particle/sphere_shape.h"

#include "base/banned.h"

/* The columns are passed through once, a block of particles at a time: factors of the block are made
 * first, then its coordinates are taken as plain lists of numbers, three to a particle. */
enum { BLOCK = 128 };

struct task {
	const struct ts_particles *p;
	struct ts_integration step;
	double inertia;
	int group;
};

/* Of each coordinate of a block. */
struct factors {
	double kick[3 * BLOCK], turn[3 * BLOCK];
	int64_t in[3 * BLOCK]; /* belongs to the group; not filled where all do */
};

TS_INLINE void make_factors(const struct task *t, size_t from, size_t n, struct factors *f)
{
	const double *mass = t->p->mass + from, *radius = t->p->radius + from;
	double kick = t->step.kick, turn = t->step.turn, inertia = t->inertia;

#pragma omp simd
	for (size_t i = 0; i < n; i++)
		f->kick[3 * i] = f->kick[3 * i + 1] = f->kick[3 * i + 2] = kick / mass[i];
	if (!(turn != 0))
		return;
#pragma omp simd
	for (size_t i = 0; i < n; i++)
		f->turn[3 * i] = f->turn[3 * i + 1] = f->turn[3 * i + 2] =
			turn / mass[i] / (inertia * radius[i] * radius[i]);
}

TS_INLINE void find_members(const struct task *t, size_t from, size_t n, struct factors *f)
{
	const uint32_t *mask = t->p->mask + from;

#pragma omp simd
	for (size_t i = 0; i < n; i++)
		f->in[3 * i] = f->in[3 * i + 1] = f->in[3 * i + 2] = mask[i] >> t->group & 1u;
}

/* to += factor * from, a factor for each number, or one for all where the list is NULL. */
TS_INLINE void add(double *restrict to, const double *restrict from, const double *restrict factors,
		   double factor, const int64_t *restrict in, size_t n)
{
#pragma omp simd
	for (size_t k = 0; k < n; k++) {
		double sum = to[k] + (factors ? factors[k] : factor) * from[k];

		to[k] = !in || in[k] ? sum : to[k];
	}
}

TS_INLINE void advance(const struct task *t, size_t from, size_t n, const struct factors *f,
		       const int64_t *in)
{
	const struct ts_particles *p = t->p;
	const struct ts_integration *s = &t->step;

	if (s->early != 0)
		add(p->x[from], p->v[from], NULL, s->early, in, 3 * n);
	if (s->kick != 0)
		add(p->v[from], p->f[from], f->kick, 0, in, 3 * n);
	if (s->turn != 0)
		add(p->omega[from], p->torque[from], f->turn, 0, in, 3 * n);
	if (s->drift != 0)
		add(p->x[from], p->v[from], NULL, s->drift, in, 3 * n);
}

TS_CLONES
static void block_of_all(const struct task *t, size_t from, size_t n)
{
	struct factors f;

	make_factors(t, from, n, &f);
	advance(t, from, n, &f, NULL);
}

TS_CLONES
static void block_of_some(const struct task *t, size_t from, size_t n)
{
	struct factors f;

	find_members(t, from, n, &f);
	make_factors(t, from, n, &f);
	advance(t, from, n, &f, f.in);
}

static void share(void *context, size_t from, size_t to)
{
	const struct task *t = context;

	for (; from < to; from += BLOCK) {
		size_t n = to - from < BLOCK ? to - from : BLOCK;
		size_t members = t->group == 0 ? n : ts_group_members(t->p, t->group, from, from + n);

		if (members == n)
			block_of_all(t, from, n);
		else if (members)
			block_of_some(t, from, n);
	}
}

void ts_integrate(struct tsim *sim, int group, const struct ts_integration *step)
{
	const struct ts_particles *p = sim->particles;
	struct task task = { p, *step, ts_inertia_factor(sim), group };

	if (!p->omega || !p->torque)
		task.step.turn = 0;
	TS_DEFER_LOOP(sim, p->n, share, &task);
}
