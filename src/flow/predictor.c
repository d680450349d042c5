#include "flow/predictor.h"

#include <math.h>

#include "base/clones.h"
#include "base/inline.h"
#include "flow/convection.h"

#include "base/banned.h"

void ts_flow_unknowns(const struct ts_fluid *fluid, int c, int from[3], int to[3])
{
	const struct ts_grid *grid = &fluid->grid;

	for (int d = 0; d < 3; d++) {
		from[d] = 0;
		to[d] = grid->n[d];
	}
	if (grid->periodic[c])
		return;
	from[c] = ts_flow_face_open(fluid->face[c][TS_LOW]) ? 0 : 1;
	to[c] = ts_flow_face_open(fluid->face[c][TS_HIGH]) ? grid->n[c] + 1 : grid->n[c];
}

/* Coefficients of a line at one point, the line, and the index of the point. They are passed to the
 * functions below one by one: a structure made within a loop keeps compilers from vectorizing it. */
struct at_point {
	double inverse, below, above, part_low, part_high;
	const struct ts_operator_line *line;
	int m;
};
#define AT(line, m)                                                                                     \
	(line)->inverse[m], (line)->below[m], (line)->above[m], (line)->part[m], (line)->part[(m) + 1], \
		(line), (m)
#define OF(p) p.inverse, p.below, p.above, p.part_low, p.part_high, p.line, p.m

/* Constants of a row for one direction e. */
struct direction {
	const double *q;	 /* velocity in this direction */
	const double *void_face; /* void fraction on the faces across e, and at cell centres */
	const double *void_centre;
	const double *flow; /* form conservative: void fraction of the fluxes */
	ptrdiff_t se;
	bool same; /* e is the direction of the component */
	double mass;
};

/* Void fractions on the lower and upper side of the control volume. */
TS_INLINE void void_fractions(const struct direction *e, ptrdiff_t at, ptrdiff_t sc, double mass, double *low,
			      double *high)
{
	if (e->same) {
		*low = e->void_centre[at - sc];
		*high = e->void_centre[at];
	} else {
		*low = mass * e->void_face[at - sc] + (1 - mass) * e->void_face[at];
		*high = mass * e->void_face[at - sc + e->se] + (1 - mass) * e->void_face[at + e->se];
	}
}

/* Fluxes e q on the lower and upper side: means of those through the faces of cells, so that they satisfy
 * the continuity equation of the control volume. */
TS_INLINE void fluxes(const struct direction *e, ptrdiff_t at, ptrdiff_t sc, double mass, double *low,
		      double *high)
{
	const double *q = e->q, *f = e->flow;
	const ptrdiff_t se = e->se;

	if (e->same) {
		*low = 0.5 * (f[at - sc] * q[at - sc] + f[at] * q[at]);
		*high = 0.5 * (f[at] * q[at] + f[at + sc] * q[at + sc]);
	} else {
		*low = mass * f[at - sc] * q[at - sc] + (1 - mass) * f[at] * q[at];
		*high = mass * f[at - sc + se] * q[at - sc + se] + (1 - mass) * f[at + se] * q[at + se];
	}
}

/* Contribution of direction e to the rate of change of component c at index `at`. */
TS_INLINE double along(double inverse, double below, double above, double part_low, double part_high,
		       const struct ts_operator_line *line, int m, const struct direction *e, const double *u,
		       ptrdiff_t at, ptrdiff_t sc, double mass, double nu, double gamma,
		       enum ts_convection scheme, enum ts_flow_form form, bool with_void)
{
	const double *q = e->q;
	const ptrdiff_t se = e->se;
	double here = u[at], low = u[at - se], high = u[at + se];
	double q_low, q_high, e_low = 1, e_high = 1, rate;

	if (with_void)
		void_fractions(e, at, sc, mass, &e_low, &e_high);
	if (e->same) { /* the sides are cell centres, midway between two faces */
		q_low = 0.5 * (low + here);
		q_high = 0.5 * (here + high);
	} else { /* the sides are edges: flow through the halves of two cells */
		q_low = mass * q[at - sc] + (1 - mass) * q[at];
		q_high = mass * q[at - sc + se] + (1 - mass) * q[at + se];
	}
	if (form != TS_FORM_DIFFERENCE) {
		double phi_low = ts_convection_face_value(scheme, gamma, q_low, u[at - 2 * se], low, here,
							  high, part_low, line, m);
		double phi_high = ts_convection_face_value(scheme, gamma, q_high, low, here, high,
							   u[at + 2 * se], part_high, line, m + 1);

		if (form == TS_FORM_CONSERVATIVE) {
			fluxes(e, at, sc, mass, &q_low, &q_high);
		} else if (with_void) {
			q_low *= e_low;
			q_high *= e_high;
			phi_low -= here;
			phi_high -= here;
		}
		rate = (q_low * phi_low - q_high * phi_high) * inverse;
	} else {
		rate = ts_convection_difference(scheme, gamma, e->same ? here : 0.5 * (q_low + q_high),
						high - here, here - low, above, below, inverse);
	}
	if (!with_void)
		return rate + nu * (above * (high - here) - below * (here - low));
	return rate + nu * (above * e_high * (high - here) - below * e_low * (here - low));
}

