/* Pictures of a report: a dump for each view, which lives in the list of dumps like one of the script, so that a run
 * prepares what it reads, but which writes no file and nothing to restart files. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/clock.h"
#include "box/domain.h"
#include "core/life.h"
#include "core/report.h"
#include "image/image.h"
#include "io/png.h"
#include "io/vtk_xml.h"
#include "report/record.h"

#include "base/banned.h"

struct view {
	struct ts_image image;
	struct ts_record *record;
	size_t number;
};

static struct ts_record_view *view_of(const struct ts_instance *self)
{
	const struct view *v = self->state;

	return &v->record->view[v->number];
}

/* ---- pictures that are kept */

static void release_picture(struct ts_record_picture *picture)
{
	ts_free(picture->data);
	*picture = (struct ts_record_picture){ 0 };
}

static size_t bytes_of(const struct ts_record *record)
{
	size_t bytes = 0;

	for (size_t v = 0; v < record->nviews; v++) {
		const struct ts_record_view *view = &record->view[v];

		bytes += view->first.length + view->last.length;
		for (size_t k = 0; k < view->n; k++)
			bytes += view->picture[k].length;
	}
	return bytes;
}

/* Of the pictures every N steps only each second one is kept and drawn from now on. */
static void thin(struct ts_record_view *view)
{
	size_t n = 0;

	view->stride *= 2;
	for (size_t k = 0; k < view->n; k++) {
		if (view->picture[k].step / view->every % view->stride == 0)
			view->picture[n++] = view->picture[k];
		else
			release_picture(&view->picture[k]);
	}
	view->n = n;
}

static enum ts_status keep(struct ts_record *record, struct ts_record_view *view,
			   const struct ts_record_picture *picture)
{
	if (!view->picture)
		view->picture = ts_arena_alloc(&record->arena, TS_RECORD_PICTURES, sizeof *view->picture);
	if (!view->picture)
		return TS_NOMEM;
	while (view->n &&
	       (view->n == TS_RECORD_PICTURES || bytes_of(record) + picture->length > TS_RECORD_BYTES))
		thin(view);
	if (picture->step / view->every % view->stride != 0 ||
	    bytes_of(record) + picture->length > TS_RECORD_BYTES) {
		view->too_large += bytes_of(record) + picture->length > TS_RECORD_BYTES;
		ts_free(picture->data);
		return TS_OK;
	}
	view->picture[view->n++] = *picture;
	return TS_OK;
}

/* ---- drawing */

static enum ts_status encode(struct tsim *sim, const struct ts_picture *from, struct ts_record_picture *out)
{
	struct ts_str png = { 0 }, text = { 0 };
	const bool good = ts_png_encode(from->width, from->height, from->rgb, &png) == TS_OK;

	if (good)
		ts_vtk_add_base64(&text, (const unsigned char *)png.text, png.length);
	ts_str_release(&png);
	if (!good || text.failed) {
		ts_str_release(&text);
		return ts_nomem(&sim->error);
	}
	*out = (struct ts_record_picture){ .step = sim->clock.step,
					   .time = ts_sim_time(sim),
					   .width = from->width,
					   .height = from->height,
					   .data = text.text,
					   .length = text.length };
	return TS_OK;
}

/* out->data NULL: there is nothing to be seen. */
static enum ts_status draw(struct ts_instance *self, struct tsim *sim, struct ts_record_picture *out)
{
	struct view *v = self->state;
	const double start = ts_clock();
	bool drawn;

	*out = (struct ts_record_picture){ 0 };
	ts_deferred_loops_run(sim);
	TS_TRY(ts_image_draw(self, sim, &drawn));
	if (drawn)
		TS_TRY(encode(sim, &v->image.picture, out));
	if (out->length > TS_RECORD_BYTES / 2) {
		view_of(self)->too_large++;
		ts_free(out->data);
		*out = (struct ts_record_picture){ 0 };
	}
	v->record->drawing += ts_clock() - start;
	return TS_OK;
}

static enum ts_status output(struct ts_instance *self, struct tsim *sim)
{
	struct ts_record_view *view = view_of(self);
	const int64_t step = sim->clock.step;
	const bool first = !view->first.data && step == sim->clock.first_step;
	struct ts_record_picture picture;

