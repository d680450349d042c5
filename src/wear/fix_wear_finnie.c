/* Fix wear/finnie: volume that impacts remove by cutting; the law is in law/erosion_finnie.h. */
#include "law/erosion_finnie.h"
#include "wear/wear.h"

#include "base/banned.h"

struct state {
	struct ts_wear wear;
	struct ts_erosion_finnie law;
};

static double impact_volume(const struct ts_instance *self, const struct ts_impact_event *e)
{
	const struct state *s = self->state;
	struct ts_erosion_impact impact = { .mass = e->mass,
					    .diameter = 2 * e->radius,
					    .normal = ts_impact_normal_speed(e),
					    .tangential = ts_impact_tangential_speed(e) };

	return ts_erosion_finnie_volume(&s->law, &impact);
}

static const struct ts_wear_law law = { .impact = impact_volume };

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	return ts_wear_init(self, sim, &law);
}

static const struct ts_arg args[] = {
	TS_WEAR_ARGS(struct state, wear),
	TS_REAL("flow_stress", struct state, law.flow_stress, .range = TS_POSITIVE, .unit = "pressure",
		.help = "plastic flow stress p of the surface, about its hardness"),
	TS_REAL("depth_ratio", struct state, law.length_ratio, .fallback = "2", .range = TS_POSITIVE,
		.help = "psi, length of the cut over its depth"),
	TS_REAL("force_ratio", struct state, law.force_ratio, .fallback = "2", .range = TS_POSITIVE,
		.help = "K, normal over tangential force on the particle"),
	TS_REAL("fraction", struct state, law.fraction, .fallback = "1", .range = TS_FRACTION,
		.help = "c, fraction of the particles that cut"),
	TS_ARGS_END,
};

TS_STYLE(fix, ts_style, ts_fix_wear_finnie)
const struct ts_style ts_fix_wear_finnie = {
	.name = "wear/finnie",
	.kind = TS_KIND_FIX,
	.summary = "Volume that impacts remove from a surface of ductile material by cutting (Finnie)",
	.doc = "Each impact of a particle of mass m at the speed V and the angle a to the surface removes "
	       "the volume\n\n"
	       "  Q = c m V^2/(p psi K) f(a)\n"
	       "  f = sin 2a - (6/K) sin^2 a for tan a <= K/6, else (K/6) cos^2 a\n\n"
	       "by cutting: the particle leaves the surface while it cuts at small angles, and comes to rest "
	       "in its groove at larger ones. With K = 2 the largest volume is at 16.8 degrees; at 90 "
	       "degrees there is none, where ductile metals in fact lose 0.3 to 0.5 of the largest volume. "
	       "Only entry speed and angle count, not the contact law. fix mesh/surface/stress with `wear "
	       "finnie` sums another form of the law, over the steps of a contact, as LIGGGHTS "
	       "does." TS_WEAR_DOC
	       "Related: fix wear/archard, fix mesh/surface/stress, fix mesh/surface, fix wall/gran.",
	.cite = "I. Finnie, Wear 3 (1960) 87",
	.example = "fix worn all wear/finnie surface chute flow_stress 1.2e9\n"
		   "fix floor all wall/gran model hertz tangential history primitive type 1 zplane 0.0\n"
		   "fix scar all wear/finnie surface floor flow_stress 1.2e9 fraction 0.1 density 7850\n"
		   "dump map all mesh/vtk 1000 worn*.vtk f_worn[8] f_worn[9] chute",
	.args = args,
	.state_size = sizeof(struct state),
	TS_WEAR_SLOTS,
	.observes = TS_OBSERVES_IMPACTS,
	.init = init,
	.late = { [TS_LATE_CONTACTS] = ts_wear_step },
	.fini = ts_wear_fini,
};
