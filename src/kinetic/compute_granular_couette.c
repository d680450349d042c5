/* Compute granular/couette: a film of grains between rough walls, by kinetic theory. */
#include <math.h>
#include <string.h>

#include "core/sim.h"
#include "kinetic/sheared_film.h"
#include "math/constants.h"

#include "base/banned.h"

/* Arguments that may be variables. */
enum number { GAP, SOLIDS, AMOUNT, SPEED, LOAD, NUMBERS };

struct state {
	struct ts_number number[NUMBERS];
	double diameter, density, restitution, friction, tangential, packing;
	double wall_restitution[2], roughness[2], bumpiness[2]; /* lower, upper wall; NaN: not given */
	double tolerance;
	int theory, radial, branch;
	int64_t points;
	bool count;

	struct tsim *sim;
	struct ts_sheared_film film;
	double solved_for[NUMBERS];
	bool solved, warned, told;
};

/* ---- arguments to film ---- */

static enum ts_status set_wall(struct ts_instance *self, struct state *s, int w)
{
	static const char *const names[] = { "lower", "upper" };
	struct ts_bumpy_wall *wall = &s->film.wall[w];
	int from = w && isnan(s->roughness[1]) && isnan(s->bumpiness[1]) ? 0 : w;

	if (isnan(s->roughness[from]) == isnan(s->bumpiness[from]))
		return ts_fail(&s->sim->error, TS_SYNTAX, &self->where,
			       "compute granular/couette: %s of roughness and bumpiness are given for the %s "
			       "wall, expected one of them",
			       isnan(s->roughness[from]) ? "none" : "both", names[w]);
	wall->half_angle =
		isnan(s->roughness[from]) ? s->bumpiness[from] * TS_PI / 180 : asin(s->roughness[from]);
	wall->restitution = s->wall_restitution[w && !isnan(s->wall_restitution[1])];
	return TS_OK;
}

static enum ts_status set_gas(struct ts_instance *self, struct state *s)
{
	double e = ts_gas_rough_restitution(s->restitution, s->friction, s->tangential);

	/* the friction of nearly elastic grains: the dissipation may not fall with it */
	if (!(e >= 0 && e <= s->restitution))
		return ts_fail(&s->sim->error, TS_RANGE, &self->where,
			       "compute granular/couette: friction %g gives the effective restitution %g, "
			       "out of 0 to restitution, %g: the theory is for small friction",
			       s->friction, e, s->restitution);
	s->film.gas = (struct ts_gas){ .theory = (enum ts_gas_theory)s->theory,
				       .radial = (enum ts_gas_radial)s->radial,
				       .restitution = e,
				       .packing = s->packing };
	return TS_OK;
}

static bool is_given(const struct ts_number *number)
{
	return number->variable || !number->null;
}

/* The numbers that may be variables; NaN: not given. */
static enum ts_status evaluate(struct ts_instance *self, struct state *s, double out[NUMBERS])
{
	for (int k = 0; k < NUMBERS; k++) {
		out[k] = NAN;
		if (!is_given(&s->number[k]))
			continue;
		TS_TRY(ts_number_now(s->sim, &s->number[k], &self->where, &out[k]));
		if (isnan(out[k])) {
			static const char *const names[] = { "gap", "solid_fraction", "amount", "speed",
							     "load" };

			return ts_fail(&s->sim->error, TS_RANGE, &self->where,
				       "compute granular/couette: %s is not a number", names[k]);
		}
	}
	return TS_OK;
}

static void set_numbers(struct state *s, const double number[NUMBERS])
{
	struct ts_sheared_film *f = &s->film;

	f->gap = number[GAP];
	f->solids = number[SOLIDS];
	f->amount = number[AMOUNT];
	f->speed = number[SPEED];
	f->load = number[LOAD];
	f->diameter = s->diameter;
	f->density = s->density;
	f->branch = (enum ts_sheared_branch)s->branch;
	f->points = (int)s->points;
	f->tolerance = s->tolerance;
	f->count = s->count;
}

/* Where grains hardly move they touch for long: forces of kinetic theory are those of collisions only. */
static void warn_of_rest(const struct ts_instance *self, struct state *s)
{
	if (s->warned || s->film.figures.coldest > 1e-6)
		return;
	s->warned = true;
	ts_warn(&s->sim->log, &self->where,
		"compute granular/couette: somewhere the granular temperature is only %.2g of its largest: "
		"the grains there are at rest, packed to the solid fraction %g, which kinetic theory does "
		"not describe",
		s->film.figures.coldest, s->film.figures.most);
}

static enum ts_status solve(struct ts_instance *self)
{
	struct state *s = self->state;
	double number[NUMBERS];

