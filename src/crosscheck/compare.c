#include "crosscheck/compare.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "crosscheck/meaning.h"
#include "crosscheck/reader.h"

#include "base/banned.h"

/* A format of the programs without precision prints six digits and drops zeros at the end. */
enum { LEAST_DIGITS = 6 };

/* Names of wall times, as titles and as keywords. */
static const char *const wall_times[] = { "CPU",   "T/CPU", "S/CPU",	 "CPULeft", "cpu",
					  "tpcpu", "spcpu", "cpuremain", NULL };

static bool is_wall_time(const char *name)
{
	for (const char *const *t = wall_times; *t; t++)
		if (ts_streq(*t, name))
			return true;
	return false;
}

static struct ts_compared *find(const struct ts_pairing *p, const char *name)
{
	for (size_t k = 0; k < p->columns; k++)
		if (p->column[k].name == name)
			return &p->column[k];
	return NULL;
}

static enum ts_status column_of(struct ts_pairing *p, const char *name, struct ts_error *err,
				struct ts_compared **out)
{
	*out = find(p, name);
	if (*out)
		return TS_OK;
	if (TS_GROW(p->column, p->column_capacity, p->columns + 1) != TS_OK)
		return ts_nomem(err);
	*out = &p->column[p->columns++];
	**out = (struct ts_compared){ .name = name, .lo = INFINITY, .hi = -INFINITY };
	(*out)->differs = ts_meanings_differ(p->meanings, p->kind, name);
	return TS_OK;
}

static void survey(struct ts_compared *c, int who, const struct ts_frame *f, size_t k)
{
	struct ts_side *side = &c->side[who];

	side->named = true;
	for (size_t row = 0; row < f->rows; row++) {
		const struct ts_printed *w = &f->cell[row * f->columns + k];

		side->whole = w->decimals < 0 && (side->whole || !side->n);
		side->n++;
		side->padded |= w->padded;
		side->digits = w->digits > side->digits ? w->digits : side->digits;
		side->decimals = w->decimals > side->decimals ? w->decimals : side->decimals;
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

/* The first reading: which columns there are, their ranges and digits. */
static enum ts_status survey_file(struct ts_pairing *p, int who, struct ts_reader *r)
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
				p->left_out = true;
				continue;
			}
			TS_TRY(column_of(p, r->frame.name[k], r->err, &column));
			survey(column, who, &r->frame, k);
		}
	}
}

/* How long the part of the name is that the components of a vector share: of "fx" 1, of "f_a[2]" 3; 0: it
 * is no component. *floor: how large their scales are at least, compared with each other. */
static size_t stem(const char *name, double *floor)
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

static bool single(const char *name)
{
	return name[0] && !name[1] && strchr("xyz", name[0]);
}

static void set_scales(struct ts_pairing *p)
{
	for (size_t k = 0; k < p->columns; k++) {
		struct ts_compared *c = &p->column[k];

		c->scale = fmax(c->hi - c->lo, 1e-3 * fmax(fabs(c->lo), fabs(c->hi)));
	}
	for (size_t k = 0; k < p->columns; k++) {
		struct ts_compared *c = &p->column[k];
		double floor;
		size_t n = stem(c->name, &floor);

		for (size_t m = 0; m < p->columns; m++) {
			const struct ts_compared *other = &p->column[m];
			double unused;

			if ((single(c->name) && single(other->name)) ||
			    (n && strncmp(c->name, other->name, n) == 0 &&
			     (stem(other->name, &unused) == n || !other->name[n])))
				c->scale = fmax(c->scale, floor * other->scale);
		}
	}
	for (size_t k = 0; k < p->columns; k++)
		if (!(p->column[k].scale > 0))
			p->column[k].scale = 1;
}

/* One unit of the last digit that was printed. */
static double resolution(const struct ts_side *side, double value)
{
	int digits = side->digits > LEAST_DIGITS ? side->digits : LEAST_DIGITS;

	if (side->whole || value == 0)
		return 0;
	if (side->padded)
		return pow(10, -side->decimals);
	return pow(10, floor(log10(fabs(value))) + 1 - digits);
}

