/* Values of ghost cells, by the boundary conditions. */
#include <math.h>

#include "flow/fluid_slabs.h"

#include "base/clones.h"
#include "base/inline.h"
#include "base/parallel.h"

#include "base/banned.h"

/* A line of values across a face: inner[0] is the first one inside, or on the face for the component across it,
 * inner[step] the next, inner[-step] the first ghost. */
enum rule {
	RULE_MIRROR, /* tangential component at a wall: the velocity given is that on the face */
	RULE_EVEN,   /* symmetric about the face */
	RULE_OUT,    /* zero gradient where the fluid leaves; less with backflow. Given: part_kept */
	RULE_ODD,    /* value given on the face, which lies midway between two points */
	/* the component across the face: */
	RULE_SET,   /* given on the face, continued by a straight line */
	RULE_KEEP,  /* continued by a straight line */
	RULE_LEAVE, /* zero gradient; 0 with backflow. Given: 1 where the fluid leaves, else 0 */
};

enum { LINES = 64 }; /* at most this number of lines is filled at a time */

TS_INLINE void fill_line(enum rule rule, double *inner, ptrdiff_t step, double given, const double mirror[3])
{
	const double first = inner[0], next = inner[step];

	switch (rule) {
	case RULE_MIRROR:
		inner[-step] = mirror[0] * given + mirror[1] * first + mirror[2] * next;
		inner[-2 * step] = 2 * inner[-step] - first;
		break;
	case RULE_EVEN:
		inner[-step] = first;
		inner[-2 * step] = next;
		break;
	case RULE_OUT:
		inner[-step] = inner[-2 * step] = given * first;
		break;
	case RULE_ODD:
		inner[-step] = 2 * given - first;
		inner[-2 * step] = 2 * given - next;
		break;
	case RULE_SET:
		inner[0] = given;
		inner[-step] = 2 * given - next;
		inner[-2 * step] = 2 * inner[-step] - given;
		break;
	case RULE_KEEP:
		inner[-step] = 2 * first - next;
		inner[-2 * step] = 2 * inner[-step] - first;
		break;
	case RULE_LEAVE:
		inner[-step] = inner[-2 * step] = given > 0 ? first : 0;
		break;
	}
}

/* Lines beside each other. */
struct lines {
	double *inner; /* of the first line */
	ptrdiff_t step;
	int n;
	const double *given, *mirror; /* of each line; weights of RULE_MIRROR */
};

/* `along`: distance of neighbouring lines. */
TS_INLINE void fill_lines_by(enum rule rule, const struct lines *lines, ptrdiff_t along)
{
	const ptrdiff_t step = lines->step;
	const double *given = lines->given, *mirror = lines->mirror;
	double *inner = lines->inner;

#pragma omp simd
	for (int m = 0; m < lines->n; m++)
		fill_line(rule, inner + m * along, step, given[m], mirror);
}

/* One loop for each rule. */
TS_INLINE void fill_lines(enum rule rule, const struct lines *lines, ptrdiff_t along)
{
	switch (rule) {
	case RULE_MIRROR:
		fill_lines_by(RULE_MIRROR, lines, along);
		break;
	case RULE_EVEN:
		fill_lines_by(RULE_EVEN, lines, along);
		break;
	case RULE_OUT:
		fill_lines_by(RULE_OUT, lines, along);
		break;
	case RULE_ODD:
		fill_lines_by(RULE_ODD, lines, along);
		break;
	case RULE_SET:
		fill_lines_by(RULE_SET, lines, along);
		break;
	case RULE_KEEP:
		fill_lines_by(RULE_KEEP, lines, along);
		break;
	case RULE_LEAVE:
		fill_lines_by(RULE_LEAVE, lines, along);
		break;
	}
}

TS_CLONES
static void fill_neighbouring_lines(enum rule rule, const struct lines *lines)
{
	fill_lines(rule, lines, 1);
}

/* The plane of lines across axis d: the other two axes and their ranges, ghosts included. */
struct plane {
	int d, a, b, from[3], to[3];
};

/* `range`: of planes that have the present values (fluid->planes), for axes before the last one. */
static struct plane plane_across(const struct ts_fluid *fluid, int d, int range)
{
	const struct ts_grid *grid = &fluid->grid;
	struct plane plane = { .d = d, .a = d == 0, .b = d == 2 ? 1 : 2 };

