/* Fix surface/voxel: a height field. */
#include <inttypes.h>
#include <math.h>

#include "base/axes.h"
#include "box/domain.h"
#include "core/report.h"
#include "math/constants.h"
#include "math/vec3.h"
#include "voxel/voxel_noise.h"
#include "voxel/voxel_source.h"
#include "voxel/voxel_surface.h"

#include "base/banned.h"

enum { STAYS = -1, LINEAR, WIGGLE };

struct motion {
	int mode;
	double velocity[3], amplitude[3], period;
};

struct state {
	struct ts_voxel_surface surface;
	struct ts_voxel_source source;
	struct ts_words cells, origin, size, move_words;
	int normal;
	double datum, base;
	struct motion motion;
	/* saved: the time since the definition of the fix is began + steps dt */
	double began, dt;
	int64_t steps;
};

static const char *const noises[] = {
	[TS_VOXEL_NOISE_COLUMNS] = "columns", [TS_VOXEL_NOISE_WAVES] = "waves", NULL
};

/* ---- the shape of the field */

struct pair {
	double number[2];
	int64_t count[2];
};
static const struct ts_arg cell_rows[] = {
	TS_INT("first", struct pair, count[0], .flags = TS_POSITIONAL, .range = TS_POSITIVE),
	TS_INT("second", struct pair, count[1], .flags = TS_POSITIONAL, .range = TS_POSITIVE),
	TS_ARGS_END,
};
static const struct ts_arg origin_rows[] = {
	TS_REAL("first", struct pair, number[0], .flags = TS_POSITIONAL),
	TS_REAL("second", struct pair, number[1], .flags = TS_POSITIONAL),
	TS_ARGS_END,
};
static const struct ts_arg size_rows[] = {
	TS_REAL("first", struct pair, number[0], .flags = TS_POSITIONAL, .range = TS_POSITIVE),
	TS_REAL("second", struct pair, number[1], .flags = TS_POSITIONAL, .range = TS_POSITIVE),
	TS_ARGS_END,
};

static enum ts_status read_pair(struct ts_instance *self, struct tsim *sim, const char *what,
				const struct ts_arg *rows, struct ts_words words, struct pair *out)
{
	*out = (struct pair){ .count = { 0 } };
	return words.n ? ts_args_parse(sim, what, rows, words, ts_instance_word(self, words.word[0].text),
				       &self->arena, out)
		       : TS_OK;
}

/* The number of columns: that of the file, or as given; both must be the same. */
static enum ts_status read_cells(struct ts_instance *self, struct tsim *sim, const struct ts_voxel_grid *grid)
{
	struct state *s = self->state;
	struct ts_voxel_field *f = &s->surface.field;
	struct pair cells;

	TS_TRY(read_pair(self, sim, "fix surface/voxel: cells", cell_rows, s->cells, &cells));
	if (!s->cells.n && !grid->n[0])
		return ts_fail(&sim->error, TS_SYNTAX, &self->where,
			       "fix surface/voxel: how many columns? `cells 100 100`");
	for (int d = 0; d < 2; d++) {
		f->n[d] = s->cells.n ? cells.count[d] : grid->n[d];
		if (grid->n[0] && f->n[d] != grid->n[d])
			return ts_fail(&sim->error, TS_RANGE, ts_instance_word(self, s->source.file),
				       "fix surface/voxel: '%s' has %" PRId64 " x %" PRId64
				       " heights, but cells are %" PRId64 " x %" PRId64,
				       s->source.file, grid->n[0], grid->n[1], cells.count[0],
				       cells.count[1]);
	}
	if (f->n[0] > TS_VOXEL_MOST_COLUMNS / f->n[1])
		return ts_fail(&sim->error, TS_RANGE, &self->where,
			       "fix surface/voxel: %" PRId64 " x %" PRId64
			       " columns are too many: at most %d",
			       f->n[0], f->n[1], TS_VOXEL_MOST_COLUMNS);
	return TS_OK;
}

