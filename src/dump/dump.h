/* Shared by all dumps: steps at which a frame is due, file names, columns, formats, selection and order of
 * rows. */
#ifndef TS_DUMP_DUMP_H
#define TS_DUMP_DUMP_H

#include "core/ref_list.h"
#include "core/sim.h"
#include "io/format.h"
#include "io/textfile.h"
#include "particle/quantity.h"

/* One column of a dump of particles or of local rows. */
struct ts_dump_column {
	struct ts_ref_input input;
	size_t number; /* as written in the script, from 1: dumps may have another order */
	bool index;    /* column `index`: number of the row; input has only name and place */
	bool integer;  /* written with an integer format */
	bool element;  /* column `element`: name of the type */
	char format[TS_FORMAT_SIZE];
	struct ts_table values; /* a row for each particle or local row */
	ts_quantity_fn *direct; /* evaluated row by row instead; or NULL */
};

/* First member of the state of every dump. */
struct ts_dump_common {
	/* arguments */
	int64_t every;	  /* N: steps between frames */
	const char *file; /* `*` stands for the step */
	/* state, written to restart files */
	int64_t last;	/* step of the last frame */
	int64_t frames; /* number of frames written */
	/* keywords of dump_modify */
	const char *variable; /* `every v_NAME`: evaluates to the step of the next frame; NULL: `every N` */
	int64_t pad, delay;   /* digits of the step in file names; first step of frames */
	int64_t sort_by;      /* 0: sorted by particle id; k or -k: by column k, ascending or descending */
	bool unsorted, first, append, time, units;
	bool binary;			      /* dumps .../vtk: legacy files in binary format */
	bool plain, image;		      /* dump atom: unscaled positions; with image flags */
	const char *label, *region, *refresh; /* names; NULL: none */
	struct ts_formats formats;
	struct ts_words element;	     /* names of the types */
	struct ts_dump_threshold *threshold; /* [nthresholds] conditions; all must hold */
	size_t nthresholds;
	bool headless; /* `header no`: rows only */
	bool single;   /* the only frame of its file, as with `*` in the name */
	bool in_order; /* its file has frames in the order of their steps: a frame replaces those of later steps */
	bool once;	 /* of write_dump: due whatever `every` and `delay` say */
	size_t restored; /* number of LAST columns read from a restart file */
	char **old;	 /* [nold] `maxfiles`: ring buffer of names of the latest files */
	int64_t nold;
	/* not saved */
	int64_t next;	 /* with `variable`: step of the next frame */
	int64_t planned; /* -explain: one more than the last step of the runs before; 0: there are none */
	struct ts_dump_column *column; /* [ncolumns] */
	size_t ncolumns;
	bool local;	/* rows of c_ID and f_ID, not particles */
	int32_t *order; /* [nrows] indices of particles or local rows in the order of writing */
	size_t nrows, order_capacity;
	struct ts_textfile out;
	struct ts_str text, path; /* of the current frame */
};
#define TS_DUMP_ARGS(T)                                                                                \
	TS_INT("every", T, common.every, .flags = TS_POSITIONAL, .range = TS_POSITIVE,                 \
	       .help = "steps between frames"),                                                        \
		TS_WORD("file", T, common.file, .flags = TS_POSITIONAL | TS_WRITES,                    \
			.help = "name of the file; `*` stands for the step, one file per frame; "      \
				"compressed if it ends in .gz; all ranks write one file together, so " \
				"that `%` is a letter like others")
/* Keywords of dump_modify that choose and order particles: part of dump_words of a style. */
#define TS_DUMP_SELECTION "sort thresh region"
#define TS_DUMP_SAVED(T) TS_SAVE_I64(T, common.last), TS_SAVE_I64(T, common.frames)

/* Arguments of dump_modify. Keywords that are not given are -1 (enums), INT64_MIN or NULL. */
struct ts_dump_changes {
	struct ts_number every;
	int64_t pad, delay, nfile, fileper, maxfiles;
	/* 0: no; 1: yes */
	int first, append, flush, buffer, time, units, scale, image, pbc, binary, header;
	int compressor;
	const char *label, *sort, *region, *refresh;
	struct ts_words format, thresh, element;
	struct ts_words picture; /* keywords of dumps image and movie with their values, as written */
};
enum ts_status ts_dump_modify(struct tsim *sim, struct ts_instance *dump,
			      const struct ts_dump_changes *changes, const struct ts_place *where);
