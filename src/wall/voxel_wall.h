/* Walls made of a voxel height field. A particle near the field has a fixed number of slots, which are contacts
 * of the wall; those of all columns near it would be too many. In each step its contact points
 * (voxel/voxel_touch.h) are matched to its slots:
 *
 *   a contact point of the same column continues the contact;
 *   a new one takes over the history of the contact that has ended in this step at the nearest point of the
 *   particle's surface, if that is within TS_VOXEL_SAME_NORMAL of it: the contact has slid to another column;
 *   any other begins a contact.
 *
 * Most listed particles do not touch. A search that finds no contact point finds the distance from the surface; no other
 * search is due before particle and surface may have travelled it, so no touch is missed.
 *
 * If a particle has more contact points than slots, particles are listed again with more slots. */
#ifndef TS_WALL_VOXEL_WALL_H
#define TS_WALL_VOXEL_WALL_H

#include "geom/box.h"
#include "voxel/voxel_surface.h"
#include "voxel/voxel_touch.h"
#include "wall/wall.h"

/* Least cosine of the angle between the normals of a contact that has ended and of one that continues it on
 * another column. Contacts that slide change their normal by a part of displacement/radius in a step. */
#define TS_VOXEL_SAME_NORMAL 0.99

/* History values of a contact besides those of its law: 1 + number of the column and its periodic image (0: no
 * contact), unit normal. */
enum { TS_VOXEL_COLUMN, TS_VOXEL_NORMAL, TS_VOXEL_MEMORY = TS_VOXEL_NORMAL + 3 };
/* Periodic images of a column that the history tells apart. */
enum { TS_VOXEL_IMAGES = 27 };

/* A particle near the field. Its slots are contacts first .. first + slots - 1 of the wall. */
struct ts_voxel_neighbor {
	size_t i, first, slots; /* i: index of the particle */
	size_t found;		/* number of contact points in this step */
	/* If it has no contact point it is searched again only after it may have come near enough. */
	double place[3],
		reach; /* position, and distance up to which contact points count, in the last step */
	double travel; /* upper bound of its displacement relative to the surface since the last search; infinite: due */
	double check_travel; /* no contact point is possible while `travel` is smaller, length */
	bool waits;	     /* it has not been searched in this step */
};

struct ts_voxel_wall {
	const char *id;		      /* of the fix of the surface; NULL: the wall is of another shape */
	const struct ts_instance *by; /* the fix of the surface */
	const struct ts_voxel_surface *surface;
	double length[3];		    /* of the box when particles were listed */
	double travelled;		    /* surface->travelled at the last force computation, length */
	struct ts_voxel_neighbor *neighbor; /* [nneighbors] */
	size_t nneighbors, neighbor_capacity;
	/* [contacts]: the contact points of a particle in this step, from the index of its first slot on, */
	struct ts_voxel_contact *at;
	double *column; /* their columns as in the history, */
	size_t *slot;	/* their contacts; SIZE_MAX: none yet */
	bool *used;	/* [contacts]: the slot has a contact point */
	size_t at_capacity, column_capacity, slot_capacity, used_capacity;
};

extern const struct ts_wall_shape ts_voxel_wall_shape;

#define TS_VOXEL_WALL_ARGS(T, f)                                                                            \
	TS_WORD("voxels", T, f.id, .flags = TS_OPTIONAL | TS_STATEFUL,                                      \
		.help = "ID of the fix surface/voxel that the wall is made of; it has the material of its " \
			"own type")

/* ---- for the files of this shape; struct ts_wall_shape says what the slots do */

/* The state of a wall that is made of a height field. */
static inline struct ts_voxel_wall *ts_voxel_wall_of(const struct ts_wall *w)
{
	return w->geometry;
}

/* Slots. */
enum ts_status ts_voxel_wall_list(struct ts_instance *self, struct tsim *sim);
bool ts_voxel_wall_has_moved(const struct ts_wall *w, const struct tsim *sim);
enum ts_status ts_voxel_wall_check_displacement(struct ts_instance *self, struct tsim *sim);
double ts_voxel_wall_gap(const struct ts_wall *w, const struct tsim *sim, const double x[3]);
extern const struct ts_exact_surface ts_voxel_wall_exact;

/* Lists the particles near the surface with their slots; `full`: in a step in which particles have more contact points
 * than slots. */
enum ts_status ts_voxel_wall_list_slots(struct ts_instance *self, struct tsim *sim, bool full);
/* Present distance of a point from the solid, 0 inside of it; infinite if it is not less than `reach`. */
double ts_voxel_wall_distance(const struct ts_voxel_wall *vw, const struct tsim *sim, const double x[3],
			      double reach);

/* The history values TS_VOXEL_... of contact k. */
static inline double *ts_voxel_memory(const struct ts_wall_contacts *c, size_t k)
{
	return ts_wall_memory(c, k) + c->width - TS_VOXEL_MEMORY;
}

/* The index in the heights of a column as in the history. */
static inline int64_t ts_voxel_column_index(double column)
{
	return ((int64_t)column - 1) / TS_VOXEL_IMAGES;
}

/* The point x in the frames of the images of the field that may be near it. */
struct ts_voxel_images {
	int n, shift[TS_VOXEL_IMAGES][3]; /* of the image, in box lengths */
	double x[TS_VOXEL_IMAGES][3];
};
void ts_voxel_images(const struct ts_voxel_surface *s, const struct ts_box *box, const double x[3],
		     struct ts_voxel_images *out);

#endif
