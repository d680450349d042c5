/* Insertion of particles during a run: common part of the fixes insert/...
 *
 * The random streams, and the order in which numbers are drawn from them, are those of LIGGGHTS 3.8, so
 * that a script gives the same particles at the same positions. */
#ifndef TS_INSERT_INSERTION_H
#define TS_INSERT_INSERTION_H

#include "geom/spherehash.h"
#include "insert/distribution.h"

struct ts_insertion_velocity {
	int spread;			/* constant, uniform, gaussian */
	double mean[3], fluctuation[3]; /* fluctuation: largest or standard deviation */
};

/* A sphere of a particle, or of a clump, that is made. */
struct ts_new_sphere {
	double x[3], radius;
	int32_t row; /* its local index; -1: it belongs to another rank */
};

/* First member of the state of every fix insert/... */
struct ts_insertion {
	struct ts_prospect own; /* of fixes without templates */
	int64_t seed, maxattempt, start;
	const char *distribution_id, *every_word;
	int random_distribute;
	bool verbose, overlapcheck, all_in, compress_tags;
	struct ts_words velocity_words, omega_words, orientation_words, property_words;

	/* set by ts_insertion_init */
	struct ts_instance *distribution;
	int64_t every; /* steps between insertions; 0: a single insertion */
	struct ts_insertion_velocity velocity;
	double omega[3];
	bool turns;		      /* random orientation */
	double q[4];		      /* else the orientation, a quaternion */
	double property;	      /* value of set_property */
	struct ts_new_particles list; /* of this insertion */
	struct ts_new_sphere
		*sphere; /* [spheres], in the order of their identities: set by ts_insertion_make */
	size_t spheres, sphere_capacity;
	bool warned, due; /* due: particles are inserted in this step */

	/* saved */
	struct ts_minstd random;
	int64_t wait;	  /* steps until the next insertion; 0: there is none */
	int64_t inserted; /* particles, or clumps, so far */
	double mass;	  /* mass inserted so far */
};
/* Arguments that all these fixes share, in three parts, and the whole of most of them. */
#define TS_INSERTION_SOURCE_ARGS(T)                                                                          \
	TS_INT("seed", T, base.seed, .range = TS_POSITIVE,                                                   \
	       .help = TS_SEED_HELP "; must differ from the seeds of the distribution and its templates"),   \
		TS_WORD("distributiontemplate", T, base.distribution_id,                                     \
			.help = "ID of the fix particledistribution/discrete whose particles are inserted"), \
		TS_INT("maxattempt", T, base.maxattempt, .fallback = "50", .range = TS_POSITIVE,             \
		       .help = "average number of trial positions per particle"),                            \
		TS_INT("start", T, base.start, .flags = TS_OPTIONAL | TS_CUT, .range = TS_NOT_NEGATIVE,      \
		       .help = "step of the first insertion; default: the next step"),                       \
		TS_BOOL("overlapcheck", T, base.overlapcheck, .fallback = "yes",                             \
			.help = "inserted particles must not overlap each other or present particles")
#define TS_INSERTION_MOTION_ARGS(T)                                                                         \
	TS_LIST_KEYWORD("omega", T, base.omega_words, .flags = TS_TO_KEYWORD | TS_OPTIONAL,                 \
			.help = "constant wx wy wz: angular velocity; default 0"),                          \
		TS_LIST_KEYWORD("orientation", T, base.orientation_words,                                   \
				.flags = TS_TO_KEYWORD | TS_OPTIONAL,                                       \
				.help = "random | template | constant q1 q2 q3 q4: orientation of clumps; " \
					"default template"),                                                \
		TS_LIST_KEYWORD("set_property", T, base.property_words,                                     \
				.flags = TS_TO_KEYWORD | TS_OPTIONAL,                                       \
				.help = "name value: a property of fix property/atom, and its value for "   \
					"inserted particles")
#define TS_INSERTION_ARGS(T)                                                                              \
	TS_INSERTION_SOURCE_ARGS(T),                                                                      \
		TS_BOOL("all_in", T, base.all_in, .fallback = "no",                                       \
			.help = "particles must lie completely in the region, not only their centers"),   \
		TS_ENUM("random_distribute", T, base.random_distribute, ts_insertion_shares,              \
			.fallback = "exact",                                                              \
			.help = "whether the fractions of the templates are exact or random in each "     \
				"insertion"),                                                             \
		TS_LIST_KEYWORD("vel", T, base.velocity_words, .flags = TS_TO_KEYWORD | TS_OPTIONAL,      \
				.help = "constant vx vy vz | uniform vx vy vz dx dy dz | gaussian vx vy " \
					"vz sx sy sz: velocity, with its largest or standard deviation; " \
					"default 0"),                                                     \
		TS_INSERTION_MOTION_ARGS(T),                                                              \
		TS_BOOL("verbose", T, base.verbose, .fallback = "yes",                                    \
			.help = "print each insertion to the log"),                                       \
		TS_BOOL("compress_tags", T, base.compress_tags, .fallback = "no",                         \
			.help = "only no is accepted: particles keep their atom IDs")
