/* Pressure given on open faces (outlets and intakes).
 *
 * The pressure P is given on the face itself, half a cell from the centre: the first ghost has
 * 2 P - p, and the contribution w (2/h) P / h of the face to the equation of the cell goes to the
 * right-hand side. Solvers use the difference from `base`, the mean of the largest and the smallest
 * pressure given: a level of 1e5 loses no digits, and equal pressures on all open faces are 0.
 *
 * In a stage of a time scheme the pressure acts as a mean over the stage: it is evaluated at the time
 * of the rates of the stage, in the middle for schemes of one stage, so that the order is kept. */
#include <math.h>
#include <stdio.h>

#include "flow/boundary.h"
#include "flow/flow_measures.h"
#include "flow/fluid_slabs.h"
#include "flow/projection.h"

#include "base/banned.h"

/* ---- planes of values: all points of a face, including those beside ghosts */

struct face_points {
	int a, b, from[2], to[2];
};

static struct face_points face_points_of(const struct ts_grid *grid, int d)
{
	struct face_points s = { .a = d == 0, .b = d == 2 ? 1 : 2 };

	s.from[0] = -grid->ghosts[s.a];
	s.from[1] = -grid->ghosts[s.b];
	s.to[0] = grid->n[s.a] + grid->ghosts[s.a];
	s.to[1] = grid->n[s.b] + grid->ghosts[s.b];
	return s;
}

static enum ts_status require_plane(const struct ts_grid *grid, int d, struct ts_flow_face_pressure *p)
{
	size_t n = ts_flow_plane_size(grid, d);

	if (p->plane)
		return TS_OK;
	p->plane = ts_alloc(n, sizeof *p->plane);
	for (size_t k = 0; p->plane && k < n; k++)
		p->plane[k] = p->constant;
	return p->plane ? TS_OK : TS_NOMEM;
}

static void free_plane(struct ts_flow_face_pressure *p)
{
	ts_free(p->plane);
	p->plane = NULL;
}

static enum ts_status copy_pressure(const struct ts_grid *grid, int d,
				    const struct ts_flow_face_pressure *from,
				    struct ts_flow_face_pressure *to)
{
	to->constant = from->constant;
	if (!from->plane) {
		free_plane(to);
		return TS_OK;
	}
	TS_TRY(require_plane(grid, d, to));
	for (size_t k = 0; k < ts_flow_plane_size(grid, d); k++)
		to->plane[k] = from->plane[k];
	return TS_OK;
}

static bool is_open(const struct ts_projection *p, int face)
{
	return ts_flow_face_open(p->fluid.face[face / 2][face % 2]);
}

/* ---- values given */

enum ts_status ts_projection_evaluate_pressure(struct ts_projection *p, struct tsim *sim, int d,
					       enum ts_grid_side side)
{
	const struct ts_flow_condition *condition = &p->condition[d][side];
	struct ts_flow_face_pressure *now = &p->pressure_now[d][side];
	const struct ts_flow_formula formula = { &condition->pressure, "pressure", TS_FLOW_CENTRES };

	if (!ts_flow_face_open(p->fluid.face[d][side])) {
		free_plane(now);
		now->constant = 0;
		return TS_OK;
	}
	if (!ts_flow_condition_shaped(condition) || !condition->pressure.variable) {
		free_plane(now);
		return ts_flow_formula_value(sim, condition, &formula, &now->constant);
	}
	if (require_plane(&p->fluid.grid, d, now) != TS_OK)
		return ts_nomem(&sim->error);
	return ts_flow_fill_plane(sim, condition, &formula, &p->fluid.grid, d, side, now->plane);
}

enum ts_status ts_projection_store_pressure(struct ts_projection *p)
{
	for (int face = 0; face < 6; face++)
		TS_TRY(copy_pressure(&p->fluid.grid, face / 2, &p->pressure_now[face / 2][face % 2],
				     &p->pressure_before[face / 2][face % 2]));
	return TS_OK;
}

/* Hydrostatic pressure at x of a fluid at rest under the body force, 0 at the upper end of the grid. Along
 * a periodic axis the body force is not balanced by a pressure. */