	for (int k = 0; k < 3; k++) {
		plane.from[k] = -grid->ghosts[k];
		plane.to[k] = grid->n[k] + grid->ghosts[k];
	}
	if (ts_fluid_divided(fluid) && d < 2) {
		plane.from[2] = fluid->planes.range[range].from;
		plane.to[2] = fluid->planes.range[range].to;
	}
	return plane;
}

/* Rows [from, to) of the plane; a row is along its axis a. A line across d reads of other lines only
 * values that do not change, so that rows can be processed in parallel. */
static struct plane rows_of(const struct plane *across, size_t from, size_t to)
{
	struct plane plane = *across;

	plane.to[plane.b] = plane.from[plane.b] + (int)to;
	plane.from[plane.b] += (int)from;
	return plane;
}

/* Whether the planes with present values have this face, or its ghosts. */
static bool has_face(const struct ts_fluid *fluid, int d, enum ts_grid_side side)
{
	const struct ts_fluid_planes *planes = &fluid->planes;
	bool has = planes->ranges == 0 || d < 2;

	for (int k = 0; k < planes->ranges; k++)
		has |= side == TS_LOW ? planes->range[k].from <= 0 : planes->range[k].to > fluid->grid.n[2];
	return has;
}

/* Calls `share` for ranges of rows of the plane across d, in parallel; `rounds`: work per line, for the
 * number of threads. *across, which `share` reads, is set before. */
static void fill_rows_in_parallel(const struct ts_fluid *fluid, int d, int rounds, ts_range_fn *share,
				  void *task, struct plane *across)
{
	const int ranges = d < 2 ? ts_fluid_ranges(fluid) : 1;

	if (!has_face(fluid, d, TS_LOW) && !has_face(fluid, d, TS_HIGH))
		return;
	for (int range = 0; range < ranges; range++) {
		size_t rows, lines;
		int team;

		*across = plane_across(fluid, d, range);
		rows = (size_t)(across->to[across->b] - across->from[across->b]);
		lines = rows * (size_t)(across->to[across->a] - across->from[across->a]);
		team = ts_fluid_team(fluid, lines * (size_t)rounds);
		ts_parallel(rows < (size_t)team ? (int)rows : team, rows, share, task);
	}
}

static inline ptrdiff_t plane_offset(const struct ts_grid *grid, const struct plane *plane, int ia, int ib)
{
	return (ptrdiff_t)grid->origin + ia * grid->stride[plane->a] + ib * grid->stride[plane->b];
}

static void wrap_periodic(const struct ts_grid *grid, double *field, const struct plane *plane)
{
	int d = plane->d, n = grid->n[d], g = grid->ghosts[d];
	ptrdiff_t s = grid->stride[d];
	const bool simple = g <= n; /* no image of an image */

	for (int ib = plane->from[plane->b]; ib < plane->to[plane->b]; ib++)
		for (int ia = plane->from[plane->a]; ia < plane->to[plane->a]; ia++) {
			double *at = field + plane_offset(grid, plane, ia, ib);

			for (int k = 1; k <= g; k++) {
				at[-k * s] = at[(simple ? n - k : ((-k) % n + n) % n) * s];
				at[(n - 1 + k) * s] = at[(simple ? k - 1 : (k - 1) % n) * s];
			}
		}
}

/* ---- lines across a face */

/* What a rule reads of the lines from (ia, ib) on: the values given there, or what decides on an open face. */
struct source {
	const struct ts_grid *grid;
	const double *plane;	/* of values given; NULL: `constant` */
	double constant[LINES]; /* the same number, or computed by `find` */
	void (*find)(struct source *source, const struct plane *plane, int ia, int ib, int n);
	const double *across; /* component across the face, */
	ptrdiff_t face;	      /* on it, relative to the cells of the lowest layer */
	int c;		      /* component that is filled */
	double out;	      /* sign of velocities out of the grid */
	double exchange;      /* see part_kept, velocity */
	const struct ts_fluid *fluid;
};

