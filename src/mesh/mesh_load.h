/* Arguments of `fix mesh/surface` and related fixes, and the construction of their mesh: reading the file,
 * scaling, translation and rotation in the order of the keywords, and checks of triangles. */
#ifndef TS_MESH_MESH_LOAD_H
#define TS_MESH_MESH_LOAD_H

#include "core/sim.h"
#include "mesh/mesh_surface.h"

struct ts_mesh_words {
	const char *file, *other;	     /* `file` or `fix`, exactly one; NULL: not given */
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
#define TS_MESH_ARGS(T, f, s)                                                                             \
	TS_WORD("file", T, f.file, .flags = TS_OPTIONAL,                                                  \
		.help = "file of triangles: STL, OBJ or legacy VTK"),                                     \
		TS_WORD("fix", T, f.other, .flags = TS_OPTIONAL,                                          \
			.help = "instead of a file: a mesh with extrude_planar, whose outer "             \
				"edges moved by that length make the triangles"),                         \
		TS_INT("type", T, s.type, .range = TS_POSITIVE,                                           \
		       .help = "particle type whose material the mesh has"),                              \
		TS_REAL("temperature", T, s.temperature, .flags = TS_OPTIONAL, .unit = "temperature",     \
			.help = "of the mesh, for fix heat/gran"),                                        \
		TS_SOME_KEYWORD("scale", T, f.scale, TS_REPEAT | TS_STATEFUL,                             \
				.help = "factor for all coordinates"),                                    \
		TS_SOME_KEYWORD("move", T, f.move, TS_REPEAT | TS_STATEFUL,                               \
				.help = "x y z: shifts the mesh"),                                        \
		TS_SOME_KEYWORD("rotate", T, f.rotate, TS_REPEAT | TS_STATEFUL,                           \
				.help = "axis ax ay az angle degrees: turns it about an axis "            \
					"through the origin. scale, move and rotate act in the "          \
					"order they are written, and may be given again"),                \
		TS_REGION("region", T, f.region, .flags = TS_OPTIONAL,                                    \
			  .help = "takes only triangles whose corners, as the file has them, are in it"), \
		TS_SOME_KEYWORD("element_exclusion_list", T, f.exclusion, 0,                              \
				.help = "read FILE: does without the triangles that stand in the "        \
					"lines of the mesh file which FILE lists; write FILE: "           \
					"makes such a list of those that are refused"),                   \
		TS_REAL("precision", T, f.precision, .flags = TS_OPTIONAL, .range = TS_POSITIVE,          \
			.unit = "length",                                                                 \
			.help = "corners nearer than this are the same; without it a 1e-7th of "          \
				"the longest side of the box around the mesh"),                           \
		TS_REAL("curvature", T, f.curvature, .fallback = "0.256235", .range = TS_WITHIN, .lo = 0, \
			.hi = 90, .unit = "degrees",                                                      \
			.help = "triangles whose planes include less than this are one flat surface"),    \
		TS_REAL("extrude_planar", T, s.extrusion, .flags = TS_OPTIONAL, .range = TS_POSITIVE,     \
			.unit = "length",                                                                 \
			.help = "of a plane mesh: how far its outer edges are moved, against the "        \
				"normal, for another mesh that says `fix ID` of this one"),               \
		TS_BOOL("curvature_tolerant", T, f.curvature_tolerant, .fallback = "no",                  \
			.help = "whether curvature may be larger than an angle of a triangle"),           \
		TS_ENUM("heal", T, f.heal, ts_mesh_heal_names, .fallback = "no",                          \
			.help = "whether triangles given twice are dropped, or refused"),                 \
		TS_BOOL("verbose", T, f.verbose, .fallback = "no",                                        \
			.help = "tells of each questionable triangle, not only how many"),                \
		TS_SOME_KEYWORD("surface_vel", T, f.surface_vel, 0,                                       \
				.help = "vx vy vz: the surface moves like a conveyor belt, in the "       \
					"plane of each triangle; the mesh stays"),                        \
		TS_SOME_KEYWORD("surface_ang_vel", T, f.surface_ang_vel, 0,                               \
				.help = "origin ox oy oz axis ax ay az omega om: the surface "            \
					"turns about an axis, om in radian/time; the mesh stays")

/* To be called in init of each style of TS_FAMILY_MESH; its other slots are in mesh/mesh_style.h. The
 * first call reads and builds the mesh and sets the velocity of the surface. */
enum ts_status ts_mesh_surface_init(struct ts_instance *self, struct tsim *sim,
				    const struct ts_mesh_words *words);

#endif
