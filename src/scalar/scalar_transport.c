#include "scalar/scalar_transport.h"

#include <math.h>
#include <string.h>

#include "flow/fluid_slabs.h"

#include "base/banned.h"

const char *const ts_scalar_schemes[] = { "vanleer", "central", "donor", NULL };

enum ts_status ts_transport_make(struct ts_transport *t, const struct ts_fluid *fluid)
{
	double **const fields[] = { &t->value, &t->source, &t->rate, &t->stage };

	for (size_t k = 0; k < sizeof fields / sizeof *fields; k++)
		if (!(*fields[k] = ts_grid_field(&fluid->grid)))
			return TS_NOMEM;
	return TS_OK;
}

void ts_transport_release(struct ts_transport *t)
{
	double **const fields[] = { &t->value, &t->source, &t->rate, &t->stage, &t->void_fraction };

	for (size_t k = 0; k < sizeof fields / sizeof *fields; k++) {
		ts_grid_field_free(*fields[k]);
		*fields[k] = NULL;
	}
}

/* Sets the ghosts beyond a face with a given value, by linear extrapolation. */
static void set_ghosts_by_value(const struct ts_fluid *fluid, int d, int side, double given, double *value)
{
	const struct ts_grid *grid = &fluid->grid;
	int a = d == 0, b = d == 2 ? 1 : 2, i[3];
	ptrdiff_t out = side ? grid->stride[d] : -grid->stride[d];

	i[d] = side ? grid->n[d] - 1 : 0;
	for (i[b] = 0; i[b] < grid->n[b]; i[b]++) {
		if (!ts_fluid_has_plane(fluid, i[2]))
			continue;
		for (i[a] = 0; i[a] < grid->n[a]; i[a]++) {
			size_t at = ts_at(grid, i[0], i[1], i[2]);

			value[(ptrdiff_t)at + out] = 2 * given - value[at];
		}
	}
}

void ts_transport_fill(const struct ts_transport *t, const struct ts_fluid *fluid, double *value)
{
	const struct ts_grid *grid = &fluid->grid;
	bool given = false;

	ts_fluid_fill_centred(fluid, value);
	for (int d = 0; d < grid->dimensions; d++)
		for (int side = 0; side < 2 && !grid->periodic[d]; side++)
			if (t->face[d][side].condition == TS_SCALAR_VALUE) {
				set_ghosts_by_value(fluid, d, side, t->face[d][side].now, value);
				given = true;
			}
	if (given) /* where both are beyond the grid */
		ts_fluid_fill_periodic(fluid, value);
}

/* T convected through an inner face, from the second and first point upwind and the first downwind. */
static double face_value(enum ts_scalar_scheme scheme, double far, double up, double down)
{
	double a = up - far, b = down - up;

	if (scheme == TS_SCALAR_CENTRAL)
		return 0.5 * (up + down);
	return scheme == TS_SCALAR_VANLEER && a * b > 0 ? up + a * b / (a + b) : up;
}

/* Flux of T (T times velocity) through the lower face m across d of the cell at `at`. */
static double flux_inside(const struct ts_transport *t, const struct ts_fluid *fluid, int d, int m, size_t at,
			  const double *value)
{
	const ptrdiff_t s = fluid->grid.stride[d];
	const double *q = value + at, e = fluid->void_fraction ? fluid->void_fraction_face[d][at] : 1;
	const double u = fluid->u[d][at];
	double side = u > 0 ? face_value(t->scheme, q[-2 * s], q[-s], q[0])
			    : face_value(t->scheme, q[s], q[0], q[-s]);

	return e * (u * side - t->diffusivity * (q[0] - q[-s]) / fluid->grid.gap[d][m]);
}

static double flux_at_boundary(const struct ts_transport *t, const struct ts_fluid *fluid, int d, int side,
			       size_t at, const double *value)
{
	const struct ts_scalar_face *face = &t->face[d][side];
	const struct ts_grid *grid = &fluid->grid;
	const double e = fluid->void_fraction ? fluid->void_fraction_face[d][at] : 1, u = fluid->u[d][at];
	const double here = value[side ? (ptrdiff_t)at - grid->stride[d] : (ptrdiff_t)at];
	const double inward = side ? -1 : 1;
	const double half = 0.5 * grid->width[d][side ? grid->n[d] - 1 : 0];

	if (face->condition == TS_SCALAR_VALUE)
		return e * (u * (inward * u > 0 ? face->now : here) +
			    inward * t->diffusivity * (face->now - here) / half);
	return e * u * here + (face->condition == TS_SCALAR_FLUX ? inward * face->now : 0);
}

