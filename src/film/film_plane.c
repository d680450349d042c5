#include "film/film_plane.h"

#include <math.h>

#include "film/film_measures.h"

#include "base/banned.h"

/* 1, x and y of a cell from the place of the plane. */
static void arms_of(const struct ts_film_flow *flow, size_t c, double arm[3])
{
	const struct ts_film *f = &flow->film;
	const struct ts_film_plane *plane = ts_film_plane_of(&flow->surface[1]);

	arm[0] = 1;
	arm[1] = ts_film_centre(f, 0, (int)(c % (size_t)f->n[0])) - plane->place[0];
	arm[2] = ts_film_centre(f, 1, (int)(c / (size_t)f->n[0])) - plane->place[1];
}

void ts_film_plane_evaluate(struct ts_film_flow *flow)
{
	struct ts_film_surface *s = &flow->surface[1];
	const struct ts_film_plane *plane = ts_film_plane_of(s);

	for (size_t c = 0; c < ts_film_cells(&flow->film); c++) {
		double arm[3];

		arms_of(flow, c, arm);
		s->z[c] = plane->pose[0] + (plane->pose[1] * arm[1] + plane->pose[2] * arm[2]);
		s->rate[c] = plane->rate[0] + (plane->rate[1] * arm[1] + plane->rate[2] * arm[2]);
	}
}

/* Sum over the area of a field of pressures, and its moments. */
static void sum_moments(const struct ts_film_flow *flow, const double *p, double ambient, double out[3])
{
	const struct ts_film *f = &flow->film;

	out[0] = out[1] = out[2] = 0;
	for (size_t c = 0; c < ts_film_cells(f); c++) {
		double arm[3], push;

		if (f->kind[c] == TS_FILM_SOLID)
			continue;
		push = (p[c] - ambient) *
		       ts_film_area(f, (int)(c % (size_t)f->n[0]), (int)(c / (size_t)f->n[0]));
		arms_of(flow, c, arm);
		for (int k = 0; k < 3; k++)
			out[k] += push * arm[k];
	}
}

/* Adds the moments of the asperities to the first column, or their derivatives by the pose to all. */
static void add_touch(const struct ts_film_flow *flow, bool slopes, double out[3][3])
{
	const struct ts_film *f = &flow->film;

	for (size_t c = 0; f->asperity.density > 0 && c < ts_film_cells(f); c++) {
		struct ts_film_touch touch = ts_film_touch(f, f->gap[c]);
		double area = ts_film_area(f, (int)(c % (size_t)f->n[0]), (int)(c / (size_t)f->n[0])), arm[3];

		if (f->kind[c] == TS_FILM_SOLID)
			continue;
		arms_of(flow, c, arm);
		for (int a = 0; a < 3; a++) {
			if (!slopes)
				out[a][0] += touch.pressure * area * arm[a];
			for (int b = 0; b < 3 && slopes; b++)
				out[a][b] += touch.slope * flow->yield[c] * area * arm[a] * arm[b];
		}
	}
}

void ts_film_plane_push(const struct ts_film_flow *flow, struct ts_film_push *out)
{
	const struct ts_film_plane *plane = ts_film_plane_of(&flow->surface[1]);
	struct ts_film_measures m;
	double sum[3], touch[3][3] = { { 0 } };

	ts_film_measure(&flow->film, &m);
	sum_moments(flow, flow->film.p, flow->film.ambient, sum);
	add_touch(flow, false, touch);
	out->normal = sum[0] + touch[0][0];
	out->touch = touch[0][0];
	for (int d = 0; d < 2; d++) {
		out->moment[d] = sum[1 + d] + touch[1 + d][0];
		out->along[d] = m.shear[1][d] + m.touch_friction[d] - sum[0] * plane->pose[1 + d];
	}
}

double ts_film_plane_clearance(const struct ts_film_flow *flow)
{
	const struct ts_film *f = &flow->film;
	double least = INFINITY;

	for (size_t c = 0; c < ts_film_cells(f); c++)
		if (f->kind[c] != TS_FILM_SOLID)
			least = fmin(least, f->gap[c]);
	return least - ts_film_least_gap(f);
}

double ts_film_plane_reach(const struct ts_film_flow *flow, const double change[3])
{
	const struct ts_film *f = &flow->film;
	double reach = 1, least = ts_film_least_gap(f);

	for (size_t c = 0; c < ts_film_cells(f); c++) {
		double arm[3], sink, room = 2.0 / 3 * (f->gap[c] - least);

		arms_of(flow, c, arm);
		sink = -(change[0] + change[1] * arm[1] + change[2] * arm[2]) * flow->yield[c];
		if (f->kind[c] != TS_FILM_SOLID && reach * sink > room)
			reach = room / sink;
	}
	return reach;
}

/* Lengths by which the pose changes: the largest distances from the place. */
static void find_extent(const struct ts_film_flow *flow, double extent[3])
{
	const struct ts_film *f = &flow->film;
	const struct ts_film_plane *plane = ts_film_plane_of(&flow->surface[1]);

	extent[0] = 1;
	for (int d = 0; d < 2; d++)
		extent[1 + d] = fmax(fabs(f->face[d][0] - plane->place[d]),
				     fabs(f->face[d][f->n[d]] - plane->place[d]));
}

static void restore(struct ts_film_flow *flow)
{
	ts_film_plane_evaluate(flow);
	ts_film_combine(flow);
}

enum ts_status ts_film_plane_slopes(struct ts_film_flow *flow, double by_pose[3][3], double by_rate[3][3],
				    struct ts_error *error)
{
	const double part =
		1e-6; /* of the least gap: error of the differences 1e-6 by curvature, 1e-9 by round-off */
	struct ts_film_plane *plane = ts_film_plane_of(&flow->surface[1]);
	double extent[3], least = ts_film_plane_clearance(flow);

	find_extent(flow, extent);
	TS_TRY(ts_film_begin_response(&flow->film, error));
	for (int k = 0; k < 6; k++) {
		double *value = k < 3 ? &plane->pose[k] : &plane->rate[k - 3], kept = *value;
		double step = (k < 3 ? part : 1) * least / extent[k % 3], sum[3];

		*value += step;
		restore(flow);
		sum_moments(flow, ts_film_respond(&flow->film), 0, sum);
		for (int a = 0; a < 3; a++)
			(k < 3 ? by_pose : by_rate)[a][k % 3] = sum[a] / (*value - kept);
		*value = kept;
	}
	restore(flow);
	ts_film_end_response(&flow->film);
	add_touch(flow, true, by_pose);
	return TS_OK;
}