struct row {
	const struct ts_predictor *p;
	int j, k, from, to;
	ptrdiff_t at; /* field index of i = 0 */
};

TS_INLINE struct direction direction(const struct row *row, int d, int c, int dimensions, bool with_void)
{
	const struct ts_fluid *fluid = row->p->fluid;

	if (d >= dimensions)
		return (struct direction){ 0 };
	return (struct direction){ .q = row->p->u[d] + row->at,
				   .void_face = with_void ? fluid->void_fraction_face[d] + row->at : NULL,
				   .void_centre = with_void ? fluid->void_fraction + row->at : NULL,
				   .flow = row->p->flow[d] ? row->p->flow[d] + row->at : NULL,
				   .se = d == 0 ? 1 : fluid->grid.stride[d],
				   .same = c == d };
}

TS_INLINE void predict_row(const struct row *row, int c, int dimensions, enum ts_convection scheme,
			   enum ts_flow_form form, bool with_void)
{
	const struct ts_predictor *p = row->p;
	const struct ts_operators *o = p->operators;
	const struct ts_operator_line *line = c == 0 ? &o->staggered[0] : &o->centred[0];
	const struct at_point y = { AT(c == 1 ? &o->staggered[1] : &o->centred[1], row->j) };
	/* In two dimensions there is no line along z; this one is not used. */
	const struct ts_operator_line *line_z = dimensions < 3 ? &o->centred[1]
						: c == 2       ? &o->staggered[2]
							       : &o->centred[2];
	const struct at_point z = { AT(line_z, dimensions < 3 ? 0 : row->k) };
	const struct direction along_x = direction(row, 0, c, dimensions, with_void);
	const struct direction along_y = direction(row, 1, c, dimensions, with_void);
	const struct direction along_z = direction(row, 2, c, dimensions, with_void);
	const ptrdiff_t sc = c == 0 ? 1 : p->fluid->grid.stride[c];
	const double *mass_x = o->mass[0];
	const double mass_c = c == 1 ? o->mass[1][row->j] : c == 2 ? o->mass[2][row->k] : 0;
	const double *u = p->u[c] + row->at, *old = p->old[c] + row->at;
	const double *void_face = with_void ? p->fluid->void_fraction_face[c] + row->at : NULL;
	double *out = p->out[c] + row->at;
	const double nu = p->nu, gamma = p->gamma, keep = p->keep, take = p->take, dt = p->dt;
	const double acceleration = p->acceleration[c];
	const bool conservative = form == TS_FORM_CONSERVATIVE;
	const double *start = conservative ? p->start[c] + row->at : NULL,
		     *last = conservative ? p->last[c] + row->at : NULL;
	const double *next = conservative ? p->next[c] + row->at : NULL;

#pragma omp simd
	for (int i = row->from; i < row->to; i++) {
		double mass = c == 0 ? mass_x[i] : mass_c;
		double rate =
			along(AT(line, i), &along_x, u, i, sc, mass, nu, gamma, scheme, form, with_void);

		rate += along(OF(y), &along_y, u, i, sc, mass, nu, gamma, scheme, form, with_void);
		if (dimensions == 3)
			rate += along(OF(z), &along_z, u, i, sc, mass, nu, gamma, scheme, form, with_void);
		if (conservative) {
			rate += void_face[i] * acceleration;
			out[i] = (keep * start[i] * old[i] + take * (last[i] * u[i] + dt * rate)) / next[i];
			continue;
		}
		if (with_void)
			rate /= void_face[i];
		out[i] = keep * old[i] + take * (u[i] + dt * (acceleration + rate));
	}
}

typedef void row_fn(const struct row *row);

#define ROW(name, c, dimensions, scheme, form, with_void)                 \
	TS_CLONES                                                         \
	static void name##_##c(const struct row *row)                     \
	{                                                                 \
		predict_row(row, c, dimensions, scheme, form, with_void); \
	}
