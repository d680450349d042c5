#include "restart/sieve.h"

#include <stdio.h>
#include <string.h>

#include "base/crc32.h"
#include "box/domain.h"
#include "particle/division.h"
#include "particle/particles.h"

#include "base/banned.h"

enum field { OTHER, NUMBER, TAG, PLACE, HELD, COLUMN, SIZE, KEY, CONTACT };
enum { MAGIC_BYTES = 4, KEY_NUMBERS = 3 };

/* ---- rows of a field, which come in pieces */

/* Calls `take` with each row. */
static enum ts_status each_row(struct ts_sieve *s, const unsigned char *bytes, size_t n,
			       enum ts_status (*take)(struct ts_sieve *s, const unsigned char *row))
{
	while (n) {
		size_t some = s->width - s->have < n ? s->width - s->have : n;
		const unsigned char *row = bytes;

		if (some < s->width) {
			memcpy(s->part + s->have, bytes, some);
			row = s->part;
		}
		s->have += some;
		bytes += some;
		n -= some;
		if (s->have < s->width)
			break;
		TS_TRY(take(s, row));
		s->row++;
		s->have = 0;
	}
	return TS_OK;
}

/* Begins rows of that many bytes, or damage. */
static enum ts_status begin_rows(struct ts_sieve *s, int field, size_t width)
{
	if (!width || width > sizeof s->part)
		return TS_DAMAGED;
	s->field = field;
	s->width = width;
	s->row = s->have = 0;
	return TS_OK;
}

/* ---- places */

static bool is_near(const struct ts_sieve *s, int32_t tag)
{
	size_t at = (size_t)tag;

	return tag > 0 && at / 8 < s->near_bytes && s->near[at / 8] >> (at % 8) & 1;
}

static enum ts_status add_near(struct ts_sieve *s, int32_t tag)
{
	size_t at = (size_t)tag;

	if (tag < 1)
		return TS_DAMAGED;
	if (at / 8 >= s->near_bytes) {
		size_t bytes = at / 4 + 64;
		unsigned char *bigger = ts_alloc(bytes, 1);

		if (!bigger)
			return TS_NOMEM;
		if (s->near_bytes)
			memcpy(bigger, s->near, s->near_bytes);
		ts_free(s->near);
		s->near = bigger;
		s->near_bytes = bytes;
	}
	s->near[at / 8] |= (unsigned char)(1 << (at % 8));
	return TS_OK;
}

static bool is_own(const struct ts_sieve *s, const double x[3])
{
	return ts_division_owns(s->sim, x);
}

/* All places are known: cuts the box, and notes the particles of this rank by their present places. */
static enum ts_status end_places(struct ts_sieve *s)
{
	const struct ts_box *box = &s->sim->domain->box;

	TS_TRY(ts_division_begin(s->sim, s->x, s->n));
	for (size_t i = 0; i < s->n; i++) {
		const bool own = is_own(s, s->x[i]);

		for (int d = 0; d < 3; d++) /* it will be wrapped when the run begins */
			if (ts_box_periodic(box, d))
				ts_box_wrap(box, d, &s->x[i][d], &(int32_t){ 0 });
		if (own || is_own(s, s->x[i]))
			TS_TRY(add_near(s, s->tag[i]));
	}
	ts_free(s->x);
	s->x = NULL;
	return TS_OK;
}

static enum ts_status take_place(struct ts_sieve *s, const unsigned char *row)
{
	double x[3];

	if (s->field == TAG)
		memcpy(&s->tag[s->row], row, sizeof *s->tag);
	else if (s->field == PLACE)
		memcpy(s->x[s->row], row, sizeof x);
	if (s->field != HELD)
		return TS_OK;
	memcpy(x, row, sizeof x);
	s->keep[s->row] = is_own(s, x);
	s->kept += s->keep[s->row];
	return s->keep[s->row] ? add_near(s, s->tag[s->row]) : TS_OK;
}

static bool has(const struct ts_sieve *s, int field)
{
	return s->seen >> field & 1;
}

static enum ts_status begin_place(void *data, const char *name, const struct ts_archive_head *head)
{
	static const struct {
		const char *name;
		int field, after; /* the field that must have come */
		uint32_t type;
		size_t numbers;
	} wanted[] = { { "n", NUMBER, OTHER, TS_SAVED_I64, 1 },
		       { "tag", TAG, NUMBER, TS_SAVED_I32, 1 },
		       { "x", PLACE, TAG, TS_SAVED_F64, 3 },
		       { "xhold", HELD, PLACE, TS_SAVED_F64, 3 } };
	struct ts_sieve *s = data;

