/* Compression of the sections of restart files. */
#ifndef TS_RESTART_PACK_H
#define TS_RESTART_PACK_H

#include <stdbool.h>
#include <stddef.h>

#include "base/status.h"

/* Compresses the bytes as one stream of zlib and gives it to `put`, piece by piece. Pieces that hardly become shorter,
 * such as most columns of real numbers, are stored as they are, so that files are written and read about as fast as a disk
 * allows. TS_NOMEM: zlib found no memory; otherwise what `put` returned. */
enum ts_status ts_pack(const unsigned char *bytes, size_t n,
		       enum ts_status (*put)(void *data, const void *bytes, size_t n), void *data);

/* The reverse, of a stream that comes in pieces. */
struct ts_unpack;
struct ts_unpack *ts_unpack_begin(void *to, size_t n); /* NULL: out of memory */
/* The same, of which `take` gets the n bytes in pieces; its failure ends the stream. */
typedef enum ts_status ts_unpack_take_fn(void *data, const unsigned char *bytes, size_t n);
struct ts_unpack *ts_unpack_begin_to(ts_unpack_take_fn *take, void *data, size_t n);
void ts_unpack_piece(struct ts_unpack *u, const void *bytes, size_t n);
/* Whether the stream has ended, with its last piece and with n bytes. */
bool ts_unpack_end(struct ts_unpack *u);
/* What `take` has returned last, before the end. */
enum ts_status ts_unpack_status(const struct ts_unpack *u);

#endif
