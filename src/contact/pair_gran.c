#include "contact/contact_energy.h"
#include "contact/contact_loop.h"
#include "contact/contact_models.h"
#include "contact/limits.h"
#include "contact/materials.h"
#include "contact/pair.h"
#include "insert/template.h"
#include "particle/prescribed.h"

#include "base/banned.h"

struct gran {
	struct ts_pair pair;
	struct ts_granular_words words;
	bool generic;
};

/* Reads the constants of all pairs of types from the material properties. */
static enum ts_status read_materials(struct ts_instance *self, struct tsim *sim)
{
	struct gran *g = self->state;
	int most = ts_template_max_type(sim);

	for (int a = 1; a <= most; a++) {
		for (int b = 1; b <= most; b++) {
			size_t k = (size_t)(a * (g->pair.ntypes + 1) + b);

			TS_TRY(ts_contact_law_of_materials(sim, &g->pair.model, a, b, "pair_style gran",
							   &self->where, ts_coeff(&g->pair.coeffs, k)));
		}
	}
	return TS_OK;
}

/* Combinations that LIGGGHTS refuses, too. */
static enum ts_status check_words(struct ts_instance *self, struct tsim *sim)
{
	const struct gran *g = self->state;

	if (!g->words.normal && !g->words.tangential && !g->words.cohesion && !g->words.rolling)
		return ts_fail(&sim->error, TS_SYNTAX, &self->where,
			       "pair gran needs a model first: `model hertz tangential history`");
	TS_TRY(ts_granular_words_check(sim, self, "pair gran", &g->words));
	if (g->words.cohesion == TS_WORD_BOND)
		TS_TRY(ts_cohesive_bonds_require(sim, self));
	if (sim->newton_on && ts_tangential_remembers(&g->pair.model))
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "pair gran with tangential history needs `newton off`");
	if (sim->still_ghosts)
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "pair gran needs velocities across periodic faces: `communicate single vel "
			       "yes`");
	return TS_OK;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct gran *g = self->state;

	g->pair.model = ts_contact_model_of_words(sim, &g->words);
	g->pair.sticks = ts_granular_reaches(&g->pair.model) || g->pair.model.multi;
	if (sim->particles
		    ->ntypes) /* also where the words are refused: with -check the scene is reviewed then */
		TS_TRY(ts_pair_prepare(sim, self));
	TS_TRY(check_words(self, sim));
	if (!sim->particles->ntypes)
		return TS_OK;
	TS_TRY(read_materials(self, sim));
	if (ts_cohesion_bridges(&g->pair.model))
		TS_TRY(ts_liquid_init(sim, self, &g->pair.liquid));
	return ts_pair_init(self, sim);
}

static enum ts_status advance(struct ts_instance *self, struct tsim *sim)
{
	const struct gran *g = self->state;

	if (ts_cohesion_bridges(&g->pair.model))
		ts_liquid_advance(sim, &g->pair.liquid);
	return TS_OK;
}

static enum ts_status archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a)
{
	struct gran *g = self->state;

	TS_TRY(ts_pair_archive_given(self, sim, a));
	g->pair.model = ts_contact_model_of_words(sim, &g->words);
	return ts_cohesion_bridges(&g->pair.model) ? ts_liquid_archive(sim, a, &g->pair.liquid) : TS_OK;
}

static enum ts_status chosen(struct ts_instance *self, struct tsim *sim)
{
	struct gran *g = self->state;
	const struct ts_granular_model m = ts_contact_model_of_words(sim, &g->words);

	if (g->words.cohesion == TS_WORD_BOND)
		return ts_cohesive_bonds_choose(sim, self);
	return ts_cohesion_bridges(&m) ? ts_liquid_columns(sim, self, &g->pair.liquid) : TS_OK;
}

static enum ts_status force(struct ts_instance *self, struct tsim *sim)
{
	const struct gran *g = self->state;

	return ts_contact_loop(sim, &g->pair, ts_contact_share_of(&g->pair, g->generic));
}

