/* PNG images, 8 bits for each of red, green and blue: ISO/IEC 15948. Compressed by zlib. */
#ifndef TS_IO_PNG_H
#define TS_IO_PNG_H

#include "core/sim.h"

/* Appends the bytes of a file. Returns TS_OK or TS_NOMEM. */
enum ts_status ts_png_encode(uint32_t width, uint32_t height, const unsigned char *rgb, struct ts_str *out);

/* Writes a file, which replaces an existing one when it is complete. rgb[(row width + column) 3 + colour], the first row
 * is the upper one. */
enum ts_status ts_png_write(struct tsim *sim, const char *path, const struct ts_place *where, uint32_t width,
			    uint32_t height, const unsigned char *rgb);

#endif