extern const char *const ts_insertion_shares[];

#define TS_INSERTION_SAVED(T) \
	TS_SAVE_I64(T, base.wait), TS_SAVE_I64(T, base.inserted), TS_SAVE_F64(T, base.mass)
enum ts_status ts_insertion_archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *archive);
/* f_ID[1], f_ID[2]: number and mass inserted so far. */
extern const struct ts_value ts_insertion_values[];

/* Parses and checks the arguments. *first: this is the first call for the fix. */
enum ts_status ts_insertion_init(struct ts_instance *self, struct tsim *sim, bool *first);
void ts_insertion_fini(struct ts_instance *self);

/* Slot `due`: whether particles are inserted in the step that begins. */
bool ts_insertion_due(const struct ts_instance *self, const struct tsim *sim);
/* With several ranks: whether each of them can make its own of the new particles, while the particles are divided. All draw the
 * same random numbers and find the same places; they need those of other ranks that are near. */
bool ts_insertion_divides(const struct ts_insertion *s, const struct tsim *sim);
/* Slot `due` of fixes that can do so: whether particles are inserted and all ranks do the step with all particles. */
bool ts_insertion_whole_due(const struct ts_instance *self, const struct tsim *sim);
/* Hook for CHECK: requests a rebuild of the contact list if an insertion is due. */
enum ts_status ts_insertion_check(struct ts_instance *self, struct tsim *sim);
/* In PRE_EXCHANGE, after particles have been drawn and placed in the list: creates those of this rank and writes to the log.
 * *from: local index of the first one. */
enum ts_status ts_insertion_make(struct ts_instance *self, struct tsim *sim, size_t *from);
/* Schedules the next insertion, after `every` steps if that is not 0. */
void ts_insertion_next(struct ts_instance *self);

/* Draws the velocity of a particle; and its orientation, for each trial position. */
void ts_insertion_draw_velocity(struct ts_insertion *s, struct ts_new_particle *one);
void ts_insertion_draw_orientation(struct ts_insertion *s, struct ts_new_particle *one);

/* Number of spheres of a new particle, or of a new clump. */
size_t ts_insertion_spheres(const struct ts_new_particle *one);
/* Computes the position of sphere k and returns its radius. */
double ts_insertion_sphere(const struct ts_new_particle *one, size_t k, double x[3]);
/* Distance that sphere k reaches from the place of the particle, in any orientation; the largest one of all in the list. */
double ts_insertion_sphere_reach(const struct ts_new_particle *one, size_t k);
double ts_insertion_reach(const struct ts_new_particles *list);
/* Mass of a new particle, or of a new clump. */
double ts_insertion_mass(const struct tsim *sim, const struct ts_new_particle *one);

/* Moves x to its periodic image in the box: the overlap functions find images of places in the box, only. */
void ts_insertion_wrap(const struct ts_box *box, double x[3]);
/* Adds to the hash the present particles, of all ranks, that a new one may overlap which is placed between lo and hi, or at one of
 * the periodic images of these places, and reaches no farther than `reach`; tests whether a new particle overlaps those in the hash;
 * adds the new particle to it. */
enum ts_status ts_insertion_hash_near(struct tsim *sim, struct ts_spherehash *occupied, const double lo[3],
				      const double hi[3], double reach);
bool ts_insertion_overlaps(const struct tsim *sim, const struct ts_spherehash *occupied,
			   const struct ts_new_particle *one);
enum ts_status ts_insertion_hash_add(struct tsim *sim, struct ts_spherehash *occupied,
				     const struct ts_new_particle *one);

/* Order of TS_INSERTION_ARGS in the manual pages. */
#define TS_INSERTION_GROUPS                                                                  \
	{ NULL, "seed distributiontemplate vel overlapcheck" },                              \
		{ "How particles are placed", "maxattempt all_in random_distribute start" }, \
		{ "What inserted particles have", "omega orientation set_property" },        \
	{                                                                                    \
		"Messages and identities", "verbose compress_tags"                           \
	}

#endif
