/* Grammar files for the syntax highlighting of editors, generated from the tables. */
#ifndef TS_MANUAL_GRAMMAR_H
#define TS_MANUAL_GRAMMAR_H

#include "base/str.h"
#include "core/tables.h"

void ts_grammar_vim(const struct ts_tables *tables, struct ts_str *out);
void ts_grammar_textmate(const struct ts_tables *tables, struct ts_str *out);

#endif
