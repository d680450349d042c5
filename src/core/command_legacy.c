/* Command legacy: results of LIGGGHTS or LAMMPS where their algorithms and tsim's differ. */
#include "core/sim.h"

#include "base/banned.h"

static const char *const of_words[] = {
	[TS_LEGACY_NO] = "no", [TS_LEGACY_LIGGGHTS] = "yes", [TS_LEGACY_LAMMPS] = "lammps", NULL
};

struct legacy {
	int of;
};

static enum ts_status run_legacy(struct tsim *sim, void *state, const struct ts_place *where)
{
	(void)where;
	sim->legacy = (enum ts_legacy)((const struct legacy *)state)->of;
	return TS_OK;
}

static const struct ts_arg args[] = {
	TS_ENUM("of", struct legacy, of, of_words, .flags = TS_POSITIONAL,
		.help = "whether results are those of LIGGGHTS (yes) or of LAMMPS (lammps)"),
	TS_ARGS_END,
};

static const char lammps_and_contacts[] =
	"`legacy lammps` has two of the differences, restart of runs and walls with the law `granular`; "
	"fix print prints at the start of a run, and titles of columns in the log are c_ID, f_ID and "
	"v_NAME instead of ID and NAME; compute temp/profile subtracts the degrees of freedom that "
	"LAMMPS does. With `legacy yes`:\n\n"
	"Contact history: a pair that separates keeps the history of its contact (tangential and "
	"rolling springs, the depth of hooke/hysteresis) until the next rebuild of the neighbor list, "
	"and continues it if the particles touch again before that, or overlap in that very step: "
	"results depend on the skin. Otherwise the history ends with the contact, as it does at walls "
	"in either case.\n\n"
	"Restart of runs: each `run` computes the forces of its first step anew, from the velocities of "
	"the full step, so that two `run 100` differ from `run 200`, and a run cut by a restart file "
	"from the whole run. Otherwise a run that continues uses the forces of the last step.\n\n"
	"compute pair/gran/local gives the forces that follow from the velocities at the end of the "
	"step, otherwise the forces that have acted in the step.\n\n"
	"Obtuse corners of triangles: a particle that lies beyond both edges of an obtuse corner, with "
	"its nearest point on one of them, touches that point only at the last corner of the triangle; "
	"at the other corners it touches the corner, or nothing if the corner belongs to another "
	"triangle, so that contacts are lost. Otherwise the contact point is the nearest point.";

static const char *const further[] = {
	"Seams of flat neighbours that bulge: a particle above the edge, beyond both faces, has no contact. "
	"Otherwise it touches the edge.\n\n"
	"fix property/atom/tracer/stream: particles that were to be marked from a step on are not marked if "
	"the stream has an insertion event in that very step; only the first ones are.\n\n"
	"fix insert/stream releases rigid clumps without angular velocity.\n\n"
	"fix heat/gran with area_correction does not correct the contacts at walls.\n\n"
	"Walls with LAMMPS' law `granular` of a material have the effective moduli E* = E/(2 (1 - nu)) and, "
	"for k_t NULL, E (2 - nu)(1 + nu)/4, as in LAMMPS' source code; otherwise those of a contact of the "
	"material with itself.\n\n"
	"fix mesh/surface/stress/servo without gains has kp = 0.01 even if its control loop is unstable with "
	"it; otherwise kp is at most a tenth of the largest stable value.\n\n"
	"Legacy VTK files (.vtk) have positions in single precision, with six digits in text files, and the "
	"bounds of the box in text dumps have six digits.\n\n"
	"Smaller ones: fix check/timestep/gran and check/timestep/bond have the formulas and warnings of "
	"LIGGGHTS; a ycylinder with `shear` has two components interchanged; two contact angles of a liquid "
	"bridge give half their product in place of their mean; the product of inertia yz of a clump is the "
	"mean of xz and yz; variables in a `variable NAME string` are not substituted; seeds that LIGGGHTS "
	"refuses are warned of; titles of columns in the log have eight letters; particles that leave with "
	"`thermo_modify lost ignore` are deleted when the neighbor list is built.\n\n"
	"What remains with `legacy yes`: a wall that is defined after fix freeze does not push frozen "
	"particles; extensive c_ID and f_ID in the log are not divided by the number of particles with "
	"`thermo_modify norm yes`; in the set-up of a further run moving meshes have the velocity of the "
	"last step, in LIGGGHTS none, and in the first row of the log of a further run the forces on meshes "
	"are doubled in LIGGGHTS; a list built because of a moving mesh is built some steps earlier or "
	"later; a fix move/mesh moves the origins of riggle and vibrot behind it, too, which stay where they "
	"are in LIGGGHTS; spheres of a clump have their share of its mass in `dump ... mass` and compute "
	"erotate/sphere, in LIGGGHTS each the mass of the clump; history columns of compute pair/gran/local "
	"with hooke/hysteresis are sx sy sz deltaMax, in LIGGGHTS deltaMax sx sy sz, and those of cohesion "
	"washino are in another order, too; templates of spheres and clumps in one mixture are drawn in "
	"another order; particles in a region mesh/tet or mesh/hex are inserted at other positions; the "
	"default log has no column Volume. And compute pe, compute pe/atom and the keywords pe, etotal and "
	"epair give the elastic energy of contacts. LIGGGHTS and LAMMPS give 0 for granular contacts, "
	"because their granular pair styles compute no energy; the energy balance (fix energy/ledger) needs "
	"it. `tsim -crosscheck` shows such columns and does not count them as differences.\n\n"
	"The option `-legacy` of the command line does the same, `-legacy lammps` as `legacy lammps`, for "
	"scripts that the other program must read, too.",
	NULL,
};

TS_STYLE(command, ts_command_style, ts_command_legacy)
const struct ts_command_style ts_command_legacy = {
	.style = { .name = "legacy",
		   .kind = TS_KIND_COMMAND,
		   .summary = "the results of LIGGGHTS or LAMMPS where their algorithms and tsim's differ",
		   .doc = lammps_and_contacts,
		   .doc_more = further,
		   .example = "legacy yes",
		   .args = args,
		   .state_size = sizeof(struct legacy) },
	.run = run_legacy,
};
