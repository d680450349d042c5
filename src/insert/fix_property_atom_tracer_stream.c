/* Fix property/atom/tracer/stream: marks particles that fix insert/stream inserts. */
#include "base/sort.h"
#include "insert/stream.h"
#include "insert/tracer.h"

#include <inttypes.h>
#include <stdlib.h>

#include "core/archive.h"

#include "base/banned.h"

/* A request to mark `left` more particles that pass the face in this step or later. */
struct request {
	int64_t step, left;
};

/* A particle that moves to the face. */
struct passage {
	int64_t step;	 /* in which it passes the face */
	double distance; /* initial distance to the face: order of those that pass in the same step */
	size_t i;
};

struct state {
	struct ts_tracer tracer;
	const char *stream_id, *every_word;
	int64_t step, number;

	const struct ts_instance *stream;
	int64_t every; /* steps between requests; 0: a single request */
	struct passage *passage;
	size_t passage_capacity;
	/* saved */
	struct request *request; /* [nrequests], by step */
	size_t nrequests, capacity;
	int64_t next; /* step of the next request */
	int64_t seen; /* age of the stream at the last insertion */
	int32_t started;
};

static enum ts_status add_request(struct state *s, struct tsim *sim, int64_t step)
{
	if (TS_GROW(s->request, s->capacity, s->nrequests + 1) != TS_OK)
		return ts_nomem(&sim->error);
	s->request[s->nrequests++] = (struct request){ step, s->number };
	return TS_OK;
}

static enum ts_status find_stream(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	struct ts_word id = { .text = s->stream_id, .place = *ts_instance_word(self, s->stream_id) };
	struct ts_instance *fix;

	TS_TRY(ts_sim_require(sim, TS_KIND_FIX, &id, &fix));
	if (!fix->style->family || !ts_streq(fix->style->family, TS_FAMILY_STREAM))
		return ts_fail(&sim->error, TS_STATE, &id.place,
			       "fix %s is of style %s, expected a fix insert/stream", id.text,
			       fix->style->name);
	s->stream = fix;
	return TS_OK;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	TS_TRY(find_stream(self, sim));
	if (!ts_streq(s->every_word, "once") && (!ts_parse_int(s->every_word, &s->every) || s->every < 1))
		return ts_fail(&sim->error, TS_SYNTAX, ts_instance_word(self, s->every_word),
			       "fix property/atom/tracer/stream: every is '%s', expected once or a number of "
			       "steps > 0",
			       s->every_word);
	TS_TRY(ts_tracer_init(self, sim));
	if (s->started)
		return TS_OK;
	s->started = 1;
	s->next = s->step + s->every;
	return add_request(s, sim, s->step);
}

/* ---- after an insertion of the stream ---- */

/* Drops requests older than the previous insertion, with a warning if they are not complete, and adds
 * those of this insertion. In LIGGGHTS the interval between insertions does not include its first step: a
 * request for just this step is lost. */
static enum ts_status update_requests(struct ts_instance *self, struct tsim *sim, int64_t interval)
{
	struct state *s = self->state;
	int64_t now = sim->clock.step;
	size_t kept = 0;

	for (size_t k = 0; k < s->nrequests; k++) {
		if (s->request[k].step >= now - interval)
			s->request[kept++] = s->request[k];
		else if (s->request[k].left > 0)
			ts_warn(&sim->log, &self->where,
				"fix property/atom/tracer/stream: %" PRId64 " of %" PRId64
				" particles could not be marked that were to pass the face after step "
				"%" PRId64,
				s->request[k].left, s->number, s->request[k].step);
	}
	s->nrequests = kept;
	for (; s->next < now + interval; s->next += s->every)
		if (s->next > now || (s->next == now && sim->legacy != TS_LEGACY_LIGGGHTS))
			TS_TRY(add_request(s, sim, s->next));
	return TS_OK;
}

static int compare_passages(const void *a, const void *b)
{
	const struct passage *p = a, *q = b;

	if (p->step != q->step)
		return p->step < q->step ? -1 : 1;
	return (p->distance > q->distance) - (p->distance < q->distance);
}

/* Lists the particles of the group that the insertion has created, in the order in which they pass the
 * face. */
static enum ts_status list_passages(struct ts_instance *self, struct tsim *sim, size_t *n)
{
	struct state *s = self->state;
	const struct ts_particles *p = sim->particles;
	const struct ts_stream *stream = s->stream->state;
	const double age = (double)stream->age;

