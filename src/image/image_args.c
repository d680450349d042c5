/* Arguments, saved state and common text of dumps image and movie. */
#include "image/image.h"
#include "io/movie.h"

#include "base/banned.h"

#define WORDS(name, f, ...) TS_SOME_KEYWORD(name, struct ts_image, f, 0, .help = __VA_ARGS__)
#define PART(name_, f, help_)                                                              \
	{                                                                                  \
		.name = name_, .type = TS_ARG_REST,                                        \
		.flags = TS_OPTIONAL | TS_TO_KEYWORD | TS_REPEAT | TS_NAMED,               \
		.offset = TS_FIELD(struct ts_image, f, struct ts_words *), .help = (help_) \
	}
const struct ts_arg ts_image_args[] = {
	TS_INT("every", struct ts_image, common.every, .flags = TS_POSITIONAL, .range = TS_POSITIVE,
	       .help = "steps between frames"),
	TS_WORD("file", struct ts_image, common.file, .flags = TS_POSITIONAL | TS_WRITES,
		.help = "image: name that ends in .png or .ppm, with a `*` for the step; movie: name that "
			"ends in " TS_MOVIE_ENDINGS),
	TS_WORD("color", struct ts_image, quantity[0], .flags = TS_POSITIONAL,
		.help = "color of the particles: type, element, or any quantity of them (vx, c_ID, f_ID, "
			"v_NAME ...)"),
	TS_WORD("diameter", struct ts_image, quantity[1], .flags = TS_POSITIONAL,
		.help = "diameter of the spheres: type, element, or any quantity; `diameter` is their own"),
	TS_BOOL("atom", struct ts_image, atoms, .fallback = "yes", .help = "whether particles are drawn"),
	TS_REAL("adiam", struct ts_image, adiam, .flags = TS_OPTIONAL, .range = TS_POSITIVE, .unit = "length",
		.help = "one diameter for all spheres, in place of DIAMETER"),
	WORDS("bond", bond_words, "COLOR WIDTH of bonds (none none)", .least = 2),
	PART("mesh", surface_words,
	     "ID|all [color C] [trans T] [value f_ID[k]|NAME] [smooth A]: triangle meshes; trans from 0, "
	     "invisible, to "
	     "1, opaque; edges of less than A degrees are shaded as curved (silver, 1, 0)"),
	PART("voxel", surface_words,
	     "ID|all [color C] [trans T] [value f_ID[k]|c_ID[k]|height]: height fields (tan, 1)"),
	PART("wall", surface_words,
	     "ID|all [color C] [trans T] [value f_ID[k]]: planes and cylinders of fix wall/gran within the "
	     "box (lightsteelblue, 0.3)"),
	PART("region", region_words,
	     "ID COLOR filled|transparent OPACITY: the surface of a region, as far as it is in the box "
	     "(opacity 0.5)"),
	PART("clip", clip_words,
	     "x|y|z POSITION above|below: removes what is above or below that coordinate; particles, bonds "
	     "and contacts are cut through"),
	PART("slice", slice_words,
	     "x|y|z POSITION QUANTITY [trans T] [body C] [arrows SPACING] [streams SPACING] [length L|factor "
	     "F] [width W] [color C]: field of the fluid in a plane (QUANTITY speed, vx, vy, vz, p, void, "
	     "wx, wy, wz, vorticity, f_ID or none), arrows of its velocity, streamlines (1, gray, no arrows, "
	     "length SPACING, black)"),
	PART("film", film_words,
	     "p|gap|void [height Z] [relief F] [trans T]: the film of flow_style reynolds at z = Z + F gap, "
	     "colored by its "
	     "pressure, gap or void fraction (0, 0, 1)"),
	PART("arrow", arrow_words,
	     "VX VY VZ [length L|factor F] [width W] [color C]: arrows of a vector of the particles (length "
	     "4 diameters, color atom: that of the particle)"),
	PART("contact", contact_words,
	     "ID [width W|factor F] [color C]: rods of the contacts of a compute pair/gran/local or "
	     "wall/gran/local, as wide as their force is large (half of the mean diameter, force: by cmap)"),
	WORDS("size", size_words, "width and height in pixels (512 512)"),
	WORDS("view", view_words,
	      "THETA PHI: direction of the camera, its angle from the z axis and that around it from the x "
	      "axis, degrees or variables (60 30; in two dimensions 0 0)"),
	WORDS("center", center_words,
	      "s|d Cx Cy Cz: point in the middle of the picture, as fractions of the box at the definition "
	      "(s) or of the frame (d); numbers or variables (s 0.5 0.5 0.5)"),
	WORDS("up", up_words,
	      "Ux Uy Uz: direction that is upwards in the picture; numbers or variables (0 0 1; in two "
	      "dimensions 0 1 0)"),
	TS_NUMBER("zoom", struct ts_image, zoom, .range = TS_POSITIVE, .fallback = "1",
		  .help = "magnification; number or variable"),
	TS_REAL("persp", struct ts_image, persp, .range = TS_NOT_NEGATIVE, .fallback = "0",
		.help = "0: the projection is parallel"),
	WORDS("box", box_words,
	      "yes|no DIAM: edges of the simulation box, their diameter as a fraction of its shortest length "
	      "(yes 0.02)"),
	WORDS("axes", axes_words,
	      "no|yes|lowerleft|center LENGTH DIAM: axes x red, y green, z blue, as fractions of the lengths "
	      "of the box (no)"),
	WORDS("subbox", subbox_words, "yes|no DIAM: as `box`, not blocks of ranks (no)"),
	TS_REAL("shiny", struct ts_image, shiny, .range = TS_FRACTION, .fallback = "1",
		.help = "0: dull surfaces, 1: highlights"),
	TS_REAL("depthcue", struct ts_image, depthcue, .range = TS_FRACTION, .fallback = "0",
		.help = "part of the background in the color of the farthest surface; the nearest has none"),
	TS_BOOL("fsaa", struct ts_image, fsaa, .fallback = "no",
		.help = "whether edges are smoothed: four samples per pixel"),
	WORDS("ssao", ssao_words,
	      "yes|no SEED DFACTOR: darkens crevices, with strength DFACTOR from 0 to 1 (no)"),
	WORDS("legend", legend_words,
	      "yes|no TITLE TITLE2: bars of the color maps with numbers, the first one at the right, the "
	      "second at the left; the titles are their names by default (no)"),
	TS_ARGS_END,
};

