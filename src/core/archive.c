/* One block of bytes: a magic word, the fields one after another, the checksum of all before it.
 * A field: length of the name with its final 0 (u32), type (u32), number of elements (u64), name,
 * elements. Numbers are in the byte order of the machine; restart/restart.c checks that order. */
#include "core/archive.h"
#include "core/archive_pieces.h"

#include <string.h>

#include "base/alloc.h"
#include "base/crc32.h"
#include "core/sim.h"

#include "base/banned.h"

struct field {
	size_t name, data; /* offsets into the block */
	enum ts_saved_type type;
	size_t count;
};

struct ts_archive {
	struct tsim *sim;
	bool writing, sealed;
	char *block; /* that is written */
	size_t length, capacity;
	const unsigned char *source; /* that is read, of the caller */
	struct field *field;
	size_t nfields, field_capacity;
	size_t next; /* the field behind the last one read: the search begins there */
};

bool ts_archive_writing(const struct ts_archive *archive)
{
	return archive->writing;
}

static enum ts_status append_bytes(struct ts_archive *a, const void *bytes, size_t n)
{
	if (ts_grow_text(&a->block, &a->capacity, a->length + n) != TS_OK)
		return ts_nomem(&a->sim->error);
	if (n)
		memcpy(a->block + a->length, bytes, n);
	a->length += n;
	return TS_OK;
}

static enum ts_status write_field(struct ts_archive *a, const char *name, enum ts_saved_type type,
				  const void *data, size_t count)
{
	uint32_t head[2] = { (uint32_t)strlen(name) + 1, (uint32_t)type };
	uint64_t n = count;

	TS_TRY(append_bytes(a, head, sizeof head));
	TS_TRY(append_bytes(a, &n, sizeof n));
	TS_TRY(append_bytes(a, name, head[0]));
	return append_bytes(a, data, count * ts_archive_element(type));
}

/* Fields are mostly read in the order in which they were written, so the search begins behind the last
 * one. */
static const struct field *find_field(const struct ts_archive *a, const char *name, size_t *at)
{
	for (size_t k = 0; k < a->nfields; k++) {
		size_t i = (a->next + k) % a->nfields;

		if (ts_streq((const char *)a->source + a->field[i].name, name)) {
			*at = i;
			return &a->field[i];
		}
	}
	return NULL;
}

static enum ts_status find_field_of_type(struct ts_archive *a, const char *name, enum ts_saved_type type,
					 const struct field **out)
{
	size_t at = 0;
	const struct field *field = find_field(a, name, &at);

	if (!field)
		return ts_fail(&a->sim->error, TS_DAMAGED, NULL, "saved state: field '%s' is missing", name);
	if (field->type != type)
		return ts_fail(&a->sim->error, TS_DAMAGED, NULL,
			       "saved state: field '%s' is of another type than expected", name);
	a->next = at + 1;
	*out = field;
	return TS_OK;
}

static enum ts_status find_field_of_size(struct ts_archive *a, const char *name, enum ts_saved_type type,
					 size_t count, const struct field **out)
{
	TS_TRY(find_field_of_type(a, name, type, out));
	if ((*out)->count != count)
		return ts_fail(&a->sim->error, TS_DAMAGED, NULL,
			       "saved state: field '%s' has %zu elements, expected %zu", name, (*out)->count,
			       count);
	return TS_OK;
}

enum ts_status ts_archive_expect(struct ts_archive *archive, const char *name, enum ts_saved_type type,
				 size_t count)
{
	size_t next = archive->next;
	const struct field *field;

	if (archive->writing)
		return TS_OK;
	TS_TRY(find_field_of_size(archive, name, type, count, &field));
	archive->next = next;
	return TS_OK;
}

enum ts_status ts_archive_fixed(struct ts_archive *archive, const char *name, enum ts_saved_type type,
				void *data, size_t count)
{
	const struct field *field;

	if (archive->writing)
		return write_field(archive, name, type, data, count);
	TS_TRY(find_field_of_size(archive, name, type, count, &field));
	if (count)
		memcpy(data, archive->source + field->data, count * ts_archive_element(type));
	return TS_OK;
}

enum ts_status ts_archive_array(struct ts_archive *archive, const char *name, enum ts_saved_type type,
				void **data, size_t *capacity, size_t *count)
{
	const struct field *field;
	size_t size = ts_archive_element(type);

	if (archive->writing)
		return write_field(archive, name, type, *data, *count);
	TS_TRY(find_field_of_type(archive, name, type, &field));
	if (ts_grow(data, capacity, field->count, size) != TS_OK)
		return ts_nomem(&archive->sim->error);
	if (field->count)
		memcpy(*data, archive->source + field->data, field->count * size);
	*count = field->count;
	return TS_OK;
}

