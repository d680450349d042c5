/* Walls made of meshes: which particle is near which triangle, and how a particle that slides from one
 * triangle to the next keeps its contact.
 *
 * A sphere that touches a flat surface touches it once: of the faces of flat neighbours that it touches
 * at the same time - its centre is over their common edge - the first has the contact. A new contact takes
 * over what the contact with a flat neighbour remembers, unless that was found to go on.
 *
 * Most triangles that are listed are not touched: these are not looked at until particle and mesh may have
 * come as near to each other as they were apart. So no touch is missed. */
#ifndef TS_WALL_MESH_WALL_H
#define TS_WALL_MESH_WALL_H

#include "mesh/mesh_surface.h"
#include "mesh/mesh_touch.h"
#include "mesh/mesh_tree.h"
#include "wall/wall.h"

/* One of the wall's meshes. */
struct ts_mesh_part_of_wall {
	const struct ts_instance *by;
	const struct ts_mesh_surface *surface;
	size_t first; /* number of its first triangle among those of all meshes */
	struct ts_mesh_tree tree;
	uint64_t moves;	  /* surface->moves when the tree was built */
	double travelled; /* surface->travelled when contacts were looked at last */
	double checked;	  /* the same, when its pace was */
};

/* Which triangle a contact of the wall is about. */
struct ts_mesh_near {
	int32_t mesh, triangle;
	int32_t shift[3]; /* it is the image so many box lengths away */
	bool done;	  /* touches in this step */
	double until;	  /* it cannot touch before the way of the particle is so long */
};

/* Where the surface is met, of a wall that acts beyond the touch; see mesh_stick.h. */
struct ts_mesh_place {
	struct ts_mesh_contact_point at;
	double point[3], distance; /* as seen from the particle; of the triangle */
	enum ts_mesh_part part;
	bool own;
};

/* A particle near the meshes; its contacts follow one another. */
struct ts_mesh_neighbor {
	size_t i, first, n;
	double place[3], radius; /* as they were last */
	double way;   /* that it and the meshes have gone since the particles were listed, at most */
	double until; /* the least of its contacts; -INFINITY: one touches */
};

/* A contact that touches, by what says its place in a sum. */
struct ts_mesh_touching {
	int32_t element, tag;
	size_t k;
};

struct ts_mesh_wall {
	struct ts_mesh_part_of_wall *mesh;
	size_t nmeshes;
	struct ts_mesh_near *near;   /* of each contact */
	struct ts_mesh_place *place; /* of each contact, of a wall that acts beyond the touch */
	struct ts_mesh_neighbor *visitor;
	size_t nvisitors, near_capacity, place_capacity, visitor_capacity;
	double length[3];		   /* of the box, when contacts were looked at last */
	struct ts_mesh_touching *touching; /* sorted, for who reads contacts: wall/surface_contacts.h */
	size_t ntouching, touching_capacity;
};

/* Numbers that a contact with a mesh remembers besides those of its law: whether there is one. */
enum { TS_MESH_MEMORY = 1 };

/* The meshes of these names; to be called in init, again before each run. */
enum ts_status ts_mesh_wall_find(struct ts_instance *self, struct tsim *sim, struct ts_mesh_wall *mw,
				 struct ts_words names);
/* Between ts_wall_rebuild_start and _finish: lists particles of the group of the wall and the mesh. */
enum ts_status ts_mesh_wall_list(struct ts_instance *self, struct tsim *sim, struct ts_wall *w,
				 struct ts_mesh_wall *mw);
/* Whether a mesh has moved so far since then that particles must be listed anew. */
bool ts_mesh_wall_has_moved(const struct tsim *sim, const struct ts_mesh_wall *mw);
/* Refuses a mesh that moves through particles in one step. */
enum ts_status ts_mesh_wall_check_displacement(struct ts_instance *self, struct tsim *sim,
					       struct ts_mesh_wall *mw);
/* Whether a fix reads the contacts of one of its meshes: then contacts keep reports. */
bool ts_mesh_wall_observed(const struct ts_mesh_wall *mw);
void ts_mesh_wall_release(struct ts_mesh_wall *mw);

/* How far particle i is from the triangle of contact k now. */
double ts_mesh_wall_distance(const struct tsim *sim, const struct ts_mesh_wall *mw, size_t k, size_t i);

/* ", triangle 12 of mesh cad": of contact k. */
void ts_mesh_wall_name(const struct ts_mesh_wall *mw, size_t k, struct ts_str *out);
/* Where particle i sees the image of the mesh. */
void ts_mesh_wall_place(const struct tsim *sim, const struct ts_mesh_near *near, size_t i, double x[3]);
/* Whether there is a contact: as of the last step, or found in this one. */
static inline double *ts_mesh_alive(const struct ts_wall_contacts *c, size_t k)
{
	return ts_wall_memory(c, k) + c->width - TS_MESH_MEMORY;
}

/* How far the meshes have gone since the last call, at most; infinite if nothing is known of it: images
 * move with the box. */
double ts_mesh_wall_come_nearer(const struct tsim *sim, struct ts_mesh_wall *mw);
/* How far from its surface a particle may begin a contact: surfaces that stick have to touch first. */
double ts_mesh_wall_outreach(const struct tsim *sim, const struct ts_wall *w, double radius);

/* A touch may be found when a particle is farther by so much: twice the tolerance of the triangle, and
 * rounding. */
static inline double ts_mesh_wall_slack(const struct ts_mesh *m, int32_t triangle)
{
	return 4 * ts_mesh_tolerance(m, (size_t)triangle);
}

/* The rest of the gap between a sphere and a triangle both can go in any way; rounding counts less than
 * what is left of it. */
static inline double ts_mesh_wall_safe_way(const struct ts_mesh *m, int32_t triangle, double distance,
					   double radius)
{
	return 0.999 * (distance - radius - ts_mesh_wall_slack(m, triangle));
}

/* Mesh and triangle of the contact k, for who reads reports. */
static inline const struct ts_mesh_near *ts_mesh_wall_near(const struct ts_mesh_wall *mw, size_t k)
{
	return &mw->near[k];
}

#endif
