#include "crosscheck/compare.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/sort.h"
#include "crosscheck/meaning.h"
#include "crosscheck/reader.h"

#include "base/banned.h"

/* %g without precision prints six digits and no trailing zeros. */
enum { LEAST_DIGITS = 6 };

/* Titles and keywords of wall times. */
static const char *const wall_times[] = { "CPU",   "T/CPU", "S/CPU",	 "CPULeft", "cpu",
					  "tpcpu", "spcpu", "cpuremain", NULL };

static bool is_wall_time(const char *name)
{
	for (const char *const *t = wall_times; *t; t++)
		if (ts_streq(*t, name))
			return true;
	return false;
}

static struct ts_compared *find_compared(const struct ts_pairing *p, const char *name)
{
	for (size_t k = 0; k < p->columns; k++)
		if (p->column[k].name == name)
			return &p->column[k];
	return NULL;
}

static enum ts_status find_or_add_column(struct ts_pairing *p, const char *name, struct ts_error *err,
					 struct ts_compared **out)
{
	*out = find_compared(p, name);
	if (*out)
		return TS_OK;
	if (TS_GROW(p->column, p->column_capacity, p->columns + 1) != TS_OK)
		return ts_nomem(err);
	*out = &p->column[p->columns++];
	**out = (struct ts_compared){ .name = name, .lo = INFINITY, .hi = -INFINITY };
	(*out)->differs_on_purpose = ts_meanings_differ(p->meanings, p->kind, name);
	return TS_OK;
}

static void update_range(struct ts_compared *c, int who, const struct ts_frame *f, size_t k)
{
	struct ts_printed_column *side = &c->side[who];

	side->present = true;
	for (size_t row = 0; row < f->rows; row++) {
		const struct ts_printed *w = &f->cell[row * f->columns + k];

		side->integer = w->decimals < 0 && (side->integer || !side->n);
		side->n++;
		side->padded |= w->padded;
		side->digits = w->digits > side->digits ? w->digits : side->digits;
		side->decimals = w->decimals > side->decimals ? w->decimals : side->decimals;
		if (w->word) /* differs from all others, whatever the scale */
			continue;
		c->lo = fmin(c->lo, w->value);
		c->hi = fmax(c->hi, w->value);
	}
}

static struct ts_reader reader_of(const struct ts_pairing *p, int who, struct ts_error *err,
				  struct ts_pool *pool)
{
	return (struct ts_reader){ .kind = p->kind,
				   .meanings = p->meanings,
				   .err = err,
				   .pool = pool,
				   .folder = p->folder[who],
				   .file = p->file[who] };
}

/* First pass: finds the columns, their ranges and digits. */
static enum ts_status find_columns(struct ts_pairing *p, int who, struct ts_reader *r)
{
	struct ts_compared *column;
	bool got;

	TS_TRY(ts_reader_open(r));
	for (;;) {
		TS_TRY(ts_reader_next(r, &got));
		if (!got)
			return TS_OK;
		p->lines |= r->frame.line;
		for (size_t k = 0; k < r->frame.columns; k++) {
			if (is_wall_time(r->frame.name[k])) {
				p->wall_times_skipped = true;
				continue;
			}
			TS_TRY(find_or_add_column(p, r->frame.name[k], r->err, &column));
			update_range(column, who, &r->frame, k);
		}
	}
}

/* Length of the part of the name that the components of a vector have in common: 1 of "fx", 3 of "f_a[2]";
 * 0 if it is not a component. *floor: lower limit of their scales relative to the largest of them. */
static size_t vector_stem(const char *name, double *floor)
{
	size_t n = strlen(name);
	const char *bracket = strpbrk(name, "[(");

	if (bracket && *bracket == '(' && bracket > name)
		bracket--; /* "normal (2)" belongs to "normal" */

	*floor = bracket ? 1e-6 : 1;
	if (bracket)
		return (size_t)(bracket - name);
	return n > 1 && strchr("xyz", name[n - 1]) ? n - 1 : 0;
}

static bool is_coordinate(const char *name)
{
	return name[0] && !name[1] && strchr("xyz", name[0]);
}

static void set_scales(struct ts_pairing *p)
{
	for (size_t k = 0; k < p->columns; k++) {
		struct ts_compared *c = &p->column[k];

		if (!(c->lo <= c->hi))
			c->lo = c->hi = 0; /* no number at all */
		c->scale = fmax(c->hi - c->lo, 1e-3 * fmax(fabs(c->lo), fabs(c->hi)));
	}
	for (size_t k = 0; k < p->columns; k++) {
		struct ts_compared *c = &p->column[k];
		double floor;
		size_t n = vector_stem(c->name, &floor);

		for (size_t m = 0; m < p->columns; m++) {
			const struct ts_compared *other = &p->column[m];
			double unused;

			if ((is_coordinate(c->name) && is_coordinate(other->name)) ||
			    (n && strncmp(c->name, other->name, n) == 0 &&
			     (vector_stem(other->name, &unused) == n || !other->name[n])))
				c->scale = fmax(c->scale, floor * other->scale);
		}
	}
	for (size_t k = 0; k < p->columns; k++)
		if (!(p->column[k].scale > 0))
			p->column[k].scale = 1;
}

