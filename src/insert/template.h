/* Particle templates: size, density and shape of inserted particles. Each fix particletemplate/... has one;
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

	/* set by init of the fix */
	bool defined;
	struct ts_spread radius, density; /* distributions of both */
	double volume, mass;		  /* means per particle (of a clump: per clump) */
	double least;			  /* smallest radius of a sphere */
	double largest;			  /* largest radius of a bounding sphere */
	double lightest;		  /* smallest mass of a sphere; of a rigid clump: its mass */
	const struct ts_clump *clump;	  /* NULL: a single sphere */
	double origin[3];		  /* point of the clump that insertion places, in its coordinates */
	bool rigid;			  /* clumps become rigid bodies ... */
	struct ts_body body; /* ... with this mass and inertia, in the orientation of the template */

	struct ts_minstd random; /* saved */
};
#define TS_SEED_HELP \
	"seed of the random numbers, 1 to 2147483646; LIGGGHTS 3.8 accepts only primes above 10000"
#define TS_TEMPLATE_ARGS(T)                                                                                  \
	TS_INT("seed", T, base.seed, .flags = TS_POSITIONAL, .range = TS_POSITIVE, .help = TS_SEED_HELP),    \
		TS_INT("atom_type", T, base.type, .fallback = "1", .range = TS_POSITIVE,                     \
		       .help = "type of the particles"),                                                     \
		TS_LIST_KEYWORD("density", T, base.density_words, .flags = TS_TO_KEYWORD,                    \
				.help = "constant D | uniform LO HI | gaussian MEAN DEVIATION | "            \
					"lognormal MEDIAN DEVIATION"),                                       \
		TS_REAL("volume_limit", T, base.volume_limit, .fallback = "1e-12", .range = TS_NOT_NEGATIVE, \
			.unit = "length^3",                                                                  \
			.help = "smallest mean volume that is accepted: a smaller one may be an error of "   \
				"units"),                                                                    \
		TS_BOOL("relative", T, base.relative, .fallback = "no",                                      \
			.help = "radii are fractions of one that another command defines")

/* For template styles: checks type and seed and reads the density; and reads the distribution of a quantity,
 * "constant R", "uniform mass LO HI" ... */
enum ts_status ts_template_start(struct ts_instance *self, struct tsim *sim);
enum ts_status ts_template_spread(struct ts_instance *self, struct tsim *sim, const char *what,
				  struct ts_words words, struct ts_spread *out);
/* Fails if the mean volume is below volume_limit. */
enum ts_status ts_template_check_volume(struct ts_instance *self, struct tsim *sim);

/* The archive function of templates; and for any random stream, under `name`. */
enum ts_status ts_template_archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *archive);
enum ts_status ts_template_archive_stream(struct ts_archive *archive, struct tsim *sim, const char *name,
					  struct ts_minstd *random);

/* Finds the template with this fix ID, or fails. */
enum ts_status ts_template_require(struct tsim *sim, const struct ts_word *id, struct ts_instance **out);

/* What a fix that has no templates can insert; first member of the state of styles of this family. */
#define TS_FAMILY_PROSPECT "prospect"
struct ts_prospect {
	int64_t type;
	double least, lightest; /* smallest radius and mass */
};

/* The largest type of all particles, templates, fixes of the above family and those that give types to particles; 0 if
 * there are none. As in LIGGGHTS, contact laws must be defined for all types up to it. */
int ts_template_max_type(const struct tsim *sim);
/* The groups, as bits, of which inserted particles may be members: those of templates, distributions and fixes that
 * insert. */
uint32_t ts_template_groups(const struct tsim *sim);
/* Whether there is a template of single spheres, or a fix that makes its own. */
bool ts_template_of_spheres(const struct tsim *sim);
/* 1 / mass of the lightest particle of this type that a fix can insert, or -1 if there is no such fix;
 * *radius: its radius (may be NULL). */
double ts_template_inverse_mass(const struct tsim *sim, int type, double *radius);

/* Fails unless 1 <= seed <= 2^31 - 2; with `legacy yes` warns of seeds that LIGGGHTS 3.8 refuses. `what`
 * begins messages. */
enum ts_status ts_template_check_seed(struct tsim *sim, const char *what, int64_t seed,
				      const struct ts_place *where);

#endif
