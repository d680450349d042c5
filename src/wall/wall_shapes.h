/* All shapes of walls. */
#ifndef TS_WALL_WALL_SHAPES_H
#define TS_WALL_WALL_SHAPES_H

#include "wall/wall_shape.h"

extern const struct ts_wall_shape *const ts_wall_shapes[]; /* ends with NULL */

#endif