static double scalar_flux(const struct ts_transport *t, const struct ts_fluid *fluid, int d, int m, size_t at,
			  const double *value)
{
	const struct ts_grid *grid = &fluid->grid;

	if (!grid->periodic[d] && (m == 0 || m == grid->n[d]))
		return flux_at_boundary(t, fluid, d, m > 0, at, value);
	return flux_inside(t, fluid, d, m, at, value);
}

/* d(e T)/dt */
static void find_rate(const struct ts_transport *t, const struct ts_fluid *fluid, const double *value,
		      int threads)
{
	const struct ts_grid *grid = &fluid->grid;
	long first, end;

	ts_fluid_slabs_rows(fluid, &first, &end);
#pragma omp parallel for num_threads(threads) schedule(static)
	for (long row = first; row < end; row++) {
		int i[3] = { 0, (int)(row % grid->n[1]), (int)(row / grid->n[1]) };

		for (; i[0] < grid->n[0]; i[0]++) {
			size_t at = ts_at(grid, i[0], i[1], i[2]);
			double sum = t->constant + t->source[at] + t->excess * value[at];

			for (int d = 0; d < grid->dimensions; d++)
				sum += (scalar_flux(t, fluid, d, i[d], at, value) -
					scalar_flux(t, fluid, d, i[d] + 1, at + (size_t)grid->stride[d],
						    value)) /
				       grid->width[d][i[d]];
			t->rate[at] = sum;
		}
	}
}

/* Largest rate at which T of a cell decays by convection and conduction along d. */
static double rate_along(const struct ts_transport *t, const struct ts_fluid *fluid, int d, int m, size_t at)
{
	const double h = fluid->grid.width[d][m];
	const double u = fmax(fabs(fluid->u[d][at]), fabs(fluid->u[d][at + (size_t)fluid->grid.stride[d]]));

	return 2 * u / h + 2 * t->diffusivity / (h * h);
}

/* Void fraction of the lower face m across d: the mean over the halves of the cells beside it. */
static double void_fraction_of_face(const struct ts_fluid *fluid, int d, int m, size_t at)
{
	const struct ts_grid *grid = &fluid->grid;
	const double *e = fluid->void_fraction;
	const double below = grid->width[d][m > 0 ? m - 1 : 0],
		     above = grid->width[d][m < grid->n[d] ? m : m - 1];

	return (below * e[at - (size_t)grid->stride[d]] + above * e[at]) / (below + above);
}

/* The same with a void fraction e: T of a dense cell changes faster, by e of the face over e of the cell. */
static double rate_along_with_void(const struct ts_transport *t, const struct ts_fluid *fluid, int d, int m,
				   size_t at)
{
	const struct ts_grid *grid = &fluid->grid;
	const size_t next = at + (size_t)grid->stride[d];
	const double h = grid->width[d][m], *gap = grid->gap[d] + m;
	const double low = void_fraction_of_face(fluid, d, m, at),
		     high = void_fraction_of_face(fluid, d, m + 1, next);
	const double flow = fmax(low * fabs(fluid->u[d][at]), high * fabs(fluid->u[d][next]));

	return (2 * flow / h + t->diffusivity / h * (low / gap[0] + high / gap[1])) /
	       fmin(fluid->void_fraction[at], t->void_fraction[at]);
}

double ts_transport_limit(const struct ts_transport *t, const struct ts_fluid *fluid)
{
	const struct ts_grid *grid = &fluid->grid;
	double most = 0;
	long first, end;

	ts_fluid_slabs_rows(fluid, &first, &end);
	for (long row = first; row < end; row++) {
		int m[3] = { 0, (int)(row % grid->n[1]), (int)(row / grid->n[1]) };

		for (; m[0] < grid->n[0]; m[0]++) {
			size_t at = ts_at(grid, m[0], m[1], m[2]);
			double sum = 0;

			for (int d = 0; d < grid->dimensions; d++)
				sum += t->void_fraction ? rate_along_with_void(t, fluid, d, m[d], at)
							: rate_along(t, fluid, d, m[d], at);
			most = fmax(most, sum);
		}
	}
	most = ts_fluid_slabs_most(fluid, most);
	return most > 0 ? 1 / most : INFINITY;
}