	*n = 0;
	for (size_t i = 0; i < p->n; i++) {
		const double *memory = ts_stream_record(stream, sim, i);

		if (memory[TS_STREAM_START] != age || !(memory[TS_STREAM_RELEASE] > 0) ||
		    memory[TS_STREAM_DISTANCE] < 0 || !ts_in_group(p, i, self->group))
			continue;
		if (TS_GROW(s->passage, s->passage_capacity, *n + 1) != TS_OK)
			return ts_nomem(&sim->error);
		s->passage[(*n)++] =
			(struct passage){ sim->clock.step + (int64_t)(memory[TS_STREAM_RELEASE] - age),
					  memory[TS_STREAM_DISTANCE], i };
	}
	ts_sort(s->passage, *n, sizeof *s->passage, compare_passages);
	return TS_OK;
}

static enum ts_status post_build(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	const struct ts_stream *stream = s->stream->state;
	size_t n;

	if (s->seen == stream->age)
		return TS_OK;
	TS_TRY(list_passages(self, sim, &n));
	if (!n) /* a rebuild without an insertion */
		return TS_OK;
	s->seen = stream->age;
	if (s->every)
		TS_TRY(update_requests(self, sim, stream->base.every));
	for (size_t k = 0; k < s->nrequests; k++) {
		struct request *r = &s->request[k];

		for (size_t j = 0; j < n && r->left > 0; j++) {
			if (s->passage[j].step < r->step ||
			    ts_tracer_marks(sim, &s->tracer)[s->passage[j].i] != 0)
				continue;
			ts_tracer_mark(sim, &s->tracer, s->passage[j].i);
			r->left--;
		}
	}
	return TS_OK;
}

/* Which particles of an insertion are marked depends on all of them. */
static bool stream_inserts(const struct ts_instance *self, const struct tsim *sim)
{
	return ts_insertion_due(((const struct state *)self->state)->stream, sim);
}

static enum ts_status archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a)
{
	struct state *s = self->state;
	void *data = s->request;
	size_t count = 2 * s->nrequests, capacity = 2 * s->capacity;
	enum ts_status status;

	TS_TRY(ts_tracer_archive(self, sim, a));
	status = ts_archive_array(a, "requests", TS_SAVED_I64, &data, &capacity, &count);
	s->request = data;
	s->nrequests = count / 2;
	s->capacity = capacity / 2;
	return status;
}

static void fini(struct ts_instance *self)
{
	struct state *s = self->state;

	ts_free(s->request);
	ts_free(s->passage);
}

static const struct ts_arg args[] = {
	TS_WORD("insert_stream", struct state, stream_id,
		.help = "ID of the fix insert/stream whose particles are marked"),
	TS_INT("mark_step", struct state, step, .range = TS_NOT_NEGATIVE, .flags = TS_STATEFUL,
	       .help = "particles that pass the face in this step or later are marked"),
	TS_INT("n_tracer", struct state, number, .range = TS_POSITIVE, .flags = TS_STATEFUL,
	       .help = "number of particles that are marked"),
	TS_WORD("every", struct state, every_word, .flags = TS_STATEFUL,
		.help = "once, or the number of steps after which the next n_tracer particles are marked"),
	TS_ARGS_END,
};

static const struct ts_saved saved[] = {
	TS_TRACER_SAVED(struct state),
	TS_SAVE_I64(struct state, next),
	TS_SAVE_I64(struct state, seen),
	TS_SAVE_I32(struct state, started),
	TS_SAVED_ROWS_END,
};

TS_STYLE(fix, ts_style, ts_fix_property_atom_tracer_stream)
const struct ts_style ts_fix_property_atom_tracer_stream = {
	.name = "property/atom/tracer/stream",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_OWN | TS_RANKS_OUTPUTS | TS_RANKS_STEPS,
	.due = stream_inserts,
	.summary = "Marks particles that pass the face of a fix insert/stream",
	.doc = "Marks the first n_tracer particles of the group that pass the face of fix insert/stream in "
	       "the step mark_step or later; with `every E` n_tracer more from the step mark_step + E on, "
	       "and so on. Particles are marked when they are inserted, since the step in which they pass "
	       "the face is known then.\n\n"
	       "If an insertion has too few particles, those of the next one are marked; what is missing "
	       "after that is dropped with a warning, except with `every once`. Of a rigid clump the first "
	       "sphere is marked.\n\n"
	       "f_ID of a particle is 1 if it is marked, else 0. f_ID as a scalar is the number of particles "
	       "marked since its last evaluation in another step.",
	.example = "fix tracer all property/atom/tracer/stream mark_step 10000 insert_stream pour n_tracer "
		   "20 every 10000",
	.family = TS_FAMILY_TRACER,
	.args = args,
	.state_size = sizeof(struct state),
	.saved = saved,
	.archive = archive,
	.values = ts_tracer_values,
	.init = init,
	.hook = { [TS_STAGE_POST_BUILD] = post_build },
	.fini = fini,
};
