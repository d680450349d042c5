/* Set-up of a projection before its first step: grid, fields, operators. */
#include <math.h>
#include <string.h>

#include "base/alloc.h"
#include "box/domain.h"
#include "flow/boundary.h"
#include "flow/projection.h"
#include "flow/slab_step.h"
#include "region/region.h"

#include "base/banned.h"

enum ts_status ts_projection_require(struct tsim *sim, const char *who, const struct ts_place *where,
				     struct ts_instance **instance, struct ts_projection **out)
{
	struct ts_fluid *fluid;

	TS_TRY(ts_flow_require_fluid(sim, who, where, &fluid));
	*instance = ts_sim_only(sim, TS_KIND_FLOW);
	if (!ts_streq((*instance)->style->family, TS_FAMILY_PROJECTION))
		return ts_fail(&sim->error, TS_STATE, where, "%s needs flow_style projection, not %s", who,
			       (*instance)->style->name);
	*out = (*instance)->state;
	return TS_OK;
}

/* ---- bounds of the grid */

static enum ts_status grid_bounds(struct ts_instance *self, struct tsim *sim, double lo[3], double hi[3])
{
	struct ts_projection *p = self->state;
	const struct ts_box *box = &sim->domain->box;

	TS_TRY(ts_domain_require(sim, &self->where));
	memcpy(lo, box->lo, sizeof box->lo);
	memcpy(hi, box->hi, sizeof box->hi);
	if (p->region) {
		TS_TRY(ts_region_update(p->region, sim));
		ts_region_bounds(p->region, lo, hi);
	}
	for (int d = 0; d < 3 && !p->region; d++)
		if (box->face[d][0] > TS_FACE_FIXED || box->face[d][1] > TS_FACE_FIXED)
			return ts_fail(&sim->error, TS_STATE, &self->where,
				       "flow_style projection: the box follows the particles along %c, the "
				       "grid cannot: use boundary p or f, or a region for the grid",
				       "xyz"[d]);
	for (int d = 0; d < 3; d++) { /* an unbounded region (INF) ends at the box */
		lo[d] = fmax(lo[d], box->lo[d]);
		hi[d] = fmin(hi[d], box->hi[d]);
		if (!(hi[d] > lo[d]))
			return ts_fail(&sim->error, TS_RANGE, &self->where,
				       "flow_style projection: the region of the grid has no part in the box "
				       "along %c",
				       "xyz"[d]);
	}
	return TS_OK;
}

static bool spans_box(const struct ts_box *box, int d, double lo, double hi)
{
	double small = 1e-12 * ts_box_length(box, d);

	return fabs(lo - box->lo[d]) <= small && fabs(hi - box->hi[d]) <= small;
}

static enum ts_status check_cells(struct ts_instance *self, struct tsim *sim, const bool periodic[3])
{
	const struct ts_projection *p = self->state;
	int dimensions = p->cells[2] == 1 ? 2 : 3;

	if (sim->dimension == 2 && dimensions == 3)
		return ts_fail(&sim->error, TS_RANGE, &self->where,
			       "flow_style projection: in two dimensions there is one cell along z");
	for (int d = 0; d < dimensions; d++)
		if (p->cells[d] < 2 && !periodic[d])
			return ts_fail(&sim->error, TS_RANGE, &self->where,
				       "flow_style projection: there must be at least two cells between the "
				       "boundaries along %c; for a flow in a plane take one along z",
				       "xyz"[d]);
	return TS_OK;
}

/* Whether the present grid has these faces and periodic axes. */
static bool same_grid(const struct ts_grid *grid, const double *const face[3], const bool periodic[3])
{
	for (int d = 0; d < 3; d++) {
		if (!grid->memory || grid->periodic[d] != periodic[d])
			return false;
		if (memcmp(grid->face[d], face[d], (size_t)(grid->n[d] + 1) * sizeof(double)) != 0)
			return false;
	}
	return true;
}

/* Makes the grid anew if it has changed. Fields depend only on the numbers of cells: they are kept if
 * lengths change. */
