/* Fix wear/neilson/gilchrist: erosion by cutting and deformation after Neilson and Gilchrist. */
#include "law/erosion_neilson.h"
#include "wear/wear_material.h"

#include "base/banned.h"

struct state {
	struct ts_wear wear;
	double cutting, deformation, threshold, transition, factor;

	struct ts_erosion_neilson law;
};

static double remove_by_impact(const struct ts_instance *self, const struct ts_impact_event *e)
{
	const struct state *s = self->state;
	struct ts_erosion_impact i = ts_wear_erosion_impact(e);

	return s->factor * ts_erosion_neilson_volume(&s->law, &i);
}

static const struct ts_wear_law law = { .impact = remove_by_impact };

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	s->law = (struct ts_erosion_neilson){ s->cutting, s->deformation, s->threshold,
					      s->transition * TS_PI / 180 };
	if (s->transition > 0)
		return ts_wear_init(self, sim, &law);
	return ts_fail(&sim->error, TS_RANGE, ts_instance_word(self, "transition"),
		       "fix wear/neilson/gilchrist: the transition angle is 0, expected an angle above 0 and "
		       "up to 90 degrees");
}

static const struct ts_arg args[] = {
	TS_WEAR_ARGS(struct state, wear),
	TS_REAL("cutting", struct state, cutting, .range = TS_POSITIVE, .unit = "pressure",
		.help = "phi: energy that removes a unit of volume by cutting"),
	TS_REAL("deformation", struct state, deformation, .range = TS_POSITIVE, .unit = "pressure",
		.help = "epsilon: energy that removes a unit of volume by deformation"),
	TS_REAL("transition", struct state, transition, .range = TS_WITHIN, .lo = 0, .hi = 90,
		.unit = "degrees",
		.help = "impact angle alpha0 from which on the particle leaves without velocity along the "
			"surface"),
	TS_REAL("threshold", struct state, threshold, .fallback = "0", .range = TS_NOT_NEGATIVE,
		.unit = "velocity", .help = "K: normal speed below which the contact is elastic"),
	TS_WEAR_FACTOR_ARG(struct state, factor),
	TS_ARGS_END,
};

TS_STYLE(fix, ts_style, ts_fix_wear_neilson_gilchrist)
const struct ts_style ts_fix_wear_neilson_gilchrist = {
	.name = "wear/neilson/gilchrist",
	.kind = TS_KIND_FIX,
	.summary = "erosion of a surface by cutting and deformation (Neilson, Gilchrist)",
	.doc = "An impact of a particle with the mass m and the speed V at the angle alpha removes the "
	       "volume\n\n"
	       "    m V^2 cos^2(alpha) sin(90 alpha/alpha0)/(2 phi) + m (V sin(alpha) - K)^2/(2 epsilon)\n\n"
	       "The sine, of 90 alpha/alpha0 degrees, is 1 above alpha0; the second part is 0 if V "
	       "sin(alpha) is below K. phi, epsilon, K and alpha0 are fitted to measured volumes of one pair "
	       "of materials." TS_WEAR_DOC "Related: fix wear/bitter, fix wear/oka, fix wear/finnie.",
	.example = "fix target all wall/gran model hertz primitive type 2 zplane 0\n"
		   "fix scar all wear/neilson/gilchrist surface target cutting 1.3e10 deformation 3.1e10 "
		   "transition 24",
	.cite = "J. H. Neilson, A. Gilchrist, Wear 11 (1968) 111",
	.args = args,
	.state_size = sizeof(struct state),
	TS_WEAR_SLOTS,
	.observes = TS_OBSERVES_IMPACTS,
	.init = init,
	.late = { [TS_LATE_CONTACTS] = ts_wear_step },
	.fini = ts_wear_fini,
};
