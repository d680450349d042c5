/* Command flow_grid: non-uniform cell widths along an axis. */
#include "base/axes.h"
#include "flow/projection.h"

#include <math.h>
#include <string.h>

#include "region/region.h"

#include "base/banned.h"

enum { UNIFORM, GEOMETRIC, TANH, AROUND, FACES };
enum { FINE_LOW, FINE_HIGH, FINE_BOTH };
static const char *const fine_names[] = { "lo", "hi", "both", NULL };

struct state {
	int axis, mode, fine;
	double ratio, strength, lo, hi;
	int64_t before, inside;
	struct ts_words faces;
};

/* Faces from 0 to 1 with widths in geometric progression; last width by first width: `ratio`. */
static void set_geometric_faces(double *face, int n, double ratio)
{
	double factor = n > 1 ? pow(ratio, 1.0 / (n - 1)) : 1, width = 1;

	face[0] = 0;
	for (int i = 0; i < n; i++, width *= factor)
		face[i + 1] = face[i] + width;
	for (int i = 0; i <= n; i++)
		face[i] /= face[n];
}

static void mirror_faces(double *face, int n)
{
	for (int i = 0; i <= n / 2; i++) {
		double low = face[i];

		face[i] = 1 - face[n - i];
		face[n - i] = 1 - low;
	}
}

static enum ts_status make_geometric(struct tsim *sim, const struct state *s, double *face, int n,
				     const struct ts_place *where)
{
	int half = n / 2;

	if (s->fine != FINE_BOTH) {
		set_geometric_faces(face, n, s->ratio);
		if (s->fine == FINE_HIGH)
			mirror_faces(face, n);
		return TS_OK;
	}
	if (n % 2)
		return ts_fail(&sim->error, TS_RANGE, where,
			       "flow_grid: fine at both ends takes an even number of cells, not %d", n);
	set_geometric_faces(face, half, s->ratio);
	for (int i = 0; i <= half; i++)
		face[i] *= 0.5;
	for (int i = 0; i < half; i++)
		face[n - i] = 1 - face[i];
	return TS_OK;
}

static void make_tanh(const struct state *s, double *face, int n)
{
	for (int i = 0; i <= n; i++)
		face[i] = 0.5 + 0.5 * tanh(s->strength * (2.0 * i / n - 1)) / tanh(s->strength);
	face[0] = 0;
	face[n] = 1;
}

/* The factor q for which h (q + q^2 + ... + q^n) = length, by bisection; NaN if there is none between 0.2
 * and 5. */
static double growth_factor(double h, int64_t n, double length)
{
	double lo = 0.2, hi = 5;

	if (n == 0)
		return fabs(length) <= 1e-9 * h ? 1 : NAN;
	for (int k = 0; k < 100; k++) {
		double q = 0.5 * (lo + hi), width = h, sum = 0;

		for (int64_t i = 0; i < n && sum <= length; i++)
			sum += width *= q;
		*(sum < length ? &lo : &hi) = q;
	}
	return lo > 0.21 && hi < 4.9 ? 0.5 * (lo + hi) : NAN;
}

/* Sets n faces beyond face[0] in the direction `sign` (1 or -1), each cell wider than the one before by q;
 * the cell before the first has width h. */
static void set_growing_faces(double *face, int64_t n, int sign, double h, double q)
{
	for (int64_t i = 1; i <= n; i++)
		face[sign * i] = face[sign * (i - 1)] + sign * (h *= q);
}

