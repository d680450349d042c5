/* Command atom_style: the columns of data files. */
#include "core/sim.h"

#include "box/domain.h"
#include "particle/particles.h"
#include "restart/data.h"

#include "base/banned.h"

struct state {
	struct ts_words words;
};

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct state *s = state;
	struct ts_data_layout layout;
	struct ts_str text = { 0 };
	const char *kept;

	if (sim->has_box)
		return ts_fail(&sim->error, TS_STATE, where,
			       "atom_style must come before the simulation box is created");
	for (size_t k = 0; k < s->words.n; k++)
		ts_str_addf(&text, k ? " %s" : "%s", s->words.word[k].text);
	kept = text.failed ? NULL : ts_pool_get(sim->pool, ts_str_text(&text));
	ts_str_release(&text);
	if (!kept)
		return ts_nomem(&sim->error);
	if (!ts_data_layout(kept, &layout))
		return ts_data_refuse_style(sim, &s->words.word[0]);
	sim->particles->atom_style = kept;
	return TS_OK;
}

static const struct ts_arg args[] = {
	TS_REST("style", struct state, words,
		.help = "sphere, granular, bond, bond/gran, bpm/sphere, molecular, atomic, or hybrid and "
			"several of these, with their arguments; granular/omp means granular"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_atom_style)
const struct ts_command_style ts_command_atom_style = {
	.style = {
		.name = "atom_style",
		.kind = TS_KIND_COMMAND,
		.summary = "Sets the columns of particles in data files",
		.doc = "Sets which columns the section Atoms of a data file has (read_data, write_data).\n"
		       "It does not restrict which properties particles have: they are always spheres\n"
		       "with a radius, mass and velocity; rotation, bonds and other properties exist as\n"
		       "soon as a command of the script needs them.\n\n"
		       "The command must come before the simulation box is created.",
		.example = "atom_style granular\n"
		       "atom_style hybrid granular bond/gran n_bondtypes 1 bonds_per_atom 6",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.run = run,
};
