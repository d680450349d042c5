#include "io/png.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <zlib.h>

#include "base/alloc.h"
#include "base/clones.h"
#include "base/inline.h"
#include "io/replace.h"

#include "base/banned.h"

static void big_endian(uint32_t value, unsigned char out[4])
{
	for (int k = 0; k < 4; k++)
		out[k] = (unsigned char)(value >> (24 - 8 * k));
}

static void add_chunk(struct ts_str *out, const char *type, const unsigned char *data, uint32_t n)
{
	unsigned char head[8], sum[4];
	uLong crc = crc32(0, NULL, 0);

	big_endian(n, head);
	memcpy(head + 4, type, 4);
	crc = crc32(crc, head + 4, 4);
	if (n) /* without data crc32_z begins anew */
		crc = crc32_z(crc, data, n);
	big_endian((uint32_t)crc, sum);
	ts_str_add_n(out, (const char *)head, sizeof head);
	if (n)
		ts_str_add_n(out, (const char *)data, n);
	ts_str_add_n(out, (const char *)sum, sizeof sum);
}

/* ---- filters: a byte is predicted from that of the pixel to the left (a), above (b), left and above (c); only the
 * difference is stored (ISO/IEC 15948, 9.2) */

enum { NONE, LEFT, UP, PAETH = 4 };

TS_INLINE int predict(int filter, int a, int b, int c)
{
	const int p = a + b - c, to_a = abs(p - a), to_b = abs(p - b), to_c = abs(p - c);

	if (filter == LEFT)
		return a;
	if (filter == UP)
		return b;
	if (filter != PAETH)
		return 0;
	return to_a <= to_b && to_a <= to_c ? a : to_b <= to_c ? b : c;
}

TS_INLINE unsigned weight(unsigned char difference)
{
	return difference < 128 ? difference : 256u - difference;
}

/* With a constant filter the loop is vectorized. */
TS_INLINE unsigned long filter_by(int filter, const unsigned char *restrict row,
				  const unsigned char *restrict above, size_t n, unsigned char *restrict out)
{
	unsigned long sum = 0;

	for (size_t k = 0; k < 3 && k < n; k++) {
		out[k] = (unsigned char)(row[k] - predict(filter, 0, above[k], 0));
		sum += weight(out[k]);
	}
	for (size_t from = 3; from < n; from += 4096) { /* sums of parts fit 32 bits */
		const size_t to = from + 4096 < n ? from + 4096 : n;
		unsigned part = 0;

		for (size_t k = from; k < to; k++) {
			out[k] =
				(unsigned char)(row[k] - predict(filter, row[k - 3], above[k], above[k - 3]));
			part += weight(out[k]);
		}
		sum += part;
	}
	return sum;
}

/* Returns the sum of the differences as signed bytes: the least one compresses best, as a rule. */
TS_CLONES static unsigned long filter_row(int filter, const unsigned char *row, const unsigned char *above,
					  size_t n, unsigned char *out)
{
	return filter == LEFT	? filter_by(LEFT, row, above, n, out)
	       : filter == UP	? filter_by(UP, row, above, n, out)
	       : filter == NONE ? filter_by(NONE, row, above, n, out)
				: filter_by(PAETH, row, above, n, out);
}

/* The best filter of a row, its number first; `spare`: memory for a row. */
static void choose_filter(const unsigned char *row, const unsigned char *above, size_t n,
			  unsigned char *spare, unsigned char *out)
{
	static const int filters[] = { NONE, LEFT, UP, PAETH };
	unsigned long least = ULONG_MAX;

	for (size_t k = 0; k < sizeof filters / sizeof *filters; k++) {
		const unsigned long sum = filter_row(filters[k], row, above, n, spare);

		if (sum >= least)
			continue;
		least = sum;
		out[0] = (unsigned char)filters[k];
		memcpy(out + 1, spare, n);
	}
}

/* Of zlib: 6 takes three times as long for files that are 3 to 8 % smaller. */
enum { LEVEL = 4 };

/* Rows after their filters, compressed. */
static enum ts_status pack(uint32_t width, uint32_t height, const unsigned char *rgb, unsigned char **packed,
			   uLong *n)
{
	const size_t row = 3 * (size_t)width;
	unsigned char *plain =
		ts_alloc(height + 2, row + 1); /* a row to try filters, and the one above the first, of 0 */
	unsigned char *spare = plain ? plain + height * (row + 1) : NULL,
		      *zero = spare ? spare + row + 1 : NULL;
	int code;

	*n = compressBound((uLong)(height * (row + 1)));
	*packed = ts_alloc(*n, 1);
	if (!plain || !*packed) {
		ts_free(plain);
		return TS_NOMEM;
	}
	memset(zero, 0, row);
	for (size_t y = 0; y < height; y++)
		choose_filter(rgb + y * row, y ? rgb + (y - 1) * row : zero, row, spare,
			      plain + y * (row + 1));
	code = compress2(*packed, n, plain, (uLong)(height * (row + 1)), LEVEL);
	ts_free(plain);
	return code == Z_OK ? TS_OK : TS_NOMEM;
}

enum ts_status ts_png_encode(uint32_t width, uint32_t height, const unsigned char *rgb, struct ts_str *out)
{
	static const unsigned char signature[8] = { 137, 'P', 'N', 'G', 13, 10, 26, 10 };
	/* 8 bits, true colour, deflate, adaptive filters, not interlaced */
	unsigned char head[13] = { [8] = 8, [9] = 2 }, *packed = NULL;
	uLong n = 0;
	const enum ts_status status = pack(width, height, rgb, &packed, &n);

	big_endian(width, head);
	big_endian(height, head + 4);
	ts_str_add_n(out, (const char *)signature, sizeof signature);
	add_chunk(out, "IHDR", head, sizeof head);
	if (status == TS_OK)
		add_chunk(out, "IDAT", packed, (uint32_t)n);
	add_chunk(out, "IEND", NULL, 0);
	ts_free(packed);
	return out->failed ? TS_NOMEM : status;
}

enum ts_status ts_png_write(struct tsim *sim, const char *path, const struct ts_place *where, uint32_t width,
			    uint32_t height, const unsigned char *rgb)
{
	struct ts_replace file = { 0 };
	struct ts_str png = { 0 };
	enum ts_status status =
		ts_png_encode(width, height, rgb, &png) == TS_OK ? TS_OK : ts_nomem(&sim->error);

	if (status == TS_OK)
		status = ts_replace_begin(&file, sim, where, path);
	if (status == TS_OK)
		status = ts_replace_write(&file, png.text, png.length);
	if (status == TS_OK)
		status = ts_replace_commit(&file, false);
	ts_replace_abandon(&file);
	ts_str_release(&png);
	return status;
}
