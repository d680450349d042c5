#include "contact/gran_coeff.h"

#include <math.h>

#include "core/arg.h"
#include "law/lens.h"
#include "math/constants.h"

#include "base/banned.h"

/* ---- arguments ---- */

enum { HOOKE, HERTZ, MATERIAL, DMT, JKR };
#define NUMBER(name_, field, unit_, range_, help_)                                                          \
	TS_REAL(name_, struct ts_gran_coeff, field, .flags = TS_POSITIONAL, .unit = unit_, .range = range_, \
		.help = help_)
#define PREFACTOR                                                                                       \
	NUMBER("d", prefactor, "", TS_NOT_NEGATIVE,                                                     \
	       "damping prefactor, see `damping`; with tsuji and coeff_restitution the coefficient of " \
	       "restitution")
#define ELASTIC                                                                                  \
	NUMBER("E", stiffness, "pressure", TS_POSITIVE, "Young's modulus"), PREFACTOR,           \
		TS_REAL("nu", struct ts_gran_coeff, poisson, .flags = TS_POSITIONAL, .unit = "", \
			.range = TS_WITHIN, .lo = -1, .hi = 0.5, .help = "Poisson's ratio")
#define SURFACE NUMBER("w", surface_energy, "energy/length^2", TS_NOT_NEGATIVE, "surface energy per area")

static const struct ts_arg hooke_rows[] = {
	NUMBER("k", stiffness, "force/length", TS_NOT_NEGATIVE, "stiffness"),
	PREFACTOR,
	TS_ARGS_END,
};
static const struct ts_arg hertz_rows[] = {
	NUMBER("k", stiffness, "pressure", TS_NOT_NEGATIVE, "stiffness"),
	PREFACTOR,
	TS_ARGS_END,
};
static const struct ts_arg material_rows[] = { ELASTIC, TS_ARGS_END };
static const struct ts_arg surface_rows[] = { ELASTIC, SURFACE, TS_ARGS_END };
static const struct ts_mode normals[] = {
	[HOOKE] = { "hooke", "linear spring", hooke_rows },
	[HERTZ] = { "hertz", "Hertzian spring", hertz_rows },
	[MATERIAL] = { "hertz/material", "Hertzian spring of a material", material_rows },
	[DMT] = { "dmt", "hertz/material with constant attraction in contact", surface_rows },
	[JKR] = { "jkr", "adhesive contact (Johnson, Kendall, Roberts), attracts beyond the touch",
		  surface_rows },
	{ .name = NULL },
};
static const char *const dampings[] = { "velocity", "mass_velocity",	 "viscoelastic",
					"tsuji",    "coeff_restitution", NULL };

const struct ts_arg ts_gran_coeff_rows[] = {
	TS_MODE("normal", struct ts_gran_coeff, normal, normals, .help = "normal law"),
	TS_LIST_KEYWORD("tangential", struct ts_gran_coeff, tangential, .flags = TS_TO_KEYWORD,
			.help = "linear_nohistory x mu | linear_history k_t x mu | mindlin k_t x mu | "
				"mindlin_rescale ... | mindlin/force ... | mindlin_rescale/force ..."),
	TS_ENUM("damping", struct ts_gran_coeff, damping, dampings, .fallback = "viscoelastic",
		.help = "damping model"),
	TS_SOME_KEYWORD("rolling", struct ts_gran_coeff, rolling, 0,
			.help = "none | sds k gamma mu: rolling resistance"),
	TS_SOME_KEYWORD("twisting", struct ts_gran_coeff, twisting, 0,
			.help = "none | sds k gamma mu | marshall: twisting resistance"),
	TS_SOME_KEYWORD("heat", struct ts_gran_coeff, heat, 0, .help = "none; conduction: see fix heat/gran"),
	TS_FLAG("limit_damping", struct ts_gran_coeff, limit_damping, .help = "no attractive normal force"),
	TS_REAL("cutoff", struct ts_gran_coeff, cutoff, .flags = TS_OPTIONAL, .unit = "length",
		.help = "no effect: contacts are defined by the radii"),
	TS_ARGS_END,
};

/* ---- arguments of the sub-laws ---- */