/* Coordinates along the axes of the field: those given, else those of the box. */
static enum ts_status read_extent(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	const struct ts_box *box = &sim->domain->box;
	struct ts_voxel_field *f = &s->surface.field;
	struct pair origin, size;

	TS_TRY(read_pair(self, sim, "fix surface/voxel: origin", origin_rows, s->origin, &origin));
	TS_TRY(read_pair(self, sim, "fix surface/voxel: size", size_rows, s->size, &size));
	for (int d = 0; d < 2; d++) {
		int axis = f->axis[d];
		double length = ts_box_length(box, axis), extent = s->size.n ? size.number[d] : length, end;

		f->origin[d] = s->origin.n ? origin.number[d] : box->lo[axis];
		f->width[d] = extent / (double)f->n[d];
		/* it spans a periodic box if its ends are images of each other */
		f->periodic[d] = ts_box_periodic(box, axis) && fabs(extent - length) <= 1e-9 * length;
		if (f->periodic[d])
			f->width[d] = length / (double)f->n[d];
		else if (ts_box_periodic(box, axis) && extent > length)
			return ts_fail(&sim->error, TS_RANGE, ts_instance_word(self, "size"),
				       "fix surface/voxel: the field is longer than the periodic box along "
				       "%s, %g and %g: it would overlap its own images",
				       ts_axis_names[axis], extent, length);
		end = ts_voxel_border(f, d, f->n[d]);
		if (ts_voxel_border(f, d, 1) > f->origin[d] && end > ts_voxel_border(f, d, f->n[d] - 1))
			continue;
		return ts_fail(&sim->error, TS_RANGE, &self->where,
			       "fix surface/voxel: columns of width %g from %g to %g along %s: neighbours "
			       "have the same coordinate, rounded",
			       f->width[d], f->origin[d], end, ts_axis_names[axis]);
	}
	return TS_OK;
}

static enum ts_status read_base(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	struct ts_voxel_field *f = &s->surface.field;

	f->base = isnan(s->base) ? -INFINITY : s->base;
	if (isnan(s->base) && ts_box_periodic(&sim->domain->box, f->axis[2]))
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "fix surface/voxel: the box is periodic along %s, the axis of the heights, "
			       "and the columns have no bottom: give a `base`, or let the box be fixed there "
			       "(`boundary`)",
			       ts_axis_names[f->axis[2]]);
	return TS_OK;
}

static enum ts_status make_field(struct ts_instance *self, struct tsim *sim, const struct ts_voxel_grid *grid)
{
	struct state *s = self->state;
	struct ts_voxel_field *f = &s->surface.field;

	for (int d = 0; d < 3; d++)
		f->axis[d] = (s->normal + 1 + d) % 3;
	TS_TRY(read_cells(self, sim, grid));
	TS_TRY(read_extent(self, sim));
	TS_TRY(read_base(self, sim));
	if (ts_voxel_field_make(f) != TS_OK)
		return ts_nomem(&sim->error);
	return ts_voxel_source_fill(self, sim, &s->source, grid, isnan(s->datum) ? -INFINITY : s->datum, f);
}

static enum ts_status load_field(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	struct ts_voxel_grid grid = { .n = { 0 } };
	enum ts_status status = ts_voxel_source_read(self, sim, &s->source, &grid);

	if (status == TS_OK)
		status = make_field(self, sim, &grid);
	ts_voxel_grid_release(&grid);
	if (status != TS_OK)
		ts_voxel_field_release(&s->surface.field);
	return status;
}

/* Walls look at three images along the heights: the nearest, and those above and below. */
static enum ts_status check_height(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_voxel_field *f = &((struct state *)self->state)->surface.field;
	double length = ts_box_length(&sim->domain->box, f->axis[2]);
	double height = f->level[f->nlevels - 1].top[0] - f->base;

	if (!ts_box_periodic(&sim->domain->box, f->axis[2]) || !(height > length))
		return TS_OK;
	return ts_fail(&sim->error, TS_RANGE, &self->where,
		       "fix surface/voxel: the highest column is longer than the periodic box along %s, %g "
		       "and %g: it "
		       "would overlap its own images; raise the `base`",
		       ts_axis_names[f->axis[2]], height, length);
}

/* The box may have changed since the field was made to span it. */
static enum ts_status check_period(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_voxel_field *f = &((struct state *)self->state)->surface.field;

	for (int d = 0; d < 2; d++) {
		double length = ts_box_length(&sim->domain->box, f->axis[d]);

		if (f->periodic[d] && !(fabs((double)f->n[d] * f->width[d] - length) <= 1e-9 * length))
			return ts_fail(&sim->error, TS_STATE, &self->where,
				       "fix surface/voxel: the field has spanned the periodic box along %s, "
				       "whose length has changed from %g to %g",
				       ts_axis_names[f->axis[d]], (double)f->n[d] * f->width[d], length);
	}
	return check_height(self, sim);
}

