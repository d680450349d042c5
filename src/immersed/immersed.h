/* Direct forcing: the fluid takes the velocity of solids in it.
 *
 * Every point of a velocity component inside a solid gets the velocity of the solid. A point of the fluid so
 * near to the surface that a neighbour may be inside gets the value on the parabola along the normal n
 * through the velocity v_s of the surface and those of the fluid at two places farther out,
 *
 *   u(x) = v_s + 2 d/(d + l) (u(x + l n) - v_s) - d/(d + 2 l) (u(x + 2 l n) - v_s),
 *
 * d the distance of x from the surface, l = 1/sqrt(sum n_i^2/h_i^2) the spacing along n (Fadlun et al., J.
 * Comput. Phys. 161 (2000) 35, and along the normal Balaras, Comput. Fluids 33 (2004) 375, with lines): the
 * surface is met to second order in h. The value counts fully near the surface and fades out towards
 * d = max |n_i| h_i, where no neighbour is inside any more, so forces stay smooth as the solid moves over the
 * points (Luo et al., Comput. Fluids 56 (2012) 61).
 *
 * Predictors of a projection do not have the pressure gradient yet, so the projection would take it from what was
 * set. Inside, down to a cell or so below the surface, the velocities get the gradient of the pressure
 * before in advance: after the first steps those of a solid at rest are exactly met. Farther in they do
 * not, so that there the pressure stays a smooth continuation of that at the surface.
 *
 * Force on a solid: what was given to the fluid, with the opposite sign, and the rate of the momentum of the
 * fluid inside, which is no fluid in fact (Uhlmann, J. Comput. Phys. 209 (2005) 448; Kempe & Froehlich,
 * J. Comput. Phys. 231 (2012) 3663):
 *
 *   F = -sum rho (u_forced - u_before) V/dt + d/dt integral_inside rho u dV */
#ifndef TS_IMMERSED_IMMERSED_H
#define TS_IMMERSED_IMMERSED_H

#include "flow/fluid.h"
#include "immersed/solid.h"

/* A point of one velocity component that is forced, or whose control volume is cut by the surface. */
struct ts_immersed_point {
	size_t at;     /* in the field */
	int32_t part;
	int32_t index; /* along the axis of the component: for the pressure gradient */
	double arm[3]; /* from the centre of the part */
	double volume; /* of the control volume */
	double solid;  /* what part of it is inside */
	double target; /* velocity it is to have, without pressure gradient */
	double before; /* the forcing */
	bool deep;     /* far from the surface */
	bool outside;  /* in the fluid: there is a band for it */
};

/* A place in the fluid: where it lies among the points of the component. */
struct ts_immersed_sample {
	size_t corner;	/* of the cell of points around it, the lowest */
	int32_t index;	/* along the axis of the component */
	double t[3];	/* where in that cell: 0..1 */
	double count;	/* what the velocity there counts */
};

/* A point that is in the fluid, and the places farther out. */
struct ts_immersed_outer {
	size_t point;
	double weight;	/* of the forcing */
	double surface; /* v_s */
	struct ts_immersed_sample out[2];
	double next;
};

struct ts_immersed_sums {
	double impulse[3], twist[3]; /* given to the fluid by the forcing since the beginning */
	double stage[6];	     /* the same, of the substep that is under way */
	double volume;		     /* inside, counted in cells */
	double velocity[3], spin[3]; /* mean of u, and of (x - X) x u about the mean place X */
};

/* Of a point that a thread has found before it is known whose it is. */
struct ts_immersed_candidate {
	double distance, thickness, rate;
};

struct ts_immersed {
	struct ts_immersed_point *point; /* of component 0, 1, 2: from first[c] to first[c + 1] */
	struct ts_immersed_outer *band;
	size_t npoints, point_capacity, nbands, band_capacity;
	size_t first[4], band_first[4];
	double *distance; /* scratch for many parts: least distance at each point, and whose it is */
	int32_t *owner;
	struct ts_immersed_sums *sums; /* of each part */
	size_t sums_capacity;
	size_t inside;	  /* points inside solids */
	double thickness; /* twice the largest distance from the surface inside, in cells */
	double rate;	  /* largest velocity of a solid by spacing: cells per time */
	double first_dt;  /* of the first stage of this substep; 0: it has not begun */
	struct ts_immersed *chunk; /* scratch of threads: what each has found, */
	size_t chunks, chunk_capacity;
	struct ts_immersed_candidate *note; /* and notes of its points */
	size_t note_capacity;
	enum ts_status status;
};

void ts_immersed_release(struct ts_immersed *ib);

/* Refuses a part that is fewer than `least` cells across; `spheres`: parts are particles. immersed_size.c */
enum ts_status ts_immersed_check_size(struct tsim *sim, const struct ts_place *where,
				      const struct ts_solid *solid, const struct ts_grid *grid, bool spheres,
				      double least);

/* Finds the points, after the solid has moved. */
enum ts_status ts_immersed_find_points(struct ts_immersed *ib, struct ts_solid *solid,
				 const struct ts_fluid *fluid);
/* A step of the fluid begins: nothing has been given. */
void ts_immersed_begin_step(struct ts_immersed *ib, size_t parts);
/* A substep has ended. */
void ts_immersed_end_substep(struct ts_immersed *ib, size_t parts);
/* Changes the predictor fluid->u; adds up what it gives. */
void ts_immersed_force(struct ts_immersed *ib, struct ts_fluid *fluid, size_t parts, double dt,
		       int iterations);
/* After a step: volume, velocity and spin of the fluid inside. */
enum ts_status ts_immersed_inner_fluid(struct ts_immersed *ib, const struct ts_fluid *fluid, size_t parts);

/* Largest |u - velocity of the solid| inside. */
double ts_immersed_slip(const struct ts_immersed *ib, const struct ts_fluid *fluid);

#endif
