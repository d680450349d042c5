/* Contact laws given on the line of the wall, in the syntax of LAMMPS: hooke, hooke/history, hertz/history
 * with their constants, granular with the keywords of pair_coeff. */
#ifndef TS_WALL_WALL_LAW_H
#define TS_WALL_WALL_LAW_H

#include "contact/gran_coeff.h"
#include "contact/gran_numbers.h"
#include "wall/wall.h"

enum { TS_WALL_LAWS = 4 };
struct ts_wall_law {
	struct ts_words words[TS_WALL_LAWS];
	struct ts_gran_numbers numbers;
	struct ts_gran_coeff coeff;
};

#define TS_WALL_LAW_WORD(name, T, f, k)                                \
	TS_SOME_KEYWORD(name, T, f.words[k], 0,                        \
			.help = "contact law of pair_style gran/" name \
				": kn kt gamma_n gamma_t xmu dampflag")
#define TS_WALL_LAW_ARGS(T, f)                                                                               \
	TS_WALL_LAW_WORD("hooke", T, f, 0), TS_WALL_LAW_WORD("hooke/history", T, f, 1),                      \
		TS_WALL_LAW_WORD("hertz/history", T, f, 2),                                                  \
		TS_SOME_KEYWORD("granular", T, f.words[3], 0, .inner = ts_gran_coeff_rows,                   \
				.help = "contact law in the keywords of pair_coeff of pair_style granular"), \
		TS_FLAG("limit_damping", T, f.numbers.limit_damping,                                         \
			.help = "with these laws: the normal force never pulls")

/* In the manual pages. */
#define TS_WALL_LAW_GROUP                                                                            \
	{                                                                                            \
		"Contact laws of LAMMPS", "hooke hooke/history hertz/history granular limit_damping" \
	}

/* In init: if one of these laws is given, sets it as the law of the wall; fails if there are several. */
enum ts_status ts_wall_law_choose(struct ts_instance *self, struct tsim *sim, struct ts_wall_law *law,
				  struct ts_wall *wall);

#endif
