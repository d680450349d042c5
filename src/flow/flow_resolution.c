/* Two criteria for cells that are too wide, from the velocity field.
 *
 * Along an axis where the cell Reynolds number |u| h/nu is above 2 central differences (and QUICK,
 * less) produce velocities that alternate from cell to cell: three consecutive differences of alternating
 * sign, which a resolved flow does not have. A high cell Reynolds number alone is no criterion: where the
 * flow varies slowly results are right.
 *
 * Beside a wall the profile should be smooth over the first three cells: the first is compared with
 * the parabola through the wall and the next two. If the layer is as thin as a cell, the first
 * velocity is that of the free stream, and the parabola gives 0.47 of it. If the first cell has
 * more than half of the largest speed, as with three cells across a channel, integrals over cells are
 * wrong by several per cent. The limits separate errors above and below 4 % in the cases of
 * doc/flow.md. */
#include "flow/flow_resolution.h"

#include <math.h>
#include <stdio.h>

#include "base/alloc.h"
#include "core/review.h"
#include "flow/flow_measures.h"
#include "flow/fluid_slabs.h"

#include "base/banned.h"

static const double ALTERNATES = 0.02, MISSES = 0.35, MATTERS = 0.1, STEEP = 0.5, ROUND_OFF = 1e-9;

/* A velocity that alternates from cell to cell along an axis. */
struct wiggle {
	/* amplitude: half of the smallest of three consecutive differences of alternating sign */
	double size;
	double reynolds; /* |u| h/nu there */
	double x[3], width;
	int axis, order; /* of the search: component, then axis */
};

/* Resolution of the velocity profile by the first cells beside a wall. */
struct layer {
	double miss;  /* mean of |u1 - parabola through the wall and the next two|, by the mean of
			 |u1 - wall| */
	double share; /* mean of |u1 - wall| by the largest speed */
	double plus;  /* y+ of the first centres, with their mean shear */
	double width; /* the widest of the first cells */
};

static double largest_speed(const struct ts_fluid *fluid)
{
	const struct ts_grid *grid = &fluid->grid;
	double most = 0;
	int first, end;

	ts_fluid_slabs_planes(fluid, &first, &end);
	for (int d = 0; d < grid->dimensions; d++) {
		for (enum ts_grid_side side = TS_LOW; side <= TS_HIGH; side++)
			for (int c = 0; c < grid->dimensions; c++)
				if (fluid->face[d][side] == TS_FLOW_WALL)
					most = fmax(most, fabs(fluid->face_velocity[d][side].constant[c]));
		for (int k = first; k < end; k++)
			for (int j = 0; j < grid->n[1]; j++)
				for (int i = 0; i < grid->n[0]; i++)
					most = fmax(most, fabs(fluid->u[d][ts_at(grid, i, j, k)]));
	}
	return ts_fluid_slabs_most(fluid, most);
}

static double face_acceleration(const struct ts_fluid *fluid, int d, int i, size_t at)
{
	const struct ts_grid *grid = &fluid->grid;
	const double below = fluid->p[at - (size_t)grid->stride[d]];

	return fabs(fluid->p[at] - below) / (grid->gap[d][i] * fluid->density);
}

/* By the pressure gradient. Beside faces of the grid the pressure is not that of a cell. */
static double largest_acceleration(const struct ts_fluid *fluid)
{
	const struct ts_grid *grid = &fluid->grid;
	double most = 0;
	int first, end;

	ts_fluid_slabs_planes(fluid, &first, &end);
	for (int d = 0; d < grid->dimensions; d++)
		for (int k = first > (d == 2) ? first : (d == 2); k < end; k++)
			for (int j = d == 1; j < grid->n[1]; j++)
				for (int i = d == 0; i < grid->n[0]; i++)
					most = fmax(most, face_acceleration(fluid, d, (int[3]){ i, j, k }[d],
									    ts_at(grid, i, j, k)));
	return ts_fluid_slabs_most(fluid, most);
}

