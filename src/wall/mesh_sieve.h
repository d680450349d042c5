/* A mesh as a sieve whose openings are not resolved: a particle that meets it passes with a probability, or is held by a
 * spring and a dashpot. For fix massflow/mesh.
 *
 * The openings are circles of diameter D at distances P, on a square lattice. A particle of diameter d that comes normal to
 * the sieve passes without touching it where its centre is less than (D - d)/2 from that of an opening, with the
 * probability pi/4 ((D - d)/P)^2. */
#ifndef TS_WALL_MESH_SIEVE_H
#define TS_WALL_MESH_SIEVE_H

#include "mesh/mesh_surface.h"
#include "mesh/mesh_tree.h"

struct ts_mesh_sieve {
	double size, spacing; /* D, P; size NaN: the mesh is no sieve */
	double stiffness;     /* force/length */
	double damping;	      /* force/velocity */
	size_t column;	      /* particle column: 0 not at the mesh, 1 held, 2 passing */
};

#define TS_MESH_SIEVE_ROWS(T, S)                                                                         \
	TS_REAL("sieveSize", T, S.size, .flags = TS_OPTIONAL, .range = TS_POSITIVE, .unit = "length",    \
		.help = "diameter of the openings of a sieve"),                                          \
		TS_REAL("sieveSpacing", T, S.spacing, .flags = TS_OPTIONAL, .range = TS_POSITIVE,        \
			.unit = "length", .help = "distance between the centres of openings"),           \
		TS_REAL("sieveStiffness", T, S.stiffness, .flags = TS_OPTIONAL, .range = TS_POSITIVE,    \
			.unit = "force/length", .help = "stiffness of the spring that holds particles"), \
		TS_REAL("sieveDamping", T, S.damping, .fallback = "0", .range = TS_NOT_NEGATIVE,         \
			.unit = "force/velocity", .help = "damping coefficient of the dashpot beside it")

static inline bool ts_mesh_sieve_is(const struct ts_mesh_sieve *sieve)
{
	return !isnan(sieve->size);
}

/* Whether it holds particle i. */
bool ts_mesh_sieve_holds(const struct ts_mesh_sieve *sieve, const struct tsim *sim, size_t i);
/* Checks the arguments, and adds the column, named sieve_ID. */
enum ts_status ts_mesh_sieve_init(struct ts_instance *self, struct tsim *sim, struct ts_mesh_sieve *sieve);
/* Adds the forces on the particles of the group of `self`; `tree` is that of the present mesh, `list` a buffer. */
enum ts_status ts_mesh_sieve_add_forces(const struct ts_instance *self, struct tsim *sim,
					const struct ts_mesh_sieve *sieve,
					const struct ts_mesh_surface *surface,
					const struct ts_mesh_tree *tree, struct ts_mesh_list *list);
/* Slot `ground`: any particle may be held. */
void ts_mesh_sieve_ground(const struct ts_mesh_sieve *sieve, const struct tsim *sim, size_t i,
			  struct ts_ground_springs *sum);

#endif
