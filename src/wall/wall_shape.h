/* The shape of a wall: planes and cylinders, meshes, a height field, the surface of a region. Each shape is a table, by
 * which all other files call it, and a line of ts_wall_shapes (wall/wall_shapes.h). Its state, `geometry`, is a struct of
 * the shape in the state of the fix. Only the files of the shape read it; that of planes and cylinders is read by the
 * review of the scene and the message about lost particles, too.
 *
 * Functions of a shape that is in use take its wall, or the fix of the wall, and find the state in w->geometry. Slots
 * may be NULL only where that is said. */
#ifndef TS_WALL_WALL_SHAPE_H
#define TS_WALL_WALL_SHAPE_H

#include "core/sim.h"
#include "geom/recession.h"

struct ts_exact_surface;
struct ts_wall;

/* A point of a wall at which the distance from the centre of a particle has a local minimum. */
struct ts_wall_near_point {
	double n[3];	    /* unit vector from the point to the centre */
	double distance;    /* of the centre from the point, length, > 0 */
	double velocity[3]; /* of the surface there */
};
typedef void ts_wall_near_fn(void *context, const struct ts_wall_near_point *point);

/* Where a contact of a wall is on its surfaces. */
struct ts_wall_place {
	size_t surface, element; /* number of the surface of the wall; number of its element */
	int32_t shift[3];	 /* periodic image of the surface that is touched, in box lengths */
};

/* The surfaces that walls of one shape are made of (wall/surface.h). `by`: the fix of the surface, after its init;
 * that of a wall if the wall itself is the surface. */
struct ts_surface_kind {
	/* of the fix; NULL: no style can observe these surfaces, and `type` is the only other slot */
	const char *family;
	/* The functions of ts_surface_elements, _area, _centre, _type and _temperature. */
	size_t (*elements)(const struct ts_instance *by);
	double (*area)(const struct ts_instance *by, const struct tsim *sim, size_t element);
	void (*centre)(const struct ts_instance *by, const struct tsim *sim, size_t element, double out[3]);
	int (*type)(const struct ts_instance *by);
	double (*temperature)(const struct ts_instance *by);
	/* Those of ts_surface_check_recession, _recede and _is_back. */
	enum ts_status (*check_recession)(struct tsim *sim, const struct ts_instance *by,
					  const struct ts_recession *how, const struct ts_place *where);
	/* NULL: check_recession refuses it */
	enum ts_status (*recede)(struct tsim *sim, const struct ts_instance *by,
				 const struct ts_recession *how, const struct ts_place *where,
				 struct ts_recession_element *e, size_t n);
	bool (*is_back)(const struct ts_instance *by, size_t element, const double normal[3]); /* NULL: no */
};

struct ts_wall_shape {
	const char *made_of; /* what a wall of this shape is made of, for messages */
	bool solid;	     /* particles touch it from outside only; else it is a sheet with two sides */

	/* ---- definition */

	/* Number of words of the line that ask for this shape; more than 1 is an error. */
	int (*given)(const void *geometry);
	/* In init, which is called again before each run: resolves the words; sets w->warm, w->moves and w->yields. */
	enum ts_status (*find)(struct ts_instance *self, struct tsim *sim);
	/* Before a run: fails if walls of this shape cannot have the contact law. NULL: they have any. */
	enum ts_status (*check_law)(struct ts_instance *self, struct tsim *sim);
	/* Warnings before a run. NULL: none. */
	void (*plan)(struct ts_instance *self, struct tsim *sim);
	/* Saved state, also of a shape that the wall does not have. NULL: none. */
	enum ts_status (*archive)(struct ts_archive *a, void *geometry);
	/* Frees what is not in the arena of the fix. NULL: nothing. */
	void (*release)(void *geometry);

	/* ---- its surfaces, at least one, numbered from 0 */

	size_t (*surfaces)(const struct ts_wall *w);
	const struct ts_instance *(*fix)(const struct ts_wall *w, size_t surface);
	void (*place)(const struct ts_wall *w, size_t k, struct ts_wall_place *out); /* of contact k */
	struct ts_surface_kind surface;

	/* ---- stages of a step; see wall/wall.h */

	/* In POST_BUILD: lists the pairs that may touch before the next rebuild. */
	enum ts_status (*list)(struct ts_instance *self, struct tsim *sim);
	/* In CHECK, these two; NULL: `enqueue` does what they do. */
	/* Whether the wall has moved half the skin since the listing, so that another one is due. */
	bool (*has_moved)(const struct ts_wall *w, const struct tsim *sim);
	/* Fails if the surface passes through a particle in one step: it moved by more than the radius. */
	enum ts_status (*check_displacement)(struct ts_instance *self, struct tsim *sim);
	/* In POST_FORCE, after ts_wall_start: computes all forces; fails if the centre of a particle lies in the
	 * surface. */
	enum ts_status (*enqueue)(struct ts_instance *self, struct tsim *sim);

	/* ---- questions of checks and messages */

	/* Present distance of the centre of the particle of contact k from the surface; stores the type of the
	 * surface. */
	double (*distance)(const struct ts_wall *w, const struct tsim *sim, size_t k, int *type);
	/* Present distance of a point from the wall, less the displacement of the wall in a step. NULL: the gap of
	 * all surfaces of the sort is looked at, whether a wall is made of them or not. */
	double (*gap)(const struct ts_wall *w, const struct tsim *sim, const double x[3]);
	/* Calls `take` for each point of the surface that is a local minimum of the distance from the centre of
	 * particle i and nearer than `reach`, at most its radius plus w->look: a flat surface has one such point,
	 * whatever its elements are. In an order that does not depend on threads; threads may ask for different
	 * particles at once. After `list`. NULL: not available. */
	void (*near)(const struct ts_wall *w, const struct tsim *sim, size_t i, double reach,
		     ts_wall_near_fn *take, void *context);
	/* Appends the name of the element of contact k: ", triangle 12 of mesh cad". NULL: the ID of the wall tells. */
	void (*name)(const struct ts_wall *w, size_t k, struct ts_str *out);

	/* ---- the first touch on a path */

	const struct ts_exact_surface *exact; /* its shape is `geometry` */
	/* Why this wall cannot have `impact exact`; NULL: it can. The slot may be NULL, too. */
	const char *(*not_exact)(const struct ts_wall *w);
};

#endif
