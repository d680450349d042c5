/* Text of legacy VTK files in the layout that VTK 9 has, and LIGGGHTS with it: version 5.1, nine numbers
 * in a line. Memory that runs out shows in out->failed. */
#ifndef TS_IO_VTK_LEGACY_H
#define TS_IO_VTK_LEGACY_H

#include "io/vtk.h"

void ts_vtk_legacy_poly(struct ts_str *out, const struct ts_vtk_poly *poly);
/* Points alone, as text of version 2.0: their data as SCALARS and VECTORS, a line for each point. So
 * LIGGGHTS writes cells of fix ave/euler. */
void ts_vtk_legacy_plain(struct ts_str *out, const struct ts_vtk_poly *poly);
/* The simulation box, a grid of one cell. */
void ts_vtk_legacy_box(struct ts_str *out, const double lo[3], const double hi[3], double time, bool binary);

#endif
