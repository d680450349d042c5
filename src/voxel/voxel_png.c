#include "voxel/voxel_png.h"

#ifdef TS_WITH_PNG
#include <png.h>
#include <setjmp.h>
#include <string.h>

#include "base/banned.h"

/* Bytes of the file, and the grid. Memory is kept here, as libpng's errors jump. */
struct reader {
	struct ts_scan *scan;
	struct ts_voxel_grid *grid;
	png_structp png;
	png_infop info;
	png_bytep *row; /* [height], in `pixels` */
	png_bytep pixels;
	char message[120];
};

static void fail(png_structp png, png_const_charp text)
{
	struct reader *r = png_get_error_ptr(png);

	snprintf(r->message, sizeof r->message, "%s", text);
	longjmp(png_jmpbuf(png), 1);
}

static void ignore(png_structp png, png_const_charp text)
{
	(void)png;
	(void)text;
}

static void take_bytes(png_structp png, png_bytep to, png_size_t n)
{
	struct reader *r = png_get_io_ptr(png);

	if (n > r->scan->n - r->scan->at)
		png_error(png, "the file ends early");
	memcpy(to, r->scan->bytes + r->scan->at, n);
	r->scan->at += n;
}

/* Grey images of 1 to 16 bits, with or without alpha, which is dropped. */
static enum ts_status read_header(struct reader *r)
{
	struct ts_scan *s = r->scan;
	png_uint_32 nx, ny;
	int type;

	png_read_info(r->png, r->info);
	nx = png_get_image_width(r->png, r->info);
	ny = png_get_image_height(r->png, r->info);
	type = png_get_color_type(r->png, r->info);
	if (type != PNG_COLOR_TYPE_GRAY && type != PNG_COLOR_TYPE_GRAY_ALPHA)
		return ts_scan_refuse(s, TS_SYNTAX, "'%s' is a colour image; expected a grey one", s->file);
	/* deflate packs at most 1032 bytes into one: so a wrong header cannot demand much memory */
	if ((double)nx * ny * png_get_bit_depth(r->png, r->info) / 8 > 1100.0 * (double)s->n)
		return ts_scan_refuse(s, TS_DAMAGED, "'%s' ends early: %zu bytes for %u x %u pixels", s->file,
				      s->n, (unsigned)nx, (unsigned)ny);
	if (png_get_bit_depth(r->png, r->info) < 8)
		png_set_expand_gray_1_2_4_to_8(r->png);
	png_set_strip_alpha(r->png);
	png_set_interlace_handling(r->png);
	png_read_update_info(r->png, r->info);
	switch (ts_voxel_grid_resize(r->grid, nx, ny)) {
	case TS_OK:
		return TS_OK;
	case TS_RANGE:
		return ts_scan_refuse(s, TS_RANGE, "'%s' has too many pixels", s->file);
	default:
		return ts_nomem(s->err);
	}
}

static enum ts_status read_pixels(struct reader *r)
{
	size_t ny = (size_t)r->grid->n[1], nx = (size_t)r->grid->n[0];
	size_t bytes = png_get_rowbytes(r->png, r->info);
	bool wide = png_get_bit_depth(r->png, r->info) == 16;

	r->row = ts_alloc(ny, sizeof *r->row);
	r->pixels = ts_alloc(ny, bytes);
	if (!r->row || !r->pixels)
		return ts_nomem(r->scan->err);
	for (size_t j = 0; j < ny; j++)
		r->row[j] = r->pixels + j * bytes;
	png_read_image(r->png, r->row);
	for (size_t j = 0; j < ny; j++)
		for (size_t i = 0; i < nx; i++) {
			const png_byte *at = r->row[ny - 1 - j] + (wide ? 2 * i : i);

			r->grid->value[j * nx + i] = wide ? (256 * at[0] + at[1]) / 65535.0 : at[0] / 255.0;
		}
	return TS_OK;
}

static enum ts_status read_all(struct reader *r)
{
	r->png = png_create_read_struct(PNG_LIBPNG_VER_STRING, r, fail, ignore);
	r->info = r->png ? png_create_info_struct(r->png) : NULL;
	if (!r->info)
		return ts_nomem(r->scan->err);
	if (setjmp(png_jmpbuf(r->png)))
		return ts_scan_refuse(r->scan, TS_DAMAGED, "'%s' is damaged: %s", r->scan->file, r->message);
	png_set_read_fn(r->png, r, take_bytes);
	TS_TRY(read_header(r));
	return read_pixels(r);
}

enum ts_status ts_voxel_png_read(struct ts_scan *scan, struct ts_voxel_grid *grid)
{
	struct reader r = { .scan = scan, .grid = grid };
	enum ts_status status = read_all(&r);

	png_destroy_read_struct(&r.png, &r.info, NULL);
	ts_free(r.row);
	ts_free(r.pixels);
	return status;
}
#else
#include "base/banned.h"

enum ts_status ts_voxel_png_read(struct ts_scan *scan, struct ts_voxel_grid *grid)
{
	(void)grid;
	return ts_scan_refuse(scan, TS_STATE,
			      "'%s' is a PNG image, and this tsim was built without libpng (apt-get install "
			      "libpng-dev, then ./configure); PGM images need no library",
			      scan->file);
}
#endif
