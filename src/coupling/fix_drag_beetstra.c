#include "coupling/drag_force.h"

#include "base/banned.h"

static double coefficient(const struct ts_drag *drag, const struct ts_slip *slip)
{
	(void)drag;
	return ts_drag_beetstra(slip);
}

static const struct ts_arg args[] = {
	TS_DRAG_CROWD_ARGS,
	TS_ARGS_END,
};

TS_STYLE(fix, ts_drag_style, ts_fix_drag_beetstra)
const struct ts_drag_style ts_fix_drag_beetstra = {
	.style = {
		.name = "drag/beetstra",
		.summary = "drag among spheres by Beetstra, van der Hoef and Kuipers",
		.doc = "F = 3 pi mu d e w (10 s/e^2 + e^2 (1 + 1.5 sqrt s) + 0.413 Re/(24 e^2) (1/e + 3 e s + "
		       "8.4 Re^-0.343)/\n"
		       "(1 + 10^(3 s) Re^(-(1 + 4 s)/2))), w = u - v, s = 1 - e, Re = rho e |w| d/mu.\n\n"
		       TS_DRAG_CROWD_DOC TS_DRAG_DOC,
		.example = "flow_style uniform velocity 0 0 1.0 viscosity 1.0e-3 density 1000\n"
			   "fix drag all drag/beetstra void 0.63",
		.cite = "R. Beetstra, M. A. van der Hoef, J. A. M. Kuipers, AIChE J. 53 (2007) 489",
		.args = args,
		TS_DRAG_SLOTS,
	},
	.coefficient = coefficient,
	.crowded = true,
	.inertial = true,
};
