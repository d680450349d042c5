#include "law/spring_dashpot.h"

#include "contact/contact_energy.h"
#include "contact/contact_loop.h"
#include "contact/contact_models.h"
#include "contact/pair.h"

#include "base/banned.h"

struct spring_dashpot {
	struct ts_pair pair;
	bool generic, located;
};

static enum ts_status complete(struct tsim *sim, void *coeff, const struct ts_place *where)
{
	struct ts_spring_dashpot *c = coeff;

	if (isnan(c->damping) == isnan(c->restitution))
		return ts_fail(&sim->error, TS_SYNTAX, where,
			       "pair_coeff: give either damping or restitution%s",
			       isnan(c->damping) ? "" : ", not both");
	if (c->restitution == 0)
		return ts_fail(&sim->error, TS_RANGE, where,
			       "pair_coeff: restitution must be > 0 (1e-6 is practically 0)");
	ts_spring_dashpot_complete(c);
	return TS_OK;
}

static const struct ts_granular_model spring = { .normal = TS_NORMAL_SPRING };

static const struct ts_granular_model located_spring = { .normal = TS_NORMAL_SPRING, .located = true };

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct spring_dashpot *s = self->state;

	s->pair.model = s->located ? located_spring : spring;
	return ts_pair_init(self, sim);
}

static enum ts_status force(struct ts_instance *self, struct tsim *sim)
{
	const struct spring_dashpot *s = self->state;

	return ts_contact_loop(sim, &s->pair, ts_contact_share_of(&s->pair, s->generic));
}

static const struct ts_arg args[] = {
	TS_FLAG("generic", struct spring_dashpot, generic,
		.help = "uses the contact loop for any law, for comparison with the specialised one"),
	TS_BOOL("located", struct spring_dashpot, located, .fallback = "no",
		.help = "sub-step contact detection: the begin and end of contacts within a step are "
			"resolved"),
	TS_ARGS_END,
};

static const struct ts_arg coeff[] = {
	TS_REAL("stiffness", struct ts_spring_dashpot, stiffness, .range = TS_POSITIVE,
		.unit = "force/length", .help = "spring constant k"),
	TS_REAL("damping", struct ts_spring_dashpot, damping, .flags = TS_OPTIONAL, .range = TS_NOT_NEGATIVE,
		.unit = "force/velocity", .help = "dashpot constant beta"),
	TS_REAL("restitution", struct ts_spring_dashpot, restitution, .flags = TS_OPTIONAL,
		.range = TS_FRACTION, .unit = "",
		.help = "coefficient of restitution e > 0, instead of beta"),
	TS_ARGS_END,
};

TS_STYLE(pair, ts_pair_style, ts_pair_spring_dashpot)
const struct ts_pair_style ts_pair_spring_dashpot = {
	.style = { .name = "spring/dashpot",
		   .kind = TS_KIND_PAIR,
		   .ranks = TS_RANKS_OWN,
		   .summary = "linear spring and dashpot, normal force only",
		   .doc = "Overlapping spheres repel with F = k delta - beta v_n along the line of centres, "
			  "delta = r_i + r_j - |x_i - x_j|, v_n > 0 while separating.\n\n"
			  "beta (force/velocity) is given by `damping`, or by the coefficient of "
			  "`restitution` e of two free bodies: beta = -2 ln e sqrt(m* k / (pi^2 + ln^2 e)) "
			  "with the effective mass m* = m_i m_j / (m_i + m_j); frozen particles and walls "
			  "have infinite mass. The contact ends at zero overlap, so for small e the force "
			  "may be attractive shortly before the end.\n\n"
			  "Coefficients are per pair of particle types; `pair_coeff I J file NAME` reads "
			  "them from a file of keyword-value lines, such as those in potentials/. A contact "
			  "lasts pi/sqrt(omega0^2 - gamma^2), omega0^2 = k/m*, gamma = beta/(2 m*); velocity "
			  "Verlet is stable for steps below 2 (sqrt(omega0^2 + gamma^2) - gamma)/omega0^2, "
			  "and a run beyond that is refused. There are no tangential forces and no "
			  "rotation.\n\n"
			  "`located yes`: velocity Verlet resolves neither the begin and end of a contact "
			  "within a step nor the velocity at the end of the step, which reduces the order of "
			  "convergence from two to one where there is damping. Here the force of a step is "
			  "the one that moves the pair to its exact position: within the contact in closed "
			  "form, F = phi k delta + psi beta u + (1 - phi) m* g with u the velocity half a "
			  "step before, phi = |1 - exp(-lambda h)|^2/(omega0 h)^2, psi = (1 - exp(-2 gamma "
			  "h))/(2 gamma h), lambda = gamma + i sqrt(omega0^2 - gamma^2), and g the relative "
			  "acceleration by all other forces; at its begin and end by integrating the motion "
			  "over the part of the step in contact. A single collision of 50 steps is then "
			  "exact to some 1e-8, and multiple contacts are of second order; at rest, and "
			  "without damping, nothing changes. Each contact has three more history numbers "
			  "(six with a tangential law). Output forces are these means over a step. Cannot be "
			  "used with fix nve/euler, nor with `legacy yes`.",
		   .example = "pair_style spring/dashpot\n"
			      "pair_style spring/dashpot located yes\n"
			      "pair_coeff * * stiffness 2.0e5 restitution 0.5\n"
			      "pair_coeff 1 2 file sandstone.spring",
		   .cite = "P. A. Cundall, O. D. L. Strack, Geotechnique 29 (1979) 47",
		   .args = args,
		   .coeff = coeff,
		   .state_size = sizeof(struct spring_dashpot),
		   .archive = ts_pair_archive,
		   .fingerprint = ts_pair_fingerprint,
		   .init = init,
		   .hook = { [TS_STAGE_FORCE] = force },
		   .energy = ts_contact_energy_of_pairs,
		   .plan = ts_pair_plan,
		   .fini = ts_pair_fini },
	.coeff_size = sizeof(struct ts_spring_dashpot),
	.complete = complete,
	.law_offset = offsetof(struct ts_spring_dashpot, law),
};
