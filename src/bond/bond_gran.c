#include <math.h>

#include "bond/bond_arguments.h"
#include "bond/bond_force.h"
#include "bond/bond_moment.h"
#include "contact/contact_energy.h"
#include "law/bond_section.h"
#include "particle/copies.h"
#include "particle/particles.h"

#include "base/banned.h"

struct gran_bond {
	struct ts_bond bond;
};

enum { DAMP_NONE, DAMP_LINEAR, DAMP_NONLINEAR };
enum { BREAK_DISTANCE, BREAK_STRESS, BREAK_TEMPERATURE, BREAK_SOFT, BREAK_SOFT_HERTZ, BREAK_SOFT_STRESS };

struct coeff {
	double ro, ri, modulus, shear_modulus;
	int damp_style, break_style;
	double damping, nonlinear[3]; /* the second is refused */
	double r_break, sigma, tau, temperature;
};

static enum ts_status complete(struct tsim *sim, void *coeff, const struct ts_place *where)
{
	const struct coeff *c = coeff;

	if (!(c->ri < c->ro))
		return ts_fail(&sim->error, TS_RANGE, where,
			       "bond_coeff: the inner radius ri is %g, expected less than the outer radius "
			       "ro, %g",
			       c->ri, c->ro);
	if (c->damp_style == DAMP_NONLINEAR)
		return ts_fail(&sim->error, TS_STATE, where,
			       "bond_coeff: nonlinear damping depends on the time step and is not supported; "
			       "use damp style 1");
	if (c->break_style > BREAK_TEMPERATURE)
		return ts_fail(&sim->error, TS_STATE, where,
			       "bond_coeff: break style %d is not supported; use 0 (distance), 1 (stress) or "
			       "2 (stress and temperature)",
			       c->break_style);
	return TS_OK;
}

static void element(const void *coeff, const struct ts_bond_pair *pair, struct ts_bond_element *e)
{
	const struct coeff *c = coeff;
	const double r = fmin(pair->radius[0], pair->radius[1]), ro = c->ro * r, ri = c->ri * r,
		     l = pair->rest;
	const double area = TS_PI * (ro * ro - ri * ri), polar = TS_PI / 2 * (pow(ro, 4) - pow(ri, 4));
	const double ratio = c->damp_style == DAMP_LINEAR ? c->damping : 0;

	e->fraction = ts_bond_fraction(l, pair->radius);
	e->k[TS_BOND_NORMAL] = c->modulus * area / l;
	e->k[TS_BOND_SHEAR] = c->shear_modulus * area / l;
	e->k[TS_BOND_BENDING] = c->modulus * polar / 2 / l;
	e->k[TS_BOND_TWIST] = c->shear_modulus * polar / l;
	ts_bond_section_damping((const double[]){ ratio, ratio, ratio, ratio }, pair->mass, pair->inertia, e);
	e->per_area = 1 / area;
	if (c->break_style == BREAK_DISTANCE) {
		/* the stress at the distance 2 r_break */
		e->tension = c->modulus * (2 * c->r_break - l) / l;
		return;
	}
	e->per_moment = 2 * (ro - ri) / polar;
	e->per_torque = (ro - ri) / polar;
	e->tension = e->compression = c->sigma;
	e->shear = c->tau;
}

static bool damped(const void *coeff)
{
	const struct coeff *c = coeff;

	return c->damp_style == DAMP_LINEAR && c->damping > 0;
}

/* ---- breakage by temperature */

static bool any_by_temperature(const struct ts_bond *bond)
{
	for (size_t t = 1; t < bond->coeffs.n; t++)
		if (bond->coeffs.given[t] &&
		    ((const struct coeff *)ts_coeff(&bond->coeffs, t))->break_style == BREAK_TEMPERATURE)
			return true;
	return false;
}

/* The column of fix heat/gran; NULL: there is none. */
static const double *temperatures(const struct tsim *sim)
{
	const struct ts_particles *p = sim->particles;

	for (size_t k = TS_NCOLUMN_BUILTIN; k < p->ncolumns; k++)
		if (p->column[k].width == 1 && ts_streq(p->column[k].name, "Temp"))
			return p->column[k].data;
	return NULL;
}

