#include "coupling/drag_force.h"

#include "base/banned.h"

static double coefficient(const struct ts_drag *drag, const struct ts_slip *slip)
{
	return ts_drag_ergun(slip, drag->c1, drag->c2);
}

static const struct ts_arg args[] = {
	TS_REAL("C1", struct ts_drag, c1, .fallback = "150", .range = TS_NOT_NEGATIVE, .unit = "",
		.help = "coefficient of the viscous term"),
	TS_REAL("C2", struct ts_drag, c2, .fallback = "1.75", .range = TS_NOT_NEGATIVE, .unit = "",
		.help = "coefficient of the inertial term; 0: no such term"),
	TS_DRAG_CROWD_ARGS,
	TS_ARGS_END,
};

TS_STYLE(fix, ts_drag_style, ts_fix_drag_ergun)
const struct ts_drag_style ts_fix_drag_ergun = {
	.style = {
		.name = "drag/ergun",
		.summary = "drag in dense beds by Ergun's equation",
		.doc = "F = V_p (C1 (1-e) mu/(e d^2) + C2 rho |w|/d) w, with w = u - v the slip velocity\n"
			"between the particles, e the void fraction, V_p and d the volume and diameter of\n"
			"the particle. The resistance of the bed per volume is f = C1 (1-e)^2 mu w/(e d^2)\n"
			"+ C2 (1-e) rho |w| w/d, and its pressure gradient f/e. With the superficial\n"
			"velocity U = e w this is Ergun's equation, C1 mu (1-e)^2 U/(e^3 d^2) + C2 rho\n"
			"(1-e) U^2/(e^3 d). C1 = 180 and C2 = 0 give the Kozeny-Carman equation.\n\n"
			TS_DRAG_CROWD_DOC TS_DRAG_DOC,
		.example = "flow_style uniform velocity 0 0 1.0 viscosity 1.0e-3 density 1000\n"
			   "fix drag bed drag/ergun void 0.4 C1 180 C2 0",
		.cite = "S. Ergun, Chem. Eng. Prog. 48 (1952) 89",
		.args = args,
		TS_DRAG_SLOTS,
	},
	.coefficient = coefficient,
	.crowded = true,
	.inertial = true,
};