/* ---- motion */

static const struct ts_arg linear_rows[] = {
	TS_VEC3("velocity", struct motion, velocity, .flags = TS_POSITIONAL),
	TS_ARGS_END,
};
static const struct ts_arg wiggle_rows[] = {
	TS_VEC3("amplitude", struct motion, amplitude, .flags = TS_POSITIONAL),
	TS_REAL("period", struct motion, period, .flags = TS_POSITIONAL, .range = TS_POSITIVE),
	TS_ARGS_END,
};
static const struct ts_mode modes[] = {
	[LINEAR] = { "linear", "at constant velocity", linear_rows },
	[WIGGLE] = { "wiggle", "oscillation", wiggle_rows },
	{ .name = NULL },
};
static const struct ts_arg motion_rows[] = {
	TS_MODE("motion", struct motion, mode, modes, .help = "kind of motion"),
	TS_ARGS_END,
};

static double elapsed_time(const struct state *s)
{
	return s->began + (double)s->steps * s->dt;
}

/* Counts steps rather than summing dt, so that a constant time step accumulates no rounding errors. */
static void advance_time(struct state *s, double dt)
{
	if (s->dt < dt || s->dt > dt) {
		s->began = elapsed_time(s);
		s->steps = 0;
		s->dt = dt;
	}
	s->steps++;
}

/* Displacement and velocity at the present time. */
static void place(struct state *s)
{
	struct ts_voxel_surface *surface = &s->surface;
	double t = elapsed_time(s), omega = 2 * TS_PI / s->motion.period;

	for (int d = 0; d < 3 && s->motion.mode == LINEAR; d++) {
		surface->velocity[d] = s->motion.velocity[d];
		surface->shift[d] = s->motion.velocity[d] * t;
	}
	for (int d = 0; d < 3 && s->motion.mode == WIGGLE; d++) {
		surface->velocity[d] = s->motion.amplitude[d] * omega * cos(omega * t);
		surface->shift[d] = s->motion.amplitude[d] * sin(omega * t);
	}
}

static enum ts_status initial_integrate(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	struct ts_voxel_surface *surface = &s->surface;
	double before[3];

	if (s->motion.mode == STAYS)
		return TS_OK;
	ts_scale(1, surface->shift, before);
	advance_time(s, sim->clock.dt);
	place(s);
	ts_sub(surface->shift, before, surface->moved);
	surface->step = ts_norm(surface->moved);
	surface->travelled += surface->step;
	return TS_OK;
}

/* ---- stages */

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	s->motion = (struct motion){ .mode = STAYS, .period = 1 };
	if (s->move_words.n)
		TS_TRY(ts_args_parse(sim, "fix surface/voxel: move", motion_rows, s->move_words,
				     ts_instance_word(self, "move"), &self->arena, &s->motion));
	if (!s->surface.field.nlevels)
		TS_TRY(load_field(self, sim));
	place(s);
	return check_period(self, sim);
}

static enum ts_status post_build(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	TS_TRY(check_period(self, sim));
	if (!sim->run.resuming)
		s->surface.travelled = 0;
	return TS_OK;
}

static enum ts_status plan(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report)
{
	const struct ts_voxel_field *f = &((const struct state *)self->state)->surface.field;
	double least, most;
	char name[48];

	(void)sim;
	ts_voxel_field_bounds(f, &least, &most);
	snprintf(name, sizeof name, "surface %s", self->id);
	ts_report_line(report, name,
		       "%" PRId64 " x %" PRId64 " columns of %.6g x %.6g, heights %.6g to %.6g%s%s", f->n[0],
		       f->n[1], f->width[0], f->width[1], least, most,
		       f->periodic[0] ? ", periodic along the first" : "",
		       f->periodic[1] ? ", periodic along the second" : "");
	return TS_OK;
}

static void fingerprint(const struct ts_instance *self, const struct tsim *sim, struct ts_hash *hash)
{
	const struct ts_voxel_surface *s = self->state;

	(void)sim;
	ts_hash_add(hash, ts_voxel_heights(&s->field),
		    (size_t)s->field.n[0] * (size_t)s->field.n[1] * sizeof(double));
	ts_hash_add(hash, s->shift, sizeof s->shift);
}

