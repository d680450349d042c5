#include "coupling/drag_force.h"

#include "base/banned.h"

static double coefficient(const struct ts_drag *drag, const struct ts_slip *slip)
{
	(void)drag;
	return ts_drag_schiller_naumann(slip);
}

static const struct ts_arg args[] = {
	TS_DRAG_ARGS,
	TS_ARGS_END,
};

TS_STYLE(fix, ts_drag_style, ts_fix_drag_schiller_naumann)
const struct ts_drag_style ts_fix_drag_schiller_naumann = {
	.style = {
		.name = "drag/schiller_naumann",
		.summary = "drag of the fluid on single spheres at any Reynolds number",
		.doc = "F = pi/8 d^2 Cd rho |w| w, w = u - v, with Cd = 24/Re (1 + 0.15 Re^0.687) below Re = "
		       "rho |w| d/mu = 1000\n"
		       "and 0.44 above. It is within 6 % (rms) of measurements for spheres up to Re = "
		       "1000.\n\n"
		       TS_DRAG_DOC,
		.example = "flow_style uniform velocity 0 0 1.0 viscosity 1.0e-3 density 1000\n"
			   "fix drag rock drag/schiller_naumann scheme exact",
		.cite = "L. Schiller, A. Naumann, Z. VDI 77 (1935) 318",
		.args = args,
		TS_DRAG_SLOTS,
	},
	.coefficient = coefficient,
	.inertial = true,
};
