/* Command legacy: the numbers of LIGGGHTS where its way and tsim's differ. */
#include "core/sim.h"

#include "base/banned.h"

struct legacy {
	bool on;
};

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	(void)where;
	sim->legacy = ((const struct legacy *)state)->on;
	return TS_OK;
}

static const struct ts_arg args[] = {
	TS_BOOL("on", struct legacy, on, .flags = TS_POSITIONAL,
		.help = "whether runs and contacts behave as in LIGGGHTS"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_legacy)
const struct ts_command_style ts_command_legacy = {
	.style = { .name = "legacy",
		   .kind = TS_KIND_COMMAND,
		   .summary = "the numbers of LIGGGHTS where its way and tsim's differ",
		   .doc = "There are nine differences. With `legacy yes`:\n\n"
			  "A pair that parts keeps the memory of its contact (tangential and rolling "
			  "springs, the depth of hooke/hysteresis) until the next rebuild of neighbours, and "
			  "takes it up again if it meets before that or overlaps in that very step: results "
			  "depend on the skin. Otherwise the memory ends with the contact, as it does at "
			  "walls in either case.\n\n"
			  "Each `run` computes the forces of its first step anew, from the velocities of the "
			  "full step, so that `run 100` twice is not `run 200`, nor is a run cut by a "
			  "restart file the whole. Otherwise a run that goes on has the forces of the last "
			  "step.\n\n"
			  "compute pair/gran/local gives the forces that the velocities at the end of the "
			  "step would make, otherwise those that acted.\n\n"
			  "A particle that is beyond both edges of an obtuse corner of a triangle, and "
			  "nearest to a point of one of them, touches that point in the last corner of the "
			  "triangle only; in the others it touches the corner, or nothing where the corner "
			  "belongs to another triangle: contacts are lost. Otherwise the nearest point is "
			  "touched.\n\n"
			  "fix property/atom/tracer/stream forgets the particles that were to be marked from "
			  "a step on in which the stream has an event, but for the first ones.\n\n"
			  "Rigid clumps of fix insert/stream get no angular velocity where they are let "
			  "go.\n\n"
			  "Walls with LAMMPS' law `granular` of a material have E* = E/(2 (1 - nu)) and, for "
			  "k_t NULL, E (2 - nu)(1 + nu)/4, as LAMMPS' program has; otherwise as the material "
			  "meets itself.\n\n"
			  "fix mesh/surface/stress/servo without gains has kp 0.01 even where its loop is "
			  "not stable with it; otherwise kp is at most a tenth of the largest stable one.\n\n"
			  "Legacy VTK files (.vtk) have positions in single precision, with six digits in "
			  "text.\n\n"
			  "One difference remains with `legacy yes`: compute pe, compute pe/atom and the "
			  "keywords pe, etotal and epair give the elastic energy of contacts. LIGGGHTS and "
			  "LAMMPS give 0 for granular contacts, because their granular pair styles compute "
			  "no energy; the books of energy (fix energy/ledger) need it. `tsim -crosscheck` "
			  "shows such columns and does not count them as differences.\n\n"
			  "`-legacy` on the command line does the same for scripts that LIGGGHTS shall read, "
			  "too.",
		   .example = "legacy yes",
		   .args = args,
		   .state_size = sizeof(struct legacy) },
	.run = run,
};
