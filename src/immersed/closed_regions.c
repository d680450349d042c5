#include "immersed/closed_regions.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "flow/flow_measures.h"
#include "flow/projection.h"
#include "flow/fluid_slabs.h"
#include "immersed/connected_cells.h"
#include "immersed/covered_faces.h"

#include "base/banned.h"

/* Largest net flow of bodies into a region, by the sum of the magnitudes, that may be an error of the
 * staircase shape of the surface on the grid. */
static const double STEPS = 0.1;

/* Relative imbalance of flows that is not round-off. */
static const double UNEVEN = 1e-9;

/* A region narrower than this number of cells is not resolved: a gap that closes, or a corner. */
enum { WIDE = 3 };

enum { NO_REGION = -1 }; /* of a cell connected to the outside, or alone inside a body */

struct region {
	/* flow into it through faces of the grid (volume/time): sum, and sum of magnitudes */
	double net, gross;
	double pushed, push; /* the same for flow from bodies */
	int lo[3], hi[3];    /* range of its cells */
	int face;	     /* face of the grid with the largest flow: 2 d + side; -1: none */
	double most;	     /* that flow */
	bool unknown;	     /* the motion of a body beside it is not known yet */
	uint16_t body;	     /* a body beside it, counted from 1; 0: none */
	double place[3];     /* mean position of the faces between the region and that body */
	size_t ends;	     /* number of these faces */
};

struct body {
	const struct ts_instance *self;
	const struct ts_solid *solid;
	enum ts_immersed_motion motion;
};

struct ts_closed_search {
	struct ts_projection *p;
	const struct ts_grid *grid;
	ts_face_owners owner; /* of lower faces: the body that prescribes the velocity */
	struct ts_connected_cells cells;
	int32_t *region_of_run;
	struct body *body;
	struct ts_covered_faces *faces; /* of each body */
	size_t nbodies, body_capacity, faces_capacity;
	struct region *region;
	size_t nregions, region_capacity;
	bool varies; /* velocities given at a region, or under a body, change with time */
	enum ts_status status;
};

void ts_closed_search_add_body(struct ts_closed_search *s, const struct ts_instance *self,
			       const struct ts_immersed *ib, const struct ts_solid *solid,
			       enum ts_immersed_motion motion)
{
	if (s->status != TS_OK || s->nbodies == UINT16_MAX)
		return;
	if (TS_GROW(s->body, s->body_capacity, s->nbodies + 1) != TS_OK ||
	    TS_GROW(s->faces, s->faces_capacity, s->nbodies + 1) != TS_OK) {
		s->status = TS_NOMEM;
		return;
	}
	s->body[s->nbodies] = (struct body){ self, solid, motion };
	s->faces[s->nbodies] = (struct ts_covered_faces){ 0 };
	s->status = ts_covered_faces_find(&s->faces[s->nbodies++], ib);
}

/* ---- cells and their faces */

/* The region of a cell; NO_REGION also for cells beyond the grid. */
static int32_t region_of_cell(const struct ts_closed_search *s, const int i[3])
{
	for (int d = 0; d < 3; d++)
		if (i[d] < 0 || i[d] >= s->grid->n[d])
			return NO_REGION;
	return s->region_of_run[ts_connected_cells_run(&s->cells, i)];
}

/* The regions on both sides of a lower face across axis d. */
struct sides {
	int32_t below, above;
};

static struct sides regions_beside(const struct ts_closed_search *s, const int i[3], int d)
{
	int below[3] = { i[0], i[1], i[2] };

	below[d] = i[d] > 0 || !s->grid->periodic[d] ? i[d] - 1 : s->grid->n[d] - 1;
	return (struct sides){ region_of_cell(s, below), region_of_cell(s, i) };
}

static double face_area(const struct ts_grid *grid, const int i[3], int d)
{
	double area = 1;

	for (int a = 0; a < 3; a++)
		area *= a == d ? 1 : grid->width[a][i[a]];
	return area;
}

static bool is_open(const struct ts_closed_search *s, int d, int side)
{
	return ts_flow_face_open(s->p->fluid.face[d][side]);
}

