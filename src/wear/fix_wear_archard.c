/* Fix wear/archard: volume that sliding particles remove; the law is in law/archard.h. */
#include "law/archard.h"
#include "wear/wear.h"

#include "base/banned.h"

struct state {
	struct ts_wear wear;
	double k, hardness;
};

static double slide_volume(const struct ts_instance *self, const struct ts_wear_slide *slide)
{
	const struct state *s = self->state;

	return ts_archard_volume(s->k, s->hardness, slide->normal_force, slide->slip);
}

static const struct ts_wear_law law = { .slide = slide_volume };

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	return ts_wear_init(self, sim, &law);
}

static const struct ts_arg args[] = {
	TS_WEAR_ARGS(struct state, wear),
	TS_REAL("k", struct state, k, .range = TS_NOT_NEGATIVE, .help = "wear coefficient"),
	TS_REAL("hardness", struct state, hardness, .range = TS_POSITIVE, .unit = "pressure",
		.help = "hardness H of the surface"),
	TS_ARGS_END,
};

TS_STYLE(fix, ts_style, ts_fix_wear_archard)
const struct ts_style ts_fix_wear_archard = {
	.name = "wear/archard",
	.kind = TS_KIND_FIX,
	.summary = "Volume that sliding particles remove from a surface (Archard)",
	.doc = "In each step each contact with the surface removes the volume\n\n"
	       "  V = k F s/H\n\n"
	       "F being the normal force, s the path of the contact point of the particle along the surface "
	       "in this step, with the rotation of the particle: one that rolls without sliding removes "
	       "nothing. The volume belongs to the element in contact. A pulling force (adhesion) removes "
	       "nothing. The work of friction is summed step by step, too; the other columns count "
	       "impacts. " TS_WEAR_EXACT TS_WEAR_DOC
	       "Related: fix wear/finnie, fix mesh/surface, fix wall/gran.",
	.cite = "J. F. Archard, J. Appl. Phys. 24 (1953) 981",
	.example = "fix worn all wear/archard surface chute k 1e-4 hardness 1.2e9\n"
		   "fix floor all wall/gran model hertz tangential history primitive type 1 zplane 0.0\n"
		   "fix rubbed all wear/archard surface floor k 1e-4 hardness 1.2e9 density 7850",
	.args = args,
	.state_size = sizeof(struct state),
	TS_WEAR_SLOTS,
	.observes = TS_OBSERVES_CONTACTS | TS_OBSERVES_BRIEF | TS_OBSERVES_IMPACTS,
	.init = init,
	.late = { [TS_LATE_CONTACTS] = ts_wear_step },
	.fini = ts_wear_fini,
};
