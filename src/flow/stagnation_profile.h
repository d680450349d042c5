/* Laminar stagnation flow of a viscous fluid at a plane: the similarity solution of K. Hiemenz (plane flow,
 * Dingler's Polytech. J. 326 (1911) 321) and F. Homann (axisymmetric flow, Z. Angew. Math. Mech. 16 (1936)
 * 153).
 *
 * With U = A r the tangential velocity far from the plane, s = z sqrt(A/nu) and k = 1 (plane) or 2
 * (axisymmetric) the velocities are u = A r f'(s), w = -k sqrt(A nu) f(s), where
 *   f''' + k f f'' + 1 - f'^2 = 0, f(0) = f'(0) = 0, f'(infinity) = 1. */
#ifndef TS_FLOW_STAGNATION_PROFILE_H
#define TS_FLOW_STAGNATION_PROFILE_H

enum { TS_STAGNATION_POINTS = 201 };

struct ts_stagnation_profile {
	double f[TS_STAGNATION_POINTS][3]; /* f, f', f'' at s = 0, 0.05, 0.1 ... 10 */
};

/* Solves the equation by shooting; f and f' are exact to 1e-10. k: 1 or 2. */
void ts_stagnation_solve(struct ts_stagnation_profile *profile, int k);
/* f and f' at s >= 0; f' is the derivative of the interpolated f to round-off, so that the velocity has no
 * divergence. */
void ts_stagnation_at(const struct ts_stagnation_profile *profile, double s, double *f, double *slope);

#endif
