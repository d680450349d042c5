/* Fix buoyancy: hydrostatic buoyancy of particles. */
#include "base/axes.h"
#include "flow/projection.h"
#include "law/buoyancy.h"

#include "average/particle_tally.h"
#include "force/gravity.h"
#include "group/chosen.h"
#include "group/group_members.h"
#include "particle/particles.h"
#include "region/region.h"

#include <string.h>

#include "core/sim.h"

#include "base/banned.h"

struct state {
	int dim;
	double level, density;
	struct ts_instance *region;
	const struct ts_gravity *gravity;
	double down; /* direction of gravity along the axis, +1 or -1 */
	struct ts_particle_tally total;
};

static enum ts_status find_gravity(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	const struct ts_instance *inst;
	size_t k = 0;
	int n = 0;

	while ((inst = ts_sim_next_of(sim, TS_KIND_FIX, TS_FAMILY_GRAVITY, &k))) {
		s->gravity = inst->state;
		n++;
	}
	if (n == 1)
		return TS_OK;
	return ts_fail(&sim->error, TS_STATE, &self->where,
		       "fix buoyancy: the fluid needs the weight of one fix gravity, there are %d", n);
}

/* Fixes by which the pressure of the fluid acts on particles: a pressure that balances the weight of the
 * fluid contains the buoyancy already. */
static const struct ts_instance *pressed(const struct tsim *sim, const struct ts_instance *self)
{
	const struct ts_instance *fix;

	for (size_t k = 0; (fix = ts_flow_part_named(sim, "flow/pressure_gradient", &k));)
		if (ts_groups_meet(sim->particles, fix->group, self->group))
			return fix;
	for (size_t k = 0; (fix = ts_flow_part_named(sim, "immersed/boundary", &k));)
		if (fix->words.n && ts_streq(fix->words.word[0].text, "spheres") &&
		    ts_groups_meet(sim->particles, fix->group, self->group))
			return fix;
	return NULL;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	const struct state *s = self->state;
	const struct ts_instance *flow = ts_sim_only(sim, TS_KIND_FLOW), *fix;
	const struct ts_projection *p;

	if (!flow || !flow->style->family || !ts_streq(flow->style->family, TS_FAMILY_PROJECTION))
		return TS_OK;
	p = flow->state;
	fix = pressed(sim, self);
	if (!fix || p->fluid.grid.periodic[s->dim] || !p->body_words.n ||
	    (!p->body_force[s->dim].variable && p->body_force[s->dim].value == 0))
		return TS_OK;
	return ts_fail(&sim->error, TS_STATE, &self->where,
		       "fix buoyancy: buoyancy would count twice: the pressure of the fluid holds its weight "
		       "(body_force along %s, flow_style in line %d) and acts on the particles by fix %s "
		       "(line %d): leave out fix buoyancy, or the body_force",
		       ts_axis_names[s->dim], flow->where.line, fix->style->name, fix->where.line);
}

static enum ts_status post_force(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	struct ts_particles *p = sim->particles;
	double magnitude;

	TS_TRY(ts_number_now(sim, &s->gravity->magnitude, &self->where, &magnitude));
	TS_TRY(ts_region_update(s->region, sim));
	TS_TRY(ts_particle_tally_start(sim, &s->total));
	for (size_t i = 0; i < p->n; i++) {
		double depth = s->down * (p->x[i][s->dim] - s->level) + p->radius[i], force;

		if (!ts_in_group(p, i, self->group) || (s->region && !ts_region_contains(s->region, p->x[i])))
			continue;
		force = -s->down * magnitude * s->density *
			ts_buoyancy_immersed_volume(p->radius[i], depth, sim->dimension == 2);
		p->f[i][s->dim] += force;
		s->total.note[i][s->dim] = force;
	}
	return TS_OK;
}

/* Before the first force of a run, when all fixes have said where gravity points. */
static enum ts_status post_build(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	TS_TRY(find_gravity(self, sim));
	s->down = s->gravity->direction[s->dim] > 0 ? 1 : -1;
	if (s->gravity->turns)
		return ts_fail(&sim->error, TS_STATE, ts_instance_word(self, "dim"),
			       "fix buoyancy: the direction of gravity is a variable, but the surface of the "
			       "fluid does not turn with it");
	for (int d = 0; d < 3; d++)
		if (d != s->dim && s->gravity->direction[d] != 0)
			return ts_fail(&sim->error, TS_STATE, ts_instance_word(self, "dim"),
				       "fix buoyancy: gravity does not point along %s",
				       ts_axis_names[s->dim]);
	return TS_OK;
}

static enum ts_status archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a)
{
	(void)sim;
	return ts_particle_tally_archive(a, &((struct state *)self->state)->total);
}

static enum ts_status join(struct ts_instance *self, struct tsim *sim)
{
	return ts_particle_tally_merge(&((struct state *)self->state)->total, sim);
}

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	(void)sim;
	memcpy(out->data, ts_particle_tally_sums(&((struct state *)self->state)->total),
	       3 * sizeof *out->data);
	return TS_OK;
}

static void fini(struct ts_instance *self)
{
	ts_particle_tally_release(&((struct state *)self->state)->total);
}

static const struct ts_arg args[] = {
	TS_ENUM("dim", struct state, dim, ts_axis_names, .help = "axis normal to the surface of the fluid"),
	TS_REAL("level", struct state, level, .fallback = "0", .unit = "length",
		.help = "coordinate of the surface"),
	TS_REAL("density", struct state, density, .range = TS_POSITIVE, .unit = "density",
		.help = "of the fluid"),
	TS_REGION("region", struct state, region, .flags = TS_OPTIONAL,
		  .help = "region that contains the fluid; without: everywhere"),
	TS_ARGS_END,
};

static const struct ts_value values[] = {
	{ "force", "force", "total buoyancy of the particles", TS_VECTOR, 3, ts_axis_names, eval },
	{ .name = NULL },
};

TS_STYLE(fix, ts_style, ts_fix_buoyancy)
const struct ts_style ts_fix_buoyancy = {
	.name = "buoyancy",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_OWN | TS_RANKS_OUTPUTS,
	.join = join,
	.summary = "Buoyancy of particles in a fluid at rest",
	.doc = "F = -rho V g, with V the volume of the part of the particle that is below the level (on the "
	       "side to which gravity points): the whole sphere, or a cap of volume pi h^2 (3 R - h)/3. g is "
	       "the acceleration of fix gravity, of which there must be exactly one, parallel to `dim`. In "
	       "two dimensions V is the area of a segment of the disc. f_ID[1] ... [3] is the total "
	       "force.\n\n"
	       "If the fluid is solved for and has a body_force along `dim` that boundaries balance, the "
	       "buoyancy is contained in its pressure: this fix together with fix flow/pressure_gradient (or "
	       "with fix immersed/boundary of particles) would count it twice and is refused. In a grid that "
	       "is periodic along `dim` no pressure balances the weight.",
	.example = "fix g all gravity 9.81 vector 0.0 0.0 -1.0\n"
		   "fix pond all buoyancy level 0.06 dim z density 1000",
	.args = args,
	.state_size = sizeof(struct state),
	.archive = archive,
	.values = values,
	.init = init,
	.hook = { [TS_STAGE_POST_BUILD] = post_build, [TS_STAGE_POST_FORCE] = post_force },
	.fini = fini,
};
