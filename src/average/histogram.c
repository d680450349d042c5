#include "average/histogram.h"

#include <math.h>

#include "io/csv.h"
#include "math/exactsum.h"
#include "particle/identity.h"
#include "particle/particles.h"

#include "base/banned.h"

enum { DEFAULT, SCALAR, VECTOR };
const char *const ts_histogram_modes[] = {
	[DEFAULT] = "default", [SCALAR] = "scalar", [VECTOR] = "vector", NULL
};
enum { ANY, GLOBAL, PERATOM, LOCAL };
const char *const ts_histogram_kinds[] = {
	[ANY] = "any", [GLOBAL] = "global", [PERATOM] = "peratom", [LOCAL] = "local", NULL
};
enum { IGNORE, END, EXTRA };
const char *const ts_histogram_beyond[] = { [IGNORE] = "ignore", [END] = "end", [EXTRA] = "extra", NULL };
/* numbers that follow those of the bins */
enum { TOTAL, MISSING, LEAST, LARGEST, NSTATISTICS };

static size_t count_bins(const struct ts_histogram *h)
{
	return (size_t)h->bins + (h->beyond == EXTRA ? 2 : 0);
}

static unsigned shapes_of(const struct ts_histogram *h)
{
	static const unsigned wanted[] = { [ANY] = TS_WANT(VECTOR) | TS_WANT(PERATOM) | TS_WANT(LOCAL),
					   [GLOBAL] = TS_WANT(VECTOR),
					   [PERATOM] = TS_WANT(PERATOM),
					   [LOCAL] = TS_WANT(LOCAL) };

	if (h->mode == SCALAR)
		return TS_WANT(SCALAR);
	return wanted[h->kind] | (h->mode == DEFAULT && h->kind == ANY ? TS_WANT(SCALAR) : 0);
}

enum ts_status ts_histogram_init(struct ts_instance *self, struct tsim *sim)
{
	struct ts_histogram *h = self->state;
	char what[64];

	snprintf(what, sizeof what, "fix %s", self->style->name);
	if (!(h->lo < h->hi))
		return ts_fail(&sim->error, TS_RANGE, &self->where, "%s: lo must be less than hi", what);
	h->average.totals = h->average.extremes = true;
	TS_TRY(ts_average_init(self, sim, &h->average));
	h->file.blocks = true;
	TS_TRY(ts_average_file_init(self, sim, &h->file));
	TS_TRY(ts_ref_list_init(sim, what, &self->arena, h->words, shapes_of(h), &h->input));
	/* without `mode` and `kind`, styles that have a scalar output are read as scalars */
	for (size_t k = 0; k < h->input.n && h->mode == DEFAULT && h->kind == ANY; k++)
		if (!h->input.item[k].quantity && ts_ref_shapes(sim, &h->input.item[k].ref) & TS_WANT(SCALAR))
			h->input.item[k].shape = TS_SCALAR;
	if (h->weighted && h->input.n != 2)
		return ts_fail(&sim->error, TS_SYNTAX, &self->where,
			       "%s: expected two values, the second being the weight; found %zu", what,
			       h->input.n);
	if (h->average.n)
		return TS_OK;
	return ts_average_resize(self, sim, &h->average, count_bins(h) + NSTATISTICS);
}

/* Bin of a value, from 0; -1: it is missing. */
static int64_t bin_of(const struct ts_histogram *h, double value)
{
	int64_t bins = (int64_t)count_bins(h);
	double at = floor((value - h->lo) * ((double)h->bins / (h->hi - h->lo)));

	if (value < h->lo)
		return h->beyond == IGNORE ? -1 : 0;
	if (value > h->hi)
		return h->beyond == IGNORE ? -1 : bins - 1;
	at = fmin(at, (double)(h->bins - 1)); /* the upper end belongs to the last bin */
	return (int64_t)at + (h->beyond == EXTRA);
}

/* Adds a value to the histogram. Sums do not depend on the order in memory: unit weights are exact, others
 * are added in the order of the values, which for particles is that of their ids. */
static void count_value(struct ts_histogram *h, double value, double weight)
{
	double *s = h->average.sum + count_bins(h);
	int64_t bin;

	if (isnan(value)) {
		s[MISSING] += weight;
		return;
	}
	s[LEAST] = fmin(s[LEAST], value);
	s[LARGEST] = fmax(s[LARGEST], value);
	bin = bin_of(h, value);
	s[bin < 0 ? MISSING : TOTAL] += weight;
	if (bin >= 0)
		h->average.sum[bin] += weight;
}

