/* An impact: the time during which one particle touches one surface - all elements of one fix: a mesh, a
 * field of voxels, a primitive wall - without interruption. Laws of erosive wear are functions of it. */
#ifndef TS_WALL_IMPACT_EVENT_H
#define TS_WALL_IMPACT_EVENT_H

#include <math.h>

/* All members are numbers of type double, so that restart files store an event as a row of numbers. */
struct ts_impact_event {
	double tag, type; /* of the particle */
	/* Of the surface, from 0: touched first; of several touched in the same step the one with the
	 * largest overlap. */
	double element;
	double mass, radius;	/* of the particle */
	double velocity[3];	/* of its centre relative to the surface at the contact point, at entry */
	double omega[3];	/* angular velocity of the particle at entry */
	double normal[3];	/* of the surface at entry, unit vector, towards the particle */
	double point[3];	/* contact point at entry, in the frame of the surface */
	double begin, duration; /* time */
	double peak_force, peak_overlap; /* maximum of the normal force and of the overlap */
	double impulse;			 /* integral of the normal force over time */
	double slip, work; /* path of the contact point along the surface, and the work of friction on it */
};

#define TS_IMPACT_EVENT_NUMBERS (sizeof(struct ts_impact_event) / sizeof(double))

/* Component of the entry velocity towards the surface; 0 if the particle did not approach it, NaN if the velocity or
 * the normal is not a number. */
static inline double ts_impact_normal_speed(const struct ts_impact_event *e)
{
	double towards = -(e->velocity[0] * e->normal[0] + e->velocity[1] * e->normal[1] +
			   e->velocity[2] * e->normal[2]);

	return towards <= 0 ? 0 : towards;
}

/* Component of the entry velocity along the surface. */
static inline double ts_impact_tangential_speed(const struct ts_impact_event *e)
{
	double along[3], away = e->velocity[0] * e->normal[0] + e->velocity[1] * e->normal[1] +
				e->velocity[2] * e->normal[2];

	for (int c = 0; c < 3; c++)
		along[c] = e->velocity[c] - away * e->normal[c];
	return sqrt(along[0] * along[0] + along[1] * along[1] + along[2] * along[2]);
}

/* Between the entry velocity and the surface, rad: pi/2 is a normal impact. 0 if both speeds are 0. */
static inline double ts_impact_angle(const struct ts_impact_event *e)
{
	return atan2(ts_impact_normal_speed(e), ts_impact_tangential_speed(e));
}

static inline double ts_impact_speed(const struct ts_impact_event *e)
{
	return hypot(ts_impact_normal_speed(e), ts_impact_tangential_speed(e));
}

/* Kinetic energy of translation relative to the surface at entry. */
static inline double ts_impact_energy(const struct ts_impact_event *e)
{
	double v = ts_impact_speed(e);

	return 0.5 * e->mass * v * v;
}

#endif
