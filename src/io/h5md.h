/* H5MD files (de Buyl, Colberg, Hoefling 2014, Comput. Phys. Commun. 185, 1546; version 1.1): trajectories of groups of
 * particles in one HDF5 file. Each frame is appended by opening the file and closing it again (io/h5file.h), so that it can
 * be read during the run and after it was killed or has filled the disk, with all frames before. Without the HDF5 library nothing can be written. */
#ifndef TS_IO_H5MD_H
#define TS_IO_H5MD_H

#include "core/sim.h"

/* A quantity: /particles/GROUP/NAME/value, of shape [frames][n] or, with several components, [frames][n][components]. */
struct ts_h5md_element {
	const char *name;
	const double *data; /* [n][components] */
	size_t components;
	bool integer; /* stored in 4 bytes; particles that a frame does not have are -1, else NaN */
	bool apart;   /* not in all frames: it has steps and times of its own */
};

struct ts_h5md_frame {
	const char *group, *author;
	int64_t step;
	double time;	    /* [time] */
	double edges[3][3]; /* vectors of the box (length) */
	double offset[3];   /* its lower corner (length) */
	bool sheared;	    /* edges is not diagonal */
	bool periodic[3];
	size_t n;			       /* particles */
	const struct ts_h5md_element *element; /* [nelements]; the first is in all frames */
	size_t nelements;
};

/* Adds a frame to the group of the file, which is created if it does not exist or if it is `fresh`. Stored frames of this
 * step and later ones, left by a run that was continued from before, are removed. */
enum ts_status ts_h5md_append(struct tsim *sim, const char *path, const struct ts_place *where,
			      const struct ts_h5md_frame *frame, bool fresh);

#endif
