#include <math.h>

#include "bond/bond_arguments.h"
#include "bond/bond_force.h"
#include "bond/bond_moment.h"
#include "bond/bond_single_loop.h"
#include "bond/bpm_words.h"
#include "contact/contact_energy.h"
#include "law/bpm_bond.h"

#include "base/banned.h"

struct bpm_rotational {
	struct ts_bond bond;
	struct ts_bpm_words words;
};

struct coeff {
	double k[TS_BOND_MODES], critical[TS_BOND_MODES], damping[TS_BOND_MODES];
	bool smooth, normalize, breaks; /* from the keywords of the bond style, before a run */
};

static enum ts_status complete(struct tsim *sim, void *coeff, const struct ts_place *where)
{
	(void)sim, (void)coeff, (void)where;
	return TS_OK;
}

static void apply_words(struct bpm_rotational *s)
{
	for (size_t t = 1; t < s->bond.coeffs.n; t++) {
		struct coeff *c = ts_coeff(&s->bond.coeffs, t);

		c->smooth = s->words.smooth;
		c->normalize = s->words.normalize;
		c->breaks = s->words.breaks && !s->words.unbreakable;
	}
}

/* Strengths are 1, as what is compared with them is B. */
static void element(const void *coeff, const struct ts_bond_pair *pair, struct ts_bond_element *e)
{
	const struct coeff *c = coeff;

	e->fraction = 0.5;
	for (int m = 0; m < TS_BOND_MODES; m++) {
		e->k[m] = c->k[m];
		e->c[m] = c->damping[m];
		if (c->normalize && m < TS_BOND_BENDING)
			e->k[m] /= pair->rest;
	}
	if (c->breaks)
		e->tension = e->shear = 1;
}

TS_INLINE bool rotational_law(const void *coeff, struct ts_bond_element *e, const struct ts_bond_ends *s,
			      bool whole, struct ts_bond_answer *out)
{
	const struct coeff *c = coeff;

	ts_bond_elastic(e, s, out);
	ts_bpm_damage(c->critical, out);
	out->smoothed = c->smooth ? ts_bpm_smoothing(out) / 3 : 0;
	ts_bpm_scale(1 - 3 * out->smoothed, e, out);
	if (whole)
		ts_bond_viscous(e, s, out);
	else if (c->smooth)
		ts_bpm_derive(c->critical, e, s, out);
	return ts_bond_holds(e, out);
}

static bool law(const void *coeff, struct ts_bond_element *e, const struct ts_bond_ends *s, bool whole,
		struct ts_bond_answer *out)
{
	return rotational_law(coeff, e, s, whole, out);
}

TS_BOND_SINGLE_LOOP(compute, rotational_law)

static bool damped(const void *coeff)
{
	const struct coeff *c = coeff;

	for (int m = 0; m < TS_BOND_MODES; m++)
		if (c->damping[m] > 0)
			return true;
	return false;
}

static enum ts_status chosen(struct ts_instance *self, struct tsim *sim)
{
	return ts_bpm_chosen(self, sim, &((struct bpm_rotational *)self->state)->words);
}

static enum ts_status allow(struct ts_instance *self, struct tsim *sim)
{
	return ts_bpm_allow(self, sim, &((struct bpm_rotational *)self->state)->words);
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct bpm_rotational *s = self->state;

	TS_TRY(ts_bpm_check(self, sim, &s->words));
	apply_words(s);
	sim->bonds->rows.filled = false;
	return ts_bond_init(self, sim);
}

static const struct ts_arg args[] = { TS_BPM_ARGS(struct bpm_rotational, words), TS_ARGS_END };

#define NUMBER(name, field, of, text)                                                                    \
	TS_REAL(name, struct coeff, field, .flags = TS_POSITIONAL, .range = TS_NOT_NEGATIVE, .unit = of, \
		.help = text)
#define CRITICAL(name, field, of, text)                                                              \
	TS_REAL(name, struct coeff, field, .flags = TS_POSITIONAL, .range = TS_POSITIVE, .unit = of, \
		.help = text)

