/* Lines of the log: results, warnings, settings. */
#include <string.h>

#include "report/record.h"

#include "base/banned.h"

void ts_record_line(struct ts_record *record, struct ts_record_lines *lines, const char *text)
{
	const char *kept;

	for (size_t k = 0; k < lines->n; k++)
		if (ts_streq(lines->line[k].text, text)) {
			lines->line[k].count++;
			return;
		}
	kept = lines->n < TS_RECORD_LINES ? ts_arena_strdup(&record->arena, text) : NULL;
	if (kept)
		lines->line[lines->n++] = (struct ts_record_line){ kept, 1 };
	else
		lines->more++;
}

/* Results are counted one by one: a script may print the same twice. */
static void add_result(struct ts_record *record, const char *text)
{
	struct ts_record_lines *r = &record->results;
	const char *kept = r->n < TS_RECORD_LINES ? ts_arena_strdup(&record->arena, text) : NULL;

	if (kept)
		r->line[r->n++] = (struct ts_record_line){ kept, 1 };
	else
		r->more++;
}

/* The log comes in pieces that need not be whole lines; of long lines without an end the rest is no result. */
static void add_text(struct ts_record *record, const char *text)
{
	enum { LONGEST = 4096 };
	struct ts_str *line = &record->line;

	while (*text) {
		const size_t n = strcspn(text, "\n");

		if (line->length + n < LONGEST)
			ts_str_add_n(line, text, n);
		text += n;
		if (!*text)
			return;
		text++;
		if (strncmp(ts_str_text(line), "RESULT ", 7) == 0)
			add_result(record, ts_str_text(line));
		ts_str_clear(line);
	}
}

void ts_record_log(void *data, enum ts_log_level level, const char *text)
{
	static const char MARK[] = "# ", WARNING[] = "warning: ";
	struct ts_record *record = data;

	if (level == TS_LOG_TEXT)
		add_text(record, text);
	else if (level == TS_LOG_WARNING)
		ts_record_line(record, &record->warnings,
			       strncmp(text, WARNING, sizeof WARNING - 1) == 0 ? text + sizeof WARNING - 1
									       : text);
	else if (level == TS_LOG_SETTING)
		ts_record_line(record, &record->settings,
			       strncmp(text, MARK, sizeof MARK - 1) == 0 ? text + sizeof MARK - 1 : text);
}
