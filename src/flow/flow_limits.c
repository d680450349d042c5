/* Stability limits of the time step of the fluid.
 *
 * Von Neumann analysis with velocities and widths frozen: a wave of du/dt = -u grad u + nu lap u has a
 * frequency of at most C = sum |u|/h and a decay rate of at most D = sum (nu lambda + kappa |u|/h), with
 * lambda = 4/h^2 the largest eigenvalue of the second difference, 8/(sqrt(3) h^2) beside a wall with the
 * quadratic profile, and kappa the contribution of the convection scheme. A time scheme is stable for dt D
 * up to its limit on the real axis and dt C up to that on the imaginary axis.
 *
 * With explicit Euler and central differences waves of too little decay grow slowly: stable for dt sum
 * u^2/(2 nu) <= 1, with nu + gamma |u| h/2 in place of nu for donor cells: A. C. Hindmarsh, P. M. Gresho &
 * D. F. Griffiths, Int. J. Numer. Meth. Fluids 4 (1984) 853. The schemes of second order, ab2 and rk2,
 * amplify by (dt C)^4/4 and (dt C)^4/8 per step: stable for 1.185/8 (dt C)^4 <= dt nu_least/h^2, rk2 for
 * half of it; QUICK itself damps these waves, of wave number k, at the rate C (k h)^4/16: sufficient for
 * (dt C)^3 <= 0.2 (measured), 1/2 with rk2. */
#include <math.h>

#include "flow/flow_limits.h"
#include "flow/implicit_viscosity.h"

#include "base/banned.h"

/* Largest eigenvalue of the second differences along axis d (1/length^2). */
static double largest_eigenvalue(const struct ts_projection *p, int d)
{
	static const double BESIDE_WALL = 1.1547005383792515; /* 2/sqrt(3) */
	const struct ts_grid *grid = &p->fluid.grid;
	const struct ts_operator_line *line = &p->operators.centred[d];
	int n = grid->n[d];
	double most = 0;

	for (int i = 0; i < n; i++) {
		double number = 2 * (line->below[i] + line->above[i]);
		enum ts_grid_side side = i == 0 ? TS_LOW : TS_HIGH;
		bool beside = (i == 0 || i == n - 1) && !grid->periodic[d];
		bool sticks = beside && (p->fluid.face[d][side] == TS_FLOW_WALL ||
					 p->fluid.face[d][side] == TS_FLOW_INLET);

		if (sticks && p->wall == TS_WALL_QUADRATIC)
			number *= BESIDE_WALL;
		most = fmax(most, number);
	}
	return most;
}

/* Contribution of the convection scheme to the decay rate, by |u|/h. */
static double convective_decay(const struct ts_projection *p)
{
	double share = p->convection == TS_CONVECTION_DONOR ? p->gamma : 1;

	return share * ts_convection_schemes[p->convection].decay;
}

/* Rates at a cell (1/time), and the largest ones over the grid. */
struct rates {
	double frequency; /* C */
	double growth;	  /* 1/(largest step by the limit of slow growth) */
};

struct weak_damping {
	enum { WEAK_NONE, WEAK_EULER, WEAK_FOURTH } kind;
	double nu, gamma, factor;
	double most; /* largest Courant number with the damping by QUICK alone */
};

static double growth_rate(const struct weak_damping *weak, const double u[3], const double h[3],
			  double frequency)
{
	double sum = 0, least = INFINITY;

	for (int d = 0; d < 3; d++) {
		double nu = weak->nu + 0.5 * weak->gamma * u[d] * h[d];

		if (u[d] > 0)
			sum += u[d] * u[d] / (2 * nu);
		if (isfinite(h[d]))
			least = fmin(least, nu / (h[d] * h[d]));
	}
	if (weak->kind == WEAK_EULER)
		return sum;
	return weak->kind == WEAK_FOURTH && frequency > 0
		       ? fmin(frequency * cbrt(weak->factor * frequency / least), frequency / weak->most)
		       : 0;
}

static struct rates row_rates(const struct ts_fluid *fluid, const struct weak_damping *weak, int j, int k)
{
	const struct ts_grid *grid = &fluid->grid;
	const bool solid = grid->dimensions == 3;
	struct rates most = { 0 };

	for (int i = 0; i < grid->n[0]; i++) {
		size_t at = ts_at(grid, i, j, k);
		double u[3] = { 0 }, frequency = 0;
		double h[3] = { grid->width[0][i], grid->width[1][j], solid ? grid->width[2][k] : INFINITY };

		for (int d = 0; d < grid->dimensions; d++) {
			u[d] = fmax(fabs(fluid->u[d][at]), fabs(fluid->u[d][at + (size_t)grid->stride[d]]));
			frequency += u[d] / h[d];
		}
		most.frequency = fmax(most.frequency, frequency);
		most.growth = fmax(most.growth, growth_rate(weak, u, h, frequency));
	}
	return most;
}

