#include "contact/materials.h"

#include <math.h>

#include "core/units.h"
#include "law/granular_force.h"
#include "material/property.h"
#include "math/constants.h"

#include "base/banned.h"

struct ts_granular_model ts_contact_model_of_words(const struct tsim *sim, const struct ts_granular_words *w)
{
	bool sticks = w->normal == TS_WORD_JKR;

	return (struct ts_granular_model){
		.normal = sticks ? TS_NORMAL_AREA_JKR : w->normal,
		.damping = sticks ? TS_DAMPING_RESTITUTION : TS_DAMPING_VELOCITY,
		.tangential = w->tangential == TS_WORD_JKR_TAN ? TS_TANGENTIAL_MINDLIN : w->tangential,
		.rolling = w->rolling,
		.cohesion = w->cohesion == TS_WORD_BOND ? TS_COHESION_OFF : w->cohesion,
		.no_tension = w->limit_force,
		.no_tangential_damping = !w->tangential_damping,
		.absolute_damping = w->absolute_damping,
		.tangential_stiffness_2_7 = w->kt_to_kn,
		.viscous = w->viscous,
		.reduce = w->reduce,
		.shares = w->modify_share,
		.torsion = w->torsion,
		.located = w->located,
		.multi = w->surface == TS_SURFACE_MULTICONTACT,
		.plane = sim->dimension == 2,
	};
}

/* Bits of the laws that need a property. */
enum needs {
	ELASTIC = 1,
	STIFFNESS = 2,
	STIFFNESS_DAMPING = 4,
	ABSOLUTE_DAMPING = 8,
	VELOCITY = 16,
	RESTITUTION = 32,
	VISCOUS = 64,
	HYSTERESIS = 128,
	FRICTION = 256,
	ROLLING = 512,
	ROLLING_DASHPOT = 1024,
	ROLLING_STIFFNESS = 2048,
	COHESION = 4096,
	ADHESION = 8192,
	BRIDGES = 16384,
	BRIDGE_SHARE = 32768,
	MODULUS = 65536,
	EDINBURGH = 131072
};

static unsigned needs_of(const struct ts_granular_model *m)
{
	static const unsigned normal[TS_NNORMAL] = {
		[TS_NORMAL_HOOKE] = ELASTIC | VELOCITY,
		[TS_NORMAL_HERTZ] = ELASTIC | RESTITUTION,
		[TS_NORMAL_HOOKE_STIFFNESS] = STIFFNESS,
		[TS_NORMAL_HOOKE_MODULUS] = MODULUS | RESTITUTION,
		[TS_NORMAL_HERTZ_STIFFNESS] = STIFFNESS | STIFFNESS_DAMPING,
		[TS_NORMAL_HOOKE_HYSTERESIS] = ELASTIC | VELOCITY | HYSTERESIS,
		[TS_NORMAL_EDINBURGH] = ELASTIC | RESTITUTION | EDINBURGH,
		[TS_NORMAL_AREA_JKR] = ELASTIC | RESTITUTION | ADHESION,
	};
	unsigned needs = normal[m->normal];

	if (m->normal == TS_NORMAL_HOOKE_STIFFNESS)
		needs |= m->absolute_damping ? ABSOLUTE_DAMPING : STIFFNESS_DAMPING;
	if (needs & VELOCITY)
		needs |= m->viscous ? VISCOUS : RESTITUTION;
	if (m->tangential)
		needs |= FRICTION;
	if (m->rolling)
		needs |= ROLLING;
	if (m->rolling == TS_ROLLING_EPSD || m->rolling == TS_ROLLING_EPSD3)
		needs |= ROLLING_DASHPOT;
	if (m->rolling == TS_ROLLING_EPSD3)
		needs |= ROLLING_STIFFNESS;
	if (ts_cohesion_bridges(m))
		needs |= BRIDGES;
	else if (m->cohesion)
		needs |= COHESION;
	if (m->shares)
		needs |= BRIDGE_SHARE;
	return needs;
}

