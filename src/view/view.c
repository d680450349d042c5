#include "view/view.h"

#include <math.h>
#include <string.h>

#include "io/png.h"
#include "io/replace.h"
#include "plot/plot_raster.h"
#include "plot/plot_svg.h"
#include "view/view_data.h"
#include "view/view_overview.h"

#include "base/banned.h"

enum { HISTOGRAM = 4 /* columns of fix ave/histo */, LEAST_SIZE = 160, MOST_SIZE = 4000 };
static const double PIXELS = 3; /* to a unit of a plot */

/* What is drawn: plots side by side. */
struct picture {
	struct ts_view_data *data;
	struct ts_plot *plot; /* [plots] */
	size_t plots;
	struct ts_plot_axis x, y, right; /* settings for all */
	int width, height;
	struct ts_plot_mark *mark; /* [marks] */
	size_t marks;
};

/* ---- words */

/* "LO:HI" */
static enum ts_status parse_range(struct ts_error *err, const char *option, const char *text,
				  struct ts_plot_axis *axis)
{
	const char *colon = text ? strchr(text, ':') : NULL;
	struct ts_str low = { 0 };
	bool good;

	if (!text)
		return TS_OK;
	axis->lo = axis->hi = NAN;
	if (colon)
		ts_str_add_n(&low, text, (size_t)(colon - text));
	good = colon && (!low.length || ts_parse_real(ts_str_text(&low), &axis->lo)) &&
	       (!colon[1] || ts_parse_real(colon + 1, &axis->hi)) && !(axis->lo >= axis->hi);
	ts_str_release(&low);
	return good ? TS_OK
		    : ts_fail(err, TS_SYNTAX, NULL,
			      "%s is '%s', expected LO:HI with LO below HI, such as 0:2.5 or 0:", option,
			      text);
}

static enum ts_status parse_style(struct ts_error *err, const char *text, enum ts_plot_style *style)
{
	static const char *const names[] = { [TS_PLOT_LINES] = "lines",
					     [TS_PLOT_POINTS] = "points",
					     [TS_PLOT_BOTH] = "both",
					     [TS_PLOT_STEPS] = "steps" };
	struct ts_suggest suggest = ts_suggest_start(text ? text : "");

	for (int k = TS_PLOT_LINES; text && k <= TS_PLOT_STEPS; k++) {
		ts_suggest_try(&suggest, names[k]);
		if (ts_streq(names[k], text)) {
			*style = (enum ts_plot_style)k;
			return TS_OK;
		}
	}
	return text ? ts_fail(err, TS_SYNTAX, NULL, "-style is '%s', expected lines, points, both or steps%s",
			      text, suggest.best ? ts_suggest_text(&suggest) : "")
		    : TS_OK;
}

/* WIDTHxHEIGHT */
static enum ts_status parse_size(struct picture *p, const char *text)
{
	const char *x = text ? strchr(text, 'x') : NULL;
	struct ts_str width = { 0 };
	int64_t w = 0, h = 0;
	bool good;

	if (!text)
		return TS_OK;
	if (x)
		ts_str_add_n(&width, text, (size_t)(x - text));
	good = x && ts_parse_int(ts_str_text(&width), &w) && ts_parse_int(x + 1, &h) && w >= LEAST_SIZE &&
	       h >= LEAST_SIZE && w <= MOST_SIZE && h <= MOST_SIZE;
	ts_str_release(&width);
	p->width = (int)w;
	p->height = (int)h;
	return good ? TS_OK
		    : ts_fail(&p->data->sim->error, TS_SYNTAX, NULL,
			      "-size is '%s', expected WIDTHxHEIGHT from %d to %d, such as 480x320", text,
			      LEAST_SIZE, MOST_SIZE);
}

/* x=VALUE[:NAME] or y=VALUE[:NAME] */
static enum ts_status parse_mark(struct picture *p, const char *text, struct ts_plot_mark *mark)
{
	const char *colon = strchr(text, ':');
	struct ts_str value = { 0 };
	bool good = (text[0] == 'x' || text[0] == 'y') && text[1] == '=';

