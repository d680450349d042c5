/* Styles and commands of LIGGGHTS and LAMMPS that tsim does not have: what it has instead, or why not. */
#include "core/unsupported_names.h"

#include "base/banned.h"

#define MOLECULAR "molecular force fields are not supported: particles are grains"
#define MOLECULAR_METHODS "methods of molecular dynamics are not supported: particles are grains"
#define CHARGES "electric charges are not supported"
#define CRYSTALS                                                                                            \
	"the order of crystals is not computed; compute coord/atom, contact/atom, rdf and fabric describe " \
	"packings"
#define PERIDYNAMICS "peridynamics is not supported; bond_style (beam, parallel ...) models solids that break"
#define PERIDYNAMIC_DAMAGE "peridynamics is not supported; compute nbond/atom tells which bonds are left"
#define SPH "smoothed-particle hydrodynamics is not supported; the fluid is solved on a grid (flow_style)"
#define ROTATION_DYNAMICS \
	"stochastic rotation dynamics is not supported; the fluid is solved on a grid (flow_style)"
#define COUPLING                                                                                         \
	"the supported couplings with other programs are couple/cfd, couple/cfd/force, /force/implicit " \
	"and /convection; tsim can also compute the fluid (flow_style)"
#define SHAPES "particles are spheres; other shapes are modelled by bonded spheres (bond_style)"
#define CHEMISTRY "chemical reactions are not supported"
#define FRAGMENTS "particles do not break into fragments; use bonded spheres (bond_style)"
#define OTHER_EDITION "it belongs to another edition of LIGGGHTS and is not in 3.8 either"
#define RESOLUTION                                                                                       \
	"it belongs to the coupling of coarse and fine grains across the faces of a mesh, which is not " \
	"supported"
#define INTERNAL "LIGGGHTS makes it by itself, and no description of it is public; leave the line out"
#define UNDESCRIBED "no description of it is public"
#define MINIMIZATION                                                                                    \
	"energy minimization is not supported; particles come to rest by damping, see fix viscous and " \
	"damping/cundall"
#define BAROSTATS                                                                                           \
	"barostats are not supported; fix deform changes the box, fix mesh/surface/stress/servo presses a " \
	"wall with a force"
#define THERMOSTATS                                                                                         \
	"thermostats are not supported; fix langevin agitates and damps particles, fix heat/gran computes " \
	"the temperatures of grains"
#define POTENTIAL_WALLS                                                                                      \
	"walls of a potential are not supported; write `fix ID GROUP wall/gran ... primitive type T xplane " \
	"X`"
#define PYTHON "Python in scripts is not supported; a Python program can run tsim (module tsim)"
#define IDENTITY "atom IDs are kept, and IDs of deleted particles are not used again"
#define OF_MOLECULES(compute_) \
	"write `compute M GROUP chunk/atom molecule` and `compute ID GROUP " compute_ " M`"
#define COMPRESSED "text is compressed with zlib: end the name of the file with .gz"
#define ONE_FILE(dump_) \
	"blocks of several data sets are not written; write `dump ID GROUP " dump_ " N FILE ...`"

