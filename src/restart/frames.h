/* Reader of text dumps (dump atom, dump custom), frame by frame. */
#ifndef TS_RESTART_FRAMES_H
#define TS_RESTART_FRAMES_H

#include "core/sim.h"
#include "io/lines.h"

/* Zero-initialise. */
struct ts_frames {
	struct tsim *sim;
	struct ts_lines lines;
	struct ts_place where; /* named in warnings about incomplete frames */
	bool more;	       /* `lines` is at the first line of a frame */
	bool begun, counted;   /* current frame: its step and its number of rows were read */
	bool cut;	       /* it is incomplete */
	size_t rows;	       /* rows of it that were read */
	size_t whole, broken;  /* number of complete and incomplete frames so far */
	/* the current frame */
	int64_t step;
	double lo[3], hi[3]; /* box (length) */
	size_t n, ncolumns;  /* rows, columns */
	char **column;	     /* [ncolumns] names */
	double *value;	     /* [n][ncolumns]; NaN: not a number */
	size_t column_capacity, value_capacity;
};

enum ts_status ts_frames_open(struct ts_frames *f, struct tsim *sim, const char *path,
			      const struct ts_place *where);
/* Reads the next complete frame; *got is false after the last. Incomplete frames, as left by a run that was
 * killed or had a full disk, are skipped with a warning, at the end of the file or within it (if a later run
 * has appended to it); a file without any complete frame is an error. */
enum ts_status ts_frames_next(struct ts_frames *f, bool *got);
void ts_frames_close(struct ts_frames *f);
/* Index of the column of this name, or -1. */
int ts_frames_column(const struct ts_frames *f, const char *name);

/* How a frame is entered in the simulation: arguments of read_dump and rerun. */
struct ts_frame_use {
	struct ts_words fields; /* quantities to set: x, vx, radius ... */
	struct ts_words labels; /* pairs: quantity, name of its column */
	bool box;		/* set the box */
	bool replace;		/* set the quantities of existing particles */
	bool trim;		/* delete particles that are not in the frame */
	bool purge;		/* delete all particles first */
	bool add;		/* create particles that are only in the frame */
};
enum ts_status ts_frames_apply(struct tsim *sim, const struct ts_frames *f, const struct ts_frame_use *use,
			       const struct ts_place *where);

#endif
