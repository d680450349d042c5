/* What the functions of tsim.h share. */
#ifndef TS_LIBRARY_LIBRARY_H
#define TS_LIBRARY_LIBRARY_H

#include "core/sim.h"
#include "core/stepping.h"
#include "tsim.h"

struct ts_library_call {
	tsim_step_fn *fn;
	void *data;
};

struct ts_library_calls {
	struct ts_library_call *item;
	size_t n, capacity;
};

struct ts_library {
	struct ts_instance outside; /* takes part in steps for those who asked by tsim_on_step */
	struct ts_library_calls calls[TSIM_STAGES];
	int stage; /* where a function of tsim_on_step acts now; -1: nowhere */
	struct ts_stepping stepping;
	struct ts_table table; /* what tsim_evaluate gave away */
	tsim_log_fn *on_log;
	void *on_log_data;
};

/* The status as the value of a public function; makes sure that there is a message. */
int ts_library_settle(struct tsim *sim, enum ts_status status);
/* Refuses a pointer that is NULL and may not be; sim itself may be that. */
int ts_library_null(struct tsim *sim, const char *function, const char *argument);
#define TS_LIBRARY_NEEDS(sim, pointer)                                     \
	do {                                                               \
		if (!(pointer))                                            \
			return ts_library_null((sim), __func__, #pointer); \
	} while (0)
/* An array without elements may be NULL. */
#define TS_LIBRARY_NEEDS_ARRAY(sim, pointer, n)                            \
	do {                                                               \
		if ((n) && !(pointer))                                     \
			return ts_library_null((sim), __func__, #pointer); \
	} while (0)
/* Refuses what is not possible inside a step. */
enum ts_status ts_library_idle(struct tsim *sim, const char *what);
/* Fills a structure of the caller, which may be older and shorter than ours. */
void ts_library_give(void *out, const void *full, size_t size);
/* Copies a text into `room` characters. */
void ts_library_copy(const char *text, char *out, size_t room, size_t *length);
/* Rows of the particles with these identities, freed by ts_free; id NULL: all, by identity. */
enum ts_status ts_library_rows(struct tsim *sim, const int32_t *id, size_t n, int32_t **rows);

#endif