/* The normal velocity given on the boundary at this cell; 0 on open and slip faces. */
static double given_normal_velocity(const struct ts_closed_search *s, const int i[3], int d, int side)
{
	const struct ts_flow_face_velocity *now = &s->p->velocity_now[d][side];
	int a = d == 0, b = d == 2 ? 1 : 2;

	if (is_open(s, d, side) || s->p->fluid.face[d][side] == TS_FLOW_SLIP)
		return 0;
	return now->plane[d] ? now->plane[d][ts_flow_plane_at(s->grid, d, i[a], i[b])] : now->constant[d];
}

/* Whether that velocity may change in the next step. */
static bool given_velocity_varies(const struct ts_closed_search *s, int d, int side)
{
	const struct ts_flow_condition *condition = &s->p->condition[d][side];

	return !is_open(s, d, side) && condition->velocity[d].variable && !condition->once;
}

/* ---- regions */

static void open_faces(struct ts_closed_search *s)
{
	for (int d = 0; d < s->grid->dimensions; d++)
		for (int side = 0; side < 2; side++)
			if (is_open(s, d, side))
				ts_connected_cells_open_face(&s->cells, s->owner, d, (enum ts_grid_side)side);
}

static void extend_range(struct region *region, const int first[3], const int last[3])
{
	for (int d = 0; d < 3; d++) {
		region->lo[d] = first[d] < region->lo[d] ? first[d] : region->lo[d];
		region->hi[d] = last[d] > region->hi[d] ? last[d] : region->hi[d];
	}
}

/* Adds a run of a closed set to its region, which begins with the first run. */
static enum ts_status add_run(struct ts_closed_search *s, size_t run, const int first[3], const int last[3])
{
	const size_t set = s->cells.set[run];
	struct region *region;

	if (set == run) {
		TS_TRY(TS_GROW(s->region, s->region_capacity, s->nregions + 1));
		region = &s->region[s->nregions];
		*region = (struct region){ .face = -1 };
		memcpy(region->lo, first, sizeof region->lo);
		memcpy(region->hi, last, sizeof region->hi);
		s->region_of_run[run] = (int32_t)s->nregions++;
		return TS_OK;
	}
	s->region_of_run[run] = s->region_of_run[set];
	extend_range(&s->region[s->region_of_run[run]], first, last);
	return TS_OK;
}

/* Makes a region of each closed set of cells. */
static enum ts_status find_regions(struct ts_closed_search *s)
{
	const struct ts_connected_cells *cells = &s->cells;
	size_t row = 0;

	s->region_of_run = ts_alloc(cells->nruns, sizeof *s->region_of_run);
	if (!s->region_of_run)
		return TS_NOMEM;
	for (int k = 0; k < s->grid->n[2]; k++)
		for (int j = 0; j < s->grid->n[1]; j++, row++)
			for (size_t run = cells->row[row]; run < cells->row[row + 1]; run++) {
				const bool more = run + 1 < cells->row[row + 1];
				const int first[3] = { cells->begin[run], j, k };
				const int last[3] = { (more ? cells->begin[run + 1] : s->grid->n[0]) - 1, j,
						      k };

				s->region_of_run[run] = NO_REGION;
				if (cells->set[run] != 0)
					TS_TRY(add_run(s, run, first, last));
			}
	return TS_OK;
}

/* ---- flow from the faces of the grid */

static void add_boundary_face(struct ts_closed_search *s, struct region *region, const int i[3], int d,
			      int side)
{
	double flow = given_normal_velocity(s, i, d, side) * face_area(s->grid, i, d) * (side ? -1 : 1);

	region->net += flow;
	region->gross += fabs(flow);
	if (fabs(flow) > region->most) {
		region->most = fabs(flow);
		region->face = 2 * d + side;
	}
}

static void add_boundary(struct ts_closed_search *s, int d, int side)
{
	const struct ts_flow_face_velocity *now = &s->p->velocity_now[d][side];
	const struct ts_grid *grid = s->grid;
	const bool varies = given_velocity_varies(s, d, side);
	int a = d == 0, b = d == 2 ? 1 : 2, i[3];

	if (is_open(s, d, side) || (!varies && !now->plane[d] && now->constant[d] == 0))
		return;
	i[d] = side ? grid->n[d] - 1 : 0;
	for (i[b] = 0; i[b] < grid->n[b]; i[b]++)
		for (i[a] = 0; i[a] < grid->n[a]; i[a]++) {
			int32_t region = region_of_cell(s, i);

			if (region == NO_REGION)
				continue;
			s->varies |= varies;
			add_boundary_face(s, &s->region[region], i, d, side);
		}
}

