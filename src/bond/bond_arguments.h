/* Rows of bond_coeff, paragraphs of the manual and slots that bond styles with moments share. */
#ifndef TS_BOND_BOND_ARGUMENTS_H
#define TS_BOND_BOND_ARGUMENTS_H

#include "bond/bonds.h"
#include "law/bond_section.h"

extern const char *const ts_bond_scatter_names[];

/* Checks that the numbers of the distribution are given. */
enum ts_status ts_bond_strength_complete(struct tsim *sim, const struct ts_bond_strength *strength,
					 const struct ts_place *where);

/* Viscous damping of the modes, as fractions of the critical one. */
struct ts_bond_damping {
	double all, of[TS_BOND_MODES]; /* arguments; NaN: as `all` */
	double ratio[TS_BOND_MODES];   /* from these */
};

void ts_bond_damping_complete(struct ts_bond_damping *damping);
bool ts_bond_any_damping(const struct ts_bond_damping *damping);

#define TS_BOND_STRENGTH_ROWS(T, f)                                                                          \
	TS_REAL("sigma_c", T, f.tension, .flags = TS_OPTIONAL, .range = TS_POSITIVE, .unit = "pressure",     \
		.help = "tensile strength; none: infinite"),                                                 \
		TS_REAL("tau_c", T, f.shear, .flags = TS_OPTIONAL, .range = TS_POSITIVE, .unit = "pressure", \
			.help = "shear strength; none: infinite"),                                           \
		TS_REAL("sigma_compression", T, f.compression, .flags = TS_OPTIONAL, .range = TS_POSITIVE,   \
			.unit = "pressure", .help = "compressive strength; none: infinite"),                 \
		TS_ENUM("scatter", T, f.scatter, ts_bond_scatter_names, .fallback = "none",                  \
			.help = "distribution of sigma_c and tau_c: none, all bonds have the same "          \
				"strength; "                                                                 \
				"normal; weibull"),                                                          \
		TS_REAL("deviation", T, f.deviation, .flags = TS_OPTIONAL, .range = TS_WITHIN, .lo = 0,      \
			.hi = 1, .unit = "",                                                                 \
			.help = "scatter normal: standard deviation divided by the mean, at most 1"),        \
		TS_REAL("shape", T, f.shape, .flags = TS_OPTIONAL, .range = TS_WITHIN, .lo = 0.1,            \
			.hi = 1000, .unit = "", .help = "scatter weibull: modulus m of the distribution"),   \
		TS_INT("seed", T, f.seed, .fallback = "1", .range = TS_POSITIVE,                             \
		       .help = "seed of the random strengths")

#define TS_BOND_DAMPING_ROW(T, f, mode, name_, text)                                              \
	TS_REAL(name_, T, f.of[mode], .flags = TS_OPTIONAL, .range = TS_NOT_NEGATIVE, .unit = "", \
		.help = "the same for " text "; none: that of `damping`")
#define TS_BOND_DAMPING_ROWS(T, f)                                                                        \
	TS_REAL("damping", T, f.all, .fallback = "0", .range = TS_NOT_NEGATIVE, .unit = "",               \
		.help = "viscous damping of all modes, as a fraction of the critical damping of the two " \
			"particles"),                                                                     \
		TS_BOND_DAMPING_ROW(T, f, TS_BOND_NORMAL, "damping_normal", "the normal force"),          \
		TS_BOND_DAMPING_ROW(T, f, TS_BOND_SHEAR, "damping_shear", "the shear force"),             \
		TS_BOND_DAMPING_ROW(T, f, TS_BOND_BENDING, "damping_bending", "the bending moment"),      \
		TS_BOND_DAMPING_ROW(T, f, TS_BOND_TWIST, "damping_twist", "the torque")

#define TS_BOND_MOMENT_DOC                                                                             \
	"Damping: dashpots parallel to the four springs, 2 zeta sqrt(k m*) with the stiffness k of "   \
	"the mode and the reduced mass, or moment of inertia, m* of the two particles. fix "           \
	"damping/cundall gives the local damping of Cundall, which acts on all forces.\n\nBonds are "  \
	"stress-free in the state in which they are created, or in which the first style with "        \
	"moments is chosen, if that is later, with sections of the radii of that time; rest lengths "  \
	"are those of create_bonds. Particles get a column `orientation` (unit quaternion) and must "  \
	"be integrated by fix nve/sphere. A bond that turns by more than 90 degrees between its "      \
	"ends, that extends over half a periodic box, or to a member of a rigid body is an error. In " \
	"two dimensions the section is a circle as well.\n\nThe limit of the time step includes "      \
	"bending and torsion, which limit short bonds; see doc/stability.md."

/* `turn`: turns the particles after they have moved. */
#define TS_BOND_MOMENT_SLOTS_WITH(turn)                                                       \
	.archive = ts_bond_archive, .fingerprint = ts_bond_fingerprint, .init = ts_bond_init, \
	.hook = { [TS_STAGE_POST_INTEGRATE] = (turn), [TS_STAGE_FORCE] = ts_bond_force },     \
	.energy = ts_contact_energy_of_bonds, .plan = ts_bond_plan, .fini = ts_bond_fini
#define TS_BOND_MOMENT_SLOTS TS_BOND_MOMENT_SLOTS_WITH(ts_bond_turn)

#endif