/* Whether the fluid is at rest but for round-off of the pressure that balances its weight: speeds are far below those that
 * the pressure gradient alone would cause until viscosity has diffused over a cell. */
static bool is_at_rest(const struct ts_fluid *fluid, double fastest)
{
	const double least = ts_grid_least_width(&fluid->grid);
	const double time = fmin(fluid->time, least * least * fluid->density / fluid->viscosity);

	return !(fastest > ROUND_OFF * largest_acceleration(fluid) * time);
}

static void check_wiggle(const struct ts_fluid *fluid, int c, int d, const int cell[3], struct wiggle *most)
{
	const struct ts_grid *grid = &fluid->grid;
	const size_t at = ts_at(grid, cell[0], cell[1], cell[2]), s = (size_t)grid->stride[d];
	const double *u = fluid->u[c];
	double below = u[at] - u[at - s], here = u[at + s] - u[at], above = u[at + 2 * s] - u[at + s];
	double size, reynolds;

	if (!(below * here < 0 && here * above < 0))
		return;
	size = 0.5 * fmin(fabs(below), fmin(fabs(here), fabs(above)));
	if (size <= most->size)
		return;
	reynolds = fabs(fluid->u[d][at]) * grid->width[d][cell[d]] * fluid->density / fluid->viscosity;
	if (!(reynolds > 2))
		return;
	most->size = size;
	most->reynolds = reynolds;
	most->axis = d;
	most->order = 3 * c + d;
	most->width = grid->width[d][cell[d]];
	for (int e = 0; e < 3; e++)
		most->x[e] = grid->centre[e][cell[e]];
}

/* The largest of all ranks; of equal ones that which comes first in the search. */
static void share_wiggle(const struct ts_fluid *fluid, struct wiggle *most)
{
	struct ts_world *world = fluid->slabs ? fluid->slabs->world : NULL;
	double first;

	if (ts_slabs_ranks(fluid->slabs) == 1)
		return;
	first = ts_fluid_slabs_most(fluid, most->size) == most->size
			? -((double)most->order * world->n + world->rank)
			: -INFINITY;
	first = -ts_fluid_slabs_most(fluid, first);
	ts_world_spread(world, (int)fmod(first, world->n), most, sizeof *most);
}

static struct wiggle largest_wiggle(const struct ts_fluid *fluid)
{
	const struct ts_grid *grid = &fluid->grid;
	struct wiggle most = { 0 };
	int first, end;

	ts_fluid_slabs_planes(fluid, &first, &end);

	for (int c = 0; c < grid->dimensions; c++)
		for (int d = 0; d < grid->dimensions; d++) {
			int from[3] = { 0 }, to[3] = { grid->n[0], grid->n[1], grid->n[2] };

			if (!grid->periodic[d]) {
				from[d] = 1;
				to[d] -= 2;
			}
			for (int k = from[2] > first ? from[2] : first; k < to[2] && k < end; k++)
				for (int j = from[1]; j < to[1]; j++)
					for (int i = from[0]; i < to[0]; i++)
						check_wiggle(fluid, c, d, (int[3]){ i, j, k }, &most);
		}
	share_wiggle(fluid, &most);
	return most;
}

/* Value at x of the parabola that is 0 at 0, u at a and v at b. */
static double parabola(double x, double a, double b, double u, double v)
{
	return u * x * (x - b) / (a * (a - b)) + v * x * (x - a) / (b * (b - a));
}

struct wall {
	const struct ts_fluid *fluid;
	int d, a, b, row[3]; /* axes; indices of the first three cells from the wall */
	enum ts_grid_side side;
	double y[3]; /* distances of their centres from the wall */
};

static struct wall find_wall(const struct ts_fluid *fluid, int d, enum ts_grid_side side)
{
	const struct ts_grid *grid = &fluid->grid;
	const int n = grid->n[d];
	const double at = grid->face[d][side == TS_LOW ? 0 : n];
	struct wall out = { .fluid = fluid, .d = d, .a = d == 0, .b = d == 2 ? 1 : 2, .side = side };