static void fill_face(double *field, enum rule rule, const struct plane *plane, ptrdiff_t first,
		      ptrdiff_t step, const double *mirror, struct source *source)
{
	const struct ts_grid *grid = source->grid;
	const ptrdiff_t along = grid->stride[plane->a];

	for (int ib = plane->from[plane->b]; ib < plane->to[plane->b]; ib++)
		for (int ia = plane->from[plane->a]; ia < plane->to[plane->a]; ia += LINES) {
			const int left = plane->to[plane->a] - ia;
			struct lines lines = { .inner = field + plane_offset(grid, plane, ia, ib) + first,
					       .step = step,
					       .n = left < LINES ? left : LINES,
					       .given = source->constant,
					       .mirror = mirror };

			if (source->find)
				source->find(source, plane, ia, ib, lines.n);
			else if (source->plane)
				lines.given = source->plane + ts_flow_plane_at(grid, plane->d, ia, ib);
			if (along == 1)
				fill_neighbouring_lines(rule, &lines);
			else
				fill_lines(rule, &lines, along);
		}
}

static void set_constant(struct source *source, double value)
{
	for (int m = 0; m < LINES; m++)
		source->constant[m] = value;
}

static void give_velocity(struct source *source, const struct ts_flow_face_velocity *given, int c)
{
	source->plane = given->plane[c];
	set_constant(source, given->constant[c]);
}

/* Layers of cells or faces beside the face, from inside: distance of neighbours, first cell, face. */
struct layers {
	ptrdiff_t step, cell, face;
};

static struct layers layers_beside(const struct ts_grid *grid, int d, enum ts_grid_side side)
{
	const ptrdiff_t s = grid->stride[d];

	return side == TS_LOW ? (struct layers){ s, 0, 0 }
			      : (struct layers){ -s, (grid->n[d] - 1) * s, grid->n[d] * s };
}

/* ---- the component across the face */

/* 1 where the fluid leaves through an open face. */
static void find_leaving(struct source *source, const struct plane *plane, int ia, int ib, int n)
{
	const ptrdiff_t along = source->grid->stride[plane->a];
	const double *u = source->across + plane_offset(source->grid, plane, ia, ib) + source->face;

	for (int m = 0; m < n; m++)
		source->constant[m] = u[m * along] * source->out > 0;
}

/* The lines outside of the faces of the other two axes: their values on the face are those given, not those of a step. */
static void set_outer_lines(const struct ts_grid *grid, double *u, const struct plane *plane,
			    const struct layers *at, struct source *source)
{
	const int axes[2] = { plane->a, plane->b };

	for (int k = 0; k < 2; k++) {
		struct plane below = *plane, above = *plane;
		const int axis = axes[k];

		below.to[axis] = below.to[axis] < 0 ? below.to[axis] : 0;
		above.from[axis] = above.from[axis] > grid->n[axis] ? above.from[axis] : grid->n[axis];
		fill_face(u, RULE_SET, &below, at->face, at->step, NULL, source);
		fill_face(u, RULE_SET, &above, at->face, at->step, NULL, source);
	}
}

static void fill_across(const struct ts_fluid *fluid, double *u, const struct plane *plane,
			enum ts_grid_side side, bool keep)
{
	const int d = plane->d;
	const struct layers at = layers_beside(&fluid->grid, d, side);
	const enum ts_flow_face kind = fluid->face[d][side];
	const bool open = ts_flow_face_open(kind);
	struct source source = { .grid = &fluid->grid, .across = u, .face = at.face };

	source.out = side == TS_LOW ? -1 : 1;
	if (kind == TS_FLOW_INTAKE)
		set_constant(&source, 1);
	else if (open)
		source.find = find_leaving;
	else if (kind != TS_FLOW_SLIP)
		give_velocity(&source, &fluid->face_velocity[d][side], d);
	fill_face(u, open ? RULE_LEAVE : keep ? RULE_KEEP : RULE_SET, plane, at.face, at.step, NULL, &source);
	if (!open && keep)
		set_outer_lines(&fluid->grid, u, plane, &at, &source);
}

/* ---- components along the face */

/* The velocity across the open face where it meets the face `edge` of the axis of component c: that given on the latter, or
 * that of the cell beside it. Ghosts would be those of the fill before. ia, ib: the point of the component. */
static double velocity_at_edge(const struct source *source, const struct plane *plane, int ia, int ib,
			       enum ts_grid_side edge)
{
	const struct ts_grid *grid = source->grid;
	const int c = source->c, d = plane->d, a = c == 0, b = c == 2 ? 1 : 2;
	const struct ts_flow_face_velocity *given = &source->fluid->face_velocity[c][edge];
	const enum ts_flow_face kind = source->fluid->face[c][edge];
	int at[3];

