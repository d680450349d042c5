/* Formats for numbers given by users: checked before they reach printf. */
#ifndef TS_IO_FORMAT_H
#define TS_IO_FORMAT_H

#include <stdbool.h>

#include "base/words.h"

enum { TS_FORMAT_SIZE = 32 };

/* "%14.8g" or, for integers, "%8d": text with exactly one conversion of that kind. Integers are
 * turned into the conversion of a long long. false: not such a format. */
bool ts_format_check(const char *format, bool integer, char out[TS_FORMAT_SIZE]);
/* Adds the number; `format` comes from ts_format_check. */
void ts_format_add(struct ts_str *out, const char *format, bool integer, double value);

/* What the words `format` of thermo_modify and dump_modify say. Zero-initialise. */
struct ts_formats {
	char real[TS_FORMAT_SIZE], whole[TS_FORMAT_SIZE]; /* as given; "" : not */
	struct ts_words line;				  /* one for each column */
	struct ts_words column;				  /* pairs: number from 1, format */
};
/* Words in pairs: float F, int F, line "F F ..." or only "F F ...", N F; or none, which forgets all. They
 * are kept in the arena. Earlier ones stay where they are not replaced. */
enum ts_status ts_formats_change(struct ts_formats *formats, struct ts_error *err, struct ts_arena *arena,
				 const char *what, struct ts_words words, size_t columns);
/* The format of column k of n, counted from 0: the one for the column, for the kind, of the line, or
 * the fallback. */
enum ts_status ts_formats_choose(const struct ts_formats *formats, struct ts_error *err, size_t k,
				 bool integer, const char *fallback, char out[TS_FORMAT_SIZE]);

#endif
