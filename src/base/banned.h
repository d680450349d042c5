/* Include last in every .c file: calls that have no bound, no error return, or hide input errors
 * do not compile. Numbers are read with ts_parse_real and ts_parse_int (base/str.h). */
#ifndef TS_BASE_BANNED_H
#define TS_BASE_BANNED_H
#pragma GCC poison strcpy strcat sprintf vsprintf strncpy strncat strtok gets atoi atol atof
#endif