static void add_boundaries(struct ts_closed_search *s)
{
	for (int d = 0; d < s->grid->dimensions; d++)
		for (int side = 0; side < 2; side++)
			if (!s->grid->periodic[d])
				add_boundary(s, d, side);
}

/* ---- flow from bodies */

static bool is_single_cell(const struct region *region)
{
	return memcmp(region->lo, region->hi, sizeof region->lo) == 0;
}

/* A cell inside a body is no region. */
static bool is_inside_body(const struct region *region)
{
	return is_single_cell(region) && region->gross == 0;
}

/* Adds the face at x between a region and a body. */
static void add_body_face(struct ts_closed_search *s, int32_t beside, const double x[3], uint16_t body)
{
	struct region *region;

	if (beside == NO_REGION)
		return;
	region = &s->region[beside];
	region->unknown |= s->body[body - 1].motion == TS_BODY_UNKNOWN;
	if (!region->body)
		region->body = body;
	if (region->body != body)
		return;
	region->ends++;
	for (int a = 0; a < 3; a++)
		region->place[a] += (x[a] - region->place[a]) / (double)region->ends;
}

static void add_body_flow(struct ts_closed_search *s, int32_t into, double flow)
{
	struct region *region;

	if (into == NO_REGION || is_inside_body(&s->region[into]))
		return;
	region = &s->region[into];
	region->pushed += flow;
	region->push += fabs(flow);
}

/* Adds one face that the body covers to the regions on both sides. */
static void add_covered_face(struct ts_closed_search *s, uint16_t number, int c,
			     const struct ts_covered_face *face)
{
	const struct ts_grid *grid = s->grid;
	const bool driven = s->body[number - 1].motion == TS_BODY_DRIVEN;
	struct sides beside;
	double x[3], flow;
	int i[3];

	ts_grid_indices(grid, face->at, i);
	beside = regions_beside(s, i, c);
	if (beside.below == NO_REGION && beside.above == NO_REGION)
		return;
	for (int a = 0; a < 3; a++)
		x[a] = a == c ? grid->face[a][i[a]] : grid->centre[a][i[a]];
	if (s->owner[c][face->at] == number) {
		add_body_face(s, beside.below, x, number);
		add_body_face(s, beside.above, x, number);
	}
	if (!driven || i[c] >= grid->n[c] || (i[c] == 0 && !grid->periodic[c]) ||
	    beside.below == beside.above)
		return;
	flow = face->velocity * face_area(grid, i, c);
	add_body_flow(s, beside.above, flow);
	add_body_flow(s, beside.below, -flow);
}

static void add_bodies(struct ts_closed_search *s)
{
	for (size_t body = 0; body < s->nbodies; body++) {
		const struct ts_covered_faces *faces = &s->faces[body];

		for (int c = 0; c < s->grid->dimensions; c++)
			for (size_t k = faces->first[c]; k < faces->first[c + 1]; k++)
				add_covered_face(s, (uint16_t)(body + 1), c, &faces->face[k]);
	}
}

/* ---- errors */

/* "fix dam (immersed/boundary region dam)" */
static void body_name(const struct body *body, char *out, size_t size)
{
	const struct ts_instance *self = body->self;
	size_t words = body->motion == TS_BODY_FREE ? 1 : 2; /* spheres have no name of their own */
	int n = snprintf(out, size, "fix %s (%s", self->id, self->style->name);

	for (size_t k = 0; k < words && k < self->words.n && n > 0 && (size_t)n < size; k++)
		n += snprintf(out + n, size - (size_t)n, " %s", self->words.word[k].text);
	if (n > 0 && (size_t)n < size)
		snprintf(out + n, size - (size_t)n, ")");
}

