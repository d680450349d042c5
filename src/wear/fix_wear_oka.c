/* Fix wear/oka: erosion by hard particles after Oka. */
#include "core/units.h"
#include "law/erosion_oka.h"
#include "wear/wear_material.h"

#include "base/banned.h"

static const char *const particles[] = { "sio2", "sic", "glass", NULL };
_Static_assert(TS_OKA_SIO2 == 0 && TS_OKA_SIC == 1 && TS_OKA_GLASS == 2, "in the order of the sets");

struct state {
	struct ts_wear wear;
	int particles;
	double hardness, relaxation, factor;

	struct ts_erosion_oka law;
	struct ts_si_units si;
};

static double remove_by_impact(const struct ts_instance *self, const struct ts_impact_event *e)
{
	const struct state *s = self->state;
	struct ts_erosion_impact i = ts_wear_erosion_impact(e);
	double speed = s->si.length / s->si.time;

	i.mass *= s->si.mass;
	i.diameter *= s->si.length;
	i.normal *= speed;
	i.tangential *= speed;
	return s->factor * ts_erosion_oka_volume(&s->law, &i) / (s->si.length * s->si.length * s->si.length);
}

static const struct ts_wear_law law = { .impact = remove_by_impact };

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	struct ts_erosion_oka_set set = ts_erosion_oka_set_of(s->particles);
	double hardness;

	s->si = ts_si_units(sim->units);
	if (!(s->si.length > 0))
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "fix wear/oka: its numbers are in SI units, units lj have no equivalent; use "
			       "si, cgs or micro");
	TS_TRY(ts_wear_init(self, sim, &law));
	TS_TRY(ts_wear_hardness(self, sim, s->hardness, &hardness));
	hardness *= s->si.mass / (s->si.length * s->si.time * s->si.time);
	s->law = ts_erosion_oka_of(&set, hardness, isnan(s->relaxation) ? 0 : s->relaxation);
	return TS_OK;
}

static const struct ts_arg args[] = {
	TS_WEAR_ARGS(struct state, wear),
	TS_ENUM("particles", struct state, particles, particles,
		.help = "numbers of the law: angular silica sand, angular silicon carbide, glass beads"),
	TS_WEAR_HARDNESS_ARG(struct state, hardness),
	TS_REAL("relaxation", struct state, relaxation, .flags = TS_OPTIONAL, .range = TS_POSITIVE,
		.unit = "",
		.help = "number W of the metal, E90 = K W^(-k1) ... in place of K Hv^k1: 3 for carbon steel, "
			"10 for stainless steel, 1000 for aluminium"),
	TS_WEAR_FACTOR_ARG(struct state, factor),
	TS_ARGS_END,
};

TS_STYLE(fix, ts_style, ts_fix_wear_oka)
const struct ts_style ts_fix_wear_oka = {
	.name = "wear/oka",
	.kind = TS_KIND_FIX,
	.summary = "erosion of a surface by hard particles, fitted to experiments (Oka)",
	.doc = "Each impact of a particle with the mass m, the diameter D, the speed V and the impact angle "
	       "alpha removes the volume m g E90,\n\n"
	       "    E90 = K Hv^k1 (V/V')^(k2s Hv^k2q) (D/D')^k3\n"
	       "    g = sin(alpha)^(s1 Hv^q1) (1 + Hv (1 - sin(alpha)))^(s2 Hv^q2)\n\n"
	       "E90 in mm^3/kg, the hardness Hv in GPa, V in m/s, D in um:\n\n"
	       "    particles  K   k1     k2s  k2q    k3    s1    q1    s2   q2     V'   D'\n"
	       "    sio2       65  -0.12  2.3  0.038  0.19  0.71  0.14  2.4  -0.94  104  326\n"
	       "    sic        45  -0.05  3.0  0.085  0.19  0.71  0.14  2.8  -1.00  99   326\n"
	       "    glass      27  -0.16  2.1  0      0.19  2.8   0.41  2.6  -1.46  100  200\n\n"
	       "The numbers are converted from and to the units of the script. The law is fitted to metals "
	       "at speeds and sizes about V' and D'; plastics, ceramics and much smaller particles are "
	       "extrapolations. With `relaxation` the dependence on the hardness is that of the load "
	       "relaxation measured for a metal. `factor` may account for another shape of the particles. "
	       "Restrictions: units si, cgs or micro." TS_WEAR_DOC
	       "Related: fix wear/bitter, fix wear/neilson/gilchrist, fix wear/zhao/chang, fix wear/finnie, "
	       "fix wear/formula.",
	.example = "fix target all wall/gran model hertz primitive type 2 zplane 0\n"
		   "fix scar all wear/oka surface target particles sio2 hardness 1.1e9",
	.cite = "Y. I. Oka, K. Okamura, T. Yoshida, Wear 259 (2005) 95; Y. I. Oka, T. Yoshida, Wear 259 "
		"(2005) 102",
	.args = args,
	.state_size = sizeof(struct state),
	TS_WEAR_SLOTS,
	.observes = TS_OBSERVES_IMPACTS,
	.init = init,
	.late = { [TS_LATE_CONTACTS] = ts_wear_step },
	.fini = ts_wear_fini,
};
