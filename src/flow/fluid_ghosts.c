/* Values of ghost cells, by the boundary conditions. */
#include "flow/fluid.h"

#include "base/parallel.h"

#include "base/banned.h"

/* A line of values across a face: inner[0] is the first one inside, inner[step] the next, inner[-step] the
 * first ghost. */
enum rule {
	RULE_MIRROR, /* tangential component at a wall: the velocity given is that on the face */
	RULE_EVEN,   /* symmetric about the face */
	RULE_OUT,    /* zero gradient; 0 with backflow */
	RULE_ODD     /* value given on the face, which lies midway between two points */
};

static inline void fill_line(enum rule rule, double *inner, ptrdiff_t step, double given,
			     const double mirror[3])
{
	switch (rule) {
	case RULE_MIRROR:
		inner[-step] = mirror[0] * given + mirror[1] * inner[0] + mirror[2] * inner[step];
		inner[-2 * step] = 2 * inner[-step] - inner[0];
		break;
	case RULE_EVEN:
		inner[-step] = inner[0];
		inner[-2 * step] = inner[step];
		break;
	case RULE_OUT: /* given: 1 where the fluid leaves */
		inner[-step] = inner[-2 * step] = given * inner[0];
		break;
	case RULE_ODD:
		inner[-step] = 2 * given - inner[0];
		inner[-2 * step] = 2 * given - inner[step];
		break;
	}
}

/* The plane of lines across axis d: the other two axes and their ranges, ghosts included. */
struct plane {
	int d, a, b, from[3], to[3];
};

static struct plane plane_across(const struct ts_grid *grid, int d)
{
	struct plane plane = { .d = d, .a = d == 0, .b = d == 2 ? 1 : 2 };

	for (int k = 0; k < 3; k++) {
		plane.from[k] = -grid->ghosts[k];
		plane.to[k] = grid->n[k] + grid->ghosts[k];
	}
	return plane;
}

/* Rows [from, to) of the plane; a row is along its axis a. A line across d reads of other lines only
 * values that do not change, so that rows can be processed in parallel. */
static struct plane rows_across(const struct ts_grid *grid, int d, size_t from, size_t to)
{
	struct plane plane = plane_across(grid, d);

	plane.to[plane.b] = plane.from[plane.b] + (int)to;
	plane.from[plane.b] += (int)from;
	return plane;
}

/* Calls `share` for ranges of rows of the plane across d, in parallel; `rounds`: work per line, for the
 * number of threads. */
static void fill_rows_in_parallel(const struct ts_fluid *fluid, int d, int rounds, ts_range_fn *share,
				  void *task)
{
	struct plane plane = plane_across(&fluid->grid, d);
	size_t rows = (size_t)(plane.to[plane.b] - plane.from[plane.b]);
	size_t lines = rows * (size_t)(plane.to[plane.a] - plane.from[plane.a]);
	int team = ts_fluid_team(fluid, lines * (size_t)rounds);

	ts_parallel(rows < (size_t)team ? (int)rows : team, rows, share, task);
}

static inline ptrdiff_t plane_offset(const struct ts_grid *grid, const struct plane *plane, int ia, int ib)
{
	return (ptrdiff_t)grid->origin + ia * grid->stride[plane->a] + ib * grid->stride[plane->b];
}

static void wrap_periodic(const struct ts_grid *grid, double *field, const struct plane *plane)
{
	int d = plane->d, n = grid->n[d], g = grid->ghosts[d];
	ptrdiff_t s = grid->stride[d];

	for (int ib = plane->from[plane->b]; ib < plane->to[plane->b]; ib++)
		for (int ia = plane->from[plane->a]; ia < plane->to[plane->a]; ia++) {
			double *at = field + plane_offset(grid, plane, ia, ib);

			for (int k = 1; k <= g; k++) {
				at[-k * s] = at[(((-k) % n + n) % n) * s];
				at[(n - 1 + k) * s] = at[((k - 1) % n) * s];
			}
		}
}

