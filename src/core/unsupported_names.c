#include "core/unsupported_names.h"

#include <string.h>

#include "base/banned.h"

#define MOLECULAR "molecular force fields are not supported: particles are grains"
#define SPH "smoothed-particle hydrodynamics is not supported; the fluid is solved on a grid (flow_style)"
#define COUPLING                                                                                         \
	"the supported couplings with other programs are couple/cfd, couple/cfd/force, /force/implicit " \
	"and /convection; tsim can also compute the fluid (flow_style)"
#define SHAPES "particles are spheres; other shapes are modelled by bonded spheres (bond_style)"
#define CHEMISTRY "chemical reactions are not supported"
#define FRAGMENTS "particles do not break into fragments; use bonded spheres (bond_style)"
#define OTHER_EDITION "it belongs to another edition of LIGGGHTS and is not in 3.8 either"
#define UNPUBLISHED "it belongs to another edition of LIGGGHTS, and no description of it is public"
#define RESOLUTION                                                                                       \
	"it belongs to the coupling of coarse and fine grains across the faces of a mesh, which is not " \
	"supported"

const struct ts_unsupported ts_unsupported_table[] = {
	{ TS_KIND_COMMAND, "angle_*", MOLECULAR },
	{ TS_KIND_COMMAND, "dihedral_*", MOLECULAR },
	{ TS_KIND_COMMAND, "dielectric", MOLECULAR },
	{ TS_KIND_COMMAND, "improper_*", MOLECULAR },
	{ TS_KIND_COMMAND, "kspace_*", MOLECULAR },
	{ TS_KIND_COMMAND, "minimize",
	  "energy minimization is not supported; particles come to rest by damping, see fix viscous" },
	{ TS_KIND_COMMAND, "min_*",
	  "energy minimization is not supported; particles come to rest by damping, see fix viscous" },
	{ TS_KIND_COMMAND, "neb", MOLECULAR },
	{ TS_KIND_COMMAND, "prd", MOLECULAR },
	{ TS_KIND_COMMAND, "python",
	  "Python in scripts is not supported; a Python program can run tsim (module tsim)" },
	{ TS_KIND_COMMAND, "tad", MOLECULAR },
	{ TS_KIND_COMMAND, "temper", MOLECULAR },
	{ TS_KIND_FIX, "bond/react", CHEMISTRY },
	{ TS_KIND_FIX, "chem/*", CHEMISTRY },
	{ TS_KIND_FIX, "couple/cfd/chemistry*", COUPLING },
	{ TS_KIND_FIX, "couple/cfd/de*", COUPLING },
	{ TS_KIND_FIX, "couple/cfd/dissolve*", COUPLING },
	{ TS_KIND_FIX, "couple/cfd/force/accumulated", COUPLING },
	{ TS_KIND_FIX, "couple/cfd/force/implicit/accumulated", COUPLING },
	{ TS_KIND_FIX, "couple/cfd/parscale*", COUPLING },
	{ TS_KIND_FIX, "couple/cfd/radiation*", COUPLING },
	{ TS_KIND_FIX, "couple/cfd/species*", COUPLING },
	{ TS_KIND_FIX, "couple/pascal*", COUPLING },
	{ TS_KIND_FIX, "nph*", "thermostats and barostats are not supported" },
	{ TS_KIND_FIX, "npt*", "thermostats and barostats are not supported" },
	{ TS_KIND_FIX, "nve/asphere*", SHAPES },
	{ TS_KIND_FIX, "nve/nonspherical", SHAPES },
	{ TS_KIND_FIX, "nve/sph", SPH },
	{ TS_KIND_FIX, "nve/sph/*", SPH },
	{ TS_KIND_FIX, "nve/superquadric", SHAPES },
	{ TS_KIND_FIX, "nvt*", "thermostats and barostats are not supported" },
	{ TS_KIND_FIX, "particletemplate/superquadric", SHAPES },
	{ TS_KIND_FIX, "qeq/*", MOLECULAR },
	{ TS_KIND_FIX, "shake", MOLECULAR },
	{ TS_KIND_FIX, "rattle", MOLECULAR },
	{ TS_KIND_FIX, "sph/*", SPH },
	{ TS_KIND_FIX, "wall/sph*", SPH },
	{ TS_KIND_FIX, "wall/region/sph", SPH },
	{ TS_KIND_PAIR, "eam*", MOLECULAR },
	{ TS_KIND_PAIR, "lj/*", MOLECULAR },
	{ TS_KIND_PAIR, "sph/*", SPH },
	{ TS_KIND_BOND, "fene*", MOLECULAR },
	{ TS_KIND_REGION, "grid", "per-grid data of computes and fixes are not supported" },
	{ TS_KIND_COMPUTE, "erotate/superquadric", SHAPES },
	{ TS_KIND_COMPUTE, "erotate/asphere", SHAPES },
	{ TS_KIND_COMMAND, "coarsegraining", RESOLUTION },
	{ TS_KIND_COMMAND, "extract_surface", OTHER_EDITION },
	{ TS_KIND_COMMAND, "extrude_surface", OTHER_EDITION },
	{ TS_KIND_FIX, "ave/euler/region",
	  "averages over the cells of a hexahedral mesh are not supported; `fix ID GROUP ave/euler nevery N "
	  "cell_size_relative C parallel no` averages over a regular grid, `compute ID GROUP reduce/region "
	  "REGION ave vx vy vz` over a region" },
	{ TS_KIND_FIX, "break/particle", FRAGMENTS },
	{ TS_KIND_FIX, "deposit",
	  "write `fix ID GROUP insert/stream` (through a face of a mesh) or `fix ID GROUP "
	  "insert/rate/region` (in a region), with fix particletemplate/sphere and fix "
	  "particledistribution/discrete" },
	{ TS_KIND_FIX, "forcecontrol/region", RESOLUTION },
	{ TS_KIND_FIX, "indent",
	  "write `fix M all mesh/surface primitive sphere radius R type T` and `fix W all wall/gran ... mesh "
	  "n_meshes 1 meshes M`; fix move/mesh moves it, fix mesh/surface/stress/servo presses it with a "
	  "force" },
	{ TS_KIND_FIX, "insert/pack/face", RESOLUTION },
	{ TS_KIND_FIX, "mesh/surface/stress/6dof",
	  "write `fix M all mesh/surface/stress file FILE type T` and `fix ID all move/mesh/free mesh M "
	  "density D`: the body moves in all six degrees of freedom" },
	{ TS_KIND_FIX, "particletemplate/fragments", FRAGMENTS },
	{ TS_KIND_FIX, "pour/legacy",
	  "write `fix ID GROUP pour N TYPE SEED region REGION vol FRACTION TRIES diam range LO HI dens LO HI "
	  "vel VXLO VXHI VYLO VYHI VZ`" },
	{ TS_KIND_FIX, "pour/dev",
	  "write `fix ID GROUP insert/rate/region seed S distributiontemplate D nparticles N particlerate "
	  "RATE insert_every STEPS region REGION`" },
	{ TS_KIND_FIX, "property/atom/timetracer", "its present name is property/atom/regiontracer/time" },
	{ TS_KIND_FIX, "massflow/mesh/face",
	  "faces of a mesh are not numbered; write a `fix mesh/surface` for each face, and for each of them "
	  "`fix ID GROUP massflow/mesh mesh MESH vec_side X Y Z`" },
	{ TS_KIND_DUMP, "decomposition/vtk",
	  "the blocks of ranks are not written; the log of a run tells their numbers" },
	{ .name = NULL },
};

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
#define BRIDGES "use easo/capillary/viscous or washino/capillary/viscous"

