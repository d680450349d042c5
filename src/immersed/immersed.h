/* Immersed boundary method by direct forcing: the fluid takes the velocity of the solids in it.
 *
 * Every point of a velocity component inside a solid gets the velocity of the solid. A point in the fluid
 * with a neighbour inside (an outer point) gets the value on the parabola along the normal n through the
 * velocity v_s of the surface and the velocities of the fluid at two positions farther out,
 *
 *   u(x) = v_s + 2 d/(d + l) (u(x + l n) - v_s) - d/(d + 2 l) (u(x + 2 l n) - v_s),
 *
 * with d the distance of x from the surface and l = 1/sqrt(sum n_i^2/h_i^2) the spacing along n (Fadlun et
 * al., J. Comput. Phys. 161 (2000) 35; along the normal Balaras, Comput. Fluids 33 (2004) 375, with
 * straight lines): the velocity on the surface is of second order in h. The weight of the value is 1 near
 * the surface and decreases to 0 at d = max |n_i| h_i, where no neighbour is inside any more, so that
 * forces stay smooth as the solid moves over the points (Luo et al., Comput. Fluids 56 (2012) 61).
 *
 * The predictor does not contain the pressure gradient, so the projection changes the forced velocities by
 * it. Inside, to a depth of about one cell, the gradient of the old pressure is added in advance: after
 * the first steps the velocity of a solid at rest is met exactly. Deeper points do without, so that the
 * pressure inside is a smooth continuation of that at the surface.
 *
 * Force on a solid: the opposite of the forcing, and the rate of change of the momentum of the fluid
 * inside, which does not exist in fact (Uhlmann, J. Comput. Phys. 209 (2005) 448; Kempe & Froehlich, J.
 * Comput. Phys. 231 (2012) 3663):
 *
 *   F = -sum rho (u_forced - u_before) V/dt + d/dt integral_inside rho u dV - integral_inside rho g dV
 *
 * g is the body force along the axes where the ends of the grid bear the weight of the fluid: the last
 * term is the buoyancy. Along periodic axes it drives the flow, and F contains what acts on the fluid
 * inside. */
#ifndef TS_IMMERSED_IMMERSED_H
#define TS_IMMERSED_IMMERSED_H

#include "flow/fluid.h"
#include "immersed/solid.h"
#include "voxel/voxel_surface.h"

/* A point of one velocity component that is forced, or whose control volume is cut by the surface. */
struct ts_immersed_point {
	size_t at;     /* index in the field */
	int32_t part;  /* of the solid */
	int32_t index; /* along the axis of the component, for the pressure gradient */
	double arm[3]; /* position relative to the centre of the part */
	double volume; /* of the control volume */
	double solid;  /* fraction of the control volume inside, 0 to 1 */
	double target; /* prescribed velocity, without pressure gradient */
	double before; /* velocity before the forcing */
	bool deep;     /* inside, far from the surface */
	bool outside;  /* in the fluid: an outer point (struct ts_immersed_outer) */
	int32_t turn; /* periods along the last axis between the point in `at` and its image beside the part */
};

/* A position in the fluid at which the velocity is sampled, relative to the points of the component. */
struct ts_immersed_sample {
	size_t corner; /* field index of the lowest of the points around it */
	int32_t index; /* of that point along the axis of the component */
	double t[3];   /* position between the points, 0 to 1 along each axis */
	double count;  /* coefficient of (u - v_s) in the parabola */
};

/* A forced point in the fluid, beside the surface, and the two positions farther out. */
struct ts_immersed_outer {
	size_t point;	/* index in `point` */
	double weight;	/* of the forcing, 0 to 1 */
	double surface; /* component of v_s */
	struct ts_immersed_sample out[2];
	double fixed; /* the part of the velocity that does not depend on the samples, in this stage */
	double next;  /* velocity after this iteration */
};

/* Of a part, in a step. */
struct ts_immersed_sums {
	double impulse[3], angular_impulse[3]; /* of the forcing on the fluid, completed substeps */
	double volume;			       /* volume inside, as sum over control volumes */
	double velocity[3], spin[3]; /* inside: mean of u, and of (x - X) x u about the mean position X */
	double arm[3][3];	     /* mean position relative to the centre, of the points of component c */
};

/* The points of one component of one part (an image of it) in one plane across the last axis, and sums over them. Ranks divide
 * planes, so sums over planes in their order are the same on any number of ranks. */
struct ts_immersed_layer {
	size_t first, end;	 /* of its points */
	int32_t component, part; /* the component is c */
	int32_t plane, turn;
	double impulse[3]; /* in this step: along c, and about the axes c + 1 and c + 2 (modulo 3) */
	double stage[3];   /* the same of the present substep */
};

/* Of a point that a thread has found, before it is known to which part it belongs. */
struct ts_immersed_candidate {
	double distance, thickness, rate;
};

