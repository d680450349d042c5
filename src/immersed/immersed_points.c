/* Finds the points that a solid forces. */
#include "immersed/immersed.h"

#include <math.h>
#include <string.h>

#include "flow/fluid_slabs.h"
#include "math/vec3.h"

#include "base/alloc.h"
#include "base/parallel.h"

#include "base/banned.h"

/* The weight of outer points is 1 up to the fraction 1 - 1/FADING of the distance at which it is 0. With a
 * smaller value the force on moving bodies is a little smoother, but the error of a staircase surface, of
 * first order in the spacing, returns. */
static const double FADING = 10;

/* Layers of cells beside a boundary on which velocities in ghosts may depend, and two more. */
enum { BESIDE = TS_GRID_GHOSTS + 4 };

/* The search for the points of one velocity component. */
struct search {
	struct ts_immersed *ib;
	struct ts_solid *solid;
	const struct ts_fluid *fluid;
	const struct ts_grid *grid;
	int component;
	size_t worker, part;
	double lo[3], hi[3]; /* bounding box of the part */
	int from[3], to[3];  /* ranges of indices; along periodic axes also beyond the grid */
	const int *planes;   /* of struct ts_immersed */
	bool parallel;	     /* several threads: the part of a point is determined later */
	bool contested;	     /* a point may be near several parts, or near several images of one */
	struct ts_immersed_point *last;
};

static double period_length(const struct ts_grid *grid, int d)
{
	return grid->face[d][grid->n[d]] - grid->face[d][0];
}

static int image_number(int i, int n)
{
	return (i >= 0 ? i : i - n + 1) / n;
}

/* Coordinate of points of the component along axis d. */
static double point_coordinate(const struct search *s, int d, int i)
{
	const double *line = d == s->component ? s->grid->face[d] : s->grid->centre[d];
	int turns = s->grid->periodic[d] ? image_number(i, s->grid->n[d]) : 0;

	return line[i - turns * s->grid->n[d]] + turns * period_length(s->grid, d);
}

/* Width of the control volume. */
static double control_width(const struct search *s, int d, int i)
{
	const double *line = d == s->component ? s->grid->gap[d] : s->grid->width[d];

	return line[s->grid->periodic[d] ? i - image_number(i, s->grid->n[d]) * s->grid->n[d] : i];
}

static int cell_of(const struct ts_grid *grid, int d, double x)
{
	double turns = floor((x - grid->face[d][0]) / period_length(grid, d));

	if (!grid->periodic[d] || turns == 0)
		return ts_grid_find(grid, d, x);
	return (int)turns * grid->n[d] + ts_grid_find(grid, d, x - turns * period_length(grid, d));
}

/* Sets the ranges of points near the part: its bounding box and two cells around it. Along periodic axes they may be longer
 * than the grid: a point may be near both ends of a part, by different images. Along others only points inside the
 * boundaries, and on open faces. */
static void find_point_ranges(struct search *s)
{
	const struct ts_grid *grid = s->grid;

	for (int d = 0; d < 3; d++) {
		bool across = d == s->component && !grid->periodic[d];
		int n = grid->n[d] + (across && ts_flow_face_open(s->fluid->face[d][TS_HIGH]));
		int first = across && !ts_flow_face_open(s->fluid->face[d][TS_LOW]);
		double lo = grid->face[d][0], hi = grid->face[d][grid->n[d]];
		bool all = !(s->hi[d] - s->lo[d] < period_length(grid, d));

		s->from[d] = first;
		s->to[d] = n;
		if ((grid->periodic[d] && all) || d >= grid->dimensions)
			continue;
		if (grid->periodic[d] || (s->lo[d] > lo && s->lo[d] < hi))
			s->from[d] = cell_of(grid, d, s->lo[d]) - 2;
		if (grid->periodic[d] || (s->hi[d] > lo && s->hi[d] < hi))
			s->to[d] = cell_of(grid, d, s->hi[d]) + 4;
		if (grid->periodic[d])
			continue;
		s->from[d] = s->from[d] < first ? first : s->from[d];
		s->to[d] = s->lo[d] > hi || s->hi[d] < lo ? s->from[d] : s->to[d] > n ? n : s->to[d];
	}
}

/* A point that is looked at. What depends on the row only is set once a row. */
struct place {
	int i[3];
	double x[3], width[3]; /* of the control volume */
	double reach;	       /* beyond this distance from the surface it is not near */
	double reach_width;    /* the width along x for which that is */
	size_t row;	       /* index in a field of the point 0 of the row */
};