	s->field = OTHER;
	for (size_t k = 0; k < sizeof wanted / sizeof *wanted; k++) {
		if (strcmp(name, wanted[k].name) != 0)
			continue;
		if (has(s, wanted[k].field) || (wanted[k].after != OTHER && !has(s, wanted[k].after)) ||
		    head->type != wanted[k].type || head->count != wanted[k].numbers * (k ? s->n : 1))
			return TS_DAMAGED;
		s->seen |= 1u << wanted[k].field;
		TS_TRY(begin_rows(s, wanted[k].field, wanted[k].numbers * ts_archive_element(head->type)));
	}
	return TS_OK;
}

bool ts_sieve_has_places(const struct ts_sieve *s)
{
	return has(s, HELD);
}

static enum ts_status take_number(struct ts_sieve *s, const unsigned char *row)
{
	int64_t n;

	memcpy(&n, row, sizeof n);
	if (n < 1 || n > INT32_MAX)
		return TS_DAMAGED;
	s->n = (size_t)n;
	s->keep = ts_alloc(s->n, 1);
	s->tag = ts_alloc(s->n, sizeof *s->tag);
	s->x = ts_alloc(s->n, sizeof *s->x);
	return s->keep && s->tag && s->x ? TS_OK : TS_NOMEM;
}

static enum ts_status place_bytes(void *data, const unsigned char *bytes, size_t n)
{
	struct ts_sieve *s = data;

	if (s->field == OTHER)
		return TS_OK;
	return each_row(s, bytes, n, s->field == NUMBER ? take_number : take_place);
}

static enum ts_status end_place(void *data)
{
	struct ts_sieve *s = data;

	return s->field == PLACE ? end_places(s) : TS_OK;
}

struct ts_archive_taker ts_sieve_places(struct ts_sieve *s)
{
	return (struct ts_archive_taker){ begin_place, place_bytes, end_place, s };
}

/* ---- the shorter section */

static enum ts_status write(struct ts_sieve *s, const void *bytes, size_t n)
{
	if (ts_grow_text(&s->block, &s->capacity, s->length + n) != TS_OK)
		return TS_NOMEM;
	memcpy(s->block + s->length, bytes, n);
	s->length += n;
	return TS_OK;
}

/* Writes the head of the field; per_row: elements of a row of it, 0: it is copied. */
static enum ts_status write_head(struct ts_sieve *s, const char *name, const struct ts_archive_head *head,
				 size_t per_row)
{
	if (!s->length) /* the magic word: ts_sieve_section */
		TS_TRY(write(s, "\0\0\0", MAGIC_BYTES));
	s->count_at = s->length + offsetof(struct ts_archive_head, count);
	s->per_row = per_row;
	s->written = 0;
	TS_TRY(write(s, head, sizeof *head));
	return write(s, name, head->name_length);
}

static enum ts_status write_row(struct ts_sieve *s, const unsigned char *row)
{
	const unsigned char *keep = s->field == COLUMN ? s->keep : s->keep_contact;

	if (!keep[s->row])
		return TS_OK;
	s->written++;
	return write(s, row, s->width);
}

static enum ts_status end_shorter(void *data)
{
	struct ts_sieve *s = data;
	uint64_t count = s->written * s->per_row;

	if (s->per_row)
		memcpy(s->block + s->count_at, &count, sizeof count);
	return TS_OK;
}

static void write_number(struct ts_sieve *s, size_t number)
{
	int64_t n = (int64_t)number;

	memcpy(s->block + s->number_at, &n, sizeof n);
}

/* ---- particles */

static enum ts_status begin_column(void *data, const char *name, const struct ts_archive_head *head)
{
	struct ts_sieve *s = data;
	size_t numbers = (size_t)head->count / s->n;

	s->field = OTHER;
	s->rows |= strcmp(name, "tag") == 0;
	if (!s->rows) {
		TS_TRY(write_head(s, name, head, 0));
		if (strcmp(name, "n") == 0)
			s->number_at = s->length;
		return TS_OK;
	}
	if (head->count % s->n)
		return TS_DAMAGED;
	TS_TRY(write_head(s, name, head, numbers));
	return begin_rows(s, COLUMN, numbers * ts_archive_element(head->type));
}