static bool is_resolved(const struct ts_closed_search *s, const struct region *region)
{
	for (int d = 0; d < s->grid->dimensions; d++)
		if (region->hi[d] - region->lo[d] + 1 < WIDE && s->grid->n[d] >= WIDE)
			return false;
	return true;
}

static enum ts_status check_region(const struct ts_closed_search *s, struct tsim *sim,
				   const struct region *region)
{
	const struct ts_instance *self = region->body ? s->body[region->body - 1].self : NULL;
	double net = region->net + region->pushed, gross = region->gross + region->push;
	const double *x = region->place;
	char name[256];

	if (!self || region->unknown || fabs(net) <= (region->push > 0 ? STEPS : UNEVEN) * gross)
		return TS_OK;
	body_name(&s->body[region->body - 1], name, sizeof name);
	if (region->gross > UNEVEN * gross)
		return ts_fail(&sim->error, TS_PHYSICS, &self->where,
			       "%s: the body closes off the fluid beside flow_boundary %s about (%.4g %.4g "
			       "%.4g): through the faces of the grid it flows %s there at %g per time, and "
			       "there is no way to an outlet; leave a gap of a cell or more, or make the "
			       "velocities given there balance",
			       name, ts_flow_face_names[region->face], x[0], x[1], x[2],
			       region->net < 0 ? "out" : "in", fabs(region->net));
	if (!is_resolved(s, region))
		return TS_OK;
	return ts_fail(&sim->error, TS_PHYSICS, &self->where,
		       "%s: the body %s fluid at %g per time that it closes off about (%.4g %.4g %.4g), and "
		       "which has no way to an outlet; leave a gap of a cell or more, or give that part an "
		       "outlet (flow_boundary)",
		       name, net > 0 ? "pushes" : "draws", fabs(net), x[0], x[1], x[2]);
}

/* ---- bodies on inlets */

static bool is_near_face(const struct ts_grid *grid, int d, int side, const double lo[3], const double hi[3])
{
	double x = grid->face[d][side ? grid->n[d] : 0];

	return lo[d] <= x && x <= hi[d];
}

/* Refuses a part of a body that covers an inlet where the fluid enters with another velocity than that of
 * the body. */
static enum ts_status check_inlet(struct ts_closed_search *s, struct tsim *sim, const struct body *body,
				  size_t part, int d, int side)
{
	const struct ts_grid *grid = s->grid;
	const struct ts_solid *solid = body->solid;
	int a = d == 0, b = d == 2 ? 1 : 2, i[3] = { 0 };
	bool varies = given_velocity_varies(s, d, side);
	double x[3], v[3];
	char name[256];

	x[d] = grid->face[d][side ? grid->n[d] : 0];
	for (i[b] = 0; i[b] < grid->n[b]; i[b]++)
		for (i[a] = 0; i[a] < grid->n[a]; i[a]++) {
			double given = given_normal_velocity(s, i, d, side);

			x[a] = grid->centre[a][i[a]];
			x[b] = grid->centre[b][i[b]];
			if ((given == 0 && !varies) || !solid->kind->inside(solid, part, x))
				continue;
			s->varies |= varies;
			ts_solid_velocity(&solid->motion[part], x, v);
			if (given == 0 || body->motion == TS_BODY_UNKNOWN ||
			    fabs(given - v[d]) <= UNEVEN * fabs(given))
				continue;
			body_name(body, name, sizeof name);
			return ts_fail(&sim->error, TS_PHYSICS, &body->self->where,
				       "%s: the body stands on flow_boundary %s, at (%.4g %.4g %.4g), where "
				       "fluid is to cross the face with velocity %g and the body has %g: "
				       "move it off, or give there the velocity of the body, by a formula "
				       "with `set`",
				       name, ts_flow_face_names[2 * d + side], x[0], x[1], x[2], given, v[d]);
		}
	return TS_OK;
}

