/* Compute stress/atom: stress times volume of each particle. */
#include "contact/contact_view.h"
#include "contact/virial.h"
#include "particle/group_moments.h"

#include "base/banned.h"

/* The contacts of a particle cost as much as so many rounds of a simple loop. */
enum { CONTACTS_COST = 10 };

struct stress {
	struct ts_words words;
	struct ts_virial_parts parts;
	struct tsim *sim;
};

/* LAMMPS' syntax has a temperature compute as first argument, that of LIGGGHTS has not. */
static bool names_temperature(const struct tsim *sim, const char *word)
{
	const struct ts_instance *inst = ts_sim_find(sim, TS_KIND_COMPUTE, word);

	return ts_streq(word, "NULL") || ts_streq(word, "thermo_temp") ||
	       (inst && ts_streq(inst->style->name, "temp"));
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct stress *s = self->state;
	struct ts_words words = s->words;

	s->sim = sim;
	sim->neigh->keep_forces = true;
	if (words.n && names_temperature(sim, words.word[0].text))
		words = ts_words_from(words, 1);
	return ts_virial_read_parts(sim, self, words, &s->parts);
}

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct stress *s = self->state;
	const struct ts_particles *p = sim->particles;

	TS_TRY(ts_contacts_forces(s->sim, self));
	TS_TRY(ts_table_resize(out, p->n, 6));
#pragma omp parallel for num_threads(ts_team(sim, CONTACTS_COST * p->n)) schedule(static)
	for (size_t i = 0; i < p->n; i++) {
		double w[6] = { 0 }, m = s->parts.kinetic ? p->mass[i] : 0;
		bool member = ts_in_group(p, i, self->group);

		if (member)
			ts_virial_of_particle(sim, i, &s->parts, w);
		for (int k = 0; k < 6; k++)
			out->data[6 * i + (size_t)k] =
				member ? -(m * p->v[i][ts_tensor_row[k]] * p->v[i][ts_tensor_column[k]] +
					   w[k])
				       : 0;
	}
	return TS_OK;
}

static const struct ts_value values[] = {
	{ "stress", "pressure*volume", "stress times volume, > 0 in tension; 0 outside the group", TS_PERATOM,
	  6, ts_tensor_names, eval },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_REST_OPTIONAL("parts", struct stress, words,
			 .help = "ke, pair, bond, fix, virial (all but ke); none: all. NULL, thermo_temp or "
				 "a compute temp may stand before them"),
	TS_ARGS_END,
};

TS_STYLE(compute, ts_style, ts_compute_stress_atom)
const struct ts_style ts_compute_stress_atom = {
	.name = "stress/atom",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE,
	.summary = "Stress of each particle times its volume",
	.doc = "S_ab = -(m v_a v_b + 1/2 sum d_a F_b), the sum over the contacts and bonds of the particle, "
	       "d the vector from the partner and F its force on the particle, for ab = xx, yy, zz, xy, xz, "
	       "yz. The unit is pressure times volume: the sum over all particles divided by the volume of "
	       "the box is the stress of the system, < 0 under pressure. Forces of walls and other fixes are "
	       "not included, so `fix` adds nothing. Forces are those of the last step.",
	.example = "compute s all stress/atom\ncompute sum all reduce sum c_s[1] c_s[2] c_s[3]",
	.args = args,
	.state_size = sizeof(struct stress),
	.values = values,
	.init = init,
};
