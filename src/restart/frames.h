/* Frames of text dumps (dump atom, dump custom), read back one after the other. */
#ifndef TS_RESTART_FRAMES_H
#define TS_RESTART_FRAMES_H

#include "core/sim.h"
#include "io/lines.h"

/* Zero-initialise. */
struct ts_frames {
	struct tsim *sim;
	struct ts_lines lines;
	struct ts_place where; /* blamed for frames that are not whole */
	bool more;	       /* `lines` stands at the beginning of a frame */
	bool begun, counted;   /* of the frame that is read: its step, its number of rows is known */
	bool cut;	       /* it is not whole */
	size_t rows;	       /* of it that were read */
	size_t whole, broken;  /* frames so far */
	/* the present frame */
	int64_t step;
	double lo[3], hi[3];
	size_t n, ncolumns;
	char **column; /* names */
	double *value; /* value[row * ncolumns + column]; NaN: no number */
	size_t column_capacity, value_capacity;
};

enum ts_status ts_frames_open(struct ts_frames *f, struct tsim *sim, const char *path,
			      const struct ts_place *where);
/* The next whole frame; *got is false after the last. Frames that are not whole, as a run leaves them that
 * was killed or had a full disk, are told in a warning and left out, at the end of the file and within
 * (where a later run has gone on); a file without any whole one is refused. */
enum ts_status ts_frames_next(struct ts_frames *f, bool *got);
void ts_frames_close(struct ts_frames *f);
/* Which column has this name, or -1. */
int ts_frames_column(const struct ts_frames *f, const char *name);

/* How a frame gets into the simulation. */
struct ts_frame_use {
	struct ts_words fields; /* x, vx, radius ...: what is taken */
	struct ts_words labels; /* pairs: field, name of its column */
	bool box;		/* the box becomes that of the frame */
	bool replace;		/* particles that are in both get the fields */
	bool trim;		/* those that are not in the frame go */
	bool purge;		/* all go before */
	bool add;		/* those that are only in the frame are made */
};
enum ts_status ts_frame_apply(struct tsim *sim, const struct ts_frames *f, const struct ts_frame_use *use,
			      const struct ts_place *where);

#endif
