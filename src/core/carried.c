#include "core/carried.h"

#include <stdlib.h>
#include <string.h>

#include "base/sort.h"

#include "base/banned.h"

static size_t word_of(int32_t tag)
{
	return (size_t)tag / 64 % TS_LEAVING_WORDS;
}

static uint64_t bit_of(int32_t tag)
{
	return (uint64_t)1 << (tag & 63);
}

void ts_carried_sort(struct ts_leaving *leaving)
{
	ts_sort(leaving->tag, leaving->n, sizeof *leaving->tag, ts_compare_int32);
	for (size_t k = 0; k < leaving->n; k++)
		leaving->some[word_of(leaving->tag[k])] |= bit_of(leaving->tag[k]);
}

bool ts_carried_leaves(const struct ts_leaving *leaving, int32_t tag)
{
	return leaving->some[word_of(tag)] & bit_of(tag) &&
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
