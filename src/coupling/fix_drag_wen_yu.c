#include "coupling/drag_force.h"

#include "base/banned.h"

static double coefficient(const struct ts_drag *drag, const struct ts_slip *slip)
{
	(void)drag;
	return ts_drag_wen_yu(slip);
}

static const struct ts_arg args[] = {
	TS_DRAG_CROWD_ARGS,
	TS_ARGS_END,
};

TS_STYLE(fix, ts_drag_style, ts_fix_drag_wen_yu)
const struct ts_drag_style ts_fix_drag_wen_yu = {
	.style = {
		.name = "drag/wen_yu",
		.summary = "drag in suspensions by Wen and Yu",
		.doc = "F = 3/4 V_p Cd e rho |w|/d e^-2.65 w, with w = u - v the slip velocity between the "
		       "particles and Cd the drag coefficient of Schiller and Naumann at Re = rho e |w| "
		       "d/mu.\n\n"
		       TS_DRAG_CROWD_DOC TS_DRAG_DOC,
		.example = "flow_style uniform velocity 0 0 1.0 viscosity 1.0e-3 density 1000\n"
			   "fix drag all drag/wen_yu void 0.83",
		.cite = "C. Y. Wen, Y. H. Yu, Chem. Eng. Prog. Symp. Ser. 62 (1966) 100",
		.args = args,
		TS_DRAG_SLOTS,
	},
	.coefficient = coefficient,
	.crowded = true,
	.inertial = true,
};
