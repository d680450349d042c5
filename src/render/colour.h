/* Colours by name: the 140 names that LAMMPS has (those of CSS, some with other values), hexadecimal numbers, and names
 * that a script defines. */
#ifndef TS_RENDER_COLOUR_H
#define TS_RENDER_COLOUR_H

#include <stdbool.h>
#include <stddef.h>

#include "base/str.h"

/* Red, green, blue from 0 to 1, as they are stored in a file: no gamma correction. */
struct ts_colour {
	float c[3];
};

/* A name defined by a script; it goes before the predefined one. */
struct ts_colour_name {
	const char *name;
	struct ts_colour colour;
};

/* Zero-initialise. The array belongs to the caller. */
struct ts_palette {
	const struct ts_colour_name *own;
	size_t n;
};

/* Colour of a number 0xRRGGBB. */
struct ts_colour ts_colour_of_hex(unsigned rgb);
/* "0x6e7f80"; false: it is no such number. */
bool ts_colour_read_hex(const char *text, struct ts_colour *out);
/* Finds a name or a hexadecimal number. */
bool ts_colour_find(const struct ts_palette *palette, const char *name, struct ts_colour *out);
/* Offers all names as corrections. */
void ts_colour_suggest(const struct ts_palette *palette, struct ts_suggest *suggest);
/* The k-th colour of the sequence for types 1, 2, ..., which repeats after sixteen. */
struct ts_colour ts_colour_of_type(size_t k);
/* (1 - t) a + t b */
struct ts_colour ts_colour_mix(struct ts_colour a, struct ts_colour b, double t);

#endif