const struct ts_unsupported ts_unsupported_table[] = {
	{ TS_KIND_COMMAND, "angle_* dihedral_* dielectric improper_* kspace_* dynamical_matrix third_order",
	  MOLECULAR },
	{ TS_KIND_COMMAND,
	  "hyper kim kim_* group2ndx ndx2group mdi neb prd tad temper temper/* message server",
	  MOLECULAR_METHODS },
	{ TS_KIND_COMMAND, "minimize min_*", MINIMIZATION },
	{ TS_KIND_COMMAND, "python", PYTHON },
	{ TS_KIND_COMMAND, "reset_atom_ids reset_atoms reset_ids reset_mol_ids", IDENTITY },
	{ TS_KIND_COMMAND, "rotate", "write `displace_atoms GROUP rotate PX PY PZ RX RY RZ ANGLE`" },
	{ TS_KIND_COMMAND, "write_coeff", "`info coeffs` prints them, the log records all values of a run" },
	{ TS_KIND_COMMAND, "coarsegraining", RESOLUTION },
	{ TS_KIND_COMMAND, "extract_surface extrude_surface", OTHER_EDITION },

	{ TS_KIND_PAIR,
	  "adp agni airebo airebo/* atm beck bop born born/* buck buck/* colloid comb comb3 cosine/squared "
	  "dpd* dsmc e3b eam* edip edip/multi eff/cut eim extep gauss gauss/cut gayberne gw gw/zbl "
	  "hbond/* kim lcbop lennard/mdf line/lj list lj/* lj96/cut local/density meam* mie/cut momb morse "
	  "morse/* nb3b/* nm/* oxdna* polymorphic python reax* rebo resquared soft srp sw sw/* table table/* "
	  "tersoff tersoff/* thole tip4p/* tri/lj ufm vashishta vashishta/* wf/cut yukawa yukawa/* zbl",
	  MOLECULAR },
	{ TS_KIND_PAIR, "coul/*", CHARGES },
	{ TS_KIND_PAIR, "brownian brownian/poly", "random forces on grains are those of fix langevin" },
	{ TS_KIND_PAIR, "lubricate lubricate/poly lubricateU lubricateU/poly",
	  "the film of a fluid between grains is that of fix lubrication" },
	{ TS_KIND_PAIR, "body/*", SHAPES },
	{ TS_KIND_PAIR, "peri/*", PERIDYNAMICS },
	{ TS_KIND_PAIR, "bubble gran_bubble", UNDESCRIBED },
	{ TS_KIND_PAIR, "hybrid/scaled", "all pairs have the same contact law" },
	{ TS_KIND_PAIR, "sph/*", SPH },
	{ TS_KIND_PAIR, "tracker",
	  "lifetimes of contacts are not recorded; `dump local` of compute pair/gran/local writes contacts" },
	{ TS_KIND_PAIR, "zero", "without a pair_style grains do not interact" },
	{ TS_KIND_BOND, "class2 fene* gromos morse oxdna* quartic table", MOLECULAR },
	{ TS_KIND_BOND, "hybrid", "there is one style of bonds; bond_coeff has coefficients for each type" },
	{ TS_KIND_BOND, "special zero", "without a bond_style bonds have no forces" },

	{ TS_KIND_FIX,
	  "atom/swap bond/create/angle bond/swap charge/regulation cmap gcmc grem hyper/* ipi msst neb "
	  "nphug pimd rattle restrain shake tfmc widom",
	  MOLECULAR_METHODS },
	{ TS_KIND_FIX, "bond/react chem/*", CHEMISTRY },
	{ TS_KIND_FIX, "efield qeq/* tune/kspace", CHARGES },
	{ TS_KIND_FIX, "box/relax nph* npt* press/berendsen rigid/nph* rigid/npt*", BAROSTATS },
	{ TS_KIND_FIX, "nvt* rigid/nvt* temp/berendsen temp/csld temp/csvr temp/rescale", THERMOSTATS },
	{ TS_KIND_FIX, "ehex heat thermal/conductivity",
	  "the temperatures of grains, and heat that is added to them, are those of fix heat/gran" },
	{ TS_KIND_FIX, "accelerate/cos",
	  "write `fix ID GROUP addforce v_FX 0 0` with a variable of style atom, a formula of x, y, z" },
	{ TS_KIND_FIX, "append/atoms deposit",
	  "write `fix ID GROUP insert/stream` (through a face of a mesh) or `fix ID GROUP "
	  "insert/rate/region` (in a region), with fix particletemplate/sphere and fix "
	  "particledistribution/discrete" },
	{ TS_KIND_FIX, "ave/spatial/sphere",
	  "write `compute C GROUP chunk/atom bin/sphere X Y Z RMIN RMAX N` and `fix ID GROUP ave/chunk ... "
	  "C`" },
	{ TS_KIND_FIX, "dt/reset",
	  "the time step is constant while steps are done; `run N every M \"timestep DT\"` changes it, a "
	  "variable in DT is evaluated each time, fix check/timestep/gran tells how large it may be" },
	{ TS_KIND_FIX, "imd", "a program can run tsim and look at each step (doc/library.md)" },
	{ TS_KIND_FIX, "indent",
	  "write `fix M all mesh/surface primitive sphere radius R type T` and `fix W all wall/gran ... mesh "
	  "n_meshes 1 meshes M`; fix move/mesh moves it, fix mesh/surface/stress/servo presses it with a "
	  "force" },
	{ TS_KIND_FIX,
	  "nve/asphere* nve/body nve/line nve/nonspherical nve/superquadric nve/tri "
	  "particletemplate/superquadric wall/body/*",
	  SHAPES },
	{ TS_KIND_FIX, "pair/tracker",
	  "lifetimes of contacts are not recorded; `dump local` of compute pair/gran/local writes contacts" },
	{ TS_KIND_FIX, "poems", "joints between rigid bodies are not supported; see fix rigid" },
	{ TS_KIND_FIX, "python python/*", PYTHON },
	{ TS_KIND_FIX, "spring/chunk spring/rg", "fix spring pulls a group to a point or to another group" },
	{ TS_KIND_FIX, "srd wall/srd", ROTATION_DYNAMICS },
	{ TS_KIND_FIX, "wall/colloid wall/harmonic wall/lj* wall/morse", POTENTIAL_WALLS },
	{ TS_KIND_FIX, "wall/piston", "fix move/mesh moves a mesh, fix wall/gran a plane (wiggle, shear)" },
	{ TS_KIND_FIX, "wall/region",
	  "walls of a potential are not supported; write `fix ID GROUP wall/gran/region ... region REGION`" },

	{ TS_KIND_FIX, "ave/euler/stress", "the stresses of cells are among the numbers of fix ave/euler" },
	{ TS_KIND_FIX, "ave/euler/region",
	  "averages over the cells of a hexahedral mesh are not supported; `fix ID GROUP ave/euler nevery N "
	  "cell_size_relative C parallel no` averages over a regular grid, `compute ID GROUP reduce/region "
	  "REGION ave vx vy vz` over a region" },
	{ TS_KIND_FIX, "break/particle multisphere/break particletemplate/fragments", FRAGMENTS },
	{ TS_KIND_FIX, "check/timestep/sph nve/sph nve/sph/* sph/* wall/region/sph wall/sph*", SPH },
	{ TS_KIND_FIX,
	  "contacthistory contacthistory/* contactproperty/* diam/max neighlist/mesh "
	  "transportequation/scalar",
	  INTERNAL },
	{ TS_KIND_FIX, "concave deform/check multisphere/nointegration region/variable", UNDESCRIBED },
	{ TS_KIND_FIX, "continuum/weighted",
	  "averages with a kernel are not supported; fix ave/euler averages over cells, compute "
	  "stress/region over a region" },
	{ TS_KIND_FIX,
	  "couple/cfd/chemistry* couple/cfd/convectiveImpl couple/cfd/de* couple/cfd/dissolve* "
	  "couple/cfd/dragforce couple/cfd/force/accumulated couple/cfd/force/implicit/accumulated "
	  "couple/cfd/parscale* couple/cfd/radiation* couple/cfd/species* couple/lb/* couple/pascal*",
	  COUPLING },
	{ TS_KIND_FIX, "fiber/spring/simple", "bond_style harmonic or beam joins the spheres of a fibre" },
	{ TS_KIND_FIX, "forcecontrol/region insert/pack/face", RESOLUTION },
	{ TS_KIND_FIX, "massflow/mesh/face",
	  "faces of a mesh are not numbered; write a `fix mesh/surface` for each face, and for each of them "
	  "`fix ID GROUP massflow/mesh mesh MESH vec_side X Y Z`" },
	{ TS_KIND_FIX, "mesh/surface/stress/6dof",
	  "write `fix M all mesh/surface/stress file FILE type T` and `fix ID all move/mesh/free mesh M "
	  "density D`: the body moves in all six degrees of freedom" },
	{ TS_KIND_FIX, "pour/legacy",
	  "write `fix ID GROUP pour N TYPE SEED region REGION vol FRACTION TRIES diam range LO HI dens LO HI "
	  "vel VXLO VXHI VYLO VYHI VZ`" },
	{ TS_KIND_FIX, "pour/dev",
	  "write `fix ID GROUP insert/rate/region seed S distributiontemplate D nparticles N particlerate "
	  "RATE insert_every STEPS region REGION`" },
	{ TS_KIND_FIX, "property/atom/timetracer", "its present name is property/atom/regiontracer/time" },

	{ TS_KIND_REGION, "grid", "per-grid data of computes and fixes are not supported" },
	{ TS_KIND_COMPUTE, "angle angle/* dihedral dihedral/* improper improper/*", MOLECULAR },
	{ TS_KIND_COMPUTE, "event/displace temp/cs viscosity/cos", MOLECULAR_METHODS },
	{ TS_KIND_COMPUTE, "dipole dipole/chunk", CHARGES },
	{ TS_KIND_COMPUTE,
	  "ackland/atom basal/atom centro/atom cna/atom cnp/atom entropy/atom hexorder/atom orientorder/atom",
	  CRYSTALS },
	{ TS_KIND_COMPUTE, "damage/atom dilatation/atom plasticity/atom", PERIDYNAMIC_DAMAGE },
	{ TS_KIND_COMPUTE, "body/local erotate/asphere erotate/superquadric temp/asphere temp/body", SHAPES },
	{ TS_KIND_COMPUTE, "bond pair", "compute pe sums the energies of pairs and bonds" },
	{ TS_KIND_COMPUTE, "centroid/stress/atom", "compute stress/atom gives each particle its stress" },
	{ TS_KIND_COMPUTE, "global/atom",
	  "compute chunk/spread/atom gives each particle the numbers of its chunk" },
	{ TS_KIND_COMPUTE, "heat/flux",
	  "the heat that is conducted through a contact is heatFlux of compute pair/gran/local" },
	{ TS_KIND_COMPUTE, "reduce/sph", SPH },
	{ TS_KIND_COMPUTE, "rigid/local", "f_ID of fix rigid has a row for each body" },
	{ TS_KIND_COMPUTE, "temp/deform",
	  "compute temp/profile and temp/granular subtract the mean velocity of a flow" },
	{ TS_KIND_COMPUTE, "voronoi/atom",
	  "cells of single particles are not computed; fix ave/euler and fix ave/chunk give volume "
	  "fractions" },
	{ TS_KIND_COMPUTE, "atom/molecule", OF_MOLECULES("reduce/chunk") },
	{ TS_KIND_COMPUTE, "com/molecule", OF_MOLECULES("com/chunk") },
	{ TS_KIND_COMPUTE, "gyration/molecule", OF_MOLECULES("gyration/chunk") },
	{ TS_KIND_COMPUTE, "inertia/molecule", OF_MOLECULES("inertia/chunk") },
	{ TS_KIND_COMPUTE, "msd/molecule", OF_MOLECULES("msd/chunk") },
	{ TS_KIND_COMPUTE, "property/molecule", OF_MOLECULES("property/chunk") },

	{ TS_KIND_DUMP, "decomposition/vtk",
	  "the blocks of ranks are not written; the log of a run tells their numbers" },
	{ TS_KIND_DUMP, "atom/vtk", "write `dump ID GROUP custom/vtk N FILE id type radius vx vy vz`" },
	{ TS_KIND_DUMP, "custom/vtm", ONE_FILE("custom/vtk") },
	{ TS_KIND_DUMP, "mesh/vtm", ONE_FILE("mesh/vtk") },
	{ TS_KIND_DUMP, "atom/zstd cfg/zstd custom/zstd local/zstd xyz/zstd", COMPRESSED },
	{ TS_KIND_DUMP, "cfg cfg/* dcd molfile netcdf netcdf/mpiio xtc yaml",
	  "write dump custom, atom, xyz or h5md: OVITO and VMD read them" },
	{ .names = NULL },
};