static void extent(const struct ts_instance *self, int dim, double *lo, double *hi)
{
	const struct ts_voxel_surface *s = self->state;
	const struct ts_voxel_field *f = &s->field;
	double least, most;

	ts_voxel_field_bounds(f, &least, &most);
	if (isfinite(f->base))
		least = f->base;
	for (int d = 0; d < 2; d++) {
		if (f->axis[d] != dim)
			continue;
		least = f->origin[d];
		most = ts_voxel_border(f, d, f->n[d]);
	}
	*lo = fmin(*lo, least + s->shift[dim]);
	*hi = fmax(*hi, most + s->shift[dim]);
}

/* The heights before recession, of a field that takes part in it; a file without them has the original heights. */
static enum ts_status archive_original(struct tsim *sim, struct ts_archive *a, struct ts_voxel_surface *s)
{
	static const char name[] = "original";
	size_t n = (size_t)s->field.n[0] * (size_t)s->field.n[1];
	bool writing = ts_archive_writing(a), saved = writing ? s->original != NULL : ts_archive_has(a, name);

	if (saved && !s->original)
		s->original = ts_alloc(n, sizeof *s->original);
	if (saved && !s->original)
		return ts_nomem(&sim->error);
	if (saved)
		return ts_archive_fixed(a, name, TS_SAVED_F64, s->original, n);
	for (size_t k = 0; s->original && k < n; k++)
		s->original[k] = ts_voxel_heights(&s->field)[k];
	return TS_OK;
}

static enum ts_status archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a)
{
	struct state *s = self->state;
	struct ts_voxel_field *f = &s->surface.field;

	TS_TRY(ts_archive_fixed(a, "heights", TS_SAVED_F64, ts_voxel_heights(f),
				(size_t)f->n[0] * (size_t)f->n[1]));
	ts_voxel_field_update(f);
	place(s);
	return archive_original(sim, a, &s->surface);
}

static void fini(struct ts_instance *self)
{
	struct ts_voxel_surface *surface = &((struct state *)self->state)->surface;

	ts_voxel_field_release(&surface->field);
	ts_free(surface->original);
}

/* ---- arguments */