/* The same from keywords as written; `what` is the name of their owner for messages. */
enum ts_status ts_dump_modify_words(struct tsim *sim, const char *what, struct ts_instance *dump,
				    struct ts_words words, struct ts_arena *arena,
				    const struct ts_place *where);

/* Condition for a particle to be written: value OPERATOR limit, or value OPERATOR its value at the last frame
 * (LAST). */
struct ts_dump_threshold {
	struct ts_dump_column value;
	int operator;
	double limit;
	bool last;
	size_t column; /* LAST: column of the particles with the value at the last frame */
};
/* Adds conditions from triples of words; `none` removes the previous ones. */
enum ts_status ts_dump_set_thresholds(struct ts_instance *self, struct tsim *sim, struct ts_words words);
/* Slot `archive` of dumps of particles: saves the values at the last frame that LAST refers to. */
enum ts_status ts_dump_archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *archive);
void ts_dump_release_thresholds(struct ts_dump_common *d);

/* Resolves the name of a column in c->input.name. */
enum ts_status ts_dump_make_column(struct ts_instance *self, struct tsim *sim, struct ts_dump_column *c,
				   bool local);
/* Evaluates c->values for all particles or local rows. */
enum ts_status ts_dump_evaluate(struct ts_dump_column *c, struct tsim *sim);

/* Makes the columns of a dump from their names; `local`: index, c_ID[k], f_ID[k], else per-particle names. */
enum ts_status ts_dump_columns(struct ts_instance *self, struct tsim *sim, struct ts_words names, bool local);
/* *due: a frame must be written at this step; it is counted as written. */
enum ts_status ts_dump_due(struct ts_instance *self, struct tsim *sim, bool *due);
/* Slot `due`: whether a frame may be due at this step. */
bool ts_dump_may_be_due(const struct ts_instance *self, const struct tsim *sim);
/* Slot `names`: what dump_modify has given. */
void ts_dump_names(const struct ts_instance *self, void (*tell)(void *data, const char *text), void *data);
/* Evaluates all columns, selects and sorts the rows. */
enum ts_status ts_dump_gather(struct ts_instance *self, struct tsim *sim, bool local);
/* The same for dumps of particles that need the values only row by row: ts_dump_value. */
enum ts_status ts_dump_gather_rows(struct ts_instance *self, struct tsim *sim);
double ts_dump_value(const struct tsim *sim, const struct ts_dump_column *c, size_t i);
/* Adds the value of a column by its format; that of the column `element` is the name of a type. */
void ts_dump_add_item(const struct ts_dump_common *d, struct ts_str *out, const struct ts_dump_column *c,
		      double value);
/* Writes the rows, items separated by blanks; `trailing`: with a blank at the end of a line, too. */
enum ts_status ts_dump_write_rows(struct ts_dump_common *d, struct tsim *sim, bool trailing);
/* The same as rows of comma-separated values that begin with the step. */
enum ts_status ts_dump_write_table(struct ts_dump_common *d, struct tsim *sim);
/* Opens the file of this frame if it is not open. */
enum ts_status ts_dump_open(struct ts_instance *self, struct tsim *sim);
/* Adds the ITEM lines of a frame to common.text. `local`: of ENTRIES, or what `label` says, otherwise of ATOMS. */
void ts_dump_header(struct ts_dump_common *d, struct tsim *sim, bool local);
/* `maxfiles`: remembers common.path, the file of this frame, and removes that of the oldest one. */
enum ts_status ts_dump_keep_latest(struct ts_dump_common *d, struct tsim *sim);
/* Flushes the file after a frame; closes it if there is one file per frame. */
enum ts_status ts_dump_frame_done(struct ts_dump_common *d, struct tsim *sim);
/* Writes a frame of a text dump, header and rows, if it is due. */
enum ts_status ts_dump_frame(struct ts_instance *self, struct tsim *sim, bool local);
/* Reports number and estimated size (bytes) of frames for -explain; `vtk`: compressed VTK file, else text. */
enum ts_status ts_dump_price(struct ts_instance *self, struct tsim *sim, bool local, bool vtk,
			     struct ts_plan_report *report);
/* Slot `plan` of dumps of particles as text. */
enum ts_status ts_dump_plan(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report);
/* The same for a known size of a frame. */
enum ts_status ts_dump_price_frame(struct ts_instance *self, struct tsim *sim, double bytes,
				   struct ts_plan_report *report);
void ts_dump_fini(struct ts_instance *self);

#endif
