/* Fix drag: a force of constant size towards a point. */
#include "core/sim.h"

#include <string.h>

#include "average/particle_tally.h"
#include "box/domain.h"
#include "math/vec3.h"
#include "particle/particles.h"

#include "base/banned.h"

struct state {
	struct ts_number at[3]; /* NULL: free in this direction */
	double size, delta;
	struct ts_particle_tally force;
};

static enum ts_status post_force(struct ts_instance *self, struct tsim *sim)
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

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
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
		  .help = "x of the point, a number or v_NAME; NULL: no force in x"),
	TS_NUMBER("y", struct state, at[1], .flags = TS_POSITIONAL | TS_NULLABLE, .unit = "length",
		  .help = "y"),
	TS_NUMBER("z", struct state, at[2], .flags = TS_POSITIONAL | TS_NULLABLE, .unit = "length",
		  .help = "z"),
	TS_REAL("fmag", struct state, size, .flags = TS_POSITIONAL, .unit = "force",
		.help = "size of the force on each particle"),
	TS_REAL("delta", struct state, delta, .flags = TS_POSITIONAL, .range = TS_NOT_NEGATIVE,
		.unit = "length", .help = "nearer than this there is no force"),
	TS_ARGS_END,
};

static const char *const components[] = { "x", "y", "z" };
static const struct ts_value values[] = {
	{ "force", "force", "total force on the particles", TS_VECTOR, 3, components, eval },
	{ .name = NULL },
};

TS_STYLE(fix, ts_style, ts_fix_drag)
const struct ts_style ts_fix_drag = {
	.name = "drag",
	.kind = TS_KIND_FIX,
	.summary = "A force of constant size towards a point",
	.doc = "f -= fmag d/|d| for particles farther than delta from the point, d leading from the (nearest "
	       "image\n"
	       "of the) point to the particle. The drag of a fluid is another matter: fix drag/stokes.",
	.example = "fix gather all drag 0.5 NULL 0.0 2.385 0.01",
	.args = args,
	.state_size = sizeof(struct state),
	.archive = archive,
	.values = values,
	.hook[TS_STAGE_POST_FORCE] = post_force,
	.fini = fini,
};
