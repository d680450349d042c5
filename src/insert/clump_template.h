/* Common part of the templates of clumps: reads the spheres and computes volume, centre of mass and
 * moments of the clump. */
#ifndef TS_INSERT_CLUMP_TEMPLATE_H
#define TS_INSERT_CLUMP_TEMPLATE_H

#include "insert/template.h"

/* First member of the state of these styles. ntry: number of random points of the Monte Carlo integration. */
struct ts_clump_template {
	struct ts_template base;
	int64_t nspheres, ntry;
	int bonded;
	struct ts_words sphere_words;
	struct ts_clump clump;
};
#define TS_CLUMP_TEMPLATE_ARGS(T)                                                                         \
	TS_INT("nspheres", T, shape.nspheres, .range = TS_WITHIN, .lo = 1, .hi = 1e6,                     \
	       .help = "number of spheres"),                                                              \
		TS_INT("ntry", T, shape.ntry, .range = TS_WITHIN, .lo = 1000, .hi = 1e10,                 \
		       .help = "number of random points for volume, centre and moments"),                 \
		TS_LIST_KEYWORD("spheres", T, shape.sphere_words, .flags = TS_TO_KEYWORD,                 \
				.help = "x y z r of each sphere, or file NAME with nspheres such lines; " \
					"optionally followed by scale FACTOR"),                           \
		TS_ENUM("bonded", T, shape.bonded, ts_clump_bonds, .fallback = "no",                      \
			.help = "whether the spheres are bonded")

extern const char *const ts_clump_bonds[];

/* Reads the clump and integrates its volume and moments. The origin, which insertion places, is the centre of
 * mass, or without `centre` that of the bounding sphere. */
enum ts_status ts_clump_template_init(struct ts_instance *self, struct tsim *sim, bool centre);

#endif
