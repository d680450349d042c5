/* Fix check/timestep/bond: compares the time step with the time of vibration of the bonds. */
#include "limits/step_check.h"

#include <math.h>
#include <stdio.h>

#include "bond/bond_force.h"
#include "bond/bonds.h"
#include "core/report.h"
#include "limits/network.h"
#include "neigh/neigh.h"
#include "particle/particles.h"

#include "base/banned.h"

enum { BOND, SKIN, STABLE };

struct state {
	struct ts_step_check check; /* first: ts_step_check_eval */
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	return ts_step_check_init(self, sim, &s->check, 1, "fraction_bond");
}

static bool is_in_group(const struct ts_instance *self, const struct tsim *sim, size_t b)
{
	const int32_t *row = sim->bonds->row[b];

	return ts_in_group(sim->particles, (size_t)row[0], self->group) &&
	       ts_in_group(sim->particles, (size_t)row[1], self->group);
}

/* *time: smallest 1/omega of a bond of the group, omega its fastest vibration; `legacy`: of its stretching.
 * *limit: smallest stability limit of a bond of the group. */
static void find_times(const struct ts_instance *self, const struct tsim *sim, bool legacy, double *time,
		       double *limit)
{
	*time = *limit = INFINITY;
	for (size_t b = 0; ts_sim_only(sim, TS_KIND_BOND) && b < sim->bonds->n; b++) {
		double alone;

		if (!is_in_group(self, sim, b))
			continue;
		alone = ts_bond_limit(sim, b, false);
		*limit = fmin(*limit, alone);
		*time = fmin(*time, legacy ? ts_bond_stretch_time(sim, b) : 0.5 * alone);
	}
}

/* The same of all bonds, contacts and walls together, if it is smaller. */
static enum ts_status find_coupled_limit(struct tsim *sim, double *limit)
{
	struct ts_plan_report report = { .limits_only = true, .enough = INFINITY };
	enum ts_status status = ts_network_report(&report, sim);
	const struct ts_limit *hard = ts_report_binding(&report, true);

	if (hard)
		*limit = fmin(*limit, hard->dt);
	ts_report_release(&report);
	return status;
}

static enum ts_status end_of_step(struct ts_instance *self, struct tsim *sim)
{
	struct ts_step_check *c = &((struct state *)self->state)->check;
	double time, limit, dt = sim->clock.dt;
	char more[64];

	if (!ts_step_check_is_due(c, sim))
		return TS_OK;
	find_times(self, sim, c->legacy || sim->legacy == TS_LEGACY_LIGGGHTS, &time, &limit);
	if (isfinite(limit))
		TS_TRY(find_coupled_limit(sim, &limit));
	c->ratio[BOND] = dt / time;
	c->ratio[SKIN] = ts_step_check_speed(self, sim, c) * dt / ts_neigh_skin(sim);
	c->ratio[STABLE] = dt / limit;
	snprintf(more, sizeof more, "; it is %.4g %% of the stability limit", 100 * c->ratio[STABLE]);
	TS_TRY(ts_step_check_judge(self, sim, c, BOND, "of the time of the bonds", more));
	return ts_step_check_judge_skin(self, sim, c, SKIN);
}

static const struct ts_arg args[] = {
	TS_LIST("when", struct state, check.words,
		.help = "number of steps between checks, or `check_every_time T`; then the largest allowed "
			"fraction of the time of the bonds"),
	TS_STEP_CHECK_ROWS(struct state, check),
	TS_ARGS_END,
};

static const char *const names[] = { "bond", "skin", "stable" };
static const struct ts_value values[] = {
	{ "ratios", "", "dt by the time of the bonds, displacement per step by the skin, dt by the limit",
	  TS_VECTOR, TS_STEP_RATIOS, names, ts_step_check_eval },
	{ .name = NULL },
};
static const struct ts_saved saved[] = { TS_SAVE_F64(struct state, check.ratio), TS_SAVED_ROWS_END };

static bool is_due(const struct ts_instance *self, const struct tsim *sim)
{
	const struct state *s = self->state;

	return ts_step_check_is_due(&s->check, sim);
}

TS_STYLE(fix, ts_style, ts_fix_check_timestep_bond)
const struct ts_style ts_fix_check_timestep_bond = {
	.name = "check/timestep/bond",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_WHOLE,
	.due = is_due,
	.summary = "compares the time step with the vibration of the bonds",
	.doc = "Every N steps three ratios are computed. f_ID[1] = dt/t_b, with the smallest time t_b = "
	       "1/omega of the bonds between particles of the group. omega is the angular frequency of the "
	       "fastest vibration of the two particles on their bond: of stretching, omega = sqrt(k_n/m*) "
	       "with the reduced mass m*, or of shear with bending, or of torsion; with dashpots t_b is half "
	       "the stability limit of the bond. f_ID[2] = v dt/skin. v is twice the largest speed in the "
	       "group, or this speed plus that of a mesh, whichever is larger. f_ID[3] is dt divided by the "
	       "stability limit of these bonds, with all other bonds, contacts and walls at the particles "
	       "(doc/stability.md). All ratios are 0 before the first check, and f_ID[1] and f_ID[3] where "
	       "there are no bonds. A run with f_ID[3] > 1 ends with an error also without this fix.\n\n"
	       "With `legacy yes` (or the command legacy) t_b is that of LIGGGHTS Flexible Fibers, of "
	       "stretching alone: sqrt(m*/k_n), k_n = Y A/L. (Its manual, fix_check_timestep_bond.html, has "
	       "the inverse of the square root. The words were compared with this page, not with the "
	       "program.) f_ID[2] > 1 is reported as well; in tsim it has little meaning, since no contact "
	       "is missed whatever the skin.",
	.example = "fix ts all check/timestep/bond 1000 0.1\nthermo_style custom step f_ts[1] f_ts[2]",
	.cite = "Y. Guo et al., Powder Technol. 249 (2013) 386",
	.args = args,
	.state_size = sizeof(struct state),
	.saved = saved,
	.values = values,
	.init = init,
	.hook = { [TS_STAGE_END_OF_STEP] = end_of_step },
};