static double difference(const struct ts_compared *c, const struct ts_printed *a, const struct ts_printed *b)
{
	double open;

	if (a->value == b->value)
		return 0;
	open = fmax(resolution(&c->side[TS_HERE], a->value), resolution(&c->side[TS_PEER], b->value));
	return fmax(0, fabs(a->value - b->value) - (1 + 1e-6) * open) / c->scale;
}

/* What both readers and a pass over them need. */
struct walk {
	struct ts_pairing *p;
	struct ts_reader reader[TS_BOTH];
	double tolerance;
	int64_t from;
	struct row *row[TS_BOTH];
	double *sorted[TS_BOTH];
	size_t row_capacity[TS_BOTH], sorted_capacity[TS_BOTH];
};

static void alone(struct ts_pairing *p, int64_t step)
{
	if (p->alone_at < 0 || step < p->alone_at)
		p->alone_at = step;
}

/* A row and the columns that tell it from the others. */
struct row {
	const struct ts_printed *cell;
	const size_t *key;
	size_t keys;
	bool turned;
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

static int by_key(const void *a, const void *b)
{
	return compare_keys(a, b);
}

static bool has_keys(enum ts_frame_kind kind)
{
	return kind == TS_FRAMES_DUMP || kind == TS_FRAMES_VTK;
}

/* Particles are recognised by their identity, other entries of dumps by all that are whole numbers, lines
 * by their order. The columns are those of the frame of `who`. */
static enum ts_status keys_of(struct walk *w, int who, size_t **key, size_t *n)
{
	const struct ts_frame *f = &w->reader[who].frame;

	*n = 0;
	*key = ts_alloc(f->columns, sizeof **key);
	if (!*key)
		return ts_nomem(w->reader[who].err);
	for (size_t k = 0; k < f->columns && has_keys(w->p->kind); k++) {
		const struct ts_compared *c = find(w->p, f->name[k]);

		if (ts_frame_column(&w->reader[!who].frame, f->name[k]) == SIZE_MAX || !c)
			continue;
		if (f->entries ? c->side[TS_HERE].whole && c->side[TS_PEER].whole
			       : ts_streq(f->name[k], "id"))
			(*key)[(*n)++] = k;
	}
	return TS_OK;
}

static enum ts_status order_rows(struct walk *w, int who, const size_t *key, size_t keys)
{
	const struct ts_frame *f = &w->reader[who].frame;

	if (TS_GROW(w->row[who], w->row_capacity[who], f->rows + 1) != TS_OK)
		return ts_nomem(w->reader[who].err);
	for (size_t k = 0; k < f->rows; k++)
		w->row[who][k] =
			(struct row){ f->cell + k * f->columns, key, keys, f->turns && f->turned[k] };
	if (keys)
		qsort(w->row[who], f->rows, sizeof *w->row[who], by_key);
	return TS_OK;
}

/* Numbers of one contact of which the programs name the partners the other way round; 0 where what they
 * shall be cannot be known. */
static double difference_turned(const struct ts_compared *c, enum ts_turning turning,
				const struct ts_printed *a, const struct ts_printed *b)
{
	struct ts_printed opposite = *b;

	opposite.value = -opposite.value;
	if (turning == TS_TURN_NOT)
		return 0;
	if (turning == TS_TURN_EITHER)
		return fmin(difference(c, a, b), difference(c, a, &opposite));
	return difference(c, a, b);
}

static void compare_row(struct walk *w, const struct row *a, const struct row *b, int64_t step)
{
	const struct ts_frame *here = &w->reader[TS_HERE].frame, *peer = &w->reader[TS_PEER].frame;
	bool turned = a->turned != b->turned;

	w->p->turned += turned;
	for (size_t k = 0; k < here->columns; k++) {
		struct ts_compared *c = find(w->p, here->name[k]);
		size_t m = ts_frame_column(peer, here->name[k]);
		double d;

		if (!c || m == SIZE_MAX)
			continue;
		d = turned ? difference_turned(c, here->turning[k], &a->cell[k], &b->cell[m])
			   : difference(c, &a->cell[k], &b->cell[m]);
		if (d > c->most || (d == c->most && c->most == 0)) {
			c->most = d;
			c->at = step;
		}
		if (d > w->tolerance && !c->parts) {
			c->parts = true;
			c->parts_at = step;
		}
	}
}

static enum ts_status compare_frames(struct walk *w)
{
	const struct ts_frame *here = &w->reader[TS_HERE].frame, *peer = &w->reader[TS_PEER].frame;
	size_t *key[TS_BOTH] = { NULL }, keys[TS_BOTH], i = 0, j = 0, lone = 0;
	enum ts_status status = TS_OK;

