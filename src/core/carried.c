#include "core/carried.h"

#include <string.h>

#include "base/banned.h"

bool ts_carried_leaves(const struct ts_leaving *leaving, int32_t tag)
{
	size_t lo = 0, hi = leaving->n;

	while (lo < hi) {
		size_t middle = lo + (hi - lo) / 2;

		if (leaving->tag[middle] < tag)
			lo = middle + 1;
		else
			hi = middle;
	}
	return lo < leaving->n && leaving->tag[lo] == tag;
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
