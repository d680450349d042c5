/* Manual pages, generated from the tables of the styles. */
#ifndef TS_MANUAL_HELP_H
#define TS_MANUAL_HELP_H

#include <stdbool.h>

#include "base/str.h"
#include "core/tables.h"

/* Appends the page of a style, for the terminal or as Markdown. */
void ts_help_page(const struct ts_style *style, bool markdown, struct ts_str *out);
/* Appends a line for each style of the kind; in Markdown with links to the pages. */
void ts_help_list(const struct ts_tables *tables, enum ts_kind kind, bool markdown, struct ts_str *out);
/* "fix_drag_ergun.md" */
void ts_help_file_name(const struct ts_style *style, struct ts_str *out);

#endif
