/* Compute granular/shear: uniform shear flow of a granular gas, by kinetic theory. */
#include <math.h>
#include <string.h>

#include "core/sim.h"
#include "kinetic/granular_shear.h"
#include "math/constants.h"

#include "base/banned.h"

/* Arguments that may be variables. */
enum number { SOLIDS, RATE, DIAMETER, NUMBERS };

struct state {
	struct ts_number number[NUMBERS];
	double density, restitution, packing;
	int radial;

	struct tsim *sim;
	struct ts_granular_shear flow;
	double solved_for[NUMBERS];
	bool solved;
};

static enum ts_status evaluate(struct ts_instance *self, struct state *s, double out[NUMBERS])
{
	static const char *const names[] = { "solid_fraction", "shear_rate", "diameter" };

	for (int k = 0; k < NUMBERS; k++) {
		TS_TRY(ts_number_now(s->sim, &s->number[k], &self->where, &out[k]));
		if (!(out[k] > 0) || isinf(out[k]))
			return ts_fail(&s->sim->error, TS_RANGE, &self->where,
				       "compute granular/shear: %s %g, expected > 0", names[k], out[k]);
	}
	return TS_OK;
}

static enum ts_status check(struct ts_instance *self, struct state *s, double solids)
{
	double limit = ts_gas_limit(&s->flow.gas);

	if (s->restitution == 1)
		return ts_fail(&s->sim->error, TS_RANGE, &self->where,
			       "compute granular/shear: restitution 1: there is no steady state, since "
			       "elastic grains dissipate nothing");
	if (s->radial == TS_GAS_TORQUATO && !(s->packing > TS_GAS_FREEZING))
		return ts_fail(&s->sim->error, TS_RANGE, &self->where,
			       "compute granular/shear: packing %g, expected more than the solid fraction at "
			       "freezing, %g",
			       s->packing, TS_GAS_FREEZING);
	/* carnahan/starling is finite above the closest packing, but means nothing there */
	if (!(solids < fmin(limit, s->packing)))
		return ts_fail(&s->sim->error, TS_RANGE, &self->where,
			       "compute granular/shear: solid_fraction %g, expected less than that at "
			       "closest packing, %g (`packing`)",
			       solids, s->packing);
	return TS_OK;
}

static enum ts_status solve(struct ts_instance *self)
{
	struct state *s = self->state;
	double number[NUMBERS];
	enum ts_status status;

	TS_TRY(evaluate(self, s, number));
	if (s->solved && !memcmp(number, s->solved_for, sizeof number))
		return TS_OK;
	s->solved = false;
	s->flow.gas = (struct ts_gas){ .radial = (enum ts_gas_radial)s->radial,
				       .restitution = s->restitution,
				       .packing = s->packing };
	TS_TRY(check(self, s, number[SOLIDS]));
	s->flow.solids = number[SOLIDS];
	status = ts_granular_shear_solve(&s->flow);
	if (status == TS_NOMEM)
		return ts_nomem(&s->sim->error);
	if (status != TS_OK)
		return ts_fail(&s->sim->error, status, &self->where,
			       "compute granular/shear: no solution was found for the solid fraction %g and "
			       "the restitution %g",
			       number[SOLIDS], s->restitution);
	memcpy(s->solved_for, number, sizeof number);
	s->solved = true;
	return TS_OK;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	bool constant = true;

	s->sim = sim;
	for (int k = 0; k < NUMBERS; k++)
		constant &= !s->number[k].variable;
	return constant ? solve(self) : TS_OK; /* so that errors are found where they are made */
}

/* ---- outputs ---- */

static const char *const names[] = { "T",	   "Kxx/T",	"Kyy/T",    "Kzz/T",	    "Kxy/T",
				     "pressure",   "shear",	"traction", "N1/p",	    "N2/p",
				     "Pxx",	   "Pyy",	"Pzz",	    "kinetic",	    "dissipation",
				     "collisions", "imbalance", "T_lun",    "T_garzo_dufty" };
enum { FIGURES = sizeof names / sizeof *names };

static double theory(const struct ts_granular_shear *f, enum ts_gas_theory theory)
{
	struct ts_gas gas = f->gas;

	gas.theory = theory;
	return ts_gas_sheared_temperature(&gas, f->solids);
}

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	struct state *s = self->state;
	const struct ts_granular_shear *f = &s->flow;
	const double *k = f->moment, *p = f->stress;
	double t = f->temperature, pressure, rate, square, stress;

	(void)sim;
	TS_TRY(solve(self));
	t = f->temperature;
	pressure = (p[TS_SHEAR_XX] + p[TS_SHEAR_YY] + p[TS_SHEAR_ZZ]) / 3;
	rate = s->solved_for[RATE];
	square = s->solved_for[DIAMETER] * s->solved_for[DIAMETER] * rate * rate;
	stress = s->density * square;
	memcpy(out->data,
	       (double[FIGURES]){ t * square, k[TS_SHEAR_XX] / t, k[TS_SHEAR_YY] / t, k[TS_SHEAR_ZZ] / t,
				  k[TS_SHEAR_XY] / t, pressure * stress, -p[TS_SHEAR_XY] * stress,
				  -p[TS_SHEAR_XY] / pressure, (p[TS_SHEAR_XX] - p[TS_SHEAR_YY]) / pressure,
				  (p[TS_SHEAR_YY] - p[TS_SHEAR_ZZ]) / pressure, p[TS_SHEAR_XX] * stress,
				  p[TS_SHEAR_YY] * stress, p[TS_SHEAR_ZZ] * stress, f->solids * t / pressure,
				  f->collisions.dissipation * stress * rate, f->collisions.rate * rate,
				  f->imbalance, theory(f, TS_GAS_LUN) * square,
				  theory(f, TS_GAS_GARZO_DUFTY) * square },
	       FIGURES * sizeof(double));
	return TS_OK;
}

