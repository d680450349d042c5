/* Include last in every .c file: functions without bounds or error returns, or that hide input errors,
 * do not compile. Numbers are parsed by ts_parse_real and ts_parse_int (base/str.h), arrays are sorted by
 * ts_sort (base/sort.h). */
#ifndef TS_BASE_BANNED_H
#define TS_BASE_BANNED_H
#pragma GCC poison strcpy strcat sprintf vsprintf strncpy strncat strtok gets atoi atol atof qsort
#endif
