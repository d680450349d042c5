/* A colour bar with numbers at an edge of a picture. */
#ifndef TS_RENDER_LEGEND_H
#define TS_RENDER_LEGEND_H

#include "render/colour_map.h"
#include "render/picture.h"

enum ts_legend_side { TS_LEGEND_RIGHT, TS_LEGEND_LEFT, TS_LEGEND_SIDES };

/* Draws the bar of the map for values from lo to hi. ink: colour of the letters and of the frame; ground: of what is
 * behind them, mostly over the scene. */
void ts_legend_draw(struct ts_picture *p, enum ts_legend_side side, const struct ts_colour_map *map,
		    double lo, double hi, const char *title, struct ts_colour ink, struct ts_colour ground);

#endif
