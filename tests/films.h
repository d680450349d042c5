/* Films of unit viscosity for tests. */
#ifndef TESTS_FILMS_H
#define TESTS_FILMS_H

#include <math.h>
#include <string.h>

#include "base/alloc.h"
#include "deck.h"
#include "film/film.h"
#include "film/film_measures.h"
#include "film/film_velocity.h"

static const double PI = 3.14159265358979323846;

/* A film on [0, length[0]] x [0, length[1]] with uniform cells; pressure 0 at edges of axis 0, no flow at those of axis
 * 1, unit gap, surfaces at rest. */
static inline struct ts_film film_open(int nx, int ny, double lx, double ly)
{
	struct ts_film f = { .n = { nx, ny },
			     .viscosity = 1,
			     .density = 1,
			     .edge = { { TS_FILM_PRESSURE, TS_FILM_PRESSURE },
				       { TS_FILM_NO_FLOW, TS_FILM_NO_FLOW } } };

	ck_assert_int_eq(ts_film_make(&f), TS_OK);
	for (int i = 0; i <= nx; i++)
		f.face[0][i] = lx * i / nx;
	for (int j = 0; j <= ny; j++)
		f.face[1][j] = ly * j / ny;
	for (size_t c = 0; c < ts_film_cells(&f); c++)
		f.gap[c] = 1;
	return f;
}

static inline void film_fill(const struct ts_film *f, double *field, double value)
{
	for (size_t c = 0; c < ts_film_cells(f); c++)
		field[c] = value;
}

/* Solves, with the balance of all cells at round-off. */
static inline struct ts_film_measures film_solve(struct ts_film *f)
{
	struct ts_error error = { .status = TS_OK };
	struct ts_film_measures m;

	ck_assert_msg(ts_film_solve(f, &error) == TS_OK, "%s", error.message);
	ck_assert_msg(f->report.balance <= 1e-11 * f->report.throughput + 1e-16, "balance %g of %g",
		      f->report.balance, f->report.throughput);
	ts_film_measure(f, &m);
	return m;
}

/* Flow out of all edges. */
static inline double film_outflow(const struct ts_film_measures *m)
{
	return m->outflow[0][0] + m->outflow[0][1] + m->outflow[1][0] + m->outflow[1][1];
}

/* Unwrapped journal bearing: x the angle from the widest gap 1 + e, the shell slides with speed 1; y from the middle to
 * the end, at pressure 0, at ratio = length/diameter radii. `groove`: pressure 0 at x = 0, else the film is closed. */
static inline struct ts_film film_bearing(int nx, int ny, double e, double ratio, bool groove,
					  enum ts_film_cavitation cavitation)
{
	struct ts_film f = film_open(nx, ny, 2 * PI, ratio);

	f.cavitation = cavitation;
	f.edge[0][0] = f.edge[0][1] = groove ? TS_FILM_PRESSURE : TS_FILM_PERIODIC;
	f.edge[1][1] = TS_FILM_PRESSURE;
	film_fill(&f, f.velocity[0][0], 1);
	for (int j = 0; j < ny; j++)
		for (int i = 0; i < nx; i++)
			f.gap[ts_film_at(&f, i, j)] = 1 + e * cos(ts_film_centre(&f, 0, i));
	return f;
}

/* Sommerfeld number eta N L D/W (R/c)^2 and attitude angle in degrees, of the half of the bearing in the film. */
static inline void film_sommerfeld(const struct ts_film *f, double *number, double *attitude)
{
	double radial = 0, tangential = 0, length = f->face[1][f->n[1]];

	for (int j = 0; j < f->n[1]; j++)
		for (int i = 0; i < f->n[0]; i++) {
			double x = ts_film_centre(f, 0, i);
			double push = f->p[ts_film_at(f, i, j)] * ts_film_area(f, i, j);

			radial -= push * cos(x);
			tangential += push * sin(x);
		}
	*number = length / PI / hypot(radial, tangential);
	*attitude = atan2(tangential, radial) * 180 / PI;
}

/* Lower surface of inclined films. */
static inline double film_lower_surface(double x, double y)
{
	return 0.2 * x - 0.1 * y;
}

/* Velocity in a film above it, at height z, which the lower surface leaves with 0.05. */
static inline void film_velocity_at(const struct ts_film *f, double x, double y, double z, double u[3])
{
	const double slope[2] = { 0.2, -0.1 };
	struct ts_film_point point;

	ts_film_sample(f, (const double[]){ x, y }, &point);
	ts_film_profile(&point, (z - film_lower_surface(x, y)) / point.gap, slope, 0.05, u);
}

#endif
