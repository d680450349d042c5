/* Compute: potential energy. */
#include "energy/potential_energy.h"

#include "base/banned.h"

struct pe {
	struct ts_words words;
	struct ts_energy_parts parts;
	struct tsim *sim;
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct pe *s = self->state;

	s->sim = sim;
	if (self->group)
		return ts_fail(&sim->error, TS_RANGE, &self->where,
			       "compute pe: contacts join particles of different groups, so the group must "
			       "be all; compute pe/atom and compute reduce give halves of each contact");
	return ts_energy_parse_parts(sim, self, s->words, &s->parts);
}

static enum ts_status eval_energy(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct pe *s = self->state;

	(void)sim;
	return ts_potential_energy(s->sim, &s->parts, out->data);
}

static const struct ts_value values[] = {
	{ "energy", "energy", "potential energy", TS_SCALAR, 1, NULL, eval_energy },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_REST_OPTIONAL("parts", struct pe, words,
			 .help = "any of pair, bond, fix; none: all. angle, dihedral, improper and kspace "
				 "contribute nothing"),
	TS_ARGS_END,
};

TS_STYLE(compute, ts_style, ts_compute_pe)
const struct ts_style ts_compute_pe = {
	.name = "pe",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE,
	.summary = "potential energy: elastic energy of contacts and bonds, and energy of fixes",
	.doc = "The potential energy is the sum of three parts:\n\n"
	       "* `pair`: the elastic energy of contacts, which they would return if they opened without "
	       "losses. Normal springs store k_n delta^2/2 with linear laws and 2/5 k_n delta^2 with the law "
	       "of Hertz, whose k_n is proportional to sqrt(delta). Springs of sliding and rolling friction "
	       "store k_t xi^2/2 and M^2/(2 k_r) at the present overlap. The energy of cohesion is the "
	       "integral of its force over the overlap, < 0. Dashpots and sliders store nothing. A contact "
	       "of hooke/hysteresis is plastic and has no potential energy: the run is refused.\n"
	       "* `bond`: K U^2/2 of each bond of bond style contact.\n"
	       "* `fix`: the energy of fixes for which `fix_modify ID energy yes` is set, e.g. -sum m g . x "
	       "of fix gravity with unwrapped positions. Walls are fixes.\n\n"
	       "LAMMPS and LIGGGHTS have no energy of granular contacts: there, compute pe is 0 for that "
	       "part (see `legacy`). LIGGGHTS has no thermo keyword pe.",
	.example = "compute stored all pe pair bond",
	.args = args,
	.state_size = sizeof(struct pe),
	.values = values,
	.init = init,
};
