#include "flow/near_exchange.h"

#include "base/banned.h"

/* ---- what one rank sends to another one */

/* The points of a box that are in one of the groups: in all combinations of their spans along the axes. */
struct shipment {
	struct ts_cell_box from;
	int groups;
	struct ts_cell_spans to[2][3];
};

/* The box of a combination of spans; false: there are no more. */
static bool box_of_spans(const struct ts_cell_spans of[3], int index, struct ts_cell_box *box)
{
	if (index >= of[0].n * of[1].n * of[2].n)
		return false;
	for (int d = 0; d < 3; index /= of[d++].n) {
		box->from[d] = of[d].of[index % of[d].n].from;
		box->to[d] = of[d].of[index % of[d].n].to;
	}
	return true;
}

/* The next box of the shipment that is not empty; *group, *index: 0 at first. False: there are no more. */
static bool next_box(const struct shipment *s, int *group, int *index, struct ts_cell_box *box)
{
	struct ts_cell_box there;

	for (; *group < s->groups; ++*group, *index = 0)
		while (box_of_spans(s->to[*group], (*index)++, &there)) {
			*box = ts_cell_box_common(&s->from, &there);
			if (ts_cell_box_size(box))
				return true;
		}
	return false;
}

static size_t shipment_size(const struct shipment *s)
{
	struct ts_cell_box box;
	int group = 0, index = 0;
	size_t size = 0;

	while (next_box(s, &group, &index, &box))
		size += ts_cell_box_size(&box);
	return size;
}

static void copy_shipment(const struct ts_grid *grid, const struct shipment *s, double *const *field,
			  size_t n, struct ts_parcel *parcel, bool out)
{
	double *at = (double *)(void *)parcel->data;

	for (size_t f = 0; f < n; f++) {
		struct ts_cell_box box;
		int group = 0, index = 0;

		while (next_box(s, &group, &index, &box)) {
			if (out)
				ts_cell_box_pack(grid, &box, field[f], at);
			else
				ts_cell_box_unpack(grid, &box, at, field[f]);
			at += ts_cell_box_size(&box);
		}
	}
}

static enum ts_status make_parcel(struct ts_parcel *parcel, const struct shipment *s, size_t fields)
{
	parcel->n = 0;
	return ts_parcel_extend(parcel, shipment_size(s) * fields * sizeof(double)) ? TS_OK : TS_NOMEM;
}

/* What rank `from` sends to rank `to`. */
typedef struct shipment shipment_fn(const struct ts_fluid *fluid, int from, int to);

static enum ts_status pack_all(struct ts_fluid *fluid, shipment_fn *shipment, double *const *field, size_t n)
{
	struct ts_fluid_near *near = &fluid->near;
	const int own = fluid->slabs->world->rank;

	for (int r = 0; r < near->ranks; r++) {
		const struct shipment out = shipment(fluid, own, r), in = shipment(fluid, r, own);

		near->out[r].n = near->in[r].n = 0;
		if (r == own)
			continue;
		TS_TRY(make_parcel(&near->out[r], &out, n));
		TS_TRY(make_parcel(&near->in[r], &in, n));
		copy_shipment(&fluid->grid, &out, field, n, &near->out[r], true);
	}
	return TS_OK;
}

static enum ts_status exchange(struct ts_fluid *fluid, shipment_fn *shipment, double *const *field, size_t n)
{
	struct ts_fluid_near *near = &fluid->near;
	const int own = fluid->slabs->world->rank;

	TS_TRY(pack_all(fluid, shipment, field, n));
	ts_world_swap(fluid->slabs->world, near->out, near->in);
	for (int r = 0; r < near->ranks; r++) {
		const struct shipment in = shipment(fluid, r, own);

		if (r != own)
			copy_shipment(&fluid->grid, &in, field, n, &near->in[r], false);
	}
	return TS_OK;
}

static void count(struct ts_fluid *fluid, shipment_fn *shipment, size_t fields)
{
	struct ts_world *world = fluid->slabs->world;

	for (int r = 0; r < fluid->near.ranks; r++) {
		const struct shipment out = shipment(fluid, world->rank, r);
		const size_t bytes = r == world->rank ? 0 : shipment_size(&out) * fields * sizeof(double);

		world->counts.messages += bytes > 0;
		world->counts.bytes += (int64_t)bytes;
	}
}

/* ---- gather */

/* Points on upper faces go with the last cell. */
static struct ts_cell_spans with_upper_face(struct ts_cell_spans spans, const struct ts_grid *grid, int d)
{
	if (spans.n && spans.of[spans.n - 1].to == grid->n[d])
		spans.of[spans.n - 1].to++;
	return spans;
}

static struct shipment of_own_cells(const struct ts_fluid *fluid, int from, int to, bool near_too)
{
	const struct ts_near_rank *rank = &fluid->near.rank[to];
	const struct ts_grid *grid = &fluid->grid;
	struct shipment s = { .from = fluid->near.owners.box[from], .groups = near_too ? 2 : 1 };

	for (int d = 0; d < 2; d++) {
		s.to[0][d] = (struct ts_cell_spans){ 1, { { 0, grid->n[d] + 1 } } };
		s.to[1][d] = with_upper_face(rank->cell[d], grid, d);
	}
	s.to[0][2] = with_upper_face(rank->planes, grid, 2);
	s.to[1][2] = with_upper_face(rank->beyond, grid, 2);
	return s;
}

