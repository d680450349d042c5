/* VTKHDF files (docs.vtk.org, VTK File Formats, version 2.0): an UnstructuredGrid whose frames are in one HDF5 file, which
 * ParaView from version 5.12 on opens as one series. Numbers of all frames stand behind each other in data sets with a row
 * for each point or cell; the group Steps says where those of a frame begin. */
#ifndef TS_IO_VTKHDF_H
#define TS_IO_VTKHDF_H

#include "io/vtk.h"

/* Adds the frame of the present step. A file that does not exist, or if `fresh`, is begun; stored frames of this step and
 * later ones, which a run continued from before has left, are removed. */
enum ts_status ts_vtkhdf_append(struct tsim *sim, const char *path, const struct ts_place *where,
				const struct ts_vtk_poly *poly, bool fresh);

#endif
