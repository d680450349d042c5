/* Adding to an HDF5 file: it is opened, changed and closed as a whole (io/h5file.h), so that it can be read during a run,
 * and after one that was killed or has filled the disk. What the library tells of an error becomes one message. */
#ifndef TS_IO_H5OUT_H
#define TS_IO_H5OUT_H

#include "core/sim.h"
#include "io/h5file.h"

/* Whether tsim was built with the HDF5 library. */
bool ts_h5out_available(void);

#ifdef TS_WITH_HDF5
struct ts_h5out {
	struct tsim *sim;
	const char *path;
	const struct ts_place *where;
	struct ts_h5file h5;
	char reason[160]; /* innermost message of the library */
};

/* Adds to the open file f->h5.id; `created`: it is empty. */
typedef enum ts_status ts_h5out_fn(struct ts_h5out *f, bool created, const void *data);
/* Opens the file, creates it if there is none or `fresh`, calls `write` and closes it. The file has all of the changes,
 * or none after an error. */
enum ts_status ts_h5out_append(struct tsim *sim, const char *path, const struct ts_place *where, bool fresh,
			       ts_h5out_fn *write, const void *data);

/* The error of the last call of the library: "writing 'post/a.h5' failed: ...". */
enum ts_status ts_h5out_fail(struct ts_h5out *f, const char *what);

bool ts_h5out_exists(hid_t at, const char *name);
/* Opens a group, or creates it. */
hid_t ts_h5out_group(hid_t at, const char *name);
/* An attribute of n numbers, or one as a scalar for n = 0. */
bool ts_h5out_attribute(hid_t at, const char *name, hid_t type, hsize_t n, const void *value);
/* n texts of the same size, with their zeros; n 0: one, as a scalar. */
bool ts_h5out_texts(hid_t at, const char *name, hsize_t n, const char *text, size_t size);
bool ts_h5out_text(hid_t at, const char *name, const char *text);
#endif

#endif
