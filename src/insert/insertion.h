/* Insertion of particles into a running simulation: what the fixes insert/... share.
 *
 * The random streams, and the order in which numbers are taken from them, are those of LIGGGHTS 3.8, so that
 * a script gives the same particles at the same places. */
#ifndef TS_INSERT_INSERTION_H
#define TS_INSERT_INSERTION_H

#include "geom/spherehash.h"
#include "insert/distribution.h"

struct ts_insertion_velocity {
	int spread; /* constant, uniform, gaussian */
	double mean[3], fluctuation[3];
};

/* First member of the state of every fix insert/... */
struct ts_insertion {
	struct ts_prospect own; /* of fixes that have no templates */
	int64_t seed, maxattempt, start;
	const char *distribution_id, *every_word;
	int random_distribute;
	bool verbose, overlapcheck, all_in, compress_tags;
	struct ts_words velocity_words, omega_words, orientation_words, property_words;

	/* set by ts_insertion_init */
	struct ts_instance *distribution;
	int64_t every; /* steps between events; 0: one event */
	struct ts_insertion_velocity velocity;
	double omega[3];
	bool turns;  /* orientation random */
	double q[4]; /* else: the orientation */
	double property;
	struct ts_newcomers list;
	bool warned, due; /* an event is due in this step */

	/* saved */
	struct ts_minstd random;
	int64_t wait; /* steps until the next event; 0: there is none */
	int64_t inserted;
	double mass;
};
#define TS_INSERTION_ARGS(T)                                                                                \
	TS_INT("seed", T, base.seed, .range = TS_POSITIVE,                                                  \
	       .help = TS_SEED_HELP " - and another one than those of the distribution and its templates"), \
		TS_WORD("distributiontemplate", T, base.distribution_id,                                    \
			.help = "the fix particledistribution/discrete whose particles are inserted"),      \
		TS_INT("maxattempt", T, base.maxattempt, .fallback = "50", .range = TS_POSITIVE,            \
		       .help = "tries to place a particle, on average"),                                    \
		TS_INT("start", T, base.start, .flags = TS_OPTIONAL, .range = TS_NOT_NEGATIVE,              \
		       .help = "step of the first event; without it the next one"),                         \
		TS_BOOL("overlapcheck", T, base.overlapcheck, .fallback = "yes",                            \
			.help = "particles must not overlap others, old or new"),                           \
		TS_BOOL("all_in", T, base.all_in, .fallback = "no",                                         \
			.help = "particles lie in the region wholly, not just with their centers"),         \
		TS_ENUM("random_distribute", T, base.random_distribute, ts_insertion_shares,                \
			.fallback = "exact",                                                                \
			.help = "whether shares of templates are kept exactly, or on average"),             \
		TS_LIST_KEYWORD("vel", T, base.velocity_words, .flags = TS_TO_KEYWORD | TS_OPTIONAL,        \
				.help = "constant vx vy vz | uniform vx vy vz dx dy dz | gaussian vx vy "   \
					"vz sx sy sz: velocity, with its largest or standard deviation; "   \
					"0 by default"),                                                    \
		TS_LIST_KEYWORD("omega", T, base.omega_words, .flags = TS_TO_KEYWORD | TS_OPTIONAL,         \
				.help = "constant wx wy wz: angular velocity, 0 by default"),               \
		TS_LIST_KEYWORD("orientation", T, base.orientation_words,                                   \
				.flags = TS_TO_KEYWORD | TS_OPTIONAL,                                       \
				.help = "random | template | constant q1 q2 q3 q4: of clumps; template "    \
					"by default"),                                                      \
		TS_LIST_KEYWORD("set_property", T, base.property_words,                                     \
				.flags = TS_TO_KEYWORD | TS_OPTIONAL,                                       \
				.help = "name value: a number of fix property/atom that inserted "          \
					"particles get"),                                                   \
		TS_BOOL("verbose", T, base.verbose, .fallback = "yes",                                      \
			.help = "each event is told in the log"),                                           \
		TS_BOOL("compress_tags", T, base.compress_tags, .fallback = "no",                           \
			.help = "only no: a particle keeps its number")
extern const char *const ts_insertion_shares[];

#define TS_INSERTION_SAVED(T) \
	TS_SAVE_I64(T, base.wait), TS_SAVE_I64(T, base.inserted), TS_SAVE_F64(T, base.mass)
enum ts_status ts_insertion_archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *archive);
/* f_ID[1], f_ID[2]: number and mass inserted so far. */
extern const struct ts_value ts_insertion_values[];

/* Parses and checks. *first: this is the first call, of a new fix. */
enum ts_status ts_insertion_init(struct ts_instance *self, struct tsim *sim, bool *first);
void ts_insertion_fini(struct ts_instance *self);

/* Hook for CHECK: asks for a rebuild when an event is due. */
enum ts_status ts_insertion_check(struct ts_instance *self, struct tsim *sim);
/* In PRE_EXCHANGE, after the list has been drawn and placed: makes the particles and says so. *from: row of
 * the first one made. */
enum ts_status ts_insertion_make(struct ts_instance *self, struct tsim *sim, size_t *from);
/* The event is over; the next comes after `every` steps, if there is one. */
void ts_insertion_next(struct ts_instance *self);

void ts_insertion_draw_velocity(struct ts_insertion *s, struct ts_newcomer *one);
/* For each try. */
void ts_insertion_draw_orientation(struct ts_insertion *s, struct ts_newcomer *one);

/* All particles there are, for checks of overlap; whether a new one would overlap them; and it takes its
 * place among them. */
enum ts_status ts_insertion_crowd(struct tsim *sim, struct ts_spherehash *crowd);
bool ts_insertion_overlaps(const struct tsim *sim, const struct ts_spherehash *crowd,
			   const struct ts_newcomer *one);
enum ts_status ts_insertion_join(struct tsim *sim, struct ts_spherehash *crowd,
				 const struct ts_newcomer *one);

#endif