/* One unit of the last printed digit. */
static double resolution(const struct ts_printed_column *side, double value)
{
	int digits = side->digits > LEAST_DIGITS ? side->digits : LEAST_DIGITS;

	if (side->integer || value == 0)
		return 0;
	if (side->padded)
		return pow(10, -side->decimals);
	return pow(10, floor(log10(fabs(value))) + 1 - digits);
}

static double scaled_difference(const struct ts_compared *c, const struct ts_printed *a,
				const struct ts_printed *b)
{
	double open;

	if (a->value == b->value)
		return 0;
	open = fmax(resolution(&c->side[TS_SELF], a->value), resolution(&c->side[TS_PEER], b->value));
	return fmax(0, fabs(a->value - b->value) - (1 + 1e-6) * open) / c->scale;
}

/* State of a pass over the frames of both programs. */
struct pass {
	struct ts_pairing *p;
	struct ts_reader reader[TS_NPROGRAMS];
	double tolerance;
	int64_t from;
	struct row *row[TS_NPROGRAMS];
	double *sorted[TS_NPROGRAMS];
	size_t row_capacity[TS_NPROGRAMS], sorted_capacity[TS_NPROGRAMS];
};

static void note_unmatched(struct ts_pairing *p, int64_t step)
{
	if (p->unmatched_at < 0 || step < p->unmatched_at)
		p->unmatched_at = step;
}

/* A row and the columns by which it is identified. */
struct row {
	const struct ts_printed *cell;
	const size_t *key;
	size_t keys;
	bool swapped; /* the partners of the contact have been exchanged */
};

static int compare_keys(const struct row *a, const struct row *b)
{
	for (size_t k = 0; k < a->keys && k < b->keys; k++) {
		double u = a->cell[a->key[k]].value, v = b->cell[b->key[k]].value;

		if (u != v)
			return u < v ? -1 : 1;
	}
	return 0;
}

static int compare_rows_by_key(const void *a, const void *b)
{
	return compare_keys(a, b);
}

static bool has_keys(enum ts_frame_kind kind)
{
	return kind == TS_FRAMES_DUMP || kind == TS_FRAMES_VTK;
}

/* Finds the columns that identify a row: of particles the identity, of other dumps all integer columns;
 * lines are matched by their order. The indices are those of the frame of `who`. */
static enum ts_status find_keys(struct pass *w, int who, size_t **key, size_t *n)
{
	const struct ts_frame *f = &w->reader[who].frame;

	*n = 0;
	*key = ts_alloc(f->columns, sizeof **key);
	if (!*key)
		return ts_nomem(w->reader[who].err);
	for (size_t k = 0; k < f->columns && has_keys(w->p->kind); k++) {
		const struct ts_compared *c = find_compared(w->p, f->name[k]);

		if (ts_frame_column(&w->reader[!who].frame, f->name[k]) == SIZE_MAX || !c)
			continue;
		if (f->entries ? c->side[TS_SELF].integer && c->side[TS_PEER].integer
			       : ts_streq(f->name[k], "id"))
			(*key)[(*n)++] = k;
	}
	return TS_OK;
}

static enum ts_status order_rows(struct pass *w, int who, const size_t *key, size_t keys)
{
	const struct ts_frame *f = &w->reader[who].frame;

	if (TS_GROW(w->row[who], w->row_capacity[who], f->rows + 1) != TS_OK)
		return ts_nomem(w->reader[who].err);
	for (size_t k = 0; k < f->rows; k++)
		w->row[who][k] =
			(struct row){ f->cell + k * f->columns, key, keys, f->has_contacts && f->swapped[k] };
	if (keys)
		ts_sort(w->row[who], f->rows, sizeof *w->row[who], compare_rows_by_key);
	return TS_OK;
}

/* Difference of numbers of a contact whose partners the programs list in opposite order; 0 if the transformed
 * value cannot be derived. */
static double swapped_difference(const struct ts_compared *c, enum ts_swap_rule turning,
				 const struct ts_printed *a, const struct ts_printed *b)
{
	struct ts_printed opposite = *b;

	opposite.value = -opposite.value;
	if (turning == TS_SWAP_UNKNOWN)
		return 0;
	if (turning == TS_SWAP_EITHER_SIGN)
		return fmin(scaled_difference(c, a, b), scaled_difference(c, a, &opposite));
	return scaled_difference(c, a, b);
}

