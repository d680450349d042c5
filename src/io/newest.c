#include "io/newest.h"

#include <dirent.h>
#include <string.h>

#include "base/banned.h"

/* The number between the ends, if there is nothing else. */
static bool number_in(const char *name, const char *before, size_t n, const char *after, int64_t *out)
{
	size_t length = strlen(name), tail = strlen(after), digits = length - n - tail;
	char text[24];

	if (length <= n + tail || digits >= sizeof text || strncmp(name, before, n) != 0 ||
	    !ts_streq(name + length - tail, after) ||
	    strspn(name + n, "0123456789") < digits)
		return false;
	memcpy(text, name + n, digits);
	text[digits] = 0;
	return ts_parse_int(text, out);
}

static void search(DIR *folder, const char *before, size_t n, const char *after, struct ts_str *name)
{
	int64_t newest = -1, step;
	struct dirent *entry;

	while ((entry = readdir(folder))) {
		if (!number_in(entry->d_name, before, n, after, &step) || step <= newest)
			continue;
		newest = step;
		ts_str_clear(name);
		ts_str_add(name, entry->d_name);
	}
}

void ts_newest_path(const char *pattern, struct ts_str *out)
{
	const char *slash = strrchr(pattern, '/'), *last = slash ? slash + 1 : pattern;
	const char *star = strchr(last, '*');
	struct ts_str folder = { 0 }, name = { 0 };
	DIR *open;

	ts_str_clear(out);
	if (!star) {
		ts_str_add(out, pattern);
		return;
	}
	ts_str_add_n(&folder, pattern, (size_t)(last - pattern));
	open = folder.failed ? NULL : opendir(folder.length ? folder.text : ".");
	if (open) {
		search(open, last, (size_t)(star - last), star + 1, &name);
		closedir(open);
	}
	if (name.length)
		ts_str_addf(out, "%s%s", ts_str_text(&folder), name.text);
	out->failed |= folder.failed || name.failed;
	ts_str_release(&folder);
	ts_str_release(&name);
}
