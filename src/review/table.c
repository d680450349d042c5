/* The table of checks. A new one is a function and a line here, and a section of doc/review.md. */
#include "review/checks.h"

#include "base/banned.h"

const struct ts_review_check ts_review_table[] = {
	{ "integrator", "particles that no fix moves", ts_review_integrator },
	{ "rotation", "an integrator that does not turn particles whose contacts have friction",
	  ts_review_rotation },
	{ "units", "numbers in SI units without the command `units`", ts_review_units },
	{ "diameter", "particles with the diameter and density that create_atoms gives",
	  ts_review_diameter },
	{ "overlap", "particles that overlap each other at the start", ts_review_overlap },
	{ "wall_overlap", "particles that overlap a wall at the start", ts_review_wall_overlap },
	{ .name = NULL },
};
