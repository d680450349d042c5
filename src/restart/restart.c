#include "restart/restart.h"

#include <errno.h>
#include <limits.h>
#include <math.h>
#include <string.h>
#include <sys/stat.h>
#include <zlib.h>

#include "base/crc32.h"
#include "box/domain.h"
#include "core/fingerprint.h"
#include "core/group.h"
#include "core/plan.h"
#include "core/unclaimed_state.h"
#include "io/replace.h"
#include "io/textfile.h"
#include "particle/particles.h"
#include "restart/pack.h"

#include "base/banned.h"

/* Version 2 added the section of the script and the arguments of styles. Older versions can be read;
 * doc/restart-format.md says which changes require a new version. */
#define MAGIC_STEM "tsim restart "
#define MAGIC MAGIC_STEM "2\n"
enum { BYTE_ORDER_MARK = 0x01020304, VERSION = 2, MAGIC_LENGTH = sizeof MAGIC - 1 };
enum { CLOCK_SECTION = 1000, SCRIPT_SECTION = 1001, END_SECTION = 0 };
enum {
	NNAMES = 3,
	LONGEST_NAME = 4096,
	LARGEST_RATIO = 1040 /* zlib compresses no better */,
	PIECE = 1 << 18
};

static const enum ts_kind saved_kinds[] = { TS_KIND_SYSTEM, TS_KIND_PAIR,     TS_KIND_BOND,
					    TS_KIND_FLOW,   TS_KIND_FIX,      TS_KIND_COMPUTE,
					    TS_KIND_DUMP,   TS_KIND_PRESSURE, TS_KIND_AUTOMATON };

_Static_assert(TS_KIND_FIX == 2 && TS_KIND_FLOW == 8 && TS_KIND_AUTOMATON == 10,
	       "restart files contain these numbers");

/* Header of a section, as in the file; names and compressed bytes follow. */
struct section_head {
	uint32_t kind, name_length[NNAMES];
	uint64_t plain, packed; /* bytes before and after compression */
	uint32_t sum, zero;	/* crc32 of the compressed bytes; padding */
};

/* ---- contents of the clock section; the same function writes and reads it */

struct run_state {
	struct ts_clock clock;
	int32_t units, dimension;
	uint64_t fingerprint;
	int64_t era;
};

static enum ts_status archive_run_state(struct ts_archive *a, struct run_state *s)
{
	struct ts_clock *c = &s->clock;

	TS_TRY(ts_archive_fixed(a, "step", TS_SAVED_I64, &c->step, 1));
	TS_TRY(ts_archive_fixed(a, "base_step", TS_SAVED_I64, &c->base_step, 1));
	TS_TRY(ts_archive_fixed(a, "base_time", TS_SAVED_F64, &c->base_time, 1));
	TS_TRY(ts_archive_fixed(a, "dt", TS_SAVED_F64, &c->dt, 1));
	TS_TRY(ts_archive_fixed(a, "units", TS_SAVED_I32, &s->units, 1));
	TS_TRY(ts_archive_fixed(a, "dimension", TS_SAVED_I32, &s->dimension, 1));
	if (ts_archive_has(a, "era")) /* older files have none */
		TS_TRY(ts_archive_fixed(a, "era", TS_SAVED_I64, &s->era, 1));
	return ts_archive_fixed(a, "fingerprint", TS_SAVED_I64, &s->fingerprint, 1);
}

/* ---- writing */

struct writer {
	struct tsim *sim;
	struct ts_replace out;
	uint32_t sum; /* crc32 of all bytes written so far */
};

static enum ts_status write_bytes(struct writer *w, const void *bytes, size_t n)
{
	w->sum = ts_crc32(w->sum, bytes, n);
	return ts_replace_write(&w->out, bytes, n);
}

/* The compressed bytes of a section; their number is written before them. */
struct packed {
	char *bytes;
	size_t n, capacity;
};

static enum ts_status put_packed(void *data, const void *bytes, size_t n)
{
	struct packed *p = data;

	if (ts_grow_text(&p->bytes, &p->capacity, p->n + n) != TS_OK)
		return TS_NOMEM;
	memcpy(p->bytes + p->n, bytes, n);
	p->n += n;
	return TS_OK;
}

