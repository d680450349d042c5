#include "restart/sections.h"

#include <errno.h>
#include <string.h>
#include <sys/stat.h>
#include <zlib.h>

#include "base/crc32.h"
#include "restart/pack.h"

#include "base/banned.h"

enum { LONGEST_NAME = 4096, LARGEST_RATIO = 1040 /* zlib compresses no better */, PIECE = 1 << 18 };

enum ts_status ts_sections_refuse(struct ts_sections *r, const char *why)
{
	return ts_fail(&r->sim->error, TS_DAMAGED, r->where, "restart file '%s' %s", r->path, why);
}

static enum ts_status read_failed(struct ts_sections *r)
{
	return ts_fail(&r->sim->error, TS_IO, r->where, "reading '%s' failed: %s", r->path, strerror(errno));
}

/* Reads n bytes, without counting them in the checksum of the file. */
static enum ts_status read_raw(struct ts_sections *r, void *to, size_t n)
{
	if (r->sim->requests.stop)
		return ts_fail(&r->sim->error, TS_STOPPED, r->where, "stopped on request while '%s' was read",
			       r->path);
	if (fread(to, 1, n, r->file) == n)
		return TS_OK;
	if (ferror(r->file))
		return read_failed(r);
	return ts_sections_refuse(r, "is cut off");
}

static enum ts_status read_bytes(struct ts_sections *r, void *to, size_t n)
{
	TS_TRY(read_raw(r, to, n));
	r->sum = ts_crc32(r->sum, to, n);
	return TS_OK;
}

static enum ts_status refuse_version(struct ts_sections *r, const char *text)
{
	return ts_fail(&r->sim->error, TS_DAMAGED, r->where,
		       "restart file '%s' has version %.*s of the format, and this program reads versions 1 "
		       "to %d: it was written by a newer tsim, or is damaged",
		       r->path, (int)strcspn(text, "\n"), text, TS_RESTART_VERSION);
}

static enum ts_status check_start(struct ts_sections *r)
{
	char magic[TS_RESTART_MAGIC_LENGTH + 1] = "", *version = magic + sizeof TS_RESTART_MAGIC_STEM - 1;
	uint32_t mark[2];
	size_t n;

	n = fread(magic, 1, TS_RESTART_MAGIC_LENGTH, r->file);
	if (ferror(r->file))
		return read_failed(r);
	r->sum = ts_crc32(r->sum, magic, n);
	if (n < TS_RESTART_MAGIC_LENGTH ||
	    memcmp(magic, TS_RESTART_MAGIC_STEM, sizeof TS_RESTART_MAGIC_STEM - 1) != 0)
		return ts_sections_refuse(r, "is not a restart file of tsim");
	if (version[0] < '1' || version[0] > '0' + TS_RESTART_VERSION || version[1] != '\n')
		return refuse_version(r, version);
	TS_TRY(read_bytes(r, mark, sizeof mark));
	if (mark[0] != TS_RESTART_BYTE_ORDER_MARK)
		return ts_sections_refuse(r,
					  "was written by a machine with another byte order, or is damaged");
	if (mark[1] != (uint32_t)(version[0] - '0'))
		return ts_sections_refuse(r, "is damaged: it has two versions of the format");
	return TS_OK;
}

static enum ts_status read_names(struct ts_sections *r, struct ts_section *s)
{
	for (int k = 0; k < TS_SECTION_NAMES; k++) {
		uint32_t length = s->head.name_length[k];

		if (length > LONGEST_NAME)
			return ts_sections_refuse(r, "is damaged: a name is too long");
		s->name[k] = ts_arena_alloc(&r->arena, length + 1, 1);
		if (!s->name[k])
			return ts_nomem(&r->sim->error);
		TS_TRY(read_bytes(r, s->name[k], length));
	}
	return TS_OK;
}

/* Reads the compressed bytes to their end, also if they are damaged: their checksum tells first. u NULL: only for this. */
static enum ts_status unpack(struct ts_sections *r, const struct ts_section *s, struct ts_unpack *u,
			     uint32_t *sum)
{
	size_t left = (size_t)s->head.packed, n;

	for (; left; left -= n) {
		n = left < PIECE ? left : PIECE;
		TS_TRY(read_raw(r, r->piece, n));
		*sum = ts_crc32(*sum, r->piece, n);
		if (u)
			ts_unpack_piece(u, r->piece, n);
	}
	return TS_OK;
}

static enum ts_status check_sum(struct ts_sections *r, const struct ts_section *s, uint32_t sum)
{
	if (sum != s->head.sum)
		return ts_sections_refuse(r, "is damaged: the checksum of a section is wrong");
	return TS_OK;
}

static enum ts_status decompress(struct ts_sections *r, struct ts_section *s, uint32_t *sum)
{
	enum ts_status status;
	struct ts_unpack *u;
	bool whole;

