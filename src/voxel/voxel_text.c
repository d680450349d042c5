#include "voxel/voxel_text.h"

#include <math.h>

#include "io/lines.h"

#include "base/banned.h"

static enum ts_status read_row(struct tsim *sim, struct ts_lines *l, struct ts_voxel_grid *grid)
{
	size_t n = (size_t)grid->n[0] * (size_t)grid->n[1];

	if (!grid->n[1])
		grid->n[0] = (int64_t)l->nwords;
	if ((int64_t)l->nwords != grid->n[0])
		return ts_lines_fail(l, TS_SYNTAX, l->nwords,
				     "%zu heights, but the first row has %lld: all rows have one for each "
				     "column",
				     l->nwords, (long long)grid->n[0]);
	if (TS_GROW(grid->value, grid->capacity, n + l->nwords) != TS_OK)
		return ts_nomem(&sim->error);
	for (size_t k = 0; k < l->nwords; k++) {
		TS_TRY(ts_lines_real(l, k, "a height", &grid->value[n + k]));
		if (!isfinite(grid->value[n + k]))
			return ts_lines_fail(l, TS_RANGE, k, "a height that is not a finite number");
	}
	grid->n[1]++;
	return TS_OK;
}

/* The first row read is the last one of the grid. */
static void reverse_rows(struct ts_voxel_grid *grid)
{
	size_t n = (size_t)grid->n[0], rows = (size_t)grid->n[1];

	for (size_t j = 0; j < rows / 2; j++)
		for (size_t i = 0; i < n; i++) {
			double *a = &grid->value[j * n + i], *b = &grid->value[(rows - 1 - j) * n + i];
			double value = *a;

			*a = *b;
			*b = value;
		}
}

enum ts_status ts_voxel_text_read(struct tsim *sim, const struct ts_place *where, const char *path,
				  struct ts_voxel_grid *grid)
{
	struct ts_lines lines = { 0 };
	enum ts_status status;
	bool more = true;

	TS_TRY(ts_lines_open(&lines, &sim->files, &sim->error, sim->pool, where, path));
	do {
		status = ts_lines_next_filled(&lines, &more);
		if (status == TS_OK && more)
			status = read_row(sim, &lines, grid);
	} while (status == TS_OK && more);
	if (status == TS_OK && !grid->n[1])
		status = ts_fail(&sim->error, TS_SYNTAX, where, "'%s' has no heights", path);
	ts_lines_close(&lines);
	reverse_rows(grid);
	return status;
}
