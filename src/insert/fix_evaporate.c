/* Fix evaporate: deletes randomly chosen particles. */
#include "base/sort.h"
#include "core/sim.h"

#include <stdlib.h>

#include "group/chosen.h"
#include "math/rng.h"
#include "particle/columns.h"
#include "rigid/rigid.h"

#include "base/banned.h"

struct draw {
	double number;
	int32_t tag;
	size_t row;
};

struct state {
	int64_t every, number, seed;
	struct ts_instance *region;
	bool molecule;
	struct draw *draw;
	size_t capacity;
	int64_t gone; /* saved: particles deleted since the beginning */
};

static enum ts_status refuse_member(struct ts_instance *self, struct tsim *sim, size_t i)
{
	return ts_fail(&sim->error, TS_STATE, &self->where,
		       "fix evaporate: particle %d belongs to a rigid body, which cannot lose particles; "
		       "restrict the group to free particles",
		       sim->particles->tag[i]);
}

/* Members of bodies that are known before the run are refused then, and not only in the step that draws one of them. */
static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	const struct state *s = self->state;
	const struct ts_particles *p = sim->particles;

	if (s->molecule)
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "fix evaporate: there are no molecules, molecule yes has no meaning");
	TS_TRY(ts_region_update(s->region, sim));
	for (size_t i = 0; i < p->n; i++)
		if (ts_rigid_member(p, i) && ts_chosen(p, i, self->group, s->region))
			return refuse_member(self, sim, i);
	return TS_OK;
}

static int compare_draws(const void *a, const void *b)
{
	const struct draw *s = a, *t = b;

	if (s->number < t->number || s->number > t->number)
		return s->number < t->number ? -1 : 1;
	return (s->tag > t->tag) - (s->tag < t->tag);
}

/* Chooses the particles with the smallest random numbers, which are functions of seed, step and tag; *n:
 * how many. */
static enum ts_status choose_particles(struct ts_instance *self, struct tsim *sim, size_t *n)
{
	struct state *s = self->state;
	const struct ts_particles *p = sim->particles;

	TS_TRY(ts_region_update(s->region, sim));
	if (TS_GROW(s->draw, s->capacity, p->n) != TS_OK)
		return ts_nomem(&sim->error);
	*n = 0;
	for (size_t i = 0; i < p->n; i++) {
		struct ts_rng rng = ts_rng_start((uint64_t)s->seed, (uint64_t)p->tag[i]);

		if (!ts_chosen(p, i, self->group, s->region))
			continue;
		rng.counter = (uint64_t)sim->clock.step;
		s->draw[*n] = (struct draw){ ts_rng_uniform(&rng), p->tag[i], i };
		++*n;
	}
	ts_sort(s->draw, *n, sizeof *s->draw, compare_draws);
	if (*n > (size_t)s->number)
		*n = (size_t)s->number;
	for (size_t k = 0; k < *n; k++)
		if (ts_rigid_member(p, s->draw[k].row))
			return refuse_member(self, sim, s->draw[k].row);
	return TS_OK;
}

static enum ts_status post_integrate(struct ts_instance *self, struct tsim *sim)
{
	const struct state *s = self->state;

	sim->run.rebuild |= sim->clock.step % s->every == 0;
	return TS_OK;
}

static enum ts_status exchange(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	unsigned char *flag;
	enum ts_status status;
	size_t n = 0;

	if (!sim->run.rebuild || sim->clock.step % s->every != 0)
		return TS_OK;
	TS_TRY(choose_particles(self, sim, &n));
	if (!n)
		return TS_OK;
	flag = ts_alloc(sim->particles->n, 1);
	if (!flag)
		return ts_nomem(&sim->error);
	for (size_t k = 0; k < n; k++)
		flag[s->draw[k].row] = 1;
	status = ts_particles_delete(sim, flag);
	ts_free(flag);
	s->gone += (int64_t)n;
	return status;
}

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	(void)sim;
	out->data[0] = (double)((const struct state *)self->state)->gone;
	return TS_OK;
}

static void fini(struct ts_instance *self)
{
	ts_free(((struct state *)self->state)->draw);
}

static const struct ts_arg args[] = {
	TS_INT("N", struct state, every, .flags = TS_POSITIONAL, .range = TS_WITHIN, .lo = 1, .hi = 1e15,
	       .help = "steps between deletions"),
	TS_INT("M", struct state, number, .flags = TS_POSITIONAL, .range = TS_WITHIN, .lo = 1, .hi = 1e9,
	       .help = "number of particles deleted each time"),
	TS_REGION("region", struct state, region, .flags = TS_POSITIONAL,
		  .help = "region in which particles are deleted"),
	TS_INT("seed", struct state, seed, .flags = TS_POSITIONAL, .range = TS_POSITIVE,
	       .help = "seed of the random numbers"),
	TS_BOOL("molecule", struct state, molecule, .fallback = "no",
		.help = "only no is accepted: there are no molecules"),
	TS_ARGS_END,
};

static const struct ts_value values[] = {
	{ "gone", "", "number of particles deleted so far", TS_SCALAR, 1, NULL, eval },
	{ .name = NULL },
};

static const struct ts_saved saved[] = { TS_SAVE_I64(struct state, gone), TS_SAVED_ROWS_END };

static bool is_due(const struct ts_instance *self, const struct tsim *sim)
{
	const struct state *s = self->state;

	return sim->clock.step % s->every == 0;
}

TS_STYLE(fix, ts_style, ts_fix_evaporate)
const struct ts_style ts_fix_evaporate = {
	.name = "evaporate",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_STEPS,
	.due = is_due,
	.summary = "Deletes randomly chosen particles",
	.doc = "In each step that is a multiple of N, M particles are chosen at random among those of the "
	       "group whose centres are in the region, and deleted; all of them if there are fewer. The "
	       "random numbers are functions of seed, step and atom ID: the choice does not depend on the "
	       "number of threads and is the same after a restart. Particles of rigid bodies are an "
	       "error.",
	.example = "fix dry all evaporate 1000 10 top 49892",
	.args = args,
	.state_size = sizeof(struct state),
	.saved = saved,
	.values = values,
	.init = init,
	.hook = {
		[TS_STAGE_POST_INTEGRATE] = post_integrate,
		[TS_STAGE_EXCHANGE] = exchange,
	},
	.fini = fini,
};
