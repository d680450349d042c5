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

static const struct ts_arg_group groups[] = {
	TS_MESH_GROUPS,
	{ .words = NULL },
};

TS_STYLE(fix, ts_style, ts_fix_mesh_surface)
const struct ts_style ts_fix_mesh_surface = {
	.name = "mesh/surface",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_OWN | TS_RANKS_OUTPUTS | TS_RANKS_ROWLESS,
	.summary = "A surface of triangles from a file or of given sizes, for walls and insertion faces",
	.purpose = "The geometry of a machine: from a file of a drawing program, or by its sizes. It has an "
		   "effect on grains by `fix wall/gran ... mesh`, and moves by fix move/mesh.",
	.doc = "Reads triangles from a file, or makes those of a shape of given sizes (`primitive`: box, "
	       "plate, disk, cylinder, tube, cone, hopper, wedge, drum, sphere, screw ..., see command "
	       "mesh_primitive), scales, moves and rotates them in the order of the keywords, and determines "
	       "which of them share corners and edges. A mesh alone has no effect on particles: `fix "
	       "wall/gran mesh` makes a wall of it, `fix move/mesh` moves it. Normals in the file are "
	       "ignored; they follow from the order of the corners by the right-hand rule.\n\n"
	       "Particles must not feel the edges between triangles where the surface is flat, and must have "
	       "one contact with each edge or corner elsewhere. Triangles that share corners and whose "
	       "planes include an angle less than `curvature` are one flat surface: the edge between them is "
	       "not active, and the history of a contact is transferred from one triangle to the other. Any "
	       "other edge is active in the last of the triangles that share it, any corner in the last of "
	       "the triangles around it; a corner is not active if no edge there is, or if two of its edges "
	       "are collinear. As in LIGGGHTS a particle on one triangle that also touches an edge which is "
	       "active in another triangle has two contacts: within sqrt(2 R delta) of a convex edge the "
	       "force is up to twice that of the plane (not with model jkr). Where triangles of a curved "
	       "surface are smaller than that and not flat to `curvature`, the particle touches many of "
	       "them: the force is several times that of one contact, and restitution is too low. A warning "
	       "tells where it is more than twice; larger triangles help, or a `curvature` above the angle "
	       "between two of them. Beside a node between two collinear edges of a rim it touches both.\n\n"
	       "The centre of each triangle must be in the box, unless the face of the box is periodic or "
	       "follows the mesh (`boundary m m m`). Across periodic faces particles interact with the "
	       "periodic images of the triangles, also of a mesh that moves far out of the box.\n\n"
	       "With surface_vel or surface_ang_vel the surface moves in its own plane like a conveyor belt "
	       "while the mesh stays in place: in each triangle the velocity is projected onto its plane and "
	       "scaled to its original magnitude.\n\n"
	       "`extrude_planar L` of a planar mesh and `fix ID` of another mesh make a rim: the faces that "
	       "the outer edges sweep when they are translated by L against the normal, two triangles for "
	       "each edge.\n\n"
	       "Related: mesh_primitive, fix wall/gran, fix move/mesh, fix mesh/surface/stress, fix "
	       "mesh/surface/planar, fix insert/stream, fix massflow/mesh, dump mesh/vtk.",
	.example = "fix cad all mesh/surface file hopper.stl type 1 scale 0.001 move 0 0 -0.1\n"
		   "fix mill all mesh/surface primitive drum radius 0.15 length 0.3 lifters 8 axis 0 1 0 "
		   "type 1\n"
		   "fix belt all mesh/surface file belt.stl type 2 rotate axis 1 0 0 angle 12.5 surface_vel "
		   "0.3 0 0\n"
		   "fix bottom all mesh/surface file disc.stl type 1 extrude_planar 0.1\n"
		   "fix rim all mesh/surface fix bottom type 1",
	.args = args,
	.groups = groups,
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