/* Arguments of a tangential, rolling or twisting law; what the law does not have stays 0. */
struct parts {
	int kind;
	struct ts_number kt;
	double x, mu, k, gamma;
};
#define PART(name_, field, unit_, help_)                                                                     \
	TS_REAL(name_, struct parts, field, .flags = TS_POSITIONAL, .unit = unit_, .range = TS_NOT_NEGATIVE, \
		.help = help_)
#define PART_FRICTION                                                            \
	PART("x", x, "", "tangential damping, as a multiple of the normal one"), \
		PART("mu", mu, "", "coefficient of friction")

static const struct ts_arg nohistory_rows[] = { PART_FRICTION, TS_ARGS_END };
static const struct ts_arg linear_rows[] = {
	PART("k_t", k, "force/length", "tangential stiffness"),
	PART_FRICTION,
	TS_ARGS_END,
};
static const struct ts_arg mindlin_rows[] = {
	TS_NUMBER("k_t", struct parts, kt, .flags = TS_POSITIONAL | TS_NULLABLE, .range = TS_NOT_NEGATIVE,
		  .unit = "pressure", .help = "tangential stiffness; NULL: 8 G*"),
	PART_FRICTION,
	TS_ARGS_END,
};
static const struct ts_arg sds_rows[] = {
	PART("k", k, "", "stiffness"),
	PART("gamma", gamma, "", "dashpot"),
	PART("mu", mu, "", "friction"),
	TS_ARGS_END,
};
static const struct ts_mode tangentials[] = {
	{ "linear_nohistory", "dashpot", nohistory_rows },
	{ "linear_history", "spring and dashpot", linear_rows },
	{ "mindlin", "spring with a stiffness proportional to the contact radius", mindlin_rows },
	{ "mindlin_rescale", "the same; the displacement is rescaled when the contact radius shrinks",
	  mindlin_rows },
	{ "mindlin/force", "history of forces instead of displacements", mindlin_rows },
	{ "mindlin_rescale/force", "history of forces, rescaled when the contact radius shrinks",
	  mindlin_rows },
	{ .name = NULL },
};
static const int tangential_laws[] = {
	TS_TANGENTIAL_NO_HISTORY,      TS_TANGENTIAL_LINEAR,	    TS_TANGENTIAL_MINDLIN,
	TS_TANGENTIAL_MINDLIN_RESCALE, TS_TANGENTIAL_MINDLIN_FORCE, TS_TANGENTIAL_MINDLIN_RESCALE_FORCE,
};
static const struct ts_mode rollings[] = {
	{ "none", "none", NULL },
	{ "sds", "spring, dashpot and slider", sds_rows },
	{ .name = NULL },
};
static const struct ts_mode twistings[] = {
	[TS_TWISTING_OFF] = { "none", "none", NULL },
	[TS_TWISTING_SDS] = { "sds", "spring, dashpot and slider", sds_rows },
	[TS_TWISTING_MARSHALL] = { "marshall", "constants derived from the tangential law", NULL },
	{ .name = NULL },
};
#define PART_OF(modes, text)                                                         \
	{                                                                            \
		TS_MODE(text, struct parts, kind, modes, .help = "law"), TS_ARGS_END \
	}
static const struct ts_arg tangential_rows[] = PART_OF(tangentials, "tangential");
static const struct ts_arg rolling_rows[] = PART_OF(rollings, "rolling");
static const struct ts_arg twisting_rows[] = PART_OF(twistings, "twisting");

static enum ts_status read_parts(struct tsim *sim, const struct ts_arg *rows, struct ts_words words,
				 const struct ts_place *where, struct parts *out)
{
	struct ts_arena arena = { 0 };
	enum ts_status status = TS_OK;

	*out = (struct parts){ 0 };
	if (words.n)
		status = ts_args_parse(sim, "granular", rows, words, where, &arena, out);
	if (status == TS_OK && out->kt.variable)
		status = ts_number_now(sim, &out->kt, where, &out->kt.value);
	ts_arena_release(&arena);
	out->k = isnan(out->k) ? 0 : out->k;
	out->gamma = isnan(out->gamma) ? 0 : out->gamma;
	out->mu = isnan(out->mu) ? 0 : out->mu;
	return status;
}