const struct ts_saved ts_image_saved[] = {
	TS_SAVE_I64(struct ts_image, common.last),
	TS_SAVE_I64(struct ts_image, common.frames),
	TS_SAVE_F64(struct ts_image, first_box),
	TS_SAVE_U8(struct ts_image, placed),
	TS_SAVED_ROWS_END,
};

const char *const ts_image_text[] = {
	"Color `type`: types have the colors red, forestgreen, blue, gold, cyan, magenta, silver, orange, "
	"lime, gray, darkred, darkgreen, darkblue, darkcyan, darkmagenta, darkgray, again after the "
	"sixteenth, or those of dump_modify acolor. `element`: types with the same name in dump_modify "
	"element have one color. Another quantity goes through the map of dump_modify amap, by default from "
	"blue at the least to red at the largest value of the frame. Values that are no numbers (NaN) are "
	"drawn in magenta, with a warning.",
	"Diameter `type` or `element`: that of dump_modify adiam; types without one have the diameter of "
	"each particle (LAMMPS: 1.0). Any other quantity is the diameter itself: `diameter` draws particles "
	"at their size, `radius` at half of it. Particles whose diameter is not positive are not drawn.",
	"Bonds are drawn if both partners are, as two halves from each partner towards the nearest image of "
	"the other: a bond across a periodic face appears at both faces. Color `atom`: each half has that of "
	"its partner; `type`: dump_modify bcolor; `strain`: length / rest length - 1; c_ID[k]: a compute "
	"such as bond/local with a row for each bond; numbers go through dump_modify bmap. Width `atom`: the "
	"lesser diameter of the partners; `type`: dump_modify bdiam, else half of the lesser diameter.",
	"Surfaces: `mesh`, `voxel` and `wall` may be given several times. With `value` the color of each "
	"triangle, column or wall is that of its number in the map of dump_modify smap, whose range min and "
	"max is that of each surface: an output with a row for each element (fix wear/finnie, fix "
	"surface/heat, compute surface/contact ...), or what the surface has: of meshes the quantities of "
	"dump mesh/vtk (stress: normal, shear_stress_average, stresscomponents: the size of the vector, "
	"wear, vel: the speed, temp, area ...), of height fields height. A mesh that moves is drawn where it "
	"is, removed triangles are not drawn. Of height fields with more than 262144 columns blocks of "
	"columns are drawn, with the height of their highest.",
	"The projection is parallel. The directions of the lights, the default view and the scale at zoom 1 "
	"(the height of the picture is twice the longest edge of the box) are those of LAMMPS. Particles are "
	"drawn at their wrapped positions. The picture is the same for any number of threads and after a "
	"restart. If variables give a view that does not exist (zoom <= 0), the picture is left out with a "
	"warning.",
	NULL,
};

const struct ts_arg_group ts_image_groups[] = {
	{ NULL, "every file color diameter size view center zoom" },
	{ "What is drawn",
	  "atom adiam bond mesh voxel wall region contact arrow film slice clip box axes subbox" },
	{ "Camera", "up persp" },
	{ "Light and edges", "shiny depthcue fsaa ssao" },
	{ "Legend", "legend" },
	{ .words = NULL },
};