	if (!first && !(view->every && step % view->every == 0 && step / view->every % view->stride == 0))
		return TS_OK;
	if (view->n && view->picture[view->n - 1].step == step) /* the last one of the run before */
		return TS_OK;
	TS_TRY(draw(self, sim, &picture));
	if (first)
		view->first = picture;
	else if (picture.data && keep(((struct view *)self->state)->record, view, &picture) != TS_OK)
		return ts_nomem(&sim->error);
	return TS_OK;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	return ts_image_read(self, sim);
}

static const struct ts_style picture_style = {
	.name = "report picture",
	.kind = TS_KIND_DUMP,
	.args = ts_image_args,
	.state_size = sizeof(struct view),
	.init = init,
	.modify = ts_image_modify,
	.hook[TS_STAGE_OUTPUT] = output,
	.defers = TS_DEFERS(OUTPUT),
	.fini = ts_image_release,
};

/* ---- views */

/* The zoom at which the box fills a picture of 640 x 480 pixels seen in the default direction. */
static double zoom_to_fit(const struct tsim *sim)
{
	const struct ts_box *box = &sim->domain->box;
	const double theta = sim->dimension == 2 ? 0 : M_PI / 3, phi = sim->dimension == 2 ? 0 : M_PI / 6;
	const double right[3] = { -sin(phi), cos(phi), 0 };
	const double up[3] = { -cos(theta) * cos(phi), -cos(theta) * sin(phi), sin(theta) };
	double width = 0, height = 0, longest = 0;

	if (sim->dimension == 2) {
		width = ts_box_length(box, 0);
		height = ts_box_length(box, 1);
		longest = fmax(width, height);
	}
	for (int d = 0; d < 3 && sim->dimension == 3; d++) {
		width += ts_box_length(box, d) * fabs(right[d]);
		height += ts_box_length(box, d) * fabs(up[d]);
		longest = fmax(longest, ts_box_length(box, d));
	}
	return 0.95 * 2 * longest / fmax(height, 0.75 * width);
}

static enum ts_status default_words(struct ts_record *record, struct tsim *sim, struct ts_record_view *view)
{
	char text[200];

	snprintf(text, sizeof text,
		 "type diameter mesh all voxel all wall all size 640 480 fsaa yes box yes 0.01 zoom %.3g",
		 zoom_to_fit(sim));
	if (ts_words_split(&record->arena, text, &record->where, &view->words) != TS_OK ||
	    ts_words_split(&record->arena, "backcolor white boxcolor gray", &record->where, &view->modify) !=
		    TS_OK)
		return ts_nomem(&sim->error);
	return TS_OK;
}

/* EVERY FILE COLOR DIAMETER ...: the file is that of the report. */
static enum ts_status dump_words(struct ts_record *record, struct tsim *sim,
				 const struct ts_record_view *view, struct ts_words *out)
{
	struct ts_word *word = ts_arena_alloc(&record->arena, view->words.n + 2, sizeof *word);

	if (!word)
		return ts_nomem(&sim->error);
	word[0] = (struct ts_word){ .text = "1", .place = view->where };
	word[1] = (struct ts_word){ .text = record->file ? record->file : "report", .place = view->where };
	memcpy(word + 2, view->words.word, view->words.n * sizeof *word);
	*out = (struct ts_words){ word, view->words.n + 2 };
	return TS_OK;
}

/* Without a report the words are checked, but nothing is drawn. */
static enum ts_status define(struct ts_record *record, struct tsim *sim, size_t k)
{
	struct ts_record_view *view = &record->view[k];
	const struct ts_word id = { .text = view->id, .place = view->where };
	struct ts_instance *dump;
	struct ts_words words;
	struct view *state;

	if (view->automatic) /* the box may be another one after `clear` */
		TS_TRY(default_words(record, sim, view));
	TS_TRY(dump_words(record, sim, view, &words));
	TS_TRY(ts_sim_create(sim, TS_KIND_DUMP, &picture_style, view->id, 0, words, &view->where, &dump));
	state = dump->state;
	state->record = record;
	state->number = k;
	state->image.unless_empty = view->automatic;
	TS_TRY(ts_dump_modify_words(sim, "report picture: modify", dump, view->modify, &record->arena,
				    &view->where));
	view->tried = true;
	return record->file ? TS_OK : ts_sim_destroy(sim, TS_KIND_DUMP, &id);
}

static enum ts_status new_view(struct ts_record *record, struct tsim *sim, const struct ts_place *where,
			       struct ts_record_view **out)
{
	struct ts_record_view *view = &record->view[record->nviews];

