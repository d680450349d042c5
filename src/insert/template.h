/* Templates: what the particles that a fix inserts look like. Each fix particletemplate/... keeps one;
 * fix particledistribution/discrete mixes them. */
#ifndef TS_INSERT_TEMPLATE_H
#define TS_INSERT_TEMPLATE_H

#include "core/sim.h"
#include "math/minstd.h"
#include "math/size_spread.h"
#include "rigid/clump.h"
#include "rigid/rigid.h"

/* First member of the state of every fix particletemplate/... */
struct ts_template {
	int64_t seed, type;
	struct ts_words radius_words, density_words;
	double volume_limit;
	bool relative;

	/* set by ts_template_init */
	bool defined;
	struct ts_spread radius, density;
	double volume, mass;   /* means */
	double least, largest; /* radius of the sphere around a particle */
	double lightest;       /* mass of a particle */
	/* of several spheres; NULL: of one */
	const struct ts_clump *clump;
	double origin[3];    /* the point of the clump that is put to a place */
	bool rigid;	     /* the spheres are a rigid body ... */
	struct ts_body body; /* ... that is so, where the clump stands as it was given */

	struct ts_minstd random; /* saved */
};
#define TS_SEED_HELP                                                                                \
	"seed of the random numbers: 1 to 2147483646; primes above 10000 where LIGGGHTS 3.8 shall " \
	"read the script, too"
#define TS_TEMPLATE_ARGS(T)                                                                                  \
	TS_INT("seed", T, base.seed, .flags = TS_POSITIONAL, .range = TS_POSITIVE, .help = TS_SEED_HELP),    \
		TS_INT("atom_type", T, base.type, .fallback = "1", .range = TS_POSITIVE,                     \
		       .help = "type of the particles"),                                                     \
		TS_LIST_KEYWORD("density", T, base.density_words, .flags = TS_TO_KEYWORD,                    \
				.help = "constant D | uniform LO HI | gaussian MEAN DEVIATION | "            \
					"lognormal MEDIAN DEVIATION"),                                       \
		TS_REAL("volume_limit", T, base.volume_limit, .fallback = "1e-12", .range = TS_NOT_NEGATIVE, \
			.unit = "length^3",                                                                  \
			.help = "particles of a smaller mean volume are refused, for they may be an "        \
				"error of units"),                                                           \
		TS_BOOL("relative", T, base.relative, .fallback = "no",                                      \
			.help = "radii are parts of one that another command knows")

/* For template styles: reads the seed, and a quantity that may be spread: "constant R", "uniform mass LO
 * HI" ... */
enum ts_status ts_template_start(struct ts_instance *self, struct tsim *sim);
enum ts_status ts_template_spread(struct ts_instance *self, struct tsim *sim, const char *what,
				  struct ts_words words, struct ts_spread *out);
/* Refuses a mean volume below the limit. */
enum ts_status ts_template_check_volume(struct ts_instance *self, struct tsim *sim);

/* The archive function of templates; and of any stream. */
enum ts_status ts_template_archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *archive);
enum ts_status ts_template_archive_stream(struct ts_archive *archive, struct tsim *sim, const char *name,
					  struct ts_minstd *random);

/* The template that the word names, or an error. */
enum ts_status ts_template_require(struct tsim *sim, const struct ts_word *id, struct ts_instance **out);

/* What a fix may make without templates; first member of the state of TS_FAMILY_PROSPECT. */
#define TS_FAMILY_PROSPECT "prospect"
struct ts_prospect {
	int64_t type;
	double least, lightest; /* radius and mass */
};

/* The largest type that a particle has or may get from a template or another fix; 0: there are none. Laws
 * of contact must be known for all up to it, as in LIGGGHTS. */
int ts_template_max_type(const struct tsim *sim);
/* 1 / mass of the lightest particle of this type that a fix may make, and its radius (may be NULL); -1:
 * there is no such fix. */
double ts_template_inverse_mass(const struct tsim *sim, int type, double *radius);

/* Any seed from 1 to 2^31 - 2 will do. `where` it stands, the `what` names the owner. */
enum ts_status ts_template_check_seed(struct tsim *sim, const char *what, int64_t seed,
				      const struct ts_place *where);

#endif
