#include "wall/wall_shapes.h"

#include "wall/mesh_wall.h"
#include "wall/primitive_wall.h"
#include "wall/region_wall.h"
#include "wall/voxel_wall.h"

#include "base/banned.h"

const struct ts_wall_shape *const ts_wall_shapes[] = {
	&ts_primitive_wall_shape, &ts_mesh_wall_shape, &ts_voxel_wall_shape, &ts_region_wall_shape, NULL,
};
