/* The fields of a block of an archive (core/archive.c) that comes in pieces, for who keeps a part of them only. */
#ifndef TS_CORE_ARCHIVE_PIECES_H
#define TS_CORE_ARCHIVE_PIECES_H

#include "core/archive.h"

enum {
	TS_ARCHIVE_MAGIC = 0x41525354,
	TS_ARCHIVE_HEAD = 16,
	TS_ARCHIVE_LONGEST_NAME = 1024,
	TS_ARCHIVE_SUM = 4
};

/* Bytes of an element; 0: there is no such type. */
size_t ts_archive_element(uint32_t type);

/* The head of a field, as in the block; its name follows, with a final 0. */
struct ts_archive_head {
	uint32_t name_length, type;
	uint64_t count;
};

struct ts_archive_taker {
	/* A field begins: its name is valid until the function returns. */
	enum ts_status (*begin)(void *data, const char *name, const struct ts_archive_head *head);
	/* The next n bytes of its elements. */
	enum ts_status (*bytes)(void *data, const unsigned char *bytes, size_t n);
	enum ts_status (*end)(void *data); /* of the field */
	void *data;
};

struct ts_archive_pieces {
	const struct ts_archive_taker *taker;
	uint64_t left; /* bytes of the block that have not come, without its checksum */
	bool started;  /* the magic word has come */
	size_t have;   /* bytes of `room` */
	uint64_t data; /* bytes of the field that have not come */
	bool inside;   /* a field */
	unsigned char room[TS_ARCHIVE_HEAD + TS_ARCHIVE_LONGEST_NAME];
};

/* n: bytes of the block. */
void ts_archive_pieces_begin(struct ts_archive_pieces *pieces, const struct ts_archive_taker *taker,
			     uint64_t n);
/* The next bytes of the block. TS_DAMAGED: it is no block; or what the taker has returned. */
enum ts_status ts_archive_pieces_add(struct ts_archive_pieces *pieces, const unsigned char *bytes, size_t n);
/* Whether all has come. */
bool ts_archive_pieces_whole(const struct ts_archive_pieces *pieces);

#endif