static int index_in_grid(const struct ts_grid *grid, int d, int i)
{
	return i - (grid->periodic[d] ? image_number(i, grid->n[d]) * grid->n[d] : 0);
}

static void begin_row(const struct search *s, int j, int k, struct place *at)
{
	*at = (struct place){ .i = { 0, j, k }, .reach_width = -1 };
	for (int d = 1; d < 3; d++) {
		at->x[d] = point_coordinate(s, d, at->i[d]);
		at->width[d] = control_width(s, d, at->i[d]);
	}
	at->row = ts_at(s->grid, 0, index_in_grid(s->grid, 1, j), index_in_grid(s->grid, 2, k));
}

static void set_place(const struct search *s, int i, struct place *at)
{
	double square = 0;

	at->i[0] = i;
	at->x[0] = point_coordinate(s, 0, i);
	at->width[0] = control_width(s, 0, i);
	if (at->width[0] == at->reach_width)
		return;
	for (int d = 0; d < s->grid->dimensions; d++)
		square += at->width[d] * at->width[d];
	at->reach = 1.001 * sqrt(square);
	at->reach_width = at->width[0];
}

/* Whether no part or image before is as near to the point; the point that is added next then owns it. keep_owners removes the
 * others. */
static bool is_nearest(const struct search *s, size_t at, double distance)
{
	struct ts_immersed *ib = s->ib;

	if (!s->contested || s->parallel)
		return true;
	if (ib->owner[at] && !(distance < ib->distance[at]))
		return false;
	ib->owner[at] = ib->npoints + 1;
	ib->distance[at] = distance;
	return true;
}

static enum ts_status add_point(struct search *s, const struct place *place, double distance)
{
	struct ts_immersed *ib = s->ib;
	size_t at = place->row + (size_t)index_in_grid(s->grid, 0, place->i[0]);
	struct ts_immersed_point *p;

	s->last = NULL;
	if (!is_nearest(s, at, distance))
		return TS_OK;
	TS_TRY(TS_GROW(ib->point, ib->point_capacity, ib->npoints + 1));
	if (s->parallel) {
		TS_TRY(TS_GROW(ib->candidate, ib->candidate_capacity, ib->npoints + 1));
		ib->candidate[ib->npoints] = (struct ts_immersed_candidate){ .distance = distance };
	}
	p = s->last = &ib->point[ib->npoints++];
	*p = (struct ts_immersed_point){ .at = at, .part = (int32_t)s->part, .solid = 1 };
	p->index = index_in_grid(s->grid, s->component, place->i[s->component]);
	p->turn = s->grid->periodic[2] ? image_number(place->i[2], s->grid->n[2]) : 0;
	ts_sub(place->x, s->solid->motion[s->part].centre, p->arm);
	p->volume = place->width[0] * place->width[1] * place->width[2];
	if (!s->grid->periodic[s->component] && (p->index == 0 || p->index == s->grid->n[s->component]))
		p->volume *= 0.5; /* half of the control volume is outside the grid */
	return TS_OK;
}

static void set_target_velocity(struct search *s, const struct place *at, double velocity)
{
	double rate = fabs(velocity) / at->width[s->component];

	s->last->target = velocity;
	if (s->parallel)
		s->ib->candidate[s->ib->npoints - 1].rate = rate;
	else if (rate > s->ib->rate)
		s->ib->rate = rate;
}

/* Updates the thickness by the point that was added last. */
static void update_thickness(struct search *s, double thickness)
{
	if (s->parallel)
		s->ib->candidate[s->ib->npoints - 1].thickness = thickness;
	else if (thickness > s->ib->thickness)
		s->ib->thickness = thickness;
}

/* Distance from x along n to the boundary of the grid, at most `most`. */
static double distance_to_boundary(const struct ts_grid *grid, const double x[3], const double n[3],
				   double most)
{
	for (int d = 0; d < 3; d++) {
		double face = grid->face[d][n[d] > 0 ? grid->n[d] : 0], away;

		if (grid->periodic[d] || n[d] == 0)
			continue;
		away = (face - x[d]) / n[d];
		away = away > 0 ? away : 0;
		most = away < most ? away : most;
	}
	return most;
}

/* Finds the points of the component around the position x + l n. */
static void find_sample(const struct search *s, const double x[3], const double n[3], double l,
			struct ts_immersed_sample *out)
{
	const struct ts_grid *grid = s->grid;
	int i[3];