/* lo <= value <= hi, or lo < value where `above` is set. */
struct bounds {
	double lo, hi;
	bool above;
};
#define POSITIVE                  \
	{                         \
		0, INFINITY, true \
	}
#define NOT_NEGATIVE               \
	{                          \
		0, INFINITY, false \
	}

struct property {
	unsigned needs;
	const char *name;
	size_t offset;
	struct bounds bounds;
	bool for_all; /* one number for all types */
};
#define PAIR(needs, name, field, ...)                                                     \
	{                                                                                 \
		needs, name, offsetof(struct ts_granular_pair, field), __VA_ARGS__, false \
	}
#define FOR_ALL(needs, name, field, ...)                                                 \
	{                                                                                \
		needs, name, offsetof(struct ts_granular_pair, field), __VA_ARGS__, true \
	}

static const struct property of_pairs[] = {
	PAIR(STIFFNESS, "kn", kn, POSITIVE),
	PAIR(STIFFNESS, "kt", kt, NOT_NEGATIVE),
	PAIR(MODULUS, "contactModulus", kn, POSITIVE),
	PAIR(MODULUS, "contactStiffnessRatio", kt, POSITIVE),
	PAIR(STIFFNESS_DAMPING, "gamman", gamman, NOT_NEGATIVE),
	PAIR(STIFFNESS_DAMPING, "gammat", gammat, NOT_NEGATIVE),
	PAIR(ABSOLUTE_DAMPING, "gamman_abs", gamman, NOT_NEGATIVE),
	PAIR(ABSOLUTE_DAMPING, "gammat_abs", gammat, NOT_NEGATIVE),
	PAIR(RESTITUTION, "coefficientRestitution", log_restitution, { 0.05, 1, true }),
	PAIR(FRICTION, "coefficientFriction", friction, NOT_NEGATIVE),
	PAIR(ROLLING, "coefficientRollingFriction", rolling_friction, NOT_NEGATIVE),
	PAIR(ROLLING_DASHPOT, "coefficientRollingViscousDamping", rolling_viscosity, NOT_NEGATIVE),
	PAIR(COHESION, "cohesionEnergyDensity", cohesion, NOT_NEGATIVE),
	PAIR(ADHESION, "workOfAdhesion", surface_energy, NOT_NEGATIVE),
	PAIR(VISCOUS, "FluidViscosity", viscosity, POSITIVE),
	PAIR(VISCOUS, "CriticalStokes", critical_stokes, POSITIVE),
	PAIR(VISCOUS, "MaximumRestitution", largest_restitution, { 0, 1, true }),
	PAIR(HYSTERESIS, "coefficientMaxElasticStiffness", unloading, { 1, INFINITY, true }),
	PAIR(HYSTERESIS, "coefficientAdhesionStiffness", adhesion, NOT_NEGATIVE),
	PAIR(HYSTERESIS, "coefficientPlasticityDepth", plasticity, NOT_NEGATIVE),
	PAIR(EDINBURGH, "UnloadingStiffness", unloading, { 1, INFINITY, false }),
	PAIR(EDINBURGH, "surfaceEnergy", surface_energy, NOT_NEGATIVE),
	PAIR(EDINBURGH, "pullOffForce", pull_off, { -INFINITY, INFINITY, false }),
	FOR_ALL(EDINBURGH, "overlapExponent", overlap_exponent, POSITIVE),
	FOR_ALL(EDINBURGH, "adhesionExponent", adhesion_exponent, POSITIVE),
	FOR_ALL(BRIDGES, "surfaceTension", surface_tension, NOT_NEGATIVE),
	FOR_ALL(BRIDGES, "fluidViscosity", liquid_viscosity, NOT_NEGATIVE),
	/* above 0: the viscous force diverges there */
	FOR_ALL(BRIDGES, "minSeparationDistanceRatio", least_gap, { 0, 6, true }),
	FOR_ALL(BRIDGES, "maxSeparationDistanceRatio", most_gap, { 1, INFINITY, false }),
	FOR_ALL(BRIDGE_SHARE, "lbVolumeFraction", bridge_share, { 0, 1, true }),
	FOR_ALL(ROLLING_STIFFNESS, "rollingStiffness", rolling_stiffness, POSITIVE),
	FOR_ALL(VELOCITY, "characteristicVelocity", velocity, POSITIVE),
};
enum { NPAIR = sizeof of_pairs / sizeof *of_pairs };