static enum ts_status column_bytes(void *data, const unsigned char *bytes, size_t n)
{
	struct ts_sieve *s = data;

	return s->field == COLUMN ? each_row(s, bytes, n, write_row) : write(s, bytes, n);
}

struct ts_archive_taker ts_sieve_particles(struct ts_sieve *s)
{
	s->length = 0;
	s->rows = false;
	return (struct ts_archive_taker){ begin_column, column_bytes, end_shorter, s };
}

/* ---- contacts */

static enum ts_status take_size(struct ts_sieve *s, const unsigned char *row)
{
	int64_t size[2];

	memcpy(size, row, sizeof size);
	if (size[0] < 0 || size[0] > INT32_MAX || size[1] < 0 || size[1] > 1024)
		return TS_DAMAGED;
	s->contacts = (size_t)size[0];
	s->history = (size_t)size[1];
	ts_free(s->keep_contact);
	s->keep_contact = ts_alloc(s->contacts, 1);
	return s->keep_contact ? write(s, row, sizeof size) : TS_NOMEM;
}

static enum ts_status take_key(struct ts_sieve *s, const unsigned char *row)
{
	int32_t key[KEY_NUMBERS];

	memcpy(key, row, sizeof key);
	s->keep_contact[s->row] = is_near(s, key[0]) || is_near(s, key[1]);
	s->contacts_kept += s->keep_contact[s->row];
	return write_row(s, row);
}

/* Numbers of a contact in the field; 0: it is another field. */
static size_t numbers_of_contact(const struct ts_sieve *s, const char *name,
				 const struct ts_archive_head *head)
{
	static const char *const names[] = { "history_keys", "history", "forces" };
	static const uint32_t types[] = { TS_SAVED_I32, TS_SAVED_F64, TS_SAVED_F64 };
	const size_t numbers[] = { KEY_NUMBERS, s->history, 3 };

	for (size_t k = 0; k < 3; k++)
		if (strcmp(name, names[k]) == 0 && head->type == types[k] && s->contacts &&
		    head->count == numbers[k] * s->contacts)
			return numbers[k];
	return 0;
}

static enum ts_status begin_contact(void *data, const char *name, const struct ts_archive_head *head)
{
	struct ts_sieve *s = data;
	size_t numbers = numbers_of_contact(s, name, head);

	s->field = OTHER;
	TS_TRY(write_head(s, name, head, numbers));
	if (strcmp(name, "history_size") == 0) {
		s->number_at = s->length;
		return head->count == 2 && head->type == TS_SAVED_I64
			       ? begin_rows(s, SIZE, 2 * sizeof(int64_t))
			       : TS_DAMAGED;
	}
	if (!numbers)
		return TS_OK;
	return begin_rows(s, numbers == KEY_NUMBERS && strcmp(name, "history_keys") == 0 ? KEY : CONTACT,
			  numbers * ts_archive_element(head->type));
}

static enum ts_status contact_bytes(void *data, const unsigned char *bytes, size_t n)
{
	struct ts_sieve *s = data;

	switch (s->field) {
	case SIZE:
		return each_row(s, bytes, n, take_size);
	case KEY:
		return each_row(s, bytes, n, take_key);
	case CONTACT:
		return each_row(s, bytes, n, write_row);
	default:
		return write(s, bytes, n);
	}
}

struct ts_archive_taker ts_sieve_contacts(struct ts_sieve *s)
{
	s->length = 0;
	return (struct ts_archive_taker){ begin_contact, contact_bytes, end_shorter, s };
}

unsigned char *ts_sieve_section(struct ts_sieve *s, size_t *n)
{
	const uint32_t magic = TS_ARCHIVE_MAGIC;
	unsigned char *block;
	uint32_t sum;

	write_number(s, s->rows ? s->kept : s->contacts_kept);
	memcpy(s->block, &magic, sizeof magic);
	sum = ts_crc32(0, s->block, s->length);
	if (write(s, &sum, sizeof sum) != TS_OK)
		return NULL;
	block = (unsigned char *)s->block;
	*n = s->length;
	s->block = NULL;
	s->length = s->capacity = 0;
	s->rows = false;
	return block;
}

void ts_sieve_release(struct ts_sieve *s)
{
	ts_free(s->keep);
	ts_free(s->tag);
	ts_free(s->x);
	ts_free(s->near);
	ts_free(s->keep_contact);
	ts_free(s->block);
	*s = (struct ts_sieve){ 0 };
}
