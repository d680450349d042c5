#include "film/film_velocity.h"

#include <math.h>

#include "base/inline.h"
#include "film/internal.h"

#include "base/banned.h"

/* The cell that contains a coordinate, and the centres on both sides of it with their weights. */
struct place {
	double x;
	int cell, near[2];
	double weight[2], apart; /* apart: distance of the centres; 0: only one */
};

/* Cells of equal width are found at the first guess. */
static int find_cell(const struct ts_film *f, int axis, double x)
{
	const double *face = f->face[axis];
	int low = 0, high = f->n[axis];
	int guess = (int)((x - face[0]) / (face[high] - face[0]) * high);

	if (guess >= 0 && guess < high && x >= face[guess] && x < face[guess + 1])
		return guess;
	while (high - low > 1) {
		int middle = (low + high) / 2;

		if (x >= f->face[axis][middle])
			low = middle;
		else
			high = middle;
	}
	return low;
}

/* Indices are at most one beyond the ends. */
static inline int wrap_index(int i, int n)
{
	return i < 0 ? n - 1 : i >= n ? 0 : i;
}

TS_INLINE void find_place(const struct ts_film *f, int axis, double x, struct place *at)
{
	int n = f->n[axis], other;
	const double *face = f->face[axis];
	double centre, period = face[n] - face[0], next, away;
	bool above;

	at->x = x > face[0] ? x < face[n] ? x : face[n] : face[0];
	at->cell = find_cell(f, axis, at->x);
	centre = ts_film_centre(f, axis, at->cell);
	above = at->x >= centre;
	other = at->cell + (above ? 1 : -1);
	at->near[0] = at->near[1] = at->cell;
	at->weight[0] = 1;
	at->weight[1] = at->apart = 0;
	if (f->edge[axis][0] == TS_FILM_PERIODIC)
		next = ts_film_centre(f, axis, wrap_index(other, n)) + (other < 0    ? -period
									: other >= n ? period
										     : 0);
	else if (other >= 0 && other < n)
		next = ts_film_centre(f, axis, other);
	else
		return;
	other = wrap_index(other, n);
	at->apart = fabs(next - centre);
	away = fabs(at->x - centre) / at->apart;
	at->near[0] = above ? at->cell : other;
	at->near[1] = above ? other : at->cell;
	at->weight[0] = above ? 1 - away : away;
	at->weight[1] = above ? away : 1 - away;
}

static double interpolate(const struct ts_film *f, const double *field, const struct place at[2])
{
	double sum = 0;

	for (int b = 0; b < 2; b++)
		for (int a = 0; a < 2; a++)
			sum += at[0].weight[a] * at[1].weight[b] *
			       field[ts_film_at(f, at[0].near[a], at[1].near[b])];
	return sum;
}

/* Derivative along an axis; beyond the last centres that between the last two. */
static double slope_along(const struct ts_film *f, const double *field, int axis, const struct place at[2])
{
	struct place line = at[axis];
	double sum = 0;

	if (!(line.apart > 0)) {
		if (f->n[axis] < 2)
			return 0;
		line.near[0] = line.cell == 0 ? 0 : f->n[axis] - 2;
		line.near[1] = line.near[0] + 1;
		line.apart = ts_film_centre(f, axis, line.near[1]) - ts_film_centre(f, axis, line.near[0]);
	}
	for (int k = 0; k < 2; k++) {
		int low[2], high[2];

		low[1 - axis] = high[1 - axis] = at[1 - axis].near[k];
		low[axis] = line.near[0];
		high[axis] = line.near[1];
		sum += at[1 - axis].weight[k] *
		       (field[ts_film_at(f, high[0], high[1])] - field[ts_film_at(f, low[0], low[1])]);
	}
	sum /= line.apart;
	return f->polar && axis == 1 && at[0].x > 0 ? sum / at[0].x : sum;
}

/* Mean velocity along an axis, if the gap were full also in the cavity. In polar coordinates r q varies linearly with
 * r^2, so that its divergence is constant in the cell. `rate`: derivative of q along the axis of a Cartesian grid. */
