#include "bed/nearest.h"

#include <string.h>

#include "base/alloc.h"
#include "geom/pairs.h"
#include "math/vec3.h"

#include "base/banned.h"

struct search {
	const struct ts_box *box;
	int dimensions;
	const double (*x)[3];
	const int32_t *tag;
	size_t n, k;
	double *d2;    /* [n][k] squared distances of `row` */
	int32_t *row;  /* [n][k] */
	int32_t *have; /* [n] number of neighbours found */
};

static bool is_nearer(const struct search *s, double d2, size_t j, double other_d2, size_t other)
{
	return d2 < other_d2 || (d2 == other_d2 && s->tag[j] < s->tag[other]);
}

static void remove_entry(double *d2, int32_t *row, size_t m, size_t have)
{
	memmove(d2 + m, d2 + m + 1, (have - m - 1) * sizeof *d2);
	memmove(row + m, row + m + 1, (have - m - 1) * sizeof *row);
}

/* Enters j at squared distance d2 into the sorted list of i, unless it is there at a nearer image. */
static void enter(struct search *s, size_t i, size_t j, double d2)
{
	double *distance = s->d2 + s->k * i;
	int32_t *row = s->row + s->k * i;
	size_t have = (size_t)s->have[i], at;

	if (have == s->k && !is_nearer(s, d2, j, distance[have - 1], (size_t)row[have - 1]))
		return;
	for (size_t m = 0; m < have; m++) {
		if ((size_t)row[m] != j)
			continue;
		if (d2 >= distance[m])
			return;
		remove_entry(distance, row, m, have--);
	}
	have = have == s->k ? have - 1 : have;
	for (at = have; at > 0 && is_nearer(s, d2, j, distance[at - 1], (size_t)row[at - 1]); at--) {
		distance[at] = distance[at - 1];
		row[at] = row[at - 1];
	}
	distance[at] = d2;
	row[at] = (int32_t)j;
	s->have[i] = (int32_t)have + 1;
}

static void enter_pair(void *context, size_t i, size_t j, const double d[3])
{
	if (i != j)
		enter(context, i, j, ts_dot(d, d));
}

/* Compares the point with all others. */
static void search_all(struct search *s, size_t i)
{
	s->have[i] = 0;
	for (size_t j = 0; j < s->n; j++) {
		double d[3];

		ts_sub(s->x[i], s->x[j], d);
		ts_box_nearest(s->box, d);
		enter_pair(s, i, j, d);
	}
}

/* Few points without k neighbours within the cutoff, such as those that fly above a bed, are compared with all others;
 * if there are many, the cutoff was too short. */
static bool are_few(size_t missing, size_t n)
{
	return missing <= 64 || (double)missing * (double)n < 2e7;
}

static enum ts_status search(struct search *s, double reach)
{
	for (;; reach *= 1.5) {
		size_t missing = 0;

		for (size_t i = 0; i < s->n; i++)
			s->have[i] = 0;
		TS_TRY(ts_pairs_visit(s->box, s->dimensions, s->x, s->n, reach, enter_pair, s));
		for (size_t i = 0; i < s->n; i++)
			missing += (size_t)s->have[i] < s->k;
		if (!are_few(missing, s->n))
			continue;
		for (size_t i = 0; missing && i < s->n; i++)
			if ((size_t)s->have[i] < s->k)
				search_all(s, i);
		return TS_OK;
	}
}

enum ts_status ts_nearest_find(const struct ts_box *box, int dimensions, const double (*x)[3],
			       const int32_t *tag, size_t n, size_t k, double reach, int32_t *row)
{
	struct search s = {
		box, dimensions, x, tag, n, k, ts_alloc(n * k, sizeof *s.d2), row, ts_alloc(n, sizeof *s.have)
	};
	enum ts_status status = s.d2 && s.have ? search(&s, reach) : TS_NOMEM;

	ts_free(s.d2);
	ts_free(s.have);
	return status;
}
