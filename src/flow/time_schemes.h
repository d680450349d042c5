/* Schemes in time: tables of numbers. */
#ifndef TS_FLOW_TIME_SCHEMES_H
#define TS_FLOW_TIME_SCHEMES_H

#include <stdbool.h>

enum { TS_MOST_STAGES = 3 };

/* Each stage is u <- keep u(beginning) + take (u + dt rate(u)), projected. */
struct ts_flow_time_scheme {
	const char *name, *help;
	int order, stages;
	double keep[TS_MOST_STAGES], take[TS_MOST_STAGES];
	double at[TS_MOST_STAGES]; /* the time a stage ends at, in steps */
	double pressure_at[TS_MOST_STAGES]; /* when it takes the pressure that is given on faces */
	bool history;              /* uses the rate of the step before */
	/* How far the region of stability of du/dt = z u goes along the negative real and along the imaginary
	 * axis; 0: not at all. */
	double real, imaginary;
	/* Courant number sum |u| dt/h that is never exceeded: 1 for euler, where it follows from the limits of
	 * decay and growth; of second order, what little viscosity stands. */
	double courant;
};

enum ts_flow_time { TS_TIME_EULER, TS_TIME_AB2, TS_TIME_RK2, TS_TIME_RK3, TS_NTIME };
extern const struct ts_flow_time_scheme ts_flow_time_schemes[TS_NTIME];
extern const char *const ts_flow_time_names[];

#endif