	*mark = (struct ts_plot_mark){ .name = colon ? colon + 1 : NULL, .vertical = text[0] == 'x' };
	if (good)
		ts_str_add_n(&value, text + 2, colon ? (size_t)(colon - text) - 2 : strlen(text + 2));
	good = good && ts_parse_real(ts_str_text(&value), &mark->at);
	ts_str_release(&value);
	return good ? TS_OK
		    : ts_fail(&p->data->sim->error, TS_SYNTAX, NULL,
			      "-mark is '%s', expected x=VALUE or y=VALUE, with :NAME or without", text);
}

static enum ts_status parse_marks(struct picture *p)
{
	const struct ts_words *words = &p->data->in->marks;

	p->mark = ts_arena_alloc(&p->data->arena, words->n, sizeof *p->mark);
	if (!p->mark)
		return ts_nomem(&p->data->sim->error);
	for (size_t k = 0; k < words->n; k++)
		TS_TRY(parse_mark(p, words->word[k].text, &p->mark[p->marks++]));
	return TS_OK;
}

/* The axis on the right needs curves, and the one on the left as well. */
static enum ts_status check_right(const struct picture *p)
{
	const struct ts_view_input *in = p->data->in;
	size_t left = 0, right = 0;

	for (size_t k = 0; k < in->n; k++) {
		left += in->source[k].columns.n;
		right += in->source[k].right.n;
	}
	if (!right && (p->right.log || in->right_range || in->right_label))
		return ts_fail(&p->data->sim->error, TS_SYNTAX, NULL,
			       "-log r, -rightrange and -rightlabel belong to -right, which is not given");
	if (right && !left)
		return ts_fail(&p->data->sim->error, TS_SYNTAX, NULL,
			       "all columns are on the right axis: name one for the left after -plot FILE");
	if (right && in->panels)
		return ts_fail(&p->data->sim->error, TS_SYNTAX, NULL,
			       "-panels and -right cannot be given together: panels have one column each");
	return TS_OK;
}

static enum ts_status parse_words(struct picture *p)
{
	const struct ts_view_input *in = p->data->in;
	struct ts_error *err = &p->data->sim->error;
	const char *log = in->log ? in->log : "";

	p->x.log = strchr(log, 'x') != NULL;
	p->y.log = strchr(log, 'y') != NULL;
	p->right.log = strchr(log, 'r') != NULL;
	if (in->log && (!*log || strlen(log) != (size_t)(p->x.log + p->y.log + p->right.log)))
		return ts_fail(err, TS_SYNTAX, NULL,
			       "-log is '%s', expected x, y or xy with -plot, with r for the axis of -right",
			       log);
	if (in->out && !ts_ends_with(in->out, ".svg") && !ts_ends_with(in->out, ".png"))
		return ts_fail(err, TS_SYNTAX, NULL, "-o is '%s', expected a name that ends in .svg or .png",
			       in->out);
	TS_TRY(parse_size(p, in->size));
	TS_TRY(parse_range(err, "-xrange", in->xrange, &p->x));
	TS_TRY(parse_range(err, "-yrange", in->yrange, &p->y));
	TS_TRY(parse_range(err, "-rightrange", in->right_range, &p->right));
	TS_TRY(check_right(p));
	return parse_marks(p);
}

/* Styles of the files; histograms have steps. */
static enum ts_status set_styles(struct picture *p)
{
	struct ts_view_data *v = p->data;

	for (size_t k = 0; k < v->in->n; k++) {
		struct ts_view_file *f = &v->file[k];
		const struct ts_sheet *t = f->part[0];

		if (t->columns == HISTOGRAM && ts_streq(t->column[0].name, "Bin") &&
		    ts_streq(t->column[1].name, "Coord"))
			f->style = TS_PLOT_STEPS;
		TS_TRY(parse_style(&v->sim->error, f->source->style, &f->style));
	}
	return TS_OK;
}

/* ---- plots */

/* "speed (m/s)" has a unit. */
static enum ts_status set_label(struct picture *p, struct ts_plot_axis *axis, const char *name)
{
	char *copy = ts_arena_strdup(&p->data->arena, name), *unit = copy ? strstr(copy, " (") : NULL;

	if (!copy)
		return ts_nomem(&p->data->sim->error);
	axis->label = copy;
	if (unit && ts_ends_with(unit, ")")) {
		*unit = '\0';
		unit += 2;
		unit[strlen(unit) - 1] = '\0';
		axis->unit = unit;
	}
	return TS_OK;
}