/* Breaks bonds whose particles have a mean temperature above the critical one. */
static enum ts_status break_hot_bonds(const struct ts_bond *bond, struct tsim *sim)
{
	struct ts_bonds *b = sim->bonds;
	const double *temperature = temperatures(sim);
	bool any = false;

	for (size_t k = 0; temperature && k < b->n; k++) {
		const struct coeff *c = ts_coeff(&bond->coeffs, (size_t)b->type[k]);
		double mean = 0.5 * (temperature[b->row[k][0]] + temperature[b->row[k][1]]);

		if (c->break_style != BREAK_TEMPERATURE || !(mean > c->temperature))
			continue;
		b->breaks[k] = TS_BOND_BREAKS_BY(TS_BOND_HEATED);
		any = true;
	}
	return any ? ts_bonds_break(sim) : TS_OK;
}

static enum ts_status post_integrate(struct ts_instance *self, struct tsim *sim)
{
	const struct gran_bond *s = self->state;

	TS_TRY(ts_bond_turn(self, sim));
	if (!any_by_temperature(&s->bond))
		return TS_OK;
	ts_copies_forward(sim); /* temperatures of partners on other ranks */
	return break_hot_bonds(&s->bond, sim);
}

static enum ts_status allow(struct ts_instance *self, struct tsim *sim)
{
	const struct gran_bond *s = self->state;

	if (sim->bonds->n && any_by_temperature(&s->bond) && !temperatures(sim))
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "bond_style gran: break style 2 needs the temperatures of `fix ID all "
			       "heat/gran initial_temperature T`");
	return TS_OK;
}

/* ---- arguments */

#define NUMBER(name, field, of, text)                                                                    \
	TS_REAL(name, struct coeff, field, .flags = TS_POSITIONAL, .range = TS_NOT_NEGATIVE, .unit = of, \
		.help = text)
#define STRENGTHS                                              \
	NUMBER("sigma", sigma, "pressure", "normal strength"), \
		NUMBER("tau", tau, "pressure", "shear strength")

static const struct ts_arg distance_rows[] = {
	NUMBER("r_break", r_break, "length", "the bond breaks at the distance 2 r_break"), TS_ARGS_END
};
static const struct ts_arg stress_rows[] = { STRENGTHS, TS_ARGS_END };
static const struct ts_arg temperature_rows[] = {
	STRENGTHS, NUMBER("T", temperature, "temperature", "largest mean temperature"), TS_ARGS_END
};
static const struct ts_arg refused_rows[] = { STRENGTHS, NUMBER("T", temperature, "temperature", "refused"),
					      TS_ARGS_END };
static const struct ts_mode break_modes[] = {
	[BREAK_DISTANCE] = { "0", "by the distance", distance_rows },
	[BREAK_STRESS] = { "1", "by the largest stress", stress_rows },
	[BREAK_TEMPERATURE] = { "2", "by the largest stress, or by temperature", temperature_rows },
	[BREAK_SOFT] = { "3", "refused", refused_rows },
	[BREAK_SOFT_HERTZ] = { "4", "refused", stress_rows },
	[BREAK_SOFT_STRESS] = { "5", "refused", stress_rows },
	{ .name = NULL },
};
#define BREAK TS_MODE("break_style", struct coeff, break_style, break_modes, .help = "when the bond breaks")

static const struct ts_arg none_rows[] = { NUMBER("damp", damping, "", "no effect"), BREAK, TS_ARGS_END };
static const struct ts_arg linear_rows[] = {
	NUMBER("damp", damping, "", "fraction of the critical damping, all modes"), BREAK, TS_ARGS_END
};
static const struct ts_arg nonlinear_rows[] = { NUMBER("damp1", nonlinear[0], "", "refused"),
						NUMBER("damp2", nonlinear[1], "", "refused"),
						NUMBER("damp3", nonlinear[2], "", "refused"), BREAK,
						TS_ARGS_END };
static const struct ts_mode damp_modes[] = {
	[DAMP_NONE] = { "0", "no damping", none_rows },
	[DAMP_LINEAR] = { "1", "dashpots", linear_rows },
	[DAMP_NONLINEAR] = { "2", "refused: nonlinear", nonlinear_rows },
	{ .name = NULL },
};

