#include "polish/wafer.h"

#include <math.h>
#include <stdbool.h>

#include "base/banned.h"

void ts_wafer_forces(const struct ts_wafer *w, const struct ts_wafer_pose *pose, struct ts_wafer_forces *out)
{
	const double yield = w->hardness / w->stiffness; /* compression at which a column yields */

	*out = (struct ts_wafer_forces){ 0 };
	for (size_t k = 0; k < w->n; k++) {
		const struct ts_wafer_column *c = &w->column[k];
		const double at[3] = { 1, c->x[0], c->x[1] };
		double depth = c->height - pose->z - pose->slope[0] * c->x[0] - pose->slope[1] * c->x[1];
		double elastic = fmin(depth, yield), force = w->stiffness * elastic * c->area;

		if (!(depth > 0))
			continue;
		out->normal += force;
		out->area += c->area;
		out->energy += force * (depth - 0.5 * elastic);
		for (int d = 0; d < 2; d++)
			out->moment[d] += force * c->x[d];
		for (int a = 0; a < 3 && depth < yield; a++)
			for (int b = 0; b < 3; b++)
				out->stiffness[a][b] += w->stiffness * c->area * at[a] * at[b];
	}
}

/* ---- equilibrium: the minimum of the convex function energy + P A (z - friction s) ---- */

static double potential(const struct ts_wafer *w, const struct ts_wafer_pose *pose,
			const struct ts_wafer_forces *f)
{
	return f->energy +
	       w->load * (pose->z - w->friction[0] * pose->slope[0] - w->friction[1] * pose->slope[1]);
}

/* Forces out of balance; returns the largest, moments over the half length of the face. */
static double find_residual(const struct ts_wafer *w, const double square[2], const struct ts_wafer_forces *f,
			    double out[3])
{
	out[0] = f->normal - w->load;
	for (int d = 0; d < 2; d++)
		out[1 + d] = f->moment[d] + w->load * w->friction[d];
	return fmax(fabs(out[0]), fmax(fabs(out[1]) / sqrt(square[0]), fabs(out[2]) / sqrt(square[1])));
}

/* Solves (K + ridge diag) x = r for a symmetric K >= 0 by Cholesky's method; false: it is singular. */
static bool solve(const double K[3][3], const double diagonal[3], double ridge, const double r[3],
		  double x[3])
{
	double L[3][3] = { { 0 } }, y[3];

	for (int a = 0; a < 3; a++)
		for (int b = 0; b <= a; b++) {
			double sum = K[a][b] + (a == b ? ridge * diagonal[a] : 0);

			for (int k = 0; k < b; k++)
				sum -= L[a][k] * L[b][k];
			if (a == b && !(sum > 1e-14 * diagonal[a]))
				return false;
			L[a][b] = a == b ? sqrt(sum) : sum / L[b][b];
		}
	for (int a = 0; a < 3; a++) {
		y[a] = r[a];
		for (int k = 0; k < a; k++)
			y[a] -= L[a][k] * y[k];
		y[a] /= L[a][a];
	}
	for (int a = 2; a >= 0; a--) {
		x[a] = y[a];
		for (int k = a + 1; k < 3; k++)
			x[a] -= L[k][a] * x[k];
		x[a] /= L[a][a];
	}
	return true;
}

/* Squares of the extent of the face, and its area. */
static void find_extent(const struct ts_wafer *w, double square[2], double *area)
{
	square[0] = square[1] = *area = 0;
	for (size_t k = 0; k < w->n; k++) {
		*area += w->column[k].area;
		for (int d = 0; d < 2; d++)
			square[d] = fmax(square[d], w->column[k].x[d] * w->column[k].x[d]);
	}
}

static struct ts_wafer_pose moved(const struct ts_wafer_pose *p, const double x[3])
{
	return (struct ts_wafer_pose){ p->z + x[0], { p->slope[0] + x[1], p->slope[1] + x[2] } };
}

/* Newton's method. Where few columns touch the stiffness is singular; a ridge, the stiffness of the whole pad times a
 * factor that adapts, keeps steps finite (K. Levenberg, Q. Appl. Math. 2 (1944) 164). Near the minimum, where the
 * potential changes by less than it is rounded, steps are judged by the residual. */
enum ts_status ts_wafer_settle(const struct ts_wafer *w, struct ts_wafer_pose *pose)
{
	double square[2], area, diagonal[3], ridge = 1e-3, r[3], x[3], most;
	struct ts_wafer_forces f;

	find_extent(w, square, &area);
	diagonal[0] = w->stiffness * area;
	for (int d = 0; d < 2; d++)
		diagonal[1 + d] = diagonal[0] * fmax(square[d], 1e-12 * (square[0] + square[1]));
	ts_wafer_forces(w, pose, &f);
	most = find_residual(w, square, &f, r);
	for (int k = 0; k < 500; k++) {
		struct ts_wafer_pose next;
		struct ts_wafer_forces g;
		double change, left, rest[3];

		if (most <= 1e-11 * w->load)
			return TS_OK;
		if (!solve((const double(*)[3])f.stiffness, diagonal, ridge, r, x)) {
			ridge = fmax(10 * ridge, 1e-12);
			continue;
		}
		next = moved(pose, x);
		ts_wafer_forces(w, &next, &g);
		left = find_residual(w, square, &g, rest);
		change = potential(w, &next, &g) - potential(w, pose, &f);
		if (!(change <= 0) && !(change <= 1e-11 * fabs(potential(w, pose, &f)) && left < most)) {
			ridge = fmax(10 * ridge, 1e-12);
			continue;
		}
		*pose = next;
		f = g;
		most = left;
		for (int d = 0; d < 3; d++)
			r[d] = rest[d];
		ridge *= 0.1;
	}
	return TS_PHYSICS;
}