	at[plane->a] = ia;
	at[plane->b] = ib;
	at[d] = source->out < 0 ? 0 : grid->n[d];
	at[c] = edge == TS_LOW ? 0 : grid->n[c] - 1;
	if (ts_flow_face_open(kind) || kind == TS_FLOW_SLIP)
		return source->across[plane_offset(grid, plane, at[plane->a], at[plane->b]) + source->face];
	return given->plane[d] ? given->plane[d][ts_flow_plane_at(grid, c, at[a], at[b])]
			       : given->constant[d];
}

/* Which part of the velocity along an open face the fluid outside has: all of it where the fluid leaves or none passes; where
 * it enters with the velocity u, which should bring no momentum, nu/(nu + |u| h). So the shear on the face, nu/h times what
 * is missing, is at most what the flow through it carries, and it vanishes with the flow, whatever the sign of round-off.
 * exchange: nu/h, h the width of the cell inside. */
static inline double part_kept(double outwards, double exchange)
{
	return outwards >= 0 ? 1 : exchange / (exchange - outwards);
}

/* part_kept beside points of the component. */
static void find_part_kept(struct source *source, const struct plane *plane, int ia, int ib, int n)
{
	const struct ts_grid *grid = source->grid;
	const ptrdiff_t along = grid->stride[plane->a], below = grid->stride[source->c];
	const double *u = source->across + plane_offset(grid, plane, ia, ib) + source->face;
	const bool varies = source->c == plane->a;
	const int lowest = -grid->ghosts[source->c], end = grid->n[source->c];

	for (int m = 0; m < n; m++) {
		const int i = varies ? ia + m : ib;
		double through = 0; /* there is none below the lowest */

		if (!grid->periodic[source->c] && (i <= 0 || i >= end))
			through = velocity_at_edge(source, plane, ia + m, ib, i > 0 ? TS_HIGH : TS_LOW);
		else if (i > lowest)
			through = 0.5 * (u[m * along] + u[m * along - below]);
		source->constant[m] = part_kept(through * source->out, source->exchange);
	}
}

static void fill_along(const struct ts_fluid *fluid, double *const u[3], int c, const struct plane *plane,
		       enum ts_grid_side side)
{
	const int d = plane->d;
	const struct layers at = layers_beside(&fluid->grid, d, side);
	const enum ts_flow_face kind = fluid->face[d][side];
	const bool open = ts_flow_face_open(kind);
	const enum rule rule = kind == TS_FLOW_SLIP ? RULE_EVEN : open ? RULE_OUT : RULE_MIRROR;
	struct source source = {
		.grid = &fluid->grid, .across = u[d], .face = at.face, .c = c, .fluid = fluid
	};

	source.out = side == TS_LOW ? -1 : 1;
	source.exchange = fluid->viscosity /
			  (fluid->density * fluid->grid.width[d][side == TS_LOW ? 0 : fluid->grid.n[d] - 1]);
	if (rule == RULE_OUT)
		source.find = find_part_kept;
	else if (rule == RULE_MIRROR)
		give_velocity(&source, &fluid->face_velocity[d][side], c);
	fill_face(u[c], rule, plane, at.cell, at.step, fluid->ghost_weights[d][side], &source);
}

struct velocity_task {
	const struct ts_fluid *fluid;
	double *const *u;
	int d;
	bool keep;
	bool along; /* fills the components along the faces, else that across them */
	struct plane across;
};

static void velocity_rows(void *context, size_t from, size_t to)
{
	const struct velocity_task *task = context;
	const struct ts_grid *grid = &task->fluid->grid;
	const struct plane plane = rows_of(&task->across, from, to);

	for (int turn = task->along; turn < (task->along ? grid->dimensions : 1); turn++) {
		int c = (task->d + turn) % grid->dimensions;

		if (grid->periodic[task->d]) {
			wrap_periodic(grid, task->u[c], &plane);
			continue;
		}
		for (int side = 0; side < 2; side++) {
			if (!has_face(task->fluid, task->d, (enum ts_grid_side)side))
				continue;
			if (turn == 0)
				fill_across(task->fluid, task->u[c], &plane, (enum ts_grid_side)side,
					    task->keep);
			else
				fill_along(task->fluid, task->u, c, &plane, (enum ts_grid_side)side);
		}
	}
}

