#include "bond/bond_arguments.h"

#include <math.h>

#include "base/banned.h"

const char *const ts_bond_scatter_names[] = {
	[TS_BOND_SAME] = "none", [TS_BOND_GAUSS] = "normal", [TS_BOND_WEIBULL] = "weibull", NULL
};

enum ts_status ts_bond_strength_complete(struct tsim *sim, const struct ts_bond_strength *s,
					 const struct ts_place *where)
{
	const char *const name = ts_bond_scatter_names[s->scatter];

	if (isnan(s->deviation) == (s->scatter == TS_BOND_GAUSS))
		return ts_fail(&sim->error, TS_SYNTAX, where, "bond_coeff: scatter %s: %s", name,
			       isnan(s->deviation)
				       ? "expected `deviation`, the standard deviation divided by the mean"
				       : "`deviation` belongs to scatter normal");
	if (isnan(s->shape) == (s->scatter == TS_BOND_WEIBULL))
		return ts_fail(&sim->error, TS_SYNTAX, where, "bond_coeff: scatter %s: %s", name,
			       isnan(s->shape) ? "expected `shape`, the modulus of the distribution"
					       : "`shape` belongs to scatter weibull");
	if (s->scatter != TS_BOND_SAME && isnan(s->tension) && isnan(s->shear))
		return ts_fail(&sim->error, TS_SYNTAX, where,
			       "bond_coeff: scatter %s: expected sigma_c or tau_c, to which it applies",
			       name);
	return TS_OK;
}

void ts_bond_damping_complete(struct ts_bond_damping *d)
{
	for (int m = 0; m < TS_BOND_MODES; m++)
		d->ratio[m] = isnan(d->of[m]) ? d->all : d->of[m];
}

bool ts_bond_any_damping(const struct ts_bond_damping *d)
{
	for (int m = 0; m < TS_BOND_MODES; m++)
		if (d->ratio[m] > 0)
			return true;
	return false;
}