#define ROWS(name, scheme, form, with_void)          \
	ROW(name##_2, 0, 2, scheme, form, with_void) \
	ROW(name##_2, 1, 2, scheme, form, with_void) \
	ROW(name##_3, 0, 3, scheme, form, with_void) \
	ROW(name##_3, 1, 3, scheme, form, with_void) \
	ROW(name##_3, 2, 3, scheme, form, with_void)
#define VARIANTS(name, scheme, form)           \
	ROWS(name##_free, scheme, form, false) \
	ROWS(name##_void, scheme, form, true)
#define CONSERVATIVE(name, scheme) ROWS(name##_conservative, scheme, TS_FORM_CONSERVATIVE, true)
#define ENTRY(name)                                        \
	{                                                  \
		{ name##_2_0, name##_2_1, NULL },          \
		{                                          \
			name##_3_0, name##_3_1, name##_3_2 \
		}                                          \
	}
#define ENTRIES(name)                                  \
	{                                              \
		ENTRY(name##_free), ENTRY(name##_void) \
	}

VARIANTS(donor, TS_CONVECTION_DONOR, TS_FORM_VOLUME)
VARIANTS(central, TS_CONVECTION_CENTRAL, TS_FORM_VOLUME)
VARIANTS(quick, TS_CONVECTION_QUICK, TS_FORM_VOLUME)
VARIANTS(cubista, TS_CONVECTION_CUBISTA, TS_FORM_VOLUME)
CONSERVATIVE(donor, TS_CONVECTION_DONOR)
CONSERVATIVE(central, TS_CONVECTION_CENTRAL)
CONSERVATIVE(quick, TS_CONVECTION_QUICK)
CONSERVATIVE(cubista, TS_CONVECTION_CUBISTA)
VARIANTS(difference, TS_CONVECTION_DONOR, TS_FORM_DIFFERENCE)

/* [scheme][with void fraction][in three dimensions][component] */
static row_fn *const volume_rows[TS_NCONVECTION][2][2][3] = {
	[TS_CONVECTION_DONOR] = ENTRIES(donor),
	[TS_CONVECTION_CENTRAL] = ENTRIES(central),
	[TS_CONVECTION_QUICK] = ENTRIES(quick),
	[TS_CONVECTION_CUBISTA] = ENTRIES(cubista),
};
static row_fn *const conservative_rows[TS_NCONVECTION][2][3] = {
	[TS_CONVECTION_DONOR] = ENTRY(donor_conservative),
	[TS_CONVECTION_CENTRAL] = ENTRY(central_conservative),
	[TS_CONVECTION_QUICK] = ENTRY(quick_conservative),
	[TS_CONVECTION_CUBISTA] = ENTRY(cubista_conservative),
};
/* Central differences are those of the donor cell with gamma 0. */
static row_fn *const difference_rows[2][2][3] = ENTRIES(difference);

void ts_flow_visit_rows(const struct ts_fluid *fluid, const struct ts_slabs *slabs, int threads,
			ts_flow_row_fn *visit, void *context)
{
	const struct ts_grid *grid = &fluid->grid;
	int from[3][3], to[3][3], height = grid->n[1] + 1;
	long first, end;

	for (int c = 0; c < grid->dimensions; c++)
		ts_flow_unknowns(fluid, c, from[c], to[c]);
	ts_slabs_rows(slabs, grid->n[2], height, grid->dimensions == 3, &first, &end);
#pragma omp parallel for num_threads(threads) schedule(static)
	for (long line = first; line < end; line++) {
		int j = (int)(line % height), k = (int)(line / height);

		for (int c = 0; c < grid->dimensions; c++)
			if (j >= from[c][1] && j < to[c][1] && k >= from[c][2] && k < to[c][2])
				visit(context, c, j, k, from[c][0], to[c][0]);
	}
}

struct prediction {
	const struct ts_predictor *predictor;
	row_fn *const *row_of; /* [component] */
};

static void predict_at(void *context, int c, int j, int k, int from, int to)
{
	const struct prediction *task = context;
	const struct ts_predictor *p = task->predictor;
	struct row row = { p, j, k, from, to, (ptrdiff_t)ts_at(&p->fluid->grid, 0, j, k) };

	task->row_of[c](&row);
}

void ts_flow_predict(const struct ts_predictor *p)
{
	bool with_void = p->fluid->void_fraction, solid = p->fluid->grid.dimensions == 3;
	struct prediction task = { p, p->form == TS_FORM_DIFFERENCE ? difference_rows[with_void][solid]
				      : p->next[0]		    ? conservative_rows[p->convection][solid]
						   : volume_rows[p->convection][with_void][solid] };

	ts_flow_visit_rows(p->fluid, p->slabs, p->threads, predict_at, &task);
}