static enum ts_status write_packed(struct writer *w, struct section_head *head, const char *const names[],
				   const struct packed *packed)
{
	head->packed = packed->n;
	head->sum = ts_crc32(0, packed->bytes, packed->n);
	for (int k = 0; k < NNAMES; k++)
		head->name_length[k] = (uint32_t)strlen(names[k]);
	TS_TRY(write_bytes(w, head, sizeof *head));
	for (int k = 0; k < NNAMES; k++)
		TS_TRY(write_bytes(w, names[k], head->name_length[k]));
	w->sum = (uint32_t)crc32_combine(w->sum, head->sum, (z_off_t)packed->n);
	return ts_replace_write(&w->out, packed->bytes, packed->n);
}

/* Compresses the contents of the archive and writes them as a section. */
static enum ts_status write_section(struct writer *w, uint32_t kind, const char *const names[],
				    struct ts_archive *archive)
{
	struct section_head head = { .kind = kind };
	struct packed packed = { 0 };
	const unsigned char *bytes;
	enum ts_status status;
	size_t n;

	TS_TRY(ts_archive_bytes(archive, &bytes, &n));
	head.plain = n;
	status = ts_pack(bytes, n, put_packed, &packed) == TS_OK ? write_packed(w, &head, names, &packed)
								 : ts_nomem(&w->sim->error);
	ts_free(packed.bytes);
	return status;
}

static const char *const no_names[NNAMES] = { "", "", "" };

static enum ts_status write_script_state(struct writer *w)
{
	struct tsim *sim = w->sim;
	struct ts_archive *archive = ts_archive_new(sim, true);
	enum ts_status status;

	if (!archive)
		return ts_nomem(&sim->error);
	status = sim->script_api->archive(sim->script_api_data, archive);
	if (status == TS_OK)
		status = write_section(w, SCRIPT_SECTION, no_names, archive);
	ts_archive_free(archive);
	return status;
}

static enum ts_status write_clock(struct writer *w)
{
	struct tsim *sim = w->sim;
	struct run_state s = { sim->clock, (int32_t)sim->units, sim->dimension, sim->run.fingerprint,
			       sim->era };
	struct ts_archive *archive = ts_archive_new(sim, true);
	enum ts_status status;

	if (!archive)
		return ts_nomem(&sim->error);
	status = archive_run_state(archive, &s);
	if (status == TS_OK)
		status = write_section(w, CLOCK_SECTION, no_names, archive);
	ts_archive_free(archive);
	return status;
}

static enum ts_status write_instance(struct writer *w, struct ts_instance *inst)
{
	const char *names[] = { inst->style->name, inst->id, ts_group_name(w->sim, inst->group) };
	struct ts_archive *archive = ts_archive_new(w->sim, true);
	enum ts_status status;

	if (!archive)
		return ts_nomem(&w->sim->error);
	status = inst->style->kind == TS_KIND_SYSTEM ? ts_archive_instance(archive, inst, w->sim)
						     : ts_unclaimed_write(w->sim, inst, archive);
	if (status == TS_OK)
		status = write_section(w, (uint32_t)inst->style->kind + 1, names, archive);
	ts_archive_free(archive);
	return status;
}

static enum ts_status write_all(struct writer *w)
{
	const uint32_t mark[2] = { BYTE_ORDER_MARK, VERSION };
	uint32_t end[2] = { END_SECTION, 0 };

	TS_TRY(write_bytes(w, MAGIC, MAGIC_LENGTH));
	TS_TRY(write_bytes(w, mark, sizeof mark));
	TS_TRY(write_clock(w));
	if (w->sim->script_api && w->sim->script_api->archive)
		TS_TRY(write_script_state(w));
	for (size_t k = 0; k < sizeof saved_kinds / sizeof *saved_kinds; k++) {
		struct ts_instances *list = &w->sim->instances[saved_kinds[k]];

		for (size_t i = 0; i < list->n; i++)
			if (list->item[i]->style->saved || list->item[i]->style->archive)
				TS_TRY(write_instance(w, list->item[i]));
	}
	end[1] = w->sum;
	return ts_replace_write(&w->out, end, sizeof end);
}

enum ts_status ts_restart_write(struct tsim *sim, const char *path, const struct ts_place *where)
{
	struct writer w = { .sim = sim };
	enum ts_status status;

