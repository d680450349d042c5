/* Fix aveforce: each particle of the group gets the mean force of the group. */
#include "base/axes.h"
#include "core/arg.h"
#include "force/restraint.h"
#include "group/chosen.h"
#include "math/exactsum.h"
#include "particle/rank_sums.h"

#include "base/banned.h"

struct state {
	struct ts_number f[3];
	struct ts_instance *region;
	double before[3]; /* saved: total force before averaging */
};

/* Returns the number of particles, of all ranks as the forces. */
static double sum_forces(const struct ts_instance *self, const struct tsim *sim, double total[3])
{
	const struct state *s = self->state;
	const struct ts_particles *p = sim->particles;
	struct ts_exactsum part[4] = { 0 };
	double n = 0;

	for (size_t i = 0; i < p->n; i++) {
		if (!ts_chosen(p, i, self->group, s->region))
			continue;
		for (int k = 0; k < 3; k++)
			ts_exactsum_add(&part[k], p->f[i][k]);
		n++;
	}
	ts_exactsum_add(&part[3], n);
	ts_rank_sums_merge(sim, part, 4);
	for (int k = 0; k < 3; k++)
		total[k] = ts_exactsum_value(&part[k]);
	return ts_exactsum_value(&part[3]);
}

static enum ts_status average_forces(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	struct ts_particles *p = sim->particles;
	double mean[3], added, n;

	TS_TRY(ts_region_update(s->region, sim));
	n = sum_forces(self, sim, s->before);
	for (int k = 0; k < 3; k++) {
		if (s->f[k].null)
			continue;
		TS_TRY(ts_number_now(sim, &s->f[k], &self->where, &added));
		mean[k] = n > 0 ? s->before[k] / n + added : 0;
	}
#pragma omp parallel for num_threads(ts_team(sim, p->n)) schedule(static)
	for (size_t i = 0; i < p->n; i++)
		for (int k = 0; ts_chosen(p, i, self->group, s->region) && k < 3; k++)
			if (!s->f[k].null)
				p->f[i][k] = mean[k];
	return TS_OK;
}

static enum ts_status eval_before(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct state *s = self->state;

	(void)sim;
	for (int k = 0; k < 3; k++)
		out->data[k] = s->before[k];
	return TS_OK;
}

static const struct ts_arg args[] = {
	TS_NUMBER("fx", struct state, f[0], .flags = TS_POSITIONAL | TS_NULLABLE, .unit = "force",
		  .help = "x component added to the mean force; NULL: this component is not averaged; "
			  "v_NAME: a variable"),
	TS_NUMBER("fy", struct state, f[1], .flags = TS_POSITIONAL | TS_NULLABLE, .unit = "force",
		  .help = "y component"),
	TS_NUMBER("fz", struct state, f[2], .flags = TS_POSITIONAL | TS_NULLABLE, .unit = "force",
		  .help = "z component"),
	TS_REGION_KEYWORD(struct state),
	TS_ARGS_END,
};

static const struct ts_value values[] = {
	{ "before", "force", "total force on the particles before it was averaged", TS_VECTOR, 3,
	  ts_axis_names, eval_before },
	{ .name = NULL },
};

static const struct ts_restraint restraint = { NULL, NULL };
static const struct ts_saved saved[] = { TS_SAVE_F64(struct state, before), TS_SAVED_ROWS_END };

TS_STYLE(fix, ts_style, ts_fix_aveforce)
const struct ts_style ts_fix_aveforce = {
	.name = "aveforce",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_OWN | TS_RANKS_OUTPUTS,
	.summary = "sets the force on each particle to the mean force of the group",
	.doc = "Each component that is not NULL is set to f = (sum of f) / n + (fx, fy, fz) for all n "
	       "particles of the group (that are in the region). Particles of equal mass and equal velocity "
	       "then move as one body without rotation.",
	.example = "fix lid top aveforce NULL NULL -2.5",
	.args = args,
	.state_size = sizeof(struct state),
	.saved = saved,
	.values = values,
	.hook[TS_STAGE_POST_FORCE] = average_forces,
	.restraint = &restraint,
};
