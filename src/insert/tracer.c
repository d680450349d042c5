#include "insert/tracer.h"

#include "particle/columns.h"

#include "base/banned.h"

enum ts_status ts_tracer_init(struct ts_instance *self, struct tsim *sim)
{
	struct ts_tracer *t = self->state;
	struct ts_str name = { 0 };
	enum ts_status status;

	ts_str_addf(&name, "%s %s", self->style->name, self->id);
	status = ts_particles_add_column(sim, ts_str_text(&name), 1, TS_COL_RESULT, &t->column);
	ts_str_release(&name);
	/* a former fix of this name may have left its column */
	for (size_t i = 0; status == TS_OK && !t->started && i < sim->particles->n; i++)
		ts_tracer_marks(sim, t)[i] = 0;
	t->started = status == TS_OK;
	return status;
}

enum ts_status ts_tracer_archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *archive)
{
	return ts_particles_archive_column(archive, sim, "marks",
					   ((const struct ts_tracer *)self->state)->column);
}

double *ts_tracer_marks(const struct tsim *sim, const struct ts_tracer *tracer)
{
	return sim->particles->column[tracer->column].data;
}

void ts_tracer_mark(const struct tsim *sim, struct ts_tracer *tracer, size_t i)
{
	double *mark = ts_tracer_marks(sim, tracer) + i;

	tracer->marked += *mark == 0;
	*mark = 1;
}

enum ts_status ts_tracer_require(struct tsim *sim, const struct ts_word *id, struct ts_tracer **out)
{
	struct ts_instance *fix;

	TS_TRY(ts_sim_require(sim, TS_KIND_FIX, id, &fix));
	if (!fix->style->family || !ts_streq(fix->style->family, TS_FAMILY_TRACER))
		return ts_fail(&sim->error, TS_STATE, &id->place,
			       "fix %s is of style %s, expected a fix property/atom/tracer or "
			       "property/atom/tracer/stream",
			       id->text, fix->style->name);
	*out = fix->state;
	return TS_OK;
}

/* ---- outputs ---- */

/* Counts the particles marked since the last evaluation; all evaluations in one step of a run give the
 * same number. */
static enum ts_status eval_new(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	struct ts_tracer *t = self->state;
	int64_t now = sim->clock.step + 1, answer = t->marked - t->told;

	if (sim->run.inside && t->answered == now)
		answer += t->answer;
	if (!sim->reading.probing) {
		t->told = t->marked;
		t->answer = answer;
		t->answered = now;
	}
	out->data[0] = (double)answer;
	return TS_OK;
}

static enum ts_status eval_marks(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const double *mark = ts_tracer_marks(sim, self->state);

	TS_TRY(ts_table_resize(out, sim->particles->n, 1));
	for (size_t i = 0; i < out->rows; i++)
		out->data[i] = mark[i];
	return TS_OK;
}

const struct ts_value ts_tracer_values[] = {
	{ "new", "", "number of particles marked since the last evaluation in another step", TS_SCALAR, 1,
	  NULL, eval_new },
	{ "marks", "", "per particle: 1 marked, 0 not", TS_PERATOM, 1, NULL, eval_marks },
	{ .name = NULL },
};
