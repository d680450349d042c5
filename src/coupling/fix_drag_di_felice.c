#include "coupling/drag_force.h"

#include "base/banned.h"

static double coefficient(const struct ts_drag *drag, const struct ts_slip *slip)
{
	(void)drag;
	return ts_drag_di_felice(slip);
}

static const struct ts_arg args[] = {
	TS_DRAG_CROWD_ARGS,
	TS_ARGS_END,
};

TS_STYLE(fix, ts_drag_style, ts_fix_drag_di_felice)
const struct ts_drag_style ts_fix_drag_di_felice = {
	.style = {
		.name = "drag/di_felice",
		.summary = "drag among spheres by Di Felice",
		.doc = "F = pi/8 d^2 Cd rho e^(2-X) |w| w, w = u - v, Cd = (0.63 + 4.8/sqrt(Re))^2, Re = rho "
		       "e |w| d/mu,\n"
		       "X = 3.7 - 0.65 exp(-(1.5 - log10 Re)^2/2).\n\n"
		       TS_DRAG_CROWD_DOC TS_DRAG_DOC,
		.example = "flow_style uniform velocity 0 0 1.0 viscosity 1.0e-3 density 1000\n"
			   "fix drag all drag/di_felice void 0.63",
		.cite = "R. Di Felice, Int. J. Multiphase Flow 20 (1994) 153",
		.args = args,
		TS_DRAG_SLOTS,
	},
	.coefficient = coefficient,
	.crowded = true,
	.inertial = true,
};
