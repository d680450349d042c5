/* Fix spring/self: tethers each particle to its initial position. */
#include "core/report.h"
#include "energy/potential_energy.h"

#include <math.h>

#include "average/particle_tally.h"
#include "math/vec3.h"
#include "particle/group_moments.h"
#include "particle/reference.h"

#include "base/banned.h"

enum { ENERGY = 0 };

struct state {
	struct ts_particle_tally energy;
	double stiffness;
	int direction;
	struct ts_reference anchor;
};

static const char *const directions[] = { "xyz", "xy", "yz", "xz", "x", "y", "z", NULL };

static bool acts_in_direction(const struct state *s, int k)
{
	for (const char *c = directions[s->direction]; *c; c++)
		if (*c == "xyz"[k])
			return true;
	return false;
}

static void unwrapped_position(const struct ts_instance *self, const struct tsim *sim, size_t i,
			       double now[3])
{
	(void)self;
	ts_unwrapped(sim, i, now);
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	return ts_reference_init(self, sim, &s->anchor, unwrapped_position);
}

static enum ts_status add_new_particles(struct ts_instance *self, struct tsim *sim)
{
	const struct state *s = self->state;

	ts_reference_add(sim, &s->anchor);
	return TS_OK;
}

static enum ts_status add_spring_forces(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	struct ts_particles *p = sim->particles;

	TS_TRY(ts_particle_tally_start(sim, &s->energy));
#pragma omp parallel for num_threads(ts_team(sim, p->n)) schedule(static)
	for (size_t i = 0; i < p->n; i++) {
		double d[3];

		if (!ts_in_group(p, i, self->group))
			continue;
		ts_unwrapped(sim, i, d);
		ts_sub(d, ts_reference_of(sim, &s->anchor, i), d);
		for (int k = 0; k < 3; k++) {
			if (!acts_in_direction(s, k))
				continue;
			p->f[i][k] -= s->stiffness * d[k];
			s->energy.note[i][ENERGY] += 0.5 * s->stiffness * d[k] * d[k];
		}
	}
	return TS_OK;
}

static void add_ground(const struct ts_instance *self, const struct tsim *sim, size_t i,
		       struct ts_ground_springs *sum)
{
	const struct state *s = self->state;

	for (int d = 0; d < 3; d++)
		if (acts_in_direction(s, d))
			sum->frequency2[d] += s->stiffness * sim->particles->imass[i];
}

static enum ts_status archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a)
{
	struct state *s = self->state;

	TS_TRY(ts_particle_tally_archive(a, &s->energy));
	return ts_reference_archive(a, sim, &s->anchor);
}

static enum ts_status eval_energy(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	struct state *s = self->state;

	(void)sim;
	out->data[0] = ts_particle_tally_sums(&s->energy)[ENERGY];
	return TS_OK;
}

static void fini(struct ts_instance *self)
{
	struct state *s = self->state;

	ts_particle_tally_release(&s->energy);
}

static const struct ts_arg args[] = {
	TS_REAL("K", struct state, stiffness, .flags = TS_POSITIONAL, .range = TS_POSITIVE,
		.unit = "force/length", .help = "stiffness of the springs"),
	TS_ENUM("dir", struct state, direction, directions, .flags = TS_POSITIONAL, .fallback = "xyz",
		.help = "directions in which the springs act"),
	TS_ARGS_END,
};

static const struct ts_value values[] = {
	{ "energy", "energy", "energy of all springs", TS_SCALAR, 1, NULL, eval_energy },
	{ .name = NULL },
};

TS_STYLE(fix, ts_style, ts_fix_spring_self)
const struct ts_style ts_fix_spring_self = {
	.name = "spring/self",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_OWN | TS_RANKS_OUTPUTS,
	.join = ts_particle_tally_join,
	.summary = "tethers each particle to its initial position by a spring",
	.doc = "Adds the force f = -K (x - x0) to each particle of the group, in the given directions. x and x0 are unwrapped positions, x0 that when the fix was defined or, for particles created later, when the particle was created. Velocity Verlet is stable for time steps below 2 sqrt(m/K) with the smallest mass m.",
	.example = "fix hold frame spring/self 2.5 xy",
	.args = args,
	.state_size = sizeof(struct state),
	.archive = archive,
	.values = values,
	.energy = ts_energy_output,
	.init = init,
	.hook = {
		[TS_STAGE_POST_BUILD] = add_new_particles,
		[TS_STAGE_POST_FORCE] = add_spring_forces,
	},
	.ground = add_ground,
	.fini = fini,
};