	TS_TRY(evaluate(self, s, number));
	if (s->solved && !memcmp(number, s->solved_for, sizeof number))
		return TS_OK;
	s->solved = false;
	set_numbers(s, number);
	TS_TRY(ts_sheared_film_solve(&s->film, &self->where, &s->sim->error));
	memcpy(s->solved_for, number, sizeof number);
	s->solved = true;
	warn_of_rest(self, s);
	return TS_OK;
}

/* Whether a compute of this style stands before this one in the script. */
static bool is_another(const struct ts_instance *self, const struct tsim *sim)
{
	const struct ts_instances *list = &sim->instances[TS_KIND_COMPUTE];

	for (size_t k = 0; k < list->n && list->item[k] != self; k++)
		if (list->item[k]->style == self->style)
			return true;
	return false;
}

/* -explain: what the theory leaves out, told by the first compute. */
static void explain(struct ts_instance *self, struct state *s, struct tsim *sim)
{
	if (!sim->reading.explain || sim->reading.check || s->told || is_another(self, sim))
		return;
	s->told = true;
	ts_log(&sim->log,
	       "\nCompute granular/couette:\n"
	       "  left out by kinetic theory: single grains and their layers at the walls, contacts that "
	       "last, collisions of more than two,\n"
	       "  correlations of velocities, gradients beyond the first, changes in time%s\n",
	       s->friction > 0 ? "" : ", friction of the grains");
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	bool constant = true;

	s->sim = sim;
	explain(self, s, sim);
	TS_TRY(set_gas(self, s));
	TS_TRY(set_wall(self, s, 0));
	TS_TRY(set_wall(self, s, 1));
	for (int k = 0; k < NUMBERS; k++)
		constant &= !s->number[k].variable;
	return constant ? solve(self) : TS_OK; /* so that errors are found where they are made */
}

/* ---- outputs ---- */

static const char *const figure_names[] = { "speed",	  "load",	"shear",      "traction",
					    "gap",	  "nu",		"slip_lower", "slip_upper",
					    "nu_centre",  "T_centre",	"nu_max",     "dissipation",
					    "loss_lower", "loss_upper", "imbalance",  "solutions",
					    "error",	  "iterations", "intervals" };
enum { FIGURES = sizeof figure_names / sizeof *figure_names };

static enum ts_status eval_figures(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct ts_sheared_film *f = &((struct state *)self->state)->film;
	const struct ts_couette_figures *g = &f->figures;

	(void)sim;
	TS_TRY(solve(self));
	memcpy(out->data,
	       (double[FIGURES]){ f->speed, f->load, g->traction * f->load, g->traction, f->gap, f->solids,
				  g->slip[0], g->slip[1], g->centre[0], g->centre[1], g->most, g->dissipation,
				  g->wall_loss[0], g->wall_loss[1], g->imbalance, f->solutions,
				  f->couette.error, f->couette.iterations, f->couette.n },
	       FIGURES * sizeof(double));
	return TS_OK;
}

static const char *const profile_names[] = { "y", "u", "nu", "T" };

static enum ts_status eval_profile(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	struct state *s = self->state;

	(void)sim;
	TS_TRY(solve(self));
	TS_TRY(ts_table_resize(out, (size_t)s->points, 4));
	if (ts_sheared_film_profile(&s->film, (double(*)[4])out->data) != TS_OK)
		return ts_nomem(&s->sim->error);
	return TS_OK;
}

static const struct ts_value values[] = {
	{ "figures", "", "stresses, slip, energies and how well they were found", TS_VECTOR, FIGURES,
	  figure_names, eval_figures },
	{ "profile", "length, velocity, -, velocity^2", "y, velocity, solid fraction, granular temperature",
	  TS_ARRAY, 4, profile_names, eval_profile },
	{ .name = NULL },
};

static void fini(struct ts_instance *self)
{
	ts_sheared_film_release(&((struct state *)self->state)->film);
}

/* ---- arguments ---- */

static const char *const theories[] = { "lun", "garzo/dufty", NULL };
static const char *const radials[] = { "lun/savage", "carnahan/starling", "torquato", NULL };
static const char *const branches[] = { "dense", "dilute", NULL };

