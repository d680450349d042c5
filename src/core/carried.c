#include "core/carried.h"

#include <stdlib.h>
#include <string.h>

#include "base/sort.h"

#include "base/banned.h"

void ts_carried_sort(struct ts_leaving *leaving)
{
	ts_sort(leaving->tag, leaving->n, sizeof *leaving->tag, ts_compare_int32);
	for (size_t k = 0; k < leaving->n; k++)
		leaving->some[(uint32_t)leaving->tag[k] / 64 % TS_LEAVING_WORDS] |= (uint64_t)1
										    << (leaving->tag[k] & 63);
}

bool ts_carried_leaves(const struct ts_leaving *leaving, int32_t tag)
{
	return ts_carried_may_leave(leaving, tag) &&
	       bsearch(&tag, leaving->tag, leaving->n, sizeof tag, ts_compare_int32);
}

static size_t stride(const struct ts_carried *rows)
{
	return sizeof(int32_t) + rows->bytes;
}

unsigned char *ts_carried_add(struct ts_carried *out, int32_t tag)
{
	unsigned char *row = ts_parcel_extend(&out->rows, stride(out));

	if (!row)
		return NULL;
	memcpy(row, &tag, sizeof tag);
	return row + sizeof tag;
}

size_t ts_carried_count(const struct ts_carried *rows)
{
	return rows->rows.n / stride(rows);
}

const unsigned char *ts_carried_row(const struct ts_carried *rows, size_t k, int32_t *tag)
{
	const unsigned char *row = rows->rows.data + k * stride(rows);

	memcpy(tag, row, sizeof *tag);
	return row + sizeof *tag;
}
