/* What all dumps share: when a frame is due, file names, columns, formats, order of rows. */
#ifndef TS_DUMP_DUMP_H
#define TS_DUMP_DUMP_H

#include "core/ref_list.h"
#include "core/sim.h"
#include "io/format.h"
#include "io/textfile.h"

/* One column of a dump of particles or of local rows. */
struct ts_dump_column {
	struct ts_ref_input input;
	bool index; /* number of the row; input has only name and place */
	bool integer;
	bool element; /* a name for the type */
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
	const char *variable; /* says the step of the next frame, instead of `every`; NULL: none */
	int64_t pad, delay;
	int64_t sort_by; /* 0: identity; k or -k: column k, up or down */
	bool unsorted, first, append, time, units;
	bool binary;	   /* of legacy VTK files */
	bool plain, image; /* of dump atom: positions as they are, image flags too */
	const char *label, *region, *refresh;
	struct ts_formats formats;
	struct ts_words element;
	struct ts_dump_threshold *threshold;
	size_t nthresholds;
	bool headless;	 /* header no: rows alone */
	size_t restored; /* columns of values of the last frame that a restart file gave back */
	char **old;	 /* names of the last frames, a ring */
	int64_t nold;
	/* workings */
	int64_t next; /* with a variable: step of the next frame, found anew by each run */
	struct ts_dump_column *column;
	size_t ncolumns;
	int32_t *order; /* rows in order of writing */
	size_t nrows, order_capacity;
	struct ts_textfile out;
	struct ts_str text, path;
};
#define TS_DUMP_ARGS(T)                                                                           \
	TS_INT("every", T, common.every, .flags = TS_POSITIONAL, .range = TS_POSITIVE,            \
	       .help = "steps between frames"),                                                   \
		TS_WORD("file", T, common.file, .flags = TS_POSITIONAL | TS_WRITES,               \
			.help = "name of the file; `*` stands for the step, one file per frame; " \
				"compressed if it ends in .gz")
#define TS_DUMP_SAVED(T) TS_SAVE_I64(T, common.last), TS_SAVE_I64(T, common.frames)

/* dump_modify: fields that were not given are negative, INT64_MIN or NULL. */
struct ts_dump_changes {
	struct ts_number every;
	int64_t pad, delay, nfile, fileper, maxfiles;
	/* -1, or 0 no, 1 yes */
	int first, append, flush, buffer, time, units, scale, image, pbc, binary, header;
	int compressor;
	const char *label, *sort, *region, *refresh;
	struct ts_words format, thresh, element;
};
enum ts_status ts_dump_modify(struct tsim *sim, struct ts_instance *dump,
			      const struct ts_dump_changes *changes, const struct ts_place *where);

/* A condition for particles to be written: value OPERATOR limit, or OPERATOR the value it had at the last
 * frame, which a column of particles keeps. */
struct ts_dump_threshold {
	struct ts_dump_column value;
	int operator;
	double limit;
	bool last;
	size_t column;
};
/* From triples of words; `none` forgets all before it. */
enum ts_status ts_dump_set_thresholds(struct ts_instance *self, struct tsim *sim, struct ts_words words);
/* For the slot archive of dumps of particles: the values at the last frame. */
enum ts_status ts_dump_archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *archive);
void ts_dump_release_thresholds(struct ts_dump_common *d);

/* One per-particle input by its name; `c->input` has name and place. */
enum ts_status ts_dump_make_column(struct ts_instance *self, struct tsim *sim, struct ts_dump_column *c,
				   bool local);
enum ts_status ts_dump_evaluate(struct ts_dump_column *c, struct tsim *sim);

/* Makes the columns from their words; `local`: index, c_ID[k], f_ID[k], else per-particle names. */
enum ts_status ts_dump_columns(struct ts_instance *self, struct tsim *sim, struct ts_words names, bool local);
/* Whether a frame must be written at this step; if so it counts as written. */
enum ts_status ts_dump_due(struct ts_instance *self, struct tsim *sim, bool *due);
/* Evaluates all columns, selects and sorts the rows. */
enum ts_status ts_dump_gather(struct ts_instance *self, struct tsim *sim, bool local);
/* Adds the rows to common.text and writes them; every item is followed by a blank, the last one only
 * if `trailing`. */
enum ts_status ts_dump_write_rows(struct ts_dump_common *d, struct tsim *sim, bool trailing);
/* Opens the file of this frame if it is not open. */
enum ts_status ts_dump_open(struct ts_instance *self, struct tsim *sim);
/* "ITEM: TIMESTEP ..." up to the bounds of the box. `what`: "ATOMS" or "ENTRIES". */
void ts_dump_header(struct ts_dump_common *d, struct tsim *sim, const char *what);
/* After a frame: all of it is with the system; closes a file of its own. */
enum ts_status ts_dump_frame_done(struct ts_dump_common *d, struct tsim *sim);
/* A whole frame of a text dump, if it is due: header, rows. */
enum ts_status ts_dump_frame(struct ts_instance *self, struct tsim *sim, bool local);
/* For -explain: how many frames of what size. */
enum ts_status ts_dump_price(struct ts_instance *self, struct tsim *sim, bool local, bool vtk,
			     struct ts_plan_report *report);
/* The same where the size of a frame is known. */
enum ts_status ts_dump_price_frame(struct ts_instance *self, struct tsim *sim, double bytes,
				   struct ts_plan_report *report);
void ts_dump_fini(struct ts_instance *self);

#endif
