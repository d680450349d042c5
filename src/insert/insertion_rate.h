/* Insertion at a rate, until a number or a mass is reached: fix insert/stream and insert/rate/region. */
#ifndef TS_INSERT_INSERTION_RATE_H
#define TS_INSERT_INSERTION_RATE_H

#include "insert/insertion.h"

struct ts_insertion_rate {
	const char *number_word, *mass_word; /* NULL: not given */
	double particlerate, massrate;	     /* NaN: not given */

	/* set by ts_insertion_rate_init */
	int64_t total; /* -1: no end */
	double rate;   /* particles per time */
	bool told;
};
#define TS_INSERTION_RATE_ARGS(T)                                                                         \
	TS_WORD("nparticles", T, rate.number_word, .flags = TS_OPTIONAL,                                  \
		.help = "how many particles are inserted in all, or INF"),                                \
		TS_WORD("mass", T, rate.mass_word, .flags = TS_OPTIONAL,                                  \
			.help = "instead of nparticles: how much mass, or INF"),                          \
		TS_REAL("particlerate", T, rate.particlerate, .flags = TS_OPTIONAL, .range = TS_POSITIVE, \
			.unit = "1/time", .help = "particles per time"),                                  \
		TS_REAL("massrate", T, rate.massrate, .flags = TS_OPTIONAL, .range = TS_POSITIVE,         \
			.unit = "mass/time", .help = "instead of particlerate: mass per time")

/* After ts_insertion_init. */
enum ts_status ts_insertion_rate_init(struct ts_instance *self, struct tsim *sim,
				      struct ts_insertion_rate *rate);
/* At the beginning of a run, when base.every is known: says once what will come. */
void ts_insertion_rate_tell(struct ts_instance *self, struct tsim *sim, struct ts_insertion_rate *rate);
/* How many in this event: the rate times the interval, rounded up or down by lot, as far as the total goes.
 * Draws one number. */
int64_t ts_insertion_rate_count(struct ts_instance *self, struct tsim *sim, struct ts_insertion_rate *rate);
/* After an event: no more of them when the total is reached. */
void ts_insertion_rate_next(struct ts_instance *self, const struct ts_insertion_rate *rate);

#endif
