/* Height fields of a picture: the tops of the columns, and their sides down to lower neighbours. Of a field with more
 * columns than a picture can show, blocks of 4 x 4, 16 x 16 ... columns are drawn with the height of their highest. */
#include "image/image_surfaces.h"
#include "voxel/voxel_surface.h"

#include "base/banned.h"

enum { MOST_BLOCKS = 1 << 18 };

static enum ts_status require(struct tsim *sim, const struct ts_word *id)
{
	struct ts_voxel_surface *surface;

	return ts_voxel_surface_require(sim, id, &surface);
}

static const struct ts_instance *next(const struct tsim *sim, size_t *k)
{
	struct ts_instance *by = NULL;

	return ts_voxel_surface_next(sim, k, &by) ? by : NULL;
}

static size_t elements(const struct ts_instance *by)
{
	const struct ts_voxel_field *f = &((const struct ts_voxel_surface *)by->state)->field;

	return (size_t)(f->n[0] * f->n[1]);
}

static bool value(const struct ts_instance *by, const char *name, double *out)
{
	const struct ts_voxel_surface *s = by->state;

	if (!ts_streq(name, "height"))
		return false;
	for (size_t k = 0; k < elements(by); k++)
		out[k] = ts_voxel_heights(&s->field)[k] + s->shift[s->field.axis[2]];
	return true;
}

/* Blocks of one level. */
struct blocks {
	const struct ts_voxel_surface *s;
	const struct ts_voxel_level *level;
	int64_t edge; /* columns along the edge of a block */
};

static double top(const struct blocks *b, int64_t i, int64_t j)
{
	const struct ts_voxel_field *f = &b->s->field;
	double height = -INFINITY;

	if (i >= 0 && j >= 0 && i < b->level->n[0] && j < b->level->n[1])
		height = b->level->top[j * b->level->n[0] + i];
	return height > f->base ? height : f->base;
}

/* A corner in the coordinates of the simulation, from numbers of blocks and a height. */
static void corner(const struct blocks *b, int64_t i, int64_t j, double height, double out[3])
{
	const struct ts_voxel_field *f = &b->s->field;
	const int64_t column[2] = { i * b->edge < f->n[0] ? i * b->edge : f->n[0],
				    j * b->edge < f->n[1] ? j * b->edge : f->n[1] };

	for (int d = 0; d < 2; d++)
		out[f->axis[d]] = ts_voxel_border(f, d, column[d]) + b->s->shift[f->axis[d]];
	out[f->axis[2]] = height + b->s->shift[f->axis[2]];
}

/* The side towards the neighbour (di, dj), if that is lower. */
static enum ts_status add_side(const struct blocks *b, int64_t i, int64_t j, int di, int dj,
			       struct ts_scene *scene, const struct ts_image_surface *s,
			       struct ts_colour colour)
{
	const int64_t at[2][2] = { { i + (di > 0), j + (dj > 0) }, { i + (di >= 0), j + (dj >= 0) } };
	const double high = top(b, i, j), low = top(b, i + di, j + dj);
	double c[4][3];

	if (!(low < high) || isinf(low))
		return TS_OK;
	for (int k = 0; k < 2; k++) {
		corner(b, at[k][0], at[k][1], high, c[k]);
		corner(b, at[1 - k][0], at[1 - k][1], low, c[2 + k]);
	}
	return ts_scene_add_quadrangle(scene, (const double(*)[3])c, colour, s->opacity);
}

static enum ts_status add_block(const struct blocks *b, int64_t i, int64_t j, struct ts_scene *scene,
				const struct ts_image_surface *s)
{
	static const int side[4][2] = { { 1, 0 }, { -1, 0 }, { 0, 1 }, { 0, -1 } };
	const struct ts_colour colour =
		ts_image_element_colour(s, (size_t)(j * b->edge * b->s->field.n[0] + i * b->edge));
	const double height = top(b, i, j);
	double c[4][3];

	if (!(height > b->s->field.base))
		return TS_OK;
	for (int k = 0; k < 4; k++)
		corner(b, i + (k == 1 || k == 2), j + (k >= 2), height, c[k]);
	TS_TRY(ts_scene_add_quadrangle(scene, (const double(*)[3])c, colour, s->opacity));
	for (int k = 0; k < 4; k++)
		TS_TRY(add_side(b, i, j, side[k][0], side[k][1], scene, s, colour));
	return TS_OK;
}

static enum ts_status add(struct tsim *sim, const struct ts_instance *by, struct ts_scene *scene,
			  const struct ts_image_surface *s)
{
	struct blocks b = { .s = by->state, .edge = 1 };
	const struct ts_voxel_field *f = &b.s->field;
	int level = 0;

	(void)sim;
	while (level + 1 < f->nlevels && f->level[level].n[0] * f->level[level].n[1] > MOST_BLOCKS)
		level++;
	b.level = &f->level[level];
	b.edge = (int64_t)1 << (TS_VOXEL_SHIFT * level);
	for (int64_t j = 0; j < b.level->n[1]; j++)
		for (int64_t i = 0; i < b.level->n[0]; i++)
			TS_TRY(add_block(&b, i, j, scene, s));
	return TS_OK;
}

const struct ts_image_sort ts_image_voxel = {
	.name = "voxel",
	.colour = 0xd2b48c, /* tan */
	.opacity = 1,
	.require = require,
	.next = next,
	.elements = elements,
	.value = value,
	.add = add,
};