	for (int d = 0; d < 3; d++) {
		const double *line = d == s->component ? grid->face[d] : grid->centre[d];
		double y = x[d] + l * n[d], lo = grid->face[d][0], hi = grid->face[d][grid->n[d]];

		if (grid->periodic[d])
			y -= floor((y - lo) / (hi - lo)) * (hi - lo);
		y = y > lo ? y : lo;
		y = y < hi ? y : hi;
		i[d] = ts_grid_find(grid, d, y);
		out->t[d] = 0;
		if (grid->ghosts[d] == 0)
			continue;
		i[d] -= d != s->component && y < line[i[d]];
		out->t[d] = (y - line[i[d]]) / (line[i[d] + 1] - line[i[d]]);
		s->ib->reads_ghosts |= i[d] < 1 || i[d] + 2 > grid->n[d] - 1;
	}
	out->corner = ts_at(grid, i[0], i[1], i[2]);
	out->index = i[s->component];
}

/* The largest distance, in planes, of the cells two spacings from a point in cell k. */
static int reached_planes(const struct ts_grid *grid, double x, double width, int k)
{
	const double lo = grid->face[2][0], hi = grid->face[2][grid->n[2]];
	const double reach = 2.001 * width; /* a little more: round-off may choose the next cell */
	double below = x - reach, above = x + reach;
	int under, over;

	if (!grid->periodic[2]) {
		below = fmax(below, lo);
		above = fmin(above, hi);
	}
	under = k - cell_of(grid, 2, below);
	over = cell_of(grid, 2, above) - k;
	return under > over ? under : over;
}

/* Of the cell with a sample also the neighbours: of trilinear interpolation, and of the pressure gradient; ghosts beside open
 * faces depend on the next plane. */
int ts_immersed_planes_beside(const struct ts_grid *grid)
{
	int most = 0;

	for (int k = 0; k < grid->n[2]; k++) {
		const int centre = reached_planes(grid, grid->centre[2][k], grid->width[2][k], k),
			  face = reached_planes(grid, grid->face[2][k], grid->gap[2][k], k);

		most = centre > most ? centre : most;
		most = face > most ? face : most;
	}
	return most + 1;
}

/* Of the cell around a point: extent along n, spacing l along n, and largest distance from the surface at
 * which a neighbour may be inside. */
struct extent {
	double across, along, reach;
};

static struct extent control_volume_extent(const struct search *s, const double width[3], const double n[3])
{
	struct extent e = { 0 };

	for (int d = 0; d < s->grid->dimensions; d++) {
		double h = width[d], part = fabs(n[d]) * h;

		e.across += part;
		e.reach = part > e.reach ? part : e.reach;
		e.along += n[d] / h * (n[d] / h);
	}
	e.along = 1 / sqrt(e.along);
	return e;
}

/* Adds the outer point for the forced point that was added last. */
static enum ts_status add_outer_point(struct search *s, const double x[3],
				      const struct ts_solid_surface *surface, const struct extent *e)
{
	struct ts_immersed *ib = s->ib;
	double d = surface->distance, l = distance_to_boundary(s->grid, x, surface->n, 2 * e->along) / 2;
	struct ts_immersed_outer *b;

	TS_TRY(TS_GROW(ib->outer, ib->outer_capacity, ib->nouter + 1));
	b = &ib->outer[ib->nouter++];
	*b = (struct ts_immersed_outer){ .point = ib->npoints - 1 };
	s->last->outside = true;
	b->weight = fmin(1, fmax(0, FADING * (1 - d / e->reach)));
	b->surface = surface->v[s->component];
	find_sample(s, x, surface->n, l, &b->out[0]);
	find_sample(s, x, surface->n, 2 * l, &b->out[1]);
	b->out[0].count = 2 * d / (d + l);
	b->out[1].count = -d / (d + 2 * l);
	return TS_OK;
}

/* Completes the point that was added last from the nearest point of the surface. */
static enum ts_status describe_near_point(struct search *s, const struct place *at,
					  const struct ts_solid_surface *surface)
{
	struct extent e = control_volume_extent(s, at->width, surface->n);
	struct ts_immersed_point *p = s->last;

	p->solid = fmin(1, fmax(0, 0.5 - surface->distance / e.across));
	set_target_velocity(s, at, surface->v[s->component]);
	update_thickness(s, -2 * surface->distance / e.across);
	return surface->distance > 0 ? add_outer_point(s, at->x, surface, &e) : TS_OK;
}

