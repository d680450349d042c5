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
	"Notation: delta is the overlap, n the unit normal towards i, R = R_i R_j/(R_i+R_j), m = m_i "      \
	"m_j/(m_i+m_j), v_n the normal velocity (negative while approaching) and a the contact radius. "    \
	"The normal force is F_n = F_e - gamma_n v_n. `hooke k d`: F_e = k delta. `hertz k d`: F_e = k a "  \
	"delta, a = sqrt(R delta). `hertz/material E d nu`: the same with k = 4/3 E/(2 (1 - nu^2)). `dmt "  \
	"E d nu w`: hertz/material minus the attraction 4 pi w R. `jkr E d nu w`: F_e = 4 E* a^3/(3 R) - "  \
	"2 pi a^2 sqrt(4 w E*/(pi a)) with delta = a^2/R - 2 sqrt(pi w a/E*), E* = E/(2 (1 - nu^2)); once " \
	"surfaces have touched they attract beyond the touch, until they separate at the pull-off force 3 " \
	"pi w R.\n\n"                                                                                       \
	"Normal damping. `damping velocity`: gamma_n = d; `mass_velocity`: d m; `viscoelastic` (the "       \
	"default): d a m; `tsuji`: d is a coefficient of restitution e, gamma_n = (1.2728 - 4.2783 e + "    \
	"11.087 e^2 - 22.348 e^3 + 27.467 e^4 - 18.022 e^5 + 4.8218 e^6) sqrt(m k_a), k_a = k for hooke "   \
	"and k a else (the restitution of equal spheres is larger than e: the polynomial is for the mass "  \
	"of one of them). `coeff_restitution` (of newer LAMMPS): the same with the factor 2 beta for "      \
	"hooke or sqrt(5) beta else instead of the polynomial, beta = -ln e/sqrt(ln^2 e + pi^2): the "      \
	"restitution is e. `limit_damping`: F_n >= 0.\n\n"                                                  \
	"Tangential force, v_t being the tangential velocity at the contact. `tangential linear_nohistory " \
	"x mu`: F_t = -min(x gamma_n, mu F_0/|v_t|) v_t. `linear_history k_t x mu`: a spring k_t along "    \
	"the tangential displacement since the first touch, which rotates with the contact, and the "       \
	"damping x gamma_n; |F_t| <= mu F_0, and where it would be larger the spring is shortened. "        \
	"`mindlin`: the spring k_t a; k_t NULL is 8 G, 1/G = 4 (2 - nu)(1 + nu)/E. `mindlin_rescale`: the " \
	"displacement is reduced in proportion when a decreases. `mindlin/force`, "                         \
	"`mindlin_rescale/force`: the spring force is stored instead of the displacement. F_0 = |F_n|, "    \
	"for adhesive laws |F_e + 2 F_p| with F_p the pull-off force, 4 pi w R for dmt.\n\n"                \
	"Rolling and twisting. `rolling sds k gamma mu`: a pseudo-force F_r = -k xi - gamma v_r, |F_r| <= " \
	"mu F_0, against the rolling velocity v_r = R (w_i - w_j) x n; its torque on i is R n x F_r, the "  \
	"opposite acts on j. `twisting sds k gamma mu`: a torque T = -k phi - gamma w_n, |T| <= mu F_0, "   \
	"against the relative rotation w_n about n. `twisting marshall`: the same with k = k_t a^2/2, "     \
	"gamma = x gamma_n a^2/2, mu = 2/3 a mu_t."

#endif
