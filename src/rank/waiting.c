#include "rank/waiting.h"

#include <math.h>
#include <sched.h>
#include <stddef.h>
#include <strings.h>
#include <time.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

#include "base/clock.h"

#include "base/banned.h"

/* A wait is long after LONG s. If others have had the processor for TAKEN s when it was offered, they compute: for the next
 * SHARED s no more is asked. */
static const double LONG = 1e-3, TAKEN = 1e-4, SHARED = 2e-2;
/* A nap is the longer the longer the wait has been, as each takes the system 10 to 40 us: at the end of a wait it adds at most
 * the PART of it, or NAP s. */
static const double NAP = 3e-5, LONGEST_NAP = 1e-3, PART = 0.125;

struct ts_waiting ts_waiting_policy(const char *word)
{
	bool passive = word && strcasecmp(word, "passive") == 0;

	return (struct ts_waiting){ .passive = passive, .polls = passive ? 20 : 200 };
}

void ts_waiting_be_exact(const struct ts_waiting *w)
{
#ifdef PR_SET_TIMERSLACK
	if (w->passive)
		prctl(PR_SET_TIMERSLACK, 1);
#else
	(void)w;
#endif
}

static void nap(double waited)
{
	double time = fmin(fmax(NAP, PART * waited), LONGEST_NAP);

	nanosleep(&(struct timespec){ 0, (long)(1e9 * time) }, NULL);
}

void ts_waiting_offer(struct ts_waiting *w, bool first)
{
	double now;

	if (!w->passive) {
		sched_yield();
		return;
	}
	now = ts_clock();
	if (first)
		w->begun = now;
	if (now < w->shared_until || now - w->begun > LONG) {
		nap(now - w->begun);
		return;
	}
	sched_yield();
	if (ts_clock() - now > TAKEN)
		w->shared_until = now + SHARED;
}
