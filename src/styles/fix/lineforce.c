/* Fix lineforce: Lets particles feel only the force along a line. */
#include "math/vec3.h"
#include "particles/particles.h"

#include "base/banned.h"

struct state {
	double direction[3];
	double unit[3];
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	double length = ts_norm(s->direction);

	if (!(length > 0))
		return ts_fail(&sim->error, TS_RANGE, &self->where,
			       "fix lineforce: the direction has no length");
	for (int k = 0; k < 3; k++)
		s->unit[k] = s->direction[k] / length;
	return TS_OK;
}

static enum ts_status post_force(struct ts_instance *self, struct tsim *sim)
{
	const struct state *s = self->state;
	struct ts_particles *p = sim->particles;

#pragma omp parallel for num_threads(ts_team(sim, p->n)) schedule(static)
	for (size_t i = 0; i < p->n; i++) {
		double along = ts_dot(p->f[i], s->unit);

		if (!ts_in_group(p, i, self->group))
			continue;
		for (int k = 0; k < 3; k++)
			p->f[i][k] = along * s->unit[k];
	}
	return TS_OK;
}

static const struct ts_arg args[] = {
	TS_VEC3("direction", struct state, direction, .flags = TS_POSITIONAL,
		.help = "direction of the line; any length"),
	TS_ARGS_END,
};

TS_STYLE(fix, ts_style, ts_fix_lineforce)
const struct ts_style ts_fix_lineforce = {
	.name = "lineforce",
	.kind = TS_KIND_FIX,
	.summary = "Lets particles feel only the force along a line",
	.doc = "f = (f . e) e with the unit vector e: particles that start at rest move along lines.",
	.example = "fix rail all lineforce 0 1 1",
	.args = args,
	.state_size = sizeof(struct state),
	.init = init,
	.hook[TS_STAGE_POST_FORCE] = post_force,
};
