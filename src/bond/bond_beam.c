#include <math.h>

#include "bond/bond_arguments.h"
#include "bond/bond_force.h"
#include "bond/bond_moment.h"
#include "bond/bond_yield.h"
#include "contact/contact_energy.h"
#include "law/beam.h"
#include "law/bond_section.h"
#include "law/plastic_hinge.h"

#include "base/banned.h"

struct beam {
	struct ts_bond bond;
};

struct coeff {
	double modulus, poisson, shear_modulus; /* the last two: NaN if not given */
	double kappa;				/* NaN: of Cowper */
	double lambda;
	double yield; /* NaN: elastic */
	struct ts_bond_damping damping;
	struct ts_bond_strength strength;
	/* from these */
	double g, shear_coefficient;
};

static enum ts_status complete(struct tsim *sim, void *coeff, const struct ts_place *where)
{
	struct coeff *c = coeff;
	double poisson;

	if (isnan(c->poisson) == isnan(c->shear_modulus))
		return ts_fail(&sim->error, TS_SYNTAX, where,
			       "bond_coeff: expected either nu, Poisson's ratio, or G, the shear "
			       "modulus");
	if (c->yield >= c->modulus)
		return ts_fail(&sim->error, TS_RANGE, where,
			       "bond_coeff: the yield stress %g is not below Young's modulus %g", c->yield,
			       c->modulus);
	c->g = isnan(c->poisson) ? c->shear_modulus : c->modulus / (2 * (1 + c->poisson));
	poisson = isnan(c->poisson) ? fmin(fmax(c->modulus / (2 * c->g) - 1, 0), 0.5) : c->poisson;
	c->shear_coefficient = isnan(c->kappa) ? ts_beam_shear_coefficient(poisson) : c->kappa;
	ts_bond_damping_complete(&c->damping);
	return ts_bond_strength_complete(sim, &c->strength, where);
}

static void element(const void *coeff, const struct ts_bond_pair *pair, struct ts_bond_element *e)
{
	const struct coeff *c = coeff;
	double radius = c->lambda * fmin(pair->radius[0], pair->radius[1]);

	ts_beam_element(radius, c->modulus, c->g, c->shear_coefficient, e);
	ts_bond_section_stress(radius, 1, e);
	ts_bond_section_damping(c->damping.ratio, pair->mass, pair->inertia, e);
	ts_bond_section_strength(&c->strength, pair->tag, e);
}

static bool damped(const void *coeff)
{
	return ts_bond_any_damping(&((const struct coeff *)coeff)->damping);
}

static bool section(const void *coeff, const struct ts_bond_pair *pair, struct ts_plastic_section *out)
{
	const struct coeff *c = coeff;

	*out = ts_plastic_circle(c->lambda * fmin(pair->radius[0], pair->radius[1]), c->yield);
	return !isnan(c->yield);
}

static const struct ts_arg coeff_rows[] = {
	TS_REAL("E", struct coeff, modulus, .range = TS_POSITIVE, .unit = "pressure",
		.help = "Young's modulus"),
	TS_REAL("nu", struct coeff, poisson, .flags = TS_OPTIONAL, .range = TS_WITHIN, .lo = 0, .hi = 0.5,
		.unit = "", .help = "Poisson's ratio: G = E/(2 (1 + nu)); instead of G"),
	TS_REAL("G", struct coeff, shear_modulus, .flags = TS_OPTIONAL, .range = TS_POSITIVE,
		.unit = "pressure", .help = "shear modulus; instead of nu"),
	TS_REAL("kappa", struct coeff, kappa, .flags = TS_OPTIONAL, .range = TS_POSITIVE, .unit = "",
		.help = "shear coefficient; none: 6 (1 + nu)/(7 + 6 nu) of Cowper, a large number: no "
			"deformation by shear"),
	TS_REAL("lambda", struct coeff, lambda, .fallback = "1", .range = TS_POSITIVE, .unit = "",
		.help = "radius of the section divided by the smaller radius of the two particles"),
	TS_REAL("yield", struct coeff, yield, .flags = TS_OPTIONAL, .range = TS_POSITIVE, .unit = "pressure",
		.help = "yield stress: ideally plastic hinges at both ends; none: elastic"),
	TS_BOND_STRENGTH_ROWS(struct coeff, strength),
	TS_BOND_DAMPING_ROWS(struct coeff, damping),
	TS_ARGS_END,
};

