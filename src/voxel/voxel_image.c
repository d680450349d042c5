#include "voxel/voxel_image.h"

#include <string.h>

#include "voxel/voxel_png.h"

#include "base/banned.h"

/* ---- PGM */

/* Where pixel k of the file, from the top left, stands in the grid. */
static double *pixel(const struct ts_voxel_grid *grid, int64_t k)
{
	return &grid->value[(grid->n[1] - 1 - k / grid->n[0]) * grid->n[0] + k % grid->n[0]];
}

static enum ts_status read_plain(struct ts_scan *s, struct ts_voxel_grid *grid, int64_t most)
{
	for (int64_t k = 0; k < grid->n[0] * grid->n[1]; k++) {
		int64_t value;

		if (k % 65536 == 0)
			TS_TRY(ts_scan_check_stop(s));
		TS_TRY(ts_scan_int(s, "a grey value", 0, most, &value));
		*pixel(grid, k) = (double)value / (double)most;
	}
	return TS_OK;
}

/* One byte for each pixel, or two, the high one first, behind a single blank. */
static enum ts_status read_raw(struct ts_scan *s, struct ts_voxel_grid *grid, int64_t most)
{
	size_t bytes = most > 255 ? 2 : 1, n = (size_t)grid->n[0] * (size_t)grid->n[1];
	const unsigned char *from = (const unsigned char *)s->bytes + s->at + 1;

	if (s->at >= s->n || (s->n - s->at - 1) / bytes < n)
		return ts_scan_refuse(s, TS_DAMAGED,
				      "'%s' ends early: %lld x %lld pixels of %zu bytes need %zu", s->file,
				      (long long)grid->n[0], (long long)grid->n[1], bytes, n * bytes);
	for (size_t k = 0; k < n; k++) {
		int64_t value = bytes == 2 ? 256 * from[2 * k] + from[2 * k + 1] : from[k];

		if (value > most)
			return ts_scan_refuse(s, TS_DAMAGED,
					      "'%s': pixel %zu is %lld, but the largest is %lld", s->file,
					      k + 1, (long long)value, (long long)most);
		*pixel(grid, (int64_t)k) = (double)value / (double)most;
	}
	return TS_OK;
}

static enum ts_status read_pgm(struct ts_scan *s, struct ts_voxel_grid *grid)
{
	bool plain = s->bytes[1] == '2';
	int64_t nx, ny, most;
	enum ts_status status;

	s->comments = true;
	ts_scan_word(s);
	TS_TRY(ts_scan_int(s, "the width of the image", 1, TS_VOXEL_MOST_COLUMNS, &nx));
	TS_TRY(ts_scan_int(s, "the height of the image", 1, TS_VOXEL_MOST_COLUMNS, &ny));
	TS_TRY(ts_scan_int(s, "the largest grey value", 1, 65535, &most));
	/* a pixel has one byte at least: so a wrong header cannot demand much memory */
	if (nx > (int64_t)s->n / ny)
		return ts_scan_refuse(s, TS_DAMAGED, "'%s' ends early: %zu bytes for %lld x %lld pixels",
				      s->file, s->n, (long long)nx, (long long)ny);
	status = ts_voxel_grid_resize(grid, nx, ny);
	if (status != TS_OK)
		return status == TS_NOMEM ? ts_nomem(s->err)
					  : ts_scan_refuse(s, TS_RANGE, "'%s' has too many pixels", s->file);
	return plain ? read_plain(s, grid, most) : read_raw(s, grid, most);
}

/* ---- all images */

static bool starts_with(const struct ts_scan *s, const char *magic)
{
	size_t n = strlen(magic);

	return s->n > n && memcmp(s->bytes, magic, n) == 0;
}

static enum ts_status read_image(struct ts_scan *s, struct ts_voxel_grid *grid)
{
	if (starts_with(s, "\x89PNG\r\n\x1a\n"))
		return ts_voxel_png_read(s, grid);
	if (starts_with(s, "P2") || starts_with(s, "P5"))
		return read_pgm(s, grid);
	if (starts_with(s, "P1") || starts_with(s, "P3") || starts_with(s, "P4") || starts_with(s, "P6"))
		return ts_scan_refuse(s, TS_SYNTAX,
				      "'%s' is a %s image (P%c); expected a grey one, P2 or P5; `pnmtopng`, "
				      "`ppmtopgm` or ImageMagick's `convert` make one",
				      s->file, s->bytes[1] == '1' || s->bytes[1] == '4' ? "bitmap" : "colour",
				      s->bytes[1]);
	return ts_scan_refuse(s, TS_SYNTAX, "'%s' is no image that can be read: expected PGM (P2, P5) or PNG",
			      s->file);
}

enum ts_status ts_voxel_image_read(struct tsim *sim, const struct ts_place *where, const char *path,
				   struct ts_voxel_grid *grid)
{
	struct ts_scan scan = { 0 };
	enum ts_status status = ts_scan_open(&scan, &sim->files, &sim->error, sim->pool, where, path);

	if (status == TS_OK)
		status = read_image(&scan, grid);
	ts_scan_close(&scan);
	return status;
}
