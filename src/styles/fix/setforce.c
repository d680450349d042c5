#include "particles/particles.h"

#include "base/banned.h"

struct setforce {
	struct ts_number f[3];
};

static enum ts_status post_force(struct ts_instance *self, struct tsim *sim)
{
	const struct setforce *s = self->state;
	struct ts_particles *p = sim->particles;

	for (int k = 0; k < 3; k++) {
		double value;

		if (s->f[k].null)
			continue;
		TS_TRY(ts_number_now(sim, &s->f[k], &self->where, &value));
		for (size_t i = 0; i < p->n; i++)
			if (ts_in_group(p, i, self->group))
				p->f[i][k] = value;
	}
	return TS_OK;
}

static const struct ts_arg args[] = {
	TS_NUMBER("fx", struct setforce, f[0], .flags = TS_POSITIONAL | TS_NULLABLE, .unit = "force",
		  .help = "x force; NULL leaves it, v_name makes it a variable"),
	TS_NUMBER("fy", struct setforce, f[1], .flags = TS_POSITIONAL | TS_NULLABLE, .unit = "force",
		  .help = "y force"),
	TS_NUMBER("fz", struct setforce, f[2], .flags = TS_POSITIONAL | TS_NULLABLE, .unit = "force",
		  .help = "z force"),
	TS_ARGS_END,
};

TS_STYLE(fix, ts_style, ts_fix_setforce)
const struct ts_style ts_fix_setforce = {
	.name = "setforce",
	.kind = TS_KIND_FIX,
	.summary = "sets components of the force on each particle of the group",
	.doc = "Replaces whatever earlier styles have added in this step. NULL leaves a component "
	       "alone.",
	.example = "fix guide tool setforce 0.0 0.0 NULL",
	.args = args,
	.state_size = sizeof(struct setforce),
	.hook = { [TS_STAGE_POST_FORCE] = post_force },
};