static const struct ts_arg constant_rows[] = {
	TS_REAL("height", struct state, source.height, .flags = TS_POSITIONAL | TS_STATEFUL, .unit = "length",
		.help = "of all columns"),
	TS_ARGS_END,
};
static const struct ts_arg file_rows[] = {
	TS_WORD("name", struct state, source.file, .flags = TS_POSITIONAL | TS_STATEFUL,
		.help = "text file, a line of numbers for each row"),
	TS_REAL("scale", struct state, source.scale, .flags = TS_STATEFUL, .fallback = "1", .unit = "length",
		.help = "factor of the numbers"),
	TS_ARGS_END,
};
static const struct ts_arg image_rows[] = {
	TS_WORD("name", struct state, source.file, .flags = TS_POSITIONAL | TS_STATEFUL,
		.help = "PGM or PNG file"),
	TS_REAL("black", struct state, source.black, .flags = TS_STATEFUL, .unit = "length",
		.help = "height of black"),
	TS_REAL("white", struct state, source.white, .flags = TS_STATEFUL, .unit = "length",
		.help = "height of white"),
	TS_ARGS_END,
};
static const struct ts_arg formula_rows[] = {
	TS_NUMBER("height", struct state, source.formula, .flags = TS_POSITIONAL | TS_STATEFUL,
		  .unit = "length", .help = "v_NAME, a function of the coordinates"),
	TS_WORD("x", struct state, source.set[0], .flags = TS_OPTIONAL | TS_STATEFUL,
		.help = "internal-style variable that gets the x coordinate of the centre of the column"),
	TS_WORD("y", struct state, source.set[1], .flags = TS_OPTIONAL | TS_STATEFUL,
		.help = "the same for y"),
	TS_WORD("z", struct state, source.set[2], .flags = TS_OPTIONAL | TS_STATEFUL,
		.help = "the same for z"),
	TS_ARGS_END,
};
static const struct ts_arg gaussian_rows[] = {
	TS_REAL("mean", struct state, source.mean, .flags = TS_STATEFUL, .fallback = "0", .unit = "length",
		.help = "mean height"),
	TS_REAL("deviation", struct state, source.deviation, .flags = TS_STATEFUL, .range = TS_NOT_NEGATIVE,
		.unit = "length", .help = "standard deviation of the heights"),
	TS_LIST_KEYWORD("correlation", struct state, source.correlation, .flags = TS_TO_KEYWORD | TS_STATEFUL,
			.unit = "length",
			.help = "correlation length, or two along the first and second axis"),
	TS_INT("seed", struct state, source.seed, .flags = TS_STATEFUL, .range = TS_POSITIVE,
	       .help = "of the random numbers"),
	TS_ENUM("noise", struct state, source.noise, noises, .flags = TS_STATEFUL, .fallback = "columns",
		.help = "what the random numbers belong to: columns, or waves"),
	TS_BOOL("exact", struct state, source.exact, .flags = TS_STATEFUL, .fallback = "yes",
		.help = "whether the heights have the mean and deviation exactly, or only on average over "
			"seeds"),
	TS_ARGS_END,
};
static const struct ts_arg self_affine_rows[] = {
	TS_REAL("mean", struct state, source.mean, .flags = TS_STATEFUL, .fallback = "0", .unit = "length",
		.help = "mean height"),
	TS_REAL("deviation", struct state, source.deviation, .flags = TS_STATEFUL, .range = TS_NOT_NEGATIVE,
		.unit = "length", .help = "standard deviation of the heights"),
	TS_REAL("hurst", struct state, source.hurst, .flags = TS_STATEFUL, .range = TS_POSITIVE,
		.help = "Hurst exponent, at most 1"),
	TS_REAL("shortest", struct state, source.shortest, .flags = TS_OPTIONAL | TS_STATEFUL,
		.range = TS_POSITIVE, .unit = "length",
		.help = "shortest wavelength; default: twice the width of the columns"),
	TS_REAL("roll", struct state, source.roll, .flags = TS_OPTIONAL | TS_STATEFUL, .range = TS_POSITIVE,
		.unit = "length", .help = "longer waves have a constant spectrum; default: `longest`"),
	TS_REAL("longest", struct state, source.longest, .flags = TS_OPTIONAL | TS_STATEFUL,
		.range = TS_POSITIVE, .unit = "length",
		.help = "longest wavelength; default: the larger size of the field"),
	TS_INT("seed", struct state, source.seed, .flags = TS_STATEFUL, .range = TS_POSITIVE,
	       .help = "of the random numbers"),
	TS_ENUM("noise", struct state, source.noise, noises, .flags = TS_STATEFUL, .fallback = "columns",
		.help = "what the random numbers belong to: columns, or waves"),
	TS_BOOL("exact", struct state, source.exact, .flags = TS_STATEFUL, .fallback = "yes",
		.help = "as for gaussian"),
	TS_ARGS_END,
};
static const struct ts_mode sources[] = {
	[TS_VOXEL_CONSTANT] = { "constant", "one height", constant_rows },
	[TS_VOXEL_FILE] = { "file", "a matrix of numbers", file_rows },
	[TS_VOXEL_IMAGE] = { "image", "a grey image", image_rows },
	[TS_VOXEL_FORMULA] = { "formula", "a function of the coordinates", formula_rows },
	[TS_VOXEL_GAUSSIAN] = { "gaussian", "a Gaussian random surface", gaussian_rows },
	[TS_VOXEL_SELF_AFFINE] = { "selfaffine", "a self-affine random surface", self_affine_rows },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_MODE("heights", struct state, source.kind, sources, .help = "where the heights come from"),
	TS_INT("type", struct state, surface.type, .range = TS_POSITIVE,
	       .help = "particle type whose material the surface has"),
	TS_SOME_KEYWORD("cells", struct state, cells, TS_STATEFUL,
			.help = "number of columns along the first and second axis; file and image: that of "
				"the file"),
	TS_ENUM("normal", struct state, normal, ts_axis_names, .flags = TS_STATEFUL, .fallback = "z",
		.help = "axis of the heights; the first and second axis are the next ones in cyclic order"),
	TS_SOME_KEYWORD("origin", struct state, origin, TS_STATEFUL, .unit = "length",
			.help = "lower corner of the field along the first and second axis; default: of the "
				"box"),
	TS_SOME_KEYWORD("size", struct state, size, TS_STATEFUL, .unit = "length",
			.help = "lengths of the field along the first and second axis; default: of the box"),
	TS_REAL("datum", struct state, datum, .flags = TS_OPTIONAL | TS_STATEFUL, .unit = "length",
		.help = "lower heights are raised to this one"),
	TS_REAL("base", struct state, base, .flags = TS_OPTIONAL | TS_STATEFUL, .unit = "length",
		.help = "bottom of all columns; default: they have none"),
	TS_BOOL("merge", struct state, surface.merges, .flags = TS_STATEFUL, .fallback = "yes",
		.help = "whether contact points within the contact area of a deeper one belong to it"),
	TS_REAL("temperature", struct state, surface.temperature, .flags = TS_OPTIONAL, .unit = "temperature",
		.help = "for fix heat/gran"),
	TS_REAL("winkler", struct state, surface.winkler, .flags = TS_OPTIONAL, .range = TS_POSITIVE,
		.unit = "pressure/length",
		.help = "stiffness of the columns per area: each is a spring under a particle; default: they "
			"are rigid"),
	TS_SOME_KEYWORD("move", struct state, move_words, TS_STATEFUL,
			.help = "`linear Vx Vy Vz`: velocity; `wiggle Ax Ay Az T`: displacement A sin(2 pi "
				"t/T)"),
	TS_ARGS_END,
};

