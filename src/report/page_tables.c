/* Tables of the log as plots, and the time step against its limits. */
#include <inttypes.h>
#include <math.h>
#include <string.h>

#include "plot/plot_svg.h"
#include "report/page.h"

#include "base/banned.h"

/* Removes points before the first check of the limits. */
static size_t drop_unknown(double *x, double *y, size_t n)
{
	size_t kept = 0;

	for (size_t k = 0; k < n; k++) {
		if (isnan(y[k]))
			continue;
		x[kept] = x[k];
		y[kept++] = y[k];
	}
	return kept;
}

static void add_plot(struct ts_page *page, const struct ts_record_table *table, size_t column,
		     const char *label, const char *unit, const struct ts_plot_mark *mark)
{
	double x[2 * TS_ROWS_MOST], y[2 * TS_ROWS_MOST];
	const size_t all = ts_rows_curve(&table->rows, column, x, y);
	const size_t n = column == table->n ? drop_unknown(x, y, all) : all;
	const struct ts_plot_series series = {
		.x = x, .y = y, .n = n, .style = n > 40 ? TS_PLOT_LINES : TS_PLOT_AUTO
	};
	const struct ts_plot plot = { .x = { .label = "time", .unit = ts_page_time_unit(page->sim) },
				      .y = { .label = label, .unit = unit },
				      .series = &series,
				      .n = 1,
				      .mark = mark,
				      .marks = mark != NULL,
				      .width = 420,
				      .height = 270 };

	page->out.failed |= ts_plot_svg_add(&plot, &page->out) != TS_OK;
}

static bool is_plotted(const struct ts_record_table *table, size_t column)
{
	return !table->column[column].clock && !ts_rows_is_constant(&table->rows, column);
}

static bool has_plots(const struct ts_record_table *table)
{
	for (size_t k = 0; k < table->n; k++)
		if (is_plotted(table, k))
			return true;
	return false;
}

static void add_plots(struct ts_page *page, const struct ts_record_table *table)
{
	struct ts_str *out = &page->out;

	ts_str_add(out, "<div class=\"plots\">\n");
	for (size_t k = 0; k < table->n; k++) {
		const struct ts_record_column *c = &table->column[k];

		if (!is_plotted(table, k))
			continue;
		ts_str_add(out, "<div class=\"card\"><h3>");
		ts_page_text(out, c->title);
		ts_str_add(out, "</h3>");
		if (c->help) {
			ts_str_add(out, "<small>");
			ts_page_text(out, c->help);
			ts_str_add(out, "</small>");
		}
		add_plot(page, table, k, c->title, NULL, NULL);
		ts_str_add(out, "</div>\n");
	}
	ts_str_add(out, "</div>\n");
}

static void add_cell(struct ts_str *out, double value)
{
	ts_str_add(out, "<td class=\"n\">");
	ts_page_number(out, value);
	ts_str_add(out, "</td>");
}

static void add_numbers(struct ts_page *page, const struct ts_record_table *table)
{
	struct ts_str *out = &page->out;

	ts_str_add(out, "<details><summary>Columns in "
			"numbers</summary><div><table>\n<thead><tr><th>Column</th><th "
			"class=\"n\">first</th><th class=\"n\">last</th><th class=\"n\">least</th><th "
			"class=\"n\">greatest</th></tr></thead>\n<tbody>\n");
	for (size_t k = 0; k < table->n; k++) {
		const struct ts_rows_sum *s = &table->rows.sum[k];

		ts_str_add(out, "<tr><td>");
		ts_page_text(out, table->column[k].title);
		if (s->odd)
			ts_str_addf(out, " <small class=\"off\">%" PRId64 " are no numbers</small>", s->odd);
		ts_str_add(out, "</td>");
		add_cell(out, s->finite ? s->first : NAN);
		add_cell(out, s->finite ? s->last : NAN);
		add_cell(out, s->finite ? s->least : NAN);
		add_cell(out, s->finite ? s->greatest : NAN);
		ts_str_add(out, "</tr>\n");
	}
	ts_str_add(out, "</tbody>\n</table></div></details>\n");
}

static void add_table(struct ts_page *page, const struct ts_record_table *table)
{
	struct ts_str *out = &page->out;

	ts_str_addf(out, "<p class=\"soft\">Steps %" PRId64 " to %" PRId64 ", %" PRId64 " row%s",
		    table->first_step, table->last_step, table->rows.count,
		    table->rows.count == 1 ? "" : "s");
	if (table->runs > 1)
		ts_str_addf(out, ", %zu runs", table->runs);
	if (table->rows.each > 1)
		ts_str_addf(out, "; of each %" PRId64 " rows the least and the greatest value are drawn",
			    table->rows.each);
	if (table->rows.count > 1 && !has_plots(table))
		ts_str_add(out, "; no column varies");
	ts_str_add(out, "</p>\n");
	if (has_plots(table))
		add_plots(page, table);
	add_numbers(page, table);
}

void ts_page_tables(struct ts_page *page)
{
	const struct ts_record *r = page->record;

	if (!r->ntables)
		return;
	ts_page_section(&page->out, "log", "Table of the log");
	for (size_t k = 0; k < r->ntables; k++)
		add_table(page, &r->table[k]);
	if (r->tables_left)
		ts_str_addf(&page->out, "<p class=\"soft\">%" PRId64 " more tables are in the log.</p>\n",
			    r->tables_left);
	ts_page_end_section(&page->out);
}

