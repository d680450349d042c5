/* Fix damping/cundall: local damping of P. A. Cundall. */
#include "base/clones.h"
#include "core/deferred_loops.h"
#include "core/sim.h"
#include "group/group_members.h"
#include "particle/particles.h"
#include "particle/type_factors.h"

#include "base/banned.h"

struct state {
	double linear, angular;
	struct ts_words scale;
	double *factor; /* by atom type */
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	if (s->factor)
		return TS_OK;
	return ts_type_factors(sim, "fix damping/cundall", &self->arena, s->scale, &s->factor);
}

/* f - gamma |f| sgn(v), for each component */
static inline void damp(double gamma, const double v[restrict 3], double f[restrict 3])
{
	for (int k = 0; k < 3; k++) {
		double size = gamma * fabs(f[k]);

		f[k] -= v[k] > 0 ? size : v[k] < 0 ? -size : 0;
	}
}

struct task {
	const struct ts_particles *p;
	const struct state *s;
	int group;
};

TS_CLONES static void damp_range(void *context, size_t from, size_t to)
{
	const struct task t = *(const struct task *)context;
	const struct ts_particles *p = t.p;

	for (size_t i = from; i < to; i++) {
		double factor = t.s->factor[p->type[i]];

		if (!ts_in_group(p, i, t.group))
			continue;
		damp(t.s->linear * factor, p->v[i], p->f[i]);
		if (p->omega && p->torque)
			damp(t.s->angular * factor, p->omega[i], p->torque[i]);
	}
}

static enum ts_status add_damping(struct ts_instance *self, struct tsim *sim)
{
	struct task task = { sim->particles, self->state, self->group };

	TS_DEFER_LOOP(sim, sim->particles->n, damp_range, &task);
	return TS_OK;
}

static const struct ts_arg args[] = {
	TS_REAL("gamma_l", struct state, linear, .flags = TS_POSITIONAL, .range = TS_FRACTION, .unit = "",
		.help = "damping of translation, a fraction of the force"),
	TS_REAL("gamma_a", struct state, angular, .flags = TS_POSITIONAL, .range = TS_FRACTION, .unit = "",
		.help = "damping of rotation, a fraction of the torque"),
	TS_TYPE_FACTORS(struct state, scale, "both constants"),
	TS_ARGS_END,
};

TS_STYLE(fix, ts_style, ts_fix_damping_cundall)
const struct ts_style ts_fix_damping_cundall = {
	.name = "damping/cundall",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_OWN,
	.summary = "local damping: opposes the motion in proportion to the force",
	.doc = "Adds to each component of the force -gamma_l |F| sgn(v), with the force F on the particle "
	       "that the pair and bond styles and the fixes defined before have exerted, and to each "
	       "component of the torque -gamma_a |T| sgn(omega). The damping of a vibration does not depend "
	       "on its frequency: the amplitude of a spring changes by the factor sqrt((1 - gamma)/(1 + "
	       "gamma)) in half a period, as its force is smaller on the way back and larger on the way out. "
	       "In equilibrium it exerts no force, so it is used to find static states. It also damps the "
	       "acceleration by gravity: do not use it for free flight.",
	.example = "fix calm all damping/cundall 0.7 0.7",
	.cite = "P. A. Cundall, in: Analytical and Computational Methods in Engineering Rock Mechanics, ed. "
		"E. T. Brown (Allen & Unwin, 1987), ch. 4",
	.args = args,
	.state_size = sizeof(struct state),
	.init = init,
	.hook = { [TS_STAGE_POST_FORCE] = add_damping },
	.defers = TS_DEFERS(POST_FORCE),
};