struct ts_immersed {
	struct ts_immersed_point *point; /* of component 0, 1, 2: from first[c] to first[c + 1] */
	struct ts_immersed_outer *outer;
	size_t npoints, point_capacity, nouter, outer_capacity;
	size_t first[4], outer_first[4];
	/* planes across the last axis, from .. to - 1, in which the points are: those of this rank while ranks have the fluid
	 * in some planes only (ts_fluid_divided), else all */
	int planes[2];
	int planes_beside;		 /* of ts_immersed_planes_beside */
	struct ts_immersed_layer *layer; /* in the order of the points */
	size_t nlayers, layer_capacity;
	double *distance; /* work fields where parts or images may be near the same point: the least distance from it, */
	size_t *owner; /* and the number in `point` of the point for that part or image, from 1 */
	struct ts_immersed_sums *sums; /* of each part */
	size_t sums_capacity;
	struct ts_parcel own_layers, all_layers; /* sums of layers, as ranks tell each other */
	double slip; /* largest |u - velocity of the solid| at points inside, near the surface, at the end of a step */
	/* Of the points of all ranks: */
	size_t inside;	      /* number of points inside solids, */
	size_t beside;	      /* and beside their surfaces */
	double thickness;     /* thickness of the solid in cells: twice the largest depth of a point */
	bool reads_ghosts;    /* samples lie beside boundaries, or a body reaches the end of the grid */
	bool beside_boundary; /* points may be so near to the ends of the grid that ghosts depend on them */
	double rate;	      /* largest velocity of a solid by spacing (cells/time) */
	double first_dt;      /* dt of the first stage of this substep; 0: it has not begun */
	struct ts_immersed *chunk; /* work memory: the points each thread has found, */
	size_t chunks, chunk_capacity;
	struct ts_immersed_candidate *candidate; /* and data of these points */
	size_t candidate_capacity;
	enum ts_status status;
};

/* Body force along an axis where the ends of the grid bear the weight of the fluid, so that a pressure balances it: 0 along
 * periodic axes, as for the hydrostatic pressure of open faces. */
static inline double ts_immersed_weight(const struct ts_fluid *fluid, int axis)
{
	return fluid->grid.periodic[axis] ? 0 : fluid->body_force[axis];
}

/* ---- immersed_resolution.c
 * Refuses a part that is fewer than `least` cells across; `spheres`: parts are particles, which are no cylinders. */
enum ts_status ts_immersed_check_size(struct tsim *sim, const struct ts_place *where,
				      const struct ts_solid *solid, const struct ts_grid *grid, bool spheres,
				      double least);
/* Refuses a height field that cannot be a body in the grid: in two dimensions one that varies along z, one that does
 * not cover the grid although it is as long. */
enum ts_status ts_immersed_check_voxels(struct tsim *sim, const struct ts_place *where, const char *id,
					const struct ts_voxel_surface *surface, const struct ts_grid *grid);
/* Warns of a body without points inside, or that is too thin. */
void ts_immersed_warn_thin(struct tsim *sim, const struct ts_place *where, const struct ts_immersed *ib);
/* Warns if columns that are thinner than cells make steps that are higher than cells. */
void ts_immersed_warn_columns(struct tsim *sim, const struct ts_place *where, const char *id,
			      const struct ts_voxel_field *f, const struct ts_grid *grid);

/* ---- immersed_conflicts.c
 * Warns of walls of which the body covers a part that moves along itself unlike the body. */
void ts_immersed_warn_walls(struct tsim *sim, const struct ts_place *where, const struct ts_immersed *ib,
			    const struct ts_fluid *fluid);
/* Warns of points inside two bodies that have different velocities there; `other`: the fix of body a. */
enum ts_status ts_immersed_warn_overlap(struct tsim *sim, const struct ts_place *where,
					const struct ts_immersed *a, const struct ts_immersed *b,
					const struct ts_fluid *fluid, const char *other);
/* Warns if a surface of the solid, of fix `other` or (NULL) of the body itself, lies less than about three cells opposite that
 * of the body: too few for the flow between them. */
enum ts_status ts_immersed_warn_gap(struct tsim *sim, const struct ts_place *where,
				    const struct ts_immersed *ib, struct ts_solid *solid,
				    const struct ts_fluid *fluid, const char *other);

/* ---- immersed_distance.c
 * Lowers distance[k] to that of the surface of any part, or its periodic images, from x[k]: < 0 inside; exact within
 * `reach`. The solid has its place. */
enum ts_status ts_immersed_distances(struct ts_solid *solid, const struct ts_grid *grid, size_t n,
				     const double (*x)[3], double reach, double *distance);

/* ---- immersed_points.c
 * Finds the forced points, after the solid has moved, or other planes are those of this rank. */
enum ts_status ts_immersed_find_points(struct ts_immersed *ib, struct ts_solid *solid,
				       const struct ts_fluid *fluid);
/* Planes below a point, or above it, from which its samples read. */
int ts_immersed_planes_beside(const struct ts_grid *grid);
/* Whether the points are those of the planes that this rank has now. */
bool ts_immersed_has_planes(const struct ts_immersed *ib, const struct ts_fluid *fluid);
void ts_immersed_release(struct ts_immersed *ib);

/* ---- immersed.c
 * Forces the predictor fluid->u, and sums the impulses. */
void ts_immersed_force(struct ts_immersed *ib, struct ts_fluid *fluid, double dt, int iterations);
/* Exchanges what the forcing exchanges, without computing it. */
void ts_immersed_rehearse_force(const struct ts_immersed *ib, const struct ts_fluid *fluid, int iterations);

/* ---- immersed_sums.c
 * At the beginning of a step of the fluid: sets the sums to zero. */
void ts_immersed_begin_step(struct ts_immersed *ib);
/* After a stage of length dt. */
void ts_immersed_add_impulses(struct ts_immersed *ib, const struct ts_fluid *fluid, double dt);
/* At the end of a substep: adds its sums to those of the step. */
void ts_immersed_end_substep(struct ts_immersed *ib);
/* After a step: computes the sums of all parts, and the slip, of all ranks. */
enum ts_status ts_immersed_sum_parts(struct ts_immersed *ib, const struct ts_fluid *fluid, size_t parts);
/* Exchanges what this exchanges. */
enum ts_status ts_immersed_rehearse_sums(struct ts_immersed *ib, const struct ts_fluid *fluid);

#endif
