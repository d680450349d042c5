/* Mixtures of particle templates, fix particledistribution/discrete. */
#ifndef TS_INSERT_DISTRIBUTION_H
#define TS_INSERT_DISTRIBUTION_H

#include "insert/template.h"

/* State of these fixes. */
struct ts_distribution {
	int64_t seed, n;
	struct ts_words pairs;

	/* set by ts_distribution_init */
	struct ts_instance **template;
	uint64_t *serial;      /* [n], numbers of these instances */
	double *share;	       /* [n], fraction of the number of particles; the sum is 1 */
	double volume, mass;   /* means per particle */
	double least, largest; /* smallest radius of a sphere; largest of a bounding sphere */
	int largest_type;

	struct ts_minstd random; /* saved */
};
extern const struct ts_arg ts_distribution_args[];
enum ts_status ts_distribution_archive(struct ts_instance *self, struct tsim *sim,
				       struct ts_archive *archive);
/* The weights of the script are fractions of mass, or of number. */
enum ts_status ts_distribution_init(struct ts_instance *self, struct tsim *sim, bool by_mass);

/* Finds the distribution with this fix ID, or fails. */
enum ts_status ts_distribution_require(struct tsim *sim, const struct ts_word *id, struct ts_instance **out);

/* A particle, or clump, that is to be inserted. */
struct ts_new_particle {
	struct ts_instance *template; /* NULL: a sphere without template */
	uint64_t serial;	      /* its number */
	uint32_t mask;		      /* groups of template and distribution, as bits */
	int32_t type;
	double radius, density;
	bool placed; /* a position was found */
	double x[3], v[3], omega[3];
	double q[4]; /* orientation of a clump */
};
struct ts_new_particles {
	struct ts_new_particle *item;
	size_t n, capacity;
};

/* Draws particles and sorts them by decreasing radius. `exact`: n particles, with fractions as exact as whole
 * numbers allow; else the number of each template is rounded up or down at random, and their sum may differ
 * from n. `user`: the fix that inserts them. */
enum ts_status ts_distribution_draw(struct ts_instance *self, struct tsim *sim,
				    const struct ts_instance *user, int64_t n, bool exact,
				    struct ts_new_particles *out);
/* Whether the template of a particle that was drawn in an earlier step is still there, not defined anew. */
bool ts_distribution_holds(const struct ts_instance *self, const struct ts_new_particle *one);

/* Writes or reads a particle that has been drawn but not been inserted yet; *some: there is one. */
enum ts_status ts_distribution_archive_particle(struct ts_instance *self, struct tsim *sim,
						struct ts_archive *archive, const char *name,
						struct ts_new_particle *one, bool *some);

#endif
