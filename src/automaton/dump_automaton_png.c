/* Dump automaton/png: pictures of the granules. */
#include <inttypes.h>
#include <math.h>
#include <string.h>

#include "automaton/automaton.h"
#include "base/alloc.h"
#include "dump/dump_vtk.h"
#include "io/movie.h"
#include "io/png.h"

#include "base/banned.h"

enum { BY_U, BY_V, BY_SPEED };
static const char *const colours[] = { "u", "v", "speed", NULL };
enum { MOST_PIXELS = 16384 }; /* along an edge */

struct state {
	struct ts_dump_common common;
	int64_t scale;
	int colour;
	const char *film; /* file of the movie; NULL: none */
	struct ts_movie movie;
	unsigned char *rgb;
	size_t capacity;
};

struct size {
	uint32_t width, height;
};

static const unsigned char background[3] = { 255, 255, 255 }, solid[3] = { 90, 90, 90 };

/* The lattice with a row of pixels for each wall. */
static struct size size_of(const struct state *s, const struct ts_automaton *a)
{
	return (struct size){ (uint32_t)(s->scale * a->lattice.nx),
			      (uint32_t)(s->scale * (a->lattice.ny + 2)) };
}

/* Without ffmpeg the frames are written nevertheless. */
static enum ts_status check_movie(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	const char *obstacle = ts_movie_obstacle(sim);

	if (!s->film)
		return TS_OK;
	if (!ts_movie_is_name(s->film))
		return ts_fail(&sim->error, TS_SYNTAX, ts_instance_word(self, s->film),
			       "dump automaton/png: movie '%s': expected a name that ends "
			       "in " TS_MOVIE_ENDINGS,
			       s->film);
	if (obstacle) {
		ts_warn(&sim->log, ts_instance_word(self, s->film),
			"dump automaton/png: there will be frames, but no movie '%s': %s", s->film, obstacle);
		s->film = NULL;
	}
	return TS_OK;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	const struct state *s = self->state;
	const char *file = s->common.file;
	struct ts_automaton *a;

	TS_TRY(ts_automaton_require(sim, "dump automaton/png", &self->where, &a));
	if (!strchr(file, '*') || !ts_ends_with(file, ".png"))
		return ts_fail(&sim->error, TS_SYNTAX, ts_instance_word(self, file),
			       "dump automaton/png writes one file per frame: the name '%s' needs a `*` for "
			       "the step and must end in .png",
			       file);
	if (s->scale * a->lattice.nx > MOST_PIXELS || s->scale * (a->lattice.ny + 2) > MOST_PIXELS)
		return ts_fail(&sim->error, TS_RANGE, &self->where,
			       "dump automaton/png: %d x %d cells of %d pixels are a picture of more than %d "
			       "pixels along an edge: use a smaller scale, or dump automaton/vtk",
			       a->lattice.nx, a->lattice.ny, (int)s->scale, MOST_PIXELS);
	return check_movie(self, sim);
}

/* -1 blue, 0 light grey, 1 red */
static void colour_of(double value, unsigned char out[3])
{
	static const double ends[3][3] = { { 40, 70, 200 }, { 205, 205, 205 }, { 200, 30, 30 } };
	const double t = fmin(fmax(value, -1), 1), part = fabs(t);
	const double *end = ends[t < 0 ? 0 : 2];

	for (int k = 0; k < 3; k++)
		out[k] = (unsigned char)lrint((1 - part) * ends[1][k] + part * end[k]);
}

static double value_of(const struct state *s, const struct ts_automaton *a, uint32_t w)
{
	const struct ts_laws_velocity v = ts_laws_velocity_of(w);
	const double fastest = fmax(fabs(a->wall[0]), fabs(a->wall[1]));
	const double scale = fastest > 0 ? ts_automaton_unit(a) / fastest : 1.0 / TS_CELL_ONE;

	if (s->colour == BY_SPEED)
		return scale * ts_cell_speed(w);
	return scale * (s->colour == BY_U ? v.x : v.y);
}

/* Fills a cell: a disc for a granule if there are enough pixels. */
static void draw_cell(const struct state *s, uint32_t width, size_t row, size_t column,
		      const unsigned char colour[3], bool disc)
{
	const int n = (int)s->scale;

	for (int j = 0; j < n; j++)
		for (int i = 0; i < n; i++) {
			const int x = 2 * i + 1 - n, y = 2 * j + 1 - n;
			const bool inside = !disc || n < 4 || x * x + y * y <= n * n;

			memcpy(s->rgb + 3 * ((row * (size_t)n + (size_t)j) * width + column * (size_t)n +
					     (size_t)i),
			       inside ? colour : background, 3);
		}
}

static void draw(const struct state *s, const struct ts_automaton *a)
{
	const struct ts_automaton_lattice *l = &a->lattice;
	const uint32_t width = size_of(s, a).width;

	for (int y = -1; y <= l->ny; y++)
		for (int x = 0; x < l->nx; x++) {
			const uint32_t w = l->cell[ts_automaton_at(l, x, y)];
			unsigned char colour[3];

			memcpy(colour, ts_cell_state(w) == TS_CELL_FIXED ? solid : background, 3);
			if (ts_cell_is_granule(w))
				colour_of(value_of(s, a, w), colour);
			draw_cell(s, width, (size_t)(l->ny - y), (size_t)x, colour, ts_cell_is_granule(w));
		}
}

