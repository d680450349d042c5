/* Text of legacy VTK files, version 3.0. Memory that runs out shows in out->failed. */
#ifndef TS_IO_VTK_LEGACY_H
#define TS_IO_VTK_LEGACY_H

#include "io/vtk.h"

/* The first three lines; DATASET follows. */
void ts_vtk_legacy_begin(struct ts_str *out, double time, bool binary);
void ts_vtk_legacy_poly(struct ts_str *out, const struct ts_vtk_poly *poly, bool binary);
/* The simulation box, a grid of one cell. */
void ts_vtk_legacy_box(struct ts_str *out, const double lo[3], const double hi[3], double time);

#endif