/* The flow beside a place decides there (find_part_kept). */
bool ts_fluid_leans_on_images(const struct ts_fluid *fluid, int d)
{
	const struct ts_grid *grid = &fluid->grid;
	bool later = false;

	for (int axis = d + 1; axis < grid->dimensions; axis++)
		later |= grid->periodic[axis];
	return later && !grid->periodic[d] &&
	       (ts_flow_face_open(fluid->face[d][TS_LOW]) || ts_flow_face_open(fluid->face[d][TS_HIGH]));
}

/* Axis by axis, each including the ghosts of the axes before it, so that edges and corners are set as
 * well. Of each component first the ghosts across its faces, so that edges do not depend on the order of the axes: the sign
 * of these velocities determines the ghosts of the others on open faces, and what is given on an inlet is what a wall beside
 * it mirrors. */
static void fill_velocity(const struct ts_fluid *fluid, double *const u[3], bool keep)
{
	const int components = fluid->grid.dimensions;
	struct velocity_task task = { .fluid = fluid, .u = u, .keep = keep };
	bool first = false; /* images, before all */

	for (int d = 0; d < components; d++)
		first |= ts_fluid_leans_on_images(fluid, d);
	for (int part = 0; part < 2 && first; part++) {
		task.along = part > 0;
		for (task.d = 1; task.d < components; task.d++)
			if (fluid->grid.periodic[task.d])
				fill_rows_in_parallel(fluid, task.d, components, velocity_rows, &task,
						      &task.across);
	}
	for (int part = 0; part < 2; part++) {
		task.along = part > 0;
		for (task.d = 0; task.d < components; task.d++)
			fill_rows_in_parallel(fluid, task.d, part ? 2 * components - 2 : 2, velocity_rows,
					      &task, &task.across);
	}
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

/* Values of pressure on the face, relative to `base` where they are given. */
struct face_pressure {
	struct source source; /* first */
	double base;
};

static void find_face_pressure(struct source *source, const struct plane *plane, int ia, int ib, int n)
{
	const double *given = source->plane + ts_flow_plane_at(source->grid, plane->d, ia, ib);

	for (int m = 0; m < n; m++)
		source->constant[m] = ((const struct face_pressure *)source)->base + given[m];
}

/* `given` + `base`: value on the face, for RULE_ODD; NULL: none, the field is symmetric. */
static void fill_centred_side(const struct ts_grid *grid, double *field, const struct plane *plane,
			      enum ts_grid_side side, const struct ts_flow_face_pressure *given, double base)
{
	const struct layers at = layers_beside(grid, plane->d, side);
	struct face_pressure pressure = { { .grid = grid }, base };

	if (given && given->plane) {
		pressure.source.plane = given->plane;
		pressure.source.find = find_face_pressure;
	} else if (given) {
		set_constant(&pressure.source, base + given->constant);
	}
	fill_face(field, given ? RULE_ODD : RULE_EVEN, plane, at.cell, at.step, NULL, &pressure.source);
}

struct centred_task {
	const struct ts_fluid *fluid;
	double *field;
	int d;
	bool is_pressure;
	double base;
	struct plane across;
};

static void centred_rows(void *context, size_t from, size_t to)
{
	const struct centred_task *task = context;
	const struct ts_grid *grid = &task->fluid->grid;
	const struct plane plane = rows_of(&task->across, from, to);

	if (grid->periodic[task->d]) {
		wrap_periodic(grid, task->field, &plane);
		return;
	}
	for (int side = 0; side < 2; side++) {
		if (!has_face(task->fluid, task->d, (enum ts_grid_side)side))
			continue;
		bool given = task->is_pressure && ts_flow_face_open(task->fluid->face[task->d][side]);

		fill_centred_side(grid, task->field, &plane, (enum ts_grid_side)side,
				  given ? &task->fluid->pressure[task->d][side] : NULL, task->base);
	}
}

static void fill_centred(const struct ts_fluid *fluid, double *field, bool is_pressure, double base)
{
	struct centred_task task = {
		.fluid = fluid, .field = field, .is_pressure = is_pressure, .base = base
	};

	for (task.d = 0; task.d < fluid->grid.dimensions; task.d++)
		fill_rows_in_parallel(fluid, task.d, 2, centred_rows, &task, &task.across);
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
			fill_rows_in_parallel(fluid, task.d, 2, centred_rows, &task, &task.across);
}