static const struct ts_arg coeff_rows[] = {
	TS_REAL("ro", struct coeff, ro, .flags = TS_POSITIONAL, .range = TS_POSITIVE, .unit = "",
		.help = "outer radius divided by the smaller radius of the two particles"),
	NUMBER("ri", ri, "", "inner radius divided by the same; below ro"),
	TS_REAL("Y", struct coeff, modulus, .flags = TS_POSITIONAL, .range = TS_POSITIVE, .unit = "pressure",
		.help = "Young's modulus of the bond"),
	TS_REAL("G", struct coeff, shear_modulus, .flags = TS_POSITIONAL, .range = TS_POSITIVE,
		.unit = "pressure", .help = "shear modulus of the bond"),
	TS_MODE("damp_style", struct coeff, damp_style, damp_modes, .help = "damping"),
	TS_ARGS_END,
};

static const char *const more[] = {
	"Compared with the documentation of LIGGGHTS Flexible Fibers "
	"(github.com/schrummy14/LIGGGHTS_Flexible_Fibers, doc/wiki/bond_gran.md), not with the program: "
	"order and meaning of the arguments, stiffnesses, linear damping, break styles 0, 1 and 2. Forces "
	"are in total form, as those of bond parallel, where LIGGGHTS adds up increments. The section is "
	"midway between the surfaces, so that spheres that overlap bend about the middle of the bond; "
	"LIGGGHTS takes the slip at the surfaces. Not supported: nonlinear damping, whose formula the "
	"documentation has as an image only, break styles 3 to 5, whose bonds repel after they have broken, "
	"and the arguments of LIGGGHTS-PFM and of richti83/LIGGGHTS-WITH-BONDS, which have other numbers in "
	"another order. create_bonds creates the bonds.",
	TS_BOND_MOMENT_DOC, NULL
};

TS_STYLE(bond, ts_bond_style, ts_bond_gran)
const struct ts_bond_style ts_bond_gran = {
	.style = { .name = "gran",
		   .kind = TS_KIND_BOND,
		   .ranks = TS_RANKS_OWN,
		   .summary = "bond with shear, bending and torsion, with the arguments of LIGGGHTS Flexible "
			      "Fibers",
		   .doc = "The bond of LIGGGHTS for flexible fibres, for its scripts; bond parallel and beam "
			  "say the same by keywords. The section is a ring of outer and inner radius r_o, "
			  "r_i, with A = pi (r_o^2 - r_i^2) and J = pi/2 (r_o^4 - r_i^4):\n\n"
			  "  k_n = Y A/L,   k_s = G A/L,   k_t = G J/L,   k_b = Y J/(2 L)\n\n"
			  "with the length L at creation. damp_style 1 are dashpots 2 damp sqrt(k m*) with "
			  "the reduced mass, or moment of inertia. break_style 0: the bond breaks when the "
			  "centres are farther apart than 2 r_break. break_style 1: when |N|/A + 2 M (r_o - "
			  "r_i)/J reaches sigma, or V/A + |M_t| (r_o - r_i)/J reaches tau. break_style 2: "
			  "the same, and when the mean temperature of the two particles (fix heat/gran) "
			  "exceeds T; it is compared at the begin of each step, before the forces.",
		   .doc_more = more,
		   .example = "bond_style gran\n"
			      "bond_coeff 1 1.0 0.0 1.5e9 1.0e9 1 0.1 1 1.5e6 1.0e6\n"
			      "create_bonds many all all 1 0 1.05e-3",
		   .cite = "Y. Guo et al., Powder Technol. 249 (2013) 386; M. Schramm, M. Z. Tekeste, C. "
			   "Plouffe, D. Harby, Biosyst. Eng. 186 (2019) 349",
		   .coeff = coeff_rows,
		   .state_size = sizeof(struct gran_bond),
		   .archive = ts_bond_archive,
		   .fingerprint = ts_bond_fingerprint,
		   .init = ts_bond_init,
		   .hook = { [TS_STAGE_POST_INTEGRATE] = post_integrate, [TS_STAGE_FORCE] = ts_bond_force },
		   .energy = ts_contact_energy_of_bonds,
		   .plan = ts_bond_plan,
		   .fini = ts_bond_fini },
	.allow = allow,
	.coeff_size = sizeof(struct coeff),
	.complete = complete,
	.compute = ts_bond_compute_moments,
	.damped = damped,
	.element = element,
};
