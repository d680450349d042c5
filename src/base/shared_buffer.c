#include "base/shared_buffer.h"

#include "base/alloc.h"

#include "base/banned.h"

static struct ts_shared_buffer *find_buffer(const struct ts_shared_buffers *buffers, const void *data)
{
	for (size_t k = 0; buffers && k < buffers->n; k++)
		if (buffers->item[k].data == data)
			return &buffers->item[k];
	return NULL;
}

enum ts_status ts_shared_buffer(struct ts_shared_buffers *buffers, void *data)
{
	struct ts_shared_buffer *buffer = find_buffer(buffers, data);

	if (!buffer) {
		TS_TRY(TS_GROW(buffers->item, buffers->capacity, buffers->n + 1));
		buffer = &buffers->item[buffers->n++];
		*buffer = (struct ts_shared_buffer){ .data = data };
	}
	buffer->count++;
	return TS_OK;
}

void ts_shared_buffer_release(struct ts_shared_buffers *buffers, const void *data)
{
	struct ts_shared_buffer *buffer = find_buffer(buffers, data);

	if (!buffer || --buffer->count > 0)
		return;
	if (buffer->orphan)
		ts_free(buffer->data);
	*buffer = buffers->item[--buffers->n];
}

void ts_shared_buffer_free(struct ts_shared_buffers *buffers, void *data)
{
	struct ts_shared_buffer *buffer = data ? find_buffer(buffers, data) : NULL;

	if (buffer)
		buffer->orphan = true;
	else
		ts_free(data);
}

void ts_shared_buffers_end(struct ts_shared_buffers *buffers)
{
	for (size_t k = 0; k < buffers->n; k++)
		if (buffers->item[k].orphan)
			ts_free(buffers->item[k].data);
	ts_free(buffers->item);
	*buffers = (struct ts_shared_buffers){ 0 };
}
