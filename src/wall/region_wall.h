/* Walls that are the surface of a region: contact points, and the velocity of the surface. */
#ifndef TS_WALL_REGION_WALL_H
#define TS_WALL_REGION_WALL_H

#include "region/region.h"
#include "wall/wall.h"

/* Motion of a region, as the difference of its variables between two steps. */
struct ts_region_motion {
	double known; /* 1: the following values have been set, else 0 */
	double step, shift[3],
		angle;		  /* last step of evaluation; displacement, length, and angle, radian, then */
	double velocity[3], rate; /* velocity; angular velocity, radian/time */
};
enum { TS_REGION_MOTION = sizeof(struct ts_region_motion) / sizeof(double) };

/* Pose of a moving region when particles near it were listed. */
struct ts_region_pose {
	double shift[3], angle; /* displacement, length; angle, radian */
	bool in_place;		/* the surface only slides along itself */
	/* upper bound of the distance of a particle from the pivot until the next listing, length */
	double far;
};

struct ts_region_wall {
	struct ts_instance *region;
	struct ts_region_contact_point *point; /* [faces], buffer */
	int faces;
	int nmovers;			  /* moving regions: the region itself, or members of it */
	const struct ts_instance **mover; /* [nmovers] */
	struct ts_region_motion *motion;  /* [nmovers]; saved */
	struct ts_region_pose *listed;	  /* [nmovers] */
	/* displacement of the surface after which particles are listed again, length; infinite: all are
	 * listed */
	double margin;
	/* [listed particles] distance of its centre from the surface at the listing, less the range of the law, length;
	 * -infinity: unknown */
	double *clear;
	size_t clear_capacity;
	int64_t listed_step;
	bool list_all;	 /* the surface is so fast that all particles are listed */
	int64_t updated; /* 1 + the step of the last update; 0: never */
};

extern const struct ts_wall_shape ts_region_wall_shape;

#endif
