/* The keywords of dump_modify as rows of an argument table, for a state with a struct ts_dump_changes as
 * member `changes`. */
#ifndef TS_DUMP_DUMP_MODIFY_H
#define TS_DUMP_DUMP_MODIFY_H

#include "dump/dump.h"

extern const char *const ts_dump_answers[], *const ts_dump_compressors[];

#define TS_DUMP_ANSWER(T, name, field, help_) \
	TS_ENUM(name, T, changes.field, ts_dump_answers, .flags = TS_OPTIONAL, .help = help_)
#define TS_DUMP_COUNT(T, name, field, least, most, help_)                                                 \
	TS_INT(name, T, changes.field, .flags = TS_OPTIONAL, .range = TS_WITHIN, .lo = least, .hi = most, \
	       .help = help_)
#define TS_DUMP_WORDS(T, name_, field, flags_, help_)                                                \
	{                                                                                            \
		.name = name_, .type = TS_ARG_REST, .flags = TS_OPTIONAL | TS_TO_KEYWORD | (flags_), \
		.offset = TS_FIELD(T, changes.field, struct ts_words *), .help = help_               \
	}
/* Keywords that only some styles have, which read them in their slot `modify`. */
#define TS_DUMP_PICTURE(T, name_, help_) \
	TS_DUMP_WORDS(T, name_, picture, TS_REPEAT | TS_NAMED, "dump image, movie: " help_)

/* clang-format off */
#define TS_DUMP_MODIFY_ROWS(T)                                                                  \
	TS_NUMBER("every", T, changes.every, .flags = TS_OPTIONAL, .range = TS_POSITIVE,        \
		  .help = "steps between frames, or a variable that evaluates to the step of the next one"), \
	TS_WORD("sort", T, changes.sort, .flags = TS_OPTIONAL,                                  \
		.help = "order of rows: id (default), off (that in memory), N or -N (column N, ascending " \
			"or descending)"),                                                      \
	TS_DUMP_WORDS(T, "thresh", thresh, TS_REPEAT,                                           \
	      "quantity, one of < <= > >= == != |^, and a number or LAST (its value at the last frame; no " \
	      "particle is written in the first one): only particles that meet all conditions; none " \
	      "removes them"),                                           \
	TS_WORD("region", T, changes.region, .flags = TS_OPTIONAL,                              \
		.help = "only particles whose centres are in the region; none: all"),           \
	TS_DUMP_WORDS(T, "format", format, TS_REPEAT,                                           \
	      "format of numbers: float F, int F, the number of a column and F, line \"F F ...\" " \
	      "with one for each column, or none for the defaults; F is a C format such as %.15g"), \
	TS_DUMP_COUNT(T, "pad", pad, 0, 20, "digits of the step in file names, with leading zeros"), \
	TS_DUMP_ANSWER(T, "first", first, "write a frame at the start of the next run whatever the step"), \
	TS_DUMP_COUNT(T, "delay", delay, 0, 9e15, "no frame before this step"),                 \
	TS_DUMP_ANSWER(T, "append", append, "append to an existing file instead of replacing it"), \
	TS_WORD("label", T, changes.label, .flags = TS_OPTIONAL,                                \
		.help = "text of an additional ITEM: LABEL of each frame; dump local: instead of "  \
			"ENTRIES"),                                                             \
	TS_DUMP_ANSWER(T, "time", time, "an additional ITEM: TIME of each frame"),              \
	TS_DUMP_ANSWER(T, "units", units, "an additional ITEM: UNITS of the first frame"),      \
	TS_DUMP_COUNT(T, "maxfiles", maxfiles, -1, 1000000,                                     \
	      "number of latest files to keep, with one file per frame; -1: all"),              \
	TS_DUMP_WORDS(T, "element", element, 0, "names of the types, for the column element and for dump " \
						"xyz"), \
	TS_DUMP_ANSWER(T, "scale", scale, "dump atom: positions scaled from 0 to 1 across the box " \
					  "(default)"), \
	TS_DUMP_ANSWER(T, "image", image, "dump atom: write image flags"),                      \
	TS_WORD("refresh", T, changes.refresh, .flags = TS_OPTIONAL,                            \
		.help = "c_ID of a compute displace/atom whose reference is renewed after each frame, as " \
			"its own keywords say"),                                                \
	TS_DUMP_ANSWER(T, "header", header, "write the ITEM lines of each frame (default)"),    \
	TS_DUMP_ANSWER(T, "buffer", buffer, "no effect: output is always buffered"),            \
	TS_ENUM("compressor", T, changes.compressor, ts_dump_compressors, .flags = TS_OPTIONAL, \
		.help = "no effect: VTK files are compressed with zlib"),                       \
	TS_DUMP_ANSWER(T, "flush", flush, "no effect: the file is flushed after each frame"),   \
	TS_DUMP_ANSWER(T, "pbc", pbc, "no effect: positions are wrapped when the neighbor list is built"), \
	TS_DUMP_ANSWER(T, "binary", binary, "binary instead of text in .vtk files; other VTK files are " \
					    "always binary"),      \
	TS_DUMP_COUNT(T, "fileper", fileper, 1, 1000000, "no effect: all ranks write one file"),    \
	TS_DUMP_COUNT(T, "nfile", nfile, 1, 1000000, "no effect: all ranks write one file"), \
	TS_DUMP_PICTURE(T, "acolor", \
			"TYPE COLOR: color of a type or a range of types; red/green/blue ...: in turn"), \
	TS_DUMP_PICTURE(T, "adiam", "TYPE DIAMETER of a type or a range of types (length)"), \
	TS_DUMP_PICTURE(T, "amap", \
			"LO HI STYLE DELTA N ENTRIES: map from numbers to colors, with " \
			"the range LO..HI (min, max: that of the frame). STYLE: c continuous, d discrete, " \
			"s sequential, then a: values or f: fractions of the range. DELTA: width of the " \
			"bins of s. N entries: VALUE COLOR, LO HI COLOR, or COLOR. Or LO HI and one " \
			"of viridis, coolwarm, gray"), \
	TS_DUMP_PICTURE(T, "atrans", \
			"TYPE T: opacity of a type or a range of types, from 0, invisible, to 1, opaque"), \
	TS_DUMP_PICTURE(T, "backcolor", "color of the background (black)"), \
	TS_DUMP_PICTURE(T, "backcolor2", "color of its upper edge, for a gradient; none"), \
	TS_DUMP_PICTURE(T, "bcolor", "TYPE COLOR, as acolor, of bonds"), \
	TS_DUMP_PICTURE(T, "bdiam", "TYPE DIAMETER, as adiam, of bonds"), \
	TS_DUMP_PICTURE(T, "bitrate", "kbit/s of movies (chosen by the encoder)"), \
	TS_DUMP_PICTURE(T, "bmap", "as amap, for bonds"), \
	TS_DUMP_PICTURE(T, "boxcolor", "color of the edges of the box (gold)"), \
	TS_DUMP_PICTURE(T, "cmap", "as amap, for forces of contacts"), \
	TS_DUMP_PICTURE(T, "color", \
			"NAME R G B or NAME 0xRRGGBB: defines a color; numbers from 0 to 1"), \
	TS_DUMP_PICTURE(T, "framerate", "frames per second of movies (24)"), \
	TS_DUMP_PICTURE(T, "gmap", "as amap, for slices of the fluid"), \
	TS_DUMP_PICTURE(T, "lights", "AMBIENT KEY FILL BACK: lights from 0 to 1 (0 0.9 0.45 0.9)"), \
	TS_DUMP_PICTURE(T, "smap", "as amap, for surfaces")
/* clang-format on */

#endif
