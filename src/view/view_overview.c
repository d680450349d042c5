#include "view/view_overview.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

#include "plot/plot_layout.h"

#include "base/banned.h"

enum { BARS = 32, BAR_LEVELS = 8, LONGEST_NAME = 24 };

struct summary {
	double first, last, least, largest, sum;
	size_t n;
};

static struct summary summarize(const struct ts_view_curve *c)
{
	struct summary s = { .first = NAN, .last = NAN, .least = INFINITY, .largest = -INFINITY };

	for (size_t k = 0; k < c->series.n; k++) {
		const double y = c->y[k];

		if (isnan(y))
			continue;
		s.first = s.n++ ? s.first : y;
		s.last = y;
		s.least = fmin(s.least, y);
		s.largest = fmax(s.largest, y);
		s.sum += y;
	}
	return s;
}

/* Means of equal numbers of rows, as bars of eight heights. */
static void add_bars(const struct ts_view_curve *c, const struct summary *s, struct ts_str *out)
{
	const size_t n = c->series.n, bars = n < BARS ? n : BARS;

	for (size_t b = 0; b < bars; b++) {
		double sum = 0, level;
		size_t counted = 0;

		for (size_t k = b * n / bars; k < (b + 1) * n / bars; k++)
			if (!isnan(c->y[k])) {
				sum += c->y[k];
				counted++;
			}
		if (!counted) {
			ts_str_add(out, " ");
			continue;
		}
		level = s->largest > s->least ? (sum / (double)counted - s->least) / (s->largest - s->least)
					      : 0;
		/* U+2581 to U+2588 */
		ts_str_addf(out, "\xe2\x96%c", (char)(0x81 + (int)fmin(level * BAR_LEVELS, BAR_LEVELS - 1)));
	}
}

static void add_head(const struct ts_view_file *f, struct ts_str *out)
{
	static const char *const kinds[] = { [TS_SHEET_LOG] = "log",
					     [TS_SHEET_ROWS] = "table",
					     [TS_SHEET_BLOCKS] = "blocks",
					     [TS_SHEET_CSV] = "comma-separated values" };
	size_t rows = 0;

	for (size_t k = 0; k < f->parts; k++)
		rows += f->part[k]->rows;
	ts_str_addf(out, "%s: %s, ", f->source->path, kinds[f->sheets.kind]);
	if (f->sheets.kind == TS_SHEET_LOG)
		ts_str_addf(out, "%zu run%s, ", f->sheets.n, f->sheets.n == 1 ? "" : "s");
	if (f->sheets.kind == TS_SHEET_BLOCKS)
		ts_str_addf(out, "%zu blocks, of the last one (%s) ", f->sheets.n,
			    f->part[f->parts - 1]->title);
	ts_str_addf(out, "%zu rows, %zu columns\n", rows, f->part[0]->columns);
}

static int name_width(const struct ts_sheet *t)
{
	size_t width = 6;

	for (size_t k = 0; k < t->columns; k++) {
		const size_t n = ts_plot_letters(t->column[k].name, strlen(t->column[k].name));

		width = n > width && n <= LONGEST_NAME ? n : width;
	}
	return (int)width;
}

enum ts_status ts_view_overview(struct ts_view_data *v, const struct ts_view_file *f, struct ts_str *out)
{
	const struct ts_sheet *t = f->part[0];
	struct ts_view_file plain = *f; /* all rows of a column together */
	const int width = name_width(t);

	plain.nby = 0;
	plain.joined = true;
	add_head(f, out);
	ts_str_addf(out, "%-*s %12s %12s %12s %12s %12s\n", width, "column", "first", "last", "least",
		    "largest", "mean");
	for (size_t k = 0; k < t->columns; k++) {
		const char *name = t->column[k].name;
		const int blanks = width - (int)ts_plot_letters(name, strlen(name));
		const struct ts_view_curve *c;
		struct summary s;

		ts_str_addf(out, "%s%*s", name, blanks > 0 ? blanks : 0, "");
		if (t->column[k].text) {
			ts_str_addf(out, " words, such as '%.40s'\n", t->column[k].text);
			continue;
		}
		TS_TRY(ts_view_data_curves(v, &plain,
					   &(struct ts_view_column){ .column = k, .error = SIZE_MAX }));
		c = &v->curve[v->curves - 1];
		s = summarize(c);
		if (!s.n)
			ts_str_add(out, " no numbers");
		else
			ts_str_addf(out, " %12.6g %12.6g %12.6g %12.6g %12.6g", s.first, s.last, s.least,
				    s.largest, s.sum / (double)s.n);
		if (s.n && v->in->terminal.unicode) {
			ts_str_add(out, "  ");
			add_bars(c, &s, out);
		}
		ts_str_add(out, "\n");
		ts_view_data_forget(v);
	}
	ts_str_addf(out, "tsim -plot %s COLUMN ... [-x COLUMN] [-o FILE.svg] draws columns", f->source->path);
	if (f->x != SIZE_MAX)
		ts_str_addf(out, " against %s", t->column[f->x].name);
	ts_str_add(out, "\n");
	return TS_OK;
}
