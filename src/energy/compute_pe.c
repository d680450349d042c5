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
	return ts_energy_read(sim, self, s->words, &s->parts);
}

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct pe *s = self->state;

	(void)sim;
	return ts_potential_energy(s->sim, &s->parts, out->data);
}

static const struct ts_value values[] = {
	{ "energy", "energy", "potential energy", TS_SCALAR, 1, NULL, eval },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_REST_OPTIONAL("parts", struct pe, words,
			 .help = "pair, bond, fix; none: all. angle, dihedral, improper, kspace add nothing"),
	TS_ARGS_END,
};

TS_STYLE(compute, ts_style, ts_compute_pe)
const struct ts_style ts_compute_pe = {
	.name = "pe",
	.kind = TS_KIND_COMPUTE,
	.summary = "Potential energy: elastic energy of contacts and bonds, and of fixes",
	.doc = "`pair`: the elastic energy of contacts, what they would give back if they opened without\n"
	       "losses. Normal springs: k_n delta^2/2 for linear laws, 2/5 k_n delta^2 for Hertz' law, whose "
	       "k_n\n"
	       "grows with sqrt(delta). Springs of slip and of rolling at the present overlap: k_t xi^2/2 "
	       "and\n"
	       "M^2/(2 k_r). Cohesion: the integral of its pull over the overlap, < 0. Dashpots and "
	       "friction\n"
	       "store nothing. A contact of hooke/hysteresis yields and has no potential: the line is "
	       "refused\n"
	       "at the run. `bond`: K U^2/2 of bond style contact. `fix`: what the fixes give that "
	       "`fix_modify\n"
	       "ID energy yes` counts in (gravity: -sum m g.x, positions unwrapped). Walls are fixes.\n\n"
	       "LAMMPS and LIGGGHTS have no energy of granular contacts: their compute pe is 0 for that "
	       "part\n"
	       "(see `legacy`). LIGGGHTS has no keyword pe of thermo_style.",
	.example = "compute stored all pe pair bond",
	.args = args,
	.state_size = sizeof(struct pe),
	.values = values,
	.init = init,
};
