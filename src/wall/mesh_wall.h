/* Walls made of meshes: lists of particle-triangle pairs, and the transfer of the contact history when a
 * particle slides from one triangle to the next.
 *
 * A sphere that touches a flat surface has one contact: if it touches the faces of several flat neighbours at
 * the same time (its centre is above their common edge), the first one has the contact. A new contact copies
 * the history of the contact with a flat neighbour, unless that contact continues.
 *
 * Most listed triangles are not touched. A pair is evaluated again only after particle and mesh may have
 * travelled the distance that separated them, so no touch is missed. */
#ifndef TS_WALL_MESH_WALL_H
#define TS_WALL_MESH_WALL_H

#include "mesh/mesh_surface.h"
#include "mesh/mesh_touch.h"
#include "mesh/mesh_vicinity.h"
#include "wall/wall.h"

/* One of the wall's meshes. */
struct ts_mesh_part_of_wall {
	const struct ts_instance *by; /* fix of the mesh */
	const struct ts_mesh_surface *surface;
	size_t first; /* index of its first triangle among those of all meshes of the wall */
	struct ts_mesh_tree tree;
	uint64_t moves;	    /* surface->moves when the tree was built */
	double travelled;   /* surface->travelled at the last force computation, length */
	double checked;	    /* surface->travelled at the last check of its displacement in a step, length */
	double velocity[3]; /* for wall/exact_surface.h: of all corners; 0 if the mesh rotates */
};

/* The triangle of a contact of the wall. */
struct ts_mesh_near {
	int32_t mesh, triangle;
	int32_t shift[3];    /* periodic image of the mesh, in box lengths */
	bool touches;	     /* in this step */
	double check_travel; /* no touch is possible while `travel` of the particle is smaller, length */
};

/* The contact point of a law that acts at a distance; see mesh_stick.h. */
struct ts_mesh_place {
	struct ts_mesh_contact_point at;
	double point[3];	/* relative to the centre of the particle, length */
	double distance;	/* of the centre from the triangle, length */
	enum ts_mesh_part part; /* face, edge or corner */
	bool own;		/* the contact belongs to this triangle */
};

/* A particle near the meshes. Its contacts are consecutive: first .. first + n - 1. */
struct ts_mesh_neighbor {
	size_t i, first, n;	 /* i: index of the particle */
	double place[3], radius; /* position and radius at the last force computation, length */
	double travel; /* upper bound of its displacement relative to the meshes since the listing, length */
	double check_travel; /* minimum over its contacts; -INFINITY: one touches */
};

/* A particle with several contacts within one contact area; see mesh_crowd.h. */
struct ts_mesh_crowd {
	size_t contacts; /* 0: none noted */
	double sum;	 /* of their overlaps, divided by the largest */
	int32_t tag, mesh;
	bool told;
};

struct ts_mesh_wall {
	bool given;	       /* the word `mesh` */
	int64_t count;	       /* n_meshes; INT64_MIN: not given */
	struct ts_words names; /* IDs of the fixes of the meshes */

	struct ts_mesh_part_of_wall *mesh;
	size_t nmeshes;
	struct ts_mesh_near *near;   /* [contacts] */
	struct ts_mesh_place *place; /* [contacts], if the law acts at a distance or w->look > 0; else NULL */
	struct ts_mesh_neighbor *neighbor; /* [nneighbors] */
	size_t nneighbors, near_capacity, place_capacity, neighbor_capacity;
	double length[3]; /* of the box at the last force computation */
	struct ts_mesh_crowd crowd;
};

/* History values of a contact with a mesh besides those of its law: 1 if the contact exists, else 0. */
enum { TS_MESH_MEMORY = 1 };
/* The key of a contact contains the periodic image of the triangle relative to the unwrapped position of the particle, so
 * that it stays the same when the particle is wrapped: modulo three box lengths in each dimension the number of the
 * element, 27 for each triangle, and of a third of it ten bits in each dimension the number of the image. So images that
 * a particle may touch at the same time, or one after the other in a step, are told apart if no triangle is longer than
 * TS_MESH_WALL_LONGEST box lengths; 72 are left for the particle and its way. */
