#include "immersed/closed_regions.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "flow/flow_measures.h"
#include "flow/projection.h"

#include "base/banned.h"

/* Largest net flow of bodies into a region, by the sum of the magnitudes, that may be an error of the
 * staircase shape of the surface on the grid. */
static const double STEPS = 0.1;

/* Relative imbalance of flows that is not round-off. */
static const double UNEVEN = 1e-9;

/* A region narrower than this number of cells is not resolved: a gap that closes, or a corner. */
enum { WIDE = 3 };

/* Labels of cells. */
enum { OUTSIDE = -1, UNLABELLED = 0, FREE = 1, FIRST_REGION = 2 };

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
	const struct ts_immersed *ib;
	const struct ts_solid *solid;
	enum ts_immersed_motion motion;
};

struct ts_closed_search {
	struct ts_projection *p;
	const struct ts_grid *grid;
	uint16_t *owner[3]; /* of lower faces: the body that prescribes the velocity, from 1; 0: none */
	int32_t *label;	    /* of cells */
	size_t *stack, nstack;
	struct body *body;
	size_t nbodies, body_capacity;
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
	s->status = TS_GROW(s->body, s->body_capacity, s->nbodies + 1);
	if (s->status != TS_OK)
		return;
	s->body[s->nbodies++] = (struct body){ self, ib, solid, motion };
	for (int c = 0; c < s->grid->dimensions; c++)
		for (size_t k = ib->first[c]; k < ib->first[c + 1]; k++)
			if (!ib->point[k].outside)
				s->owner[c][ib->point[k].at] = (uint16_t)s->nbodies;
}

/* ---- cells and their faces */

/* One face of a cell: its index in the field of the component, and the cell across. */
struct link {
	size_t face, cell;
	bool boundary; /* there is no cell across */
};

static struct link neighbour_link(const struct ts_grid *grid, size_t at, const int i[3], int d, int side)
{
	const size_t s = (size_t)grid->stride[d], all = (size_t)grid->n[d] * s;
	bool last = i[d] == (side ? grid->n[d] - 1 : 0);
	struct link link = { side ? at + s : at, side ? at + s : at - s, last && !grid->periodic[d] };

	if (last && grid->periodic[d]) {
		link.face = side ? at + s - all : at;
		link.cell = side ? at + s - all : at - s + all;
	}
	return link;
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

/* ---- flood fill */

static void label_cell(struct ts_closed_search *s, size_t cell, int32_t label)
{
	if (s->label[cell] != UNLABELLED)
		return;
	s->label[cell] = label;
	s->stack[s->nstack++] = cell;
}

static void add_body_face(struct ts_closed_search *s, struct region *region, const int i[3], int d, int side,
			  uint16_t body)
{
	double x[3];

	for (int a = 0; a < 3; a++)
		x[a] = a == d ? s->grid->face[a][i[a] + side] : s->grid->centre[a][i[a]];
	region->unknown |= s->body[body - 1].motion == TS_BODY_UNKNOWN;
	if (!region->body)
		region->body = body;
	if (region->body != body)
		return;
	region->ends++;
	for (int a = 0; a < 3; a++)
		region->place[a] += (x[a] - region->place[a]) / (double)region->ends;
}

static void add_boundary_face(struct ts_closed_search *s, struct region *region, const int i[3], int d,
			      int side)
{
	double flow = given_normal_velocity(s, i, d, side) * face_area(s->grid, i, d) * (side ? -1 : 1);

	s->varies |= given_velocity_varies(s, d, side);
	region->net += flow;
	region->gross += fabs(flow);
	if (fabs(flow) > region->most) {
		region->most = fabs(flow);
		region->face = 2 * d + side;
	}
}

/* Labels all cells connected to the cell on the stack, and sums up the flow into them. */
static void fill_closed_region(struct ts_closed_search *s, int32_t label, struct region *region)
{
	while (s->nstack) {
		size_t at = s->stack[--s->nstack];
		int i[3];

		ts_grid_indices(s->grid, at, i);
		for (int d = 0; d < s->grid->dimensions; d++) {
			region->lo[d] = i[d] < region->lo[d] ? i[d] : region->lo[d];
			region->hi[d] = i[d] > region->hi[d] ? i[d] : region->hi[d];
			for (int side = 0; side < 2; side++) {
				struct link link = neighbour_link(s->grid, at, i, d, side);
				uint16_t body = s->owner[d][link.face];

				if (!link.boundary && !body)
					label_cell(s, link.cell, label);
				if (body)
					add_body_face(s, region, i, d, side, body);
				if (link.boundary)
					add_boundary_face(s, region, i, d, side);
			}
		}
	}
}

#define EACH_CELL(grid, i)                                  \
	for (i[2] = 0; i[2] < (grid)->n[2]; i[2]++)         \
		for (i[1] = 0; i[1] < (grid)->n[1]; i[1]++) \
			for (i[0] = 0; i[0] < (grid)->n[0]; i[0]++)

/* Labels the cell across a face of a free cell as free, unless a body prescribes the velocity of the face.
 * In most cases the cell across is the neighbour in memory. */
static inline void label_neighbor(struct ts_closed_search *s, size_t at, int d, int side)
{
	const size_t stride = (size_t)s->grid->stride[d];
	size_t cell = side ? at + stride : at - stride, face = side ? cell : at;
	struct link link;
	int i[3];

	if (s->label[cell] == UNLABELLED) {
		if (!s->owner[d][face])
			label_cell(s, cell, FREE);
		return;
	}
	if (s->label[cell] != OUTSIDE || !s->grid->periodic[d])
		return;
	ts_grid_indices(s->grid, at, i);
	link = neighbour_link(s->grid, at, i, d, side);
	if (!s->owner[d][link.face])
		label_cell(s, link.cell, FREE);
}

/* Labels all cells connected to an open face. */
static void fill_from_face(struct ts_closed_search *s, int d, int side)
{
	const struct ts_grid *grid = s->grid;
	int a = d == 0, b = d == 2 ? 1 : 2, i[3];

	i[d] = side ? grid->n[d] - 1 : 0;
	for (i[b] = 0; i[b] < grid->n[b]; i[b]++)
		for (i[a] = 0; i[a] < grid->n[a]; i[a]++) {
			size_t at = ts_at(grid, i[0], i[1], i[2]);

			if (!s->owner[d][side ? at + (size_t)grid->stride[d] : at])
				label_cell(s, at, FREE);
		}
	while (s->nstack) {
		size_t at = s->stack[--s->nstack];

		for (int e = 0; e < grid->dimensions; e++) {
			label_neighbor(s, at, e, TS_LOW);
			label_neighbor(s, at, e, TS_HIGH);
		}
	}
}

static void fill_from_open_faces(struct ts_closed_search *s)
{
	for (int d = 0; d < s->grid->dimensions; d++)
		for (int side = 0; side < 2; side++)
			if (is_open(s, d, side))
				fill_from_face(s, d, side);
}

static enum ts_status fill_closed_regions(struct ts_closed_search *s)
{
	int i[3];

