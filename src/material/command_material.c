/* Command material: the properties of a material, from a file, for particles of a type. */
#include "material/material.h"
#include "particle/particles.h"

#include "base/banned.h"

struct material {
	struct ts_types types;
	const char *file;
};

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct material *m = state;
	int most = sim->particles->ntypes, hi = m->types.hi ? m->types.hi : most;
	struct ts_word file = { .text = m->file, .place = *ts_sim_word_of(sim, m->file, where) };

	if (hi > most)
		return ts_fail(&sim->error, TS_RANGE, ts_sim_word(sim, 1, where),
			       "material: particle type %d does not exist, create_box made %d", hi, most);
	for (int type = m->types.lo; type <= hi; type++)
		TS_TRY(ts_material_read(sim, type, &file));
	return TS_OK;
}

static const struct ts_arg args[] = {
	TS_TYPES("type", struct material, types, .flags = TS_POSITIONAL,
		 .help = "particle types of that material"),
	TS_WORD("file", struct material, file, .help = "its file: glass stands for glass.material"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_material)
const struct ts_command_style ts_command_material = {
	.style = { .name = "material",
		   .kind = TS_KIND_COMMAND,
		   .summary = "reads the properties of a material from a file",
		   .doc = "The file is looked for here, beside the script, in the folder that the "
			  "environment variable TSIM_POTENTIALS names, in potentials/ here and of the source "
			  "tree, and among the installed potentials. Its lines are `NAME value unit` or, for "
			  "a pair of materials, `NAME with OTHER value unit`, OTHER being the name of the "
			  "other one's file; `#` starts a comment, and tells the source of the number. Units "
			  "are of SI: 1 (none), Pa, J/m3, kg/m3, m/s, W/m/K, J/kg/K; values are turned into "
			  "those of the script (si, cgs, micro).\n\n"
			  "Whatever needs a property takes it from fix property/global, if there is one of "
			  "that name, else from the materials of the types. A pair of materials has the "
			  "value that either file gives for the other; else, if both are the same material, "
			  "its own; else the mean of their own two values, for want of a measurement, and a "
			  "warning says so, once for each pair. What no file gives is unknown, and a contact "
			  "law that needs it is refused with the names of the materials. "
			  "`property(NAME,TYPE)` in a formula is the value, `property(NAME,TYPE,TYPE)` that "
			  "of a pair.\n\n"
			  "The files give what was measured, each number with its source beside it. "
			  "Restitution and friction of pairs: glass, acetate, and silica-sand (friction), "
			  "steel (friction), aluminium (friction) with themselves, alumina with glass, steel "
			  "with aluminium (friction). Friction of metals is that of clean dry surfaces that "
			  "slide; restitution holds for the speed that the file names, and falls with speed "
			  "where a body yields. Young's moduli of hard materials are beyond what contact "
			  "models take without `hard_particles yes`. Like fix property/global the command "
			  "has to be given again after read_restart.",
		   .example = "material 1 file glass\n"
			      "material 2 file steel\n"
			      "set type 1 density $(property(density,1))",
		   .args = args,
		   .state_size = sizeof(struct material) },
	.needs_box = true,
	.run = run,
};