	/* within a run the forces belong to the current state: a continued run need not compute them again */
	if (sim->run.inside)
		TS_TRY(ts_sim_fingerprint(sim, &sim->run.fingerprint));
	TS_TRY(ts_replace_begin(&w.out, sim, where, path));
	status = write_all(&w);
	if (status == TS_OK)
		status = ts_replace_commit(&w.out, true);
	ts_replace_abandon(&w.out);
	return status;
}

/* ---- reading: the whole file is checked before anything is restored. A file is read a second time then, section by section; the
 * sections of a pipe are all kept until then. */

struct section {
	struct section_head head;
	char *name[NNAMES];   /* style, id, group */
	off_t at;	      /* of its compressed bytes */
	unsigned char *plain; /* uncompressed bytes; freed once they are restored */
};

struct reader {
	struct tsim *sim;
	const char *path;
	const struct ts_place *where;
	struct ts_arena arena;
	FILE *file;
	bool twice;	      /* it is a file */
	uint64_t left;	      /* a section cannot have more bytes */
	uint32_t sum;	      /* crc32 of all bytes read so far */
	unsigned char *piece; /* of a section */
	struct section *section;
	size_t nsections, section_capacity;
	size_t system; /* index in the table of systems: the first that is not yet restored */
};

static enum ts_status refuse_file(struct reader *r, const char *why)
{
	return ts_fail(&r->sim->error, TS_DAMAGED, r->where, "restart file '%s' %s", r->path, why);
}

static enum ts_status read_failed(struct reader *r)
{
	return ts_fail(&r->sim->error, TS_IO, r->where, "reading '%s' failed: %s", r->path, strerror(errno));
}

/* Reads n bytes, without counting them in the checksum of the file. */
static enum ts_status read_raw(struct reader *r, void *to, size_t n)
{
	if (r->sim->requests.stop)
		return ts_fail(&r->sim->error, TS_STOPPED, r->where, "stopped on request while '%s' was read",
			       r->path);
	if (fread(to, 1, n, r->file) == n)
		return TS_OK;
	if (ferror(r->file))
		return read_failed(r);
	return refuse_file(r, "is cut off");
}

static enum ts_status read_bytes(struct reader *r, void *to, size_t n)
{
	TS_TRY(read_raw(r, to, n));
	r->sum = ts_crc32(r->sum, to, n);
	return TS_OK;
}

static enum ts_status refuse_version(struct reader *r, const char *text)
{
	return ts_fail(&r->sim->error, TS_DAMAGED, r->where,
		       "restart file '%s' has version %.*s of the format, and this program reads versions 1 "
		       "to %d: it was written by a newer tsim, or is damaged",
		       r->path, (int)strcspn(text, "\n"), text, VERSION);
}

static enum ts_status check_start(struct reader *r)
{
	char magic[MAGIC_LENGTH + 1] = "", *version = magic + sizeof MAGIC_STEM - 1;
	uint32_t mark[2];
	size_t n;

	n = fread(magic, 1, MAGIC_LENGTH, r->file);
	if (ferror(r->file))
		return read_failed(r);
	r->sum = ts_crc32(r->sum, magic, n);
	if (n < MAGIC_LENGTH || memcmp(magic, MAGIC_STEM, sizeof MAGIC_STEM - 1) != 0)
		return refuse_file(r, "is not a restart file of tsim");
	if (version[0] < '1' || version[0] > '0' + VERSION || version[1] != '\n')
		return refuse_version(r, version);
	TS_TRY(read_bytes(r, mark, sizeof mark));
	if (mark[0] != BYTE_ORDER_MARK)
		return refuse_file(r, "was written by a machine with another byte order, or is damaged");
	if (mark[1] != (uint32_t)(version[0] - '0'))
		return refuse_file(r, "is damaged: it has two versions of the format");
	return TS_OK;
}

static enum ts_status read_names(struct reader *r, struct section *s)
{
	for (int k = 0; k < NNAMES; k++) {
		uint32_t length = s->head.name_length[k];

		if (length > LONGEST_NAME)
			return refuse_file(r, "is damaged: a name is too long");
		s->name[k] = ts_arena_alloc(&r->arena, length + 1, 1);
		if (!s->name[k])
			return ts_nomem(&r->sim->error);
		TS_TRY(read_bytes(r, s->name[k], length));
	}
	return TS_OK;
}

