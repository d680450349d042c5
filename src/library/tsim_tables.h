/* What tsim is made of: its styles, systems and checks. */
#ifndef TS_LIBRARY_TSIM_TABLES_H
#define TS_LIBRARY_TSIM_TABLES_H

#include "core/tables.h"

/* Generated (library/style_table.c) from the marks TS_STYLE; sorted by kind, then name; closed by NULL. */
extern const struct ts_style *const ts_style_table[];
extern const struct ts_tables ts_tables;

#endif