static struct shipment to_planes(const struct ts_fluid *fluid, int from, int to)
{
	return of_own_cells(fluid, from, to, false);
}

static struct shipment to_planes_and_near(const struct ts_fluid *fluid, int from, int to)
{
	return of_own_cells(fluid, from, to, true);
}

enum ts_status ts_fluid_near_gather(struct ts_fluid *fluid, double *const *field, size_t n, bool near_too)
{
	return exchange(fluid, near_too ? to_planes_and_near : to_planes, field, n);
}

void ts_fluid_near_count_gather(struct ts_fluid *fluid, size_t fields, bool near_too)
{
	count(fluid, near_too ? to_planes_and_near : to_planes, fields);
}

/* ---- spread */

/* With the ghosts beside faces that are not periodic. */
static struct ts_cell_spans with_ghosts(const struct ts_cell_spans *spans, const struct ts_grid *grid, int d)
{
	struct ts_cell_spans out = *spans;

	for (int s = 0; s < out.n && !grid->periodic[d]; s++) {
		out.of[s].from -= out.of[s].from == 0 ? grid->ghosts[d] : 0;
		out.of[s].to += out.of[s].to == grid->n[d] ? grid->ghosts[d] : 0;
	}
	return out;
}

static struct shipment of_slab(const struct ts_fluid *fluid, int from, int to)
{
	const struct ts_near_rank *rank = &fluid->near.rank[to];
	const struct ts_grid *grid = &fluid->grid;
	struct shipment s = { .groups = 1 };

	for (int d = 0; d < 3; d++) {
		s.from.from[d] = -grid->ghosts[d];
		s.from.to[d] = grid->n[d] + grid->ghosts[d];
		s.to[0][d] = with_ghosts(&rank->cell[d], grid, d);
	}
	if (from > 0)
		s.from.from[2] = (int)ts_slabs_part(fluid->slabs, from, (size_t)grid->n[2]);
	if (from < fluid->near.ranks - 1)
		s.from.to[2] = (int)ts_slabs_part(fluid->slabs, from + 1, (size_t)grid->n[2]);
	return s;
}

/* ---- ghosts */

/* Where a ghost at k = -depth or n - 1 + depth has its value: -1: its face is not periodic, and `mirror` is not set. */
static int source_of_ghost(const struct ts_grid *grid, int d, bool high, int depth, bool mirror)
{
	const int n = grid->n[d];

	if (grid->periodic[d])
		return high ? (depth - 1) % n : ((-depth) % n + n) % n;
	return mirror ? (high ? n - depth : depth - 1) : -1;
}

/* Copies a layer across axis d to another one, where the other axes are near particles, with ghosts of axes before d. */
static void copy_layer(const struct ts_fluid *fluid, double *field, int d, int from, int to)
{
	const struct ts_grid *grid = &fluid->grid;
	const struct ts_cell_spans *cell = ts_fluid_near_own(fluid)->cell;
	const int a = d == 0, b = d == 2 ? 1 : 2;
	const ptrdiff_t shift = (from - to) * grid->stride[d];
	struct ts_cell_spans along[2];

	for (int k = 0; k < 2; k++) {
		const int axis = k ? b : a;

		along[k] = cell[axis];
		for (int s = 0; s < along[k].n; s++) { /* ghosts of either sort: they are made, or not used */
			along[k].of[s].from -= along[k].of[s].from == 0 ? grid->ghosts[axis] : 0;
			along[k].of[s].to += along[k].of[s].to == grid->n[axis] ? grid->ghosts[axis] : 0;
		}
	}
	for (int sb = 0; sb < along[1].n; sb++)
		for (int ib = along[1].of[sb].from; ib < along[1].of[sb].to; ib++)
			for (int sa = 0; sa < along[0].n; sa++)
				for (int ia = along[0].of[sa].from; ia < along[0].of[sa].to; ia++) {
					double *at = field + grid->origin + ia * grid->stride[a] +
						     ib * grid->stride[b] + to * grid->stride[d];

					*at = at[shift];
				}
}

static void fill_near(const struct ts_fluid *fluid, double *field, bool mirror)
{
	const struct ts_grid *grid = &fluid->grid;
	const struct ts_cell_spans *cell = ts_fluid_near_own(fluid)->cell;

	for (int d = 0; d < grid->dimensions; d++)
		for (int depth = 1; depth <= grid->ghosts[d]; depth++)
			for (int high = 0; high < 2; high++) {
				const int from = source_of_ghost(grid, d, high, depth, mirror);

				if (from >= 0 && ts_cell_spans_have(&cell[d], from))
					copy_layer(fluid, field, d, from,
						   high ? grid->n[d] - 1 + depth : -depth);
			}
}

void ts_fluid_near_fill_centred(const struct ts_fluid *fluid, double *field)
{
	fill_near(fluid, field, true);
}

enum ts_status ts_fluid_near_spread(struct ts_fluid *fluid, double *const *field, size_t n)
{
	TS_TRY(exchange(fluid, of_slab, field, n));
	for (size_t f = 0; f < n; f++)
		fill_near(fluid, field[f], false);
	return TS_OK;
}

void ts_fluid_near_count_spread(struct ts_fluid *fluid, size_t fields)
{
	count(fluid, of_slab, fields);
}
