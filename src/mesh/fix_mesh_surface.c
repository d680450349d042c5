/* Fix mesh/surface: a surface of triangles. */
#include "mesh/mesh_load.h"
#include "mesh/mesh_style.h"

#include "base/banned.h"

struct state {
	struct ts_mesh_surface surface;
	struct ts_mesh_words words;
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	return ts_mesh_surface_init(self, sim, &((struct state *)self->state)->words);
}

static const struct ts_arg args[] = {
	TS_MESH_ARGS(struct state, words, surface),
	TS_ARGS_END,
};

TS_STYLE(fix, ts_style, ts_fix_mesh_surface)
const struct ts_style ts_fix_mesh_surface = {
	.name = "mesh/surface",
	.kind = TS_KIND_FIX,
	.summary = "A surface of triangles from a file, for walls and insertion faces",
	.doc = "Reads triangles, scales, moves and turns them in the order of the words, and finds out how "
	       "they\n"
	       "hang together. By itself a mesh does nothing: `fix wall/gran mesh` makes a wall of it, `fix\n"
	       "move/mesh` moves it. Normals in the file are not used; they follow from the order of "
	       "corners.\n\n"
	       "Where a surface is flat, particles must not feel that it is made of triangles, and an edge "
	       "or\n"
	       "corner they must feel once. Triangles that share corners and whose planes include less than\n"
	       "`curvature` are one flat surface: the edge between them does not count, and what a contact\n"
	       "remembers goes along from one to the other. Any other edge belongs to the last of the "
	       "triangles\n"
	       "that share it, any corner to the last of those around it; a corner does not count if no "
	       "edge\n"
	       "there does, or if two edges go straight on through it. As in LIGGGHTS a particle on one "
	       "triangle\n"
	       "that also touches such an edge, which belongs to the other triangle, has two contacts: "
	       "within\n"
	       "sqrt(2 R delta) of a convex edge the force is up to twice that of the plane (not with model "
	       "jkr).\n\n"
	       "The centre of each triangle must be in the box, unless the face of the box is periodic or "
	       "moves\n"
	       "(`boundary m m m`), in which case it makes room for the mesh. Across periodic faces "
	       "particles meet\n"
	       "the images of the triangles.\n\n"
	       "With surface_vel or surface_ang_vel the surface moves in itself like a conveyor belt: the "
	       "velocity\n"
	       "is turned into the plane of each triangle, and keeps its magnitude.\n\n"
	       "`extrude_planar L` of a plane mesh and `fix ID` of another make a rim: the faces that the "
	       "outer\n"
	       "edges sweep when they are moved by L against the normal, two triangles for each edge.",
	.example = "fix cad all mesh/surface file hopper.stl type 1 scale 0.001 move 0 0 -0.1\n"
		   "fix belt all mesh/surface file belt.stl type 2 rotate axis 1 0 0 angle 12.5 surface_vel "
		   "0.3 0 0\n"
		   "fix bottom all mesh/surface file disc.stl type 1 extrude_planar 0.1\n"
		   "fix rim all mesh/surface fix bottom type 1",
	.args = args,
	.family = TS_FAMILY_MESH,
	.state_size = sizeof(struct state),
	.archive = ts_mesh_surface_archive,
	.fingerprint = ts_mesh_surface_fingerprint,
	.extent = ts_mesh_surface_extent,
	.init = init,
	.hook = { [TS_STAGE_POST_BUILD] = ts_mesh_surface_post_build },
	.plan = ts_mesh_surface_plan,
	.fini = ts_mesh_surface_fini,
};
