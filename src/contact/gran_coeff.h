/* Contact laws in the words of LAMMPS' pair_style granular, the same for pair_coeff and for walls: NORMAL
 * numbers tangential ... [damping ...] [rolling ...] [twisting ...]. */
#ifndef TS_CONTACT_GRAN_COEFF_H
#define TS_CONTACT_GRAN_COEFF_H

#include "core/sim.h"
#include "law/granular.h"

struct ts_gran_coeff {
	/* constants of the law; first: an entry of pair_coeff, see ts_pair.law_offset */
	struct ts_granular_pair law;
	struct ts_granular_model model;

	/* as given in the script */
	int normal, damping;
	double stiffness, prefactor, poisson, surface_energy, cutoff;
	bool limit_damping;
	struct ts_words tangential, rolling, twisting, heat;
	bool stiffness_follows; /* k_t NULL: computed from the material */
};
extern const struct ts_arg ts_gran_coeff_rows[];

/* Parses the arguments of the sub-laws and derives model and law. */
enum ts_status ts_gran_coeff_complete(struct tsim *sim, void *coeff, const struct ts_place *where);
/* Whether two laws differ by their numbers only; then the mixed law for pairs of both types. */
bool ts_gran_coeff_alike(const struct ts_gran_coeff *a, const struct ts_gran_coeff *b);
void ts_gran_coeff_mix(const struct ts_gran_coeff *a, const struct ts_gran_coeff *b,
		       struct ts_gran_coeff *out);
/* Constants that LAMMPS uses for a material at a wall: E* = E/(2 (1 - nu)), k_t NULL = E (2 - nu)(1 + nu)/4.
 */
void ts_gran_coeff_legacy_wall(struct ts_gran_coeff *c);

/* Text for the manual pages. */
#define TS_GRAN_COEFF_DOC                                                                                   \
	"With delta the overlap, n the normal towards i, R = R_i R_j/(R_i+R_j), m = m_i m_j/(m_i+m_j), "    \
	"v_n the normal velocity (negative while approaching) and a the radius of the contact area, the "   \
	"normal force is F_n = F_e - gamma_n v_n. `hooke k d`: F_e = k delta. `hertz k d`: F_e = k a "      \
	"delta, a = sqrt(R delta). `hertz/material E d nu`: k = 4/3 E/(2 (1 - nu^2)). `dmt E d nu w`: the " \
	"same less 4 pi w R. `jkr E d nu w`: F_e = 4 E* a^3/(3 R) - 2 pi a^2 sqrt(4 w E*/(pi a)) with "     \
	"delta = a^2/R - 2 sqrt(pi w a/E*), E* = E/(2 (1 - nu^2)); surfaces that have met pull beyond "     \
	"their touch, until they part with the force 3 pi w R.\n\n"                                         \
	"`damping velocity`: gamma_n = d; `mass_velocity`: d m; `viscoelastic` (the default): d a m; "      \
	"`tsuji`: d is a coefficient of restitution e, gamma_n = (1.2728 - 4.2783 e + 11.087 e^2 - 22.348 " \
	"e^3 + 27.467 e^4 - 18.022 e^5 + 4.8218 e^6) sqrt(m k_a), k_a = k for hooke and k a else (equal "   \
	"spheres rebound with more: the polynomial is for the mass of one of them). `coeff_restitution` "   \
	"(of newer LAMMPS): the same with 2 beta of hooke or sqrt(5) beta, beta = -ln e/sqrt(ln^2 e + "     \
	"pi^2): they rebound with e. `limit_damping`: F_n >= 0.\n\n"                                        \
	"`tangential linear_nohistory x mu`: F_t = -min(x gamma_n, mu F_0/|v_t|) v_t, v_t the slip. "       \
	"`linear_history k_t x mu`: a spring k_t along the slip since the first touch, which turns with "   \
	"the contact, and the dashpot x gamma_n; |F_t| <= mu F_0, beyond which the spring is shortened. "   \
	"`mindlin`: the spring k_t a; k_t NULL is 8 G, 1/G = 4 (2 - nu)(1 + nu)/E. `mindlin_rescale`: it "  \
	"loses in length what a loses. `mindlin/force`, `mindlin_rescale/force`: its force is remembered "  \
	"instead of its length. F_0 = |F_n|, of surfaces that stick |F_e + 2 F_p|, F_p the force that "     \
	"parts them, 4 pi w R with dmt.\n\n"                                                                \
	"`rolling sds k gamma mu`: a force F_r = -k xi - gamma v_r, |F_r| <= mu F_0, against the velocity " \
	"of rolling v_r = R (w_i - w_j) x n; its torque on i is R n x F_r, the opposite on j. `twisting "   \
	"sds k gamma mu`: a torque T = -k phi - gamma w_n, |T| <= mu F_0, against the rotation w_n about "  \
	"n. `twisting marshall`: k = k_t a^2/2, gamma = x gamma_n a^2/2, mu = 2/3 a mu_t."

#endif
