/* Clumps of overlapping spheres: bounding sphere, and volume, centre of mass and moments of inertia of
 * their union by Monte Carlo integration.
 *
 * All random numbers are from one minimal standard generator, in the order of LIGGGHTS 3.8: first the
 * orders in which spheres are added to the bounding sphere, then `tries` points in the bounding box for
 * volume and centre, then the same number for the moments. */
#ifndef TS_RIGID_CLUMP_H
#define TS_RIGID_CLUMP_H

#include <stddef.h>
#include <stdint.h>

#include "base/status.h"
#include "math/minstd.h"

struct ts_clump_sphere {
	double x[3], radius;
};

struct ts_clump {
	struct ts_clump_sphere *sphere;
	size_t n;
	double middle[3], reach; /* centre and radius of the bounding sphere */
	double volume;		 /* of the union */
	double centre[3];	 /* of mass */
	double moments[6];	 /* of inertia about it, xx yy zz xy xz yz, for density 1 */
};

/* Computes all but the spheres. TS_RANGE: none of the points lies in a sphere. */
enum ts_status ts_clump_measure(struct ts_clump *clump, int64_t tries, struct ts_minstd *random);

#endif
