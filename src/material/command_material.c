/* Command material: assigns the properties of a material file to atom types. */
#include "material/material.h"
#include "particle/particles.h"

#include "base/banned.h"

struct material {
	struct ts_types types;
	const char *file;
};

static enum ts_status assign_material(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct material *m = state;
	int ntypes = sim->particles->ntypes, hi = m->types.hi ? m->types.hi : ntypes;
	struct ts_word file = { .text = m->file, .place = *ts_sim_word_of(sim, m->file, where) };

	if (hi > ntypes)
		return ts_fail(&sim->error, TS_RANGE, ts_sim_word(sim, 1, where),
			       "material: particle type %d does not exist, create_box made %d", hi, ntypes);
	for (int type = m->types.lo; type <= hi; type++)
		TS_TRY(ts_material_read(sim, type, &file));
	return TS_OK;
}

static const struct ts_arg args[] = {
	TS_TYPES("type", struct material, types, .flags = TS_POSITIONAL,
		 .help = "atom types of the material"),
	TS_WORD("file", struct material, file, .help = "material file; glass means glass.material"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_material)
const struct ts_command_style ts_command_material = {
	.style = { .name = "material",
		   .kind = TS_KIND_COMMAND,
		   .summary = "reads the properties of a material from a file",
		   .doc = "Reads the properties of a material and assigns them to the atom types. The file "
			  "is searched in the current folder, the folder of the script, the folder of the "
			  "environment variable TSIM_POTENTIALS, potentials/ in the current folder and in "
			  "the source tree, and the installed potentials. Its lines are `NAME value unit` "
			  "or, for a pair of materials, `NAME with OTHER value unit`, where OTHER is the "
			  "name of the file of the other material; `#` starts a comment, which gives the "
			  "source of the number. Units are SI: 1 (none), Pa, J/m3, kg/m3, m/s, W/m/K, "
			  "J/kg/K; values are converted to the units of the script (si, cgs, micro).\n\n"
			  "A property is taken from fix property/global if there is one of that name, else "
			  "from the materials of the types. The value of a pair of materials is the one that "
			  "either file gives for the other material; else, for a pair of the same material, "
			  "the value of that material; else the mean of the values of both materials, with a "
			  "warning once per pair. A contact law that needs a property which no file gives "
			  "stops with an error that names the materials. In formulas `property(NAME,TYPE)` "
			  "is the value of a type and `property(NAME,TYPE,TYPE)` that of a pair.\n\n"
			  "The files that come with tsim contain measured values, each with its source. "
			  "Restitution and friction of pairs: glass, acetate, and silica-sand (friction), "
			  "steel (friction), aluminium (friction) with themselves, alumina with glass, steel "
			  "with aluminium (friction). Friction of metals is that of clean dry surfaces in "
			  "sliding; restitution is valid for the impact velocity given in the file, and "
			  "decreases with velocity for materials that yield. Young's moduli of hard "
			  "materials exceed the limit of contact models unless `hard_particles yes` is set. "
			  "Like fix property/global, the command must be repeated after read_restart.",
		   .example = "material 1 file glass\n"
			      "material 2 file steel\n"
			      "set type 1 density $(property(density,1))",
		   .args = args,
		   .state_size = sizeof(struct material) },
	.needs_box = true,
	.run = assign_material,
};