/* Reads the compressed bytes to their end, also if they are damaged: their checksum tells first. u NULL: only for this. */
static enum ts_status unpack(struct reader *r, const struct section *s, struct ts_unpack *u, uint32_t *sum)
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

static enum ts_status check_sum(struct reader *r, const struct section *s, uint32_t sum)
{
	if (sum != s->head.sum)
		return refuse_file(r, "is damaged: the checksum of a section is wrong");
	return TS_OK;
}

static enum ts_status decompress(struct reader *r, struct section *s, uint32_t *sum)
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
	return whole ? TS_OK : refuse_file(r, "is damaged: a section cannot be expanded");
}

static enum ts_status check_section(struct reader *r, struct section *s)
{
	uint32_t sum = 0;

	if (s->head.packed > r->left)
		return refuse_file(r, "is cut off");
	if (s->head.plain / LARGEST_RATIO > s->head.packed)
		return refuse_file(r, "is damaged: a section has an impossible size");
	s->at = r->twice ? ftello(r->file) : 0;
	TS_TRY(r->twice ? unpack(r, s, NULL, &sum) : decompress(r, s, &sum));
	TS_TRY(check_sum(r, s, sum));
	r->sum = (uint32_t)crc32_combine(r->sum, sum, (z_off_t)s->head.packed);
	return TS_OK;
}

/* `before`: the checksum of all bytes before the end mark. */
static enum ts_status check_end(struct reader *r, uint32_t before)
{
	uint32_t sum;

	TS_TRY(read_bytes(r, &sum, sizeof sum));
	if (getc(r->file) != EOF)
		return refuse_file(r, "is damaged: there are data after its end");
	if (sum != before)
		return refuse_file(r, "is damaged: its checksum is wrong");
	return TS_OK;
}

static enum ts_status read_sections(struct reader *r)
{
	struct section_head head;

