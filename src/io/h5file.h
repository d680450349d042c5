/* HDF5 files that change as a whole: what is added goes behind the contents at once, while changes of the contents are
 * held in memory until the library has closed the file without an error. A run that is killed before leaves the contents
 * as they were, with unused bytes behind them; after an error, such as of a full disk, the file is cut off there. */
#ifndef TS_IO_H5FILE_H
#define TS_IO_H5FILE_H

#ifdef TS_WITH_HDF5
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

#include "io/h5library.h"

/* Zero-initialise. */
struct ts_h5file {
	FILE *file;
	hid_t id;	 /* of the file in the library */
	hid_t driver;	 /* of the library for this file */
	uint64_t before; /* bytes of contents before the changes */
	uint64_t size;	 /* bytes of the file */
	uint64_t end;	 /* bytes of the contents with the changes */
	int error;	 /* errno of the first failure; later writes are ignored */
	struct ts_h5file_change {
		uint64_t at;
		size_t n;
		unsigned char *byte;
	} * change; /* [nchanges] in the order of writing */
	size_t nchanges, capacity;
};

/* `file` is open for reading and writing, and empty if `create`; it is closed by ts_h5file_close, also after a failure.
 * Returns f->id, negative after a failure. */
hid_t ts_h5file_open(struct ts_h5file *f, FILE *file, const char *path, bool create);
/* Closes everything that is open in the file. `keep`: makes the changes, unless there was a failure. Returns whether the
 * file has them; f->error tells why not, if the reason is one of the system. */
bool ts_h5file_close(struct ts_h5file *f, bool keep);
#endif

#endif