static enum ts_status remake_grid(struct ts_projection *p, const double *const face[3],
				  const bool periodic[3], bool sparse)
{
	struct ts_fluid *fluid = &p->fluid;
	const int n[3] = { (int)p->cells[0], (int)p->cells[1], (int)p->cells[2] };

	if (same_grid(&fluid->grid, face, periodic) && p->rhs)
		return TS_OK;
	p->pressure = NULL;
	ts_operators_release(&p->operators);
	ts_grid_release(&fluid->grid);
	TS_TRY(ts_grid_make(&fluid->grid, n[2] == 1 ? 2 : 3, n, face, periodic));
	fluid->grid.sparse = sparse;
	fluid->grids++;
	TS_TRY(ts_operators_make(&p->operators, &fluid->grid));
	TS_TRY(ts_fluid_make(fluid));
	for (int d = 0; d < 3; d++)
		if (!p->work[d] && !(p->work[d] = ts_grid_field(&fluid->grid)))
			return TS_NOMEM;
	if (!p->rhs)
		p->rhs = ts_grid_field(&fluid->grid);
	return p->rhs ? TS_OK : TS_NOMEM;
}

/* Fields that every projection has: velocity, predictor, pressure, right-hand side. */
enum { FIELDS = 8 };

static double count_cells(const struct ts_projection *p)
{
	return (double)p->cells[0] * (double)p->cells[1] * (double)p->cells[2];
}

/* Whether the machine has the memory of the fields, or of the part of a rank: more is granted, and the process ended when it
 * is used. */
static bool fits_memory(const struct ts_projection *p, const struct tsim *sim)
{
	const double there = ts_alloc_available();
	const int parts = sim->world && p->cells[2] >= TS_GRID_GHOSTS * sim->world->n ? sim->world->n : 1;

	return !(there > 0) || FIELDS * sizeof(double) * count_cells(p) / parts <= there;
}

static enum ts_status fail_out_of_memory(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_projection *p = self->state;
	double cells = count_cells(p);

	return ts_fail(&sim->error, TS_NOMEM, &p->cell_words.word[0].place,
		       "flow_style projection: out of memory: %lld x %lld x %lld cells need %.3g GB for the "
		       "fluid's fields alone; take fewer",
		       (long long)p->cells[0], (long long)p->cells[1], (long long)p->cells[2],
		       FIELDS * sizeof(double) * cells / 1e9);
}

static enum ts_status make_grid(struct ts_instance *self, struct tsim *sim)
{
	struct ts_projection *p = self->state;
	struct ts_arena arena = { 0 };
	double lo[3], hi[3], *face[3];
	enum ts_status status = TS_OK;
	bool periodic[3];

	TS_TRY(grid_bounds(self, sim, lo, hi));
	for (int d = 0; d < 3; d++)
		periodic[d] = ts_box_periodic(&sim->domain->box, d) &&
			      spans_box(&sim->domain->box, d, lo[d], hi[d]);
	TS_TRY(check_cells(self, sim, periodic));
	if (!fits_memory(p, sim))
		return fail_out_of_memory(self, sim);
	for (int d = 0; d < 3 && status == TS_OK; d++) {
		int n = (int)p->cells[d];

		face[d] = ts_arena_alloc(&arena, (size_t)n + 1, sizeof *face[d]);
		for (int i = 0; face[d] && i <= n; i++)
			face[d][i] =
				lo[d] + (hi[d] - lo[d]) * (p->graded[d] ? p->graded[d][i] : (double)i / n);
		if (!face[d])
			status = TS_NOMEM;
		else
			face[d][n] = hi[d];
	}
	if (status == TS_OK)
		status = remake_grid(p, (const double *const *)face, periodic, sim->world);
	ts_arena_release(&arena);
	return status == TS_NOMEM ? fail_out_of_memory(self, sim) : status;
}

/* ---- the grid to which the fields belong */

static bool flows(const struct ts_fluid *fluid)
{
	bool any = false;

	for (int d = 0; d < fluid->grid.dimensions && fluid->u[d]; d++)
		for (size_t k = 0; k < fluid->grid.size; k++)
			any |= fluid->u[d][k] != 0;
	return any;
}