	for (;;) {
		uint32_t before = r->sum;
		struct section *s;

		TS_TRY(read_bytes(r, &head.kind, sizeof head.kind));
		if (head.kind == END_SECTION)
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

/* The bytes of a section of a file that has been checked. */
static enum ts_status read_again(struct reader *r, struct section *s)
{
	uint32_t sum = 0;

	if (s->plain)
		return TS_OK;
	if (fseeko(r->file, s->at, SEEK_SET) != 0)
		return read_failed(r);
	return decompress(r, s, &sum);
}

/* Restores run state, instance, or (both NULL) variables of the script from a section. */
static enum ts_status restore_from(struct reader *r, const struct section *s, struct run_state *clock,
				   struct ts_instance *inst)
{
	struct ts_archive *archive = ts_archive_new(r->sim, false);
	enum ts_status status;

	if (!archive)
		return ts_nomem(&r->sim->error);
	status = ts_archive_from(archive, s->plain, (size_t)s->head.plain);
	if (status == TS_OK && clock)
		status = archive_run_state(archive, clock);
	else if (status == TS_OK && inst)
		status = ts_archive_instance(archive, inst, r->sim);
	else if (status == TS_OK && r->sim->script_api && r->sim->script_api->archive)
		status = r->sim->script_api->archive(r->sim->script_api_data, archive);
	ts_archive_free(archive);
	return status;
}

static enum ts_status restore_clock(struct reader *r)
{
	static const char *const units[] = { "lj", "si", "cgs", "micro" };
	struct tsim *sim = r->sim;
	struct run_state s = { 0 };

	if (!r->nsections || r->section[0].head.kind != CLOCK_SECTION)
		return refuse_file(r, "is damaged: it does not begin with the clock");
	TS_TRY(read_again(r, &r->section[0]));
	TS_TRY(restore_from(r, &r->section[0], &s, NULL));
	if (s.units < 0 || s.units > TS_UNITS_MICRO || (s.dimension != 2 && s.dimension != 3))
		return refuse_file(r, "is damaged: unknown units or dimension");
	if (s.clock.base_step < 0 || s.clock.step < s.clock.base_step || !isfinite(s.clock.base_time) ||
	    !isfinite(s.clock.dt))
		return refuse_file(r, "is damaged: impossible step or time");
	if (sim->units != TS_UNITS_LJ && (int32_t)sim->units != s.units)
		return ts_fail(&sim->error, TS_STATE, r->where,
			       "restart file '%s' is in units %s, but the script says units %s", r->path,
			       units[s.units], units[sim->units]);
	if (sim->dimension != 3 && sim->dimension != s.dimension)
		return ts_fail(&sim->error, TS_STATE, r->where,
			       "restart file '%s' has dimension %d, but the script says dimension %d",
			       r->path, (int)s.dimension, sim->dimension);
	sim->clock = s.clock;
	sim->clock.first_step = sim->clock.last_step = s.clock.step;
	sim->units = (enum ts_units)s.units;
	sim->dimension = s.dimension;
	sim->run.fingerprint = s.fingerprint;
	sim->era = s.era;
	return TS_OK;
}

/* Systems are restored in the order of the table, each once: later ones depend on earlier ones. */
static enum ts_status restore_system(struct reader *r, const struct section *s)
{
	struct ts_instance *inst = ts_sim_find(r->sim, TS_KIND_SYSTEM, s->name[0]);

	if (!inst)
		return refuse_file(r, "holds the state of a system this program does not have");
	while (r->sim->tables->systems[r->system] &&
	       &r->sim->tables->systems[r->system]->style != inst->style)
		r->system++;
	if (!r->sim->tables->systems[r->system])
		return refuse_file(r, "is damaged: its sections are out of order");
	r->system++;
	return restore_from(r, s, NULL, inst);
}

static enum ts_status restore_section(struct reader *r, const struct section *s)
{
	if (s->head.kind == SCRIPT_SECTION)
		return restore_from(r, s, NULL, NULL);
	if (s->head.kind == 0 || s->head.kind > TS_NKIND)
		return refuse_file(r, "holds the state of an unknown kind of style");
	if (s->head.kind - 1 != TS_KIND_SYSTEM)
		return ts_unclaimed_add(r->sim, (enum ts_kind)(s->head.kind - 1), s->name[0], s->name[1],
					s->name[2], s->plain, (size_t)s->head.plain);
	return restore_system(r, s);
}

static enum ts_status restore_all(struct reader *r)
{
	TS_TRY(restore_clock(r));
	for (size_t k = 1; k < r->nsections; k++) {
		TS_TRY(read_again(r, &r->section[k]));
		TS_TRY(restore_section(r, &r->section[k]));
		ts_free(r->section[k].plain);
		r->section[k].plain = NULL;
	}
	return ts_sim_has_box(r->sim) ? TS_OK : refuse_file(r, "is damaged: it has no simulation box");
}

/* A file with valid checksums may still have impossible contents: nothing of it is kept. */
static void discard_state(struct tsim *sim)
{
	sim->has_box = false;
	sim->particles->n = 0;
	ts_unclaimed_free(sim);
}

static enum ts_status read_stream(struct reader *r)
{
	struct stat info;

	r->twice = ts_files_stat(&r->sim->files, r->path, &info) == 0 && S_ISREG(info.st_mode) &&
		   fseeko(r->file, 0, SEEK_SET) == 0;
	r->left = r->twice ? (uint64_t)info.st_size
			   : UINT64_MAX; /* what sections of a pipe have cannot be known */
	TS_TRY(check_start(r));
	return read_sections(r);
}

static enum ts_status read_file(struct reader *r)
{
	r->file = ts_files_open_along(&r->sim->files, r->path);
	if (!r->file)
		return ts_fail(&r->sim->error, TS_IO, r->where, "cannot open restart file '%s': %s", r->path,
			       ts_files_why(&r->sim->files));
	r->piece = ts_alloc(PIECE, 1);
	return r->piece ? read_stream(r) : ts_nomem(&r->sim->error);
}

static void release(struct reader *r)
{
	if (r->file)
		fclose(r->file);
	for (size_t k = 0; k < r->nsections; k++)
		ts_free(r->section[k].plain);
	ts_arena_release(&r->arena);
	ts_free(r->section);
	ts_free(r->piece);
}

enum ts_status ts_restart_read(struct tsim *sim, const char *path, const struct ts_place *where)
{
	struct reader r = { .sim = sim, .path = path, .where = where };
	enum ts_status status;

	if (ts_sim_has_box(sim))
		return ts_fail(&sim->error, TS_STATE, where,
			       "there is a box already: read_restart comes before create_box");
	status = read_file(&r);
	if (status == TS_OK && (status = restore_all(&r)) != TS_OK)
		discard_state(sim);
	release(&r);
	return status;
}