static const struct ts_saved saved[] = {
	TS_SAVE_F64(struct state, surface.travelled),
	TS_SAVE_F64(struct state, surface.step),
	TS_SAVE_F64(struct state, began),
	TS_SAVE_F64(struct state, dt),
	TS_SAVE_I64(struct state, steps),
	TS_SAVED_ROWS_END,
};

static const char doc[] =
	"A solid made of columns, for walls with rough or worn surfaces. The first and second axis are "
	"divided into cells of equal size; the column on each cell reaches from its height down to `base`, "
	"or without end. The field covers the box, or the rectangle from `origin` of the lengths `size`. A "
	"field alone has no effect on particles: `fix wall/gran voxels ID` makes a wall of it.\n\n"
	"Heights:\n\n"
	"  constant H          one height\n"
	"  file NAME           numbers, times `scale`; each line is a row\n"
	"  image NAME          grey values: `black` and `white` are the heights of black and white\n"
	"  formula v_NAME      an equal-style variable, evaluated at the centre of each column; the "
	"coordinates are set in the internal-style variables named by `x`, `y`, `z`\n"
	"  gaussian            a Gaussian random surface\n"
	"  selfaffine          a self-affine random surface\n\n"
	"Files and images are seen from above, with the first axis to the right: their first row is the one "
	"of the largest second coordinate. Images are PGM (P2, P5) or, if tsim was built with libpng, PNG; "
	"grey, of up to 16 bits. Heights below `datum` are raised to it; columns whose height is not above "
	"`base` are empty.\n\n"
	"The heights of a Gaussian surface have a normal distribution with the covariance\n\n"
	"  <(h(x) - mean)(h(x + r) - mean)> = deviation^2 exp(-(r_1/l_1)^2 - (r_2/l_2)^2),\n\n"
	"l being the correlation lengths. It is periodic along both axes: the covariance is the sum over the "
	"periodic images. Correlation lengths may be at most half of the size. The random number of a column "
	"or wave depends on the seed and its index alone. With `exact yes` the heights are shifted and "
	"scaled to have the mean and standard deviation given, before the datum is applied; with `exact no` "
	"they have them on average over seeds.\n\n"
	"The heights of a self-affine surface have a normal distribution with the isotropic power "
	"spectrum\n\n"
	"  C(q) = constant for longest >= 2 pi/q > roll\n"
	"  C(q) ~ q^(-2 - 2 hurst) for roll >= 2 pi/q >= shortest\n"
	"  C(q) = 0 for other wave numbers q.\n\n"
	"It is periodic along both axes; seed, `noise` and `exact` are those of a Gaussian surface.\n\n"
	"With `noise columns` each column has its random number, so that fields of other `cells` are other "
	"surfaces. With `noise waves` each wave that is periodic in the field has its random amplitude and "
	"phase: the surface is the same for any number of columns that resolve its spectrum, sampled at "
	"their centres. Use it to see how results depend on the width of columns.\n\n"
	"A particle touches the tops, sides, edges and corners of the columns: each point of the solid that "
	"is nearer to the centre than all other points around it is one contact. There are no seams: a "
	"particle on columns of equal height has one contact, as on a plane, with the same force bit for "
	"bit; columns whose heights differ by less than 1e-9 of their width, or by rounding, count as equal. "
	"The history of a contact that slides from column to column is kept, see fix wall/gran. If the "
	"centre of a particle gets into the solid the run stops.";

