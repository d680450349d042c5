/* Fixes particledistribution/discrete and .../numberbased: mixtures of particle templates by mass or
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

#define DOC(quantity)                                                                                \
	"Defines a mixture of n fixes particletemplate/... by their fractions of the " quantity "\n" \
	"of inserted particles. If the weights do not add up to 1, a warning is given and\n"         \
	"they are divided by their sum.\n\n"                                                         \
	"Of N particles each template contributes its number rounded down; the rest is\n"            \
	"assigned to templates drawn in proportion to their remainders, as in LIGGGHTS.\n"           \
	"Larger particles are placed before smaller ones. Inserted particles also become\n"          \
	"members of the group of this fix."

TS_STYLE(fix, ts_style, ts_fix_particledistribution_discrete)
const struct ts_style ts_fix_particledistribution_discrete = {
	.name = "particledistribution/discrete",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_ROWLESS,
	.summary = "Mixture of particle templates by mass, for insertion",
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
	.ranks = TS_RANKS_WHOLE | TS_RANKS_ROWLESS,
	.summary = "Mixture of particle templates by number, for insertion",
	.doc = DOC("number"),
	.example = "fix mix all particledistribution/discrete/numberbased 32452843 2 small 0.3 large 0.7",
	.args = ts_distribution_args,
	.state_size = sizeof(struct ts_distribution),
	.archive = ts_distribution_archive,
	.init = init_by_number,
};
