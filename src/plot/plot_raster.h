/* Plots as pictures of pixels, with smooth edges, on white. Letters are those of render/letters.h with their dots joined by
 * strokes: ASCII, raised digits; of other signs the nearest ASCII ones are shown. */
#ifndef TS_PLOT_PLOT_RASTER_H
#define TS_PLOT_PLOT_RASTER_H

#include "plot/plot.h"
#include "render/picture.h"

/* Draws into a zero-initialised picture with `scale` pixels to a unit, at least 1. The caller releases it, also after
 * an error: TS_NOMEM, or TS_RANGE if it would have more than TS_PICTURE_EDGE pixels along an edge. */
enum ts_status ts_plot_raster(const struct ts_plot *plot, double scale, struct ts_picture *out);
/* Several plots in one picture, so many in a row. n >= 1. */
enum ts_status ts_plot_raster_panels(const struct ts_plot *plot, size_t n, size_t columns, double scale,
				     struct ts_picture *out);

#endif
