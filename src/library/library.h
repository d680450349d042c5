/* Internal interface of the functions of tsim.h. */
#ifndef TS_LIBRARY_LIBRARY_H
#define TS_LIBRARY_LIBRARY_H

#include "core/sim.h"
#include "core/stepping.h"
#include "sheet/sheet.h"
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
	struct ts_instance outside; /* calls the functions of tsim_on_step in each step */
	struct ts_library_calls calls[TSIM_STAGES];
	int stage; /* the stage in which a function of tsim_on_step is running; -1: none */
	struct ts_stepping stepping;
	struct ts_table table; /* the result of the last tsim_evaluate */
	tsim_log_fn *on_log;
	void *on_log_data;
	struct ts_library_rows_told {
		tsim_row_fn *fn;
		void *data;
		const char **name; /* of the present row */
		double *value;
		size_t capacity, name_capacity;
	} row;
	struct ts_sheets sheets; /* of the last tsim_tables */
	struct ts_files_peers peers;
	void (*leave)(struct ts_world *world); /* the other ranks, at the end; NULL: none have been joined */
};

/* Converts the status to the return value of a public function, and ensures that there is an error message. */
int ts_library_result(struct tsim *sim, enum ts_status status);
/* Error: a pointer argument is NULL. sim may be NULL. */
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
/* An error inside a step; `what` names the operation. */
enum ts_status ts_library_refuse_in_step(struct tsim *sim, const char *what);
/* Copies the first out->size bytes to a structure of the caller, which may be an older and shorter version. */
void ts_library_copy_struct(void *out, const void *full, size_t size);
/* Copies a text, truncated to `room` bytes including the final 0; *length: its full length. */
void ts_library_copy(const char *text, char *out, size_t room, size_t *length);
/* Rows of the particles with these identities; id NULL: of all particles, sorted by identity. The caller
 * frees them by ts_free. */
enum ts_status ts_library_rows(struct tsim *sim, const int32_t *id, size_t n, int32_t **rows);

#endif
