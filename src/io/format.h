/* Formats of numbers given by users, checked before they are passed to printf. */
#ifndef TS_IO_FORMAT_H
#define TS_IO_FORMAT_H

#include <stdbool.h>

#include "base/words.h"

enum { TS_FORMAT_SIZE = 32 };

/* Checks for a text with exactly one conversion: of a real number such as "%14.8g", or of an integer such
 * as "%8d", which is changed to that of a long long. false: not such a format. */
bool ts_format_check(const char *format, bool integer, char out[TS_FORMAT_SIZE]);
/* Adds the number; `format` comes from ts_format_check. */
void ts_format_add(struct ts_str *out, const char *format, bool integer, double value);

/* Adds the text; `format` comes from ts_formats_choose_text. */
void ts_format_add_text(struct ts_str *out, const char *format, const char *text);

/* Settings of the keyword `format` of thermo_modify and dump_modify. Zero-initialise. */
struct ts_formats {
	char real[TS_FORMAT_SIZE], whole[TS_FORMAT_SIZE]; /* float, int; "": not given */
	struct ts_words line;				  /* one format for each column */
	struct ts_words column;				  /* pairs: column number from 1, format */
};
/* Changes the settings by pairs of words: float F, int F, line "F F ..." or only "F F ...", N F; or none,
 * which removes all. Other settings are kept. Texts are stored in the arena. */
enum ts_status ts_formats_change(struct ts_formats *formats, struct ts_error *err, struct ts_arena *arena,
				 const char *what, struct ts_words words, size_t columns);
/* Format of column k, counted from 0: in this order that of the column, of float or int, of the line, or the
 * fallback. */
enum ts_status ts_formats_choose(const struct ts_formats *formats, struct ts_error *err, size_t k,
				 bool integer, const char *fallback, char out[TS_FORMAT_SIZE]);
/* The same for a column of names: %s, or with a width. */
enum ts_status ts_formats_choose_text(const struct ts_formats *formats, struct ts_error *err, size_t k,
				      char out[TS_FORMAT_SIZE]);

#endif
