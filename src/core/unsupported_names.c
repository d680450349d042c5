#include "core/unsupported_names.h"

#include <string.h>

#include "base/banned.h"

#define SPH "smoothed-particle hydrodynamics is not supported; the fluid is solved on a grid (flow_style)"
#define SHAPES "particles are spheres; other shapes are modelled by bonded spheres (bond_style)"
#define FRAGMENTS "particles do not break into fragments; use bonded spheres (bond_style)"
#define UNPUBLISHED "it belongs to another edition of LIGGGHTS, and no description of it is public"
#define GRID_LINES "`box` draws the edges of the box, `slice` the fields of the fluid"
#define SEGMENTS                                                                                        \
	"particles are drawn as spheres; meshes, height fields, walls and regions by `mesh`, `voxel`, " \
	"`wall`, `region`"
#define TRANSPARENT "particles (atrans), surfaces and slices (trans) can be transparent, bonds and lines not"
/* Keywords of both dumps of pictures, and of both commands that change dumps. */
#define PICTURES(word_, remark_)             \
	{ "dump image", word_, remark_ },    \
	{                                    \
		"dump movie", word_, remark_ \
	}
#define CHANGES(word_, remark_)                     \
	{ "dump_modify", word_, remark_ },          \
	{                                           \
		"write_dump modify", word_, remark_ \
	}
#define TEMPLATE_BONDS                                                                         \
	"insert the spheres, then make the bonds: bond_style (beam, parallel, gran ...) with " \
	"`create_bonds`, or with `fix ID GROUP bond/create/gran` while spheres are inserted"
/* Words of both templates of clumps. */
#define CLUMPS(word_, remark_)                                      \
	{ "fix particletemplate/multiplespheres", word_, remark_ }, \
	{                                                           \
		"fix particletemplate/multisphere", word_, remark_  \
	}
#define PAIRS(word_)                                                                                    \
	{                                                                                               \
		"compute pair/local", word_,                                                            \
			"compute pair/gran/local gives normal and tangential forces, torques, overlap " \
			"and history of a contact"                                                      \
	}
#define BONDS(word_)                                                                                   \
	{                                                                                              \
		"compute property/local", word_,                                                       \
			"compute bond/local gives lengths, forces, torques and stresses of bonds, in " \
			"the same order"                                                               \
	}
#define BRIDGES "use easo/capillary/viscous or washino/capillary/viscous"

static const struct {
	const char *of, *word, *remark;
} words[] = {
	{ "model", "hertz/break", FRAGMENTS },
	{ "model", "hysteretic/nonlinear2", UNPUBLISHED "; hooke/hysteresis is a similar law" },
	{ "model", "luding", "hooke/hysteresis is a similar law" },
	{ "model", "edinburgh/stiffness", "use model edinburgh, whose stiffness is that of the material" },
	{ "model", "thornton_ning", "edinburgh and hooke/hysteresis are elasto-plastic laws with adhesion" },
	{ "tangential", "tan_luding", "use tangential history" },
	{ "rolling_friction", "luding", "epsd is a similar law" },
	{ "rolling_friction", "cdtnonlinear2", UNPUBLISHED "; cdt is a similar law" },
	{ "cohesion", "bond/nonlinear",
	  "no description of its law is public; `cohesion bond` is the linear law, bond_style beam and "
	  "parallel have other options" },
	{ "cohesion", "capillary", BRIDGES },
	{ "surface", "superquadric", SHAPES },
	{ "pair gran", "capillaryModel", BRIDGES },
	{ "pair gran", "Willett", BRIDGES },
	{ "fix massflow/mesh", "sieveMultiSphereCanPass",
	  "members of rigid bodies are held: a body could be stuck between its members" },
	{ "fix wall/gran", "general_plane",
	  "for planes at any angle use a region: `region W plane PX PY PZ NX NY NZ` and `fix ID GROUP "
	  "wall/gran/region model ... type T region W`" },
	{ "fix wall/gran", "general_cylinder",
	  "for cylinders along x, y or z write `primitive ... zcylinder R X Y`; for other directions use a "
	  "region (region cylinder with rotate, fix wall/gran/region) or a mesh" },
	{ "out", "bin", "compute temp/chunk gives the temperature of each bin of compute chunk/atom" },
	{ "bonded", "yes*", TEMPLATE_BONDS },
	CLUMPS("bond_type", TEMPLATE_BONDS),
	CLUMPS("nbond_pairs", TEMPLATE_BONDS),
	CLUMPS("spheres_different_types",
	       "all spheres of a template have its atom_type; `set` changes types of particles"),
	{ "set", "blockiness", SHAPES },
	{ "set", "quat", SHAPES },
	{ "set", "shape", SHAPES },
	{ "set", "meso_rho", SPH },
	{ "set", "sphkernel", SPH },
	PAIRS("p1"),
	PAIRS("p2"),
	PAIRS("p3"),
	PAIRS("p4"),
	BONDS("batom1*"),
	BONDS("batom2*"),
	BONDS("bforce*"),
	BONDS("btorque*"),
	BONDS("beqdist"),
	PICTURES("grid", "fields of the fluid are drawn by `slice x|y|z POSITION QUANTITY`"),
	PICTURES("gridline", GRID_LINES),
	PICTURES("gridlines", GRID_LINES),
	PICTURES("line", SEGMENTS),
	PICTURES("tri", SEGMENTS),
	PICTURES("ellipsoid", SHAPES),
	PICTURES("body", SHAPES),
	PICTURES("fix", SEGMENTS),
	PICTURES("compute", SEGMENTS),
	CHANGES("btrans", TRANSPARENT),
	CHANGES("boxtrans", TRANSPARENT),
	CHANGES("axestrans", TRANSPARENT),
	{ TS_UNSUPPORTED_QUANTITY, "p", SPH },
	{ TS_UNSUPPORTED_QUANTITY, "rho", SPH },
	{ TS_UNSUPPORTED_QUANTITY, "blockiness*", SHAPES },
	{ TS_UNSUPPORTED_QUANTITY, "quat*", SHAPES },
	{ TS_UNSUPPORTED_QUANTITY, "shape*", SHAPES },
	{ TS_UNSUPPORTED_QUANTITY, "id_multisphere", "use mol, the number of the body" },
	{ TS_UNSUPPORTED_QUANTITY, "i_cg_level", "several levels of coarse graining are not supported" },
	{ .of = NULL },
};

static bool matches_pattern(const char *pattern, size_t length, const char *name)
{
	if (pattern[length - 1] == '*')
		return strncmp(pattern, name, length - 1) == 0;
	return strncmp(pattern, name, length) == 0 && name[length] == '\0';
}

bool ts_unsupported_names(const struct ts_unsupported *k, const char *name)
{
	for (const char *at = k->names; *at; at += strspn(at, " ")) {
		const size_t length = strcspn(at, " ");

		if (matches_pattern(at, length, name))
			return true;
		at += length;
	}
	return false;
}

const struct ts_unsupported *ts_unsupported_find(enum ts_kind kind, const char *name)
{
	for (const struct ts_unsupported *k = ts_unsupported_table; k->names; k++)
		if (k->kind == kind && ts_unsupported_names(k, name))
			return k;
	return NULL;
}

const char *ts_unsupported_word_remark(const char *of, const char *word)
{
	for (size_t k = 0; words[k].of; k++)
		if (ts_streq(words[k].of, of) && matches_pattern(words[k].word, strlen(words[k].word), word))
			return words[k].remark;
	return NULL;
}
