#include "integrate/integrate.h"
#include "particle/particles.h"

#include "base/banned.h"

struct nve_sphere {
	int inertia; /* enum ts_inertia; by_dimension: not given */
	bool disc;   /* LAMMPS' keyword for inertia disc */
	bool warned;
};

static enum ts_status initial_integrate(struct ts_instance *self, struct tsim *sim)
{
	double dt = sim->clock.dt;

	ts_integrate(sim, self->group,
		     &(struct ts_integration){ .kick = 0.5 * dt, .kick_omega = 0.5 * dt, .drift = dt });
	return TS_OK;
}

static enum ts_status final_integrate(struct ts_instance *self, struct tsim *sim)
{
	double h = 0.5 * sim->clock.dt;

	ts_integrate(sim, self->group, &(struct ts_integration){ .kick = h, .kick_omega = h });
	return TS_OK;
}

/* All particles have the same kind of inertia: the fixes that specify it must agree. */
static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct ts_instances *fixes = &sim->instances[TS_KIND_FIX];
	struct nve_sphere *s = self->state;
	enum ts_inertia said;

	if (s->disc)
		s->inertia = TS_INERTIA_DISC;
	if (s->inertia == TS_INERTIA_DISC && sim->dimension != 2)
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "fix nve/sphere: discs need `dimension 2`");
	said = (enum ts_inertia)s->inertia;
	for (size_t k = 0; k < fixes->n; k++) {
		const struct nve_sphere *other = fixes->item[k]->state;

		if (fixes->item[k]->style != self->style || !other->inertia)
			continue;
		if (said && other->inertia != (int)said && !ts_streq(fixes->item[k]->id, self->id))
			return ts_fail(&sim->error, TS_STATE, &self->where,
				       "fix nve/sphere: fix %s (%s:%d) has another inertia",
				       fixes->item[k]->id, TS_FILE_AND_LINE(fixes->item[k]->where));
		if (!said)
			said = (enum ts_inertia)other->inertia;
	}
	sim->particles->inertia = said;
	if (sim->dimension == 2 && !said && !s->warned)
		ts_warn(&sim->log, &self->where,
			"particles rotate as discs, I = m r^2/2, of the mass density pi r^2, as in LIGGGHTS "
			"(LAMMPS: "
			"4/3 pi r^3, unless it is density/disc); confirm it by `inertia disc`, or use "
			"`inertia sphere`");
	s->warned = true;
	return TS_OK;
}

static const char *const inertias[] = { "by_dimension", "sphere", "disc", NULL };

static const struct ts_arg args[] = {
	TS_ENUM("inertia", struct nve_sphere, inertia, inertias, .fallback = "by_dimension",
		.help = "moment of inertia: 2/5 m r^2 of a sphere, 1/2 m r^2 of a disc (in two dimensions "
			"only); by dimension: disc in two"),
	TS_FLAG("disc", struct nve_sphere, disc, .help = "the same as inertia disc"),
	TS_ARGS_END,
};

TS_STYLE(fix, ts_style, ts_fix_nve_sphere)
const struct ts_style ts_fix_nve_sphere = {
	.name = "nve/sphere",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_OWN | TS_RANKS_ROWLESS,
	.summary = "integrates translation and rotation of the group by velocity Verlet",
	.doc = "As fix nve, and in addition omega += h/2 T/I before and after the computation of forces and "
	       "torques T, with I = 0.4 m r^2. Where no style computes torques or reads the rotation, this "
	       "is left out, as it would change nothing.\n\n"
	       "In two dimensions particles rotate as discs, I = 0.5 m r^2, and a warning says so unless the "
	       "inertia is given; `inertia sphere` lets spheres roll in a plane. The rotational energy "
	       "(thermo keyword erotate, compute erotate/sphere) uses the same I.",
	.example = "fix move all nve/sphere\n"
		   "fix move all nve/sphere inertia sphere",
	.args = args,
	.state_size = sizeof(struct nve_sphere),
	.init = init,
	.integrates = TS_MOVES | TS_OBEYS | TS_TURNS,
	.hook = { [TS_STAGE_INITIAL_INTEGRATE] = initial_integrate,
		  [TS_STAGE_FINAL_INTEGRATE] = final_integrate },
	.defers = TS_DEFERS(INITIAL_INTEGRATE) | TS_DEFERS(FINAL_INTEGRATE),
};
