/* Recession: how the geometry of a surface follows the volume worn from its elements. What is common to height fields
 * (voxel/voxel_recede.h) and meshes; called through wall/surface.h.
 *
 * The volume of an element that is due goes three ways:
 *
 *	taken    from the geometry, now
 *	surplus  there is no more material above the depth `thickness`; it is not taken, now or later
 *	the rest stays pending: it is due again in the next update
 */
#ifndef TS_GEOM_RECESSION_H
#define TS_GEOM_RECESSION_H

#include <stdbool.h>
#include <stddef.h>

/* What happens to an element that is worn down to the depth `thickness`. */
enum ts_through {
	TS_THROUGH_STOP,  /* it stays, and gives no more volume */
	TS_THROUGH_OPEN,  /* it is removed: particles pass */
	TS_THROUGH_ERROR, /* as stop; the run ends with an error */
};

struct ts_recession {
	double thickness; /* of the material below the original surface, length; infinite: not given */
	double layer;	  /* height of a voxel, which is removed whole, length; 0: any height */
	int through;	  /* enum ts_through */
};

/* An element in one update. */
struct ts_recession_element {
	size_t element;
	double due;  /* volume, length^3; may be negative by rounding errors */
	double back; /* part of `due` worn by particles on the side against its normal, length^3 */
	/* results, 0 and false before */
	double taken, surplus; /* length^3 */
	bool through;	       /* it is worn down to the depth `thickness`, now or before */
};

#endif
