/* Buffers that a caller of the library may still read: freed when their owner and the last reader have
 * released them. */
#ifndef TS_BASE_SHARED_BUFFER_H
#define TS_BASE_SHARED_BUFFER_H

#include <stdbool.h>
#include <stddef.h>

#include "base/status.h"

struct ts_shared_buffer {
	void *data;
	int count;
	bool orphan; /* the owner has let go */
};

/* Zero-initialise. */
struct ts_shared_buffers {
	struct ts_shared_buffer *item;
	size_t n, capacity;
};

enum ts_status ts_shared_buffer(struct ts_shared_buffers *holds, void *data);
/* Undoes one ts_shared_buffer. */
void ts_shared_buffer_release(struct ts_shared_buffers *holds, const void *data);
/* What the owner calls instead of ts_free. holds may be NULL. */
void ts_shared_buffer_free(struct ts_shared_buffers *holds, void *data);
/* Frees all that was kept, held or not. */
void ts_shared_buffers_end(struct ts_shared_buffers *holds);

#endif