/* After a restart the movie begins anew. */
static enum ts_status add_to_movie(struct ts_instance *self, struct tsim *sim, struct size size)
{
	struct state *s = self->state;

	if (!s->film)
		return TS_OK;
	if (s->movie.frames == 0 && s->common.frames > 1)
		ts_warn(&sim->log, &self->where,
			"dump automaton/png: the movie '%s' begins at step %" PRId64
			"; frames before the restart are pictures only",
			s->film, sim->clock.step);
	return ts_movie_add(&s->movie, sim, &self->where, s->film, size.width, size.height, s->rgb);
}

static enum ts_status output(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	struct ts_automaton *a;
	struct size size;
	bool due;

	TS_TRY(ts_dump_due(self, sim, &due));
	if (!due)
		return TS_OK;
	TS_TRY(ts_automaton_require(sim, "dump automaton/png", &self->where, &a));
	size = size_of(s, a);
	if (TS_GROW(s->rgb, s->capacity, 3 * (size_t)size.width * size.height) != TS_OK)
		return ts_nomem(&sim->error);
	draw(s, a);
	TS_TRY(ts_dump_vtk_path(&s->common, sim));
	TS_TRY(ts_png_write(sim, ts_str_text(&s->common.path), &self->where, size.width, size.height,
			    s->rgb));
	return add_to_movie(self, sim, size);
}

static enum ts_status complete_movie(struct ts_instance *self, struct tsim *sim)
{
	(void)sim;
	return ts_movie_end(&((struct state *)self->state)->movie);
}

static enum ts_status plan(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report)
{
	const double packed = 0.1; /* of three bytes per pixel, for discs in cells of 8 pixels */
	struct ts_automaton *a;
	struct size size;

	TS_TRY(ts_automaton_require(sim, "dump automaton/png", &self->where, &a));
	size = size_of(self->state, a);
	return ts_dump_price_frame(self, sim, 3 * packed * size.width * size.height, report);
}

static void fini(struct ts_instance *self)
{
	struct state *s = self->state;

	ts_movie_end(&s->movie);
	ts_free(s->rgb);
	ts_dump_fini(self);
}

static const struct ts_arg args[] = {
	TS_INT("every", struct state, common.every, .flags = TS_POSITIONAL, .range = TS_POSITIVE,
	       .help = "steps between frames"),
	TS_WORD("file", struct state, common.file, .flags = TS_POSITIONAL | TS_WRITES,
		.help = "file name, ending in .png, with `*` for the step"),
	TS_INT("scale", struct state, scale, .range = TS_WITHIN, .lo = 1, .hi = 64, .fallback = "8",
	       .help = "pixels along the edge of a cell"),
	TS_ENUM("colour", struct state, colour, colours, .fallback = "u",
		.help = "velocity along x, along y, or the speed, by the speed of the faster wall"),
	TS_WORD("movie", struct state, film, .flags = TS_OPTIONAL | TS_WRITES,
		.help = "file for a movie of the frames, made by ffmpeg: its name ends in " TS_MOVIE_ENDINGS),
	TS_REAL("framerate", struct state, movie.rate, .range = TS_POSITIVE, .fallback = "24",
		.help = "frames a second of the movie"),
	TS_ARGS_END,
};

static const struct ts_saved saved[] = { TS_DUMP_SAVED(struct state), TS_SAVED_ROWS_END };

TS_STYLE(dump, ts_style, ts_dump_automaton_png)
const struct ts_style ts_dump_automaton_png = {
	.name = "automaton/png",
	.kind = TS_KIND_DUMP,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.due = ts_dump_may_be_due,
	.names = ts_dump_names,
	.summary = "Writes pictures of an automaton",
	.doc = "Each granule is a disc (with a scale below 4 a square) with the colour of its velocity: red "
	       "as\n"
	       "the faster wall, grey at rest, blue against it. Walls and obstacles are dark.\n"
	       "\n"
	       "With `movie` the program ffmpeg, which must be on the PATH, makes a movie of the frames; "
	       "without\n"
	       "ffmpeg there is a warning, and the frames are written. The movie is complete after `undump` "
	       "or at\n"
	       "the end of the script; after a restart it begins anew. If ffmpeg fails, for instance as the "
	       "disk is\n"
	       "full, the run ends with its message. A movie is also made of frames by `ffmpeg -i "
	       "frame%06d.png\n"
	       "film.mp4`, with names that `dump_modify ID pad 6` makes.",
	.example = "dump picture all automaton/png 10 post/frame*.png scale 8 movie post/film.mp4\n"
		   "dump_modify picture pad 6",
	.args = args,
	.state_size = sizeof(struct state),
	.saved = saved,
	.init = init,
	.plan = plan,
	.hook[TS_STAGE_OUTPUT] = output,
	.close = complete_movie,
	.fini = fini,
};
