/* What templates of clumps share: the spheres, from words or from a file, and what they make together. */
#ifndef TS_INSERT_CLUMP_TEMPLATE_H
#define TS_INSERT_CLUMP_TEMPLATE_H

#include "insert/template.h"

/* First member of the state of these styles. */
struct ts_clump_template {
	struct ts_template base;
	int64_t nspheres, ntry;
	struct ts_words sphere_words;
	struct ts_clump clump;
};
#define TS_CLUMP_TEMPLATE_ARGS(T)                                                                        \
	TS_INT("nspheres", T, shape.nspheres, .range = TS_WITHIN, .lo = 1, .hi = 1e6,                    \
	       .help = "number of spheres"),                                                             \
		TS_INT("ntry", T, shape.ntry, .range = TS_WITHIN, .lo = 1000, .hi = 1e10,                \
		       .help = "random points for volume, centre and moments"),                          \
		TS_LIST_KEYWORD("spheres", T, shape.sphere_words, .flags = TS_TO_KEYWORD,                \
				.help = "x y z r of each sphere, or file NAME with as many such lines; " \
					"then perhaps scale FACTOR")

/* Reads and measures the clump; the origin is its centre of mass, or the middle of the sphere around it. */
enum ts_status ts_clump_template_init(struct ts_instance *self, struct tsim *sim, bool centre);

#endif
