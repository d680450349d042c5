#include "restart/pack.h"

#include <stdbool.h>
#include <stdint.h>
#include <zlib.h>

#include "base/alloc.h"

#include "base/banned.h"

/* Bytes. PIECE: for which it is decided at once; SAMPLE: of it that are compressed to decide; ROOM: of the output.
 * A piece is worth compressing if its sample becomes as short as 1 / WORTH of it (zeros, equal numbers): then zlib is about as
 * fast as a disk. Real numbers of random digits lose a tenth, at 25 MB/s, indices of neighbours three quarters, at 65 MB/s.
 * MOST_ROOM: what zlib takes in one call. */
enum { PIECE = 1 << 18, SAMPLE = 1 << 12, ROOM = 1 << 18, WORTH = 8, MOST_ROOM = 1 << 30 };

static bool is_worth_it(const unsigned char *bytes, size_t n)
{
	unsigned char room[SAMPLE];
	size_t size = n < SAMPLE ? n : SAMPLE;
	uLongf length = (uLongf)(size / WORTH);

	if (n < SAMPLE)
		return true;
	return compress2(room, &length, bytes + (n - size) / 2, (uLong)size, Z_BEST_SPEED) == Z_OK;
}

struct packer {
	z_stream zip;
	unsigned char *room;
	enum ts_status (*put)(void *data, const void *bytes, size_t n);
	void *data;
};

static enum ts_status empty_room(struct packer *p)
{
	size_t n = ROOM - p->zip.avail_out;
	enum ts_status status = n ? p->put(p->data, p->room, n) : TS_OK;

	p->zip.next_out = p->room;
	p->zip.avail_out = ROOM;
	return status;
}

/* Pieces of one kind are one run of the compressor; in between it is emptied. */
static enum ts_status set_level(struct packer *p, int level)
{
	while (deflateParams(&p->zip, level, Z_DEFAULT_STRATEGY) == Z_BUF_ERROR)
		TS_TRY(empty_room(p));
	return TS_OK;
}

static enum ts_status pack_piece(struct packer *p, const unsigned char *bytes, size_t n, bool last)
{
	int code;

	p->zip.next_in = (z_const Bytef *)(uintptr_t)bytes;
	p->zip.avail_in = (uInt)n;
	do {
		if (!p->zip.avail_out)
			TS_TRY(empty_room(p));
		code = deflate(&p->zip, last ? Z_FINISH : Z_NO_FLUSH);
	} while (last ? code != Z_STREAM_END : p->zip.avail_in > 0);
	return last ? empty_room(p) : TS_OK;
}

static enum ts_status pack_pieces(struct packer *p, const unsigned char *bytes, size_t n)
{
	size_t at = 0, size;
	bool worth, was = true;

	do {
		size = n - at < PIECE ? n - at : PIECE;
		worth = is_worth_it(bytes + at, size);
		if (worth != was)
			TS_TRY(set_level(p, worth ? Z_BEST_SPEED : Z_NO_COMPRESSION));
		was = worth;
		TS_TRY(pack_piece(p, bytes + at, size, at + size == n));
		at += size;
	} while (at < n);
	return TS_OK;
}

enum ts_status ts_pack(const unsigned char *bytes, size_t n,
		       enum ts_status (*put)(void *data, const void *bytes, size_t n), void *data)
{
	struct packer p = { .put = put, .data = data, .room = ts_alloc(ROOM, 1) };
	enum ts_status status = TS_NOMEM;

	if (p.room && deflateInit(&p.zip, Z_BEST_SPEED) == Z_OK) {
		p.zip.next_out = p.room;
		p.zip.avail_out = ROOM;
		status = pack_pieces(&p, bytes, n);
		deflateEnd(&p.zip);
	}
	ts_free(p.room);
	return status;
}

struct ts_unpack {
	z_stream zip;
	size_t left; /* bytes that do not fit into zip.avail_out */
	int code;
	ts_unpack_take_fn *take; /* NULL: they stay where they are */
	void *data;
	unsigned char *room; /* [ROOM], of the present piece */
	enum ts_status status;
};

struct ts_unpack *ts_unpack_begin(void *to, size_t n)
{
	struct ts_unpack *u = ts_alloc(1, sizeof *u);

	if (!u || inflateInit(&u->zip) != Z_OK) {
		ts_free(u);
		return NULL;
	}
	inflateValidate(&u->zip,
			0); /* the file has its own checksums, of the compressed and of the plain bytes */
	u->zip.next_out = to;
	u->left = n;
	return u;
}

struct ts_unpack *ts_unpack_begin_to(ts_unpack_take_fn *take, void *data, size_t n)
{
	unsigned char *room = ts_alloc(ROOM, 1);
	struct ts_unpack *u = room ? ts_unpack_begin(room, n) : NULL;

	if (!u) {
		ts_free(room);
		return NULL;
	}
	u->take = take;
	u->data = data;
	u->room = room;
	return u;
}

/* Gives away what is in the room. */
static void empty_unpacked(struct ts_unpack *u)
{
	size_t n = u->take ? (size_t)(u->zip.next_out - u->room) : 0;

	if (n && u->status == TS_OK)
		u->status = u->take(u->data, u->room, n);
	if (u->take)
		u->zip.next_out = u->room;
	if (u->status != TS_OK)
		u->code = Z_DATA_ERROR;
}

enum ts_status ts_unpack_status(const struct ts_unpack *u)
{
	return u->status;
}

void ts_unpack_piece(struct ts_unpack *u, const void *bytes, size_t n)
{
	const size_t most = u->take ? ROOM : MOST_ROOM;

	if (u->code == Z_STREAM_END && n)
		u->code = Z_DATA_ERROR;
	u->zip.next_in = (z_const Bytef *)(uintptr_t)bytes;
	u->zip.avail_in = (uInt)n;
	while (u->code == Z_OK && u->zip.avail_in) {
		if (!u->zip.avail_out) {
			empty_unpacked(u);
			u->zip.avail_out = (uInt)(u->left < most ? u->left : most);
			u->left -= u->zip.avail_out;
		}
		if (u->code == Z_OK)
			u->code = inflate(&u->zip, Z_NO_FLUSH); /* Z_BUF_ERROR: there are more than n bytes */
	}
	if (u->code == Z_STREAM_END)
		empty_unpacked(u);
	if (u->zip.avail_in)
		u->code = Z_DATA_ERROR;
}

bool ts_unpack_end(struct ts_unpack *u)
{
	bool whole = u->code == Z_STREAM_END && !u->left && !u->zip.avail_out;

	inflateEnd(&u->zip);
	ts_free(u->room);
	ts_free(u);
	return whole;
}
