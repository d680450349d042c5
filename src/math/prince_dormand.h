/* Steps of the Runge-Kutta pair of orders 8 and 7 with 13 stages, for small autonomous systems y' = f(y).
 *
 * P. J. Prince, J. R. Dormand, High order embedded Runge-Kutta formulae, J. Comput. Appl. Math. 7 (1981) 67, RK8(7)13M.
 * All numbers of a state are advanced side by side; several steps from one state share its first stage. */
#ifndef TS_MATH_PRINCE_DORMAND_H
#define TS_MATH_PRINCE_DORMAND_H

#include <stddef.h>

/* Largest number of numbers in a state. */
enum { TS_PRINCE_DORMAND_MOST = 16 };
enum { TS_PRINCE_DORMAND_STAGES = 13 };

struct ts_prince_dormand {
	/* dy = f(y); both hold n numbers */
	void (*derivative)(const double *y, double *dy, const void *context);
	const void *context;
	size_t n;
	double y[TS_PRINCE_DORMAND_MOST]; /* where steps start */
	double k[TS_PRINCE_DORMAND_STAGES][TS_PRINCE_DORMAND_MOST];
};

/* Steps start from y[n] from now on. */
void ts_prince_dormand_start(struct ts_prince_dormand *s, const double *y);
/* The state `to` after a step h, of order 8; `error`: its difference from that of order 7. Both have room for
 * TS_PRINCE_DORMAND_MOST numbers. */
void ts_prince_dormand_step(struct ts_prince_dormand *s, double h, double *to, double *error);

#endif
