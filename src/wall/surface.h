/* Surfaces: what particles hit and wear. A surface is named by the ID of its fix and consists of elements:
 *
 *   fix mesh/surface ...        one element for each triangle
 *   fix surface/voxel ...       one for each column
 *   fix wall/gran, primitive    one for each plane or cylinder
 *
 * A style that has a row for each element of a surface (values of shape TS_SURFACE) finds it in its init by
 * ts_surface_require, returns its fix in the slot `surface`, and says in `observes` (core/style.h) what it reads of
 * it: contacts (wall/surface_contacts.h) or impacts (impact/impacts.h). The walls made of the surface keep just that. */
#ifndef TS_WALL_SURFACE_H
#define TS_WALL_SURFACE_H

#include "core/sim.h"
#include "geom/recession.h"

struct ts_surface_kind;

struct ts_surface {
	const struct ts_instance *by; /* its fix; valid in a run */
	struct tsim *sim;	      /* and sim->removals when it was found: for outputs between runs */
	uint64_t removals;
	const struct ts_surface_kind *kind;
};

/* Finds the surface of this ID; fails with an error at the word, and a suggestion, if there is none. */
enum ts_status ts_surface_require(struct tsim *sim, const struct ts_word *id, struct ts_surface *out);
/* Between runs, for outputs: finds the surface again if its fix may have been deleted, or defined anew; fails if it is gone,
 * or has another number of elements. */
enum ts_status ts_surface_find_again(struct ts_surface *s, const char *id, const struct ts_place *where,
				     size_t elements);
/* Number of elements. */
size_t ts_surface_elements(const struct ts_surface *s);
/* Of an element, length^2: of a triangle, now; of a plane that of the cross-section of the box; of a cylinder that
 * of its part in the box, along its axis. */
double ts_surface_area(const struct ts_surface *s, const struct tsim *sim, size_t element);
/* Its centre: of a triangle, of the top of a column, of a plane or of the axis of a cylinder within the box. */
void ts_surface_centre(const struct ts_surface *s, const struct tsim *sim, size_t element, double out[3]);
/* Particle type whose material the surface has. */
int ts_surface_type(const struct ts_surface *s);
/* Its temperature; NaN: it conducts no heat. */
double ts_surface_temperature(const struct ts_surface *s);

/* ---- recession: fixes wear/... with `evolve yes` ---- */

/* In init: whether the surface can recede like this; if not, fails at `where` with the reason. */
enum ts_status ts_surface_check_recession(struct tsim *sim, const struct ts_surface *s,
					  const struct ts_recession *how, const struct ts_place *where);
/* After the forces of a step: takes volume from n elements, each of them once, in an order that does not depend on
 * threads. */
enum ts_status ts_surface_recede(struct tsim *sim, const struct ts_surface *s, const struct ts_recession *how,
				 const struct ts_place *where, struct ts_recession_element *e, size_t n);
/* Whether a contact with this normal, towards the particle, is on the side against the normal of the element. */
bool ts_surface_is_back(const struct ts_surface *s, size_t element, const double normal[3]);

/* What live styles read of the surface of this fix: bits of enum ts_observes. Valid after all init functions. */
unsigned ts_surface_observers(const struct tsim *sim, const struct ts_instance *by);
/* The first style that reads what `bit` says of the surface of this fix, and nothing of `lacks`; NULL: none. */
const struct ts_instance *ts_surface_observer(const struct tsim *sim, const struct ts_instance *by,
					      unsigned bit, unsigned lacks);

#endif
