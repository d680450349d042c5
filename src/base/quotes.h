/* Quoted parts of a text, and the places of its characters. */
#ifndef TS_BASE_QUOTES_H
#define TS_BASE_QUOTES_H

#include <stddef.h>

#include "base/status.h"

/* Place of the characters at .. at+n of a text of `length` characters whose place is `whole`, possibly
 * quoted. If the text differs from the line as written (by substitution of a variable): `whole`. */
struct ts_place ts_place_inside(const struct ts_place *whole, size_t length, size_t at, size_t n);

/* If a quoted part ('..', "..", triple quotes) starts at `at`: the position behind it; else `at`. A
 * quote character without its partner is an ordinary character. */
size_t ts_quote_end(const char *text, size_t at);

#endif
