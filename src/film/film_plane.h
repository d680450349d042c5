/* A rigid plane above the film of flow_style reynolds that moves by the forces of the film: the face of fix wafer. */
#ifndef TS_FILM_FILM_PLANE_H
#define TS_FILM_FILM_PLANE_H

#include "film/film_flow.h"

enum ts_film_move {
	TS_FILM_KEEP,  /* a run begins or resumes: the plane stays, unless it has no place yet */
	TS_FILM_SETUP, /* the first forces of a run: no time passes */
	TS_FILM_STEP   /* a step after the present place */
};

/* First member of the state of fixes of TS_FAMILY_FILM_PLANE. The plane is z + s_1 (x - x_0) + s_2 (y - y_0). */
struct ts_film_plane {
	double place[2]; /* x_0, y_0; known after init */
	double pose[3];	 /* z, s_1, s_2 */
	double rate[3];	 /* their rates */
	/* Called by the flow style, which has evaluated all else: moves the plane to its place at this time and solves the film
	 * below it by flow->solve. NULL: its init has failed. */
	enum ts_status (*move)(struct ts_instance *self, struct tsim *sim, struct ts_instance *flow,
			       enum ts_film_move how);
};

/* The plane of an upper surface; NULL: none. */
static inline struct ts_film_plane *ts_film_plane_of(const struct ts_film_surface *s)
{
	return s->plane_fix ? s->plane_fix->state : NULL;
}

/* Sets height and rate of the upper surface from its plane. */
void ts_film_plane_evaluate(struct ts_film_flow *flow);

/* Forces of the film on its plane: along z, moments of these about the axes through place (sums of p - ambient times x and y),
 * and along x and y: of shear, of the pressure on the slope, of the friction of asperities. */
struct ts_film_push {
	double normal, moment[2], along[2];
	double touch; /* the part of asperities in `normal` */
};
void ts_film_plane_push(const struct ts_film_flow *flow, struct ts_film_push *out);

/* Derivatives of normal and moments (rows) by pose and by rate, after a solution. */
enum ts_status ts_film_plane_slopes(struct ts_film_flow *flow, double by_pose[3][3], double by_rate[3][3],
				    struct ts_error *error);

/* Least gap, less that for which the film is known, and the largest part, at most 1, of a change of the pose that leaves each
 * cell a third of it. */
double ts_film_plane_clearance(const struct ts_film_flow *flow);
double ts_film_plane_reach(const struct ts_film_flow *flow, const double change[3]);

#endif
