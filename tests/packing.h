/* A packing that falls on a floor, for tests of the library. */
#ifndef TESTS_PACKING_H
#define TESTS_PACKING_H

#include "tsim.h"

extern const char packing[];

struct tsim *packing_open(void);
/* Nothing may stay allocated. */
void packing_close(struct tsim *sim);
/* The test fails unless both have the same positions, velocities and forces, to the bit. */
void packing_same(struct tsim *a, struct tsim *b);

#endif
