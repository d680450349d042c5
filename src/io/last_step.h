/* Files that a continued run appends to. A run that was killed has often written more than its last restart file knows: the rows
 * behind that step are written again, and readers would count them twice. */
#ifndef TS_IO_LAST_STEP_H
#define TS_IO_LAST_STEP_H

#include "io/textfile.h"

enum ts_step_form {
	TS_STEP_ROWS,	/* each row begins with the step */
	TS_STEP_BLOCKS, /* a line begins with the step, the next ones with 1, 2, 3 ... */
	TS_STEP_FRAMES	/* frames of a dump of text */
};

/* After a file has been opened, and before something is written, at step `first` or later: warns if the simulation continues from
 * a restart file and the file has rows of this step or of later ones already. A compressed file is not looked at. */
void ts_last_step_warn(const struct ts_textfile *file, struct tsim *sim, enum ts_step_form form,
		       int64_t first);
/* Whether the line begins with this step. */
bool ts_last_step_begins(const char *line, int64_t step);

#endif