/* A face of a body that lies on faces of cells is inside at all of them: rounding must not choose. */
static void settle_on_surface(const struct place *at, struct ts_solid_surface *surface)
{
	const double round_off = 1e-9;

	if (fabs(surface->distance) < round_off * at->reach)
		surface->distance = 0;
}

/* Searches a row along x: a point far from the surface is on the same side as the point before. */
static enum ts_status search_row(struct search *s, int j, int k)
{
	enum { UNKNOWN, OUT, IN } where = UNKNOWN;
	struct place at;

	begin_row(s, j, k, &at);
	for (int i = s->from[0]; i < s->to[0]; i++) {
		enum ts_solid_side side;
		struct ts_solid_surface surface;

		set_place(s, i, &at);
		TS_TRY(s->solid->kind->find_surface(s->solid, s->worker, s->part, at.x, at.reach, &side,
						    &surface));
		if (side == TS_SOLID_NEAR) {
			settle_on_surface(&at, &surface);
			where = surface.distance > 0 ? OUT : IN;
			TS_TRY(add_point(s, &at, surface.distance));
			if (s->last)
				TS_TRY(describe_near_point(s, &at, &surface));
			continue;
		}
		if (where == UNKNOWN)
			where = s->solid->kind->inside(s->solid, s->part, at.x) ? IN : OUT;
		if (where == OUT)
			continue;
		TS_TRY(add_point(s, &at, -INFINITY));
		if (s->last) {
			double v[3];

			ts_solid_velocity(&s->solid->motion[s->part], at.x, v);
			set_target_velocity(s, &at, v[s->component]);
			s->last->deep = true;
			update_thickness(s, 2);
		}
	}
	return TS_OK;
}

/* Keeps the points of the nearest part or image, and resets the work fields. */
static void keep_owners(struct ts_immersed *ib, size_t first, size_t first_band)
{
	size_t n = first, bands = first_band, b = first_band;

	for (size_t k = first; k < ib->npoints; k++) {
		struct ts_immersed_point p = ib->point[k];
		bool mine = ib->owner[p.at] == k + 1;

		if (b < ib->nouter && ib->outer[b].point == k) {
			ib->outer[bands] = ib->outer[b++];
			ib->outer[bands].point = n;
			bands += mine;
		}
		ib->point[n] = p;
		n += mine;
	}
	for (size_t k = first; k < n; k++)
		ib->owner[ib->point[k].at] = 0;
	ib->npoints = n;
	ib->nouter = bands;
}

/* Whether points in this plane across the last axis are those of this rank: `k` may be beyond a periodic grid. */
static bool has_plane(const struct search *s, int k)
{
	const int at = index_in_grid(s->grid, 2, k);

	return at >= s->planes[0] && at < s->planes[1];
}

/* Leaves planes out that are those of other ranks, at both ends of the range. */
static void trim_planes(struct search *s)
{
	while (s->from[2] < s->to[2] && !has_plane(s, s->from[2]))
		s->from[2]++;
	while (s->from[2] < s->to[2] && !has_plane(s, s->to[2] - 1))
		s->to[2]--;
}

/* Begins with a part; returns the number of its rows. */
static size_t begin_part_search(struct search *s, size_t part)
{
	s->part = part;
	s->solid->kind->bounds(s->solid, part, s->lo, s->hi);
	find_point_ranges(s);
	for (int d = 0; d < s->grid->dimensions; d++)
		s->ib->beside_boundary |= s->from[d] < BESIDE || s->to[d] > s->grid->n[d] - BESIDE;
	trim_planes(s);
	if (s->from[0] >= s->to[0] || s->from[1] >= s->to[1] || s->from[2] >= s->to[2])
		return 0;
	return (size_t)(s->to[1] - s->from[1]) * (size_t)(s->to[2] - s->from[2]);
}

/* Searches the rows from `from` to `to`, counted over all parts. */
static enum ts_status search_rows(struct search *s, size_t from, size_t to)
{
	size_t first = 0, rows;

	for (size_t part = 0; part < s->solid->parts && first < to; part++, first += rows) {
		size_t begin, end, height;

		rows = begin_part_search(s, part);
		begin = from > first ? from - first : 0;
		end = to - first < rows ? to - first : rows;
		height = (size_t)(s->to[1] - s->from[1]);
		for (size_t row = begin; row < end; row++) {
			const int k = s->from[2] + (int)(row / height);

			if (has_plane(s, k))
				TS_TRY(search_row(s, s->from[1] + (int)(row % height), k));
		}
	}
	return TS_OK;
}

