#include "coupling/drag_force.h"

#include "base/banned.h"

static double coefficient(const struct ts_drag *drag, const struct ts_slip *slip)
{
	return ts_drag_carlson_hoglund(slip, drag->sound);
}

static const struct ts_arg args[] = {
	TS_DRAG_ARGS,
	TS_REAL("sound", struct ts_drag, sound, .range = TS_POSITIVE, .unit = "velocity",
		.help = "speed of sound of the gas"),
	TS_ARGS_END,
};

TS_STYLE(fix, ts_drag_style, ts_fix_drag_carlson_hoglund)
const struct ts_drag_style ts_fix_drag_carlson_hoglund = {
	.style = {
		.name = "drag/carlson_hoglund",
		.summary = "drag of a gas on single spheres, with corrections for compressibility and "
			   "rarefaction",
		.doc = "The drag of fix drag/schiller_naumann times\n\n"
		       "  (1 + exp(-0.427/M^4.63 - 3/Re^0.88))/(1 + M/Re (3.82 + 1.28 exp(-1.25 Re/M))),\n\n"
		       "Re = rho |w| d/mu, M = |w|/sound, w = u - v: the numerator is the effect of\n"
		       "compressibility, the denominator that of rarefaction; for small grains it is a slip\n"
		       "correction, 1 + 2.6 Kn for Knudsen numbers Kn = 1.48 M/Re << 1 in air. A grain of 25 "
		       "um with\n"
		       "105 m/s in air (Re = 174, M = 0.31) has 0.7 % less drag than by Schiller and "
		       "Naumann.\n\n"
		       TS_DRAG_DOC,
		.example = "flow_style uniform velocity 0 0 105 viscosity 1.8e-5 density 1.2\n"
			   "fix drag all drag/carlson_hoglund sound 343 scheme exact",
		.cite = "D. J. Carlson, R. F. Hoglund, AIAA J. 2 (1964) 1980",
		.args = args,
		TS_DRAG_SLOTS,
	},
	.coefficient = coefficient,
	.inertial = true,
};