static const char *const more[] = {
	"Strengths: the largest stresses are those at the end with the larger bending moment,\n\n"
	"  sigma = N/A + (M + V l/2) R/I,   tau = V/A + |M_t| R/J\n\n"
	"with normal force N (> 0 in tension), shear force V, torque M_t, and the bending moment M in the "
	"middle. (If V and M are not in the same plane this is an upper bound.) A beam breaks for good when "
	"sigma >= sigma_c (mode tension), tau >= tau_c (mode shear), or, if given, when the compressive "
	"stress reaches sigma_compression (mode compression). Scatter is described at bond parallel.",
	"`yield S`: an elastic, ideally plastic beam. It flows in hinges at its ends where the bending "
	"moment reaches M_p = 4/3 R^3 S, twists where the torque reaches T_p = 2/3 pi R^3 S/sqrt(3), and "
	"changes its length where the normal force reaches N_p = pi R^2 S: the limits of a solid circular "
	"section that has yielded through. Each holds for itself, so that beams under several loads yield "
	"later than solid ones; there is no hardening. After unloading the plastic bend stays. The strengths "
	"are compared with the stresses of an elastic section, which reach 16/(3 pi) S = 1.7 S in a hinge. "
	"The work that is lost is f_ID of fix energy/ledger, dissipated in plastic contacts and bonds. A "
	"beam that yields takes about three times as long.",
	TS_BOND_MOMENT_DOC, NULL
};

TS_STYLE(bond, ts_bond_style, ts_bond_beam)
const struct ts_bond_style ts_bond_beam = {
	.style = { .name = "beam",
		   .kind = TS_KIND_BOND,
		   .ranks = TS_RANKS_OWN,
		   .summary = "Timoshenko beam with circular section between two centres",
		   .doc = "A beam from centre to centre, of radius R = lambda min(R_a, R_b) and length l, "
			  "the distance when the bond was created. The element is the cubic one of "
			  "Timoshenko in a frame that moves with the beam (co-rotational):\n\n"
			  "  k_n = E A/l,   k_s = 12 E I/(l^3 (1 + Phi)),   k_b = E I/l,   k_t = G J/l\n\n"
			  "with Phi = 12 E I/(kappa G A l^2), k_b for the difference of the rotations of the "
			  "two ends, k_s for the displacement across the beam by their mean. A straight "
			  "cantilever has the exact deflection P L^3/(3 E I) + P L/(kappa G A) with any "
			  "number of bonds; compare bond parallel, which needs many. Fibres, grass, fabrics. "
			  "The mass of the beam is that of the particles.\n\n"
			  "Equations typeset, assumptions, order and limits: doc/theory-bonds.md.",
		   .doc_more = more,
		   .example = "bond_style beam\n"
			      "bond_coeff 1 E 3.1e9 nu 0.3 lambda 1 sigma_c 60e6 damping 0.05",
		   .cite = "M. Obermayr, K. Dressler, C. Vrettos, P. Eberhard, Comput. Geotech. 49 (2013) "
			   "299; Y. Guo et al., Powder Technol. 249 (2013) 386",
		   .coeff = coeff_rows,
		   .state_size = sizeof(struct beam),
		   TS_BOND_MOMENT_SLOTS_WITH(ts_bond_turn_and_yield) },
	.coeff_size = sizeof(struct coeff),
	.complete = complete,
	.compute = ts_bond_compute_moments,
	.damped = damped,
	.element = element,
	.section = section,
};