static void compare_row(struct pass *w, const struct row *a, const struct row *b, int64_t step)
{
	const struct ts_frame *self = &w->reader[TS_SELF].frame, *peer = &w->reader[TS_PEER].frame;
	bool swapped = a->swapped != b->swapped;

	w->p->swapped += swapped;
	for (size_t k = 0; k < self->columns; k++) {
		struct ts_compared *c = find_compared(w->p, self->name[k]);
		size_t m = ts_frame_column(peer, self->name[k]);
		double d;

		if (!c || m == SIZE_MAX)
			continue;
		d = swapped ? swapped_difference(c, self->swap_rule[k], &a->cell[k], &b->cell[m])
			    : scaled_difference(c, &a->cell[k], &b->cell[m]);
		if (d > c->most || (d == c->most && c->most == 0)) {
			c->most = d;
			c->at = step;
		}
		if (d > w->tolerance && !c->diverged) {
			c->diverged = true;
			c->diverged_at = step;
		}
	}
}

static enum ts_status compare_frames(struct pass *w)
{
	const struct ts_frame *self = &w->reader[TS_SELF].frame, *peer = &w->reader[TS_PEER].frame;
	size_t *key[TS_NPROGRAMS] = { NULL }, keys[TS_NPROGRAMS], i = 0, j = 0, unmatched = 0;
	enum ts_status status = TS_OK;

	for (int who = 0; who < TS_NPROGRAMS && status == TS_OK; who++) {
		status = find_keys(w, who, &key[who], &keys[who]);
		if (status == TS_OK)
			status = order_rows(w, who, key[who], keys[who]);
	}
	while (status == TS_OK && i < self->rows && j < peer->rows) {
		const struct row *a = &w->row[TS_SELF][i], *b = &w->row[TS_PEER][j];
		int order = compare_keys(a, b);

		if (order == 0)
			compare_row(w, a, b, self->step);
		unmatched += order != 0;
		i += order <= 0;
		j += order >= 0;
	}
	unmatched += self->rows - i + peer->rows - j;
	if (status == TS_OK && unmatched) {
		w->p->unmatched_rows += unmatched;
		note_unmatched(w->p, self->step);
	}
	ts_free(key[TS_SELF]);
	ts_free(key[TS_PEER]);
	return status;
}

static int compare_values(const void *a, const void *b)
{
	double u = *(const double *)a, v = *(const double *)b;

	return (u > v) - (u < v);
}

/* Sorts the values of a column in a frame, and updates its sums. */
static enum ts_status sort_column(struct pass *w, int who, struct ts_compared *c, size_t k)
{
	const struct ts_frame *f = &w->reader[who].frame;
	struct ts_printed_column *side = &c->side[who];
	double *v;

	if (TS_GROW(w->sorted[who], w->sorted_capacity[who], f->rows + 1) != TS_OK)
		return ts_nomem(w->reader[who].err);
	v = w->sorted[who];
	for (size_t row = 0; row < f->rows; row++) {
		const struct ts_printed *cell = &f->cell[row * f->columns + k];
		const double d = cell->value - c->lo;

		v[row] = cell->value;
		if (cell->word)
			continue;
		side->n_after++;
		side->sum += d;
		side->squares += d * d;
	}
	ts_sort(v, f->rows, sizeof *v, compare_values);
	return TS_OK;
}

/* Distance of two distributions: the mean distance of their quantiles (sorted values). */
static double quantile_distance(const double *a, size_t n, const double *b, size_t m)
{
	size_t count = n < m ? n : m;
	double sum = 0;

	for (size_t k = 0; k < count; k++)
		sum += fabs(a[(size_t)(((double)k + 0.5) * (double)n / (double)count)] -
			    b[(size_t)(((double)k + 0.5) * (double)m / (double)count)]);
	return count ? sum / (double)count : 0;
}

/* Whether signs in the column depend on the order of the partners, so that distributions cannot be
 * compared. */
static bool depends_on_order(const struct ts_frame *f, size_t k)
{
	return f->has_contacts &&
	       (f->swap_rule[k] == TS_SWAP_EITHER_SIGN || f->swap_rule[k] == TS_SWAP_UNKNOWN);
}

static enum ts_status gather_statistics(struct pass *w)
{
	const struct ts_frame *self = &w->reader[TS_SELF].frame, *peer = &w->reader[TS_PEER].frame;

