/* The film of flow_style reynolds: what other styles read of it, and the surfaces that bound it. */
#ifndef TS_FILM_FILM_FLOW_H
#define TS_FILM_FILM_FLOW_H

#include "core/sim.h"
#include "film/film.h"

#define TS_FAMILY_FILM "film"
#define TS_FAMILY_FILM_PLANE "plane of a film"

struct ts_voxel_surface;

/* A surface z = h(x, y, t). */
struct ts_film_surface {
	struct ts_number height; /* argument: a number, or a formula of the coordinates; null: not given */
	const char *voxel;	 /* argument: ID of a fix surface/voxel, or NULL */
	const char *plane_id;	 /* argument, upper: ID of a fix of TS_FAMILY_FILM_PLANE, or NULL */
	double velocity[3];	 /* argument: of the material */
	bool stays;		 /* argument: the shape does not move with the material */

	struct ts_voxel_surface *field; /* that of `voxel` */
	struct ts_instance *plane_fix;	/* that of `plane_id`; NULL: none */
	double now[3];			/* velocity at present: `velocity` and that of the field */
	double *z,
		*rate; /* height at the centres of the film, its rate without that of a shape that moves; owned */
};

/* First member of the state of styles of TS_FAMILY_FILM. */
struct ts_film_flow {
	struct ts_film film;
	struct ts_film_surface surface[2]; /* lower, upper */
	double *bottom;	    /* height of the lower surface below the gap, at most the upper one; owned */
	double *yield;	    /* change of the gap with the distance of the surfaces; owned */
	double *carried;    /* scratch; owned */
	double least;	    /* argument: least gap; 0: none */
	bool solid;	    /* there is no fluid where the gap is not positive */
	bool transient;	    /* argument: the fluid in the gap is followed in time */
	const char *set[3]; /* internal variables that receive the coordinates */
	/* Solves the film below the plane as it is; `self` is the flow style. */
	enum ts_status (*solve)(struct ts_instance *self, struct tsim *sim);
};

/* The live film; an error in the name of `who` if there is none. */
enum ts_status ts_film_flow_require(struct tsim *sim, const char *who, const struct ts_place *where,
				    struct ts_film_flow **out);

/* Finds the voxel field, checks that the surface is given once. `name`: "lower" or "upper". */
enum ts_status ts_film_surface_find(struct ts_instance *self, struct tsim *sim, struct ts_film_surface *s,
				    const char *name);
/* Computes z, rate and now at this time. The upper voxel field hangs from its height. */
enum ts_status ts_film_surface_evaluate(struct ts_instance *self, struct tsim *sim, struct ts_film_flow *flow,
					int side);
/* Computes gap, kinds, rate and velocities of the film, bottom and yield from the surfaces. */
void ts_film_combine(struct ts_film_flow *flow);
/* The flow whose upper surface is the plane of this fix, or NULL. */
struct ts_instance *ts_film_flow_below(const struct tsim *sim, const struct ts_instance *plane);

#endif
