#include "particle/identity.h"

#include <stdlib.h>
#include <string.h>

#include "base/sort.h"

#include "base/banned.h"

/* A table by tag takes 4 bytes for each tag ever assigned; a binary search takes no memory but more time. The
 * table is used up to this ratio of tags to particles, and always below this number of tags. */
enum { LARGEST_RATIO = 16, TABLE_ALWAYS = 1 << 20 };

static int compare_tags(const void *a, const void *b)
{
	const int32_t *p = a, *q = b;

	return (*p > *q) - (*p < *q);
}

/* Fills p->sorted_tags with the pairs of tag and index, sorted by tag; skips the sort if they are in
 * order. */
static void sort_by_tag(struct ts_particles *p, int32_t (*pair)[2])
{
	bool ordered = true;

	for (size_t i = 0; i < p->n; i++) {
		pair[i][0] = p->tag[i];
		pair[i][1] = (int32_t)i;
		ordered &= i == 0 || p->tag[i - 1] < p->tag[i];
	}
	if (!ordered)
		ts_sort(pair, p->n, sizeof *pair, compare_tags);
	for (size_t i = 0; i < p->n; i++) {
		p->sorted_tags[i] = pair[i][0];
		p->sorted_tags[p->n + i] = pair[i][1];
	}
}

static enum ts_status list_by_sorting(struct ts_particles *p)
{
	int32_t(*pair)[2] = ts_alloc(p->n + 1, sizeof *pair);

	if (!pair)
		return TS_NOMEM;
	sort_by_tag(p, pair);
	ts_free(pair);
	return TS_OK;
}

static void list_by_table(struct ts_particles *p)
{
	size_t filled = 0;

	for (int32_t tag = 1; tag <= p->max_tag; tag++)
		if (p->row_of_tag[tag] >= 0) {
			p->sorted_tags[filled] = tag;
			p->sorted_tags[p->n + filled++] = p->row_of_tag[tag];
		}
}

static enum ts_status fill_table(struct ts_particles *p)
{
	size_t size = (size_t)p->max_tag + 1;

	TS_TRY(TS_RENEW_UNSET(p->row_of_tag, p->row_of_tag_capacity, size));
	memset(p->row_of_tag, 0xff, size * sizeof *p->row_of_tag); /* -1 */
	for (size_t i = 0; i < p->n; i++)
		p->row_of_tag[p->tag[i]] = (int32_t)i;
	return TS_OK;
}

enum ts_status ts_identities(struct tsim *sim, bool ordered, struct ts_identities *out)
{
	struct ts_particles *p = sim->particles;
	bool table = p->max_tag < TABLE_ALWAYS || (size_t)p->max_tag / LARGEST_RATIO < p->n;
	enum ts_status status = TS_OK;

	if (table)
		status = fill_table(p);
	if (status == TS_OK && (ordered || !table))
		status = TS_RENEW_UNSET(p->sorted_tags, p->sorted_tags_capacity, 2 * p->n + 1);
	if (status == TS_OK && !table)
		status = list_by_sorting(p);
	else if (status == TS_OK && ordered)
		list_by_table(p);
	*out = (struct ts_identities){ .n = p->n, .max = p->max_tag };
	if (table)
		out->row_of_tag = p->row_of_tag;
	if (status == TS_OK && (ordered || !table)) {
		out->tag = p->sorted_tags;
		out->row = p->sorted_tags + p->n;
	}
	return status == TS_OK ? TS_OK : ts_nomem(&sim->error);
}