/* Name in the legend: the column where the plot has several, and what else tells the curve from others. */
static enum ts_status name_series(struct picture *p, struct ts_view_curve *c, bool many)
{
	struct ts_str text = { 0 };

	ts_str_addf(&text, "%s%s%s", many ? c->column : "", many && *c->name ? ", " : "", c->name);
	if (c->series.right)
		ts_str_add(&text, text.length ? " (right)" : "right");
	c->series.name = text.failed ? NULL : ts_arena_strdup(&p->data->arena, ts_str_text(&text));
	ts_str_release(&text);
	return c->series.name ? TS_OK : ts_nomem(&p->data->sim->error);
}

/* The first curve from index `from` on by the left or the right axis; NULL: none. */
static const struct ts_view_curve *first_of(const struct ts_view_data *v, size_t from, bool right)
{
	for (size_t k = from; k < v->curves; k++)
		if (v->curve[k].series.right == right)
			return &v->curve[k];
	return NULL;
}

/* Fills a plot with the curves from index `from` on. */
static enum ts_status fill_plot(struct picture *p, struct ts_plot *plot, size_t from, bool title)
{
	struct ts_view_data *v = p->data;
	const struct ts_view_file *f = &v->file[0];
	const size_t n = v->curves - from;
	struct ts_plot_series *series = ts_arena_alloc(&v->arena, n, sizeof *series);
	const struct ts_view_curve *left = first_of(v, from, false), *right = first_of(v, from, true);
	bool many = false, many_left = false, many_right = false;

	if (!series)
		return ts_nomem(&v->sim->error);
	for (size_t k = from; k < v->curves; k++) {
		const struct ts_view_curve *c = &v->curve[k];

		many |= !ts_streq(c->column, v->curve[from].column);
		many_left |= !c->series.right && !ts_streq(c->column, left->column);
		many_right |= c->series.right && !ts_streq(c->column, right->column);
	}
	for (size_t k = 0; k < n; k++) {
		TS_TRY(name_series(p, &v->curve[from + k], many));
		series[k] = v->curve[from + k].series;
	}
	*plot = (struct ts_plot){ .x = p->x,
				  .y = p->y,
				  .right = p->right,
				  .series = series,
				  .n = n,
				  .mark = p->mark,
				  .marks = p->marks,
				  .width = p->width,
				  .height = p->height };
	if (title && v->in->title)
		plot->title = v->in->title;
	else if (title && v->in->n == 1)
		plot->title = f->source->path;
	if (v->in->xlabel || f->x != SIZE_MAX)
		TS_TRY(set_label(p, &plot->x, v->in->xlabel ? v->in->xlabel : f->part[0]->column[f->x].name));
	if (v->in->ylabel || (left && !many_left))
		TS_TRY(set_label(p, &plot->y, v->in->ylabel ? v->in->ylabel : left->column));
	if (v->in->right_label || (right && !many_right))
		TS_TRY(set_label(p, &plot->right, v->in->right_label ? v->in->right_label : right->column));
	return TS_OK;
}

/* Columns that are named share a plot, unless panels are wanted; without names each has its own. */
static enum ts_status make_plots(struct picture *p)
{
	struct ts_view_data *v = p->data;
	const bool together =
		(v->in->source[0].columns.n > 0 || v->in->source[0].right.n > 0) && !v->in->panels;
	const size_t panels = together ? 1 : v->file[0].ny;

	p->plot = ts_arena_alloc(&v->arena, panels, sizeof *p->plot);
	if (!p->plot)
		return ts_nomem(&v->sim->error);
	for (size_t panel = 0; panel < panels; panel++) {
		const size_t from = v->curves;

		for (size_t k = 0; k < v->in->n; k++)
			for (size_t c = together ? 0 : panel; c < (together ? v->file[k].ny : panel + 1); c++)
				if (c < v->file[k].ny)
					TS_TRY(ts_view_data_curves(v, &v->file[k], &v->file[k].y[c]));
		TS_TRY(fill_plot(p, &p->plot[p->plots++], from, panel == 0));
	}
	return TS_OK;
}

/* ---- files */

