/* Mixtures of particle templates, fix particledistribution/discrete. */
#ifndef TS_INSERT_DISTRIBUTION_H
#define TS_INSERT_DISTRIBUTION_H

#include "insert/template.h"

/* State of the fixes. */
struct ts_distribution {
	int64_t seed, n;
	struct ts_words pairs;

	/* set by ts_distribution_init */
	struct ts_instance **template;
	double *share;	       /* of number; they add up to 1 */
	double volume, mass;   /* means of a particle */
	double least, largest; /* radii of spheres around particles */
	int largest_type;

	struct ts_minstd random; /* saved */
};
extern const struct ts_arg ts_distribution_args[];
enum ts_status ts_distribution_archive(struct ts_instance *self, struct tsim *sim,
				       struct ts_archive *archive);
/* Weights are shares of mass, or of number. */
enum ts_status ts_distribution_init(struct ts_instance *self, struct tsim *sim, bool by_mass);

/* The distribution that the word names, or an error. */
enum ts_status ts_distribution_require(struct tsim *sim, const struct ts_word *id, struct ts_instance **out);

/* A particle that is to be made. */
struct ts_newcomer {
	struct ts_instance *template; /* NULL: a sphere of nobody's */
	uint32_t mask;		      /* groups of template and distribution */
	int32_t type;
	double radius, density;
	bool placed;
	double x[3], v[3], omega[3];
	double q[4]; /* orientation of a clump */
};
struct ts_newcomers {
	struct ts_newcomer *item;
	size_t n, capacity;
};

/* Draws n particles, large ones first. `exact`: the shares are kept as well as whole numbers allow; else
 * each template has its number rounded at random, and there may be more or less than n. */
enum ts_status ts_distribution_draw(struct ts_instance *self, struct tsim *sim, int64_t n, bool exact,
				    struct ts_newcomers *out);

#endif