static double given_velocity(const struct ts_flow_face_velocity *given, const struct ts_grid *grid, int d,
			     int c, int ia, int ib)
{
	return given->plane[c] ? given->plane[c][ts_flow_plane_at(grid, d, ia, ib)] : given->constant[c];
}

/* ---- the component across the face */

static void fill_across(const struct ts_fluid *fluid, double *u, const struct plane *plane,
			enum ts_grid_side side, bool keep)
{
	const struct ts_grid *grid = &fluid->grid;
	int d = plane->d;
	ptrdiff_t s = side == TS_LOW ? grid->stride[d] : -grid->stride[d];
	ptrdiff_t face = side == TS_LOW ? 0 : grid->n[d] * grid->stride[d];
	enum ts_flow_face kind = fluid->face[d][side];
	bool open = ts_flow_face_open(kind);

	for (int ib = plane->from[plane->b]; ib < plane->to[plane->b]; ib++)
		for (int ia = plane->from[plane->a]; ia < plane->to[plane->a]; ia++) {
			double *at = u + plane_offset(grid, plane, ia, ib) + face;
			double out = at[0] * (double)(side == TS_LOW ? -1 : 1);

			if (kind == TS_FLOW_SLIP && !keep)
				at[0] = 0;
			else if (!open && !keep)
				at[0] = given_velocity(&fluid->face_velocity[d][side], grid, d, d, ia, ib);
			at[-s] = !open ? 2 * at[0] - at[s] : out > 0 || kind == TS_FLOW_INTAKE ? at[0] : 0;
			at[-2 * s] = !open ? 2 * at[-s] - at[0] : at[-s];
		}
}

/* ---- components along the face */

/* 1 where the fluid leaves through an open face beside a point of component c, else 0. */
static double flows_out(const struct ts_grid *grid, const double *across, ptrdiff_t at, int c,
			enum ts_grid_side side)
{
	double u = across[at] + across[at - grid->stride[c]];

	return (side == TS_LOW ? -u : u) > 0;
}

static void fill_along(const struct ts_fluid *fluid, double *const u[3], int c, const struct plane *plane,
		       enum ts_grid_side side)
{
	const struct ts_grid *grid = &fluid->grid;
	int d = plane->d;
	ptrdiff_t s = side == TS_LOW ? grid->stride[d] : -grid->stride[d];
	ptrdiff_t first = side == TS_LOW ? 0 : (grid->n[d] - 1) * grid->stride[d];
	ptrdiff_t face = side == TS_LOW ? 0 : grid->n[d] * grid->stride[d];
	enum ts_flow_face kind = fluid->face[d][side];
	enum rule rule = kind == TS_FLOW_SLIP ? RULE_EVEN : ts_flow_face_open(kind) ? RULE_OUT : RULE_MIRROR;

	for (int ib = plane->from[plane->b]; ib < plane->to[plane->b]; ib++)
		for (int ia = plane->from[plane->a]; ia < plane->to[plane->a]; ia++) {
			ptrdiff_t at = plane_offset(grid, plane, ia, ib);
			bool lowest = (c == plane->a ? ia : ib) == -grid->ghosts[c];
			double given = 0;

			if (rule == RULE_MIRROR)
				given = given_velocity(&fluid->face_velocity[d][side], grid, d, c, ia, ib);
			else if (rule == RULE_OUT && !lowest)
				given = flows_out(grid, u[d], at + face, c, side);
			fill_line(rule, u[c] + at + first, s, given, fluid->ghost_weights[d][side]);
		}
}

struct velocity_task {
	const struct ts_fluid *fluid;
	double *const *u;
	int d;
	bool keep;
};

/* The component across the face comes first: its sign determines the ghosts of the others on open faces. */
static void velocity_rows(void *context, size_t from, size_t to)
{
	const struct velocity_task *task = context;
	const struct ts_grid *grid = &task->fluid->grid;
	struct plane plane = rows_across(grid, task->d, from, to);

	for (int turn = 0; turn < grid->dimensions; turn++) {
		int c = (task->d + turn) % grid->dimensions;

		if (grid->periodic[task->d]) {
			wrap_periodic(grid, task->u[c], &plane);
			continue;
		}
		for (int side = 0; side < 2; side++)
			if (turn == 0)
				fill_across(task->fluid, task->u[c], &plane, (enum ts_grid_side)side,
					    task->keep);
			else
				fill_along(task->fluid, task->u, c, &plane, (enum ts_grid_side)side);
	}
}