	if (record->nviews == TS_RECORD_VIEWS)
		return ts_fail(&sim->error, TS_RANGE, where,
			       "report picture: a report has at most %d views, and these have been given",
			       TS_RECORD_VIEWS);
	*view = (struct ts_record_view){ .stride = 1, .where = *where };
	snprintf(view->id, sizeof view->id, "report:%zu", record->nviews + 1);
	record->nviews++;
	*out = view;
	return TS_OK;
}

enum ts_status ts_record_views_begin(struct ts_record *record, struct tsim *sim)
{
	struct ts_record_view *view;

	if (!ts_sim_has_box(sim))
		return TS_OK;
	if (record->file && !record->nviews && !record->no_pictures) {
		TS_TRY(new_view(record, sim, &record->where, &view));
		view->automatic = true;
	}
	for (size_t k = 0; k < record->nviews; k++)
		if (record->file ? !ts_sim_find(sim, TS_KIND_DUMP, record->view[k].id)
				 : !record->view[k].tried)
			TS_TRY(define(record, sim, k));
	return TS_OK;
}

/* ---- the words of `report picture` */

/* Words before and after `modify`. */
static enum ts_status split_words(struct ts_record *record, struct tsim *sim, struct ts_words words,
				  struct ts_record_view *view)
{
	struct ts_words copy;
	size_t n = 0;

	if (ts_words_copy(&record->arena, words, &copy) != TS_OK)
		return ts_nomem(&sim->error);
	while (n < copy.n && !ts_streq(copy.word[n].text, "modify"))
		n++;
	view->words = (struct ts_words){ copy.word, n };
	view->modify = ts_words_from(copy, n + 1);
	return TS_OK;
}

/* The same line executed again, in a loop, is the same view. */
static bool is_known(const struct ts_record *record, const struct ts_place *where)
{
	for (size_t k = 0; k < record->nviews; k++)
		if (where->line && record->view[k].where.line == where->line &&
		    ts_streq(record->view[k].where.file, where->file))
			return true;
	return false;
}

enum ts_status ts_record_add_view(struct ts_record *record, struct tsim *sim, struct ts_words words,
				  const struct ts_place *where)
{
	struct ts_record_view *view;
	int64_t every = 0;

	if (words.n == 1 && ts_streq(words.word[0].text, "none")) {
		record->no_pictures = true;
		return TS_OK;
	}
	if (is_known(record, where))
		return TS_OK;
	if (!words.n || (!ts_streq(words.word[0].text, "ends") &&
			 (!ts_parse_int(words.word[0].text, &every) || every < 1)))
		return ts_fail(&sim->error, TS_SYNTAX, words.n ? &words.word[0].place : where,
			       "report picture: found '%s', expected none, ends, or a number of steps > 0 "
			       "between pictures, then the words of dump image: COLOR DIAMETER ...",
			       words.n ? words.word[0].text : "");
	TS_TRY(new_view(record, sim, where, &view));
	view->every = every;
	return split_words(record, sim, ts_words_from(words, 1), view);
}

/* ---- the last state */

static void draw_last(struct ts_record *record, struct tsim *sim, struct ts_record_view *view)
{
	struct ts_instance *dump = ts_sim_find(sim, TS_KIND_DUMP, view->id);
	struct ts_record_picture picture = { 0 };
	enum ts_status status;

	if (!dump || dump->style != &picture_style)
		return;
	status = init(dump, sim);
	if (status == TS_OK)
		status = draw(dump, sim, &picture);
	view->trouble = status == TS_OK ? NULL : ts_arena_strdup(&record->arena, sim->error.message);
	if (status != TS_OK || !picture.data)
		return;
	release_picture(&view->last);
	view->last = picture;
}

void ts_record_views_end(struct ts_record *record, struct tsim *sim)
{
	const struct ts_error before = sim->error;

	for (size_t k = 0; k < record->nviews; k++) {
		ts_error_clear(&sim->error);
		draw_last(record, sim, &record->view[k]);
	}
	sim->error = before;
}

void ts_record_views_release(struct ts_record *record)
{
	for (size_t k = 0; k < record->nviews; k++) {
		struct ts_record_view *view = &record->view[k];

		release_picture(&view->first);
		release_picture(&view->last);
		for (size_t i = 0; i < view->n; i++)
			release_picture(&view->picture[i]);
	}
}