static enum ts_status evaluate_input(struct ts_instance *self, struct tsim *sim, size_t k,
				     struct ts_table *out)
{
	const struct ts_histogram *h = self->state;

	if (h->input.item[k].shape == TS_SCALAR) {
		if (ts_table_resize(out, 1, 1) != TS_OK)
			return ts_nomem(&sim->error);
		return ts_ref_input_scalar(sim, &h->input.item[k], out->data);
	}
	return ts_ref_input_eval(sim, &h->input.item[k], out);
}

static enum ts_status add_input(struct ts_instance *self, struct tsim *sim, size_t k)
{
	struct ts_histogram *h = self->state;
	const struct ts_ref_input *input = &h->input.item[k];
	const struct ts_particles *p = sim->particles;
	struct ts_identities map = { 0 };
	size_t n;

	TS_TRY(evaluate_input(self, sim, k, &h->values));
	n = h->values.rows * h->values.columns;
	if (h->weighted) {
		TS_TRY(evaluate_input(self, sim, k + 1, &h->weights));
		if (h->weights.rows * h->weights.columns != n)
			return ts_fail(&sim->error, TS_STATE, &h->input.item[k + 1].where,
				       "fix %s: %zu weights for %zu values", self->style->name,
				       h->weights.rows * h->weights.columns, n);
	}
	if (input->shape == TS_PERATOM)
		TS_TRY(ts_identities(sim, true, &map));
	for (size_t at = 0; at < n; at++) {
		size_t i = map.row ? (size_t)map.row[at] : at;

		if (!map.row || ts_in_group(p, i, self->group))
			count_value(h, h->values.data[i], h->weighted ? h->weights.data[i] : 1);
	}
	return TS_OK;
}

/* Centre of a bin; lo and hi for the extra bins. */
static double bin_centre(const struct ts_histogram *h, size_t bin)
{
	double width = (h->hi - h->lo) / (double)h->bins;

	if (h->beyond != EXTRA)
		return h->lo + ((double)bin + 0.5) * width;
	if (bin == 0 || bin == count_bins(h) - 1)
		return bin ? h->hi : h->lo;
	return h->lo + ((double)bin - 0.5) * width;
}

static enum ts_status add_titles(struct ts_instance *self, struct tsim *sim)
{
	struct ts_histogram *h = self->state;
	struct ts_str line = { 0 };

	ts_str_addf(&line, "# Histogrammed data for fix %s", self->id);
	if (line.failed)
		return ts_nomem(&sim->error);
	ts_average_file_title(&h->file, 0, ts_str_text(&line));
	ts_average_file_title(&h->file, 1,
			      "# TimeStep Number-of-bins Total-counts Missing-counts Min-value Max-value");
	ts_average_file_title(&h->file, 2, "# Bin Coord Count Count/Total");
	ts_str_release(&line);
	return TS_OK;
}

static double fraction(const struct ts_histogram *h, size_t bin)
{
	double total = h->average.result[count_bins(h) + TOTAL];

	return total > 0 ? h->average.result[bin] / total : 0;
}

/* The least and the largest value are 0 if there is no value in any sample. */
static double statistic(const struct ts_histogram *h, size_t k)
{
	const double *s = h->average.result + count_bins(h);

	return (k == LEAST || k == LARGEST) && !(s[LEAST] <= s[LARGEST]) ? 0 : s[k];
}

static enum ts_status add_csv_names(struct ts_histogram *h, struct tsim *sim)
{
	static const char *const names[] = { "step",  "bin",	 "coord", "count", "fraction",
					     "total", "missing", "min",	  "max" };

	ts_csv_names(&h->file.text, names, sizeof names / sizeof *names);
	return ts_average_file_names_done(sim, &h->file);
}

/* A row of a table has the statistics of its histogram, too. */
static void add_csv_row(struct ts_histogram *h, const struct tsim *sim, size_t bin)
{
	struct ts_average_file *f = &h->file;

	ts_csv_int(&f->text, sim->clock.step);
	ts_csv_int(&f->text, (int64_t)bin + 1);
	ts_average_file_number(f, bin_centre(h, bin));
	ts_average_file_number(f, h->average.result[bin]);
	ts_average_file_number(f, fraction(h, bin));
	for (size_t k = 0; k < NSTATISTICS; k++)
		ts_average_file_number(f, statistic(h, k));
	ts_csv_end(&f->text);
}