static const struct {
	const char *of, *word, *remark;
} words[] = {
	{ "model", "hertz/break", FRAGMENTS },
	{ "model", "hysteretic/nonlinear2", UNPUBLISHED "; hooke/hysteresis is a similar law" },
	{ "model", "luding", "hooke/hysteresis is a similar law" },
	{ "rolling_friction", "cdtnonlinear2", UNPUBLISHED "; cdt is a similar law" },
	{ "cohesion", "bond/nonlinear",
	  "no description of its law is public; `cohesion bond` is the linear law, bond_style beam and "
	  "parallel have other options" },
	{ "cohesion", "capillary", BRIDGES },
	{ "surface", "superquadric", SHAPES },
	{ "pair gran", "capillaryModel", BRIDGES },
	{ "pair gran", "Willett", BRIDGES },
	{ "fix wall/gran", "general_plane",
	  "for planes at any angle use a region: `region W plane PX PY PZ NX NY NZ` and `fix ID GROUP "
	  "wall/gran/region model ... type T region W`" },
	{ "fix wall/gran", "general_cylinder",
	  "for cylinders along x, y or z write `primitive ... zcylinder R X Y`; for other directions use a "
	  "region (region cylinder with rotate, fix wall/gran/region) or a mesh" },
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
	{ TS_UNSUPPORTED_QUANTITY, "i_cg_level", "several levels of coarse graining are not supported" },
	{ .of = NULL },
};

static bool matches_pattern(const char *pattern, const char *name)
{
	size_t n = strlen(pattern);

	return pattern[n - 1] == '*' ? strncmp(pattern, name, n - 1) == 0 : ts_streq(pattern, name);
}

const struct ts_unsupported *ts_unsupported_find(enum ts_kind kind, const char *name)
{
	for (const struct ts_unsupported *k = ts_unsupported_table; k->name; k++)
		if (k->kind == kind && matches_pattern(k->name, name))
			return k;
	return NULL;
}

const char *ts_unsupported_word_remark(const char *of, const char *word)
{
	for (size_t k = 0; words[k].of; k++)
		if (ts_streq(words[k].of, of) && matches_pattern(words[k].word, word))
			return words[k].remark;
	return NULL;
}
