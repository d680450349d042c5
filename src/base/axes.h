/* Names of the axes, of components of vectors, and of words that choose one of them. */
#ifndef TS_BASE_AXES_H
#define TS_BASE_AXES_H

extern const char *const ts_axis_names[]; /* x, y, z, NULL */

#endif