static double mean_along(const struct ts_film *f, int axis, const struct place at[2], double gap,
			 double *rate)
{
	int i = at[0].cell, j = at[1].cell, k = at[axis].cell;
	double low = ts_film_full_flow(f, axis, i, j);
	double high = ts_film_full_flow(f, axis, i + (axis == 0), j + (axis == 1));
	double a = f->face[axis][k], b = f->face[axis][k + 1], t = (at[axis].x - a) / (b - a);
	double length = axis == 0 ? f->face[1][j + 1] - f->face[1][j] : f->face[0][i + 1] - f->face[0][i];

	*rate = (high - low) / (length * (b - a));
	if (f->polar && axis == 0) {
		t = (at[0].x * at[0].x - a * a) / (b * b - a * a);
		length *= at[0].x;
	}
	return length > 0 ? (low + t * (high - low)) / (length * gap) : 0;
}

/* The velocities U1', U2' of the fluid at the surfaces and their derivatives along the axis. The condition of slip,
 *   (h + 4 b1) U1' + 2 b1 U2' = h U1 + 6 b1 m,   m = q/h the mean,
 * and that of the upper surface have derivatives of the same form: dU1', dU2' in place of U1', U2', (U1 - U1') dh/h in
 * place of U1, and dm = (dq - m dh)/h in place of m. */
static void add_slip(const struct ts_film *f, int axis, double flow_rate, struct ts_film_point *out)
{
	double mean = out->mean[axis], h = out->gap, rate = (flow_rate - mean * out->slope[axis]) / h;
	double wall[2], fluid[2], change[2];

	for (int side = 0; side < 2; side++)
		wall[side] = out->wall[side][axis];
	ts_film_slip_velocity(f, h, mean, wall, fluid);
	for (int side = 0; side < 2; side++) {
		out->fluid[side][axis] = fluid[side];
		wall[side] = (wall[side] - fluid[side]) * out->slope[axis] / h;
	}
	ts_film_slip_velocity(f, h, rate, wall, change);
	for (int side = 0; side < 2; side++)
		out->stretch[side] += change[side];
}

static bool touches_solid(const struct ts_film *f, const struct place at[2])
{
	for (int b = 0; b < 2; b++)
		for (int a = 0; a < 2; a++)
			if (f->kind[ts_film_at(f, at[0].near[a], at[1].near[b])] == TS_FILM_SOLID)
				return true;
	return false;
}

/* Linear between centres and on to the edges; constant in the cell if stepped, or beside cells that are solid. */
static void sample_field(const struct ts_film *f, const double *field, const struct place at[2],
			 double *value, double slope[2])
{
	*value = field[ts_film_at(f, at[0].cell, at[1].cell)];
	slope[0] = slope[1] = 0;
	if (f->shape == TS_FILM_STEPPED || touches_solid(f, at))
		return;
	*value = interpolate(f, field, at);
	for (int axis = 0; axis < 2; axis++) {
		slope[axis] = slope_along(f, field, axis, at);
		if (!(at[axis].apart > 0))
			*value += slope[axis] * (at[axis].x - ts_film_centre(f, axis, at[axis].cell)) *
				  (f->polar && axis == 1 ? at[0].x : 1);
	}
}

TS_INLINE void find_places(const struct ts_film *f, const double x[2], struct place at[2])
{
	find_place(f, 0, x[0], &at[0]);
	find_place(f, 1, x[1], &at[1]);
}

void ts_film_interpolate(const struct ts_film *f, const double *field, const double x[2], double *value,
			 double slope[2])
{
	struct place at[2];

	find_places(f, x, at);
	sample_field(f, field, at, value, slope);
}

/* The gap is at least half of that at the centre, as for the flow through edges. */
static void sample_gap(const struct ts_film *f, const struct place at[2], struct ts_film_point *out)
{
	double least = f->gap[ts_film_at(f, at[0].cell, at[1].cell)] / 2, unused[2];

	sample_field(f, f->gap, at, &out->gap, out->slope);
	sample_field(f, f->rate, at, &out->rate, unused);
	if (out->gap < least && (!(at[0].apart > 0) || !(at[1].apart > 0)))
		out->gap = least;
}