/* The value of a property for types a and b, for messages. */
struct given {
	const char *name;
	int a, b;
	double value;
};

static enum ts_status refuse_value(struct tsim *sim, const struct given *g, const char *expected)
{
	return ts_fail(&sim->error, TS_RANGE, ts_property_place(sim, g->name, g->a, g->b),
		       "property/global %s is %.15g, expected %s", g->name, g->value, expected);
}

static enum ts_status check_range(struct tsim *sim, const struct given *g, const struct bounds *bounds)
{
	const char *relation = bounds->above ? ">" : ">=";
	char expected[96];

	if (g->value >= bounds->lo && g->value <= bounds->hi && !(bounds->above && g->value <= bounds->lo))
		return TS_OK;
	if (bounds->hi < INFINITY)
		snprintf(expected, sizeof expected, "a number %s %g and <= %g", relation, bounds->lo,
			 bounds->hi);
	else
		snprintf(expected, sizeof expected, "a number %s %g", relation, bounds->lo);
	return refuse_value(sim, g, expected);
}

static enum ts_status check_usual_modulus(struct tsim *sim, const struct given *g, double pascal)
{
	char expected[160];

	if (g->value < 5e6 * pascal && !sim->soft_particles) {
		snprintf(expected, sizeof expected,
			 "at least %g: overlaps of softer particles are too large; `soft_particles yes` "
			 "allows it",
			 5e6 * pascal);
		return refuse_value(sim, g, expected);
	}
	if (g->value > 1e9 * pascal && !sim->hard_particles) {
		snprintf(expected, sizeof expected,
			 "at most %g: harder particles need very small time steps; `hard_particles yes` "
			 "allows it",
			 1e9 * pascal);
		return refuse_value(sim, g, expected);
	}
	return TS_OK;
}

/* LIGGGHTS' bounds against errors of units; only in units with a pascal. */
static enum ts_status check_usual(struct tsim *sim, const struct given *g)
{
	bool si = sim->units == TS_UNITS_SI;

	if (ts_streq(g->name, "youngsModulus") && (si || sim->units == TS_UNITS_CGS))
		return check_usual_modulus(sim, g, si ? 1 : 10);
	if (ts_streq(g->name, "characteristicVelocity") && si && g->value < 0.01)
		return refuse_value(sim, g, "at least 0.01");
	if (ts_streq(g->name, "rollingStiffness") && si && g->value < 1)
		return refuse_value(sim, g, "at least 1");
	return TS_OK;
}

static enum ts_status read_property(struct tsim *sim, struct given *g, const char *who,
				    const struct ts_place *where, const struct bounds *bounds)
{
	TS_TRY(ts_property_value(sim, g->name, g->a, g->b, who, where, &g->value));
	TS_TRY(check_range(sim, g, bounds));
	return check_usual(sim, g);
}

