/* Fixes particledistribution/discrete and .../numberbased: a mixture of particle templates by mass, or by
 * number. */
#include "insert/distribution.h"

#include "base/banned.h"

static enum ts_status init_by_mass(struct ts_instance *self, struct tsim *sim)
{
	return ts_distribution_init(self, sim, true);
}

static enum ts_status init_by_number(struct ts_instance *self, struct tsim *sim)
{
	return ts_distribution_init(self, sim, false);
}

#define DOC(share)                                                                                         \
	"Names n fixes particletemplate/... and the share of each in the " share                           \
	" of what is inserted. If the shares\n"                                                            \
	"do not add up to 1 a warning is given and they are divided by their sum. Of N particles each "    \
	"template gets\n"                                                                                  \
	"the whole part of its number; what is left goes to templates drawn in proportion to their "       \
	"remainders, as\n"                                                                                 \
	"in LIGGGHTS. Larger ones are placed before smaller ones. The group of the fix is one more group " \
	"that\n"                                                                                           \
	"inserted particles become members of."

TS_STYLE(fix, ts_style, ts_fix_particledistribution_discrete)
const struct ts_style ts_fix_particledistribution_discrete = {
	.name = "particledistribution/discrete",
	.kind = TS_KIND_FIX,
	.summary = "A mixture of particle templates by mass, for fixes that insert",
	.doc = DOC("mass"),
	.example = "fix mix all particledistribution/discrete 32452843 2 small 0.3 large 0.7",
	.args = ts_distribution_args,
	.state_size = sizeof(struct ts_distribution),
	.archive = ts_distribution_archive,
	.init = init_by_mass,
};

TS_STYLE(fix, ts_style, ts_fix_particledistribution_discrete_numberbased)
const struct ts_style ts_fix_particledistribution_discrete_numberbased = {
	.name = "particledistribution/discrete/numberbased",
	.kind = TS_KIND_FIX,
	.summary = "A mixture of particle templates by number, for fixes that insert",
	.doc = DOC("number"),
	.example = "fix mix all particledistribution/discrete/numberbased 32452843 2 small 0.3 large 0.7",
	.args = ts_distribution_args,
	.state_size = sizeof(struct ts_distribution),
	.archive = ts_distribution_archive,
	.init = init_by_number,
};
