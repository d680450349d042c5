/* Bonds of `pair_style gran ... cohesion bond`: bonds of the style cohesion, whose types are the pairs of particle
 * types and whose constants are material properties. */
#ifndef TS_CONTACT_COHESIVE_BONDS_H
#define TS_CONTACT_COHESIVE_BONDS_H

#include "core/sim.h"
#include "law/bond_element.h"

/* The words of the bond style, also those of pair_style gran after `cohesion bond`. */
struct ts_cohesive_words {
	bool by_stress, tension, compression, shear, twist, bending;
	bool always, damping, ratio_given;
	bool by_temperature, smooth, dissipation, drucker_prager; /* refused */
	bool dissipated, potential;				  /* no effect */
};

#define TS_COHESIVE_ARGS(T, f)                                                                              \
	TS_BOOL("stressBreak", T, f.by_stress, .fallback = "off",                                           \
		.help = "cohesion bond: bonds break by stress, maxSigmaBond and maxTauBond, instead of by " \
			"distance, maxDistanceBond"),                                                       \
		TS_BOOL("createBondAlways", T, f.always, .fallback = "off",                                 \
			.help = "cohesion bond: bonds are created in each step, instead of only in step "   \
				"tsCreateBond"),                                                            \
		TS_BOOL("tensionStress", T, f.tension, .fallback = "on",                                    \
			.help = "cohesion bond: bonds resist stretching"),                                  \
		TS_BOOL("compressionStress", T, f.compression, .fallback = "on",                            \
			.help = "cohesion bond: bonds resist compression"),                                 \
		TS_BOOL("shearStress", T, f.shear, .fallback = "on",                                        \
			.help = "cohesion bond: bonds resist shear"),                                       \
		TS_BOOL("normalTorqueStress", T, f.twist, .fallback = "on",                                 \
			.help = "cohesion bond: bonds resist torsion"),                                     \
		TS_BOOL("shearTorqueStress", T, f.bending, .fallback = "on",                                \
			.help = "cohesion bond: bonds resist bending"),                                     \
		TS_BOOL("dampingBond", T, f.damping, .fallback = "on",                                      \
			.help = "cohesion bond: local damping, dampingNormalForceBond ..."),                \
		TS_BOOL("ratioTensionCompression", T, f.ratio_given, .fallback = "off",                     \
			.help = "cohesion bond: the tensile strength is the property "                      \
				"ratioTensionCompression times maxSigmaBond"),                              \
		TS_BOOL("temperatureBreak", T, f.by_temperature, .fallback = "off", .help = "only off"),    \
		TS_BOOL("dampingBondSmooth", T, f.smooth, .fallback = "off", .help = "only off"),           \
		TS_BOOL("dissipationBond", T, f.dissipation, .fallback = "off", .help = "only off"),        \
		TS_BOOL("druckerPrager", T, f.drucker_prager, .fallback = "off", .help = "only off")

/* Whether the word is one of them. */
bool ts_cohesive_word(const char *text);
/* Refuses what is not supported. `who` for messages. */
enum ts_status ts_cohesive_words_check(struct tsim *sim, const struct ts_instance *self, const char *who,
				       const struct ts_cohesive_words *words);
/* Chooses the bond style with the words of the pair style; fails if another one is in use. */
enum ts_status ts_cohesive_bonds_choose(struct tsim *sim, const struct ts_instance *pair);
/* Fails if the bond style has been replaced since. */
enum ts_status ts_cohesive_bonds_require(struct tsim *sim, const struct ts_instance *pair);

/* Constants of a bond type. */
struct ts_cohesive_coeff {
	int a, b; /* the types of the particles, a <= b; 0: there is no such pair */
	struct ts_cohesive_words words;
	double radius_multiplier, kn, kt; /* length/length, stress/length */
	double create_distance, max_distance;
	double sigma, tau, ratio; /* stress; ratio of tensile and compressive strength */
	double damping[TS_BOND_MODES];
};
/* The bond type of particles of types a and b. */
static inline int ts_cohesive_type(int a, int b)
{
	return a < b ? b * (b - 1) / 2 + a : a * (a - 1) / 2 + b;
}
/* Reads the properties of types a and b. */
enum ts_status ts_cohesive_read(struct tsim *sim, const struct ts_cohesive_words *words, int a, int b,
				const struct ts_place *where, struct ts_cohesive_coeff *out);

#endif