	EACH_CELL(s->grid, i)
	{
		size_t at = ts_at(s->grid, i[0], i[1], i[2]);
		struct region region = { .face = -1 };
		int32_t label = FIRST_REGION + (int32_t)s->nregions;

		if (s->label[at] != UNLABELLED)
			continue;
		memcpy(region.lo, i, sizeof region.lo);
		memcpy(region.hi, i, sizeof region.hi);
		label_cell(s, at, label);
		fill_closed_region(s, label, &region);
		if (memcmp(region.lo, region.hi, sizeof region.lo) == 0 && region.gross == 0) {
			s->label[at] = FREE; /* a single cell inside a body */
			continue;
		}
		TS_TRY(TS_GROW(s->region, s->region_capacity, s->nregions + 1));
		s->region[s->nregions++] = region;
	}
	return TS_OK;
}

/* ---- flow from bodies */

static void add_body_flow(struct ts_closed_search *s, int32_t label, double flow)
{
	struct region *region;

	if (label < FIRST_REGION)
		return;
	region = &s->region[label - FIRST_REGION];
	region->pushed += flow;
	region->push += fabs(flow);
}

static void add_body_flows(struct ts_closed_search *s, const struct body *body)
{
	const struct ts_immersed *ib = body->ib;

	for (int c = 0; c < s->grid->dimensions; c++)
		for (size_t k = ib->first[c]; k < ib->first[c + 1]; k++) {
			const struct ts_immersed_point *point = &ib->point[k];
			struct link link;
			double flow;
			int i[3];

			if (point->outside || point->target == 0)
				continue;
			ts_grid_indices(s->grid, point->at, i);
			if (i[c] >= s->grid->n[c])
				continue; /* beyond an open face */
			flow = point->target * face_area(s->grid, i, c);
			link = neighbour_link(s->grid, point->at, i, c, 0);
			if (link.boundary || s->label[link.cell] == s->label[point->at])
				continue;
			add_body_flow(s, s->label[point->at], flow);
			add_body_flow(s, s->label[link.cell], -flow);
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

static enum ts_status allocate_fields(struct ts_closed_search *s)
{
	for (int d = 0; d < s->grid->dimensions; d++)
		if (!(s->owner[d] = ts_alloc(s->grid->size, sizeof **s->owner)))
			return TS_NOMEM;
	s->label = ts_alloc(s->grid->size, sizeof *s->label);
	s->stack = ts_alloc(ts_grid_cells(s->grid), sizeof *s->stack);
	return s->label && s->stack ? TS_OK : TS_NOMEM;
}

/* Labels ghost cells and padding as outside. */
static void mark_outside(struct ts_closed_search *s)
{
	const struct ts_grid *grid = s->grid;

	memset(s->label, 0xff, grid->size * sizeof *s->label); /* OUTSIDE, -1, in all bytes */
	for (int k = 0; k < grid->n[2]; k++)
		for (int j = 0; j < grid->n[1]; j++)
			memset(s->label + ts_at(grid, 0, j, k), 0, (size_t)grid->n[0] * sizeof *s->label);
}

static enum ts_status find_closed_regions(struct ts_closed_search *s, struct tsim *sim)
{
	enum ts_status status = allocate_fields(s);

	if (status == TS_OK)
		mark_bodies(s, sim);
	if (status != TS_OK || s->status != TS_OK)
		return ts_nomem(&sim->error);
	if (s->nbodies == 0)
		return TS_OK;
	TS_TRY(check_inlets(s, sim));
	mark_outside(s);
	fill_from_open_faces(s);
	if (fill_closed_regions(s) != TS_OK)
		return ts_nomem(&sim->error);
	for (size_t k = 0; k < s->nbodies && s->nregions; k++)
		if (s->body[k].motion == TS_BODY_DRIVEN)
			add_body_flows(s, &s->body[k]);
	for (size_t k = 0; k < s->nregions; k++)
		TS_TRY(check_region(s, sim, &s->region[k]));
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
	status = find_closed_regions(&s, sim);
	s.p->check_closed = s.varies ? ts_immersed_check_closed : NULL;
	for (int d = 0; d < 3; d++)
		ts_free(s.owner[d]);
	ts_free(s.label);
	ts_free(s.stack);
	ts_free(s.body);
	ts_free(s.region);
	return status;
}
