#include "flow/flow_sampling.h"

#include <math.h>
#include <string.h>

#include "flow/flow.h"
#include "flow/flow_measures.h"

#include "base/banned.h"

enum { LINEAR, CUBIC };
const char *const ts_flow_interpolations[] = { [LINEAR] = "linear", [CUBIC] = "cubic", NULL };

enum { X, Y, Z, S, VX, VY, VZ, SPEED, P, VOID, WX, WY, WZ, VORTICITY };
static const char *const names[] = { [X] = "x",	  [Y] = "y",
				     [Z] = "z",	  [S] = "s",
				     [VX] = "vx", [VY] = "vy",
				     [VZ] = "vz", [SPEED] = "speed",
				     [P] = "p",	  [VOID] = "void",
				     [WX] = "wx", [WY] = "wy",
				     [WZ] = "wz", [VORTICITY] = "vorticity",
				     NULL };
static const int default_columns[] = { VX, VY, VZ, P };
enum { NUSUAL = sizeof default_columns / sizeof *default_columns };

/* Positions of the values along an axis. */
enum nodes { ON_FACES, IN_CENTRES };

enum { MOST_NODES = 4, MOST_INDICES = 3 * MOST_NODES };
struct stencil {
	int n, index[MOST_INDICES];
	double weight[MOST_INDICES];
};

struct axis {
	const struct ts_fluid *fluid;
	const struct ts_grid *grid;
	int d;
	enum nodes nodes;
	bool ends[2]; /* besides centres there is a value on the lower, upper boundary */
	bool scalar;  /* not a component of the velocity */
};

static bool is_boundary(const struct axis *a, int k)
{
	return !a->grid->periodic[a->d] && ((a->ends[0] && k < 0) || (a->ends[1] && k >= a->grid->n[a->d]));
}

static double node_coordinate(const struct axis *a, int k)
{
	if (a->nodes == ON_FACES)
		return a->grid->face[a->d][k];
	if (is_boundary(a, k))
		return a->grid->face[a->d][k < 0 ? 0 : k];
	return a->grid->centre[a->d][k];
}

static void node_range(const struct axis *a, int *low, int *high)
{
	int n = a->grid->n[a->d];

	if (a->grid->periodic[a->d]) {
		*low = a->nodes == ON_FACES ? -1 : -TS_GRID_GHOSTS;
		*high = n + 1;
	} else {
		*low = a->ends[0] ? -1 : 0;
		*high = a->nodes == ON_FACES || a->ends[1] ? n : n - 1;
	}
}

static void add_node(struct stencil *s, int index, double weight)
{
	s->index[s->n] = index;
	s->weight[s->n++] = weight;
}

/* Adds the value on the boundary itself: that given of a scalar, and at walls and inlets of the velocity, recovered from the
 * ghost; else, with zero gradient, that of the cell. */
static void add_boundary(struct stencil *s, const struct axis *a, bool high, double weight)
{
	const double *mirror = a->fluid->ghost_weights[a->d][high];
	enum ts_flow_face face = a->fluid->face[a->d][high];
	int first = high ? a->grid->n[a->d] - 1 : 0, inward = high ? -1 : 1;

	if (a->scalar) {
		add_node(s, first - inward, 0.5 * weight);
		add_node(s, first, 0.5 * weight);
		return;
	}
	if (face != TS_FLOW_WALL && face != TS_FLOW_INLET) {
		add_node(s, first, weight);
		return;
	}
	add_node(s, first - inward, weight / mirror[0]);
	add_node(s, first, -weight * mirror[1] / mirror[0]);
	if (mirror[2] != 0)
		add_node(s, first + inward, -weight * mirror[2] / mirror[0]);
}

static double clamp_to_grid(const struct ts_grid *grid, int d, double x)
{
	return fmin(fmax(x, grid->face[d][0]), grid->face[d][grid->n[d]]);
}

/* The `count` nodes nearest to x, or all if there are fewer. */
static struct stencil stencil_around(const struct axis *a, double x, int count)
{
	const struct ts_grid *grid = a->grid;
	struct stencil s = { 0 };
	int low, high, first;