/* ---- in parallel: each thread searches its own range of rows; the results are joined in the order of the
 * ranges */

struct search_task {
	const struct search *search;
	size_t rows;
};

static void search_chunks(void *context, size_t from, size_t to)
{
	const struct search_task *task = context;
	struct search s = *task->search;
	size_t chunks = s.ib->chunks;

	for (size_t k = from; k < to; k++) {
		s.ib = &task->search->ib->chunk[k];
		s.parallel = true;
		s.worker = k;
		s.ib->npoints = s.ib->nouter = 0;
		s.ib->reads_ghosts = false;
		s.ib->status = search_rows(&s, task->rows * k / chunks, task->rows * (k + 1) / chunks);
	}
}

static enum ts_status append_chunk(struct search *s, const struct ts_immersed *chunk)
{
	struct ts_immersed *ib = s->ib;
	size_t band = 0;

	TS_TRY(chunk->status);
	ib->reads_ghosts |= chunk->reads_ghosts;
	TS_TRY(TS_GROW(ib->point, ib->point_capacity, ib->npoints + chunk->npoints));
	TS_TRY(TS_GROW(ib->outer, ib->outer_capacity, ib->nouter + chunk->nouter));
	for (size_t k = 0; k < chunk->npoints; k++) {
		const struct ts_immersed_point *p = &chunk->point[k];
		const struct ts_immersed_candidate *candidate = &chunk->candidate[k];
		const struct ts_immersed_outer *b = p->outside ? &chunk->outer[band++] : NULL;

		if (!is_nearest(s, p->at, candidate->distance))
			continue;
		if (b) {
			ib->outer[ib->nouter] = *b;
			ib->outer[ib->nouter++].point = ib->npoints;
		}
		ib->point[ib->npoints++] = *p;
		ib->rate = fmax(ib->rate, candidate->rate);
		ib->thickness = fmax(ib->thickness, candidate->thickness);
	}
	return TS_OK;
}

static enum ts_status search_in_parallel(struct search *s, size_t rows, int team)
{
	struct ts_immersed *ib = s->ib;
	struct search_task task = { s, rows };

	if (s->solid->kind->team)
		TS_TRY(s->solid->kind->team(s->solid, (size_t)team));
	TS_TRY(TS_GROW(ib->chunk, ib->chunk_capacity, (size_t)team));
	ib->chunks = (size_t)team;
	ts_parallel(team, ib->chunks, search_chunks, &task);
	for (size_t k = 0; k < ib->chunks; k++)
		TS_TRY(append_chunk(s, &ib->chunk[k]));
	return TS_OK;
}

static enum ts_status allocate_owners(struct ts_immersed *ib, const struct ts_grid *grid)
{
	if (ib->owner)
		return TS_OK;
	ib->distance = ts_alloc(grid->size, sizeof *ib->distance);
	ib->owner = ts_alloc(grid->size, sizeof *ib->owner);
	return ib->distance && ib->owner ? TS_OK : TS_NOMEM;
}

static enum ts_status find_component_points(struct search *s)
{
	enum { ROUNDS = 8 }; /* work of a point in iterations of a simple loop, for the number of threads */
	struct ts_immersed *ib = s->ib;
	size_t first = ib->npoints, first_band = ib->nouter, rows = 0, looks = 0;
	int team;

	s->contested = s->solid->parts > 1;
	for (size_t part = 0; part < s->solid->parts; part++) {
		size_t more = begin_part_search(s, part);

		for (int d = 0; d < 3; d++)
			s->contested |= s->grid->periodic[d] && s->to[d] - s->from[d] > s->grid->n[d];
		rows += more;
		looks += more * (size_t)(s->to[0] - s->from[0]);
	}
	team = ts_fluid_team(s->fluid, ROUNDS * looks);
	team = rows < (size_t)team ? (int)rows : team;
	if (s->contested)
		TS_TRY(allocate_owners(ib, s->grid));
	TS_TRY(team > 1 ? search_in_parallel(s, rows, team) : search_rows(s, 0, rows));
	if (s->contested)
		keep_owners(ib, first, first_band);
	return TS_OK;
}

/* ---- layers */

static int plane_of(const struct ts_grid *grid, const struct ts_immersed_point *p)
{
	return (int)(p->at / (size_t)grid->stride[2]) - grid->ghosts[2];
}

