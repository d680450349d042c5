/* Walls that are the surface of a region: where they touch, how they move. */
#ifndef TS_WALL_REGION_WALL_H
#define TS_WALL_REGION_WALL_H

#include "region/region.h"
#include "wall/wall.h"

/* How a region moves, by what its variables said in the step before. */
struct ts_region_motion {
	double known, step, shift[3], angle;
	double velocity[3], rate; /* of rotation */
};
enum { TS_REGION_MOTION = sizeof(struct ts_region_motion) / sizeof(double) };

/* How a region that moves stood as particles near it were listed. */
struct ts_region_pose {
	double shift[3], angle;
	double far; /* the distance of the farthest particle from the pivot */
};

struct ts_region_wall {
	struct ts_instance *region;
	struct ts_region_contact_point *spot; /* room for those of a particle */
	int faces;
	int nmovers; /* the region or those that it is made of */
	const struct ts_instance **mover;
	struct ts_region_motion *motion; /* of each; saved */
	struct ts_region_pose *listed;	 /* of each */
	/* the surface may go so far before particles are listed anew; infinite: all are listed */
	double margin;
	int64_t listed_step;
	bool quick;   /* it goes so fast that all are listed */
	int64_t seen; /* the step after the one in which it was updated last; 0: never */
};

/* In init, when the region is known. */
enum ts_status ts_region_wall_init(struct ts_instance *self, struct tsim *sim, struct ts_region_wall *w);
/* Between ts_wall_rebuild_start and _finish, of the region as it was last updated: lists particles of the
 * group. */
enum ts_status ts_region_wall_list(struct ts_instance *self, struct tsim *sim, struct ts_wall *wall,
				   struct ts_region_wall *w);
/* The region as it is now; refuses one that has moved through particles in one step. */
enum ts_status ts_region_wall_update(struct ts_instance *self, struct tsim *sim, struct ts_region_wall *w);
/* Before the forces: updates it, and says whether it has gone so far that particles must be listed anew. */
enum ts_status ts_region_wall_follow(struct ts_instance *self, struct tsim *sim, struct ts_region_wall *w,
				     bool *list);
/* How far the particle of contact k is from its face now; infinite: it does not meet it. */
double ts_region_wall_distance(const struct ts_region_wall *w, const struct tsim *sim,
			       const struct ts_wall *wall, size_t k);
/* All forces; the surface has the material of this type. */
enum ts_status ts_region_wall_enqueue_contacts(struct tsim *sim, struct ts_wall *wall,
					       struct ts_region_wall *w, int type);
enum ts_status ts_region_wall_archive(struct ts_archive *a, struct ts_region_wall *w);

#endif
