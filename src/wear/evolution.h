/* Evolving surfaces: how the wear of a fix wear/LAW with `evolve yes` changes the geometry of its surface.
 *
 * Every `every` steps each element gives the volume that has been worn from it and is still there
 * (geom/recession.h, wall/surface.h). At any time
 *
 *	worn by the law = taken from the geometry + surplus of elements that are worn through + pending */
#ifndef TS_WEAR_EVOLUTION_H
#define TS_WEAR_EVOLUTION_H

#include "wall/surface.h"

/* Of one element; all numbers of type double, for restart files. */
struct ts_evolution_sums {
	double taken, surplus; /* length^3 */
	double back;	       /* pending part worn by particles on the side against the normal, length^3 */
	double through;	       /* 1: it is worn down to the depth `thickness` */
};
enum { TS_EVOLUTION_SUMS = sizeof(struct ts_evolution_sums) / sizeof(double) };

struct ts_evolution {
	/* arguments */
	bool on;
	int64_t every;		 /* steps */
	double thickness, layer; /* NaN: not given */
	int through;		 /* enum ts_through */

	struct ts_evolution_sums *sums;	   /* [n], in the order of the rows of struct ts_wear */
	struct ts_recession_element *item; /* buffer */
	size_t n, capacity, item_capacity;
};

extern const char *const ts_through_names[];

#define TS_EVOLUTION_ARGS(T, f)                                                                              \
	TS_BOOL("evolve", T, f.on, .flags = TS_STATEFUL, .fallback = "no",                                   \
		.help = "whether the surface recedes as it wears"),                                          \
		TS_INT("evolve_every", T, f.every, .fallback = "1000", .range = TS_POSITIVE,                 \
		       .help = "steps between changes of the geometry"),                                     \
		TS_REAL("thickness", T, f.thickness, .flags = TS_OPTIONAL, .range = TS_POSITIVE,             \
			.unit = "length",                                                                    \
			.help = "depth of the material below the original surface; default: to the base of " \
				"a "                                                                         \
				"height field"),                                                             \
		TS_REAL("layer", T, f.layer, .flags = TS_OPTIONAL, .range = TS_POSITIVE, .unit = "length",   \
			.help = "height of the voxels, which are removed whole; default: columns are "       \
				"lowered by any depth"),                                                     \
		TS_ENUM("through", T, f.through, ts_through_names, .fallback = "stop",                       \
			.help = "elements that are worn through: give no more volume (stop), are removed "   \
				"(open), or end the run (error)")

/* In the init of a fix wear/LAW, whose surface has been found. */
enum ts_status ts_evolution_init(struct ts_instance *self, struct tsim *sim);
/* With `evolve yes`: row `row` of the fix has got this volume. */
enum ts_status ts_evolution_add(struct tsim *sim, struct ts_evolution *e, size_t row, double volume,
				bool back);
/* At the end of a step: changes the geometry if it is time. */
enum ts_status ts_evolution_update(struct ts_instance *self, struct tsim *sim);
/* Total of one member of struct ts_evolution_sums, given by its offset in numbers: exact, rounded once. */
double ts_evolution_total(const struct ts_evolution *e, size_t member);
enum ts_status ts_evolution_archive(struct ts_archive *archive, struct tsim *sim, struct ts_evolution *e,
				    size_t rows);
void ts_evolution_release(struct ts_evolution *e);

#endif