	for (int who = 0; who < TS_BOTH && status == TS_OK; who++) {
		status = keys_of(w, who, &key[who], &keys[who]);
		if (status == TS_OK)
			status = order_rows(w, who, key[who], keys[who]);
	}
	while (status == TS_OK && i < here->rows && j < peer->rows) {
		const struct row *a = &w->row[TS_HERE][i], *b = &w->row[TS_PEER][j];
		int order = compare_keys(a, b);

		if (order == 0)
			compare_row(w, a, b, here->step);
		lone += order != 0;
		i += order <= 0;
		j += order >= 0;
	}
	lone += here->rows - i + peer->rows - j;
	if (status == TS_OK && lone) {
		w->p->rows_alone += lone;
		alone(w->p, here->step);
	}
	ts_free(key[TS_HERE]);
	ts_free(key[TS_PEER]);
	return status;
}

static int by_value(const void *a, const void *b)
{
	double u = *(const double *)a, v = *(const double *)b;

	return (u > v) - (u < v);
}

/* The distribution of a column in one frame, sorted. */
static enum ts_status sort_column(struct walk *w, int who, struct ts_compared *c, size_t k)
{
	const struct ts_frame *f = &w->reader[who].frame;
	struct ts_side *side = &c->side[who];
	double *v;

	if (TS_GROW(w->sorted[who], w->sorted_capacity[who], f->rows + 1) != TS_OK)
		return ts_nomem(w->reader[who].err);
	v = w->sorted[who];
	for (size_t row = 0; row < f->rows; row++) {
		double d;

		v[row] = f->cell[row * f->columns + k].value;
		d = v[row] - c->lo;
		side->after++;
		side->sum += d;
		side->squares += d * d;
	}
	qsort(v, f->rows, sizeof *v, by_value);
	return TS_OK;
}

/* How far apart the distributions are: the mean distance of their quantiles. */
static double distance(const double *a, size_t n, const double *b, size_t m)
{
	size_t count = n < m ? n : m;
	double sum = 0;

	for (size_t k = 0; k < count; k++)
		sum += fabs(a[(size_t)(((double)k + 0.5) * (double)n / (double)count)] -
			    b[(size_t)(((double)k + 0.5) * (double)m / (double)count)]);
	return count ? sum / (double)count : 0;
}

/* The distribution of a column says nothing where its signs depend on which partner is named first. */
static bool is_bound(const struct ts_frame *f, size_t k)
{
	return f->turns && (f->turning[k] == TS_TURN_EITHER || f->turning[k] == TS_TURN_NOT);
}

static enum ts_status gather_statistics(struct walk *w)
{
	const struct ts_frame *here = &w->reader[TS_HERE].frame, *peer = &w->reader[TS_PEER].frame;

	for (size_t k = 0; here->step >= w->from && k < here->columns; k++) {
		struct ts_compared *c = find(w->p, here->name[k]);
		size_t m = ts_frame_column(peer, here->name[k]);

		if (!c || m == SIZE_MAX || (w->p->turned && is_bound(here, k)))
			continue;
		TS_TRY(sort_column(w, TS_HERE, c, k));
		TS_TRY(sort_column(w, TS_PEER, c, m));
		c->profile +=
			distance(w->sorted[TS_HERE], here->rows, w->sorted[TS_PEER], peer->rows) / c->scale;
		c->frames++;
	}
	return TS_OK;
}

/* Both readers side by side; a frame of a step that the other does not have is alone. */
static enum ts_status walk(struct walk *w, enum ts_status (*visit)(struct walk *w))
{
	bool got[TS_BOTH];
	const struct ts_frame *here = &w->reader[TS_HERE].frame, *peer = &w->reader[TS_PEER].frame;