/* ---- limits of the time step */

enum { FEW_LIMITS = 8 }; /* shown openly */

static bool same_limit(const struct ts_record_run *a, const struct ts_record_run *b)
{
	if (a->dt < b->dt || a->dt > b->dt)
		return false;
	if (!a->limit_of || !b->limit_of)
		return a->limit_of == b->limit_of;
	return ts_streq(a->limit_of, b->limit_of);
}

static void add_limit(struct ts_str *out, const struct ts_record_run *run, size_t first, size_t last)
{
	ts_str_addf(out, first == last ? "<tr><td>%zu</td>" : "<tr><td>%zu to %zu</td>", first, last);
	add_cell(out, run->dt);
	add_cell(out, run->limit_of ? run->limit : NAN);
	if (run->limit_of)
		ts_str_addf(out, "<td class=\"n\">%.3g %%</td><td>", 100 * run->dt / run->limit);
	else
		ts_str_add(out, "<td class=\"n\">-</td><td>");
	ts_page_text(out, run->limit_of ? run->limit_of : "no style has a limit");
	ts_str_add(out, "</td></tr>\n");
}

static void begin_limits(struct ts_str *out)
{
	ts_str_add(out, "<table>\n<thead><tr><th>Run</th><th class=\"n\">time step</th><th "
			"class=\"n\">limit</th><th class=\"n\">share</th><th>set by, at the start of the "
			"run</th></tr></thead>\n<tbody>\n");
}

static void end_limits(struct ts_str *out)
{
	ts_str_add(out, "</tbody>\n</table>");
}

/* The end of the runs with the limit of run k. */
static size_t end_of_limit(const struct ts_record *r, size_t k)
{
	size_t end = k + 1;

	while (end < r->nruns && same_limit(&r->run[end], &r->run[k]))
		end++;
	return end;
}

static size_t count_limits(const struct ts_record *r)
{
	size_t n = 0;

	for (size_t k = 0; k < r->nruns; k = end_of_limit(r, k))
		n++;
	return n;
}

static void add_limits(struct ts_page *page)
{
	const struct ts_record *r = page->record;

	begin_limits(&page->out);
	for (size_t k = 0; k < r->nruns; k = end_of_limit(r, k))
		add_limit(&page->out, &r->run[k], k + 1, end_of_limit(r, k));
	end_limits(&page->out);
}

/* The run that began nearest to its limit; NULL: no run has one. */
static const struct ts_record_run *nearest_limit(const struct ts_record *r)
{
	const struct ts_record_run *nearest = NULL;

	for (size_t k = 0; k < r->nruns; k++) {
		const struct ts_record_run *run = &r->run[k];

		if (run->limit_of && (!nearest || run->dt / run->limit > nearest->dt / nearest->limit))
			nearest = run;
	}
	return nearest;
}

static void add_nearest(struct ts_page *page)
{
	const struct ts_record *r = page->record;
	const struct ts_record_run *nearest = nearest_limit(r);
	struct ts_str *out = &page->out;

	if (!nearest)
		return;
	ts_str_add(out, "<p class=\"soft\">Of the runs below, the one that began nearest to its limit</p>\n"
			"<div class=\"scroll\">");
	begin_limits(out);
	add_limit(out, nearest, (size_t)(nearest - r->run) + 1, (size_t)(nearest - r->run) + 1);
	end_limits(out);
	ts_str_add(out, "</div>\n");
}

static void add_fractions(struct ts_page *page)
{
	const struct ts_record *r = page->record;
	const struct ts_plot_mark limit = { .name = "limit", .at = 1 };
	bool any = false;

	for (size_t k = 0; k < r->ntables; k++) {
		const struct ts_record_table *t = &r->table[k];

		if (ts_rows_is_constant(&t->rows, t->n))
			continue;
		ts_str_add(&page->out, any ? "" : "<div class=\"plots\">\n");
		any = true;
		ts_str_add(&page->out, "<div class=\"card\"><h3>Time step / its limit</h3><small>as checked "
				       "during the run</small>");
		add_plot(page, t, t->n, "step / limit", NULL,
			 t->rows.sum[t->n].greatest > 0.5 ? &limit : NULL);
		ts_str_add(&page->out, "</div>\n");
	}
	ts_str_add(&page->out, any ? "</div>\n" : "");
}

void ts_page_limits(struct ts_page *page)
{
	const struct ts_record *r = page->record;
	struct ts_str *out = &page->out;

	if (!r->nruns)
		return;
	ts_page_section(out, "limits", "Time step and its limits");
	if (count_limits(r) <= FEW_LIMITS) {
		ts_str_add(out, "<div class=\"scroll\">");
		add_limits(page);
		ts_str_add(out, "</div>\n");
	} else {
		add_nearest(page);
		ts_str_add(out, "<details><summary>");
		if ((size_t)r->runs > r->nruns)
			ts_str_addf(out, "The first %zu of %" PRId64 " runs", r->nruns, r->runs);
		else
			ts_str_addf(out, "All %zu runs", r->nruns);
		ts_str_add(out, "</summary><div>");
		add_limits(page);
		ts_str_add(out, "</div></details>\n");
	}
	add_fractions(page);
	ts_page_end_section(out);
}
