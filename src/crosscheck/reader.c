#include "crosscheck/reader.h"

#include "base/banned.h"

enum ts_status ts_reader_add_name(struct ts_reader *r, struct ts_frame *f, const char *text)
{
	struct ts_str name = { 0 };
	const char *kept;
	int n = 1;

	ts_str_add(&name, text);
	do {
		if (n > 1) {
			ts_str_clear(&name);
			ts_str_addf(&name, "%s (%d)", text, n);
		}
		n++;
		kept = name.failed ? NULL : ts_pool_get(r->pool, ts_str_text(&name));
	} while (kept && ts_frame_column(f, kept) != SIZE_MAX);
	ts_str_release(&name);
	if (!kept || TS_GROW(f->name, f->name_capacity, f->columns + 1) != TS_OK)
		return ts_nomem(r->err);
	f->name[f->columns++] = kept;
	return TS_OK;
}

enum ts_status ts_reader_damaged(struct ts_reader *r, const char *what)
{
	return ts_lines_fail(&r->lines, TS_DAMAGED, SIZE_MAX, "%s", what);
}
