/* Fix particledistribution/discrete/massbased: a mixture of particle templates by mass. */
#include "particles/distribution.h"

#include "base/banned.h"

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	return ts_distribution_init(self, sim, true);
}

TS_STYLE(fix, ts_style, ts_fix_particledistribution_discrete_massbased)
const struct ts_style ts_fix_particledistribution_discrete_massbased = {
	.name = "particledistribution/discrete/massbased",
	.kind = TS_KIND_FIX,
	.summary = "A mixture of particle templates by mass, for fixes that insert",
	.doc = "Another name of fix particledistribution/discrete: shares are those of mass.",
	.example = "fix mix all particledistribution/discrete/massbased 32452843 2 small 0.3 large 0.7",
	.args = ts_distribution_args,
	.state_size = sizeof(struct ts_distribution),
	.archive = ts_distribution_archive,
	.init = init,
};