/* Reports the limits of ts_pair_plan and, as advice, Rayleigh and Hertz times where the law has a material.
 */
static enum ts_status plan(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report)
{
	const struct gran *g = self->state;
	int law = g->pair.model.normal;
	double speed;
	struct ts_granular_times times;

	TS_TRY(ts_pair_plan(self, sim, report));
	if (!report->advice)
		return TS_OK;
	if (law != TS_NORMAL_HERTZ && law != TS_NORMAL_HOOKE && law != TS_NORMAL_HOOKE_HYSTERESIS)
		return TS_OK;
	speed = 2 * ts_prescribed_max_speed(sim, 0);
	TS_TRY(ts_granular_times(sim, 0, speed, false, "pair_style gran", &self->where, &times));
	if (isfinite(times.rayleigh))
		TS_TRY(ts_report_limit(report, times.rayleigh, false, &self->where,
				       "waves along the surface of particles (Rayleigh's time)"));
	if (isfinite(times.hertz))
		TS_TRY(ts_report_limit(report, times.hertz, false, &self->where,
				       "collisions at the speed %.4g (Hertz' time)", speed));
	return TS_OK;
}

static enum ts_status complete(struct tsim *sim, void *coeff, const struct ts_place *where)
{
	(void)sim, (void)coeff, (void)where;
	return TS_OK;
}

static const struct ts_arg args[] = {
	TS_GRANULAR_ARGS(struct gran, words),
	TS_FLAG("generic", struct gran, generic,
		.help = "uses the contact loop for any model, for comparison with specialised ones"),
	TS_ARGS_END,
};

static const struct ts_arg coeff[] = { TS_ARGS_END };

static const char normal_laws[] =
	"With delta the overlap, n the unit normal towards i, R* = R_i R_j/(R_i+R_j), m* = m_i "
	"m_j/(m_i+m_j), v_n the normal velocity (negative while approaching) and v_t the tangential velocity "
	"at the contact point, the force on i is F_n n + F_t with F_n = k_n delta - gamma_n v_n. Frozen "
	"particles have infinite mass.\n\n"
	"Normal laws (`model`). Y* and G* are the effective moduli, 1/Y* = sum (1-nu^2)/Y, 1/G* = sum "
	"2(2-nu)(1+nu)/Y over both particles. `hertz`: k_n = 4/3 Y* sqrt(R* delta), k_t = 8 G* sqrt(R* "
	"delta), gamma = -2 sqrt(5/6) beta sqrt(S m*) with S_n = 2 Y* sqrt(R* delta), S_t = k_t, beta = ln "
	"e/sqrt(ln^2 e + pi^2). `hooke`: k_n = k_t = 16/15 sqrt(R*) Y* (15 m* V^2/(16 sqrt(R*) Y*))^(1/5), "
	"gamma = sqrt(4 m* k_n/(1 + (pi/ln e)^2)). `hooke/stiffness` and `hertz/stiffness`: k and m* gamma "
	"as given, the latter times sqrt(R* delta). `hooke/modulus`, for rock of bonded grains: the springs "
	"4 R E_c of both grains in series, k_n = 4 E_c R*, k_t = k_n/kappa, gamma as hooke (D. O. Potyondy, "
	"P. A. Cundall, Int. J. Rock Mech. Min. Sci. 41 (2004) 1329). `hooke/hysteresis`: loading with the "
	"k_n of hooke, steeper unloading, adhesion at the end. `edinburgh`: see below. `jkr`: adhesive "
	"contact, F_n = 4 Y* a^3/(3 R*) - sqrt(8 pi W Y* a^3) with the contact radius a from delta = a^2/R* "
	"- sqrt(2 pi W a/Y*), W the "
	"work of adhesion; once surfaces have touched they attract beyond the touch and separate at the "
	"pull-off force 3/2 pi W R* (K. L. Johnson, K. Kendall, A. D. Roberts, Proc. R. Soc. Lond. A 324 "
	"(1971) 301). k_t = 8 G* a; damping as hertz, sqrt(R* delta) replaced by a.";

