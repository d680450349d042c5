#include <math.h>

#include "bond/bond_arguments.h"
#include "bond/bond_force.h"
#include "bond/bond_moment.h"
#include "contact/contact_energy.h"
#include "law/bond_section.h"
#include "law/bond_softening.h"

#include "base/banned.h"

struct parallel_bond {
	struct ts_bond bond;
};

enum softened_by { BY_TENSION, BY_BOTH };
static const char *const softened_by_names[] = { [BY_TENSION] = "tension", [BY_BOTH] = "both", NULL };

struct coeff {
	double kn, ks, modulus, ratio; /* NaN: not given */
	double lambda, beta;
	double soften;	 /* NaN: brittle */
	int softened_by; /* enum softened_by */
	double friction; /* degrees */
	struct ts_bond_damping damping;
	struct ts_bond_strength strength;
};

/* What softening and friction need. */
static enum ts_status complete_softening(struct tsim *sim, const struct coeff *c,
					 const struct ts_place *where)
{
	if (!isnan(c->soften) && isnan(c->strength.tension))
		return ts_fail(&sim->error, TS_SYNTAX, where,
			       "bond_coeff: soften: expected sigma_c, the stress at which softening begins");
	if (c->softened_by == BY_BOTH && (isnan(c->soften) || isnan(c->strength.shear)))
		return ts_fail(&sim->error, TS_SYNTAX, where, "bond_coeff: soften_by both: expected %s",
			       isnan(c->soften) ? "soften, the slope of the softening"
						: "tau_c, the shear stress at which softening begins");
	if (c->friction > 0 && isnan(c->strength.shear))
		return ts_fail(&sim->error, TS_SYNTAX, where,
			       "bond_coeff: friction_angle: expected tau_c, the shear strength without "
			       "normal stress, which is infinite");
	return TS_OK;
}

static enum ts_status complete(struct tsim *sim, void *coeff, const struct ts_place *where)
{
	struct coeff *c = coeff;

	if (isnan(c->kn) == isnan(c->modulus))
		return ts_fail(&sim->error, TS_SYNTAX, where,
			       "bond_coeff: expected either kn, the normal stiffness per area, or E, the "
			       "modulus of the bond, kn = E/(R_a + R_b)");
	if (isnan(c->ks) == isnan(c->ratio) || (!isnan(c->ks) && !isnan(c->modulus)))
		return ts_fail(&sim->error, TS_SYNTAX, where,
			       "bond_coeff: expected %sratio, that of normal to shear stiffness kn/ks%s",
			       isnan(c->modulus) ? "either " : "",
			       isnan(c->modulus) ? ", or ks, the shear stiffness per area"
						 : " (with E, not ks)");
	TS_TRY(complete_softening(sim, c, where));
	ts_bond_damping_complete(&c->damping);
	return ts_bond_strength_complete(sim, &c->strength, where);
}

static void element(const void *coeff, const struct ts_bond_pair *pair, struct ts_bond_element *e)
{
	const struct coeff *c = coeff;
	double radius = c->lambda * fmin(pair->radius[0], pair->radius[1]);
	double kn = isnan(c->kn) ? c->modulus / (pair->radius[0] + pair->radius[1]) : c->kn;

	e->fraction = ts_bond_fraction(pair->rest, pair->radius);
	ts_bond_section_parallel(radius, kn, isnan(c->ks) ? kn / c->ratio : c->ks, e);
	ts_bond_section_stress(radius, c->beta, e);
	ts_bond_section_damping(c->damping.ratio, pair->mass, pair->inertia, e);
	ts_bond_section_strength(&c->strength, pair->tag, e);
	e->friction = tan(c->friction * TS_PI / 180);
	if (!isnan(c->soften))
		ts_bond_softens_by(c->soften, c->softened_by == BY_BOTH, e);
}

static bool softens(const void *coeff)
{
	const struct coeff *c = coeff;

	return !isnan(c->soften) || c->friction > 0;
}

