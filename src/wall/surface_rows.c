#include "wall/surface_rows.h"

#include <inttypes.h>

#include "core/archive.h"

#include "base/banned.h"

enum ts_status ts_surface_rows_init(struct tsim *sim, struct ts_surface_rows *rows,
				    const struct ts_surface *surface, size_t width,
				    const struct ts_place *place)
{
	size_t elements = ts_surface_elements(surface);

	if (rows->n && elements != rows->elements)
		return ts_fail(&sim->error, TS_STATE, place,
			       "surface '%s' has %zu elements, but had %zu when its contacts were summed",
			       surface->by->id, elements, rows->elements);
	if (TS_GROW(rows->row, rows->row_capacity, elements) != TS_OK)
		return ts_nomem(&sim->error);
	rows->elements = elements;
	rows->width = width;
	return TS_OK;
}

enum ts_status ts_surface_rows_at(struct tsim *sim, struct ts_surface_rows *rows, size_t element,
				  double **out)
{
	if (!rows->row[element]) {
		if (TS_GROW(rows->touched, rows->touched_capacity, rows->n + 1) != TS_OK ||
		    TS_GROW(rows->data, rows->data_capacity, (rows->n + 1) * rows->width) != TS_OK)
			return ts_nomem(&sim->error);
		for (size_t c = 0; c < rows->width; c++)
			rows->data[rows->n * rows->width + c] = 0;
		rows->touched[rows->n++] = (int32_t)element;
		rows->row[element] = (int32_t)rows->n;
	}
	*out = rows->data + (size_t)(rows->row[element] - 1) * rows->width;
	return TS_OK;
}

/* After reading: finds the rows of elements; fails if the file does not fit. */
static enum ts_status restore(struct tsim *sim, struct ts_surface_rows *rows, size_t numbers)
{
	bool fits = numbers == rows->n * rows->width;

	for (size_t k = 0; fits && k < rows->n; k++) {
		int32_t element = rows->touched[k];

		fits = element >= 0 && (size_t)element < rows->elements && !rows->row[element];
		if (fits)
			rows->row[element] = (int32_t)k + 1;
	}
	return fits ? TS_OK
		    : ts_fail(&sim->error, TS_DAMAGED, NULL,
			      "saved sums over contacts do not fit a surface of %zu elements",
			      rows->elements);
}

enum ts_status ts_surface_rows_archive(struct tsim *sim, struct ts_surface_rows *rows,
				       struct ts_archive *archive)
{
	size_t numbers = rows->n * rows->width;

	TS_TRY(ts_archive_array(archive, "touched", TS_SAVED_I32, (void **)&rows->touched,
				&rows->touched_capacity, &rows->n));
	TS_TRY(ts_archive_array(archive, "sums", TS_SAVED_F64, (void **)&rows->data, &rows->data_capacity,
				&numbers));
	return ts_archive_writing(archive) ? TS_OK : restore(sim, rows, numbers);
}

void ts_surface_rows_release(struct ts_surface_rows *rows)
{
	ts_free(rows->row);
	ts_free(rows->touched);
	ts_free(rows->data);
}