/* 1/Y* = (1-nu_a^2)/Y_a + (1-nu_b^2)/Y_b; 1/G* = 2(2-nu_a)(1+nu_a)/Y_a + 2(2-nu_b)(1+nu_b)/Y_b */
static enum ts_status read_elastic_constants(struct tsim *sim, int a, int b, const char *who,
					     const struct ts_place *where, struct ts_granular_pair *out)
{
	static const struct bounds positive = POSITIVE, ratio = { 0, 0.5, false };
	const int types[2] = { a, b };
	double y = 0, g = 0;

	for (int k = 0; k < 2; k++) {
		struct given young = { "youngsModulus", types[k], 0, 0 };
		struct given poisson = { "poissonsRatio", types[k], 0, 0 };
		double nu;

		TS_TRY(read_property(sim, &young, who, where, &positive));
		TS_TRY(read_property(sim, &poisson, who, where, &ratio));
		nu = poisson.value;
		y += (1 - nu * nu) / young.value;
		g += 2 * (2 - nu) * (1 + nu) / young.value;
	}
	out->young = 1 / y;
	out->shear = 1 / g;
	return TS_OK;
}

/* Constants of law/normal_area.h for a material: k = 4/3 Y*, k_t = 8 G*. The work of adhesion W separates two
 * surfaces of surface energy w = W/2 each, so the pull-off force is 3 pi w R* = 3/2 pi W R*. Damping is that
 * of model hertz with the contact radius a instead of sqrt(R* delta): 2 sqrt(5/6) |beta| sqrt(2 Y* a m*) =
 * sqrt(5) |beta| sqrt(k a m*), and with 8 G* instead of 2 Y* for the tangential one. */
static void set_jkr_constants(struct ts_granular_pair *out)
{
	out->kn = 4.0 / 3.0 * out->young;
	out->kt = 8 * out->shear;
	out->gamman = -sqrt(5) * out->damping;
	out->gammat = 2 * sqrt(out->shear / out->young);
	out->surface_energy *= 0.5;
}

/* Mean of both contact angles, radians; LIGGGHTS 3.8 uses half their product, which `legacy` reproduces. */
static enum ts_status read_contact_angle(struct tsim *sim, int a, int b, const char *who,
					 const struct ts_place *where, struct ts_granular_pair *out)
{
	static const struct bounds angle = { 0, 180, false };
	struct given one = { "contactAngle", a, 0, 0 }, other = { "contactAngle", b, 0, 0 };
	double degree = TS_PI / 180;

	TS_TRY(read_property(sim, &one, who, where, &angle));
	TS_TRY(read_property(sim, &other, who, where, &angle));
	out->contact_angle = 0.5 *
			     (sim->legacy == TS_LEGACY_LIGGGHTS ? one.value * degree * other.value
								: one.value + other.value) *
			     degree;
	return TS_OK;
}

enum ts_status ts_contact_law_of_materials(struct tsim *sim, const struct ts_granular_model *model, int a,
					   int b, const char *who, const struct ts_place *where,
					   struct ts_granular_pair *out)
{
	unsigned needs = needs_of(model);

	*out = (struct ts_granular_pair){ 0 };
	out->bridge_share = 0.05;
	if (needs & BRIDGES)
		TS_TRY(read_contact_angle(sim, a, b, who, where, out));
	if (needs & ELASTIC)
		TS_TRY(read_elastic_constants(sim, a, b, who, where, out));
	for (size_t k = 0; k < NPAIR; k++) {
		const struct property *p = &of_pairs[k];
		struct given g = { p->name, p->for_all ? 0 : a, p->for_all ? 0 : b, 0 };

		if (!(needs & p->needs))
			continue;
		TS_TRY(read_property(sim, &g, who, where, &p->bounds));
		*(double *)((char *)out + p->offset) = g.value;
	}
	if (needs & RESTITUTION) {
		double l = log(out->log_restitution);

		out->log_restitution = l;
		out->damping = l / sqrt(l * l + TS_PI * TS_PI);
	}
	if (needs & MODULUS) {
		out->kn *= 4;
		out->kt = out->kn / out->kt;
	}
	if (needs & EDINBURGH)
		out->metre = ts_si_units(sim->units).length > 0 ? 1 / ts_si_units(sim->units).length : 1;
	if (needs & ADHESION)
		set_jkr_constants(out);
	return TS_OK;
}