static double hydrostatic_pressure(const struct ts_fluid *fluid, const double x[3])
{
	const struct ts_grid *grid = &fluid->grid;
	double sum = 0;

	for (int a = 0; a < grid->dimensions; a++) {
		double g = fluid->body_force[a];

		if (g != 0 && !grid->periodic[a])
			sum += g * (x[a] - grid->face[a][g > 0 ? 0 : grid->n[a]]);
	}
	return fluid->density * sum;
}

/* Computes the pressure of the next projection on a face; updates the smallest and the largest value. */
static enum ts_status set_next_pressure(struct ts_projection *p, int d, int side, double extreme[2])
{
	const struct ts_grid *grid = &p->fluid.grid;
	const struct ts_flow_face_pressure *before = &p->pressure_before[d][side],
					   *now = &p->pressure_now[d][side];
	struct ts_flow_face_pressure *next = &p->pressure_next[d][side];
	const struct face_points s = face_points_of(grid, d);
	bool deep = p->condition[d][side].hydrostatic == TS_FLOW_HYDROSTATIC;
	double x[3];

	if (before->plane || now->plane || deep)
		TS_TRY(require_plane(grid, d, next));
	else
		free_plane(next);
	next->constant = ts_flow_interpolate_time(before->constant, now->constant, p->pressure_time);
	if (!next->plane) {
		extreme[0] = fmin(extreme[0], next->constant);
		extreme[1] = fmax(extreme[1], next->constant);
		return TS_OK;
	}
	x[d] = grid->face[d][side == TS_LOW ? 0 : grid->n[d]];
	for (int ib = s.from[1]; ib < s.to[1]; ib++)
		for (int ia = s.from[0]; ia < s.to[0]; ia++) {
			size_t k = ts_flow_plane_at(grid, d, ia, ib);
			double value =
				ts_flow_interpolate_time(ts_flow_face_pressure_at(before, k),
							 ts_flow_face_pressure_at(now, k), p->pressure_time);

			x[s.a] = ts_flow_coordinate(grid, s.a, TS_FLOW_CENTRES, ia);
			x[s.b] = ts_flow_coordinate(grid, s.b, TS_FLOW_CENTRES, ib);
			value += deep ? hydrostatic_pressure(&p->fluid, x) : 0;
			next->plane[k] = value;
			extreme[0] = fmin(extreme[0], value);
			extreme[1] = fmax(extreme[1], value);
		}
	return TS_OK;
}

/* Subtracts `base`. */
static void make_relative(const struct ts_grid *grid, int d, struct ts_flow_face_pressure *p, double base)
{
	p->constant -= base;
	for (size_t k = 0; p->plane && k < ts_flow_plane_size(grid, d); k++)
		p->plane[k] -= base;
}

static enum ts_status set_next_pressures(struct ts_projection *p)
{
	double extreme[2] = { INFINITY, -INFINITY };

	for (int face = 0; face < 6; face++) {
		struct ts_flow_face_pressure *next = &p->pressure_next[face / 2][face % 2];

		if (is_open(p, face) && !p->initial_projection) {
			TS_TRY(set_next_pressure(p, face / 2, face % 2, extreme));
			continue;
		}
		free_plane(next);
		next->constant = 0;
	}
	p->next_pressure_base = p->initial_projection ? 0 : p->level_now;
	if (extreme[0] <= extreme[1])
		p->next_pressure_base = 0.5 * (extreme[0] + extreme[1]);
	for (int face = 0; face < 6; face++)
		if (is_open(p, face) && !p->initial_projection)
			make_relative(&p->fluid.grid, face / 2, &p->pressure_next[face / 2][face % 2],
				      p->next_pressure_base);
	return TS_OK;
}

/* ---- in a projection */

/* of <- next - of */
static enum ts_status make_difference(const struct ts_grid *grid, int d,
				      const struct ts_flow_face_pressure *next,
				      struct ts_flow_face_pressure *of)
{
	if (next->plane)
		TS_TRY(require_plane(grid, d, of));
	of->constant = next->constant - of->constant;
	for (size_t k = 0; of->plane && k < ts_flow_plane_size(grid, d); k++)
		of->plane[k] = ts_flow_face_pressure_at(next, k) - of->plane[k];
	return TS_OK;
}

