#include "coupling/drag_force.h"

#include "base/banned.h"

static double coefficient(const struct ts_drag *drag, const struct ts_slip *slip)
{
	(void)drag;
	return ts_drag_stokes(slip);
}

static const struct ts_arg args[] = {
	TS_DRAG_ARGS,
	TS_ARGS_END,
};

TS_STYLE(fix, ts_drag_style, ts_fix_drag_stokes)
const struct ts_drag_style ts_fix_drag_stokes = {
	.style = {
		.name = "drag/stokes",
		.summary = "Stokes drag of the fluid on each particle of the group",
		.doc = "F = 3 pi mu d (u - v), u the velocity of the fluid at the particle's centre, mu its "
		       "viscosity, both from\n"
		       "flow_style, d the diameter. `axes z` keeps only that component.\n\n"
		       TS_DRAG_DOC,
		.example = "flow_style uniform velocity 0 0 1.0 viscosity 1.0e-3\n"
			   "fix drag rock drag/stokes axes z scheme exact",
		.cite = "G. G. Stokes, Trans. Camb. Phil. Soc. 9 (1851) 8",
		.args = args,
		TS_DRAG_SLOTS,
	},
	.coefficient = coefficient,
};
