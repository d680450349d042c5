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
#include "core/ranks.h"
#include "core/ranks_pause.h"
#include "core/unclaimed_state.h"
#include "io/replace.h"
#include "io/textfile.h"
#include "particle/division.h"
#include "particle/particles.h"
#include "restart/pack.h"
#include "restart/sections.h"
#include "restart/sieve.h"

#include "base/banned.h"

static const enum ts_kind saved_kinds[] = { TS_KIND_SYSTEM, TS_KIND_PAIR,     TS_KIND_BOND,
					    TS_KIND_FLOW,   TS_KIND_FIX,      TS_KIND_COMPUTE,
					    TS_KIND_DUMP,   TS_KIND_PRESSURE, TS_KIND_AUTOMATON };

_Static_assert(TS_KIND_FIX == 2 && TS_KIND_FLOW == 8 && TS_KIND_AUTOMATON == 10,
	       "restart files contain these numbers");

/* ---- contents of the clock section; the same function writes and reads it */

struct run_state {
	struct ts_clock clock;
	int32_t units, dimension;
	uint64_t fingerprint;
	uint8_t any_order; /* 1: the fingerprint does not depend on the order of the particles; older files have none */
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
	if (ts_archive_has(a, "resets"))
		TS_TRY(ts_archive_fixed(a, "resets", TS_SAVED_I64, &c->resets, 1));
	TS_TRY(ts_archive_fixed(a, "fingerprint", TS_SAVED_I64, &s->fingerprint, 1));
	if (!ts_archive_has(a, "any_order")) {
		s->fingerprint = ts_fingerprint_of_old(s->fingerprint);
		return TS_OK;
	}
	return ts_archive_fixed(a, "any_order", TS_SAVED_U8, &s->any_order, 1);
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

static enum ts_status write_packed(struct writer *w, struct ts_section_head *head, const char *const names[],
				   const struct packed *packed)
{
	head->packed = packed->n;
	head->sum = ts_crc32(0, packed->bytes, packed->n);
	for (int k = 0; k < TS_SECTION_NAMES; k++)
		head->name_length[k] = (uint32_t)strlen(names[k]);
	TS_TRY(write_bytes(w, head, sizeof *head));
	for (int k = 0; k < TS_SECTION_NAMES; k++)
		TS_TRY(write_bytes(w, names[k], head->name_length[k]));
	w->sum = (uint32_t)crc32_combine(w->sum, head->sum, (z_off_t)packed->n);
	return ts_replace_write(&w->out, packed->bytes, packed->n);
}

/* Compresses the contents of the archive and writes them as a section. */
static enum ts_status write_section(struct writer *w, uint32_t kind, const char *const names[],
				    struct ts_archive *archive)
{
	struct ts_section_head head = { .kind = kind };
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

static const char *const no_names[TS_SECTION_NAMES] = { "", "", "" };

static enum ts_status write_script_state(struct writer *w)
{
	struct tsim *sim = w->sim;
	struct ts_archive *archive = ts_archive_new(sim, true);
	enum ts_status status;

	if (!archive)
		return ts_nomem(&sim->error);
	status = sim->script_api->archive(sim->script_api_data, archive);
	if (status == TS_OK)
		status = write_section(w, TS_RESTART_SCRIPT_SECTION, no_names, archive);
	ts_archive_free(archive);
	return status;
}

static enum ts_status write_clock(struct writer *w)
{
	struct tsim *sim = w->sim;
	struct run_state s = { sim->clock, (int32_t)sim->units, sim->dimension, sim->run.fingerprint, 1,
			       sim->era };
	struct ts_archive *archive = ts_archive_new(sim, true);
	enum ts_status status;

	if (!archive)
		return ts_nomem(&sim->error);
	status = archive_run_state(archive, &s);
	if (status == TS_OK)
		status = write_section(w, TS_RESTART_CLOCK_SECTION, no_names, archive);
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

/* Of a pair, bond or flow style at least the name and the arguments: the run that reads the file warns if it has none. */
static bool is_saved(const struct ts_style *style)
{
	return style->saved || style->archive || ts_unclaimed_is_model(style->kind);
}

static enum ts_status write_all(struct writer *w)
{
	const uint32_t mark[2] = { TS_RESTART_BYTE_ORDER_MARK, TS_RESTART_VERSION };
	uint32_t end[2] = { TS_RESTART_END_SECTION, 0 };