/* Whether the grid has other faces than the fields, by more than round-off of formulas for them. */
static bool faces_differ(const struct ts_projection *p)
{
	static const double SMALL = 1e-9; /* of the length of the axis */
	const struct ts_grid *grid = &p->fluid.grid;

	for (int d = 0; d < grid->dimensions; d++) {
		const double *face = grid->face[d];

		for (int i = 0; p->field_face[d] && i <= grid->n[d]; i++)
			if (fabs(face[i] - p->field_face[d][i]) > SMALL * (face[grid->n[d]] - face[0]))
				return true;
	}
	return false;
}

enum ts_status ts_projection_keep_faces(struct ts_projection *p)
{
	const struct ts_grid *grid = &p->fluid.grid;

	for (int d = 0; d < 3; d++) {
		size_t n = (size_t)grid->n[d] + 1;

		if (!p->field_face[d] && !(p->field_face[d] = ts_alloc(n, sizeof *p->field_face[d])))
			return TS_NOMEM;
		memcpy(p->field_face[d], grid->face[d], n * sizeof *p->field_face[d]);
	}
	return TS_OK;
}

enum ts_status ts_projection_begin_on_grid(struct ts_instance *self, struct tsim *sim)
{
	struct ts_projection *p = self->state;

	p->fluid.stretched = faces_differ(p);
	if (p->fluid.stretched && flows(&p->fluid))
		ts_warn(&sim->log, &self->where,
			"flow_style projection: the grid has changed (flow_grid, region, change_box or "
			"replicate) since the fluid was set, has moved or was written to the restart file: "
			"each cell keeps its velocity, so that the flow is stretched with the cells");
	return ts_projection_keep_faces(p) == TS_OK ? TS_OK : ts_nomem(&sim->error);
}

/* ---- set-up */

enum ts_status ts_projection_setup(struct ts_instance *self, struct tsim *sim)
{
	struct ts_projection *p = self->state;
	struct ts_fluid *fluid = &p->fluid;

	TS_TRY(make_grid(self, sim));
	fluid->grid.by_depth = sim->dimension == 2;
	fluid->density = p->density;
	fluid->viscosity = p->viscosity;
	fluid->threads = sim->threads;
	fluid->grain = sim->grain;
	p->poisson.threads = ts_team(sim, ts_grid_cells(&fluid->grid));
	if (ts_slabs_make(&p->slabs, sim->world, fluid->grid.n[2]) != TS_OK)
		return ts_nomem(&sim->error);
	p->poisson.slabs = &p->slabs;
	fluid->slabs = &p->slabs;
	if (ts_slab_step_set_up(p, sim, ts_flow_style_of(self)->blocks(sim)) != TS_OK)
		return ts_nomem(&sim->error);
	TS_TRY(ts_projection_set_face_types(self, sim));
	TS_TRY(ts_projection_evaluate_boundary(self, sim));
	p->ghosts_filled = false;
	ts_projection_interpolate_boundary(p, 0); /* the fields are those of the last step */
	if (ts_projection_not_started(p))
		ts_fluid_fill_velocity(fluid, fluid->u);
	else
		ts_fluid_fill_ghosts(fluid, fluid->u);
	ts_fluid_fill_pressure(fluid, fluid->p);
	ts_slab_step_end(p);
	return TS_OK;
}

void ts_projection_release(struct ts_projection *p)
{
	ts_fluid_release(&p->fluid);
	ts_operators_release(&p->operators);
	ts_slabs_release(&p->slabs);
	for (int d = 0; d < 3; d++) {
		ts_grid_field_free(p->work[d]);
		ts_grid_field_free(p->second_stage[d]);
		ts_grid_field_free(p->history[d]);
		ts_grid_field_free(p->weight[d]);
		ts_grid_field_free(p->void_before[d]);
		ts_grid_field_free(p->void_rate[d]);
		ts_grid_field_free(p->void_start[d]);
		ts_grid_field_free(p->void_stage[d]);
		ts_free(p->graded[d]);
		ts_free(p->field_face[d]);
		for (int side = 0; side < 2; side++) {
			ts_fluid_face_velocity_release(&p->velocity_now[d][side]);
			ts_fluid_face_velocity_release(&p->velocity_before[d][side]);
		}
	}
	ts_projection_release_pressure(p);
	ts_grid_field_free(p->rhs);
	ts_grid_field_free(p->increment);
	ts_grid_field_free(p->void_fraction_before);
}