static const struct ts_arg args[] = {
	TS_NUMBER("gap", struct state, number[GAP], .flags = TS_OPTIONAL, .unit = "length",
		  .help = "distance of the walls, at least 2 diameters; or v_NAME"),
	TS_NUMBER("solid_fraction", struct state, number[SOLIDS], .flags = TS_OPTIONAL,
		  .help = "mean over the gap, below `packing`; or v_NAME"),
	TS_NUMBER("amount", struct state, number[AMOUNT], .flags = TS_OPTIONAL, .unit = "length",
		  .help = "instead: volume of the grains over the area of a wall; or v_NAME"),
	TS_NUMBER("speed", struct state, number[SPEED], .flags = TS_OPTIONAL, .unit = "velocity",
		  .help = "of the lower wall; or v_NAME"),
	TS_NUMBER("load", struct state, number[LOAD], .flags = TS_OPTIONAL, .unit = "pressure",
		  .help = "normal stress on the walls; or v_NAME"),
	TS_REAL("diameter", struct state, diameter, .range = TS_POSITIVE, .unit = "length",
		.help = "of the grains"),
	TS_REAL("density", struct state, density, .range = TS_POSITIVE, .unit = "density",
		.help = "of the grains"),
	TS_REAL("restitution", struct state, restitution, .range = TS_FRACTION, .help = "of two grains"),
	TS_REAL("wall_restitution", struct state, wall_restitution[0], .range = TS_FRACTION,
		.help = "of grain and wall"),
	TS_REAL("roughness", struct state, roughness[0], .flags = TS_OPTIONAL, .range = TS_FRACTION,
		.help = "of the walls: sine of the half angle of their bumps"),
	TS_REAL("bumpiness", struct state, bumpiness[0], .flags = TS_OPTIONAL, .range = TS_WITHIN, .lo = 0,
		.hi = 90, .unit = "degrees", .help = "instead: half angle of their bumps"),
	TS_REAL("upper_wall_restitution", struct state, wall_restitution[1], .flags = TS_OPTIONAL,
		.range = TS_FRACTION, .help = "if that of the upper wall differs"),
	TS_REAL("upper_roughness", struct state, roughness[1], .flags = TS_OPTIONAL, .range = TS_FRACTION,
		.help = "if that of the upper wall differs"),
	TS_REAL("upper_bumpiness", struct state, bumpiness[1], .flags = TS_OPTIONAL, .range = TS_WITHIN,
		.lo = 0, .hi = 90, .unit = "degrees", .help = "if that of the upper wall differs"),
	TS_REAL("friction", struct state, friction, .fallback = "0", .range = TS_NOT_NEGATIVE,
		.help = "coefficient of two grains, small"),
	TS_REAL("tangential", struct state, tangential, .fallback = "0", .range = TS_WITHIN, .lo = -0.99,
		.hi = 1, .help = "restitution along the surface of contacts that stick"),
	TS_REAL("packing", struct state, packing, .fallback = "0.65", .range = TS_FRACTION,
		.help = "solid fraction at closest packing"),
	TS_ENUM("theory", struct state, theory, theories, .fallback = "lun", .help = "kinetic theory"),
	TS_ENUM("radial", struct state, radial, radials, .fallback = "lun/savage",
		.help = "radial distribution of grains in contact"),
	TS_ENUM("branch", struct state, branch, branches, .fallback = "dense",
		.help = "which solid fraction, if several carry the load"),
	TS_INT("points", struct state, points, .fallback = "41", .range = TS_WITHIN, .lo = 2, .hi = 10001,
	       .help = "number of points of the profile, from wall to wall"),
	TS_REAL("tolerance", struct state, tolerance, .fallback = "1e-8", .range = TS_WITHIN, .lo = 1e-11,
		.hi = 0.1, .help = "relative error of stresses, slip and centre"),
	TS_BOOL("count", struct state, count, .fallback = "yes", .help = "whether solutions are counted"),
	TS_ARGS_END,
};

static const char doc[] =
	"Steady flow of grains that fill the gap between two parallel rough walls, sheared by the motion of "
	"the lower one: profiles of velocity, solid fraction and granular temperature T = <C^2>/3, and the "
	"stresses, by the kinetic theory of inelastic spheres. It reads nothing of the simulation; no box or "
	"run is needed. There is no gravity, and nothing varies along the walls.\n\n"
	"Three of gap, solid_fraction (or amount), speed and load are given; the fourth is the result. For a "
	"load and a gap several solid fractions may be found (in wide gaps a dilute one, a dense one and one "
	"between): `branch` chooses one of the first two. An unknown gap is the narrowest that carries the "
	"load.\n\n"
	"Equations (N, S normal and shear stress, constant; rho, d density and diameter of the grains):\n\n"
	"  N = rho g1 T,  S = rho d g2 sqrt(T) |du/dy|\n"
	"  dq/dy = S |du/dy| - (rho/d) g5 T^1.5,  q = -rho d (g3 sqrt(T) dT/dy + g4 T^1.5 dnu/dy)\n\n"
	"with g1 to g5 functions of nu and the restitution: theory lun is that of Lun et al. (1984), for "
	"nearly elastic grains; garzo/dufty that of Garzo and Dufty (1999), for any restitution. Radial "
	"distribution at contact: lun/savage (1 - nu/packing)^(-2.5 packing); carnahan/starling (2 - nu)/(2 "
	"(1 - nu)^3); torquato the same up to freezing, nu = 0.49, then its value there times (packing - "
	"0.49)/(packing - nu).\n\n"
	"Walls are covered with spheres (Jenkins and Richman 1986; Richman 1988; leading order). With the "
	"half angle theta of the bumps and c = 2 (1 - cos theta)/sin^2 theta the slip is\n\n"
	"  u_s = sqrt(pi/2) f sqrt(T) S/N,  1/f = 2/3 (c - cos theta)\n\n"
	"and the flux of energy into the flow q = S u_s - sqrt(2/pi) (1 - e_w) c N sqrt(T). roughness is sin "
	"theta: near 0 walls are smooth, and hold less and less shear; at 1 a grain fits between two "
	"bumps.\n\n"
	"friction: the restitution is replaced by that of smooth grains with the same dissipation, for small "
	"friction (Jenkins and Zhang 2002; about e - pi mu/2 + 9 mu^2/2). Friction on the walls is not "
	"modelled.";

