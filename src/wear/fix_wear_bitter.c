/* Fix wear/bitter: erosion by deformation and cutting after Bitter. */
#include "law/erosion_bitter.h"
#include "wear/wear_material.h"

#include "base/banned.h"

struct state {
	struct ts_wear wear;
	struct ts_erosion_bitter law; /* NaN: by `yield` */
	double yield, factor;
	struct ts_wear_moduli moduli;
};

/* Density of a sphere of this mass. */
static double density(const struct ts_impact_event *e)
{
	return e->mass / (4.0 / 3.0 * TS_PI * e->radius * e->radius * e->radius);
}

static double remove_by_impact(const struct ts_instance *self, const struct ts_impact_event *e)
{
	const struct state *s = self->state;
	struct ts_erosion_impact i = ts_wear_erosion_impact(e);
	struct ts_erosion_bitter one = s->law;

	if (isnan(one.cutting_constant))
		one.cutting_constant = ts_erosion_bitter_cutting(s->yield, density(e));
	if (isnan(one.threshold))
		one.threshold = ts_erosion_yield_speed(s->yield, density(e), s->moduli.of[(int)e->type]);
	if (isnan(one.elastic_constant))
		one.elastic_constant =
			ts_erosion_bitter_elastic(s->yield, density(e), s->moduli.of[(int)e->type]);
	return s->factor * ts_erosion_bitter_volume(&one, &i);
}

static const struct ts_wear_law law = { .impact = remove_by_impact };

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	TS_TRY(ts_wear_init(self, sim, &law));
	if (!isnan(s->yield)) {
		if (isnan(s->law.threshold) || isnan(s->law.elastic_constant))
			TS_TRY(ts_wear_moduli_find(self, sim, &s->moduli));
		return TS_OK;
	}
	if (isnan(s->law.cutting_constant))
		return ts_fail(&sim->error, TS_SYNTAX, &self->where,
			       "fix wear/bitter: the cutting constant is missing: cutting_constant C, or "
			       "yield Y from which it follows");
	if (isnan(s->law.threshold))
		s->law.threshold = 0;
	if (isnan(s->law.elastic_constant))
		s->law.elastic_constant = 0;
	return TS_OK;
}

static void fini(struct ts_instance *self)
{
	ts_wear_moduli_release(&((struct state *)self->state)->moduli);
	ts_wear_fini(self);
}

static const struct ts_arg args[] = {
	TS_WEAR_ARGS(struct state, wear),
	TS_REAL("deformation", struct state, law.deformation, .range = TS_POSITIVE, .unit = "pressure",
		.help = "epsilon: energy that removes a unit of volume by deformation"),
	TS_REAL("cutting", struct state, law.cutting, .range = TS_POSITIVE, .unit = "pressure",
		.help = "phi: energy that removes a unit of volume by cutting"),
	TS_REAL("yield", struct state, yield, .flags = TS_OPTIONAL, .range = TS_POSITIVE, .unit = "pressure",
		.help = "elastic load limit y of the surface: 1.6 times the yield stress of a metal"),
	TS_WEAR_MODULUS_ARG(struct state, moduli.given),
	TS_REAL("threshold", struct state, law.threshold, .flags = TS_OPTIONAL, .range = TS_NOT_NEGATIVE,
		.unit = "velocity",
		.help = "K: normal speed below which the contact is elastic; default: by yield, or 0"),
	TS_REAL("cutting_constant", struct state, law.cutting_constant, .flags = TS_OPTIONAL,
		.range = TS_NOT_NEGATIVE, .unit = "velocity^(-1/2)/pressure", .help = "C; default: by yield"),
	TS_REAL("elastic_constant", struct state, law.elastic_constant, .flags = TS_OPTIONAL,
		.range = TS_NOT_NEGATIVE, .unit = "velocity^(1/2)", .help = "K1; default: by yield, or 0"),
	TS_WEAR_FACTOR_ARG(struct state, factor),
	TS_ARGS_END,
};

TS_STYLE(fix, ts_style, ts_fix_wear_bitter)
const struct ts_style ts_fix_wear_bitter = {
	.name = "wear/bitter",
	.kind = TS_KIND_FIX,
	.summary = "erosion of a surface by deformation and cutting (Bitter)",
	.doc = "An impact of a particle with the mass m, the normal speed n and the tangential speed t "
	       "removes the volume, for n > K,\n\n"
	       "    m (n - K)^2/(2 epsilon) + 2 m X (t - X phi),         X = C (n - K)^2/sqrt(n), or\n"
	       "    m (n - K)^2/(2 epsilon) + m (t^2 - K1 (n - K)^(3/2))/(2 phi)\n\n"
	       "The first holds for t > 2 X phi + sqrt(K1 (n - K)^(3/2)): the particle leaves with velocity "
	       "along the surface. At that t both are equal. The second term is 0 where it would be "
	       "negative. epsilon and phi are fitted to measured volumes. "
	       "K, C and K1 may be given, or follow from the elastic load limit y (`yield`), the density rho "
	       "of the particle and the effective modulus E*:\n\n"
	       "    K = pi^2/(2 sqrt(10)) y^(5/2)/(sqrt(rho) E*^2)\n"
	       "    C = 0.288/y (rho/y)^(1/4)\n"
	       "    K1 = 0.82 y^2 (y/rho)^(1/4)/E*^2\n\n"
	       "K is the speed at which the largest pressure of an elastic impact reaches y." TS_WEAR_DOC
	       "Related: fix wear/neilson/gilchrist, fix wear/oka, fix wear/finnie.",
	.example = "fix target all wall/gran model hertz primitive type 2 zplane 0\n"
		   "fix scar all wear/bitter surface target deformation 3.1e10 cutting 1.3e10 yield 4e8 "
		   "modulus 5.3e10",
	.cite = "J. G. A. Bitter, Wear 6 (1963) 5 and 169",
	.args = args,
	.state_size = sizeof(struct state),
	TS_WEAR_SLOTS,
	.observes = TS_OBSERVES_IMPACTS,
	.init = init,
	.late = { [TS_LATE_CONTACTS] = ts_wear_step },
	.fini = fini,
};
