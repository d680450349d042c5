#include "voxel/voxel_field.h"

#include "base/alloc.h"

#include "base/banned.h"

enum { EDGE = 1 << TS_VOXEL_SHIFT };

static size_t blocks_of(const struct ts_voxel_level *level)
{
	return (size_t)level->n[0] * (size_t)level->n[1];
}

enum ts_status ts_voxel_field_make(struct ts_voxel_field *f)
{
	int64_t n[2] = { f->n[0], f->n[1] };

	for (f->nlevels = 0; f->nlevels < TS_VOXEL_LEVELS;) {
		struct ts_voxel_level *level = &f->level[f->nlevels];

		level->n[0] = n[0];
		level->n[1] = n[1];
		level->top = ts_alloc(blocks_of(level), sizeof *level->top);
		if (!level->top) {
			ts_voxel_field_release(f);
			return TS_NOMEM;
		}
		f->nlevels++;
		if (n[0] == 1 && n[1] == 1)
			break;
		for (int d = 0; d < 2; d++)
			n[d] = (n[d] + EDGE - 1) / EDGE;
	}
	return TS_OK;
}

void ts_voxel_field_release(struct ts_voxel_field *f)
{
	for (int l = 0; l < f->nlevels; l++) {
		ts_free(f->level[l].top);
		f->level[l].top = NULL;
	}
	f->nlevels = 0;
}

/* The maximum over the children of block bi, bj of level l > 0. */
static double block_top(const struct ts_voxel_field *f, int l, int64_t bi, int64_t bj)
{
	const struct ts_voxel_level *below = &f->level[l - 1];
	double most = -INFINITY;

	for (int64_t j = EDGE * bj; j < EDGE * (bj + 1) && j < below->n[1]; j++)
		for (int64_t i = EDGE * bi; i < EDGE * (bi + 1) && i < below->n[0]; i++)
			most = fmax(most, below->top[j * below->n[0] + i]);
	return most;
}

void ts_voxel_field_update(struct ts_voxel_field *f)
{
	for (int l = 1; l < f->nlevels; l++) {
		struct ts_voxel_level *level = &f->level[l];

		for (int64_t j = 0; j < level->n[1]; j++)
			for (int64_t i = 0; i < level->n[0]; i++)
				level->top[j * level->n[0] + i] = block_top(f, l, i, j);
	}
}

void ts_voxel_set_height(struct ts_voxel_field *f, int64_t i, int64_t j, double height)
{
	f->level[0].top[j * f->n[0] + i] = height;
	for (int l = 1; l < f->nlevels; l++) {
		struct ts_voxel_level *level = &f->level[l];
		double *top, now;

		i /= EDGE;
		j /= EDGE;
		top = &level->top[j * level->n[0] + i];
		now = block_top(f, l, i, j);
		if (now >= *top && now <= *top) /* the blocks above have the same maximum, too */
			return;
		*top = now;
	}
}

void ts_voxel_field_bounds(const struct ts_voxel_field *f, double *least, double *most)
{
	const double *height = ts_voxel_heights(f);

	*least = INFINITY;
	*most = -INFINITY;
	for (size_t k = 0; k < blocks_of(&f->level[0]); k++) {
		if (!(height[k] > f->base))
			continue;
		*least = fmin(*least, height[k]);
		*most = fmax(*most, height[k]);
	}
}

int64_t ts_voxel_index(const struct ts_voxel_field *f, int d, double x)
{
	/* indices farther away are those of columns that do not exist, or lost by rounding */
	static const double far = 9e15;
	double at = floor((x - f->origin[d]) / f->width[d]);
	int64_t i;

	if (!(fabs(at) < far))
		return (int64_t)(at > 0 ? far : -far);
	i = (int64_t)at;
	/* rounding of the quotient: the borders decide */
	while (ts_voxel_border(f, d, i) > x)
		i--;
	while (ts_voxel_border(f, d, i + 1) <= x)
		i++;
	return i;
}
