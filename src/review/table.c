/* The table of checks. A new one is a function and a line here, and a section of doc/review.md. */
#include "review/checks.h"

#include "base/banned.h"

const struct ts_review_check ts_review_table[] = {
	{ "integrator", "particles that no fix moves", ts_review_integrator },
	{ "rotation", "an integrator that does not turn particles whose contacts have friction",
	  ts_review_rotation },
	{ "units", "numbers in SI units without the command `units`", ts_review_units },
	{ "diameter", "particles with the diameter and density that create_atoms gives", ts_review_diameter },
	{ "overlap", "particles that overlap each other at the start", ts_review_overlap },
	{ "wall_overlap", "particles that overlap a wall at the start", ts_review_wall_overlap },
	{ "density", "densities that no grain has, in SI units", ts_review_density },
	{ "bonds", "bonded structures that keep no shape", ts_review_bonds },
	{ "modulus", "moduli that no solid has, in SI units", ts_review_modulus },
	{ "reach", "walls that no particle in the box can touch", ts_review_reach },
	{ "floor", "gravity towards a fixed face, and nothing that stops what falls", ts_review_floor },
	{ "mesh_size", "meshes that are smaller than the particles", ts_review_mesh_size },
	{ "members", "integrators that move members of rigid bodies, too", NULL },
	{ "mesh_leaves", "meshes that will leave the box in the run", NULL },
	{ "servo", "a servo that goes to and fro with its largest speed", NULL },
	{ "momentum", "momentum of particles and fluid in a periodic box that is not kept", NULL },
	{ "flow_resolution", "cells that are too wide for the flow that is solved for", NULL },
	{ .name = NULL },
};