static bool damped(const void *coeff)
{
	return ts_bond_any_damping(&((const struct coeff *)coeff)->damping);
}

static const struct ts_arg coeff_rows[] = {
	TS_REAL("kn", struct coeff, kn, .flags = TS_OPTIONAL, .range = TS_POSITIVE, .unit = "pressure/length",
		.help = "normal stiffness per area of the section"),
	TS_REAL("ks", struct coeff, ks, .flags = TS_OPTIONAL, .range = TS_POSITIVE, .unit = "pressure/length",
		.help = "shear stiffness per area of the section"),
	TS_REAL("E", struct coeff, modulus, .flags = TS_OPTIONAL, .range = TS_POSITIVE, .unit = "pressure",
		.help = "modulus of the bond: kn = E/(R_a + R_b); instead of kn"),
	TS_REAL("ratio", struct coeff, ratio, .flags = TS_OPTIONAL, .range = TS_POSITIVE, .unit = "",
		.help = "ratio kn/ks; instead of ks"),
	TS_REAL("lambda", struct coeff, lambda, .fallback = "1", .range = TS_POSITIVE, .unit = "",
		.help = "radius of the section divided by the smaller radius of the two particles"),
	TS_BOND_STRENGTH_ROWS(struct coeff, strength),
	TS_REAL("soften", struct coeff, soften, .flags = TS_OPTIONAL, .range = TS_POSITIVE, .unit = "",
		.help = "slope at which the tensile stress falls with the opening beyond sigma_c, by that of "
			"the elastic bond; none: it breaks at sigma_c"),
	TS_ENUM("soften_by", struct coeff, softened_by, softened_by_names, .fallback = "tension",
		.help = "what makes a bond soften: tension only, beyond sigma_c; or both, also shear beyond "
			"tau_c"),
	TS_REAL("friction_angle", struct coeff, friction, .fallback = "0", .range = TS_WITHIN, .lo = 0,
		.hi = 89, .unit = "degrees",
		.help = "angle phi of internal friction: the shear strength is tau_c - sigma_n tan(phi) with "
			"the mean normal stress sigma_n = N/A, > 0 in tension"),
	TS_REAL("beta", struct coeff, beta, .fallback = "1", .range = TS_FRACTION, .unit = "",
		.help = "share of the moments in the stresses, Potyondy 2011"),
	TS_BOND_DAMPING_ROWS(struct coeff, damping),
	TS_ARGS_END,
};

static const char *const more[] = {
	"Strengths: the largest stresses of the section are\n\n"
	"  sigma = N/A + beta M R/I,   tau = V/A + beta |M_t| R/J\n\n"
	"with the normal force N (> 0 in tension), shear force V, bending moment M and torque M_t. A bond "
	"breaks for good when sigma >= sigma_c (mode tension) or tau >= tau_c (mode shear), or, if "
	"sigma_compression is given, when -N/A + beta M R/I reaches it (mode compression). Dashpots do not "
	"count. A strength that is not given is infinite. With `scatter normal` and `scatter weibull` the "
	"strengths sigma_c and tau_c of each bond are independent random numbers with these means. They are "
	"functions of `seed` and the IDs of the two particles, hence the same for any number of threads, "
	"order of particles, and after a restart. A normal distribution is cut off at 0.",
	"`soften B`: displacement softening (Ma & Huang 2018). At sigma_c the bond does not break, but "
	"begins to crack. With the largest opening X that it has had, as stress of the whole section by "
	"sigma_c, the fraction g = (rho - X)/((rho - 1) X), rho = 1 + 1/B, of the section is intact: it has "
	"g times all forces and moments of the whole bond, to which the crack adds its share of the normal "
	"force in compression. So the stress of a bond that is pulled falls linearly to 0 at the opening rho "
	"sigma_c/kn, where it breaks (mode tension); unloading goes back to the origin, and compression is "
	"that of the whole bond. The work per area until then is sigma_c^2 rho/(2 kn). Strengths in shear "
	"and compression are those of the intact part: compared are the stresses that the whole section "
	"would have, as `sigma` and `tau` of compute bond/local are, whose sigma_c is rho times that of "
	"bond_coeff. Dashpots are multiplied by g. What is lost is f_ID of fix energy/ledger, dissipated in "
	"plastic contacts and bonds. The limit of the time step is that of the whole bond. A bond that has "
	"cracked breaks at the latest when its ends have turned by 90 degrees.\n\n"
	"With `soften_by both` shear cracks the bond as well: X is then the larger of the opening and of the "
	"shear stress of the whole section by the shear strength, and the bond breaks by either at X = rho. "
	"With tension only, a bond breaks at once when tau reaches its shear strength.",
	"`friction_angle PHI`: the shear strength depends on the mean normal stress sigma_n = N/A, > 0 in "
	"tension, as that of Mohr and Coulomb and of the linear parallel bond of Itasca's PFC,\n\n"
	"  tau >= tau_c - sigma_n tan(PHI)\n\n"
	"so a compressed bond is stronger, and a bond without shear breaks at the tension tau_c/tan(PHI), if "
	"that is below sigma_c. Moments have no part in sigma_n. tau_c, the cohesion, is scattered, PHI is "
	"not. In a bond that softens sigma_n is what the cracked bond carries. The friction of particles "
	"whose bond has broken is that of their contact, by pair_style. Column tau_c of compute bond/local "
	"is the strength at the present normal stress.",
	TS_BOND_MOMENT_DOC, NULL
};