	TS_TRY(write_bytes(w, TS_RESTART_MAGIC, TS_RESTART_MAGIC_LENGTH));
	TS_TRY(write_bytes(w, mark, sizeof mark));
	TS_TRY(write_clock(w));
	if (w->sim->script_api && w->sim->script_api->archive)
		TS_TRY(write_script_state(w));
	for (size_t k = 0; k < sizeof saved_kinds / sizeof *saved_kinds; k++) {
		struct ts_instances *list = &w->sim->instances[saved_kinds[k]];

		for (size_t i = 0; i < list->n; i++)
			if (is_saved(list->item[i]->style))
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
		TS_TRY(ts_fingerprint_renew(sim));
	TS_TRY(ts_replace_begin(&w.out, sim, where, path));
	status = write_all(&w);
	if (status == TS_OK)
		status = ts_replace_commit(&w.out, true);
	ts_replace_abandon(&w.out);
	return status;
}

/* ---- restoring */

/* Restores run state, instance, or (both NULL) variables of the script from a section. */
static enum ts_status restore_from(struct ts_sections *r, const struct ts_section *s, struct run_state *clock,
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

static enum ts_status restore_clock(struct ts_sections *r)
{
	static const char *const units[] = { "lj", "si", "cgs", "micro" };
	struct tsim *sim = r->sim;
	struct run_state s = { 0 };

	if (!r->nsections || r->section[0].head.kind != TS_RESTART_CLOCK_SECTION)
		return ts_sections_refuse(r, "is damaged: it does not begin with the clock");
	TS_TRY(ts_sections_again(r, &r->section[0]));
	TS_TRY(restore_from(r, &r->section[0], &s, NULL));
	if (s.units < 0 || s.units > TS_UNITS_MICRO || (s.dimension != 2 && s.dimension != 3))
		return ts_sections_refuse(r, "is damaged: unknown units or dimension");
	if (s.clock.base_step < 0 || s.clock.step < s.clock.base_step || !isfinite(s.clock.base_time) ||
	    !isfinite(s.clock.dt))
		return ts_sections_refuse(r, "is damaged: impossible step or time");
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
static enum ts_status restore_system(struct ts_sections *r, const struct ts_section *s)
{
	struct ts_instance *inst = ts_sim_find(r->sim, TS_KIND_SYSTEM, s->name[0]);

	if (!inst)
		return ts_sections_refuse(r, "holds the state of a system this program does not have");
	while (r->sim->tables->systems[r->system] &&
	       &r->sim->tables->systems[r->system]->style != inst->style)
		r->system++;
	if (!r->sim->tables->systems[r->system])
		return ts_sections_refuse(r, "is damaged: its sections are out of order");
	r->system++;
	return restore_from(r, s, NULL, inst);
}

static enum ts_status restore_section(struct ts_sections *r, const struct ts_section *s)
{
	if (s->head.kind == TS_RESTART_SCRIPT_SECTION)
		return restore_from(r, s, NULL, NULL);
	if (s->head.kind == 0 || s->head.kind > TS_NKIND)
		return ts_sections_refuse(r, "holds the state of an unknown kind of style");
	if (s->head.kind - 1 != TS_KIND_SYSTEM)
		return ts_unclaimed_add(r->sim, (enum ts_kind)(s->head.kind - 1), s->name[0], s->name[1],
					s->name[2], s->plain, (size_t)s->head.plain);
	return restore_system(r, s);
}

/* ---- several ranks, each of which restores the particles of its block */

enum { PARTICLES, CONTACTS };
static const char *const divided[] = { [PARTICLES] = "particles", [CONTACTS] = "neigh" };

static bool is_system(const struct ts_section *s, const char *name)
{
	return s->head.kind == TS_KIND_SYSTEM + 1 && strcmp(s->name[0], name) == 0;
}

static enum ts_status note_longest(void *data, const char *name, const struct ts_archive_head *head)
{
	uint64_t *longest = data;

	(void)name;
	*longest = head->count > *longest ? head->count : *longest;
	return TS_OK;
}

static enum ts_status skip_bytes(void *data, const unsigned char *bytes, size_t n)
{
	(void)data, (void)bytes, (void)n;
	return TS_OK;
}

static enum ts_status skip_end(void *data)
{
	(void)data;
	return TS_OK;
}

/* Elements of the longest field of a section that has been read. */
static uint64_t longest_field(const struct ts_section *s)
{
	uint64_t longest = 0;
	const struct ts_archive_taker taker = { note_longest, skip_bytes, skip_end, &longest };
	struct ts_archive_pieces pieces;

	ts_archive_pieces_begin(&pieces, &taker, s->head.plain);
	if (ts_archive_pieces_add(&pieces, s->plain, (size_t)s->head.plain) != TS_OK)
		return UINT64_MAX;
	return longest;
}

/* Whether a section can be restored while each rank has its own particles: it has no number for each particle, bond or body. */
static enum ts_status check_without_rows(struct ts_sections *r, struct ts_section *s, bool *is)
{
	enum { LONGEST = 1 << 20 };
	struct ts_archive *archive;

	*is = s->head.kind == TS_RESTART_SCRIPT_SECTION || s->head.plain < LONGEST;
	if (s->head.kind == TS_RESTART_SCRIPT_SECTION || !*is)
		return TS_OK;
	TS_TRY(ts_sections_again(r, s));
	archive = ts_archive_new(r->sim, false);
	if (!archive)
		return ts_nomem(&r->sim->error);
	*is = ts_archive_from(archive, s->plain, (size_t)s->head.plain) == TS_OK &&
	      longest_field(s) < r->sieve->n;
	if (is_system(s, "bonds"))
		*is &= ts_archive_expect(archive, "tag", TS_SAVED_I32, 0) == TS_OK;
	else if (is_system(s, "rigid") && ts_archive_has(archive, "id"))
		*is &= ts_archive_expect(archive, "id", TS_SAVED_I32, 0) == TS_OK;
	ts_archive_free(archive);
	ts_error_clear(&r->sim->error);
	return TS_OK;
}

static enum ts_status check_others(struct ts_sections *r, bool *can)
{
	for (size_t k = 1; k < r->nsections && *can; k++) {
		struct ts_section *s = &r->section[k];

		if (!is_system(s, "domain") && !is_system(s, divided[PARTICLES]) &&
		    !is_system(s, divided[CONTACTS]))
			TS_TRY(check_without_rows(r, s, can));
	}
	return TS_OK;
}

static void give_up_dividing(struct ts_sections *r)
{
	if (r->sieve)
		ts_sieve_release(r->sieve);
	ts_free(r->sieve);
	r->sieve = NULL;
}

/* The box is restored; finds the particles of this rank. */
static enum ts_status begin_dividing(struct ts_sections *r, const struct ts_section *particles)
{
	struct tsim *sim = r->sim;
	struct ts_archive_taker taker;
	enum ts_status status;
	bool can = true;

	if (ts_ranks(sim) < 2 || !sim->world || !sim->run.pauses || !r->twice || sim->dimension != 3 ||
	    sim->legacy || ts_fingerprint_in_order(sim) || !ts_sim_has_box(sim))
		return TS_OK;
	r->sieve = ts_alloc(1, sizeof *r->sieve);
	if (!r->sieve)
		return ts_nomem(&sim->error);
	r->sieve->sim = sim;
	taker = ts_sieve_places(r->sieve);
	status = ts_sections_expand(r, particles, &taker);
	if (status == TS_OK && !ts_sieve_has_places(r->sieve))
		status = TS_DAMAGED;
	if (status == TS_OK)
		status = check_others(r, &can);
	if (status == TS_DAMAGED && sim->error.status == TS_OK) { /* whoever restores all says why */
		status = TS_OK;
		can = false;
	}
	if (status != TS_OK || !can)
		give_up_dividing(r);
	return status;
}

/* Makes the section of this rank, of its particles or of their contacts. */
static enum ts_status read_own(struct ts_sections *r, struct ts_section *s, int part)
{
	struct ts_archive_taker taker =
		part == PARTICLES ? ts_sieve_particles(r->sieve) : ts_sieve_contacts(r->sieve);
	enum ts_status status;
	size_t n = 0;

	r->whole[part] = *s;
	status = ts_sections_expand(r, s, &taker);
	if (status == TS_DAMAGED && r->sim->error.status == TS_OK)
		return ts_sections_refuse(r, "is damaged: particles or contacts are incomplete");
	TS_TRY(status);
	s->plain = ts_sieve_section(r->sieve, &n);
	s->head.plain = n;
	return s->plain ? TS_OK : ts_nomem(&r->sim->error);
}

/* The bytes of a section that are to be restored. */
static enum ts_status read_section(struct ts_sections *r, struct ts_section *s)
{
	if (is_system(s, divided[PARTICLES]))
		TS_TRY(begin_dividing(r, s));
	for (int part = PARTICLES; r->sieve && part <= CONTACTS; part++)
		if (is_system(s, divided[part]))
			return read_own(r, s, part);
	return ts_sections_again(r, s);
}

/* All ranks get all particles after all, before anything has been computed. */
static enum ts_status restore_part(struct ts_sections *r, int part)
{
	struct ts_section *s = &r->whole[part];
	enum ts_status status;

	if (!s->at) /* there is no such section */
		return TS_OK;
	TS_TRY(ts_sections_again(r, s));
	status = restore_from(r, s, NULL, ts_sim_find(r->sim, TS_KIND_SYSTEM, divided[part]));
	ts_free(s->plain);
	s->plain = NULL;
	return status;
}

static enum ts_status restore_whole(struct tsim *sim, void *data)
{
	const int lost_policy = sim->particles->lost_policy; /* of the script */
	enum ts_status status = restore_part(data, PARTICLES);

	sim->particles->lost_policy = lost_policy;
	return status == TS_OK ? restore_part(data, CONTACTS) : status;
}

static enum ts_status restore_all(struct ts_sections *r)
{
	TS_TRY(restore_clock(r));
	for (size_t k = 1; k < r->nsections; k++) {
		TS_TRY(read_section(r, &r->section[k]));
		TS_TRY(restore_section(r, &r->section[k]));
		ts_free(r->section[k].plain);
		r->section[k].plain = NULL;
	}
	if (!ts_sim_has_box(r->sim))
		return ts_sections_refuse(r, "is damaged: it has no simulation box");
	r->sim->continued = true;
	return ts_unclaimed_apply_earlier(r->sim);
}

/* A file with valid checksums may still have impossible contents: nothing of it is kept. */
static void discard_state(struct tsim *sim)
{
	sim->has_box = false;
	sim->particles->n = 0;
	ts_unclaimed_free(sim);
}

static void release_all(void *reader)
{
	give_up_dividing(reader);
	ts_sections_close(reader);
	ts_free(reader);
}

/* What has been restored stays divided: the file is kept for who needs all of it. */
static enum ts_status stay_divided(struct ts_sections *r)
{
	struct ts_plan none = { 0 };
	enum ts_status status = ts_ranks_pause(r->sim, &none);

	give_up_dividing(r);
	if (status == TS_OK)
		ts_division_start(r->sim, &(struct ts_reread){ restore_whole, release_all, r });
	else
		release_all(r);
	return status;
}

static struct ts_sections *new_reader(struct tsim *sim, const char *path, const struct ts_place *where)
{
	struct ts_sections *r = ts_alloc(1, sizeof *r);

	if (!r)
		return NULL;
	r->sim = sim;
	r->path = ts_arena_strdup(&r->arena, path);
	r->place = where ? *where : (struct ts_place){ 0 };
	r->where = where ? &r->place : NULL;
	if (r->path)
		return r;
	release_all(r);
	return NULL;
}

enum ts_status ts_restart_read(struct tsim *sim, const char *path, const struct ts_place *where)
{
	struct ts_sections *r;
	enum ts_status status;

	if (ts_sim_has_box(sim))
		return ts_conflict(&sim->error, where,
				   "there is a box already: read_restart comes before create_box");
	r = new_reader(sim, path, where);
	if (!r)
		return ts_nomem(&sim->error);
	status = ts_sections_open(r);
	if (status == TS_OK && (status = restore_all(r)) != TS_OK)
		discard_state(sim);
	if (status == TS_OK && r->sieve)
		return stay_divided(r);
	release_all(r);
	return status;
}
