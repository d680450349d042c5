/* What a program wrote, frame by frame: rows of a table of thermodynamic output, particles of a dump, lines
 * of an averaging fix. Numbers remember how finely they were printed. */
#ifndef TS_CROSSCHECK_FRAME_H
#define TS_CROSSCHECK_FRAME_H

#include <stdbool.h>
#include <stdint.h>

#include "io/lines.h"

/* A word of an output. */
struct ts_printed {
	double value; /* of a word that is no number: one that differs where the word does */
	int digits;   /* significant ones */
	int decimals; /* behind the point; -1: no point, no exponent */
	bool padded;  /* ends in a zero behind the point, without exponent: a fixed format such as %.3f */
};
struct ts_printed ts_printed(const char *word);
bool ts_printed_is_number(const char *word);

struct ts_meanings;

enum ts_frame_kind {
	TS_FRAMES_THERMO, /* the tables on the screen */
	TS_FRAMES_DUMP,
	TS_FRAMES_VTK,	/* legacy VTK as text */
	TS_FRAMES_TEXT, /* any other text with numbers */
};

/* What becomes of a number when the partners of a contact change their places. */
enum ts_turning {
	TS_TURN_SAME,
	TS_TURN_SIGN,	/* it changes its sign, as the force */
	TS_TURN_SWAP,	/* another column has that of the other partner */
	TS_TURN_EITHER, /* its sign depends on the law: memory of the contact */
	TS_TURN_NOT,	/* it cannot be known: a torque about the centre of one partner */
};

struct ts_frame {
	int64_t step;
	bool line; /* no step is known: it is the number of the line */
	const char **name;
	size_t columns, rows;
	struct ts_printed *cell; /* cell[row * columns + column] */
	bool entries;		 /* rows of a dump that is not of particles */
	size_t name_capacity, cell_capacity;
	/* Rows of contacts, meaning.h: what each column does, and which rows named the partners the other
	 * way round. */
	bool turns;
	enum ts_turning *turning;
	size_t *partner;
	bool *turned;
	size_t turning_capacity, partner_capacity, turned_capacity;
};
/* Which column has the name; SIZE_MAX: none. Names are those of the string pool. */
size_t ts_frame_column(const struct ts_frame *frame, const char *name);

#endif
