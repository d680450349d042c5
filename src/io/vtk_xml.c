#include "io/vtk_xml.h"

#include <string.h>
#include <zlib.h>

#include "core/block_work.h"
#include "core/ranks.h"

#include "base/banned.h"

void ts_vtk_add_base64(struct ts_str *out, const unsigned char *bytes, size_t n)
{
	static const char digit[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
	char line[4 * 256];
	size_t used = 0;

	for (size_t i = 0; i < n; i += 3) {
		unsigned a = bytes[i], b = i + 1 < n ? bytes[i + 1] : 0, c = i + 2 < n ? bytes[i + 2] : 0;

		line[used++] = digit[a >> 2];
		line[used++] = digit[(a & 3) << 4 | b >> 4];
		line[used++] = i + 1 < n ? digit[(b & 15) << 2 | c >> 6] : '=';
		line[used++] = i + 2 < n ? digit[c & 63] : '=';
		if (used == sizeof line || i + 3 >= n) {
			ts_str_add_n(out, line, used);
			used = 0;
		}
	}
}

enum { BLOCK = 1 << 20, SENT = 8 };

static void compress_block(const void *context, const void *block, size_t n, struct ts_str *out)
{
	uLongf length = compressBound((uLong)n);
	unsigned char *packed = ts_alloc(length, 1);

	(void)context;
	if (packed && compress2(packed, &length, block, (uLong)n, Z_BEST_SPEED) == Z_OK)
		ts_str_add_n(out, (const char *)packed, length);
	else
		out->failed = true;
	ts_free(packed);
}

enum ts_status ts_vtk_add_packed(struct tsim *sim, struct ts_str *out, const void *data, size_t n)
{
	const struct ts_block_work work = { compress_block, NULL, BLOCK, SENT };
	const size_t blocks = ts_block_work_blocks(&work, n);
	uint64_t *head = ts_alloc(3 + blocks, sizeof *head);
	struct ts_str packed = { 0 };
	enum ts_status status =
		head ? ts_block_work(sim, &work, data, n, &packed, head + 3) : ts_nomem(&sim->error);

	if (status == TS_OK && ts_ranks_first(sim)) {
		head[0] = blocks;
		head[1] = BLOCK;
		head[2] = n % BLOCK;
		ts_vtk_add_base64(out, (const unsigned char *)head, (3 + blocks) * sizeof *head);
		ts_vtk_add_base64(out, (const unsigned char *)ts_str_text(&packed), packed.length);
	}
	ts_free(head);
	ts_str_release(&packed);
	return status == TS_OK && out->failed ? ts_nomem(&sim->error) : status;
}

void ts_vtk_add_name(struct ts_str *out, const char *name)
{
	for (; *name; name++)
		ts_str_add_n(out, strchr("<>&\"'\\", *name) ? "_" : name, 1);
}

enum ts_status ts_vtk_add_array(struct tsim *sim, struct ts_str *out, const char *name, const char *type,
				size_t components, const void *data, size_t n)
{
	ts_str_addf(out, "<DataArray type=\"%s\" Name=\"", type);
	ts_vtk_add_name(out, name);
	ts_str_addf(out, "\" NumberOfComponents=\"%zu\" format=\"binary\">\n", components);
	TS_TRY(ts_vtk_add_packed(sim, out, data, n * components * 8));
	ts_str_add(out, "\n</DataArray>\n");
	return TS_OK;
}

static enum ts_status add_integers(struct tsim *sim, struct ts_str *out, const struct ts_vtk_array *array,
				   size_t n)
{
	int64_t *whole = ts_alloc(n * array->components, sizeof *whole);
	enum ts_status status;

	if (!whole)
		return ts_nomem(&sim->error);
	for (size_t k = 0; k < n * array->components; k++)
		whole[k] = (int64_t)array->data[k];
	status = ts_vtk_add_array(sim, out, array->name, "Int64", array->components, whole, n);
	ts_free(whole);
	return status;
}

enum ts_status ts_vtk_add_data(struct tsim *sim, struct ts_str *out, const char *element,
			       const struct ts_vtk_array *array, size_t narrays, size_t n)
{
	ts_str_addf(out, "<%s>\n", element);
	for (size_t k = 0; k < narrays; k++)
		if (array[k].integer)
			TS_TRY(add_integers(sim, out, &array[k], n));
		else
			TS_TRY(ts_vtk_add_array(sim, out, array[k].name, "Float64", array[k].components,
						array[k].data, n));
	ts_str_addf(out, "</%s>\n", element);
	return TS_OK;
}

void ts_vtk_add_opening(struct ts_str *out, const char *type)
{
	const uint16_t one = 1;

	ts_str_addf(out,
		    "<?xml version=\"1.0\"?>\n<VTKFile type=\"%s\" version=\"1.0\" byte_order=\"%s\" "
		    "header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">\n",
		    type, *(const unsigned char *)&one ? "LittleEndian" : "BigEndian");
}

void ts_vtk_add_time(struct ts_str *out, double time)
{
	ts_str_add(out, "<FieldData>\n<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" "
			"format=\"ascii\">\n");
	ts_str_addf(out, "%.17g\n</DataArray>\n</FieldData>\n", time);
}
