#include "flow/time_schemes.h"

#include <stddef.h>

#include "base/banned.h"

/* Gottlieb, Shu & Tadmor, SIAM Rev. 43 (2001) 89: Runge-Kutta schemes made of Euler steps. */
const struct ts_flow_time_scheme ts_flow_time_schemes[TS_NTIME] = {
	[TS_TIME_EULER] = { .name = "euler",
			    .help = "explicit Euler, first order",
			    .order = 1,
			    .stages = 1,
			    .take = { 1 },
			    .at = { 1 },
			    .pressure_at = { 1 / 2. },
			    .real = 2,
			    .courant = 1 },
	[TS_TIME_AB2] = { .name = "ab2",
			  .help = "Adams-Bashforth, second order, at the cost of euler",
			  .order = 2,
			  .stages = 1,
			  .take = { 1 },
			  .at = { 1 },
			  .pressure_at = { 1 / 2. },
			  .history = true,
			  .real = 1,
			  .courant = 0.7 },
	[TS_TIME_RK2] = { .name = "rk2",
			  .help = "Heun, second order, two projections in a step",
			  .order = 2,
			  .stages = 2,
			  .keep = { 0, 1 / 2. },
			  .take = { 1, 1 / 2. },
			  .at = { 1, 1 },
			  .pressure_at = { 0, 1 },
			  .real = 2,
			  .courant = 1 },
	[TS_TIME_RK3] = { .name = "rk3",
			  .help = "Shu-Osher, third order, three projections in a step",
			  .order = 3,
			  .stages = 3,
			  .keep = { 0, 3 / 4., 1 / 3. },
			  .take = { 1, 1 / 4., 2 / 3. },
			  .at = { 1, 1 / 2., 1 },
			  .pressure_at = { 0, 1, 1 / 2. },
			  .real = 2.5127453266183286,
			  .imaginary = 1.7320508075688772,
			  .courant = 1.7320508075688772 },
};

const char *const ts_flow_time_names[] = {
	[TS_TIME_EULER] = "euler", [TS_TIME_AB2] = "ab2", [TS_TIME_RK2] = "rk2",
	[TS_TIME_RK3] = "rk3",	   [TS_NTIME] = NULL,
};
