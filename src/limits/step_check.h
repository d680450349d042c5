/* What fix check/timestep/gran and check/timestep/bond share: when they check, the largest allowed fractions, what
 * is said when one is exceeded, and how fast particles may come nearer to each other. */
#ifndef TS_LIMITS_STEP_CHECK_H
#define TS_LIMITS_STEP_CHECK_H

#include "core/sim.h"

enum { TS_STEP_FRACTIONS = 2, TS_STEP_RATIOS = 3 };

struct ts_step_check {
	struct ts_words words; /* N or check_every_time T, then the fractions */
	bool warn, error, legacy;
	double vmax;
	double fraction[TS_STEP_FRACTIONS];
	double interval; /* between checks, time; NaN: given in steps */
	int64_t every;
	double ratio[TS_STEP_RATIOS]; /* of the last check; saved */
	double warned[TS_STEP_RATIOS];
};

#define TS_STEP_CHECK_ROWS(T, f)                                                                          \
	TS_BOOL("warn", T, f.warn, .fallback = "yes", .help = "warn if a fraction is exceeded"),          \
		TS_BOOL("error", T, f.error, .fallback = "no",                                            \
			.help = "end the run if a fraction is exceeded"),                                 \
		TS_REAL("vmax", T, f.vmax, .fallback = "0", .range = TS_NOT_NEGATIVE, .unit = "velocity", \
			.help = "lower bound of the particle speed"),                                     \
		TS_BOOL("legacy", T, f.legacy, .fallback = "no",                                          \
			.help = "compute the times as LIGGGHTS does, see below")

/* Reads `words`: the interval and `n` fractions, named `names` in messages. */
enum ts_status ts_step_check_init(const struct ts_instance *self, struct tsim *sim, struct ts_step_check *c,
				  size_t n, const char *names);
bool ts_step_check_is_due(const struct ts_step_check *c, const struct tsim *sim);
/* Largest speed at which two particles of the group, or one and a mesh, may come nearer to each other. */
double ts_step_check_speed(const struct ts_instance *self, const struct tsim *sim,
			   const struct ts_step_check *c);
/* Warns, or ends the run, if ratio[which], the step as a fraction `of` a time, exceeds fraction[which]. A warning is
 * repeated only if the ratio has grown. `more` is appended to the message, or "". */
enum ts_status ts_step_check_judge(const struct ts_instance *self, struct tsim *sim, struct ts_step_check *c,
				   int which, const char *of, const char *more);
/* The same for ratio[which], the displacement in a step as a fraction of the skin: with `legacy` only. */
enum ts_status ts_step_check_judge_skin(const struct ts_instance *self, struct tsim *sim,
					struct ts_step_check *c, int which);
/* Output of the ratios, of a fix whose state begins with its ts_step_check. */
enum ts_status ts_step_check_eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out);

#endif
