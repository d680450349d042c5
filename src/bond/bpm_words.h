/* What the bond styles of LAMMPS' package BPM share: their keywords, and the list of broken bonds. */
#ifndef TS_BOND_BPM_WORDS_H
#define TS_BOND_BPM_WORDS_H

#include "bond/bonds.h"

struct ts_bpm_words {
	struct ts_words store; /* of store/local */
	bool overlay, smooth, normalize, breaks, unbreakable, volume;
};

#define TS_BPM_ARGS(T, f)                                                                                   \
	TS_SOME_KEYWORD("store/local", T, f.store, 0,                                                       \
			.help = "FIX N QUANTITIES ...: makes fix FIX bond/store/local N QUANTITIES ..., "   \
				"the "                                                                      \
				"list of broken bonds"),                                                    \
		TS_BOOL("overlay/pair", T, f.overlay, .fallback = "no",                                     \
			.help = "whether the pair style acts between bonded particles; special_bonds must " \
				"agree"),                                                                   \
		TS_BOOL("smooth", T, f.smooth, .fallback = "yes",                                           \
			.help = "forces decrease to zero before the bond breaks"),                          \
		TS_BOOL("normalize", T, f.normalize, .fallback = "no",                                      \
			.help = "stiffnesses of stretching and shear are divided by the rest length"),      \
		TS_BOOL("break", T, f.breaks, .fallback = "yes",                                            \
			.help = "whether bonds break; no: goes with smooth no only"),                       \
		TS_FLAG("break/no", T, f.unbreakable, .help = "the same as break no")

/* Checks the keywords and makes the fix: when the style is chosen. */
enum ts_status ts_bpm_chosen(struct ts_instance *self, struct tsim *sim, struct ts_bpm_words *words);
/* Checks that the keywords agree: before a run. */
enum ts_status ts_bpm_check(const struct ts_instance *self, struct tsim *sim,
			    const struct ts_bpm_words *words);
/* Checks that special_bonds agrees, if there are bonds. */
enum ts_status ts_bpm_allow(const struct ts_instance *self, struct tsim *sim,
			    const struct ts_bpm_words *words);

#define TS_BPM_DOC                                                                                           \
	"`special_bonds lj 0 1 1 coul 1 1 1` switches the pair style between bonded particles off, which "   \
	"`overlay/pair no`, the default, requires where bonds break; with `overlay/pair yes` it must not "   \
	"be "                                                                                                \
	"given. `store/local FIX N QUANTITIES` makes fix FIX bond/store/local. Rest lengths and directions " \
	"are those of the time at which a bond is created; LAMMPS takes those of the first run after it. "   \
	"Broken bonds are removed, where LAMMPS sets their type to 0; fix bond/breakage lists them, too, "   \
	"and "                                                                                               \
	"the thermo keyword brokenbonds is their number."

#endif
