/* An argument that is one number, or one for each particle (an atom-style variable). */
#ifndef TS_CORE_EACH_H
#define TS_CORE_EACH_H

#include "core/arg.h"
#include "core/value.h"

/* Zero-initialise; ts_each_release when done. */
struct ts_each {
	double value;
	const double *list; /* by particle, or NULL */
	struct ts_table table;
};

/* The number as it is now. */
enum ts_status ts_each_now(struct tsim *sim, const struct ts_number *number,
			   const struct ts_place *where, struct ts_each *each);
static inline double ts_each_of(const struct ts_each *each, size_t i)
{
	return each->list ? each->list[i] : each->value;
}
static inline void ts_each_release(struct ts_each *each)
{
	ts_table_release(&each->table);
}

#endif