/* Uniform cells from lo to hi; on either side widths in geometric progression to the ends of the axis. */
static enum ts_status make_around(struct tsim *sim, const struct state *s, const struct ts_grid *grid,
				  double *face, const struct ts_place *where)
{
	int d = s->axis, n = grid->n[d];
	double origin = grid->face[d][0], length = grid->face[d][n] - origin;
	double lo = (s->lo - origin) / length, hi = (s->hi - origin) / length;
	double h = (hi - lo) / (double)s->inside, below, above;
	int64_t after = n - s->before - s->inside;

	if (!(lo >= 0 && hi <= 1 && hi > lo) || after < 0)
		return ts_fail(&sim->error, TS_RANGE, where,
			       "flow_grid: %g to %g with %lld cells before and %lld inside do not fit into "
			       "the %d cells from %g to %g",
			       s->lo, s->hi, (long long)s->before, (long long)s->inside, n, origin,
			       origin + length);
	below = growth_factor(h, s->before, lo);
	above = growth_factor(h, after, 1 - hi);
	if (isnan(below) || isnan(above))
		return ts_fail(&sim->error, TS_RANGE, where,
			       "flow_grid: the %lld cells %s %g cannot fill the rest of the axis",
			       (long long)(isnan(below) ? s->before : after),
			       isnan(below) ? "before" : "after", isnan(below) ? s->lo : s->hi);
	for (int64_t i = 0; i <= s->inside; i++)
		face[s->before + i] = lo + (double)i * h;
	set_growing_faces(face + s->before, s->before, -1, h, below);
	set_growing_faces(face + s->before + s->inside, after, 1, h, above);
	face[0] = 0;
	face[n] = 1;
	return TS_OK;
}

static enum ts_status read_faces(struct tsim *sim, const struct state *s, const struct ts_grid *grid,
				 double *face, const struct ts_place *where)
{
	int d = s->axis, n = grid->n[d];
	double lo = grid->face[d][0], length = grid->face[d][n] - lo;

	if (s->faces.n != (size_t)n + 1)
		return ts_fail(&sim->error, TS_RANGE, where,
			       "flow_grid: %d cells along %s have %d faces, and %zu are given", n,
			       ts_axis_names[d], n + 1, s->faces.n);
	for (int i = 0; i <= n; i++) {
		const struct ts_word *word = &s->faces.word[i];

		if (!ts_parse_real(word->text, &face[i]))
			return ts_fail(&sim->error, TS_SYNTAX, &word->place,
				       "flow_grid: expected a coordinate instead of '%s'", word->text);
		face[i] = (face[i] - lo) / length;
		if (i > 0 && !(face[i] > face[i - 1]))
			return ts_fail(&sim->error, TS_RANGE, &word->place,
				       "flow_grid: the faces must increase");
	}
	if (fabs(face[0]) > 1e-9 || fabs(face[n] - 1) > 1e-9)
		return ts_fail(&sim->error, TS_RANGE, where,
			       "flow_grid: the grid goes from %g to %g along %s: the first and the last face "
			       "must lie there",
			       lo, lo + length, ts_axis_names[d]);
	face[0] = 0;
	face[n] = 1;
	return TS_OK;
}

static enum ts_status make_faces(struct tsim *sim, const struct state *s, const struct ts_grid *grid,
				 double *face, const struct ts_place *where)
{
	int n = grid->n[s->axis];

	if (s->mode == GEOMETRIC)
		return make_geometric(sim, s, face, n, where);
	if (s->mode == AROUND)
		return make_around(sim, s, grid, face, where);
	if (s->mode == TANH)
		make_tanh(s, face, n);
	return s->mode == FACES ? read_faces(sim, s, grid, face, where) : TS_OK;
}

static enum ts_status set_grid_spacing(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct state *s = state;
	struct ts_projection *p;
	struct ts_instance *flow;
	enum ts_status status;
	double *face = NULL;

	TS_TRY(ts_projection_require(sim, "flow_grid", where, &flow, &p));
	if (s->axis >= p->fluid.grid.dimensions)
		return ts_fail(&sim->error, TS_RANGE, where, "flow_grid: there is one cell along %s",
			       ts_axis_names[s->axis]);
	if (s->mode != UNIFORM) {
		face = ts_alloc((size_t)p->fluid.grid.n[s->axis] + 1, sizeof *face);
		if (!face)
			return ts_nomem(&sim->error);
		status = make_faces(sim, s, &p->fluid.grid, face, where);
		if (status != TS_OK) {
			ts_free(face);
			return status;
		}
	}
	ts_free(p->graded[s->axis]);
	p->graded[s->axis] = face;
	return ts_projection_setup(flow, sim);
}