	if (a->d >= grid->dimensions) {
		add_node(&s, 0, 1);
		return s;
	}
	x = clamp_to_grid(grid, a->d, x);
	node_range(a, &low, &high);
	first = ts_grid_find(grid, a->d, x);
	if (a->nodes != ON_FACES && x < grid->centre[a->d][first])
		first--;
	first -= count / 2 - 1;
	if (count > high - low + 1)
		count = high - low + 1;
	first = first < low ? low : first + count - 1 > high ? high - count + 1 : first;
	for (int k = first; k < first + count; k++) {
		double weight = 1;

		for (int other = first; other < first + count; other++)
			if (other != k)
				weight *= (x - node_coordinate(a, other)) /
					  (node_coordinate(a, k) - node_coordinate(a, other));
		if (is_boundary(a, k))
			add_boundary(&s, a, k >= 0, weight);
		else
			add_node(&s, k, weight);
	}
	return s;
}

typedef double value_fn(const struct ts_fluid *fluid, const void *what, const int cell[3]);

static double sum_stencils(const struct stencil s[3], const struct ts_fluid *fluid, value_fn *value,
			   const void *what)
{
	double sum = 0;

	for (int k = 0; k < s[2].n; k++)
		for (int j = 0; j < s[1].n; j++)
			for (int i = 0; i < s[0].n; i++) {
				const int cell[3] = { s[0].index[i], s[1].index[j], s[2].index[k] };

				sum += s[2].weight[k] * s[1].weight[j] * s[0].weight[i] *
				       value(fluid, what, cell);
			}
	return sum;
}

static double centred_value(const struct ts_fluid *fluid, const void *what, const int cell[3])
{
	return ((const double *)what)[ts_at(&fluid->grid, cell[0], cell[1], cell[2])];
}

static double edge_vorticity(const struct ts_fluid *fluid, const void *what, const int cell[3])
{
	return ts_flow_edge_vorticity(fluid, *(const int *)what, cell);
}

static double sample_centred(const struct ts_fluid *fluid, const struct ts_flow_scalar *field,
			     const double x[3], int count)
{
	struct stencil s[3];

	for (int d = 0; d < 3; d++) {
		const struct axis axis = { .fluid = fluid,
					   .grid = &fluid->grid,
					   .d = d,
					   .nodes = IN_CENTRES,
					   .ends = { field->given[d][0], field->given[d][1] },
					   .scalar = true };

		s[d] = stencil_around(&axis, x[d], count);
	}
	return sum_stencils(s, fluid, centred_value, field->value);
}

static double velocity(const struct ts_fluid *fluid, int component, const double x[3], int count)
{
	struct stencil s[3];

	if (component >= fluid->grid.dimensions)
		return 0;
	for (int d = 0; d < 3; d++) {
		const bool along = d != component;
		const struct axis axis = { .fluid = fluid,
					   .grid = &fluid->grid,
					   .d = d,
					   .nodes = along ? IN_CENTRES : ON_FACES,
					   .ends = { along, along } };

		s[d] = stencil_around(&axis, x[d], count);
	}
	return sum_stencils(s, fluid, centred_value, fluid->u[component]);
}

static double vorticity(const struct ts_fluid *fluid, int component, const double x[3])
{
	struct stencil s[3];

	if (fluid->grid.dimensions == 2 && component != 2)
		return 0;
	for (int d = 0; d < 3; d++) {
		const struct axis axis = { .fluid = fluid,
					   .grid = &fluid->grid,
					   .d = d,
					   .nodes = d == component ? IN_CENTRES : ON_FACES };

		s[d] = stencil_around(&axis, x[d], 2);
	}
	return sum_stencils(s, fluid, edge_vorticity, &component);
}

