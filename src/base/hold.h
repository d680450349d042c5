/* Memory that someone outside still looks at: freed when the owner and the last who holds it have let
 * go. */
#ifndef TS_BASE_HOLD_H
#define TS_BASE_HOLD_H

#include <stdbool.h>
#include <stddef.h>

#include "base/status.h"

struct ts_hold {
	void *data;
	int count;
	bool orphan; /* the owner has let go */
};

/* Zero-initialise. */
struct ts_holds {
	struct ts_hold *item;
	size_t n, capacity;
};

enum ts_status ts_hold(struct ts_holds *holds, void *data);
/* Undoes one ts_hold. */
void ts_hold_release(struct ts_holds *holds, const void *data);
/* What the owner calls instead of ts_free. holds may be NULL. */
void ts_hold_free(struct ts_holds *holds, void *data);
/* Frees all that was kept, held or not. */
void ts_holds_end(struct ts_holds *holds);

#endif