static enum ts_status write_result(struct ts_instance *self, struct tsim *sim)
{
	struct ts_histogram *h = self->state;
	struct ts_str *text = &h->file.text;
	size_t n = count_bins(h);
	bool titles;

	if (!ts_average_file_wanted(&h->file))
		return TS_OK;
	TS_TRY(ts_average_file_begin(self, sim, &h->file, &titles));
	if (titles)
		TS_TRY(h->file.csv ? add_csv_names(h, sim) : add_titles(self, sim));
	for (size_t b = 0; h->file.csv && b < n; b++)
		add_csv_row(h, sim, b);
	if (h->file.csv)
		return ts_average_file_end(sim, &h->file);
	ts_str_addf(text, "%lld %zu", (long long)sim->clock.step, n);
	for (size_t k = 0; k < NSTATISTICS; k++)
		ts_average_file_number(&h->file, statistic(h, k));
	ts_str_add(text, "\n");
	for (size_t b = 0; b < n; b++) {
		ts_str_addf(text, "%zu", b + 1);
		ts_average_file_number(&h->file, bin_centre(h, b));
		ts_average_file_number(&h->file, h->average.result[b]);
		ts_average_file_number(&h->file, fraction(h, b));
		ts_str_add(text, "\n");
	}
	return ts_average_file_end(sim, &h->file);
}

enum ts_status ts_histogram_sample(struct ts_instance *self, struct tsim *sim)
{
	struct ts_histogram *h = self->state;
	double *s = h->average.sum + count_bins(h);

	if (!ts_average_due(&h->average, sim))
		return TS_OK;
	if (h->average.samples == 0) {
		s[LEAST] = INFINITY;
		s[LARGEST] = -INFINITY;
	}
	for (size_t k = 0; k < (h->weighted ? 1 : h->input.n); k++)
		TS_TRY(add_input(self, sim, k));
	if (!ts_average_sampled(&h->average, sim))
		return TS_OK;
	ts_average_combine(&h->average);
	return write_result(self, sim);
}

enum ts_status ts_histogram_archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a)
{
	struct ts_histogram *h = self->state;

	TS_TRY(ts_average_archive(self, sim, a, &h->average));
	if (h->average.n != count_bins(h) + NSTATISTICS)
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "fix %s %s: the restart file holds another number of bins", self->style->name,
			       self->id);
	return TS_OK;
}

static enum ts_status eval_statistics(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct ts_histogram *h = self->state;

	(void)sim;
	for (size_t k = 0; k < NSTATISTICS; k++)
		out->data[k] = statistic(h, k);
	return TS_OK;
}

static enum ts_status eval_bins(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct ts_histogram *h = self->state;
	size_t n = count_bins(h);

	(void)sim;
	TS_TRY(ts_table_resize(out, n, 3));
	for (size_t b = 0; b < n; b++) {
		out->data[3 * b] = bin_centre(h, b);
		out->data[3 * b + 1] = h->average.result[b];
		out->data[3 * b + 2] = fraction(h, b);
	}
	return TS_OK;
}

static const char *const statistics[] = { "total", "missing", "min", "max", NULL };
static const char *const columns[] = { "coord", "count", "fraction", NULL };
const struct ts_value ts_histogram_values[] = {
	{ "statistics", "", "total count in the bins, missing values, smallest and largest value", TS_VECTOR,
	  NSTATISTICS, statistics, eval_statistics },
	{ "bins", "", "centre, count, and fraction of the total for each bin", TS_ARRAY, 3, columns,
	  eval_bins },
	{ .name = NULL },
};

enum ts_status ts_histogram_plan(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report)
{
	const struct ts_histogram *s = self->state;

	/* place, count and fraction of most bins are short */
	return ts_average_file_plan(&s->file, sim, s->average.freq, (size_t)s->bins, 1, report);
}

void ts_histogram_fini(struct ts_instance *self)
{
	struct ts_histogram *h = self->state;

	ts_average_file_release(&h->file);
	ts_average_release(&h->average);
	ts_ref_list_release(&h->input);
	ts_table_release(&h->values);
	ts_table_release(&h->weights);
}