	for (size_t k = 0; self->step >= w->from && k < self->columns; k++) {
		struct ts_compared *c = find_compared(w->p, self->name[k]);
		size_t m = ts_frame_column(peer, self->name[k]);

		if (!c || m == SIZE_MAX || (w->p->swapped && depends_on_order(self, k)))
			continue;
		TS_TRY(sort_column(w, TS_SELF, c, k));
		TS_TRY(sort_column(w, TS_PEER, c, m));
		c->quantiles +=
			quantile_distance(w->sorted[TS_SELF], self->rows, w->sorted[TS_PEER], peer->rows) /
			c->scale;
		c->frames++;
	}
	return TS_OK;
}

/* Reads the frames of both programs in order of their steps, and calls `visit` for those that both have. */
static enum ts_status match_frames(struct pass *w, enum ts_status (*visit)(struct pass *w))
{
	bool got[TS_NPROGRAMS];
	const struct ts_frame *self = &w->reader[TS_SELF].frame, *peer = &w->reader[TS_PEER].frame;

	for (int who = 0; who < TS_NPROGRAMS; who++) {
		TS_TRY(ts_reader_open(&w->reader[who]));
		TS_TRY(ts_reader_next(&w->reader[who], &got[who]));
	}
	while (got[TS_SELF] || got[TS_PEER]) {
		bool both = got[TS_SELF] && got[TS_PEER], behind[TS_NPROGRAMS];

		behind[TS_SELF] = got[TS_SELF] && (!got[TS_PEER] || self->step <= peer->step);
		behind[TS_PEER] = got[TS_PEER] && (!got[TS_SELF] || peer->step <= self->step);
		if (both && self->step == peer->step)
			TS_TRY(visit(w));
		for (int who = 0; who < TS_NPROGRAMS; who++) {
			if (!behind[who])
				continue;
			if (visit == compare_frames && behind[!who])
				w->p->frames += who == TS_SELF;
			if (visit == compare_frames && !behind[!who]) {
				w->p->unmatched_frames[who]++;
				note_unmatched(w->p, w->reader[who].frame.step);
			}
		}
		for (int who = 0; who < TS_NPROGRAMS; who++)
			if (behind[who])
				TS_TRY(ts_reader_next(&w->reader[who], &got[who]));
	}
	return TS_OK;
}

static enum ts_status run_pass(struct ts_pairing *p, struct pass *w, struct ts_error *err,
			       struct ts_pool *pool, enum ts_status (*visit)(struct pass *w))
{
	enum ts_status status;

	w->p = p;
	for (int who = 0; who < TS_NPROGRAMS; who++)
		w->reader[who] = reader_of(p, who, err, pool);
	status = match_frames(w, visit);
	for (int who = 0; who < TS_NPROGRAMS; who++) {
		ts_reader_close(&w->reader[who]);
		ts_free(w->row[who]);
		ts_free(w->sorted[who]);
	}
	return status;
}

enum ts_status ts_compare(struct ts_pairing *p, double tolerance, struct ts_error *err, struct ts_pool *pool)
{
	struct pass w = { .tolerance = tolerance };

	p->unmatched_at = -1;
	for (int who = 0; who < TS_NPROGRAMS; who++) {
		struct ts_reader r = reader_of(p, who, err, pool);
		enum ts_status status = find_columns(p, who, &r);

		ts_reader_close(&r);
		TS_TRY(status);
	}
	set_scales(p);
	return run_pass(p, &w, err, pool, compare_frames);
}

static double mean_of(const struct ts_printed_column *side)
{
	return side->sum / (double)side->n_after;
}

static double deviation_of(const struct ts_printed_column *side)
{
	double mean = mean_of(side);

	return sqrt(fmax(0, side->squares / (double)side->n_after - mean * mean));
}

enum ts_status ts_compare_statistics(struct ts_pairing *p, int64_t from, struct ts_error *err,
				     struct ts_pool *pool)
{
	struct pass w = { .from = from };

	TS_TRY(run_pass(p, &w, err, pool, gather_statistics));
	for (size_t k = 0; k < p->columns; k++) {
		struct ts_compared *c = &p->column[k];
		const struct ts_printed_column *a = &c->side[TS_SELF], *b = &c->side[TS_PEER];

		if (!a->n_after || !b->n_after)
			continue;
		c->mean = fabs(mean_of(a) - mean_of(b)) / c->scale;
		c->deviation = fabs(deviation_of(a) - deviation_of(b)) / c->scale;
		c->quantiles /= c->frames;
	}
	return TS_OK;
}

bool ts_compare_lacks(const struct ts_compared *column, int who)
{
	return !column->side[who].present && column->side[!who].n;
}

void ts_compare_release(struct ts_pairing *p)
{
	ts_free(p->column);
	p->column = NULL;
	p->columns = p->column_capacity = 0;
}
