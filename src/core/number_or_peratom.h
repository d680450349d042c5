/* An argument with one value, or one for each particle (a variable of style atom). */
#ifndef TS_CORE_NUMBER_OR_PERATOM_H
#define TS_CORE_NUMBER_OR_PERATOM_H

#include "core/arg.h"
#include "core/value.h"

/* Zero-initialise; ts_number_or_peratom_release when done. */
struct ts_number_or_peratom {
	double value;
	const double *list; /* a value for each local particle, in `table`; NULL: `value` for all */
	struct ts_table table;
};

/* Evaluates the number: its variable may be of style equal or atom. */
enum ts_status ts_number_or_peratom_now(struct tsim *sim, const struct ts_number *number,
					const struct ts_place *where, struct ts_number_or_peratom *values);
static inline double ts_number_or_peratom_of(const struct ts_number_or_peratom *values, size_t i)
{
	return values->list ? values->list[i] : values->value;
}
static inline void ts_number_or_peratom_release(struct ts_number_or_peratom *values)
{
	ts_table_release(&values->table);
}

#endif
