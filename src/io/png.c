#include "io/png.h"

#include <string.h>
#include <zlib.h>

#include "base/alloc.h"
#include "io/replace.h"

#include "base/banned.h"

static void big_endian(uint32_t value, unsigned char out[4])
{
	for (int k = 0; k < 4; k++)
		out[k] = (unsigned char)(value >> (24 - 8 * k));
}

static enum ts_status write_chunk(struct ts_replace *file, const char *type, const unsigned char *data,
				  uint32_t n)
{
	unsigned char head[8], sum[4];
	uLong crc = crc32(0, NULL, 0);

	big_endian(n, head);
	memcpy(head + 4, type, 4);
	crc = crc32(crc, head + 4, 4);
	if (n) /* without data crc32_z begins anew */
		crc = crc32_z(crc, data, n);
	big_endian((uint32_t)crc, sum);
	TS_TRY(ts_replace_write(file, head, sizeof head));
	if (n)
		TS_TRY(ts_replace_write(file, data, n));
	return ts_replace_write(file, sum, sizeof sum);
}

/* Rows with the byte 0 before them, "no filter", compressed. */
static enum ts_status pack(struct tsim *sim, uint32_t width, uint32_t height, const unsigned char *rgb,
			   unsigned char **packed, uLong *n)
{
	const size_t row = 3 * (size_t)width;
	unsigned char *plain = ts_alloc(height, row + 1);
	int code;

	*n = compressBound((uLong)(height * (row + 1)));
	*packed = ts_alloc(*n, 1);
	if (!plain || !*packed) {
		ts_free(plain);
		return ts_nomem(&sim->error);
	}
	for (size_t y = 0; y < height; y++)
		memcpy(plain + y * (row + 1) + 1, rgb + y * row, row);
	code = compress2(*packed, n, plain, (uLong)(height * (row + 1)), 6);
	ts_free(plain);
	return code == Z_OK ? TS_OK : ts_nomem(&sim->error);
}

static enum ts_status write_chunks(struct ts_replace *file, uint32_t width, uint32_t height,
				   const unsigned char *packed, uLong n)
{
	static const unsigned char signature[8] = { 137, 'P', 'N', 'G', 13, 10, 26, 10 };
	/* 8 bits, true colour, deflate, adaptive filters, not interlaced */
	unsigned char head[13] = { [8] = 8, [9] = 2 };

	big_endian(width, head);
	big_endian(height, head + 4);
	TS_TRY(ts_replace_write(file, signature, sizeof signature));
	TS_TRY(write_chunk(file, "IHDR", head, sizeof head));
	TS_TRY(write_chunk(file, "IDAT", packed, (uint32_t)n));
	TS_TRY(write_chunk(file, "IEND", NULL, 0));
	return ts_replace_commit(file, false);
}

enum ts_status ts_png_write(struct tsim *sim, const char *path, const struct ts_place *where, uint32_t width,
			    uint32_t height, const unsigned char *rgb)
{
	struct ts_replace file = { 0 };
	unsigned char *packed = NULL;
	uLong n = 0;
	enum ts_status status = pack(sim, width, height, rgb, &packed, &n);

	if (status == TS_OK)
		status = ts_replace_begin(&file, sim, where, path);
	if (status == TS_OK)
		status = write_chunks(&file, width, height, packed, n);
	ts_replace_abandon(&file);
	ts_free(packed);
	return status;
}
