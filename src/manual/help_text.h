/* Text of manual pages: headings, wrapped lines, items of lists, paragraphs; for the terminal or as Markdown. */
#ifndef TS_MANUAL_HELP_TEXT_H
#define TS_MANUAL_HELP_TEXT_H

#include <stdbool.h>
#include <stddef.h>

#include "base/str.h"

/* A heading of a part of a page, and one of a group within a part. */
void ts_help_heading(const char *text, bool markdown, struct ts_str *out);
void ts_help_subheading(const char *text, bool markdown, struct ts_str *out);
/* The text in lines of at most 78 characters, indented by `indent` blanks, and by `more` further ones after
 * the first line. A single line end is a blank, two separate paragraphs. */
void ts_help_wrapped(const char *text, size_t indent, size_t more, struct ts_str *out);
/* An item of a list of arguments or outputs: a name and its description. */
void ts_help_entry(const struct ts_str *name, const struct ts_str *text, size_t depth, bool markdown,
		   struct ts_str *out);
/* An item of other lists: in the terminal the name and the text in columns. */
void ts_help_item(const char *name, const char *text, bool markdown, struct ts_str *out);
/* The lines of the text, indented; as a block of script lines. */
void ts_help_lines(const char *text, const char *indent, struct ts_str *out);
void ts_help_block(const char *text, bool markdown, struct ts_str *out);
/* Paragraphs are separated by empty lines; lines that begin with two blanks are preformatted. */
void ts_help_paragraphs(const char *text, bool markdown, struct ts_str *out);

#endif
