/* Cohesion: an attractive force -k A along n, with the cohesion energy density k and a contact area A.
 *
 *   sjkr           A = circle of intersection of the spheres, -pi/4
 *                  (r-Ri-Rj)(r+Ri-Rj)(r-Ri+Rj)(r+Ri+Rj)/r^2; at a wall pi (R^2 - r^2)
 *   sjkr2          A = 2 pi delta 2R*; at a wall 2 pi delta R as in LIGGGHTS, half the limit of an
 *                  infinitely large partner
 *   easo, washino  liquid bridges: law/capillary.h */
#ifndef TS_LAW_COHESION_H
#define TS_LAW_COHESION_H

#include "law/capillary.h"
#include "law/lens.h"
#include "law/normal.h"
#include "math/constants.h"

/* Area of the circle of intersection of two overlapping spheres, or of a sphere and a plane. */
TS_INLINE double ts_lens_area(const struct ts_touch *t)
{
	if (t->wall)
		return ts_lens_of_plane(t->distance, t->radius[0]);
	return ts_lens_of_spheres(t->distance, t->radius[0], t->radius[1]);
}

/* Contribution of cohesion to F_n. */
TS_INLINE double ts_cohesion_force(const struct ts_granular_model *m, const struct ts_granular_pair *c,
				   const struct ts_touch *t)
{
	switch (m->cohesion) {
	case TS_COHESION_SJKR:
		return -c->cohesion * ts_lens_area(t);
	case TS_COHESION_SJKR2:
		return -c->cohesion * 2 * TS_PI * t->overlap * (t->wall ? t->radius[0] : 2 * t->r_eff);
	case TS_COHESION_EASO:
	case TS_COHESION_WASHINO:
		return ts_bridge_force(m, c, t);
	default:
		return 0;
	}
}

#endif