/* Velocities of moving walls and inlets count as well: a fluid at rest beside them will take them. */
static struct rates boundary_rates(const struct ts_fluid *fluid, const struct weak_damping *weak, int d,
				   enum ts_grid_side side)
{
	const struct ts_grid *grid = &fluid->grid;
	const struct ts_flow_face_velocity *given = &fluid->face_velocity[d][side];
	const int a = d == 0, b = d == 2 ? 1 : 2;
	struct rates most = { 0 };

	for (int ib = 0; ib < grid->n[b]; ib++)
		for (int ia = 0; ia < grid->n[a]; ia++) {
			size_t at = ts_flow_plane_at(grid, d, ia, ib);
			double u[3] = { 0 }, h[3] = { INFINITY, INFINITY, INFINITY }, frequency = 0;

			h[d] = grid->width[d][side == TS_LOW ? 0 : grid->n[d] - 1];
			h[a] = grid->width[a][ia];
			h[b] = b < grid->dimensions ? grid->width[b][ib] : INFINITY;
			for (int e = 0; e < grid->dimensions; e++) {
				u[e] = fabs(given->plane[e] ? given->plane[e][at] : given->constant[e]);
				frequency += u[e] / h[e];
			}
			most.frequency = fmax(most.frequency, frequency);
			most.growth = fmax(most.growth, growth_rate(weak, u, h, frequency));
		}
	return most;
}

static struct rates all_boundary_rates(const struct ts_fluid *fluid, const struct weak_damping *weak)
{
	struct rates most = { 0 };

	for (int d = 0; d < fluid->grid.dimensions; d++)
		for (enum ts_grid_side side = TS_LOW; side <= TS_HIGH; side++) {
			struct rates face = { 0 };

			if (fluid->face[d][side] == TS_FLOW_WALL || fluid->face[d][side] == TS_FLOW_INLET)
				face = boundary_rates(fluid, weak, d, side);
			most.frequency = fmax(most.frequency, face.frequency);
			most.growth = fmax(most.growth, face.growth);
		}
	return most;
}

static struct weak_damping find_weak_damping(const struct ts_projection *p)
{
	static const double FOURTH = 1.185 / 8, QUICK_AB2 = 0.58, QUICK_RK2 = 0.79;
	const struct ts_flow_time_scheme *scheme = &ts_flow_time_schemes[p->time];
	struct weak_damping weak = { .nu = p->viscosity / p->density,
				     .gamma = p->convection == TS_CONVECTION_DONOR ? p->gamma : 0 };

	if (scheme->order == 1)
		weak.kind = WEAK_EULER;
	else if (!(scheme->imaginary > 0))
		weak.kind = WEAK_FOURTH;
	weak.factor = scheme->history ? FOURTH : FOURTH / 2;
	if (ts_convection_schemes[p->convection].order > 2)
		weak.most = scheme->history ? QUICK_AB2 : QUICK_RK2;
	return weak;
}

static double sum_of_eigenvalues(const struct ts_projection *p)
{
	double sum = 0;

	for (int d = 0; d < p->fluid.grid.dimensions; d++)
		sum += largest_eigenvalue(p, d);
	return sum;
}

double ts_flow_viscous_limit(const struct ts_projection *p)
{
	if (p->viscous != TS_VISCOUS_EXPLICIT)
		return INFINITY;
	return ts_flow_time_schemes[p->time].real / (p->viscosity / p->density * sum_of_eigenvalues(p));
}

struct ts_flow_limits ts_flow_limits(const struct ts_projection *p)
{
	const struct ts_fluid *fluid = &p->fluid;
	const struct ts_grid *grid = &fluid->grid;
	const struct ts_flow_time_scheme *scheme = &ts_flow_time_schemes[p->time];
	const struct weak_damping weak = find_weak_damping(p);
	const struct rates faces = all_boundary_rates(fluid, &weak);
	long first, end;
	double frequency = faces.frequency, growth = faces.growth, numbers = 0;

	ts_slabs_rows(&p->slabs, grid->n[2], grid->n[1], 0, &first, &end);
#pragma omp parallel for num_threads(p->poisson.threads) schedule(static) reduction(max : frequency, growth)
	for (long line = first; line < end; line++) {
		struct rates row =
			row_rates(fluid, &weak, (int)(line % grid->n[1]), (int)(line / grid->n[1]));

		frequency = fmax(frequency, row.frequency);
		growth = fmax(growth, row.growth);
	}
	if (p->slabs.active) {
		double most[] = { frequency, growth };

		ts_world_most(p->slabs.world, most, 2);
		frequency = most[0];
		growth = most[1];
	}
	if (p->viscous == TS_VISCOUS_EXPLICIT)
		numbers = weak.nu * sum_of_eigenvalues(p);
	return (struct ts_flow_limits){
		.viscous = scheme->real / (numbers + convective_decay(p) * frequency),
		.courant = scheme->courant / frequency,
		.growth = 1 / growth,
	};
}

double ts_flow_limit(const struct ts_projection *p)
{
	struct ts_flow_limits limits = ts_flow_limits(p);

	return fmin(limits.viscous, fmin(limits.courant, limits.growth));
}
