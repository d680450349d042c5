#include "neigh/materials.h"

#include <math.h>

#include "law/granular_force.h"
#include "particles/property.h"

#include "base/banned.h"

const char *const ts_normal_names[] = {
	"off", "spring", "hooke", "hertz", "hooke/stiffness", "hertz/stiffness", "hooke/hysteresis",
	NULL
};
const char *const ts_tangential_names[] = { "off", "history", "no_history", NULL };
const char *const ts_rolling_names[] = { "off", "cdt", "epsd", "epsd2", "epsd3", NULL };
const char *const ts_cohesion_names[] = { "off", "sjkr", "sjkr2", NULL };
const char *const ts_surface_names[] = { "default", NULL };

struct ts_granular_model ts_granular_model_of(const struct tsim *sim,
					      const struct ts_granular_words *w)
{
	return (struct ts_granular_model){
		.normal = w->normal,
		.tangential = w->tangential,
		.rolling = w->rolling,
		.cohesion = w->cohesion,
		.no_tension = w->limit_force,
		.no_tangential_damping = !w->tangential_damping,
		.absolute_damping = w->absolute_damping,
		.tangential_stiffness_2_7 = w->kt_to_kn,
		.viscous = w->viscous,
		.reduce = w->reduce,
		.torsion = w->torsion,
		.plane = sim->dimension == 2,
	};
}

/* Which laws need a property. */
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
	COHESION = 4096
};

static unsigned needs_of(const struct ts_granular_model *m)
{
	static const unsigned normal[TS_NNORMAL] = {
		[TS_NORMAL_HOOKE] = ELASTIC | VELOCITY,
		[TS_NORMAL_HERTZ] = ELASTIC | RESTITUTION,
		[TS_NORMAL_HOOKE_STIFFNESS] = STIFFNESS,
		[TS_NORMAL_HERTZ_STIFFNESS] = STIFFNESS | STIFFNESS_DAMPING,
		[TS_NORMAL_HOOKE_HYSTERESIS] = ELASTIC | VELOCITY | HYSTERESIS,
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
	if (m->cohesion)
		needs |= COHESION;
	return needs;
}

struct property {
	unsigned needs;
	const char *name;
	size_t offset;
	double lo, hi; /* lo < value <= hi */
	bool for_all;  /* one number, whatever the types */
};
#define PAIR(needs, name, field, lo, hi)                                                           \
	{                                                                                          \
		needs, name, offsetof(struct ts_granular_pair, field), lo, hi, false               \
	}

static const struct property of_pairs[] = {
	PAIR(STIFFNESS, "kn", kn, 0, INFINITY),
	PAIR(STIFFNESS, "kt", kt, -1, INFINITY),
	PAIR(STIFFNESS_DAMPING, "gamman", gamman, -1, INFINITY),
	PAIR(STIFFNESS_DAMPING, "gammat", gammat, -1, INFINITY),
	PAIR(ABSOLUTE_DAMPING, "gamman_abs", gamman, -1, INFINITY),
	PAIR(ABSOLUTE_DAMPING, "gammat_abs", gammat, -1, INFINITY),
	PAIR(RESTITUTION, "coefficientRestitution", log_restitution, 0, 1),
	PAIR(FRICTION, "coefficientFriction", friction, -INFINITY, INFINITY),
	PAIR(ROLLING, "coefficientRollingFriction", rolling_friction, -INFINITY, INFINITY),
	PAIR(ROLLING_DASHPOT, "coefficientRollingViscousDamping", rolling_viscosity, -INFINITY,
	     INFINITY),
	PAIR(ROLLING_STIFFNESS, "coeffRollingStiffness", rolling_stiffness, -INFINITY, INFINITY),
	PAIR(COHESION, "cohesionEnergyDensity", cohesion, -INFINITY, INFINITY),
	PAIR(VISCOUS, "FluidViscosity", viscosity, 0, INFINITY),
	PAIR(VISCOUS, "CriticalStokes", critical_stokes, 0, INFINITY),
	PAIR(VISCOUS, "MaximumRestitution", largest_restitution, 0, 1),
	PAIR(HYSTERESIS, "coefficientMaxElasticStiffness", unloading, 1, INFINITY),
	PAIR(HYSTERESIS, "coefficientAdhesionStiffness", adhesion, -1, INFINITY),
	PAIR(HYSTERESIS, "coefficientPlasticityDepth", plasticity, -1, INFINITY),
	{ VELOCITY, "characteristicVelocity", offsetof(struct ts_granular_pair, velocity), 0,
	  INFINITY, true },
};
enum { NPAIR = sizeof of_pairs / sizeof *of_pairs };

static enum ts_status in_range(struct tsim *sim, const char *name, double value, double lo,
			       double hi)
{
	const struct ts_instance *by;

	if (value > lo && value <= hi)
		return TS_OK;
	ts_property_find(sim, name, &by);
	return ts_fail(&sim->error, TS_RANGE, &by->where,
		       "property/global %s must be > %g%s, found %.15g", name, lo > -1 ? lo : 0,
		       hi < INFINITY ? " and at most 1" : "", value);
}

/* 1/Y* = (1-nu_a^2)/Y_a + (1-nu_b^2)/Y_b; 1/G* = 2(2-nu_a)(1+nu_a)/Y_a + 2(2-nu_b)(1+nu_b)/Y_b */
static enum ts_status elastic(struct tsim *sim, int a, int b, const char *who,
			      const struct ts_place *where, struct ts_granular_pair *out)
{
	const int types[2] = { a, b };
	double y = 0, g = 0;

	for (int k = 0; k < 2; k++) {
		double young, nu;

		TS_TRY(ts_property_value(sim, "youngsModulus", types[k], 0, who, where, &young));
		TS_TRY(ts_property_value(sim, "poissonsRatio", types[k], 0, who, where, &nu));
		TS_TRY(in_range(sim, "youngsModulus", young, 0, INFINITY));
		TS_TRY(in_range(sim, "poissonsRatio", nu, -1, 0.5));
		y += (1 - nu * nu) / young;
		g += 2 * (2 - nu) * (1 + nu) / young;
	}
	out->young = 1 / y;
	out->shear = 1 / g;
	return TS_OK;
}

enum ts_status ts_granular_material(struct tsim *sim, const struct ts_granular_model *model, int a,
				    int b, const char *who, const struct ts_place *where,
				    struct ts_granular_pair *out)
{
	unsigned needs = needs_of(model);

	*out = (struct ts_granular_pair){ 0 };
	if (needs & ELASTIC)
		TS_TRY(elastic(sim, a, b, who, where, out));
	for (size_t k = 0; k < NPAIR; k++) {
		const struct property *p = &of_pairs[k];
		double *value = (double *)((char *)out + p->offset);

		if (!(needs & p->needs))
			continue;
		TS_TRY(ts_property_value(sim, p->name, p->for_all ? 0 : a, p->for_all ? 0 : b, who,
					 where, value));
		TS_TRY(in_range(sim, p->name, *value, p->lo, p->hi));
	}
	if (needs & RESTITUTION) {
		double l = log(out->log_restitution);

		out->log_restitution = l;
		out->damping = l / sqrt(l * l + TS_PI * TS_PI);
	}
	return TS_OK;
}
