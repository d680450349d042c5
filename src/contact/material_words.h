/* The words that choose contact laws, the same for pair_style gran and walls: `model hertz tangential history
 * ...`. */
#ifndef TS_CONTACT_MATERIAL_WORDS_H
#define TS_CONTACT_MATERIAL_WORDS_H

#include "contact/cohesive_bonds.h"
#include "core/sim.h"
#include "law/granular.h"

/* the choices and flags as given; laws by the numbers of law/granular.h or TS_WORD_... */
struct ts_granular_words {
	int normal, tangential, rolling, cohesion, surface;
	bool limit_force, tangential_damping, absolute_damping, kt_to_kn, viscous, reduce, torsion;
	bool heating[2], potential, dissipated, unbonded, located, modify_share, limit_liquid;
	struct ts_cohesive_words bonds; /* of `cohesion bond` */
};
/* Words whose number is not that of their law in law/granular.h. */
enum {
	TS_WORD_JKR = TS_NORMAL_EDINBURGH + 1,
	TS_WORD_JKR_TAN = TS_TANGENTIAL_INCREMENTAL + 1,
	TS_WORD_BOND = TS_COHESION_WASHINO + 1
};
enum { TS_SURFACE_DEFAULT, TS_SURFACE_MULTICONTACT };
extern const char *const ts_normal_names[],
	*const ts_tangential_names[], *const ts_rolling_names[], *const ts_cohesion_names[],
									 *const ts_surface_names[];

#define TS_GRANULAR_ARGS(T, f)                                                                               \
	TS_ENUM("model", T, f.normal, ts_normal_names, .fallback = "off", .help = "normal law"),             \
		TS_ENUM("tangential", T, f.tangential, ts_tangential_names, .fallback = "off",               \
			.help = "tangential law"),                                                           \
		TS_ENUM("cohesion", T, f.cohesion, ts_cohesion_names, .fallback = "off",                     \
			.help = "cohesion law; bond: bonds between particles (bond_style cohesion); "        \
				"easo/... and washino/... are liquid bridges "                               \
				"(doc/bridges.md), which take the properties surfaceTension, "               \
				"fluidViscosity, contactAngle, minSeparationDistanceRatio, "                 \
				"maxSeparationDistanceRatio, surfaceLiquidContentInitial and "               \
				"lbVolumeFraction"),                                                         \
		TS_ENUM("rolling_friction", T, f.rolling, ts_rolling_names, .fallback = "off",               \
			.help = "rolling law"),                                                              \
		TS_ENUM("surface", T, f.surface, ts_surface_names, .fallback = "default",                    \
			.help = "`multicontact`: surfaces are displaced by the other contacts of the "       \
				"particle, see "                                                             \
				"fix multicontact/halfspace"),                                               \
		TS_BOOL("limitForce", T, f.limit_force, .fallback = "off",                                   \
			.help = "no attractive normal force (before cohesion)"),                             \
		TS_BOOL("tangential_damping", T, f.tangential_damping, .fallback = "on",                     \
			.help = "tangential damping"),                                                       \
		TS_BOOL("absolute_damping", T, f.absolute_damping, .fallback = "off",                        \
			.help = "gamma of hooke/stiffness is not multiplied by m*"),                         \
		TS_BOOL("ktToKnUser", T, f.kt_to_kn, .fallback = "off", .help = "hooke: k_t = 2/7 k_n"),     \
		TS_BOOL("viscous", T, f.viscous, .fallback = "off",                                          \
			.help = "hooke: restitution depends on the Stokes number"),                          \
		TS_BOOL("tangential_reduce", T, f.reduce, .fallback = "off",                                 \
			.help = "cohesion reduces the limit of friction"),                                   \
		TS_BOOL("modifyLbVolume", T, f.modify_share, .fallback = "off",                              \
			.help = "cohesion washino/capillary/viscous: a bridge takes the fraction "           \
				"lbVolumeFraction of the liquid instead of 0.05"),                           \
		TS_BOOL("limitLiquidContent", T, f.limit_liquid, .fallback = "off",                          \
			.help = "cohesion washino/capillary/viscous: only off"),                             \
		TS_BOOL("torsionTorque", T, f.torsion, .fallback = "off",                                    \
			.help = "rolling friction also acts on the rotation about the normal"),              \
		TS_BOOL("heating_normal_hertz", T, f.heating[0], .fallback = "off",                          \
			.help = "no effect yet"),                                                            \
		TS_BOOL("heating_tangential_history", T, f.heating[1], .fallback = "off",                    \
			.help = "no effect yet"),                                                            \
		TS_BOOL("computeElasticPotential", T, f.potential, .fallback = "off", .help = "no effect"),  \
		TS_BOOL("computeDissipatedEnergy", T, f.dissipated, .fallback = "off", .help = "no effect"), \
		TS_BOOL("disableNormalWhenBonded", T, f.unbonded, .fallback = "off",                         \
			.help = "no effect; see special_bonds"),                                             \
		TS_COHESIVE_ARGS(T, f.bonds),                                                                \
		TS_BOOL("located", T, f.located, .fallback = "no",                                           \
			.help = "sub-step contact detection: begin and end of contacts within a step are "   \
				"resolved")

/* The same in the order of the manual pages. */
#define TS_GRANULAR_GROUPS                                                                         \
	{ NULL, "model tangential rolling_friction cohesion" },                                    \
		{ "Details of the contact law",                                                    \
		  "surface limitForce tangential_damping absolute_damping ktToKnUser viscous "     \
		  "tangential_reduce torsionTorque located" },                                     \
		{ "Liquid bridges (cohesion washino/capillary/viscous)",                           \
		  "modifyLbVolume limitLiquidContent" },                                           \
		{ "Bonds (cohesion bond)",                                                         \
		  "stressBreak createBondAlways tensionStress compressionStress shearStress "      \
		  "normalTorqueStress shearTorqueStress dampingBond ratioTensionCompression "      \
		  "temperatureBreak dampingBondSmooth dissipationBond druckerPrager" },            \
	{                                                                                          \
		"Accepted for compatibility, without effect",                                      \
			"heating_normal_hertz heating_tangential_history computeElasticPotential " \
			"computeDissipatedEnergy disableNormalWhenBonded"                          \
	}

/* Checks the order of the words, and that keywords fit the models. `who` for messages: "pair gran". */
enum ts_status ts_granular_words_check(struct tsim *sim, const struct ts_instance *self, const char *who,
				       const struct ts_granular_words *words);

#endif
