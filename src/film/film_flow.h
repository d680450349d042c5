/* The film of flow_style reynolds: what other styles read of it, and the surfaces that bound it. */
#ifndef TS_FILM_FILM_FLOW_H
#define TS_FILM_FILM_FLOW_H

#include "core/sim.h"
#include "film/film.h"

#define TS_FAMILY_FILM "film"

struct ts_voxel_surface;

/* A surface z = h(x, y, t). */
struct ts_film_surface {
	struct ts_number height; /* argument: a number, or a formula of the coordinates; null: not given */
	const char *voxel;	 /* argument: ID of a fix surface/voxel, or NULL */
	double velocity[3];	 /* argument: of the material */
	bool stays;		 /* argument: the shape does not move with the material */

	struct ts_voxel_surface *field; /* that of `voxel` */
	double now[3];			/* velocity at present: `velocity` and that of the field */
	double *z, *rate;		/* h and dh/dt at the centres of the film; owned */
};

/* First member of the state of styles of TS_FAMILY_FILM. */
struct ts_film_flow {
	struct ts_film film;
	struct ts_film_surface surface[2]; /* lower, upper */
	const char *set[3];		   /* internal variables that receive the coordinates */
};

/* The live film; an error in the name of `who` if there is none. */
enum ts_status ts_film_flow_require(struct tsim *sim, const char *who, const struct ts_place *where,
				    struct ts_film_flow **out);

/* Finds the voxel field, checks that the surface is given once. `name`: "lower" or "upper". */
enum ts_status ts_film_surface_find(struct ts_instance *self, struct tsim *sim, struct ts_film_surface *s,
				    const char *name);
/* Computes z, rate and now at this time. */
enum ts_status ts_film_surface_evaluate(struct ts_instance *self, struct tsim *sim,
					const struct ts_film_flow *flow, struct ts_film_surface *s);

#endif