static double void_fraction_after(const struct ts_transport *t, const struct ts_fluid *fluid, size_t k,
				  double dt)
{
	return t->void_fraction[k] + dt * fluid->void_fraction_rate[k];
}

/* Runge-Kutta methods as convex combinations of Euler steps (Shu & Osher): the contents e T after a stage are part times
 * (first times those at the beginning + those of the stage before after an Euler step). */
struct stage {
	double part, first;
	double from, to; /* times of the stage before and of this one, in steps */
};
enum { MOST_STAGES = 3 };
static const struct method {
	int stages;
	struct stage stage[MOST_STAGES];
} heun = { 2, { { 1, 0, 0, 1 }, { 0.5, 1, 1, 1 } } },
  third_order = { 3, { { 1, 0, 0, 1 }, { 0.25, 3, 1, 0.5 }, { 2.0 / 3, 0.5, 0.5, 1 } } };

/* Central differences do not damp what is convected, and by Heun's method it grows. */
static const struct method *method_of(const struct ts_transport *t)
{
	return t->scheme == TS_SCALAR_CENTRAL ? &third_order : &heun;
}

/* T after a stage of a step of length dt from T of the stage before, and the rate of its e T. */
static void make_stage(const struct ts_transport *t, const struct ts_fluid *fluid, const struct stage *stage,
		       double dt, const double *before, double *after, int threads)
{
	const double *e = t->void_fraction;
	size_t first, end;

	ts_fluid_slabs_values(fluid, &first, &end);
#pragma omp parallel for num_threads(threads) schedule(static)
	for (size_t k = first; k < end; k++) {
		double last = e ? void_fraction_after(t, fluid, k, stage->from * dt) : 1,
		       next = e ? void_fraction_after(t, fluid, k, stage->to * dt) : 1;
		double content = stage->first * ((e ? e[k] : 1) * t->value[k]) + last * before[k];

		/* e is 0 in the padding between rows */
		after[k] = next > 0 ? stage->part * (content + dt * t->rate[k]) / next : 0;
	}
}

static void advance_void_fraction(struct ts_transport *t, const struct ts_fluid *fluid, double dt,
				  int threads)
{
	size_t first, end;

	for (int range = 0; range < ts_fluid_ranges(fluid) && t->void_fraction; range++) {
		ts_fluid_range_values(fluid, range, &first, &end);
#pragma omp parallel for num_threads(threads) schedule(static)
		for (size_t k = first; k < end; k++)
			t->void_fraction[k] = void_fraction_after(t, fluid, k, dt);
	}
}

static void make_substep(struct ts_transport *t, const struct ts_fluid *fluid, double dt, int threads)
{
	const struct method *method = method_of(t);

	for (int s = 0; s < method->stages; s++) {
		double *before = s == 0 ? t->value : t->stage;
		double *after = s == method->stages - 1 ? t->value : t->stage;

		ts_transport_fill(t, fluid, before);
		find_rate(t, fluid, before, threads);
		make_stage(t, fluid, &method->stage[s], dt, before, after, threads);
		ts_fluid_slabs_share_halo(fluid, after);
	}
	advance_void_fraction(t, fluid, dt, threads);
}

double ts_transport_parts(const struct ts_transport *t, const struct ts_fluid *fluid, double dt)
{
	return fmax(ceil(dt / ts_transport_limit(t, fluid)), 1);
}

void ts_transport_rehearse(const struct ts_transport *t, const struct ts_fluid *fluid, double dt)
{
	for (long k = (long)ts_transport_parts(t, fluid, dt); k > 0; k--) {
		for (int s = method_of(t)->stages; s > 1; s--)
			ts_fluid_slabs_share_halo(fluid, t->stage);
		ts_fluid_slabs_share_halo(fluid, t->value);
	}
}

void ts_transport_advance(struct ts_transport *t, const struct ts_fluid *fluid, double dt, long parts,
			  int threads)
{
	for (long k = 0; k < parts; k++)
		make_substep(t, fluid, dt / (double)parts, threads);
}