/* Saved with its final 0. */
enum ts_status ts_archive_string(struct ts_archive *archive, const char *name, const char **text)
{
	const struct field *field;
	const char *saved;

	if (archive->writing)
		return write_field(archive, name, TS_SAVED_U8, *text, strlen(*text) + 1);
	TS_TRY(find_field_of_type(archive, name, TS_SAVED_U8, &field));
	saved = (const char *)archive->source + field->data;
	if (!field->count || strnlen(saved, field->count) != field->count - 1)
		return ts_fail(&archive->sim->error, TS_DAMAGED, NULL,
			       "saved state: field '%s' is not a string", name);
	*text = ts_pool_get(archive->sim->pool, saved);
	return *text ? TS_OK : ts_nomem(&archive->sim->error);
}

bool ts_archive_has(const struct ts_archive *archive, const char *name)
{
	size_t at;

	return archive->writing || find_field(archive, name, &at);
}

enum ts_status ts_archive_instance(struct ts_archive *archive, struct ts_instance *inst, struct tsim *sim)
{
	for (const struct ts_saved *row = inst->style->saved; row && row->type != TS_SAVED_END; row++)
		TS_TRY(ts_archive_fixed(archive, row->name, row->type, (char *)inst->state + row->offset,
					row->count));
	if (inst->style->archive)
		return inst->style->archive(inst, sim, archive);
	return TS_OK;
}

struct ts_archive *ts_archive_new(struct tsim *sim, bool writing)
{
	const uint32_t magic = TS_ARCHIVE_MAGIC;
	struct ts_archive *a = ts_alloc(1, sizeof *a);

	if (!a)
		return NULL;
	a->sim = sim;
	a->writing = writing;
	if (writing && append_bytes(a, &magic, sizeof magic) != TS_OK) {
		ts_archive_free(a);
		return NULL;
	}
	return a;
}

void ts_archive_free(struct ts_archive *archive)
{
	if (!archive)
		return;
	ts_free(archive->block);
	ts_free(archive->field);
	ts_free(archive);
}

enum ts_status ts_archive_bytes(struct ts_archive *archive, const unsigned char **bytes, size_t *n)
{
	uint32_t sum;

	if (archive->writing && !archive->sealed) {
		sum = ts_crc32(0, archive->block, archive->length);
		TS_TRY(append_bytes(archive, &sum, sizeof sum));
		archive->sealed = true;
	}
	*bytes = (const unsigned char *)archive->block;
	*n = archive->length;
	return TS_OK;
}

/* Parses the field at `at` and moves `at` behind it; false if it does not fit before `end`. */
static bool parse_field(const unsigned char *block, size_t *at, size_t end, struct field *field)
{
	uint32_t head[2];
	uint64_t count;
	size_t size;

	if (end - *at < TS_ARCHIVE_HEAD)
		return false;
	memcpy(head, block + *at, sizeof head);
	memcpy(&count, block + *at + sizeof head, sizeof count);
	*at += TS_ARCHIVE_HEAD;
	size = ts_archive_element(head[1]);
	if (!size || !head[0] || head[0] > TS_ARCHIVE_LONGEST_NAME || head[0] > end - *at ||
	    memchr(block + *at, 0, head[0]) != block + *at + head[0] - 1)
		return false;
	field->name = *at;
	*at += head[0];
	if (count > (end - *at) / size)
		return false;
	field->data = *at;
	field->type = (enum ts_saved_type)head[1];
	field->count = (size_t)count;
	*at += field->count * size;
	return true;
}

static enum ts_status fail_damaged(struct ts_archive *a, const char *why)
{
	a->nfields = a->next = 0;
	return ts_fail(&a->sim->error, TS_DAMAGED, NULL, "saved state is damaged: %s", why);
}

enum ts_status ts_archive_from(struct ts_archive *archive, const unsigned char *bytes, size_t n)
{
	size_t at = sizeof(uint32_t), end;
	uint32_t magic, sum;

	archive->nfields = archive->next = 0;
	archive->source = bytes;
	if (n < sizeof magic + sizeof sum)
		return fail_damaged(archive, "too short");
	end = n - sizeof sum;
	memcpy(&magic, bytes, sizeof magic);
	memcpy(&sum, bytes + end, sizeof sum);
	if (magic != TS_ARCHIVE_MAGIC)
		return fail_damaged(archive, "it does not begin as it should");
	if (sum != ts_crc32(0, bytes, end))
		return fail_damaged(archive, "the checksum is wrong");
	while (at < end) {
		if (TS_GROW(archive->field, archive->field_capacity, archive->nfields + 1) != TS_OK)
			return ts_nomem(&archive->sim->error);
		if (!parse_field(bytes, &at, end, &archive->field[archive->nfields]))
			return fail_damaged(archive, "a field does not fit into it");
		archive->nfields++;
	}
	return TS_OK;
}
