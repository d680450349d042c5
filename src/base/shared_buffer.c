#include "base/shared_buffer.h"

#include "base/alloc.h"

#include "base/banned.h"

static struct ts_shared_buffer *find(const struct ts_shared_buffers *holds, const void *data)
{
	for (size_t k = 0; holds && k < holds->n; k++)
		if (holds->item[k].data == data)
			return &holds->item[k];
	return NULL;
}

enum ts_status ts_shared_buffer(struct ts_shared_buffers *holds, void *data)
{
	struct ts_shared_buffer *hold = find(holds, data);

	if (!hold) {
		TS_TRY(TS_GROW(holds->item, holds->capacity, holds->n + 1));
		hold = &holds->item[holds->n++];
		*hold = (struct ts_shared_buffer){ .data = data };
	}
	hold->count++;
	return TS_OK;
}

void ts_shared_buffer_release(struct ts_shared_buffers *holds, const void *data)
{
	struct ts_shared_buffer *hold = find(holds, data);

	if (!hold || --hold->count > 0)
		return;
	if (hold->orphan)
		ts_free(hold->data);
	*hold = holds->item[--holds->n];
}

void ts_shared_buffer_free(struct ts_shared_buffers *holds, void *data)
{
	struct ts_shared_buffer *hold = data ? find(holds, data) : NULL;

	if (hold)
		hold->orphan = true;
	else
		ts_free(data);
}

void ts_shared_buffers_end(struct ts_shared_buffers *holds)
{
	for (size_t k = 0; k < holds->n; k++)
		if (holds->item[k].orphan)
			ts_free(holds->item[k].data);
	ts_free(holds->item);
	*holds = (struct ts_shared_buffers){ 0 };
}