	for (int m = 0; m < 3; m++) {
		out.row[m] = side == TS_LOW ? m : n - 1 - m;
		out.y[m] = fabs(grid->centre[d][out.row[m]] - at);
	}
	return out;
}

/* Component c of the velocities in the first three cells relative to the wall. */
static void first_velocities(const struct wall *wall, int c, int ia, int ib, double u[3])
{
	const struct ts_fluid *fluid = wall->fluid;
	const struct ts_flow_face_velocity *given = &fluid->face_velocity[wall->d][wall->side];
	size_t plane = ts_flow_plane_at(&fluid->grid, wall->d, ia, ib);
	double own = given->plane[c] ? given->plane[c][plane] : given->constant[c];

	for (int m = 0; m < 3; m++) {
		int cell[3];

		cell[wall->d] = wall->row[m];
		cell[wall->a] = ia;
		cell[wall->b] = ib;
		u[m] = fluid->u[c][ts_at(&fluid->grid, cell[0], cell[1], cell[2])] - own;
	}
}

/* Integrals over a row of cells beside the wall: 1, |u1 - wall|, |u1 - parabola|. */
static void add_wall_row(const struct wall *wall, int ib, double out[3])
{
	const struct ts_grid *grid = &wall->fluid->grid;
	const double *y = wall->y;
	double u[3];

	for (int ia = 0; ia < grid->n[wall->a]; ia++) {
		double patch = grid->width[wall->a][ia] * grid->width[wall->b][ib];

		out[0] += patch;
		for (int c = 0; c < grid->dimensions; c++) {
			if (c == wall->d)
				continue;
			first_velocities(wall, c, ia, ib, u);
			out[1] += patch * fabs(u[0]);
			out[2] += patch * fabs(u[0] - parabola(y[0], y[1], y[2], u[1], u[2]));
		}
	}
}

/* Of all rows: each rank has those of its planes, or the first or the last rank all. */
static void add_wall_rows(const struct wall *wall, double (*row)[3])
{
	const struct ts_fluid *fluid = wall->fluid;
	const int n = fluid->grid.n[wall->b], ranks = ts_slabs_ranks(fluid->slabs);
	const bool across = wall->d == 2;
	int first, end;

	ts_fluid_slabs_planes(fluid, &first, &end);
	if (across && (wall->row[0] < first || wall->row[0] >= end))
		first = end = 0;
	else if (across)
		first = 0, end = n;
	for (int ib = first; ib < end; ib++)
		add_wall_row(wall, ib, row[ib]);
	if (ranks == 1)
		return;
	if (across)
		ts_world_spread(fluid->slabs->world, wall->side == TS_LOW ? 0 : ranks - 1, row,
				(size_t)n * sizeof *row);
	else
		ts_slabs_share(fluid->slabs, &(struct ts_slabs_field){ .first = *row, .stride = 3 });
}

static enum ts_status boundary_layer(const struct wall *wall, double fastest, struct layer *out)
{
	const struct ts_fluid *fluid = wall->fluid;
	const struct ts_grid *grid = &fluid->grid;
	const int n = grid->n[wall->b];
	double area = 0, sum = 0, miss = 0, (*row)[3] = ts_alloc((size_t)n, sizeof *row);

	if (!row)
		return TS_NOMEM;
	add_wall_rows(wall, row);
	for (int ib = 0; ib < n; ib++) {
		area += row[ib][0];
		sum += row[ib][1];
		miss += row[ib][2];
	}
	ts_free(row);
	*out = (struct layer){ .miss = sum > 0 ? miss / sum : 0,
			       .share = sum / area / fastest,
			       .plus = sqrt(sum / area * wall->y[0] * fluid->density / fluid->viscosity),
			       .width = grid->width[wall->d][wall->row[0]] };
	return TS_OK;
}

/* Whether the flow has developed: viscosity has diffused over four cells, or the fluid has crossed the
 * grid. */
