#include "script/source.h"

#include <errno.h>
#include <string.h>

#include "base/input_limit.h"
#include "base/script_folders.h"
#include "core/sim.h"

#include "base/banned.h"

/* At the start of UTF-8 files of some editors. */
static const char byte_order_mark[] = "\xef\xbb\xbf";

static enum ts_status init_source(struct ts_source *source, struct tsim *sim, const char *name)
{
	*source = (struct ts_source){ .name = ts_pool_get(sim->pool, name) };
	return source->name ? TS_OK : ts_nomem(&sim->error);
}

/* Opens the path in the folder of the script that names it. */
static enum ts_status open_beside(struct ts_source *source, struct tsim *sim, const char *path,
				  const struct ts_place *where)
{
	struct ts_str beside = { 0 };
	enum ts_status status;

	if (!where || !where->file || !ts_files_beside(&sim->files, &beside, where->file, path))
		return TS_OK;
	if (beside.failed)
		return ts_nomem(&sim->error);
	status = init_source(source, sim, ts_str_text(&beside));
	if (status == TS_OK)
		source->stream = ts_files_open(&sim->files, source->name, "r");
	ts_str_release(&beside);
	return status;
}

enum ts_status ts_source_open(struct ts_source *source, struct tsim *sim, const char *path,
			      const struct ts_place *where)
{
	TS_TRY(init_source(source, sim, path));
	source->stream = ts_files_open(&sim->files, path, "r");
	if (!source->stream && errno == ENOENT)
		TS_TRY(open_beside(source, sim, path, where));
	source->owns_stream = true;
	if (!source->stream)
		return ts_fail(&sim->error, TS_IO, where, "cannot open script '%s': %s", path,
			       ts_files_why(&sim->files));
	return ts_files_note_script(&sim->files, source->name) ? TS_OK : ts_nomem(&sim->error);
}

enum ts_status ts_source_stream(struct ts_source *source, struct tsim *sim, FILE *stream, const char *name)
{
	TS_TRY(init_source(source, sim, name));
	source->stream = stream;
	return TS_OK;
}

enum ts_status ts_source_string(struct ts_source *source, struct tsim *sim, const char *text,
				const char *name)
{
	TS_TRY(init_source(source, sim, name));
	ts_str_add(&source->text, text);
	return source->text.failed ? ts_nomem(&sim->error) : TS_OK;
}

void ts_source_rewind(struct ts_source *source)
{
	source->at = 0;
	source->line = 0;
}

void ts_source_set_position(struct ts_source *source, size_t at, int line)
{
	source->at = at;
	source->line = line;
}

enum ts_status ts_source_add_label(struct ts_source *source, struct tsim *sim, const char *label)
{
	struct ts_source_label *new;

	if (source->nlabels && source->label[source->nlabels - 1].at >= source->at)
		return TS_OK;
	if (TS_GROW(source->label, source->label_capacity, source->nlabels + 1) != TS_OK)
		return ts_nomem(&sim->error);
	new = &source->label[source->nlabels];
	*new = (struct ts_source_label){ ts_pool_get(sim->pool, label), source->at, source->line };
	source->nlabels += new->name != NULL;
	return new->name ? TS_OK : ts_nomem(&sim->error);
}

/* All labels before the last known one are known, since lines are read or skipped in order. */
bool ts_source_seek_label(struct ts_source *source, const char *label)
{
	ts_source_rewind(source);
	for (size_t k = 0; k < source->nlabels; k++) {
		ts_source_set_position(source, source->label[k].at, source->label[k].line);
		if (ts_streq(source->label[k].name, label))
			return true;
	}
	return false;
}

void ts_source_close(struct ts_source *source)
{
	if (source->owns_stream && source->stream)
		fclose(source->stream);
	ts_str_release(&source->text);
	ts_free(source->label);
	*source = (struct ts_source){ 0 };
}

/* Reads one more line of the stream into the text. */
static enum ts_status fetch_line(struct ts_source *source, struct tsim *sim)
{
	struct ts_place place = { .file = source->name, .text = "", .line = source->line + 1 };
	size_t n = 0, most = ts_input_longest_line();
	int c = 0;

	while (c != '\n' && (c = getc(source->stream)) != EOF) {
		char byte = (char)c;

		if (!c)
			return ts_fail(&sim->error, TS_SYNTAX, &place,
				       "the script is not a text file: it has a byte 0 here");
		if (++n > most)
			return ts_fail(&sim->error, TS_RANGE, &place,
				       "the line has more than %zu bytes; if that is intended, raise the "
				       "limit by -input-limit GB, of which a line may have a thousandth",
				       most);
		ts_str_add_n(&source->text, &byte, 1);
	}
	if (source->text.failed)
		return ts_nomem(&sim->error);
	if (c == EOF && ferror(source->stream))
		return ts_fail(&sim->error, TS_IO, &place, "cannot read the script: %s", strerror(errno));
	return TS_OK;
}

enum ts_status ts_source_read_all(struct ts_source *source, struct tsim *sim)
{
	size_t n;

	do {
		n = source->text.length;
		if (source->stream)
			TS_TRY(fetch_line(source, sim));
	} while (source->text.length > n);
	return TS_OK;
}

/* Reads the next row of the file; place->text is NULL at the end. */
static enum ts_status next_row(struct ts_source *source, struct tsim *sim, struct ts_place *place)
{
	struct ts_str row = { 0 };
	size_t n;
	const char *text;

	*place = (struct ts_place){ .file = source->name };
	if (source->at == source->text.length && source->stream)
		TS_TRY(fetch_line(source, sim));
	if (source->at == source->text.length)
		return TS_OK;
	if (source->at == 0 && strncmp(source->text.text, byte_order_mark, 3) == 0)
		source->at = 3;
	text = source->text.text + source->at;
	n = strcspn(text, "\n");
	source->at += n + (text[n] == '\n');
	source->line++;
	while (n && strchr(" \t\r\f\v", text[n - 1]))
		n--;
	ts_str_add_n(&row, text, n);
	place->line = source->line;
	place->text = row.failed ? NULL : ts_pool_get(sim->pool, ts_str_text(&row));
	ts_str_release(&row);
	return place->text ? TS_OK : ts_nomem(&sim->error);
}

enum ts_status ts_source_line(struct ts_source *source, struct tsim *sim, struct ts_line *line, bool *end)
{
	bool more = true;

	ts_line_clear(line);
	while (more) {
		struct ts_place row;
		size_t n;

		TS_TRY(next_row(source, sim, &row));
		if (!row.text)
			break;
		if (ts_line_start_row(line, &row) != TS_OK)
			return ts_nomem(&sim->error);
		/* `&` at the end of a row joins rows even in a comment, but not before a comment
		 * (LIGGGHTS) */
		n = strlen(row.text);
		more = n && row.text[n - 1] == '&';
		ts_line_add(line, row.text, n - more, 1, 0);
		if (!more && ts_line_quote_open(ts_str_text(&line->text))) {
			ts_line_add(line, "\n", 1, (int)n + 1, 0);
			more = true;
		}
	}
	*end = line->rows == 0;
	return line->text.failed ? ts_nomem(&sim->error) : TS_OK;
}
