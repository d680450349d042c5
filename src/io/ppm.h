/* PPM images: netpbm's format P6, 8 bits for each of red, green and blue, not compressed. */
#ifndef TS_IO_PPM_H
#define TS_IO_PPM_H

#include "core/sim.h"

/* As ts_png_write. */
enum ts_status ts_ppm_write(struct tsim *sim, const char *path, const struct ts_place *where, uint32_t width,
			    uint32_t height, const unsigned char *rgb);

#endif