static bool is_developed(const struct ts_fluid *fluid, double width, double fastest)
{
	const struct ts_grid *grid = &fluid->grid;
	double length = 0;

	for (int d = 0; d < grid->dimensions; d++)
		length = fmax(length, grid->face[d][grid->n[d]] - grid->face[d][0]);
	return fluid->time * fastest > length ||
	       fluid->time * fluid->viscosity > 4 * width * width * fluid->density;
}

static enum ts_status report_wiggle(const struct ts_instance *self, struct tsim *sim, double fastest)
{
	const struct ts_projection *p = self->state;
	const struct ts_fluid *fluid = &p->fluid;
	const struct wiggle w = largest_wiggle(fluid);
	char remedy[128];

	/* Forces of unresolved particles differ from cell to cell. */
	if (fluid->force[0] || fluid->exchange[0] || fluid->void_fraction)
		return TS_OK;
	if (!(w.size > ALTERNATES * fastest) || !is_developed(fluid, w.width, fastest))
		return TS_OK;
	if (ts_convection_schemes[p->convection].bounded)
		snprintf(remedy, sizeof remedy, "use smaller cells");
	else
		snprintf(remedy, sizeof remedy, "use `convection %s`, or smaller cells",
			 p->convection == TS_CONVECTION_QUICK ? "cubista" : "quick");
	return ts_review_report(sim, "flow_resolution", &self->where,
				"the cells are too wide for the flow: at time %.4g the velocity alternates "
				"from cell to cell along %c by %.2g %% of the largest speed %.4g at (%.4g "
				"%.4g %.4g), where the cell Reynolds number |u| h/nu is %.3g (convection %s "
				"oscillates above 2 where the flow changes within a cell); %s there "
				"(flow_grid)",
				fluid->time, "xyz"[w.axis], 100 * w.size / fastest, fastest, w.x[0], w.x[1],
				w.x[2], w.reynolds, ts_convection_names[p->convection], remedy);
}

static enum ts_status report_wall(const struct ts_instance *self, struct tsim *sim, const struct wall *wall,
				  double fastest)
{
	const struct ts_fluid *fluid = wall->fluid;
	char axis = "xyz"[wall->d];
	struct layer layer;

	if (boundary_layer(wall, fastest, &layer) != TS_OK)
		return ts_nomem(&sim->error);
	if (!(layer.share > STEEP || (layer.miss > MISSES && layer.share > MATTERS)) ||
	    !is_developed(fluid, layer.width, fastest))
		return TS_OK;
	return ts_review_report(sim, "flow_resolution", &self->where,
				"the cells are too wide for the flow beside the wall %s: at time %.4g the "
				"velocity changes by %.2g %% of the largest speed %.4g from the wall to the "
				"first centres, and differs there by %.2g %% from the parabola through the "
				"wall and the next two (y+ = %.3g); the error of shear and flow rate is "
				"several per cent: use more cells along %c, or finer ones at the wall "
				"(`flow_grid %c tanh 1.5`)",
				ts_flow_face_names[2 * wall->d + (wall->side != TS_LOW)], fluid->time,
				100 * layer.share, fastest, 100 * layer.miss, layer.plus, axis, axis);
}

enum ts_status ts_projection_check_resolution(const struct ts_instance *self, struct tsim *sim)
{
	const struct ts_projection *p = self->state;
	const struct ts_fluid *fluid = &p->fluid;
	const double fastest = largest_speed(fluid);

	if (fluid->steps == 0 || !(fluid->viscosity > 0) || !(fastest > 0) || is_at_rest(fluid, fastest))
		return TS_OK;
	TS_TRY(report_wiggle(self, sim, fastest));
	for (int d = 0; d < fluid->grid.dimensions; d++)
		for (enum ts_grid_side side = TS_LOW; side <= TS_HIGH; side++)
			if (fluid->face[d][side] == TS_FLOW_WALL && fluid->grid.n[d] >= 3) {
				struct wall wall = find_wall(fluid, d, side);

				TS_TRY(report_wall(self, sim, &wall, fastest));
			}
	return TS_OK;
}
