#include "core/archive_pieces.h"

#include <string.h>

#include "base/banned.h"

enum { MAGIC_BYTES = 4 };

size_t ts_archive_element(uint32_t type)
{
	switch (type) {
	case TS_SAVED_F64:
	case TS_SAVED_I64:
		return 8;
	case TS_SAVED_I32:
		return 4;
	case TS_SAVED_U8:
		return 1;
	default:
		return 0;
	}
}

void ts_archive_pieces_begin(struct ts_archive_pieces *pieces, const struct ts_archive_taker *taker,
			     uint64_t n)
{
	*pieces = (struct ts_archive_pieces){ .taker = taker,
					      .left = n > TS_ARCHIVE_SUM ? n - TS_ARCHIVE_SUM : 0 };
}

/* Fills `room` to `need` bytes; *full: it has them. Returns the bytes taken. */
static size_t fill(struct ts_archive_pieces *s, const unsigned char *bytes, size_t n, size_t need, bool *full)
{
	size_t some = need - s->have < n ? need - s->have : n;

	memcpy(s->room + s->have, bytes, some);
	s->have += some;
	*full = s->have == need;
	return some;
}

static enum ts_status end_field(struct ts_archive_pieces *s)
{
	s->inside = false;
	s->have = 0;
	return s->taker->end(s->taker->data);
}

/* left: bytes behind the name. */
static enum ts_status begin_field(struct ts_archive_pieces *s, const struct ts_archive_head *head,
				  uint64_t left)
{
	size_t size = ts_archive_element(head->type);

	if (!size || s->room[s->have - 1] || head->count > left / size)
		return TS_DAMAGED;
	s->inside = true;
	s->data = head->count * size;
	TS_TRY(s->taker->begin(s->taker->data, (const char *)s->room + TS_ARCHIVE_HEAD, head));
	return s->data ? TS_OK : end_field(s);
}

/* The magic word, or a part of a head and name; *used: bytes taken. */
static enum ts_status add_head(struct ts_archive_pieces *s, const unsigned char *bytes, size_t n,
			       size_t *used)
{
	struct ts_archive_head head;
	bool full;

	if (!s->started) {
		*used = fill(s, bytes, n, MAGIC_BYTES, &s->started);
		s->have = s->started ? 0 : s->have;
		return TS_OK;
	}
	*used = 0;
	if (s->have < TS_ARCHIVE_HEAD)
		*used = fill(s, bytes, n, TS_ARCHIVE_HEAD, &full);
	if (s->have < TS_ARCHIVE_HEAD)
		return TS_OK;
	memcpy(&head, s->room, sizeof head);
	if (!head.name_length || head.name_length > TS_ARCHIVE_LONGEST_NAME)
		return TS_DAMAGED;
	*used += fill(s, bytes + *used, n - *used, TS_ARCHIVE_HEAD + head.name_length, &full);
	return full ? begin_field(s, &head, s->left - *used) : TS_OK;
}

enum ts_status ts_archive_pieces_add(struct ts_archive_pieces *s, const unsigned char *bytes, size_t n)
{
	n = n < s->left ? n : (size_t)s->left; /* the checksum is not a field */
	while (n) {
		size_t used = 0;

		if (s->inside) {
			used = n < s->data ? n : (size_t)s->data;
			TS_TRY(s->taker->bytes(s->taker->data, bytes, used));
			s->data -= used;
			if (!s->data)
				TS_TRY(end_field(s));
		} else {
			TS_TRY(add_head(s, bytes, n, &used));
		}
		s->left -= used;
		bytes += used;
		n -= used;
	}
	return TS_OK;
}

bool ts_archive_pieces_whole(const struct ts_archive_pieces *s)
{
	return s->started && !s->left && !s->inside && !s->have;
}