/* ---- constants ---- */

/* Y* = 1/((1 - nu_a^2)/E_a + (1 - nu_b^2)/E_b) */
static double effective_young(const struct ts_gran_coeff *a, const struct ts_gran_coeff *b)
{
	return 1 /
	       ((1 - a->poisson * a->poisson) / a->stiffness + (1 - b->poisson * b->poisson) / b->stiffness);
}

/* G* = 1/(2(2 - nu_a)(1 + nu_a)/E_a + ...) */
static double effective_shear(const struct ts_gran_coeff *a, const struct ts_gran_coeff *b)
{
	return 1 / (2 * (2 - a->poisson) * (1 + a->poisson) / a->stiffness +
		    2 * (2 - b->poisson) * (1 + b->poisson) / b->stiffness);
}

static bool is_material(const struct ts_gran_coeff *c)
{
	return c->normal >= MATERIAL;
}

/* Damping prefactor for a coefficient of restitution e (Y. Tsuji et al., 1992; the polynomial as in LAMMPS).
 */
static double tsuji_damping(double e)
{
	static const double a[] = { 4.8218, -18.022, 27.467, -22.348, 11.087, -4.2783, 1.2728 };
	double sum = 0;

	for (int k = 0; k < 7; k++)
		sum = sum * e + a[k];
	return sum;
}

/* gamma_0, the prefactor of the normal damping. */
static double damping_prefactor(const struct ts_gran_coeff *c)
{
	double l = log(c->prefactor);

	if (c->damping == TS_DAMPING_TSUJI)
		return tsuji_damping(c->prefactor);
	if (c->damping == TS_DAMPING_RESTITUTION)
		return (c->normal == HOOKE ? 2 : sqrt(5)) * -l / sqrt(l * l + TS_PI * TS_PI);
	return c->prefactor;
}

static void set_normal(struct ts_gran_coeff *c)
{
	static const int laws[] = { TS_NORMAL_AREA_HOOKE, TS_NORMAL_AREA_HERTZ, TS_NORMAL_AREA_HERTZ,
				    TS_NORMAL_AREA_DMT, TS_NORMAL_AREA_JKR };

	c->model = (struct ts_granular_model){ .normal = laws[c->normal],
					       .damping = c->damping,
					       .full_slip = true,
					       .no_tension = c->limit_damping };
	c->law = (struct ts_granular_pair){
		.kn = is_material(c) ? 4.0 / 3 * effective_young(c, c) : c->stiffness,
		.gamman = damping_prefactor(c),
		.surface_energy = c->normal >= DMT ? c->surface_energy : 0,
	};
}

static enum ts_status set_tangential(struct tsim *sim, struct ts_gran_coeff *c, const struct ts_place *where)
{
	struct parts part;
	bool mindlin;

	TS_TRY(read_parts(sim, tangential_rows, c->tangential, where, &part));
	c->model.tangential = tangential_laws[part.kind];
	mindlin = c->model.tangential >= TS_TANGENTIAL_MINDLIN;
	c->stiffness_follows = mindlin && part.kt.null;
	c->law.kt = mindlin ? part.kt.value : part.k;
	c->law.gammat = part.x;
	c->law.friction = part.mu;
	if (!c->stiffness_follows)
		return TS_OK;
	c->law.kt = 8 * effective_shear(c, c);
	if (is_material(c))
		return TS_OK;
	return ts_fail(&sim->error, TS_SYNTAX, &c->tangential.word[1].place,
		       "granular: the tangential stiffness NULL needs a normal law with material constants: "
		       "hertz/material, dmt or jkr");
}

static enum ts_status set_rolling_and_twisting(struct tsim *sim, struct ts_gran_coeff *c,
					       const struct ts_place *where)
{
	struct parts part;

	TS_TRY(read_parts(sim, rolling_rows, c->rolling, where, &part));
	c->model.rolling = part.kind ? TS_ROLLING_SDS : TS_ROLLING_OFF;
	c->law.roll_stiffness = part.k;
	c->law.roll_damping = part.gamma;
	c->law.rolling_friction = part.mu;
	TS_TRY(read_parts(sim, twisting_rows, c->twisting, where, &part));
	c->model.twisting = part.kind;
	c->law.twist_stiffness = part.k;
	c->law.twist_damping = part.gamma;
	c->law.twist_friction = part.mu;
	return TS_OK;
}

