/* Fix drag: a force of constant magnitude towards a point. */
#include "base/axes.h"
#include "core/sim.h"

#include <string.h>

#include "average/particle_tally.h"
#include "box/domain.h"
#include "math/vec3.h"
#include "particle/particles.h"

#include "base/banned.h"

struct state {
	struct ts_particle_tally force;
	struct ts_number at[3]; /* NULL: no force in this direction */
	double size, delta;
};

static enum ts_status add_drag(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	struct ts_particles *p = sim->particles;
	double at[3] = { 0 };

	TS_TRY(ts_particle_tally_start(sim, &s->force));
	for (int k = 0; k < 3; k++)
		if (!s->at[k].null)
			TS_TRY(ts_number_now(sim, &s->at[k], &self->where, &at[k]));
#pragma omp parallel for num_threads(ts_team(sim, p->n)) schedule(static)
	for (size_t i = 0; i < p->n; i++) {
		double d[3], length;

		if (!ts_in_group(p, i, self->group))
			continue;
		ts_sub(p->x[i], at, d);
		for (int k = 0; k < 3; k++)
			d[k] = s->at[k].null ? 0 : d[k];
		ts_box_nearest(&sim->domain->box, d);
		length = ts_norm(d);
		if (!(length > s->delta))
			continue;
		for (int k = 0; k < 3; k++) {
			s->force.note[i][k] = -s->size * d[k] / length;
			p->f[i][k] += s->force.note[i][k];
		}
	}
	return TS_OK;
}

static enum ts_status archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a)
{
	struct state *s = self->state;

	(void)sim;
	return ts_particle_tally_archive(a, &s->force);
}

static enum ts_status eval_total(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	struct state *s = self->state;

	(void)sim;
	memcpy(out->data, ts_particle_tally_sums(&s->force), 3 * sizeof *out->data);
	return TS_OK;
}

static void fini(struct ts_instance *self)
{
	struct state *s = self->state;

	ts_particle_tally_release(&s->force);
}

static const struct ts_arg args[] = {
	TS_NUMBER("x", struct state, at[0], .flags = TS_POSITIONAL | TS_NULLABLE, .unit = "length",
		  .help = "x of the point: a number or v_NAME; NULL: no force in x"),
	TS_NUMBER("y", struct state, at[1], .flags = TS_POSITIONAL | TS_NULLABLE, .unit = "length",
		  .help = "y"),
	TS_NUMBER("z", struct state, at[2], .flags = TS_POSITIONAL | TS_NULLABLE, .unit = "length",
		  .help = "z"),
	TS_REAL("fmag", struct state, size, .flags = TS_POSITIONAL, .unit = "force",
		.help = "magnitude of the force on each particle"),
	TS_REAL("delta", struct state, delta, .flags = TS_POSITIONAL, .range = TS_NOT_NEGATIVE,
		.unit = "length", .help = "distance from the point below which there is no force"),
	TS_ARGS_END,
};

static const struct ts_value values[] = {
	{ "force", "force", "total force on the particles", TS_VECTOR, 3, ts_axis_names, eval_total },
	{ .name = NULL },
};

TS_STYLE(fix, ts_style, ts_fix_drag)
const struct ts_style ts_fix_drag = {
	.name = "drag",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_OWN | TS_RANKS_OUTPUTS,
	.join = ts_particle_tally_join,
	.summary = "adds a force of constant magnitude towards a point",
	.doc = "Adds f = -fmag d/|d| to each particle of the group whose distance |d| from the point is "
	       "larger than delta, where d is the vector from the nearest periodic image of the point to the "
	       "particle. Components that are NULL are 0 in d. For the drag of a fluid see fix drag/stokes.",
	.example = "fix gather all drag 0.5 NULL 0.0 2.385 0.01",
	.args = args,
	.state_size = sizeof(struct state),
	.archive = archive,
	.values = values,
	.hook[TS_STAGE_POST_FORCE] = add_drag,
	.fini = fini,
};