/* Axis by axis, each including the ghosts of the axes before it, so that edges and corners are set as
 * well. */
static void fill_velocity(const struct ts_fluid *fluid, double *const u[3], bool keep)
{
	struct velocity_task task = { .fluid = fluid, .u = u, .keep = keep };

	for (task.d = 0; task.d < fluid->grid.dimensions; task.d++)
		fill_rows_in_parallel(fluid, task.d, 2 * fluid->grid.dimensions, velocity_rows, &task);
}

void ts_fluid_fill_velocity(const struct ts_fluid *fluid, double *const u[3])
{
	fill_velocity(fluid, u, false);
}

void ts_fluid_fill_ghosts(const struct ts_fluid *fluid, double *const u[3])
{
	fill_velocity(fluid, u, true);
}

/* ---- centred fields */

/* `given` + `base`: value on the face, for RULE_ODD; NULL: 0. */
static void fill_centred_side(const struct ts_grid *grid, double *field, const struct plane *plane,
			      enum ts_grid_side side, enum rule rule,
			      const struct ts_flow_face_pressure *given, double base)
{
	int d = plane->d;
	ptrdiff_t s = side == TS_LOW ? grid->stride[d] : -grid->stride[d];
	ptrdiff_t first = side == TS_LOW ? 0 : (grid->n[d] - 1) * grid->stride[d];

	for (int ib = plane->from[plane->b]; ib < plane->to[plane->b]; ib++)
		for (int ia = plane->from[plane->a]; ia < plane->to[plane->a]; ia++) {
			double value = 0;

			if (given)
				value = base +
					ts_flow_face_pressure_at(given, ts_flow_plane_at(grid, d, ia, ib));
			fill_line(rule, field + plane_offset(grid, plane, ia, ib) + first, s, value, NULL);
		}
}

struct centred_task {
	const struct ts_fluid *fluid;
	double *field;
	int d;
	bool is_pressure;
	double base;
};

static void centred_rows(void *context, size_t from, size_t to)
{
	const struct centred_task *task = context;
	const struct ts_grid *grid = &task->fluid->grid;
	struct plane plane = rows_across(grid, task->d, from, to);

	if (grid->periodic[task->d]) {
		wrap_periodic(grid, task->field, &plane);
		return;
	}
	for (int side = 0; side < 2; side++) {
		bool given = task->is_pressure && ts_flow_face_open(task->fluid->face[task->d][side]);

		fill_centred_side(grid, task->field, &plane, (enum ts_grid_side)side,
				  given ? RULE_ODD : RULE_EVEN,
				  given ? &task->fluid->pressure[task->d][side] : NULL, task->base);
	}
}

static void fill_centred(const struct ts_fluid *fluid, double *field, bool is_pressure, double base)
{
	struct centred_task task = {
		.fluid = fluid, .field = field, .is_pressure = is_pressure, .base = base
	};

	for (task.d = 0; task.d < fluid->grid.dimensions; task.d++)
		fill_rows_in_parallel(fluid, task.d, 2, centred_rows, &task);
}

void ts_fluid_fill_centred(const struct ts_fluid *fluid, double *field)
{
	fill_centred(fluid, field, false, 0);
}

void ts_fluid_fill_pressure(const struct ts_fluid *fluid, double *p)
{
	fill_centred(fluid, p, true, fluid->pressure_base);
}

void ts_fluid_fill_relative(const struct ts_fluid *fluid, double *p)
{
	fill_centred(fluid, p, true, 0);
}

void ts_fluid_fill_periodic(const struct ts_fluid *fluid, double *field)
{
	struct centred_task task = { .fluid = fluid, .field = field };

	for (task.d = 0; task.d < fluid->grid.dimensions; task.d++)
		if (fluid->grid.periodic[task.d])
			fill_rows_in_parallel(fluid, task.d, 2, centred_rows, &task);
}
