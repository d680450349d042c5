/* How a rank waits for others, between two polls: it offers its processor to other programs. With OMP_WAIT_POLICY=passive,
 * which holds for threads as well, it also sleeps where others compute: then a rank that is ready gets a processor on which
 * no other one polls, instead of waiting for a slice of time of the other program in each exchange. */
#ifndef TS_RANK_WAITING_H
#define TS_RANK_WAITING_H

#include <stdbool.h>

struct ts_waiting {
	bool passive;
	int polls;	     /* before the processor is offered for the first time */
	double begun;	     /* clock when the present wait began, s */
	double shared_until; /* clock until which other programs are taken to compute, s */
};

/* The policy of this word, NULL: none. */
struct ts_waiting ts_waiting_policy(const char *word);
/* Times of sleep of this thread are exact, as far as it sleeps: Linux rounds them up by 50 us. */
void ts_waiting_be_exact(const struct ts_waiting *w);
/* Offers the processor, or sleeps; `first` in this wait. */
void ts_waiting_offer(struct ts_waiting *w, bool first);

#endif
