/* The table of checks. A new check needs a function declared in review/internal.h, a line here, and a
 * section of doc/review.md. */
#include "review/table.h"

#include "review/internal.h"

#include "base/banned.h"

const struct ts_review_check ts_review_table[] = {
	{ "integrator", "particles that no fix moves", ts_review_integrator, false },
	{ "group", "fixes that act on a group without particles", ts_review_group, false },
	{ "rotation", "an integrator without rotation for particles whose contacts have friction",
	  ts_review_rotation, false },
	{ "units", "numbers in SI units without the command `units`", ts_review_units, false },
	{ "diameter", "particles with the diameter and density that create_atoms gives", ts_review_diameter,
	  false },
	{ "overlap", "particles that overlap each other at the start", ts_review_overlap, .contacts = true },
	{ "wall_overlap", "particles that overlap a wall at the start, or when they are inserted",
	  ts_review_wall_overlap, .contacts = true },
	{ "density", "densities outside the range of solids, in SI units", ts_review_density, false },
	{ "bonds", "bonded structures without shear and bending stiffness", ts_review_bonds, false },
	{ "modulus", "elastic moduli outside the range of solids, in SI units", ts_review_modulus, false },
	{ "reach", "walls that no particle in the box can touch", ts_review_reach, false },
	{ "floor", "gravity towards a fixed face without a wall, mesh or fixed particle below",
	  ts_review_floor, false },
	{ "mesh_size", "meshes that are smaller than the particles", ts_review_mesh_size, false },
	{ "held_contacts", "contacts of two held particles, where outputs read forces",
	  ts_review_held_contacts, false },
	{ "members", "integrators whose group contains members of rigid bodies", NULL, false },
	{ "mesh_leaves", "meshes that will leave the box during the run", NULL, false },
	{ "servo", "a servo that oscillates at its largest speed", NULL, false },
	{ "momentum", "total momentum of particles and fluid that is not conserved in a periodic box", NULL,
	  false },
	{ "flow_resolution", "grid cells that are too wide for the flow", NULL, false },
	{ .name = NULL },
};
