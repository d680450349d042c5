/* Lists the output files of two runs, and pairs them. */
#include <ctype.h>
#include <string.h>
#include <zlib.h>

#include "base/files.h"
#include "crosscheck/outputs.h"

#include "base/banned.h"

enum { PROBE = 512 };

enum format { FORMAT_EMPTY, FORMAT_TEXT, FORMAT_DUMP, FORMAT_VTK, FORMAT_LOG, FORMAT_OTHER };

/* Format of a file, from its first bytes. */
static enum format format_of(const char *folder, const char *name)
{
	static const char *const logs[] = { "tsim ", "LIGGGHTS (", "LAMMPS (" };
	char bytes[PROBE + 1] = "";
	struct ts_str path = { 0 };
	gzFile file;
	int n;

	ts_str_addf(&path, "%s/%s", folder, name);
	file = path.failed ? NULL : ts_files_open_gz(NULL, path.text);
	ts_str_release(&path);
	n = file ? gzread(file, bytes, PROBE) : 0;
	if (file)
		gzclose(file);
	if (n == (int)strspn(bytes, " \t\r\n"))
		return n < PROBE ? FORMAT_EMPTY : FORMAT_TEXT;
	for (int k = 0; k < n; k++)
		if (!isprint((unsigned char)bytes[k]) && !isspace((unsigned char)bytes[k]) &&
		    !(bytes[k] & 0x80))
			return FORMAT_OTHER;
	for (size_t k = 0; k < sizeof logs / sizeof *logs; k++)
		if (strncmp(bytes, logs[k], strlen(logs[k])) == 0)
			return FORMAT_LOG;
	if (strncmp(bytes, "<?xml", 5) == 0)
		return FORMAT_OTHER;
	if (strncmp(bytes, "# vtk DataFile", 14) == 0)
		return strstr(bytes, "\nBINARY") ? FORMAT_OTHER : FORMAT_VTK;
	return strncmp(bytes, "ITEM:", 5) == 0 ? FORMAT_DUMP : FORMAT_TEXT;
}

/* "post/dump100.txt" -> "post/dump*.txt" */
static const char *pattern_of(const char *name, struct ts_pool *pool)
{
	const char *base = strrchr(name, '/'), *end, *begin;
	struct ts_str text = { 0 };
	const char *kept;

	base = base ? base + 1 : name;
	end = base + strlen(base);
	while (end > base && !isdigit((unsigned char)end[-1]))
		end--;
	begin = end;
	while (begin > base && isdigit((unsigned char)begin[-1]))
		begin--;
	ts_str_add_n(&text, name, (size_t)(begin - name));
	ts_str_add(&text, end > begin ? "*" : "");
	ts_str_add(&text, end);
	kept = text.failed ? NULL : ts_pool_get(pool, ts_str_text(&text));
	ts_str_release(&text);
	return kept;
}

static bool list_has(const struct ts_listing *list, const char *name)
{
	for (size_t k = 0; k < list->n; k++)
		if (list->name[k] == name)
			return true;
	return false;
}

/* Files that are not compared: logs, and the lists of frames that only tsim writes for ParaView. */
static bool is_excluded(const char *folder, const char *name)
{
	return strncmp(name, "log.", 4) == 0 || ts_ends_with(name, ".series") || ts_ends_with(name, ".pvd") ||
	       format_of(folder, name) == FORMAT_LOG;
}

static enum ts_status append_name(const char ***list, size_t *n, size_t *capacity, const char *name,
				  struct ts_error *err)
{
	if (TS_GROW(*list, *capacity, *n + 1) != TS_OK)
		return ts_nomem(err);
	(*list)[(*n)++] = name;
	return TS_OK;
}

/* Pairs all files in both folders whose pattern is that of the k-th name, if that is the first of them. */
static enum ts_status pair_files(struct ts_outputs *o, const char *const folder[TS_NPROGRAMS], size_t k,
				 enum format format, struct ts_error *err, struct ts_pool *pool)
{
	const struct ts_listing *list = &o->listing[TS_SELF];
	const char *pattern = pattern_of(list->name[k], pool), **names;
	struct ts_pairing *p;
	size_t n = 0;

