#include "particles/lattice.h"

#include <stddef.h>

#include "base/banned.h"

#define SQRT3 1.7320508075688772
#define SQRT_8_3 1.632993161855452

enum { SC, BCC, FCC, HCP, DIAMOND, SQ, SQ2, HEX, NLATTICE };

const char *const ts_lattice_names[] = { "sc", "bcc", "fcc", "hcp",  "diamond",
					 "sq", "sq2", "hex", "none", NULL };

static const struct ts_lattice lattices[NLATTICE] = {
	[SC] = { 3, { 1, 1, 1 }, 1, { { 0, 0, 0 } } },
	[BCC] = { 3, { 1, 1, 1 }, 2, { { 0, 0, 0 }, { 0.5, 0.5, 0.5 } } },
	[FCC] = { 3,
		  { 1, 1, 1 },
		  4,
		  { { 0, 0, 0 }, { 0.5, 0.5, 0 }, { 0.5, 0, 0.5 }, { 0, 0.5, 0.5 } } },
	[HCP] = { 3,
		  { 1, SQRT3, SQRT_8_3 },
		  4,
		  { { 0, 0, 0 }, { 0.5, 0.5, 0 }, { 0.5, 5. / 6, 0.5 }, { 0, 1. / 3, 0.5 } } },
	[DIAMOND] = { 3,
		      { 1, 1, 1 },
		      8,
		      { { 0, 0, 0 },
			{ 0, 0.5, 0.5 },
			{ 0.5, 0, 0.5 },
			{ 0.5, 0.5, 0 },
			{ 0.25, 0.25, 0.25 },
			{ 0.25, 0.75, 0.75 },
			{ 0.75, 0.25, 0.75 },
			{ 0.75, 0.75, 0.25 } } },
	[SQ] = { 2, { 1, 1, 1 }, 1, { { 0, 0, 0 } } },
	[SQ2] = { 2, { 1, 1, 1 }, 2, { { 0, 0, 0 }, { 0.5, 0.5, 0 } } },
	[HEX] = { 2, { 1, SQRT3, 1 }, 2, { { 0, 0, 0 }, { 0.5, 0.5, 0 } } },
};

const struct ts_lattice *ts_lattice_get(int style)
{
	return style >= 0 && style < NLATTICE ? &lattices[style] : NULL;
}
