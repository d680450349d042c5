#include "base/hold.h"

#include "base/alloc.h"

#include "base/banned.h"

static struct ts_hold *find(const struct ts_holds *holds, const void *data)
{
	for (size_t k = 0; holds && k < holds->n; k++)
		if (holds->item[k].data == data)
			return &holds->item[k];
	return NULL;
}

enum ts_status ts_hold(struct ts_holds *holds, void *data)
{
	struct ts_hold *hold = find(holds, data);

	if (!hold) {
		TS_TRY(TS_GROW(holds->item, holds->capacity, holds->n + 1));
		hold = &holds->item[holds->n++];
		*hold = (struct ts_hold){ .data = data };
	}
	hold->count++;
	return TS_OK;
}

void ts_hold_release(struct ts_holds *holds, const void *data)
{
	struct ts_hold *hold = find(holds, data);

	if (!hold || --hold->count > 0)
		return;
	if (hold->orphan)
		ts_free(hold->data);
	*hold = holds->item[--holds->n];
}

void ts_hold_free(struct ts_holds *holds, void *data)
{
	struct ts_hold *hold = data ? find(holds, data) : NULL;

	if (hold)
		hold->orphan = true;
	else
		ts_free(data);
}

void ts_holds_end(struct ts_holds *holds)
{
	for (size_t k = 0; k < holds->n; k++)
		if (holds->item[k].orphan)
			ts_free(holds->item[k].data);
	ts_free(holds->item);
	*holds = (struct ts_holds){ 0 };
}