static enum ts_status check_inlets(struct ts_closed_search *s, struct tsim *sim)
{
	for (size_t k = 0; k < s->nbodies; k++)
		for (size_t part = 0; part < s->body[k].solid->parts; part++) {
			const struct ts_solid *solid = s->body[k].solid;
			double lo[3], hi[3];

			solid->kind->bounds(solid, part, lo, hi);
			for (int face = 0; face < 2 * s->grid->dimensions; face++)
				if (!s->grid->periodic[face / 2] &&
				    is_near_face(s->grid, face / 2, face % 2, lo, hi))
					TS_TRY(check_inlet(s, sim, &s->body[k], part, face / 2, face % 2));
		}
	return TS_OK;
}

/* ---- the whole search */

static void mark_bodies(struct ts_closed_search *s, struct tsim *sim)
{
	struct ts_instance *part;

	for (size_t k = 0; (part = ts_sim_next_of(sim, TS_KIND_FIX, TS_FAMILY_FLOW_PART, &k));) {
		const struct ts_flow_part *flow_part = part->state;

		if (flow_part->mark_closed)
			flow_part->mark_closed(part, s);
	}
}

static enum ts_status allocate_owners(struct ts_closed_search *s)
{
	for (int d = 0; d < s->grid->dimensions; d++)
		if (!(s->owner[d] = ts_alloc(s->grid->size, sizeof **s->owner)))
			return TS_NOMEM;
	return TS_OK;
}

static void mark_faces(struct ts_closed_search *s)
{
	for (size_t body = 0; body < s->nbodies; body++) {
		const struct ts_covered_faces *faces = &s->faces[body];

		for (int c = 0; c < s->grid->dimensions; c++)
			for (size_t k = faces->first[c]; k < faces->first[c + 1]; k++)
				s->owner[c][faces->face[k].at] = (uint16_t)(body + 1);
	}
}

static enum ts_status find_closed_regions(struct ts_closed_search *s)
{
	TS_TRY(allocate_owners(s));
	mark_faces(s);
	TS_TRY(ts_connected_cells_find(&s->cells, s->grid, s->owner));
	open_faces(s);
	ts_connected_cells_complete(&s->cells);
	TS_TRY(find_regions(s));
	add_boundaries(s);
	add_bodies(s);
	return TS_OK;
}

static enum ts_status search_regions(struct ts_closed_search *s, struct tsim *sim)
{
	if (find_closed_regions(s) != TS_OK)
		return ts_nomem(&sim->error);
	for (size_t k = 0; k < s->nregions; k++)
		if (!is_inside_body(&s->region[k]))
			TS_TRY(check_region(s, sim, &s->region[k]));
	return TS_OK;
}

/* While ranks have some planes only, the first one gets what bodies cover in all of them, and looks for closed regions. */
static enum ts_status check_regions(struct ts_closed_search *s, struct tsim *sim)
{
	struct ts_world *world = ts_fluid_divided(&s->p->fluid) ? s->p->slabs.world : NULL;

	mark_bodies(s, sim);
	if (s->status != TS_OK)
		return ts_nomem(&sim->error);
	if (s->nbodies == 0)
		return TS_OK;
	TS_TRY(check_inlets(s, sim));
	if (world && ts_covered_faces_gather(world, s->faces, s->nbodies) != TS_OK)
		return ts_nomem(&sim->error);
	if (!world || world->rank == 0)
		TS_TRY(search_regions(s, sim));
	if (world)
		ts_world_spread(world, 0, &s->varies, sizeof s->varies);
	return TS_OK;
}

enum ts_status ts_immersed_check_closed(struct tsim *sim)
{
	struct ts_instance *flow = ts_sim_only(sim, TS_KIND_FLOW);
	struct ts_closed_search s = { 0 };
	enum ts_status status;

	if (!flow || !ts_streq(flow->style->family, TS_FAMILY_PROJECTION))
		return TS_OK;
	s.p = flow->state;
	s.grid = &s.p->fluid.grid;
	status = check_regions(&s, sim);
	s.p->check_closed = s.varies ? ts_immersed_check_closed : NULL;
	for (int d = 0; d < 3; d++)
		ts_free(s.owner[d]);
	ts_connected_cells_release(&s.cells);
	ts_free(s.region_of_run);
	for (size_t k = 0; k < s.nbodies; k++)
		ts_covered_faces_release(&s.faces[k]);
	ts_free(s.faces);
	ts_free(s.body);
	ts_free(s.region);
	return status;
}