static const struct ts_arg coeff_rows[] = {
	NUMBER("k_r", k[TS_BOND_NORMAL], "force/length", "stiffness of stretching"),
	NUMBER("k_s", k[TS_BOND_SHEAR], "force/length", "stiffness of shear"),
	NUMBER("k_t", k[TS_BOND_TWIST], "force*length", "stiffness of torsion"),
	NUMBER("k_b", k[TS_BOND_BENDING], "force*length", "stiffness of bending"),
	CRITICAL("f_rc", critical[TS_BOND_NORMAL], "force", "critical normal force"),
	CRITICAL("f_sc", critical[TS_BOND_SHEAR], "force", "critical shear force"),
	CRITICAL("tau_bc", critical[TS_BOND_BENDING], "force*length", "critical bending moment"),
	CRITICAL("tau_tc", critical[TS_BOND_TWIST], "force*length", "critical torque"),
	NUMBER("gamma_n", damping[TS_BOND_NORMAL], "force/velocity", "damping of stretching"),
	NUMBER("gamma_s", damping[TS_BOND_SHEAR], "force/velocity", "damping of shear"),
	NUMBER("gamma_r", damping[TS_BOND_BENDING], "force*length*time", "damping of bending"),
	NUMBER("gamma_t", damping[TS_BOND_TWIST], "force*length*time", "damping of torsion"),
	TS_ARGS_END,
};

static const char *const more[] = {
	TS_BPM_DOC,
	"The four motions are those of bond_style parallel with the section in the middle between the two "
	"centres: shear is the displacement of the two sides across the bond, bending and torsion are the "
	"components of the rotation of one particle relative to the other. They have an elastic energy, "
	"whose derivatives are the forces; LAMMPS decomposes the rotation after Wang, which is the same for "
	"small angles.",
	"In compute bond/local `ratio` is B, `sigma` is B where f_r and tau_b contribute more to it than f_s "
	"and tau_t, else `tau`; the mode of a broken bond is tension or shear alike. With `break no` there "
	"is nothing to compare with: `ratio` and `mode` are 0, B is `sigma` or `tau`. The columns force, "
	"shear, bending and twist are the loads that act, multiplied by w. The force that fix bond/breakage "
	"lists is about 0 with smoothing, as w is. Particles are integrated by fix nve/sphere, or "
	"nve/bpm/sphere, the same. A bond that turns by more than 90 degrees between its ends, or that "
	"extends over half a periodic box, is an error.",
	NULL
};

TS_STYLE(bond, ts_bond_style, ts_bond_bpm_rotational)
const struct ts_bond_style ts_bond_bpm_rotational = {
	.style = { .name = "bpm/rotational",
		   .kind = TS_KIND_BOND,
		   .ranks = TS_RANKS_OWN,
		   .summary = "breakable bond with shear, bending and torsion of LAMMPS' package BPM",
		   .doc = "The bond resists stretching by the normal force f_r = k_r (r - r0), and shear, "
			  "bending and torsion with the stiffnesses k_s, k_b and k_t by the shear force f_s "
			  "and the moments tau_b and tau_t. It breaks when\n\n"
			  "  B = f_r/f_rc + |f_s|/f_sc + |tau_b|/tau_bc + |tau_t|/tau_tc\n\n"
			  "reaches 1, f_r > 0 in tension. All forces and moments are multiplied by w = 1 - "
			  "B^4 (B > 0), with `smooth no` by 1. The dashpots gamma_n, gamma_s, gamma_r and "
			  "gamma_t act parallel to the four springs, also multiplied by w. The elastic "
			  "energy is multiplied by 1 - B^4/3, the integral where all loads grow in "
			  "proportion; fix energy/ledger books what another way of loading takes or "
			  "gives with the dashpots. With `normalize yes` k_r and k_s are divided by r0.",
		   .doc_more = more,
		   .example = "special_bonds lj 0 1 1 coul 1 1 1\n"
			      "bond_style bpm/rotational store/local broken 1000 time id1 id2\n"
			      "bond_coeff 1 1.0 0.2 0.02 0.02 0.20 0.04 0.04 0.04 0.1 0.02 0.002 0.002",
		   .cite = "Y. Wang, Acta Geotech. 4 (2009) 117; J. T. Clemmer, J. M. Monti, J. B. Lechman, "
			   "Soft Matter 20 (2024) 1702",
		   .args = args,
		   .coeff = coeff_rows,
		   .state_size = sizeof(struct bpm_rotational),
		   .archive = ts_bond_archive,
		   .fingerprint = ts_bond_fingerprint,
		   .init = init,
		   .hook = { [TS_STAGE_POST_INTEGRATE] = ts_bond_turn, [TS_STAGE_FORCE] = ts_bond_force },
		   .energy = ts_contact_energy_of_bonds,
		   .plan = ts_bond_plan,
		   .fini = ts_bond_fini },
	.allow = allow,
	.coeff_size = sizeof(struct coeff),
	.chosen = chosen,
	.complete = complete,
	.compute = compute,
	.damped = damped,
	.element = element,
	.law = law,
};