	for (int who = 0; who < TS_BOTH; who++) {
		TS_TRY(ts_reader_open(&w->reader[who]));
		TS_TRY(ts_reader_next(&w->reader[who], &got[who]));
	}
	while (got[TS_HERE] || got[TS_PEER]) {
		bool both = got[TS_HERE] && got[TS_PEER], behind[TS_BOTH];

		behind[TS_HERE] = got[TS_HERE] && (!got[TS_PEER] || here->step <= peer->step);
		behind[TS_PEER] = got[TS_PEER] && (!got[TS_HERE] || peer->step <= here->step);
		if (both && here->step == peer->step)
			TS_TRY(visit(w));
		for (int who = 0; who < TS_BOTH; who++) {
			if (!behind[who])
				continue;
			if (visit == compare_frames && behind[!who])
				w->p->frames += who == TS_HERE;
			if (visit == compare_frames && !behind[!who]) {
				w->p->alone[who]++;
				alone(w->p, w->reader[who].frame.step);
			}
		}
		for (int who = 0; who < TS_BOTH; who++)
			if (behind[who])
				TS_TRY(ts_reader_next(&w->reader[who], &got[who]));
	}
	return TS_OK;
}

static enum ts_status pass(struct ts_pairing *p, struct walk *w, struct ts_error *err, struct ts_pool *pool,
			   enum ts_status (*visit)(struct walk *w))
{
	enum ts_status status;

	w->p = p;
	for (int who = 0; who < TS_BOTH; who++)
		w->reader[who] = reader_of(p, who, err, pool);
	status = walk(w, visit);
	for (int who = 0; who < TS_BOTH; who++) {
		ts_reader_close(&w->reader[who]);
		ts_free(w->row[who]);
		ts_free(w->sorted[who]);
	}
	return status;
}

enum ts_status ts_compare(struct ts_pairing *p, double tolerance, struct ts_error *err, struct ts_pool *pool)
{
	struct walk w = { .tolerance = tolerance };

	p->alone_at = -1;
	for (int who = 0; who < TS_BOTH; who++) {
		struct ts_reader r = reader_of(p, who, err, pool);
		enum ts_status status = survey_file(p, who, &r);

		ts_reader_close(&r);
		TS_TRY(status);
	}
	set_scales(p);
	return pass(p, &w, err, pool, compare_frames);
}

static double mean_of(const struct ts_side *side)
{
	return side->sum / (double)side->after;
}

static double deviation_of(const struct ts_side *side)
{
	double mean = mean_of(side);

	return sqrt(fmax(0, side->squares / (double)side->after - mean * mean));
}

enum ts_status ts_compare_statistics(struct ts_pairing *p, int64_t from, struct ts_error *err,
				     struct ts_pool *pool)
{
	struct walk w = { .from = from };

	TS_TRY(pass(p, &w, err, pool, gather_statistics));
	for (size_t k = 0; k < p->columns; k++) {
		struct ts_compared *c = &p->column[k];
		const struct ts_side *a = &c->side[TS_HERE], *b = &c->side[TS_PEER];

		if (!a->after || !b->after)
			continue;
		c->mean = fabs(mean_of(a) - mean_of(b)) / c->scale;
		c->spread = fabs(deviation_of(a) - deviation_of(b)) / c->scale;
		c->profile /= c->frames;
	}
	return TS_OK;
}

bool ts_compare_lacks(const struct ts_compared *column, int who)
{
	return !column->side[who].named && column->side[!who].n;
}

void ts_compare_release(struct ts_pairing *p)
{
	ts_free(p->column);
	p->column = NULL;
	p->columns = p->column_capacity = 0;
}