static enum ts_status find_layers(struct ts_immersed *ib, const struct ts_grid *grid)
{
	ib->nlayers = 0;
	for (int c = 0; c < grid->dimensions; c++)
		for (size_t k = ib->first[c], first = k; k < ib->first[c + 1]; first = k) {
			const int32_t part = ib->point[first].part, turn = ib->point[first].turn;
			const int plane = plane_of(grid, &ib->point[first]);

			while (k < ib->first[c + 1] && ib->point[k].part == part &&
			       ib->point[k].turn == turn && plane_of(grid, &ib->point[k]) == plane)
				k++;
			TS_TRY(TS_GROW(ib->layer, ib->layer_capacity, ib->nlayers + 1));
			ib->layer[ib->nlayers++] = (struct ts_immersed_layer){ .first = first,
									       .end = k,
									       .component = c,
									       .part = part,
									       .plane = plane,
									       .turn = turn };
		}
	return TS_OK;
}

/* ---- ranks */

/* Planes of this rank; the last one has the faces behind the last cells, too. */
static void find_planes(const struct ts_fluid *fluid, int planes[2])
{
	const int n = fluid->grid.n[2];

	planes[0] = 0;
	planes[1] = n;
	if (ts_fluid_divided(fluid))
		ts_fluid_slabs_planes(fluid, &planes[0], &planes[1]);
	planes[1] += planes[1] == n;
}

bool ts_immersed_has_planes(const struct ts_immersed *ib, const struct ts_fluid *fluid)
{
	int planes[2];

	find_planes(fluid, planes);
	return memcmp(planes, ib->planes, sizeof planes) == 0;
}

/* What follows from the points of all ranks. */
static void sum_of_ranks(struct ts_immersed *ib, const struct ts_fluid *fluid)
{
	struct ts_world *world = ts_fluid_divided(fluid) ? fluid->slabs->world : NULL;
	int64_t number[2] = { (int64_t)(ib->npoints - ib->nouter), (int64_t)ib->nouter };
	double most[3] = { ib->thickness, ib->rate, ib->reads_ghosts };

	if (world) {
		ts_world_sums(world, number, 2);
		ts_world_most(world, most, 3);
	}
	ib->inside = (size_t)number[0];
	ib->beside = (size_t)number[1];
	ib->thickness = most[0];
	ib->rate = most[1];
	ib->reads_ghosts = most[2] > 0;
}

/* Of all planes, which need memory that those of this rank do not. */
static void release_other_planes(struct ts_immersed *ib, const struct ts_fluid *fluid)
{
	if (ib->npoints && !ts_immersed_has_planes(ib, fluid))
		ts_immersed_release(ib);
}

enum ts_status ts_immersed_find_points(struct ts_immersed *ib, struct ts_solid *solid,
				       const struct ts_fluid *fluid)
{
	struct search s = {
		.ib = ib, .solid = solid, .fluid = fluid, .grid = &fluid->grid, .planes = ib->planes
	};

	release_other_planes(ib, fluid);
	TS_TRY(TS_GROW(ib->sums, ib->sums_capacity, solid->parts));
	find_planes(fluid, ib->planes);
	ib->planes_beside = ts_immersed_planes_beside(&fluid->grid);
	ib->npoints = ib->nouter = 0;
	ib->reads_ghosts = ib->beside_boundary = false;
	ib->thickness = ib->rate = 0;
	for (int c = 0; c < 3; c++) {
		ib->first[c] = ib->npoints;
		ib->outer_first[c] = ib->nouter;
		s.component = c;
		if (c < fluid->grid.dimensions)
			TS_TRY(find_component_points(&s));
	}
	ib->first[3] = ib->npoints;
	ib->outer_first[3] = ib->nouter;
	sum_of_ranks(ib, fluid);
	return find_layers(ib, &fluid->grid);
}

void ts_immersed_release(struct ts_immersed *ib)
{
	for (size_t k = 0; k < ib->chunk_capacity; k++)
		ts_immersed_release(&ib->chunk[k]);
	ts_free(ib->chunk);
	ts_free(ib->candidate);
	ts_free(ib->point);
	ts_free(ib->outer);
	ts_free(ib->distance);
	ts_free(ib->owner);
	ts_free(ib->sums);
	ts_free(ib->layer);
	ts_parcel_release(&ib->own_layers);
	ts_parcel_release(&ib->all_layers);
	*ib = (struct ts_immersed){ 0 };
}