static const char *const doc_more[] = {
	"The vector:\n\n"
	"  1, 2      speed of the lower wall, load (normal stress)\n"
	"  3, 4      shear stress, traction coefficient (shear stress over load)\n"
	"  5, 6      gap, mean solid fraction\n"
	"  7, 8      slip velocity at the lower and upper wall\n"
	"  9, 10     solid fraction and granular temperature at half the gap\n"
	"  11        largest solid fraction\n"
	"  12        energy dissipated between grains, per area and time\n"
	"  13, 14    energy dissipated at the lower and upper wall, per area and time\n"
	"  15        |work of the walls - 12 - 13 - 14|/work: round-off\n"
	"  16        number of solutions found: profiles, for a given gap and solid fraction; solid "
	"fractions that carry the load, for a given load; 0 with `count no`\n"
	"  17        estimated relative error of 1 to 10\n"
	"  18, 19    iterations of Newton's method, intervals of the mesh\n\n"
	"The array has a row for each point of the profile, from the lower to the upper wall: y, velocity, "
	"solid fraction, T.",
	"Method: collocation of fourth order, Newton's method, continuation from narrow gaps; the mesh is "
	"refined until the estimated error is below `tolerance`; with radial torquato it has shorter "
	"intervals where nu passes 0.49, as nu' has a step there. If a mesh of about 65536 intervals is not "
	"fine enough the error is told. In gaps of more than about 10 diameters, of nearly elastic grains "
	"more, there may be further solutions, dense at one wall: 16 says so. The result is that which "
	"continues the only one of narrow gaps, symmetric if the walls are.",
	"Refused are: a mean solid fraction of `packing` or more; a gap below 2 diameters; smooth walls; "
	"elastic grains between elastic walls, which have no steady state; solid fractions that reach "
	"`packing` with carnahan/starling; wide gaps up to which the solution of narrow gaps does not "
	"continue. Where dissipative grains come to rest in the middle of a wide gap (T less than 1e-6 of "
	"that elsewhere) a warning is given: kinetic theory does not describe them.",
	"Related: compute film, doc/granular-film.md.", NULL
};

TS_STYLE(compute, ts_style, ts_compute_granular_couette)
const struct ts_style ts_compute_granular_couette = {
	.name = "granular/couette",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.summary = "Shear flow of grains between rough walls by kinetic theory: profiles, stresses, slip",
	.doc = doc,
	.doc_more = doc_more,
	.example = "compute film all granular/couette gap 4e-3 solid_fraction 0.4 speed 2 diameter 0.787e-3 "
		   "density 2550 restitution 0.85 wall_restitution 0.65 roughness 0.65\n"
		   "compute pad all granular/couette amount 2e-3 speed v_U load v_p diameter 0.787e-3 "
		   "density 2550 restitution 0.85 wall_restitution 0.65 bumpiness 40 theory garzo/dufty\n"
		   "print \"traction $(c_film[4]), slip $(c_film[7])\"\n"
		   "fix out all ave/time 1 1 1 c_film[*] mode vector file profile.txt",
	.cite = "C. K. K. Lun, S. B. Savage, D. J. Jeffrey, N. Chepurniy, J. Fluid Mech. 140 (1984) 223; J. "
		"T. Jenkins, M. W. Richman, J. Fluid Mech. 171 (1986) 53; M. W. Richman, Acta Mech. 75 "
		"(1988) 227; V. Garzo, J. W. Dufty, Phys. Rev. E 59 (1999) 5895; J. T. Jenkins, C. Zhang, "
		"Phys. Fluids 14 (2002) 1228",
	.args = args,
	.state_size = sizeof(struct state),
	.values = values,
	.boxless = true,
	.init = init,
	.fini = fini,
};
