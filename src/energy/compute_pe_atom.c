/* Compute: potential energy of each particle. */
#include "contact/contact_energy.h"
#include "energy/potential_energy.h"

#include "base/banned.h"

struct pe_atom {
	struct ts_words words;
	struct ts_contact_energy_parts parts;
	struct tsim *sim;
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct pe_atom *s = self->state;
	struct ts_energy_parts parts;

	s->sim = sim;
	TS_TRY(ts_energy_parse_parts(sim, self, s->words, &parts));
	s->parts = (struct ts_contact_energy_parts){ parts.pair, parts.bond };
	return TS_OK;
}

static enum ts_status eval_energy(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct pe_atom *s = self->state;
	const struct ts_particles *p = sim->particles;

	TS_TRY(ts_contact_energy_require(s->sim, self, &s->parts));
	TS_TRY(ts_table_resize(out, p->n, 1));
	for (size_t i = 0; i < p->n; i++)
		out->data[i] =
			ts_in_group(p, i, self->group) ? ts_contact_energy_of_particle(sim, i, &s->parts) : 0;
	return TS_OK;
}

static const struct ts_value values[] = {
	{ "energy", "energy", "half the energy of each contact and bond; 0 outside the group", TS_PERATOM, 1,
	  NULL, eval_energy },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_REST_OPTIONAL("parts", struct pe_atom, words,
			 .help = "any of pair, bond; none: both. fix, angle, dihedral, improper and kspace "
				 "contribute nothing"),
	TS_ARGS_END,
};

TS_STYLE(compute, ts_style, ts_compute_pe_atom)
const struct ts_style ts_compute_pe_atom = {
	.name = "pe/atom",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE,
	.summary = "potential energy of each particle",
	.doc = "The energy of a particle is half the elastic energy of each of its contacts and bonds; see "
	       "compute pe for the equations. The sum over all particles equals the result of compute pe "
	       "pair bond.",
	.example = "compute e all pe/atom\ncompute stored all reduce sum c_e",
	.args = args,
	.state_size = sizeof(struct pe_atom),
	.values = values,
	.init = init,
};
