#include "packing.h"

#include <stdlib.h>
#include <string.h>

#include "deck.h"

#include "base/alloc.h"

/* Contacts, a wall, periodic images, many rebuilds. */
const char packing[] = "units si\n"
		       "boundary p f f\n"
		       "region box block 0 0.385 0 0.4 0 1 units box\n"
		       "create_box 2 box\n"
		       "lattice sc 0.055\n"
		       "region low block 0 0.385 0.05 0.35 0.05 0.5 units box\n"
		       "create_atoms 1 region low\n"
		       "set group all diameter 0.0523 density 2385\n"
		       "group rock type 1\n"
		       "velocity all create 3.7e19 86028121\n"
		       "pair_style spring/dashpot\n"
		       "pair_coeff * * stiffness 2385 restitution 0.5\n"
		       "fix move all nve\n"
		       "fix g all gravity 9.81 vector 0.1 0 -1\n"
		       "fix floor all wall/gran primitive type 1 zplane 0.03\n"
		       "compute k all ke\n"
		       "compute nc all contacts\n"
		       "compute x all property/atom id x vz\n"
		       "fix trace all vector 10 c_k\n"
		       "thermo 50\n"
		       "timestep 2e-4\n";

struct tsim *packing_open(void)
{
	return deck_open("%s", packing);
}

void packing_close(struct tsim *sim)
{
	tsim_close(sim);
	ck_assert_int_eq(ts_alloc_balance(), 0);
}

void packing_same(struct tsim *a, struct tsim *b)
{
	static const char *const names[] = { "x", "y", "z", "vx", "vy", "vz", "fx", "fy", "fz" };
	size_t n = tsim_count(a);
	double *p = calloc(n, sizeof *p), *q = calloc(n, sizeof *q);

	ck_assert_uint_eq(n, tsim_count(b));
	for (size_t k = 0; k < DECK_LENGTH(names); k++) {
		ck_assert_int_eq(tsim_gather(a, names[k], NULL, p, n), 0);
		ck_assert_int_eq(tsim_gather(b, names[k], NULL, q, n), 0);
		ck_assert_msg(memcmp(p, q, n * sizeof *p) == 0, "%s differs", names[k]);
	}
	free(p);
	free(q);
}
