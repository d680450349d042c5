/* Insertion at a given rate until a number or mass is reached: fix insert/stream and insert/rate/region. */
#ifndef TS_INSERT_INSERTION_RATE_H
#define TS_INSERT_INSERTION_RATE_H

#include "insert/insertion.h"

struct ts_insertion_rate {
	const char *number_word, *mass_word; /* NULL: not given */
	double particlerate, massrate;	     /* NaN: not given */

	/* set by ts_insertion_rate_init */
	int64_t total;	   /* number of particles; -1: unlimited. Of `mass` it is the mean number */
	double total_mass; /* by `mass`; else infinite */
	double rate;	   /* particles per time */
	bool told;	   /* the log has the rate */
};
#define TS_INSERTION_RATE_ARGS(T)                                                                         \
	TS_WORD("nparticles", T, rate.number_word, .flags = TS_OPTIONAL,                                  \
		.help = "total number of particles to insert, or INF"),                                   \
		TS_WORD("mass", T, rate.mass_word, .flags = TS_OPTIONAL,                                  \
			.help = "instead of nparticles: total mass, or INF"),                             \
		TS_REAL("particlerate", T, rate.particlerate, .flags = TS_OPTIONAL, .range = TS_POSITIVE, \
			.unit = "1/time", .help = "particles per time"),                                  \
		TS_REAL("massrate", T, rate.massrate, .flags = TS_OPTIONAL, .range = TS_POSITIVE,         \
			.unit = "mass/time", .help = "instead of particlerate: mass per time")

/* After ts_insertion_init. */
enum ts_status ts_insertion_rate_init(struct ts_instance *self, struct tsim *sim,
				      struct ts_insertion_rate *rate);
/* In SETUP, when base.every is known: writes rate and total to the log, once. */
void ts_insertion_rate_print(struct ts_instance *self, struct tsim *sim, struct ts_insertion_rate *rate);
/* Number of particles of this insertion: rate * interval, rounded up or down at random so that the mean
 * is exact, limited by the total. Draws one random number. */
int64_t ts_insertion_rate_count(struct ts_instance *self, struct tsim *sim, struct ts_insertion_rate *rate);
/* Schedules the next insertion unless the total is reached. */
void ts_insertion_rate_next(struct ts_instance *self, const struct ts_insertion_rate *rate);

#endif