static const struct ts_value values[] = {
	{ "flow", "", "granular temperature, stresses, dissipation", TS_VECTOR, FIGURES, names, eval },
	{ .name = NULL },
};

/* ---- arguments ---- */

static const char *const radials[] = { "lun/savage", "carnahan/starling", "torquato", NULL };

static const struct ts_arg args[] = {
	TS_NUMBER("solid_fraction", struct state, number[SOLIDS], .help = "below `packing`; or v_NAME"),
	TS_NUMBER("shear_rate", struct state, number[RATE], .unit = "1/time", .help = "du/dy > 0; or v_NAME"),
	TS_NUMBER("diameter", struct state, number[DIAMETER], .unit = "length",
		  .help = "of the grains; or v_NAME"),
	TS_REAL("density", struct state, density, .range = TS_POSITIVE, .unit = "density",
		.help = "of the grains"),
	TS_REAL("restitution", struct state, restitution, .range = TS_FRACTION,
		.help = "of two grains, below 1"),
	TS_ENUM("radial", struct state, radial, radials, .fallback = "carnahan/starling",
		.help = "radial distribution of grains in contact"),
	TS_REAL("packing", struct state, packing, .fallback = "0.64", .range = TS_FRACTION,
		.help = "solid fraction at closest packing"),
	TS_ARGS_END,
};

static const char doc[] =
	"Steady uniform shear flow of smooth inelastic spheres, u = shear_rate y along x, by the Enskog "
	"equation: granular temperature T = <C^2>/3, its anisotropy, stresses with their normal differences, "
	"dissipation. It reads nothing of the simulation; no box or run is needed. It is what a box under "
	"fix deform xy is compared with (examples/film/in.sheared_gas).\n\n"
	"In this flow the shear rate is set by the restitution, (d u')^2/T is of the order of 1 - e^2, so "
	"that the equations of Navier-Stokes order (compute granular/couette, T = g2/g5 (d u')^2) hold for "
	"nearly elastic grains only. Here the peculiar velocities C have an anisotropic Gaussian "
	"distribution with the second moment K = <C C>, the solution of its balance (Jenkins and Richman "
	"1988; Chou and Richman 1998)\n\n"
	"  u' (delta_ix K_jy + delta_jx K_iy) = source of collisions S_ij(K, u', nu, e)\n\n"
	"whose integrals over collisions are computed without an expansion in u' or in the anisotropy; the "
	"mean velocity difference over a diameter is part of the collisions. T differs from a Monte Carlo "
	"solution of the same Enskog equation by less than 1.5 % for e >= 0.8. What the Enskog equation "
	"leaves out are correlations of velocities: above nu = 0.4 they matter.\n\n"
	"radial: distribution at contact; carnahan/starling (2 - nu)/(2 (1 - nu)^3); torquato the same up to "
	"freezing, nu = 0.49, then its value there times (packing - 0.49)/(packing - nu); lun/savage (1 - "
	"nu/packing)^(-2.5 packing).";

static const char *const doc_more[] = {
	"The vector:\n\n"
	"  1         granular temperature T\n"
	"  2 to 5    K_xx/T, K_yy/T, K_zz/T, K_xy/T\n"
	"  6, 7      pressure p = tr(P)/3, shear stress -P_xy\n"
	"  8         -P_xy/p\n"
	"  9, 10     normal stress differences (P_xx - P_yy)/p, (P_yy - P_zz)/p\n"
	"  11 to 13  normal stresses P_xx, P_yy, P_zz\n"
	"  14        kinetic part of p, by p\n"
	"  15        energy dissipated, per volume and time\n"
	"  16        collisions of a grain, per time\n"
	"  17        |work - dissipation|/work: round-off\n"
	"  18, 19    T of Navier-Stokes order, g2/g5 (d u')^2, by Lun et al. (1984) and by Garzo and Dufty "
	"(1999)",
	"Refused are elastic grains, which have no steady state, and solid fractions of `packing` or more.",
	"Related: compute granular/couette, fix deform, compute temp/granular, doc/granular-film.md.", NULL
};

TS_STYLE(compute, ts_style, ts_compute_granular_shear)
const struct ts_style ts_compute_granular_shear = {
	.name = "granular/shear",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.summary =
		"Uniform shear flow of grains by kinetic theory: temperature, stresses, normal differences",
	.doc = doc,
	.doc_more = doc_more,
	.example = "compute t all granular/shear solid_fraction 0.2 shear_rate 100 diameter 1e-3 density "
		   "2550 restitution 0.9\n"
		   "print \"T $(c_t[1]), N1/p $(c_t[9])\"",
	.cite = "J. T. Jenkins, M. W. Richman, J. Fluid Mech. 192 (1988) 313; C.-S. Chou, M. W. Richman, "
		"Physica A 259 (1998) 430; J. F. Lutsko, Phys. Rev. E 70 (2004) 061101; V. Garzo, J. W. "
		"Dufty, Phys. Rev. E 59 (1999) 5895",
	.args = args,
	.state_size = sizeof(struct state),
	.values = values,
	.boxless = true,
	.init = init,
};