enum { TS_MESH_WALL_IMAGES = 27, TS_MESH_WALL_BITS = 10, TS_MESH_WALL_LONGEST = 3000 };

extern const struct ts_wall_shape ts_mesh_wall_shape;

#define TS_MESH_WALL_ARGS(T, f)                                                                           \
	TS_FLAG("mesh", T, f.given, .help = "the wall is made of meshes"),                                \
		TS_INT("n_meshes", T, f.count, .flags = TS_OPTIONAL, .range = TS_POSITIVE,                \
		       .help = "mesh: number of meshes"),                                                 \
		TS_SOME_KEYWORD("meshes", T, f.names, TS_STATEFUL, .count = "n_meshes",                   \
				.help = "mesh: IDs of the fixes of the meshes; each has the material of " \
					"its own type")

/* ---- for the files of this shape; struct ts_wall_shape says what the slots do */

/* The state of a wall that is made of meshes. */
static inline struct ts_mesh_wall *ts_mesh_wall_of(const struct ts_wall *w)
{
	return w->geometry;
}

/* Slots. A pair is listed if the particle is in the groups of both the wall and the mesh. */
enum ts_status ts_mesh_wall_list(struct ts_instance *self, struct tsim *sim);
bool ts_mesh_wall_has_moved(const struct ts_wall *w, const struct tsim *sim);
enum ts_status ts_mesh_wall_check_displacement(struct ts_instance *self, struct tsim *sim);
extern const struct ts_exact_surface ts_mesh_wall_exact;

/* Makes the trees of the meshes that have moved since they were made. */
enum ts_status ts_mesh_wall_update_trees(struct tsim *sim, struct ts_mesh_wall *mw);

/* Position of particle i relative to the periodic image of the mesh, in the frame of the mesh. */
void ts_mesh_wall_position(const struct tsim *sim, const struct ts_mesh_near *near, size_t i, double x[3]);
/* Whether a corner of the triangle of contact b is in the plane of that of contact a, both in their periodic images, of one mesh.
 * Corners that are box lengths apart are one vertex (ts_mesh_link_images): triangles that share it may be anywhere. Those of a
 * plane that is longer than the box, whose images cover each other, adjoin as well. */
bool ts_mesh_wall_adjoin(const struct ts_mesh_wall *mw, size_t a, size_t b);
/* The history value that is > 0 if the contact exists: since the last step, or found in this one. */
static inline double *ts_mesh_contact_exists(const struct ts_wall_contacts *c, size_t k)
{
	return ts_wall_memory(c, k) + c->width - TS_MESH_MEMORY;
}

/* Upper bound of the displacement of the meshes since the last call; infinite if the box has changed, as
 * images move with it, or if a full evaluation is asked for. */
double ts_mesh_wall_max_approach(const struct tsim *sim, struct ts_mesh_wall *mw);
/* Largest distance of the surfaces at which a contact begins: 0 for adhesive laws, whose surfaces must touch
 * first. */
double ts_mesh_wall_onset_distance(const struct tsim *sim, const struct ts_wall *w, double radius);

/* Tolerance of a touch, length: twice the tolerance of the triangle, and rounding. */
static inline double ts_mesh_wall_slack(const struct ts_mesh *m, int32_t triangle)
{
	return 4 * ts_mesh_tolerance(m, (size_t)triangle);
}

/* The gap between a sphere and a triangle, reduced by the tolerance and by 0.1 % for rounding: a relative
 * displacement shorter than this in any direction does not lead to a touch. */
static inline double ts_mesh_wall_safe_travel(const struct ts_mesh *m, int32_t triangle, double distance,
					      double radius)
{
	return 0.999 * (distance - radius - ts_mesh_wall_slack(m, triangle));
}

#endif
