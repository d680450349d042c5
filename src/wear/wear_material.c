#include "wear/wear_material.h"

#include <stdio.h>

#include "material/property.h"
#include "particle/particles.h"

#include "base/banned.h"

static enum ts_status find_property(const struct ts_instance *self, struct tsim *sim, const char *name,
				    int type, double *out)
{
	char who[64];

	snprintf(who, sizeof who, "fix %s", self->style->name);
	TS_TRY(ts_property_value(sim, name, type, 0, who, &self->where, out));
	return TS_OK;
}

enum ts_status ts_wear_hardness(const struct ts_instance *self, struct tsim *sim, double given, double *out)
{
	const struct ts_wear *wear = self->state;

	*out = given;
	if (isnan(given))
		TS_TRY(find_property(self, sim, "hardness", ts_surface_type(&wear->surface), out));
	if (*out > 0)
		return TS_OK;
	return ts_fail(&sim->error, TS_RANGE, &self->where,
		       "fix %s: the hardness of the surface is %g, expected a number above 0",
		       self->style->name, *out);
}

/* (1 - nu^2)/Y */
static enum ts_status find_compliance(const struct ts_instance *self, struct tsim *sim, int type, double *out)
{
	double young, poisson;

	TS_TRY(find_property(self, sim, "youngsModulus", type, &young));
	TS_TRY(find_property(self, sim, "poissonsRatio", type, &poisson));
	*out = (1 - poisson * poisson) / young;
	if (*out > 0)
		return TS_OK;
	return ts_fail(&sim->error, TS_RANGE, &self->where,
		       "fix %s: youngsModulus %g and poissonsRatio %g of type %d, expected a modulus above 0 "
		       "and a ratio below 1",
		       self->style->name, young, poisson, type);
}

enum ts_status ts_wear_moduli_find(const struct ts_instance *self, struct tsim *sim,
				   struct ts_wear_moduli *moduli)
{
	const struct ts_wear *wear = self->state;
	int types = sim->particles->ntypes;
	double surface, particle;

	ts_wear_moduli_release(moduli);
	moduli->of = ts_alloc((size_t)types + 1, sizeof *moduli->of);
	if (!moduli->of)
		return ts_nomem(&sim->error);
	for (int type = 1; type <= types; type++) {
		moduli->of[type] = moduli->given;
		if (!isnan(moduli->given))
			continue;
		TS_TRY(find_compliance(self, sim, ts_surface_type(&wear->surface), &surface));
		TS_TRY(find_compliance(self, sim, type, &particle));
		moduli->of[type] = 1 / (surface + particle);
	}
	return TS_OK;
}

void ts_wear_moduli_release(struct ts_wear_moduli *moduli)
{
	ts_free(moduli->of);
	moduli->of = NULL;
}