static const char other_laws[] =
	"Tangential laws. `tangential history`: F_t = -k_t xi - gamma_t v_t, xi the tangential displacement "
	"since the first touch; where the spring force k_t |xi| exceeds mu |F_n|, xi is shortened to mu "
	"|F_n|/k_t, and there is no damping. `no_history`: F_t = -min(gamma_t, mu |F_n|/|v_t|) v_t. "
	"`incremental_history`: as `history`, but the stored quantity is the spring force, changed by -k_t "
	"v_t dt with the present k_t (C. Thornton, S. J. Cummins, P. W. Cleary, Powder Technol. 210 (2011) "
	"189); for constant k_t both are the same. `jkr_tan`, for model jkr only: LAMMPS' `mindlin`, with a "
	"limit for spring plus dashpot. With model jkr the limit of friction is mu (F_e + 3 pi W R*), F_e "
	"the force without damping, as long as the surfaces adhere.\n\n"
	"`rolling_friction cdt`: torque mu_r k_n delta R* against the relative rotation; `epsd`, `epsd2`, "
	"`epsd3`: a rolling spring and dashpot, limited to mu_r |F_n| R*. `cohesion sjkr`: an attraction k "
	"A, A the area in which the spheres intersect; `sjkr2`: A = 4 pi delta R*. `bond`: bonds that "
	"transmit shear, bending and torsion and break, bond_style cohesion. `easo/...`, `washino/...`: "
	"liquid bridges (doc/bridges.md). `surface multicontact`: fix multicontact/halfspace.";

static const char edinburgh[] =
	"`model edinburgh`: elasto-plastic contacts with adhesion of cohesive powders (S. C. Thakur, J. P. "
	"Morrissey, J. Sun, J. F. Chen, J. Y. Ooi, Granul. Matter 16 (2014) 383). With the overlap d, its "
	"largest value d_max so far, k_2 = kappa k_1 and d_p^n = (1 - 1/kappa) d_max^n,\n\n"
	"    F = f_0 + k_1 d^n, unloading f_0 + k_2 (d^n - d_p^n), but not below f_0 - k_a d^chi\n\n"
	"k_1 = 4/3 Y* sqrt(R*), k_t = 8 G* sqrt(R* d); for n = 1 k_1 = 2 R* Y*, k_t = 2 Y* sqrt(R* d). k_a "
	"follows from the pull-off force 3/2 pi w a, a the radius of the circle in which the spheres "
	"intersect at d_p, at most k_2 d_p^n/2: where the branches meet. A contact that is loaded again "
	"from the last branch continues with the d_max that belongs to it. gamma = sqrt(4 m* k_1/(1 + "
	"(pi/ln e)^2)), with k_1 in SI units whatever n is: for n = 1.5 contacts of hard or small grains "
	"are overdamped unless e is near 1. A contact ends where the surfaces separate. f_0 > 0 repels, as "
	"in LIGGGHTS; coefficientAdhesionStiffness, which LIGGGHTS demands, has no effect there and is not "
	"read. Other than there particles adhere to walls, too, and rolling_friction cdt, epsd take k_1 "
	"d^n for k_1 d. limitForce, located and energies are refused.";

