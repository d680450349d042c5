/* The tables of styles, systems and checks of tsim. */
#ifndef TS_LIBRARY_TSIM_TABLES_H
#define TS_LIBRARY_TSIM_TABLES_H

#include "core/tables.h"

/* Generated (library/style_table.c) from the TS_STYLE marks; sorted by kind, then name; NULL-terminated. */
extern const struct ts_style *const ts_style_table[];
extern const struct ts_tables ts_tables;

#endif
