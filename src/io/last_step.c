#include "io/last_step.h"

#include <ctype.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/files.h"

#include "base/banned.h"

/* Bytes at the end of a file in which its last step is looked for, one after the other: frames may be long. */
static const int64_t tails[] = { 1 << 16, 1 << 20, 1 << 24, 1 << 28 };

/* The whole number that the line begins with, behind blanks; -1: none. */
static int64_t number_of(const char *line)
{
	char *end;
	long long number;

	line += strspn(line, " \t");
	if (!isdigit((unsigned char)line[0]))
		return -1;
	number = strtoll(line, &end, 10);
	return strchr(" \t\r\n,", *end) ? number : -1; /* or the end of the text */
}

/* The step of a frame that begins at this line or in it. */
static int64_t frame_of(const char *line, const char *next)
{
	static const char item[] = "ITEM: TIMESTEP", xyz[] = "Atoms. Timestep: ";

	if (strncmp(line, item, sizeof item - 1) == 0)
		return number_of(next);
	return strncmp(line, xyz, sizeof xyz - 1) == 0 ? number_of(line + sizeof xyz - 1) : -1;
}

/* The last step in a text; its first line may be a part of one. */
static int64_t find_in(const char *text, enum ts_step_form form)
{
	int64_t last = -1, before = -1;
	const char *line = strchr(text, '\n');

	for (const char *next; line && *++line; line = next) {
		int64_t number = number_of(line), found = number;

		next = strchr(line, '\n');
		if (form == TS_STEP_FRAMES)
			found = frame_of(line, next ? next + 1 : "");
		else if (form == TS_STEP_BLOCKS)
			found = number == 1 ? before : -1;
		before = number;
		last = found >= 0 ? found : last;
	}
	return last;
}

/* The last `size` bytes behind a line feed, as a text; NULL: not to be had. */
static char *read_tail(FILE *in, int64_t whole, int64_t size)
{
	char *text = ts_alloc_unset((size_t)size + 2, 1);
	size_t got;

	if (!text)
		return NULL;
	text[0] = '\n';
	got = fseek(in, (long)(whole - size), SEEK_SET) == 0
		      ? fread(text + (size == whole), 1, (size_t)size, in)
		      : 0;
	text[got + (size == whole)] = '\0';
	return text;
}

static int64_t find_last(const struct ts_textfile *file, enum ts_step_form form)
{
	FILE *in = ts_files_open(file->files, file->path, "r");
	int64_t last = -1, size = 0;

	for (size_t k = 0; in && last < 0 && size < file->whole && k < sizeof tails / sizeof *tails; k++) {
		char *text;

		size = tails[k] < file->whole ? tails[k] : file->whole;
		text = read_tail(in, file->whole, size);
		last = text ? find_in(text, form) : -1;
		ts_free(text);
	}
	if (in)
		fclose(in);
	return last;
}

bool ts_last_step_begins(const char *line, int64_t step)
{
	return number_of(line) == step;
}

void ts_last_step_warn(const struct ts_textfile *file, struct tsim *sim, enum ts_step_form form,
		       int64_t first)
{
	int64_t last;

	if (!sim->continued || file->gz || file->whole <= 0)
		return;
	last = find_last(file, form);
	if (last >= first)
		ts_warn(&sim->log, &file->where,
			"'%s' has %s up to step %" PRId64 " already, as of a run that went on behind its "
			"restart file: those from step %" PRId64 " on will be there twice",
			file->path, form == TS_STEP_FRAMES ? "frames" : "rows", last, first);
}