static enum ts_status check_combination(struct tsim *sim, const struct ts_gran_coeff *c,
					const struct ts_place *where)
{
	bool restitution = c->damping == TS_DAMPING_RESTITUTION;

	if ((c->limit_damping || restitution) && c->normal >= DMT)
		return ts_fail(&sim->error, TS_SYNTAX, where,
			       "granular: %s does not go with %s, which attracts",
			       restitution ? "damping coeff_restitution" : "limit_damping",
			       normals[c->normal].name);
	if ((restitution && !(c->prefactor > 0 && c->prefactor <= 1)) ||
	    (c->damping == TS_DAMPING_TSUJI && !(c->prefactor >= 0 && c->prefactor <= 1)))
		return ts_fail(&sim->error, TS_RANGE, where,
			       "granular: with `damping %s` the damping of `%s` is a coefficient of "
			       "restitution, %g, expected a number %s 0 and <= 1",
			       restitution ? "coeff_restitution" : "tsuji", normals[c->normal].name,
			       c->prefactor, restitution ? ">" : ">=");
	if (c->heat.n && !(c->heat.n == 1 && ts_streq(c->heat.word[0].text, "none")))
		return ts_fail(&sim->error, TS_STATE, &c->heat.word[0].place,
			       "granular: heat %s is not supported: use fix heat/gran for conduction through "
			       "contacts",
			       c->heat.word[0].text);
	return TS_OK;
}

enum ts_status ts_gran_coeff_complete(struct tsim *sim, void *coeff, const struct ts_place *where)
{
	struct ts_gran_coeff *c = coeff;

	TS_TRY(check_combination(sim, c, where));
	set_normal(c);
	TS_TRY(set_tangential(sim, c, where));
	TS_TRY(set_rolling_and_twisting(sim, c, where));
	if (c->model.twisting != TS_TWISTING_MARSHALL || c->model.tangential != TS_TANGENTIAL_NO_HISTORY)
		return TS_OK;
	return ts_fail(&sim->error, TS_SYNTAX, &c->twisting.word[0].place,
		       "granular: twisting marshall derives its spring from the tangential law, and "
		       "linear_nohistory has none");
}

void ts_gran_coeff_legacy_wall(struct ts_gran_coeff *c)
{
	double nu = c->poisson;

	if (is_material(c))
		c->law.kn = 4.0 / 3 * c->stiffness / (2 * (1 - nu));
	if (c->stiffness_follows)
		c->law.kt = c->stiffness * (2 - nu) * (1 + nu) / 4;
}

bool ts_gran_coeff_alike(const struct ts_gran_coeff *a, const struct ts_gran_coeff *b)
{
	const struct ts_granular_model *m = &a->model, *n = &b->model;

	return a->normal == b->normal && m->damping == n->damping && m->tangential == n->tangential &&
	       m->rolling == n->rolling && m->twisting == n->twisting && m->no_tension == n->no_tension;
}

/* Geometric means, except for the elastic constants of materials. */
void ts_gran_coeff_mix(const struct ts_gran_coeff *a, const struct ts_gran_coeff *b,
		       struct ts_gran_coeff *out)
{
	const struct ts_granular_pair *p = &a->law, *q = &b->law;

	*out = *a;
#define MEAN(field) out->law.field = sqrt(p->field * q->field)
	MEAN(kn);
	MEAN(kt);
	MEAN(gamman);
	MEAN(gammat);
	MEAN(friction);
	MEAN(surface_energy);
	MEAN(roll_stiffness);
	MEAN(roll_damping);
	MEAN(rolling_friction);
	MEAN(twist_stiffness);
	MEAN(twist_damping);
	MEAN(twist_friction);
#undef MEAN
	if (is_material(a))
		out->law.kn = 4.0 / 3 * effective_young(a, b);
	if (a->stiffness_follows && b->stiffness_follows)
		out->law.kt = 8 * effective_shear(a, b);
}
