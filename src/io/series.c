#include "io/series.h"

#include <dirent.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/sort.h"

#include "base/banned.h"

/* A path: the whole text, its last component, the `*` in that (NULL: none). */
struct pattern {
	const char *text, *last, *star;
};

static struct pattern split_pattern(const char *text)
{
	const char *slash = strrchr(text, '/'), *last = slash ? slash + 1 : text;

	return (struct pattern){ text, last, strchr(last, '*') };
}

bool ts_series_is(const char *pattern)
{
	return split_pattern(pattern).star != NULL;
}

/* *out: the number at the `*`; false: the name does not match. */
static bool match_number(const char *name, const struct pattern *p, int64_t *out)
{
	const char *after = p->star + 1;
	size_t n = (size_t)(p->star - p->last), length = strlen(name), tail = strlen(after);
	size_t digits = length - n - tail;
	char text[24];

	if (length <= n + tail || digits >= sizeof text || strncmp(name, p->last, n) != 0 ||
	    !ts_streq(name + length - tail, after) || strspn(name + n, "0123456789") < digits)
		return false;
	memcpy(text, name + n, digits);
	text[digits] = 0;
	return ts_parse_int(text, out);
}

static enum ts_status add_file(struct ts_series *series, const struct pattern *p, const char *name,
			       int64_t step)
{
	struct ts_str path = { 0 };

	TS_TRY(TS_GROW(series->file, series->capacity, series->n + 1));
	ts_str_add_n(&path, p->text, (size_t)(p->last - p->text));
	ts_str_add(&path, name);
	if (path.failed) {
		ts_str_release(&path);
		return TS_NOMEM;
	}
	series->file[series->n] = (struct ts_series_file){ step, ts_strdup(ts_str_text(&path)) };
	ts_str_release(&path);
	return series->file[series->n++].path ? TS_OK : TS_NOMEM;
}

static enum ts_status search_folder(DIR *folder, const struct pattern *p, struct ts_series *series)
{
	struct dirent *entry;
	int64_t step;

	while ((entry = readdir(folder)))
		if (match_number(entry->d_name, p, &step))
			TS_TRY(add_file(series, p, entry->d_name, step));
	return TS_OK;
}

/* By step; of equal steps, such as 7 and 007, the shorter name first. */
static int compare_steps(const void *a, const void *b)
{
	const struct ts_series_file *f = a, *g = b;

	if (f->step != g->step)
		return f->step < g->step ? -1 : 1;
	return (strlen(f->path) > strlen(g->path)) - (strlen(f->path) < strlen(g->path));
}

enum ts_status ts_series_find(struct ts_files *files, const char *pattern, struct ts_series *out)
{
	struct pattern p = split_pattern(pattern);
	struct ts_str folder = { 0 };
	enum ts_status status = TS_OK;
	DIR *open;

	if (!p.star) {
		p.last = p.text;
		return add_file(out, &p, pattern, 0);
	}
	ts_str_add_n(&folder, pattern, (size_t)(p.last - pattern));
	if (folder.failed)
		return TS_NOMEM;
	open = ts_files_list(files, folder.length ? folder.text : ".");
	if (open) {
		status = search_folder(open, &p, out);
		closedir(open);
	}
	ts_str_release(&folder);
	ts_sort(out->file, out->n, sizeof *out->file, compare_steps);
	return status;
}

void ts_series_release(struct ts_series *series)
{
	for (size_t k = 0; k < series->n; k++)
		ts_free(series->file[k].path);
	ts_free(series->file);
	*series = (struct ts_series){ 0 };
}

void ts_series_path(struct ts_str *out, const char *path, long long step, int pad)
{
	ts_str_clear(out);
	for (const char *star; (star = strchr(path, '*')); path = star + 1) {
		ts_str_add_n(out, path, (size_t)(star - path));
		ts_str_addf(out, "%0*lld", pad, step);
	}
	ts_str_add(out, path);
}