static const char *const doc_more[] = {
	"Where columns are narrower than the contact area, as on a ramp of narrow columns, and beside steps "
	"lower than the overlap, as wear makes them, several of these points lie in one contact area. They "
	"are one contact: with `merge yes`, the default, a contact point p belongs to a deeper one p_1 "
	"if\n\n"
	"  |p - p_1|^2 < 2 (R^2 - d_1^2),\n\n"
	"d_1 being the distance of p_1 from the centre: sqrt(R^2 - d_1^2) is the radius of the circle in "
	"which the sphere cuts the tangent plane. Only the deepest contact of an area acts, so that the "
	"force converges to that of the smooth surface as the columns become narrower, with an error of "
	"first order in their width, and does not jump at low steps. Contacts with sides and in corners "
	"stay apart as long as overlaps are small: at right angles below 0.29 R.",
	"With `merge no` each edge is a contact of its own: beside a step of any height the force doubles, "
	"and the narrower the columns are the stiffer is the wall. Edges that share the force give the "
	"direction of elastic rebounds from a ramp more exactly, with an error of higher order in the width.",
	"The field is periodic along an axis along which it spans a periodic box. Elsewhere it ends with "
	"side faces. In a box that is periodic along the heights a `base` is needed, and no column may be "
	"longer than the box.",
	"The time t of `move` counts from the definition of the fix. Fixes wear/... with `evolve yes` lower "
	"the columns. Restart files contain the heights.",
	"With `winkler K` each column is a spring under a particle, K times its cross-section stiff: the "
	"Winkler foundation of compute surface/contact. Contact law and spring are in series, and the top is "
	"in balance at any time: the point of contact goes back by u along the axis of the heights, where\n\n"
	"  K A u = F_n(delta) n_a,\n\n"
	"delta being the overlap with the deflected point and n_a the component of the normal. Without "
	"damping no energy is lost; damping acts on the rate of delta. At sides, n_a = 0, columns are rigid. "
	"Springs do not know of each other: each contact has that of a whole column, and other columns are "
	"where they are without load; so is the surface for all other styles. The contact is softer than "
	"without `winkler`, so the same time step is stable. It needs a law of type hooke or hertz; `impact "
	"exact` and fix energy/ledger are refused.",
	"Related: fix wall/gran, fix mesh/surface, dump voxel/vtk, compute surface/contact.",
	NULL
};

TS_STYLE(fix, ts_style, ts_fix_surface_voxel)
const struct ts_style ts_fix_surface_voxel = {
	.name = "surface/voxel",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_OWN | TS_RANKS_OUTPUTS,
	.summary = "A height field of columns: from a formula, a file, an image, or random",
	.doc = doc,
	.doc_more = doc_more,
	.example = "fix flat all surface/voxel constant 0.0 type 1 cells 100 100\n"
		   "variable cx internal 0\nvariable cy internal 0\nvariable height equal "
		   "0.2*v_cx+0.1*sin(v_cy)\n"
		   "fix ramp all surface/voxel formula v_height x cx y cy type 1 cells 200 1\n"
		   "fix plate all surface/voxel image plate.pgm black 0.0 white 1e-05 type 2 datum 2e-06\n"
		   "fix rough all surface/voxel gaussian mean 0.0 deviation 1e-06 correlation 5e-06 8e-06 "
		   "seed 17 type 1 cells 256 256 move linear 0.1 0.0 0.0",
	.args = args,
	.family = TS_FAMILY_VOXEL,
	.state_size = sizeof(struct state),
	.saved = saved,
	.archive = archive,
	.fingerprint = fingerprint,
	.extent = extent,
	.init = init,
	.hook = { [TS_STAGE_INITIAL_INTEGRATE] = initial_integrate, [TS_STAGE_POST_BUILD] = post_build },
	.plan = plan,
	.fini = fini,
};
