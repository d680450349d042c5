#include "contact/contact_energy.h"
#include "contact/gran_numbers.h"

#include "base/banned.h"

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	return ts_gran_numbers_init(self, sim, TS_NORMAL_HERTZ_STIFFNESS, TS_TANGENTIAL_SLIDER);
}

TS_STYLE(pair, ts_pair_style, ts_pair_gran_hertz_history)
const struct ts_pair_style ts_pair_gran_hertz_history = {
	.style = { .name = "gran/hertz/history",
		   .kind = TS_KIND_PAIR,
		   .ranks = TS_RANKS_OWN | TS_RANKS_ROWLESS,
		   .summary = "Hertzian springs and dashpots, normal and tangential, in LAMMPS' syntax",
		   .doc = TS_GRAN_NUMBERS_DOC
		   "s = sqrt(R* delta), F_n = s (kn delta - m* gamma_n v_n) and F_t = s (-kt xi - m* gamma_t "
		   "v_t), xi the tangential displacement since the first touch. Where |F_t| would exceed xmu "
		   "|F_n| it is reduced to that, and xi to the value for which spring and dashpot give this "
		   "force. kn = 4/3 Y* is the stiffness of elastic spheres.\n\n"
		   "The lever arms of F_t are the full radii, as in LAMMPS, with whose results it agrees to "
		   "round-off; in `pair_style gran` they are the distances to the contact point. pair_coeff "
		   "has no coefficients.",
		   .cite = "L. E. Silbert et al., Phys. Rev. E 64 (2001) 051302; H. P. Zhang, H. A. Makse, "
			   "Phys. Rev. E 72 (2005) 011301",
		   .example = "pair_style gran/hertz/history 200000.0 NULL 50.0 NULL 0.5 1\n"
			      "pair_coeff * *",
		   .args = ts_gran_numbers_args,
		   .coeff = ts_gran_numbers_coeff,
		   .state_size = sizeof(struct ts_gran_numbers_pair),
		   .archive = ts_pair_archive_given,
		   .fingerprint = ts_pair_fingerprint,
		   .init = init,
		   .hook = { [TS_STAGE_FORCE] = ts_gran_numbers_force },
		   .energy = ts_contact_energy_of_pairs,
		   .plan = ts_pair_plan,
		   .fini = ts_pair_fini },
	.coeff_size = sizeof(struct ts_granular_pair),
	.complete = ts_gran_numbers_complete,
};
