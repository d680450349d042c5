#include "neigh/row_loop.h"

#include "base/banned.h"

void ts_row_share_generic(void *task, size_t from, size_t to)
{
	ts_row_share(task, from, to, &((const struct ts_row_task *)task)->pair->model);
}

void ts_row_share_each(void *task, size_t from, size_t to)
{
	ts_row_share(task, from, to, NULL);
}
