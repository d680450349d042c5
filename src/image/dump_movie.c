/* Dump movie: the pictures of dump image as a movie, encoded by ffmpeg. */
#include <inttypes.h>
#include <string.h>

#include "core/report.h"
#include "image/image.h"
#include "io/movie.h"

#include "base/banned.h"

struct state {
	struct ts_image image;
	struct ts_movie movie;
	struct ts_str part; /* name of the file of this run, if it is not that of the script */
};

static enum ts_status check_name(struct ts_instance *self, struct tsim *sim)
{
	const char *file = ((const struct ts_image *)self->state)->common.file;
	const char *obstacle = ts_movie_obstacle(sim);

	if (!ts_movie_is_name(file))
		return ts_fail(&sim->error, TS_SYNTAX, ts_instance_word(self, file),
			       "dump movie: the name of the file must end in " TS_MOVIE_ENDINGS
			       ", found '%s'",
			       file);
	if (obstacle)
		return ts_fail(&sim->error, TS_STATE, ts_instance_word(self, file),
			       "dump movie: no movie '%s': %s; dump image writes the frames without it", file,
			       obstacle);
	return TS_OK;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	TS_TRY(check_name(self, sim));
	return ts_image_read(self, sim);
}

/* Frames before a restart are in the file of the run before, which is kept: the new ones get a name with the step, as
 * film.12000.mp4 for film.mp4. */
static enum ts_status name_part(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	const char *file = s->image.common.file, *ending = strrchr(file, '.');

	if (s->movie.frames > 0 || s->image.common.frames <= 1)
		return TS_OK;
	ts_str_clear(&s->part);
	ts_str_addf(&s->part, "%.*s.%" PRId64 "%s", (int)(ending - file), file, sim->clock.step, ending);
	if (s->part.failed)
		return ts_nomem(&sim->error);
	ts_warn(&sim->log, &self->where,
		"dump %s: the movie '%s' goes on from this restart file in '%s'; `ffmpeg -f concat` joins "
		"them",
		self->id, file, ts_str_text(&s->part));
	return TS_OK;
}

static enum ts_status output(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	const struct ts_picture *p = &s->image.picture;
	bool due, drawn;

	TS_TRY(ts_dump_due(self, sim, &due));
	if (!due)
		return TS_OK;
	TS_TRY(ts_image_draw(self, sim, &drawn));
	if (!drawn)
		return TS_OK;
	TS_TRY(name_part(self, sim));
	ts_image_warn_frames(self, sim, 0);
	s->movie.rate = s->image.framerate;
	s->movie.bitrate = (int64_t)s->image.bitrate;
	return ts_movie_add(&s->movie, sim, ts_instance_word(self, s->image.common.file),
			    s->part.length ? ts_str_text(&s->part) : s->image.common.file, p->width,
			    p->height, p->rgb);
}

static enum ts_status complete(struct ts_instance *self, struct tsim *sim)
{
	(void)sim;
	return ts_movie_end(&((struct state *)self->state)->movie);
}

static enum ts_status plan(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report)
{
	const struct ts_image *s = self->state;
	const double kbit = s->bitrate > 0 ? s->bitrate : 2000;

	report->bytes += ts_image_memory(s);
	return ts_dump_price_frame(self, sim, 125 * kbit / s->framerate, report);
}

static void fini(struct ts_instance *self)
{
	struct state *s = self->state;

	ts_movie_end(&s->movie);
	ts_str_release(&s->part);
	ts_image_release(self);
}

TS_STYLE(dump, ts_style, ts_dump_movie)
const struct ts_style ts_dump_movie = {
	.name = "movie",
	.kind = TS_KIND_DUMP,
	.dump_words = "element thresh region",
	.ranks = TS_RANKS_WHOLE,
	.due = ts_dump_may_be_due,
	.names = ts_dump_names,
	.summary = "Makes a movie of the pictures of dump image",
	.purpose = "A movie of the run, made by the program ffmpeg; the words are those of dump image.",
	.doc = "Draws what dump image draws and gives the pictures to the program ffmpeg, which must be on "
	       "the PATH. The movie is complete after `undump` or at the end of the script; after a restart "
	       "the frames that follow are in a file with the step in its name, film.12000.mp4 for film.mp4. "
	       "dump_modify framerate and bitrate are those of the movie.",
	.doc_more = ts_image_text,
	.example = "dump film all movie 500 post/film.mp4 vx diameter size 1280 720 fsaa yes\n"
		   "dump_modify film framerate 30 backcolor white",
	.args = ts_image_args,
	.groups = ts_image_groups,
	.state_size = sizeof(struct state),
	.saved = ts_image_saved,
	.archive = ts_dump_archive,
	.init = init,
	.modify = ts_image_modify,
	.plan = plan,
	.hook[TS_STAGE_OUTPUT] = output,
	.defers = TS_DEFERS(OUTPUT),
	.close = complete,
	.fini = fini,
};