/* Linear between centres, and to the pressure on the edges. */
static double sample_pressure(const struct ts_film *f, const struct place at[2])
{
	double p = interpolate(f, f->p, at);

	for (int axis = 0; axis < 2; axis++) {
		const int k = at[axis].cell;
		const double away = at[axis].x - ts_film_centre(f, axis, k);
		const int up = away > 0;

		if (at[axis].apart > 0 || away == 0)
			continue;
		for (int side = 0; side < 2; side++) {
			int cell[2] = { at[0].cell, at[1].cell }, face[2];
			struct ts_film_sides s;

			cell[1 - axis] = at[1 - axis].near[side];
			face[axis] = k + up;
			face[1 - axis] = cell[1 - axis];
			s = ts_film_sides_of(f, axis, face[0], face[1]);
			p += at[1 - axis].weight[side] * fabs(away) * 2 /
			     (f->face[axis][k + 1] - f->face[axis][k]) *
			     (ts_film_end_pressure(f, axis, face[0], face[1], &s) -
			      f->p[ts_film_at(f, cell[0], cell[1])]);
		}
	}
	return p;
}

static void sample_places(const struct ts_film *f, const struct place at[2], struct ts_film_point *out)
{
	size_t c = ts_film_at(f, at[0].cell, at[1].cell);

	out->p = touches_solid(f, at) ? f->p[c] : sample_pressure(f, at);
	out->empty = f->empty[c];
	for (int axis = 0; axis < 2; axis++)
		for (int side = 0; side < 2; side++)
			out->wall[side][axis] = interpolate(f, f->velocity[side][axis], at);
	sample_gap(f, at, out);
	out->stretch[0] = out->stretch[1] = 0;
	for (int axis = 0; axis < 2; axis++) {
		double rate;

		out->fluid[0][axis] = out->wall[0][axis];
		out->fluid[1][axis] = out->wall[1][axis];
		out->mean[axis] = (out->wall[0][axis] + out->wall[1][axis]) / 2;
		if (f->kind[c] == TS_FILM_SOLID)
			continue;
		out->mean[axis] = mean_along(f, axis, at, out->gap, &rate);
		if (ts_film_slips(f))
			add_slip(f, axis, rate, out);
	}
}

void ts_film_sample(const struct ts_film *f, const double x[2], struct ts_film_point *out)
{
	struct place at[2];

	find_places(f, x, at);
	sample_places(f, at, out);
}

void ts_film_sample_with(const struct ts_film *f, const double *field, const double x[2],
			 struct ts_film_point *out, double *value, double slope[2])
{
	struct place at[2];

	find_places(f, x, at);
	sample_places(f, at, out);
	sample_field(f, field, at, value, slope);
}

/* With S = int_h1^z u dz = h (f1 U1 + f2 U2) + f3 (q - h (U1 + U2)/2), div q = -dh/dt and grad s = -(grad h1 + s
 * grad h)/h: w = dh1/dt - div S at constant z; U1 and U2 are those of the fluid, of divergence `stretch`. */
void ts_film_profile(const struct ts_film_point *point, double s, const double lower_slope[2],
		     double lower_rate, double u[3])
{
	double f1 = s - s * s / 2, f2 = s * s / 2, f3 = s * s * (3 - 2 * s),
	       w = lower_rate + f3 * point->rate -
		   point->gap * ((f1 - f3 / 2) * point->stretch[0] + (f2 - f3 / 2) * point->stretch[1]);

	for (int axis = 0; axis < 2; axis++) {
		double low = point->fluid[0][axis], high = point->fluid[1][axis], mean = (low + high) / 2;

		u[axis] = low * (1 - s) + high * s + 6 * s * (1 - s) * (point->mean[axis] - mean);
		w += u[axis] * (lower_slope[axis] + s * point->slope[axis]) -
		     (f1 * low + f2 * high - f3 * mean) * point->slope[axis];
	}
	u[2] = w;
}
