/* Arguments of `fix mesh/surface` and related fixes, and the construction of their mesh: reading the file,
 * scaling, translation and rotation in the order of the keywords, and checks of triangles. */
#ifndef TS_MESH_MESH_LOAD_H
#define TS_MESH_MESH_LOAD_H

#include "core/sim.h"
#include "mesh/mesh_surface.h"
#include "shape/shape.h"

struct ts_mesh_words {
	const char *file, *other; /* `file`, `fix` or `primitive`, exactly one; NULL: not given */
	struct ts_words primitive;
	struct ts_words scale, move, rotate; /* they act in the order of the line, see mesh_soup.h */
	struct ts_words surface_vel, surface_ang_vel, exclusion;
	struct ts_instance *region;
	double precision, curvature;
	int heal;
	bool curvature_tolerant, verbose;
};

extern const char *const ts_mesh_heal_names[];
/* `f`: the field of the state that is a struct ts_mesh_words, `s`: the one that is a struct
 * ts_mesh_surface. */
#define TS_MESH_ARGS(T, f, s)                                                                                \
	TS_WORD("file", T, f.file, .flags = TS_OPTIONAL,                                                     \
		.help = "file of triangles: STL, OBJ or legacy VTK"),                                        \
		TS_WORD("fix", T, f.other, .flags = TS_OPTIONAL,                                             \
			.help = "instead of a file: ID of a mesh with extrude_planar; the triangles "        \
				"are the faces swept by its outer edges"),                                   \
		{ .name = "primitive",                                                                       \
		  .type = TS_ARG_REST,                                                                       \
		  .flags = TS_OPTIONAL | TS_TO_KEYWORD | TS_REPEAT | TS_NAMED | TS_STATEFUL,                 \
		  .offset = TS_FIELD(T, f.primitive, struct ts_words *),                                     \
		  .inner = ts_shape_args,                                                                    \
		  .help = "SHAPE ...: instead of a file: a box, cylinder, hopper, drum, screw ... of given " \
			  "sizes, with the words of command mesh_primitive; several shapes make one mesh" }, \
		TS_INT("type", T, s.type, .range = TS_POSITIVE,                                              \
		       .help = "particle type whose material the mesh has"),                                 \
		TS_REAL("temperature", T, s.temperature, .flags = TS_OPTIONAL, .unit = "temperature",        \
			.help = "temperature of the mesh, for fix heat/gran"),                               \
		TS_SOME_KEYWORD("scale", T, f.scale, TS_REPEAT | TS_STATEFUL, .most = 1,                     \
				.help = "factor for all coordinates"),                                       \
		TS_SOME_KEYWORD("move", T, f.move, TS_REPEAT | TS_STATEFUL, .most = 3,                       \
				.help = "x y z: shift of the mesh"),                                         \
		TS_SOME_KEYWORD("rotate", T, f.rotate, TS_REPEAT | TS_STATEFUL, .most = 6,                   \
				.help = "axis ax ay az angle degrees: rotation about an axis "               \
					"through the origin. scale, move and rotate act in the "             \
					"order of the line, and may be repeated"),                           \
		TS_REGION("region", T, f.region, .flags = TS_OPTIONAL,                                       \
			  .help = "only triangles whose corners, as in the file, are in this region"),       \
		TS_SOME_KEYWORD("element_exclusion_list", T, f.exclusion, 0,                                 \
				.help = "read FILE: leaves out the triangles at the lines of the mesh "      \
					"file that FILE lists; write FILE: writes such a list of "           \
					"refused triangles"),                                                \
		TS_REAL("precision", T, f.precision, .flags = TS_OPTIONAL, .range = TS_POSITIVE,             \
			.unit = "length",                                                                    \
			.help = "corners nearer to each other than this are the same; default: 1e-7 "        \
				"times the longest side of the bounding box of the mesh"),                   \
		TS_REAL("curvature", T, f.curvature, .fallback = "0.256235", .range = TS_WITHIN, .lo = 0,    \
			.hi = 90, .unit = "degrees",                                                         \
			.help = "neighbours whose planes include a smaller angle are one flat surface"),     \
		TS_REAL("extrude_planar", T, s.extrusion, .flags = TS_OPTIONAL, .range = TS_POSITIVE,        \
			.unit = "length",                                                                    \
			.help = "of a planar mesh: length by which its outer edges are extruded, against "   \
				"the normal, by another mesh with `fix ID` of this one"),                    \
		TS_BOOL("curvature_tolerant", T, f.curvature_tolerant, .fallback = "no",                     \
			.help = "whether triangles may have angles smaller than curvature"),                 \
		TS_ENUM("heal", T, f.heal, ts_mesh_heal_names, .fallback = "no",                             \
			.help = "whether duplicate triangles are left out, or refused"),                     \
		TS_BOOL("verbose", T, f.verbose, .fallback = "no",                                           \
			.help = "whether each faulty triangle is reported, not only their number"),          \
		TS_SOME_KEYWORD("surface_vel", T, f.surface_vel, 0,                                          \
				.help = "vx vy vz: velocity of the surface, as of a conveyor belt, in the "  \
					"plane of each triangle; the mesh stays in place"),                  \
		TS_SOME_KEYWORD("surface_ang_vel", T, f.surface_ang_vel, 0,                                  \
				.help = "origin ox oy oz axis ax ay az omega om: rotation of the surface "   \
					"about an axis, om in radian/time; the mesh stays in place")

/* To be called in init of each style of TS_FAMILY_MESH; its other slots are in mesh/mesh_style.h. The
 * first call reads and builds the mesh and sets the velocity of the surface. */
enum ts_status ts_mesh_surface_init(struct ts_instance *self, struct tsim *sim,
				    const struct ts_mesh_words *words);

/* Order of TS_MESH_ARGS in the manual pages. */
#define TS_MESH_GROUPS                                                                               \
	{ NULL, "file primitive type scale move rotate" },                                           \
		{ "Motion of the surface in its own plane", "surface_vel surface_ang_vel" },         \
		{ "Heat", "temperature" },                                                           \
		{ "Parts of a mesh, and meshes made from another", "region fix extrude_planar" },    \
	{                                                                                            \
		"Faults of the file, edges",                                                         \
			"precision curvature curvature_tolerant heal element_exclusion_list verbose" \
	}

#endif
