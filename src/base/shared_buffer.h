/* Buffers that callers of the library may still read: freed when the owner and the last reader have
 * released them. */
#ifndef TS_BASE_SHARED_BUFFER_H
#define TS_BASE_SHARED_BUFFER_H

#include <stdbool.h>
#include <stddef.h>

#include "base/status.h"

struct ts_shared_buffer {
	void *data;
	int count;
	bool orphan; /* released by the owner */
};

/* Zero-initialise. */
struct ts_shared_buffers {
	struct ts_shared_buffer *item;
	size_t n, capacity;
};

/* Adds one use of a buffer. */
enum ts_status ts_shared_buffer(struct ts_shared_buffers *buffers, void *data);
/* Releases one use. */
void ts_shared_buffer_release(struct ts_shared_buffers *buffers, const void *data);
/* To be called by the owner instead of ts_free. holds may be NULL. */
void ts_shared_buffer_free(struct ts_shared_buffers *buffers, void *data);
/* Frees all remaining buffers, in use or not. */
void ts_shared_buffers_end(struct ts_shared_buffers *buffers);

#endif