static const char usage[] =
	"These equations typeset, with assumptions, order and limits: doc/theory-contact.md, "
	"doc/theory-adhesion.md, doc/theory-rolling.md.\n\n"
	"The constants are defined by fix property/global. Per type: youngsModulus, poissonsRatio. Per pair "
	"of types: coefficientRestitution, coefficientFriction, coefficientRollingFriction, "
	"coefficientRollingViscousDamping (epsd, epsd3), cohesionEnergyDensity, workOfAdhesion (jkr; "
	"resolutionJKR has no effect), UnloadingStiffness kappa, surfaceEnergy w, pullOffForce f_0 "
	"(edinburgh), kn, kt, gamman, gammat (the stiffness laws; gamman_abs, gammat_abs "
	"with absolute_damping), contactModulus E_c and contactStiffnessRatio kappa (hooke/modulus), "
	"coefficientMaxElasticStiffness, coefficientAdhesionStiffness, coefficientPlasticityDepth "
	"(hysteresis), FluidViscosity, CriticalStokes, MaximumRestitution (viscous). One number: "
	"characteristicVelocity V (hooke), overlapExponent n and adhesionExponent chi (edinburgh), "
	"rollingStiffness (epsd3).\n\n"
	"An oblique impact gains no energy, except that the tangential spring of the Hertzian models "
	"stiffens with the overlap and releases early displacement with a larger stiffness: without "
	"dissipation (e = 1) up to some thousandths of the energy (hertz; more for hertz/stiffness, "
	"depending on kt/kn).\n\n"
	"`located yes`, sub-step contact detection: begin and end of contacts within a step are resolved, "
	"see pair_style spring/dashpot; for spring, hooke, hertz and their stiffness variants. Tangential "
	"damping and displacement are corrected alike; where a law is discontinuous - `history` drops its "
	"damping where sliding begins - convergence stays of first order. Walls with the law of the pair "
	"style use it, too.\n\n"
	"Equations, order of the words and defaults are those of LIGGGHTS 3.8, and results agree to "
	"round-off if the neighbour list is rebuilt between two contacts of a pair: LIGGGHTS keeps the "
	"history of an ended contact until then, here it ends with the contact, unless `legacy yes` is set.";

static const char *const doc_more[] = { other_laws, edinburgh, usage, NULL };

static const struct ts_arg_group groups[] = {
	TS_GRANULAR_GROUPS,
	{ "Tests of the program", "generic" },
	{ .words = NULL },
};

TS_STYLE(pair, ts_pair_style, ts_pair_gran)
const struct ts_pair_style ts_pair_gran = {
	.style = { .name = "gran",
		   .kind = TS_KIND_PAIR,
		   .ranks = TS_RANKS_OWN | TS_RANKS_ROWLESS,
		   .summary = "contact laws of granular materials",
		   .purpose =
			   "The contact law of most simulations of grains: stiffness and damping from the "
			   "properties of materials, friction, rolling resistance, cohesion. The properties "
			   "come from fix property/global or from `material`; `pair_coeff * *` follows.",
		   .doc = normal_laws,
		   .doc_more = doc_more,
		   .cite = "P. A. Cundall, O. D. L. Strack, Geotechnique 29 (1979) 47; Y. Tsuji, T. Tanaka, "
			   "T. Ishida, Powder Technol. 71 (1992) 239; J. Ai, J.-F. Chen, J. M. Rotter, J. Y. "
			   "Ooi, Powder Technol. 206 (2011) 269. Bridges of liquid: F. Soulie, F. Cherblanc, "
			   "M. S. El Youssoufi, C. Saix, Int. J. Numer. Anal. Methods Geomech. 30 (2006) "
			   "213; Y. I. Rabinovich, M. S. Esayanur, B. M. Moudgil, Langmuir 21 (2005) 10992; "
			   "G. Lian, C. Thornton, M. J. Adams, J. Colloid Interface Sci. 161 (1993) 138; D. "
			   "Shi, J. J. McCarthy, Powder Technol. 184 (2008) 64; S. T. Nase, W. L. Vargas, A. "
			   "A. Abatan, J. J. McCarthy, Powder Technol. 116 (2001) 214",
		   .example = "pair_style gran model hertz tangential history\n"
			      "pair_coeff * *",
		   .args = args,
		   .groups = groups,
		   .coeff = coeff,
		   .state_size = sizeof(struct gran),
		   .archive = archive,
		   .fingerprint = ts_pair_fingerprint,
		   .init = init,
		   .hook = { [TS_STAGE_INITIAL_INTEGRATE] = advance, [TS_STAGE_FORCE] = force },
		   .energy = ts_contact_energy_of_pairs,
		   .plan = plan,
		   .fini = ts_pair_fini },
	.coeff_size = sizeof(struct ts_granular_pair),
	.complete = complete,
	.chosen = chosen,
};