	s->plain = ts_alloc((size_t)s->head.plain, 1);
	u = s->plain ? ts_unpack_begin(s->plain, (size_t)s->head.plain) : NULL;
	if (!u)
		return ts_nomem(&r->sim->error);
	status = unpack(r, s, u, sum);
	whole = ts_unpack_end(u);
	TS_TRY(status);
	TS_TRY(check_sum(r, s, *sum));
	return whole ? TS_OK : ts_sections_refuse(r, "is damaged: a section cannot be expanded");
}

static enum ts_status check_section(struct ts_sections *r, struct ts_section *s)
{
	uint32_t sum = 0;

	if (s->head.packed > r->left)
		return ts_sections_refuse(r, "is cut off");
	if (s->head.plain / LARGEST_RATIO > s->head.packed)
		return ts_sections_refuse(r, "is damaged: a section has an impossible size");
	s->at = r->twice ? ftello(r->file) : 0;
	TS_TRY(r->twice ? unpack(r, s, NULL, &sum) : decompress(r, s, &sum));
	TS_TRY(check_sum(r, s, sum));
	r->sum = (uint32_t)crc32_combine(r->sum, sum, (z_off_t)s->head.packed);
	return TS_OK;
}

/* `before`: the checksum of all bytes before the end mark. */
static enum ts_status check_end(struct ts_sections *r, uint32_t before)
{
	uint32_t sum;

	TS_TRY(read_bytes(r, &sum, sizeof sum));
	if (getc(r->file) != EOF)
		return ts_sections_refuse(r, "is damaged: there are data after its end");
	if (sum != before)
		return ts_sections_refuse(r, "is damaged: its checksum is wrong");
	return TS_OK;
}

static enum ts_status read_sections(struct ts_sections *r)
{
	struct ts_section_head head;

	for (;;) {
		uint32_t before = r->sum;
		struct ts_section *s;

		TS_TRY(read_bytes(r, &head.kind, sizeof head.kind));
		if (head.kind == TS_RESTART_END_SECTION)
			return check_end(r, before);
		if (TS_GROW(r->section, r->section_capacity, r->nsections + 1) != TS_OK)
			return ts_nomem(&r->sim->error);
		TS_TRY(read_bytes(r, (char *)&head + sizeof head.kind, sizeof head - sizeof head.kind));
		s = &r->section[r->nsections++];
		s->head = head;
		TS_TRY(read_names(r, s));
		TS_TRY(check_section(r, s));
	}
}

enum ts_status ts_sections_again(struct ts_sections *r, struct ts_section *s)
{
	uint32_t sum = 0;

	if (s->plain)
		return TS_OK;
	if (fseeko(r->file, s->at, SEEK_SET) != 0)
		return read_failed(r);
	return decompress(r, s, &sum);
}

static enum ts_status take_bytes(void *data, const unsigned char *bytes, size_t n)
{
	return ts_archive_pieces_add(data, bytes, n);
}

enum ts_status ts_sections_expand(struct ts_sections *r, const struct ts_section *s,
				  const struct ts_archive_taker *taker)
{
	struct ts_archive_pieces *pieces = ts_alloc(1, sizeof *pieces);
	enum ts_status status, taken = TS_OK;
	struct ts_unpack *u;
	uint32_t sum = 0;

	if (!pieces)
		return ts_nomem(&r->sim->error);
	ts_archive_pieces_begin(pieces, taker, s->head.plain);
	u = ts_unpack_begin_to(take_bytes, pieces, (size_t)s->head.plain);
	if (!u) {
		ts_free(pieces);
		return ts_nomem(&r->sim->error);
	}
	status = fseeko(r->file, s->at, SEEK_SET) ? read_failed(r) : unpack(r, s, u, &sum);
	if (status == TS_OK)
		taken = ts_unpack_status(u);
	if (!ts_unpack_end(u) || !ts_archive_pieces_whole(pieces))
		taken = taken == TS_OK ? TS_DAMAGED : taken;
	ts_free(pieces);
	TS_TRY(status);
	return taken == TS_NOMEM ? ts_nomem(&r->sim->error) : taken;
}

static enum ts_status read_stream(struct ts_sections *r)
{
	struct stat info;

	r->twice = ts_files_stat(&r->sim->files, r->path, &info) == 0 && S_ISREG(info.st_mode) &&
		   fseeko(r->file, 0, SEEK_SET) == 0;
	r->left = r->twice ? (uint64_t)info.st_size
			   : UINT64_MAX; /* what sections of a pipe have cannot be known */
	TS_TRY(check_start(r));
	return read_sections(r);
}

enum ts_status ts_sections_open(struct ts_sections *r)
{
	r->file = ts_files_open_along(&r->sim->files, r->path);
	if (!r->file)
		return ts_fail(&r->sim->error, TS_IO, r->where, "cannot open restart file '%s': %s", r->path,
			       ts_files_why(&r->sim->files));
	r->piece = ts_alloc(PIECE, 1);
	return r->piece ? read_stream(r) : ts_nomem(&r->sim->error);
}

void ts_sections_close(struct ts_sections *r)
{
	if (r->file)
		fclose(r->file);
	for (size_t k = 0; k < r->nsections; k++)
		ts_free(r->section[k].plain);
	ts_arena_release(&r->arena);
	ts_free(r->section);
	ts_free(r->piece);
}