static void swap_pressure(struct ts_flow_face_pressure *a, struct ts_flow_face_pressure *b)
{
	const struct ts_flow_face_pressure keep = *a;

	*a = *b;
	*b = keep;
}

static void swap_face_pressures(struct ts_projection *p)
{
	for (int face = 0; face < 6; face++)
		swap_pressure(&p->fluid.pressure[face / 2][face % 2], &p->pressure_next[face / 2][face % 2]);
}

static void add_constant(const struct ts_projection *p, double *field, double by)
{
	if (by == 0)
		return;
	for (int range = 0; range < ts_fluid_ranges(&p->fluid); range++) {
		size_t first, end;

		ts_fluid_range_values(&p->fluid, range, &first, &end);
#pragma omp parallel for num_threads(p->poisson.threads) schedule(static)
		for (size_t k = first; k < end; k++)
			field[k] += by;
	}
}

/* Adds the contribution of the pressure on an open face to rhs. */
static void add_face_to_rhs(struct ts_projection *p, int d, int side, double sign)
{
	const struct ts_grid *grid = &p->fluid.grid;
	const struct ts_flow_face_pressure *given = &p->fluid.pressure[d][side];
	const int a = d == 0, b = d == 2 ? 1 : 2, cell = side == TS_LOW ? 0 : grid->n[d] - 1;
	const size_t to_face = side == TS_LOW ? 0 : (size_t)grid->stride[d];
	const double factor = sign * ts_poisson_conductance(&p->poisson, d, side == TS_LOW ? 0 : grid->n[d]) /
			      grid->width[d][cell];
	const double *weight = p->poisson.weight[d];
	size_t first, end;

	if (!given->plane && given->constant == 0)
		return;
	ts_slabs_own(&p->slabs, (size_t)grid->n[2], &first, &end);
	if (d == 2 && ((size_t)cell < first || (size_t)cell >= end))
		return;
	for (int ib = d < 2 ? (int)first : 0; ib < (d < 2 ? (int)end : grid->n[b]); ib++)
		for (int ia = 0; ia < grid->n[a]; ia++) {
			size_t at =
				ts_at(grid, 0, 0, 0) + (size_t)(cell * grid->stride[d] +
								ia * grid->stride[a] + ib * grid->stride[b]);
			double w = weight ? weight[at + to_face] : 1;

			p->rhs[at] -= factor * w *
				      ts_flow_face_pressure_at(given, ts_flow_plane_at(grid, d, ia, ib));
		}
}

static void add_faces_to_rhs(struct ts_projection *p, double sign)
{
	for (int face = 0; face < 6; face++)
		if (is_open(p, face))
			add_face_to_rhs(p, face / 2, face % 2, sign);
}

enum ts_status ts_projection_impose_pressure(struct ts_projection *p)
{
	struct ts_fluid *fluid = &p->fluid;

	TS_TRY(set_next_pressures(p));
	if (fluid->incremental)
		for (int face = 0; face < 6; face++)
			TS_TRY(make_difference(&fluid->grid, face / 2, &p->pressure_next[face / 2][face % 2],
					       &fluid->pressure[face / 2][face % 2]));
	else {
		swap_face_pressures(p);
		add_constant(p, fluid->p, -fluid->pressure_base);
	}
	add_faces_to_rhs(p, 1);
	return TS_OK;
}

void ts_projection_restore_pressure(struct ts_projection *p)
{
	struct ts_fluid *fluid = &p->fluid;

	if (fluid->incremental) {
		add_faces_to_rhs(p, -1);
		swap_face_pressures(p);
		add_constant(p, fluid->p, p->next_pressure_base - fluid->pressure_base);
	} else {
		add_constant(p, fluid->p, p->next_pressure_base);
	}
	fluid->pressure_base = p->next_pressure_base;
	if (!fluid->incremental && fluid->pressure_base != 0) /* the bits of ghosts with which a run begins */
		ts_fluid_fill_pressure(fluid, fluid->p);
}