static const struct ts_arg geometric_args[] = {
	TS_REAL("ratio", struct state, ratio, .flags = TS_POSITIONAL, .range = TS_POSITIVE,
		.help = "ratio of the largest to the smallest cell width"),
	TS_ENUM("fine", struct state, fine, fine_names, .fallback = "lo",
		.help = "end with the smallest cells; both: at both ends"),
	TS_ARGS_END,
};

static const struct ts_arg tanh_args[] = {
	TS_REAL("strength", struct state, strength, .flags = TS_POSITIONAL, .range = TS_POSITIVE,
		.help = "b in x_i = 1/2 + tanh(b (2 i/n - 1))/(2 tanh b): small cells at both ends"),
	TS_ARGS_END,
};

static const struct ts_arg around_args[] = {
	TS_REAL("lo", struct state, lo, .flags = TS_POSITIONAL, .unit = "length",
		.help = "lower end of the uniform cells"),
	TS_REAL("hi", struct state, hi, .flags = TS_POSITIONAL, .unit = "length",
		.help = "upper end of the uniform cells"),
	TS_INT("before", struct state, before, .range = TS_NOT_NEGATIVE, .help = "number of cells before lo"),
	TS_INT("inside", struct state, inside, .range = TS_POSITIVE,
	       .help = "number of uniform cells between lo and hi; the remaining cells are above hi"),
	TS_ARGS_END,
};

static const struct ts_arg faces_args[] = {
	TS_REST("faces", struct state, faces,
		.help = "coordinates of all faces, one more than the number of cells"),
	TS_ARGS_END,
};

static const struct ts_mode modes[] = {
	[UNIFORM] = { "uniform", "uniform cell width", NULL },
	[GEOMETRIC] = { "geometric", "cell widths in geometric progression", geometric_args },
	[TANH] = { "tanh", "hyperbolic tangent: smooth, with small cells at both ends", tanh_args },
	[AROUND] = { "around",
		     "uniform between two positions, e.g. around a body; growing by a constant factor on "
		     "both sides",
		     around_args },
	[FACES] = { "faces", "explicit list of faces", faces_args },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_ENUM("axis", struct state, axis, ts_axis_names, .flags = TS_POSITIONAL, .help = "axis"),
	TS_MODE("spacing", struct state, mode, modes, .help = "distribution of cell widths"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_flow_grid)
const struct ts_command_style ts_command_flow_grid = {
	.style = { .name = "flow_grid",
		   .kind = TS_KIND_COMMAND,
		   .ranks = TS_RANKS_FORMULAS,
		   .summary = "sets the cell widths of the fluid grid along an axis",
		   .doc = "Sets the positions of the cell faces along one axis. flow_style projection, which "
			  "sets the number of cells, must come before. Default: uniform cells. Each axis is "
			  "graded independently, so the grid stays Cartesian.\n\n"
			  "The discretisation is of second order if cell widths change smoothly, by a few "
			  "per cent from cell to cell.\n\n"
			  "After a run, and in a run continued from a restart file, which needs the same "
			  "lines, the cells keep their velocities if their faces change, with a warning.",
		   .example = "flow_grid y tanh 1.7\nflow_grid x geometric 4.0 fine hi\n"
			      "flow_grid x around -1 2 before 40 inside 90\n"
			      "flow_grid z faces 0 0.1 0.25 0.5 1.0",
		   .args = args,
		   .state_size = sizeof(struct state) },
	.needs_box = true,
	.run = set_grid_spacing,
};
