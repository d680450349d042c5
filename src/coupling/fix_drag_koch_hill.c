#include "coupling/drag_force.h"

#include "base/banned.h"

static double coefficient(const struct ts_drag *drag, const struct ts_slip *slip)
{
	(void)drag;
	return ts_drag_koch_hill(slip);
}

static const struct ts_arg args[] = {
	TS_DRAG_CROWD_ARGS,
	TS_ARGS_END,
};

TS_STYLE(fix, ts_drag_style, ts_fix_drag_koch_hill)
const struct ts_drag_style ts_fix_drag_koch_hill = {
	.style = {
		.name = "drag/koch_hill",
		.summary = "drag among spheres by Hill, Koch and Ladd",
		.doc = "F = 3 pi mu d e^2 (F0 + F3 Re/2) w, w = u - v, Re = rho e |w| d/mu, from simulations "
		       "of random arrays; with s = 1-e, F0 = (1 + 3 sqrt(s/2) + 135/64 s ln s + 16.14 s)/(1 + "
		       "0.681 s - 8.48 s^2 + 8.16 s^3) below\n"
		       "s = 0.4, else 10 s/e^3; F3 = 0.0673 + 0.212 s + 0.0232/e^5.\n\n"
		       TS_DRAG_CROWD_DOC TS_DRAG_DOC,
		.example = "flow_style uniform velocity 0 0 1.0 viscosity 1.0e-3 density 1000\n"
			   "fix drag all drag/koch_hill void 0.63",
		.cite = "R. J. Hill, D. L. Koch, A. J. C. Ladd, J. Fluid Mech. 448 (2001) 243",
		.args = args,
		TS_DRAG_SLOTS,
	},
	.coefficient = coefficient,
	.crowded = true,
	.inertial = true,
};