static double sample_value(int what, const struct ts_fluid *fluid, const double x[3], int count)
{
	double v[3];

	if (what == P)
		return sample_centred(fluid, &(struct ts_flow_scalar){ .value = fluid->p }, x, count);
	if (what == VOID)
		return fluid->void_fraction
			       ? sample_centred(fluid,
						&(struct ts_flow_scalar){ .value = fluid->void_fraction }, x,
						count)
			       : 1;
	if (what >= VX && what <= VZ)
		return velocity(fluid, what - VX, x, count);
	if (what >= WX && what <= WZ)
		return vorticity(fluid, what - WX, x);
	for (int d = 0; d < 3; d++)
		v[d] = what == SPEED ? velocity(fluid, d, x, count) : vorticity(fluid, d, x);
	return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

void ts_flow_sample(const struct ts_flow_sampler *sampler, const struct ts_fluid *fluid, const double x[3],
		    double s, double *out)
{
	int count = sampler->interpolation == CUBIC ? 4 : 2;

	for (size_t k = 0; k < sampler->list.n; k++) {
		int what = sampler->list.item[k];

		if (what == TS_FLOW_SCALAR)
			out[k] = sample_centred(fluid, &sampler->carried[k], x, count);
		else if (what <= Z)
			out[k] = x[what];
		else
			out[k] = what == S ? s : sample_value(what, fluid, x, count);
	}
}

/* The default columns, if no words are given. */
static enum ts_status select_default_columns(struct ts_name_list *list, struct tsim *sim,
					     struct ts_arena *arena)
{
	if (!list->item)
		list->item = ts_arena_alloc(arena, NUSUAL, sizeof *list->item);
	if (!list->item)
		return ts_nomem(&sim->error);
	memcpy(list->item, default_columns, sizeof default_columns);
	list->n = NUSUAL;
	return TS_OK;
}

enum ts_status ts_flow_sampler_read(struct ts_flow_sampler *s, struct tsim *sim, struct ts_arena *arena,
				    const char *who, const struct ts_place *where)
{
	struct ts_fluid *fluid;

	s->sim = sim;
	TS_TRY(ts_flow_require_fluid(sim, who, where, &fluid));
	TS_TRY(s->words.n ? ts_flow_read_names(sim, who, arena, s->words, names, sizeof *names, &s->list)
			  : select_default_columns(&s->list, sim, arena));
	if (!s->carried)
		s->carried = ts_arena_alloc(arena, s->list.n, sizeof *s->carried);
	return s->carried ? TS_OK : ts_nomem(&sim->error);
}

enum ts_status ts_flow_sampler_init(struct ts_instance *self, struct tsim *sim)
{
	struct ts_str who = { 0 };
	enum ts_status status;

	ts_str_addf(&who, "compute %s", self->style->name);
	status = ts_flow_sampler_read(self->state, sim, &self->arena, ts_str_text(&who), &self->where);
	ts_str_release(&who);
	return status;
}

enum ts_status ts_flow_sampler_inside(struct ts_instance *self, struct tsim *sim, const double x[3],
				      const struct ts_place *where)
{
	struct ts_fluid *fluid;

	TS_TRY(ts_flow_require_fluid(sim, self->style->name, where, &fluid));
	for (int d = 0; d < 3; d++)
		if (ts_grid_find(&fluid->grid, d, x[d]) < 0)
			return ts_fail(&sim->error, TS_RANGE, where,
				       "compute %s: %s = %g is outside of the fluid's grid, which goes from "
				       "%g to %g",
				       self->style->name, names[d], x[d], fluid->grid.face[d][0],
				       fluid->grid.face[d][fluid->grid.n[d]]);
	return TS_OK;
}

enum ts_status ts_flow_sampler_fetch(struct ts_flow_sampler *s, struct tsim *sim, const char *who,
				     const struct ts_place *where, struct ts_fluid **fluid)
{
	TS_TRY(ts_flow_require_fields(sim, who, where, fluid));
	for (size_t k = 0; k < s->list.n; k++)
		if (s->list.item[k] == TS_FLOW_SCALAR)
			TS_TRY(ts_flow_scalar_field(sim, who, &s->words.word[k], &s->carried[k]));
	return TS_OK;
}

enum ts_status ts_flow_sampler_begin(struct ts_instance *self, size_t rows, struct ts_table *out,
				     struct ts_fluid **fluid)
{
	struct ts_flow_sampler *s = self->state;

	TS_TRY(ts_flow_sampler_fetch(s, s->sim, self->style->name, &self->where, fluid));
	return ts_table_resize(out, rows, s->list.n);
}

enum ts_status ts_flow_sampler_first_row(struct ts_instance *self, const struct tsim *sim,
					 struct ts_table *out,
					 enum ts_status (*eval)(struct ts_instance *self,
								const struct tsim *sim, struct ts_table *out))
{
	TS_TRY(eval(self, sim, out));
	out->rows = 1;
	return TS_OK;
}
