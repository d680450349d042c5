/* Time integration schemes as tables of coefficients. */
#ifndef TS_FLOW_TIME_SCHEMES_H
#define TS_FLOW_TIME_SCHEMES_H

#include <stdbool.h>

enum { TS_MOST_STAGES = 3 };

/* Each stage is u <- keep u(beginning) + take (u + dt rate(u)), then projected. */
struct ts_flow_time_scheme {
	const char *name, *help;
	int order, stages;
	double keep[TS_MOST_STAGES], take[TS_MOST_STAGES];
	double at[TS_MOST_STAGES];	    /* time at the end of a stage, in steps */
	double pressure_at[TS_MOST_STAGES]; /* time of the pressure given on faces in a stage, in steps */
	bool history;			    /* uses the rate of change in the step before */
	/* Extent of the stability region of du/dt = z u along the negative real and along the imaginary
	 * axis; 0: none. */
	double real, imaginary;
	/* Largest Courant number sum |u| dt/h: 1 for euler, where it follows from the limits of decay and
	 * growth; for schemes of second order the value that is stable with little viscosity. */
	double courant;
};

enum ts_flow_time { TS_TIME_EULER, TS_TIME_AB2, TS_TIME_RK2, TS_TIME_RK3, TS_NTIME };
extern const struct ts_flow_time_scheme ts_flow_time_schemes[TS_NTIME];
extern const char *const ts_flow_time_names[];

#endif
