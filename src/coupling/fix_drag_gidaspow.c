#include "coupling/drag_force.h"

#include "base/banned.h"

static double coefficient(const struct ts_drag *drag, const struct ts_slip *slip)
{
	(void)drag;
	return ts_drag_gidaspow(slip);
}

static const struct ts_arg args[] = {
	TS_DRAG_CROWD_ARGS,
	TS_ARGS_END,
};

TS_STYLE(fix, ts_drag_style, ts_fix_drag_gidaspow)
const struct ts_drag_style ts_fix_drag_gidaspow = {
	.style = {
		.name = "drag/gidaspow",
		.summary = "drag by Ergun in beds, by Wen and Yu in suspensions",
		.doc = "Above a void fraction of 0.8 the drag of fix drag/wen_yu, otherwise that of fix "
		       "drag/ergun. The force is discontinuous at 0.8.\n\n"
		       TS_DRAG_CROWD_DOC TS_DRAG_DOC,
		.example = "flow_style uniform velocity 0 0 1.0 viscosity 1.0e-3 density 1000\n"
			   "fix drag all drag/gidaspow void 0.63",
		.cite = "D. Gidaspow, Multiphase Flow and Fluidization, Academic Press 1994",
		.args = args,
		TS_DRAG_SLOTS,
	},
	.coefficient = coefficient,
	.crowded = true,
	.inertial = true,
};