TS_STYLE(bond, ts_bond_style, ts_bond_parallel)
const struct ts_bond_style ts_bond_parallel = {
	.style = { .name = "parallel",
		   .kind = TS_KIND_BOND,
		   .ranks = TS_RANKS_OWN,
		   .summary = "parallel bond: a disc of cement with normal, shear, bending and torsional "
			      "stiffness",
		   .doc = "A disc of elastic material between two particles, midway between their surfaces, "
			  "of radius R = lambda min(R_a, R_b), area A = pi R^2 and moments I = pi R^4/4, J = "
			  "pi R^4/2. Relative motion of the particles at the disc gives forces and "
			  "moments\n\n"
			  "  dN = kn A dU_n,   dV = -ks A dU_s,   dM_t = -ks J dtheta_n,   dM = -kn I "
			  "dtheta_s\n\n"
			  "(Potyondy & Cundall 2004). tsim computes them in total form, from positions and "
			  "orientations: the integral of these increments in the frame that rotates with the "
			  "bond. So a rigid motion of the particles gives no force, however far they turn, "
			  "and without damping energy, momentum and angular momentum are conserved.\n\n"
			  "A straight chain of N bonds of length l = L/N with kn = E/l, ks = G/l has the "
			  "exact deflections P L/(E A) by an axial force P, P L^3/(3 E I) (1 - 1/(4 N^2)) + "
			  "P L/(G A) by a transverse force, M L^2/(2 E I) by a moment M, and the twist T "
			  "L/(G J) by a torque T.\n\n"
			  "Equations typeset, assumptions, order and limits: doc/theory-bonds.md.",
		   .doc_more = more,
		   .example = "bond_style parallel\n"
			      "bond_coeff 1 E 62e9 ratio 2.5 sigma_c 175e6 tau_c 175e6 scatter normal "
			      "deviation 0.23 seed 4711\n"
			      "create_bonds many rock rock 1 0.0 1.05e-3",
		   .cite = "D. O. Potyondy, P. A. Cundall, Int. J. Rock Mech. Min. Sci. 41 (2004) 1329; Y. "
			   "Ma, H. Huang, Int. J. Rock Mech. Min. Sci. 104 (2018) 9",
		   .coeff = coeff_rows,
		   .state_size = sizeof(struct parallel_bond),
		   TS_BOND_MOMENT_SLOTS },
	.coeff_size = sizeof(struct coeff),
	.complete = complete,
	.compute = ts_bond_compute_moments,
	.damped = damped,
	.element = element,
	.softens = softens,
};
