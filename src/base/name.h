/* Names of variables, computes and fixes: letters, digits and _, in any locale. */
#ifndef TS_BASE_NAME_H
#define TS_BASE_NAME_H

#include <stdbool.h>
#include <stddef.h>

static inline bool ts_in_name(char c)
{
	return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

/* Letters of the name with which the text begins; 0: it begins with none. */
static inline size_t ts_name_length(const char *text)
{
	size_t n = 0;

	while (ts_in_name(text[n]))
		n++;
	return n;
}

#endif