static enum ts_status write_svg(struct picture *p, const char *path, size_t columns)
{
	struct tsim *sim = p->data->sim;
	struct ts_replace file = { 0 };
	struct ts_str text = { 0 };
	enum ts_status status = ts_plot_svg_panels(p->plot, p->plots, columns, &text);

	status = status != TS_OK ? ts_nomem(&sim->error)
				 : ts_replace_begin(&file, sim, &(struct ts_place){ 0 }, path);
	if (status == TS_OK)
		status = ts_replace_write(&file, text.text, text.length);
	if (status == TS_OK)
		status = ts_replace_commit(&file, false);
	ts_replace_abandon(&file);
	ts_str_release(&text);
	return status;
}

static enum ts_status write_png(struct picture *p, const char *path, size_t columns)
{
	struct tsim *sim = p->data->sim;
	struct ts_picture pixels = { 0 };
	enum ts_status status = TS_RANGE;

	for (double scale = PIXELS; status == TS_RANGE && scale >= 1; scale--)
		status = ts_plot_raster_panels(p->plot, p->plots, columns, scale, &pixels);
	if (status == TS_OK)
		status = ts_png_write(sim, path, &(struct ts_place){ 0 }, pixels.width, pixels.height,
				      pixels.rgb);
	else if (status == TS_RANGE)
		ts_fail(&sim->error, status, NULL, "%zu plots do not fit in a picture: name some columns",
			p->plots);
	else
		status = ts_nomem(&sim->error);
	ts_picture_release(&pixels);
	return status;
}

static enum ts_status show(struct picture *p, struct ts_str *text)
{
	const struct ts_view_input *in = p->data->in;
	const size_t columns = p->plots > 3 ? 2 : 1;

	if (in->out)
		return (ts_ends_with(in->out, ".svg") ? write_svg : write_png)(p, in->out, columns);
	for (size_t k = 0; k < p->plots; k++)
		if (ts_plot_terminal(&p->plot[k], &in->terminal, text) != TS_OK)
			return ts_nomem(&p->data->sim->error);
	return TS_OK;
}

enum ts_status ts_view(struct tsim *sim, const struct ts_view_input *in, struct ts_str *text)
{
	struct ts_view_data data = { .sim = sim, .in = in };
	struct picture p = { .data = &data };
	enum ts_status status = parse_words(&p);

	if (status == TS_OK)
		status = ts_view_data_read(&data);
	if (status == TS_OK)
		status = set_styles(&p);
	if (status == TS_OK && !in->out && !in->source[0].columns.n && !in->source[0].right.n) {
		for (size_t k = 0; k < in->n && status == TS_OK; k++)
			status = ts_view_overview(&data, &data.file[k], text);
	} else if (status == TS_OK) {
		status = make_plots(&p);
		if (status == TS_OK)
			status = show(&p, text);
	}
	ts_view_data_release(&data);
	return status;
}

void ts_view_help(struct ts_str *out)
{
	ts_str_add(out,
		   "  tsim -plot FILE                                list of all columns, with their course\n"
		   "  tsim -plot FILE COLUMN ... [-x COLUMN[+-ERROR]] on the terminal\n"
		   "  tsim -plot FILE [COLUMN ...] -o FILE.svg       picture, .svg or .png\n"
		   "  tsim -plot FILE COLUMN -plot FILE2 [COLUMN]    curves of several files\n"
		   "  COLUMN is NAME[+-ERROR][=LABEL]; names may be numbers from 1 on, or formulas: "
		   "'100*ke/$3=share'\n"
		   "  -right COLUMN ...  of the file before, by a second axis on the right;  -rightlabel "
		   "TEXT  "
		   "-rightrange LO:HI\n"
		   "  -log x|y|xy|r  -xrange LO:HI  -yrange LO:HI  -style lines|points|both|steps\n"
		   "  -mark y=VALUE[:NAME]  -title TEXT  -xlabel TEXT  -ylabel TEXT  -size WIDTHxHEIGHT  "
		   "-panels\n"
		   "  -part N|last|all  run of a log, block of an average;  -by COLUMN,...  a curve for each "
		   "value\n"
		   "  FILE is a log of tsim, LIGGGHTS or LAMMPS, a file of fix ave/time, ave/histo, "
		   "ave/chunk,\n"
		   "  ave/correlate or print, a table of -sweep, or any table of numbers. doc/plots.md says "
		   "more.\n");
}
