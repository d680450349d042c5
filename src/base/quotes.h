/* Quoted stretches of a text, and the places of its characters. */
#ifndef TS_BASE_QUOTES_H
#define TS_BASE_QUOTES_H

#include <stddef.h>

#include "base/status.h"

/* The place of the characters at..at+n of a text of `length` characters that stands at `whole`,
 * perhaps in quotes. If the text there is not what was written (a variable was put in): whole. */
struct ts_place ts_place_inside(const struct ts_place *whole, size_t length, size_t at, size_t n);

/* If a quoted stretch ('..', "..", triple) starts at `at`: the position behind it; else `at`. A
 * quote character without partner is an ordinary one. */
size_t ts_quote_end(const char *text, size_t at);

#endif