/* ---- restart */

static enum ts_status archive_one(struct ts_projection *p, struct tsim *sim, struct ts_archive *archive,
				  const char *what, int face, struct ts_flow_face_pressure *given)
{
	const struct ts_grid *grid = &p->fluid.grid;
	bool writing = ts_archive_writing(archive);
	char name[48];

	snprintf(name, sizeof name, "pressure_%s_%d", what, face);
	if (writing ? given->constant == 0 && !given->plane : !ts_archive_has(archive, name))
		return TS_OK;
	TS_TRY(ts_archive_fixed(archive, name, TS_SAVED_F64, &given->constant, 1));
	snprintf(name, sizeof name, "pressure_%s_plane_%d", what, face);
	if (writing ? !given->plane : !ts_archive_has(archive, name))
		return TS_OK;
	if (require_plane(grid, face / 2, given) != TS_OK)
		return ts_nomem(&sim->error);
	return ts_archive_fixed(archive, name, TS_SAVED_F64, given->plane,
				ts_flow_plane_size(grid, face / 2));
}

enum ts_status ts_projection_archive_pressure(struct ts_projection *p, struct tsim *sim,
					      struct ts_archive *archive)
{
	double *base = &p->fluid.pressure_base;

	for (int face = 0; face < 6; face++) {
		TS_TRY(archive_one(p, sim, archive, "before", face, &p->pressure_before[face / 2][face % 2]));
		TS_TRY(archive_one(p, sim, archive, "held", face, &p->fluid.pressure[face / 2][face % 2]));
	}
	if (ts_archive_writing(archive) ? *base == 0 : !ts_archive_has(archive, "pressure_base"))
		return TS_OK;
	return ts_archive_fixed(archive, "pressure_base", TS_SAVED_F64, base, 1);
}

void ts_projection_release_pressure(struct ts_projection *p)
{
	for (int face = 0; face < 6; face++) {
		free_plane(&p->pressure_before[face / 2][face % 2]);
		free_plane(&p->pressure_now[face / 2][face % 2]);
		free_plane(&p->pressure_next[face / 2][face % 2]);
	}
}

/* ---- checks */

/* An axis along the face, not periodic, with a body force; -1 if there is none. A formula counts as a body
 * force whatever its present value. */
static int force_along(const struct ts_projection *p, int d)
{
	const struct ts_grid *grid = &p->fluid.grid;

	for (int a = 0; a < grid->dimensions; a++)
		if (a != d && !grid->periodic[a] &&
		    (p->body_force[a].variable || p->body_force[a].value != 0))
			return a;
	return -1;
}

enum ts_status ts_projection_check_pressure(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_projection *p = self->state;

	for (int face = 0; face < 6; face++) {
		const struct ts_flow_condition *condition = &p->condition[face / 2][face % 2];
		bool formula = ts_flow_condition_shaped(condition) && condition->pressure.variable;
		int a = force_along(p, face / 2);

		if (!is_open(p, face))
			continue;
		if (a >= 0 && condition->hydrostatic == TS_FLOW_PRESSURE_UNSAID && !formula)
			return ts_fail(&sim->error, TS_STATE, &condition->where,
				       "flow_boundary %s: the body_force of flow_style acts along this face, "
				       "along %c, and the pressure on it is uniform: that would drive a jet "
				       "through it; give it `hydrostatic yes`, with which a fluid at rest "
				       "stays at rest, or `hydrostatic no` if the pressure outside is "
				       "uniform",
				       ts_flow_face_names[face], "xyz"[a]);
		if (p->level.variable || p->level.value != 0)
			return ts_fail(&sim->error, TS_STATE, ts_instance_word(self, "pressure_level"),
				       "flow_style projection: pressure_level is for a fluid without open "
				       "faces; here flow_boundary %s gives the pressure: use `pressure P` "
				       "there",
				       ts_flow_face_names[face]);
	}
	return TS_OK;
}
