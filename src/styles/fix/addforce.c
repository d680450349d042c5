#include "particles/particles.h"

#include "base/banned.h"

struct addforce {
	struct ts_number f[3];
};

static enum ts_status post_force(struct ts_instance *self, struct tsim *sim)
{
	const struct addforce *s = self->state;
	struct ts_particles *p = sim->particles;

	for (int k = 0; k < 3; k++) {
		double value;

		TS_TRY(ts_number_now(sim, &s->f[k], &self->where, &value));
		for (size_t i = 0; i < p->n; i++)
			if (ts_in_group(p, i, self->group))
				p->f[i][k] += value;
	}
	return TS_OK;
}

static const struct ts_arg args[] = {
	TS_NUMBER("fx", struct addforce, f[0], .flags = TS_POSITIONAL, .unit = "force",
		  .help = "x force on each particle; may be v_name"),
	TS_NUMBER("fy", struct addforce, f[1], .flags = TS_POSITIONAL, .unit = "force",
		  .help = "y force"),
	TS_NUMBER("fz", struct addforce, f[2], .flags = TS_POSITIONAL, .unit = "force",
		  .help = "z force"),
	TS_ARGS_END,
};

TS_STYLE(fix, ts_style, ts_fix_addforce)
const struct ts_style ts_fix_addforce = {
	.name = "addforce",
	.kind = TS_KIND_FIX,
	.summary = "adds a force to each particle of the group",
	.doc = "f += (fx, fy, fz) for every particle of the group.",
	.example = "fix push tool addforce 0.0 0.0 -2.5",
	.args = args,
	.state_size = sizeof(struct addforce),
	.hook = { [TS_STAGE_POST_FORCE] = post_force },
};
