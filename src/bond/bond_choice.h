/* How fix bond/create and bond/break of LAMMPS choose among pairs of particles. */
#ifndef TS_BOND_BOND_CHOICE_H
#define TS_BOND_BOND_CHOICE_H

#include "core/sim.h"

/* A pair of particles with what decides. */
struct ts_bond_option {
	size_t row[2];
	int32_t tag[2];
	double key; /* the smallest is chosen, of equal ones the first */
};

/* Keywords `prob FRACTION SEED`. */
struct ts_bond_chance {
	struct ts_words words;
	double fraction;
	int64_t seed;
};
#define TS_BOND_CHANCE_ROW(T, f)               \
	TS_SOME_KEYWORD("prob", T, f.words, 0, \
			.help = "FRACTION SEED: an eligible pair is taken with this probability")

enum ts_status ts_bond_chance_read(struct tsim *sim, const char *what, struct ts_bond_chance *chance);
/* Sets chosen[k] of the options that are the best of both their particles, and that chance takes. */
enum ts_status ts_bond_choose(struct tsim *sim, const struct ts_bond_option *option, size_t n,
			      const struct ts_bond_chance *chance, unsigned char *chosen);

#endif