	names = ts_arena_alloc(&o->arena, list->n + 1, sizeof *names);
	if (!pattern || !names)
		return ts_nomem(err);
	for (size_t m = 0; m < list->n; m++) {
		const char *name = list->name[m], *other = pattern_of(name, pool);

		if (!other)
			return ts_nomem(err);
		if (other != pattern || !list_has(&o->listing[TS_PEER], name))
			continue;
		if (m < k)
			return TS_OK; /* paired already */
		names[n++] = name;
	}
	if (TS_GROW(o->pairing, o->capacity, o->n + 1) != TS_OK)
		return ts_nomem(err);
	p = &o->pairing[o->n++];
	*p = (struct ts_pairing){ .name = n > 1 ? pattern : names[0],
				  .kind = format == FORMAT_DUMP	 ? TS_FRAMES_DUMP
					  : format == FORMAT_VTK ? TS_FRAMES_VTK
								 : TS_FRAMES_TEXT };
	for (int who = 0; who < TS_NPROGRAMS; who++) {
		p->folder[who] = folder[who];
		p->file[who] = names;
	}
	return TS_OK;
}

/* Removes from the list of tsim the files that only one program leaves empty: they cannot be compared. */
static enum ts_status remove_empty(struct ts_outputs *o, const char *const folder[TS_NPROGRAMS],
				   struct ts_error *err)
{
	struct ts_listing *list = &o->listing[TS_SELF];
	size_t kept = 0;

	for (size_t k = 0; k < list->n; k++) {
		const char *name = list->name[k];
		bool both = list_has(&o->listing[TS_PEER], name), empty[TS_NPROGRAMS];

		for (int who = 0; who < TS_NPROGRAMS; who++)
			empty[who] = both && format_of(folder[who], name) == FORMAT_EMPTY;
		for (int who = 0; who < TS_NPROGRAMS; who++)
			if (empty[who] && !empty[!who])
				TS_TRY(append_name(&o->empty[who], &o->nempty[who], &o->empty_capacity[who],
						   name, err));
		if (empty[TS_SELF] == empty[TS_PEER])
			list->name[kept++] = name;
	}
	list->n = kept;
	return TS_OK;
}

enum ts_status ts_outputs_pair(struct ts_outputs *o, const char *const folder[TS_NPROGRAMS],
			       struct ts_error *err, struct ts_pool *pool)
{
	for (int who = 0; who < TS_NPROGRAMS; who++) {
		const struct ts_listing *list = &o->listing[who];

		for (size_t k = 0; k < list->n; k++)
			if (!list_has(&o->listing[!who], list->name[k]) &&
			    !is_excluded(folder[who], list->name[k]))
				TS_TRY(append_name(&o->only[who], &o->nonly[who], &o->only_capacity[who],
						   list->name[k], err));
	}
	TS_TRY(remove_empty(o, folder, err));
	for (size_t k = 0; k < o->listing[TS_SELF].n; k++) {
		const char *name = o->listing[TS_SELF].name[k];
		enum format format = format_of(folder[TS_SELF], name);

		if (!list_has(&o->listing[TS_PEER], name) || is_excluded(folder[TS_SELF], name))
			continue;
		if (format == FORMAT_OTHER)
			TS_TRY(append_name(&o->skipped, &o->nskipped, &o->skipped_capacity, name, err));
		else
			TS_TRY(pair_files(o, folder, k, format, err, pool));
	}
	return TS_OK;
}

void ts_outputs_release(struct ts_outputs *o)
{
	for (size_t k = 0; k < o->n; k++)
		ts_compare_release(&o->pairing[k]);
	for (int who = 0; who < TS_NPROGRAMS; who++) {
		ts_free(o->listing[who].name);
		ts_free(o->only[who]);
		ts_free(o->empty[who]);
	}
	ts_free(o->pairing);
	ts_free(o->skipped);
	ts_arena_release(&o->arena);
}
