/* What all dumps share: when a frame is due, file names, columns, formats, order of rows. */
#ifndef TS_IO_DUMP_H
#define TS_IO_DUMP_H

#include "core/ref_list.h"
#include "core/sim.h"
#include "io/format.h"
#include "io/textfile.h"

/* One column of a dump of particles or of local rows. */
struct ts_dump_column {
	struct ts_ref_input input;
	bool index; /* number of the row; input has only name and place */
	bool integer;
	char format[TS_FORMAT_SIZE];
	struct ts_table values; /* one column, a row per particle or local row */
};

/* First member of the state of every dump. */
struct ts_dump_common {
	int64_t every;	  /* argument */
	const char *file; /* argument */
	int64_t last;	  /* saved: step of the last frame */
	int64_t frames;	  /* saved: how many were written */
	/* dump_modify */
	int64_t pad;
	bool unsorted, first, append;
	const char *label;
	char float_format[TS_FORMAT_SIZE], int_format[TS_FORMAT_SIZE];
	struct ts_words line_format;
	/* workings */
	struct ts_dump_column *column;
	size_t ncolumns;
	int32_t *order; /* rows in order of writing */
	size_t nrows, order_capacity;
	struct ts_textfile out;
	struct ts_str text, path;
};
#define TS_DUMP_ARGS(T)                                                                            \
	TS_INT("every", T, common.every, .flags = TS_POSITIONAL, .range = TS_POSITIVE,             \
	       .help = "steps between frames"),                                                    \
		TS_WORD("file", T, common.file, .flags = TS_POSITIONAL | TS_WRITES,                            \
			.help = "name of the file; `*` stands for the step, one file per frame; "  \
				"compressed if it ends in .gz")
#define TS_DUMP_SAVED(T) TS_SAVE_I64(T, common.last), TS_SAVE_I64(T, common.frames)

/* dump_modify: fields that were not given are negative, INT64_MIN or NULL. */
struct ts_dump_changes {
	int64_t every, pad;
	int sort, first, append, format_kind; /* 0 none or no, 1 id or yes; enum ts_dump_format */
	const char *label, *format;
};
enum ts_dump_format { TS_DUMP_FORMAT_FLOAT, TS_DUMP_FORMAT_INT, TS_DUMP_FORMAT_LINE };
enum ts_status ts_dump_modify(struct tsim *sim, struct ts_instance *dump,
			      const struct ts_dump_changes *changes, const struct ts_place *where);

/* Makes the columns from their words; `local`: index, c_ID[k], f_ID[k], else per-particle names. */
enum ts_status ts_dump_columns(struct ts_instance *self, struct tsim *sim, struct ts_words names,
			       bool local);
/* Whether a frame must be written at this step; if so it counts as written. */
bool ts_dump_due(struct ts_instance *self, struct tsim *sim);
/* Evaluates all columns, selects and sorts the rows. */
enum ts_status ts_dump_gather(struct ts_instance *self, struct tsim *sim, bool local);
/* Adds the rows to common.text and writes them; every item is followed by a blank. */
enum ts_status ts_dump_write_rows(struct ts_dump_common *d, struct tsim *sim);
/* Opens the file of this frame if it is not open. */
enum ts_status ts_dump_open(struct ts_instance *self, struct tsim *sim);
/* "ITEM: TIMESTEP ..." up to the bounds of the box. `what`: "ATOMS" or "ENTRIES". */
void ts_dump_header(struct ts_dump_common *d, struct tsim *sim, const char *what);
/* After a frame: all of it is with the system; closes a file of its own. */
enum ts_status ts_dump_frame_done(struct ts_dump_common *d);
/* A whole frame of a text dump, if it is due: header, rows. */
enum ts_status ts_dump_frame(struct ts_instance *self, struct tsim *sim, bool local);
void ts_dump_fini(struct ts_instance *self);

#endif
