/* Output of a program as frames: a row of the thermo output, the particles of a step of a dump, lines of an
 * averaging fix. For each number the printed digits are stored. */
#ifndef TS_CROSSCHECK_FRAME_H
#define TS_CROSSCHECK_FRAME_H

#include <stdbool.h>
#include <stdint.h>

#include "io/lines.h"

/* A word of an output. */
struct ts_printed {
	double value; /* if the word is not a number: its hash */
	int digits;   /* significant digits */
	int decimals; /* digits after the decimal point; -1: no point, no exponent */
	bool word;    /* not a number: a name, nan, inf */
	bool padded;  /* ends in a zero after the point, without exponent: a fixed format such as %.3f */
};
struct ts_printed ts_printed(const char *word);
bool ts_printed_is_number(const char *word);

struct ts_meanings;

enum ts_frame_kind {
	TS_FRAMES_THERMO, /* the thermo output on the screen */
	TS_FRAMES_DUMP,
	TS_FRAMES_VTK,	/* legacy VTK in ASCII */
	TS_FRAMES_TEXT, /* any other text with numbers */
};

/* How a number transforms if the two partners of a contact are exchanged. */
enum ts_swap_rule {
	TS_SWAP_INVARIANT,
	TS_SWAP_SIGN,	     /* changes sign, like the force */
	TS_SWAP_PARTNER,     /* exchanged with the column of the other partner */
	TS_SWAP_EITHER_SIGN, /* the sign depends on the contact law: history */
	TS_SWAP_UNKNOWN,     /* cannot be derived: a torque about the centre of one partner */
};

struct ts_frame {
	int64_t step;
	bool line; /* the output has no steps: `step` is the line number */
	const char **name;
	size_t columns, rows;
	struct ts_printed *cell; /* cell[row * columns + column] */
	bool entries;		 /* rows of a dump of local values, not of particles */
	size_t name_capacity, cell_capacity;
	/* Rows of contacts (meaning.h): rule of each column, and its column of the other partner; rows whose
	 * partners have been exchanged, so that the smaller identity is first. */
	bool has_contacts;
	enum ts_swap_rule *swap_rule;
	size_t *partner;
	bool *swapped;
	size_t swap_rule_capacity, partner_capacity, swapped_capacity;
};
/* Index of the column with this name, a string of the pool; SIZE_MAX: none. */
size_t ts_frame_column(const struct ts_frame *frame, const char *name);

#endif
