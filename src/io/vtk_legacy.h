/* Text of legacy VTK files, version 5.1, in the layout of VTK 9, which LIGGGHTS uses: nine numbers in a
 * line. If memory runs out, out->failed is set. */
#ifndef TS_IO_VTK_LEGACY_H
#define TS_IO_VTK_LEGACY_H

#include "io/vtk.h"

/* All ranks call it; the text is that of the first one. */
enum ts_status ts_vtk_legacy_poly(struct tsim *sim, struct ts_str *out, const struct ts_vtk_poly *poly);
/* Points only, as text of version 2.0 with SCALARS and VECTORS, a line for each point: the format of
 * LIGGGHTS for cells of fix ave/euler. */
void ts_vtk_legacy_plain(struct ts_str *out, const struct ts_vtk_poly *poly);
/* The simulation box as a rectilinear grid of one cell. */
void ts_vtk_legacy_box(struct ts_str *out, const double lo[3], const double hi[3], double time, bool binary);

#endif
