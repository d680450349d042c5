#include "wall/wall_contacts.h"

#include <stdlib.h>
#include <string.h>

#include "base/sort.h"
#include "particle/division.h"
#include "particle/identity.h"
#include "particle/particles.h"

#include "base/banned.h"

void ts_wall_contacts_start(struct ts_wall_contacts *c, struct ts_wall_rebuild *rebuild, size_t width)
{
	struct ts_wall_contacts *old = &rebuild->old;

	*old = *c;
	*c = (struct ts_wall_contacts){ .width = width,
					.want_reports = old->want_reports,
					.row = old->row,
					.row_capacity = old->row_capacity,
					.force = old->force,
					.force_capacity = old->force_capacity,
					.expected = old->n + old->n / 8 };
	old->row = NULL;
	old->force = NULL;
	old->row_capacity = old->force_capacity = 0;
}

static enum ts_status reserve_pairs(struct tsim *sim, struct ts_wall_contacts *c, size_t n)
{
	if (TS_GROW(c->row, c->row_capacity, n) != TS_OK || TS_GROW(c->key, c->key_capacity, n) != TS_OK ||
	    TS_GROW(c->touching, c->touching_capacity, n) != TS_OK ||
	    TS_GROW(c->last, c->last_capacity, n) != TS_OK ||
	    TS_GROW(c->memory, c->memory_capacity, n * c->width + 1) != TS_OK ||
	    TS_GROW(c->force, c->force_capacity, n) != TS_OK)
		return ts_nomem(&sim->error);
	return TS_OK;
}

static enum ts_status reserve(struct tsim *sim, struct ts_wall_contacts *c, size_t n)
{
	TS_TRY(reserve_pairs(sim, c, n));
	if (c->want_reports && TS_GROW(c->report, c->report_capacity, n) != TS_OK)
		return ts_nomem(&sim->error);
	return TS_OK;
}

enum ts_status ts_wall_contacts_add(struct tsim *sim, struct ts_wall_contacts *c, size_t i, int element,
				    int image)
{
	TS_TRY(reserve(sim, c, c->n || !c->expected ? c->n + 1 : c->expected));
	c->row[c->n] = (int32_t)i;
	c->key[c->n][0] = sim->particles->tag[i];
	c->key[c->n][1] = element;
	c->key[c->n][2] = image;
	c->touching[c->n] = 0;
	c->last[c->n].overlap = 0;
	for (size_t k = 0; k < c->width; k++)
		c->memory[c->n * c->width + k] = 0;
	ts_wall_contact_zero_force(c, c->n);
	if (c->want_reports)
		c->report[c->n] = (struct ts_wall_report){ 0 };
	c->n++;
	return TS_OK;
}

/* Whether there is anything to copy: most listed particles do not touch. */
static bool has_history(const struct ts_wall_contacts *c, size_t k)
{
	if (ts_wall_report(c, k) || ts_wall_only_conducts(c, k))
		return true;
	for (size_t d = 0; d < c->width; d++)
		if (c->memory[k * c->width + d] != 0)
			return true;
	return false;
}

static int compare_keys(const void *a, const void *b)
{
	int first = ts_compare_int32_pair(a, b);

	return first ? first : ts_compare_int32((const int32_t *)a + 2, (const int32_t *)b + 2);
}

/* Contacts are listed in the order of particles in memory, which a rebuild may change. So the keys of the old
 * contacts are sorted, each with its index, for a binary search. */
static int32_t (*sorted_keys(const struct ts_wall_contacts *c, size_t *n))[TS_WALL_KEY + 1]
{
	int32_t(*list)[TS_WALL_KEY + 1] = ts_alloc(c->n, sizeof *list);

	*n = 0;
	for (size_t k = 0; list && k < c->n; k++) {
		if (!has_history(c, k))
			continue;
		memcpy(list[*n], c->key[k], sizeof *c->key);
		list[(*n)++][TS_WALL_KEY] = (int32_t)k;
	}
	if (list)
		ts_sort(list, *n, sizeof *list, compare_keys);
	return list;
}

/* Contact k of the new list continues contact `was` of the old one. */
static void copy_history(struct ts_wall_contacts *c, size_t k, const struct ts_wall_contacts *old, size_t was,
			 bool last)
{
	c->touching[k] = 1;
	if (last)
		c->last[k] = old->last[was];
	if (c->width && c->width == old->width)
		memcpy(ts_wall_memory(c, k), ts_wall_memory(old, was), c->width * sizeof *c->memory);
	if (c->report && old->report)
		c->report[k] = old->report[was];
}

enum ts_status ts_wall_contacts_finish(struct tsim *sim, struct ts_wall_contacts *c,
				       struct ts_wall_rebuild *rebuild)
{
	const struct ts_wall_contacts *old = &rebuild->old;
	bool some = old->n && c->n && ((c->width && old->width == c->width) || old->report);
	/* the list is made again within a step, for all particles on each rank */
	bool remade = sim->particles->division && sim->particles->division->rebuilding;
	size_t n = 0;
	int32_t(*list)[TS_WALL_KEY + 1] = some ? sorted_keys(old, &n) : NULL;
	int (*compare)(const void *, const void *) = old->old_keys ? ts_compare_int32_pair : compare_keys;

	for (size_t k = 0; n && k < c->n; k++) {
		const int32_t *found = bsearch(c->key[k], list, n, sizeof *list, compare);

		if (found)
			copy_history(c, k, old, (size_t)found[TS_WALL_KEY], remade);
	}
	ts_wall_contacts_release(&rebuild->old);
	if (some && !list)
		return ts_nomem(&sim->error);
	ts_free(list);
	return TS_OK;
}

void ts_wall_contact_reset(struct ts_wall_contacts *c, size_t k)
{
	ts_wall_contact_zero_force(c, k);
	c->touching[k] = 0;
	c->last[k].overlap = 0;
	if (c->width)
		memset(ts_wall_memory(c, k), 0, c->width * sizeof *c->memory);
	if (c->report)
		c->report[k] = (struct ts_wall_report){ 0 };
}

struct split {
	const struct ts_wall_contacts *c;
	ts_range_fn *share;
	void *context;
};

/* Index of the first contact of the next particle, at k or after it. */
static size_t next_particle(const struct ts_wall_contacts *c, size_t k)
{
	while (k > 0 && k < c->n && c->row[k] == c->row[k - 1])
		k++;
	return k;
}

static void share_whole_particles(void *context, size_t from, size_t to)
{
	const struct split *split = context;

	split->share(split->context, next_particle(split->c, from), next_particle(split->c, to));
}

void ts_wall_contacts_parallel(const struct tsim *sim, const struct ts_wall_contacts *c, ts_range_fn *share,
			       void *context)
{
	struct split split = { c, share, context };

	/* a contact costs as much as about 64 particles of simple loops */
	ts_parallel(ts_team(sim, 64 * c->n), c->n, share_whole_particles, &split);
}

enum ts_status ts_wall_contacts_give(struct tsim *sim, struct ts_wall_contacts *c,
				     const struct ts_leaving *leaving, struct ts_carried *out)
{
	size_t memory = c->width * sizeof *c->memory;

	out->bytes = sizeof *c->key + memory + sizeof *c->last + (c->want_reports ? sizeof *c->report : 0);
	for (size_t k = 0; k < c->n; k++) {
		unsigned char *row;

		if (!has_history(c, k) || (leaving && !ts_carried_leaves(leaving, c->key[k][0])))
			continue;
		row = ts_carried_add(out, c->key[k][0]);
		if (!row)
			return ts_nomem(&sim->error);
		memcpy(row, c->key[k], sizeof *c->key);
		row += sizeof *c->key;
		memcpy(row, ts_wall_memory(c, k), memory);
		row += memory;
		memcpy(row, &c->last[k], sizeof *c->last);
		if (c->report)
			memcpy(row + sizeof *c->last, &c->report[k], sizeof *c->report);
	}
	if (!leaving)
		c->n = 0;
	return TS_OK;
}

/* The next rebuild continues these contacts; until then only their keys and histories are read. */
enum ts_status ts_wall_contacts_take(struct tsim *sim, struct ts_wall_contacts *c,
				     const struct ts_carried *rows)
{
	size_t n = ts_carried_count(rows), memory = c->width * sizeof *c->memory;

	for (size_t k = 0; k < n; k++) {
		int32_t tag;
		const unsigned char *row = ts_carried_row(rows, k, &tag);

		size_t at = c->n;

		TS_TRY(ts_wall_contacts_add(sim, c, 0, 0, 0));
		memcpy(c->key[at], row, sizeof *c->key);
		row += sizeof *c->key;
		memcpy(ts_wall_memory(c, at), row, memory);
		row += memory;
		memcpy(&c->last[at], row, sizeof *c->last);
		if (c->report)
			memcpy(&c->report[at], row + sizeof *c->last, sizeof *c->report);
	}
	return TS_OK;
}

/* Reports are stored only if an output needs them. Those of older files have no heat flow and are ignored: the next
 * step makes new ones. */
static enum ts_status archive_reports(struct ts_archive *archive, struct tsim *sim,
				      struct ts_wall_contacts *c)
{
	static const char name[] = "conducting_reports";
	bool there = ts_archive_writing(archive) ? c->report != NULL : ts_archive_has(archive, name);

	if (!there)
		return TS_OK;
	if (TS_GROW(c->report, c->report_capacity, c->n) != TS_OK)
		return ts_nomem(&sim->error);
	return ts_archive_fixed(archive, name, TS_SAVED_F64, c->report, c->n * TS_WALL_REPORT);
}

/* The numbers of images are an array of their own, which older files do not have. */
static enum ts_status archive_keys(struct ts_archive *archive, struct tsim *sim, struct ts_wall_contacts *c)
{
	static const char images[] = "contact_images";
	int32_t *flat = ts_alloc(TS_WALL_KEY * c->n, sizeof *flat);
	enum ts_status status;

	if (!flat)
		return ts_nomem(&sim->error);
	c->old_keys = !ts_archive_writing(archive) && !ts_archive_has(archive, images);
	for (size_t k = 0; k < c->n; k++) {
		memcpy(flat + 2 * k, c->key[k], 2 * sizeof *flat);
		flat[2 * c->n + k] = c->key[k][2];
	}
	status = ts_archive_fixed(archive, "contact_keys", TS_SAVED_I32, flat, 2 * c->n);
	if (status == TS_OK && !c->old_keys)
		status = ts_archive_fixed(archive, images, TS_SAVED_I32, flat + 2 * c->n, c->n);
	for (size_t k = 0; k < c->n; k++) {
		memcpy(c->key[k], flat + 2 * k, 2 * sizeof *flat);
		c->key[k][2] = flat[2 * c->n + k];
	}
	ts_free(flat);
	return status;
}

static enum ts_status archive_all(struct ts_archive *archive, struct tsim *sim, struct ts_wall_contacts *c)
{
	TS_TRY(archive_keys(archive, sim, c));
	TS_TRY(ts_archive_fixed(archive, "contact_memory", TS_SAVED_F64, c->memory, c->n * c->width));
	return archive_reports(archive, sim, c);
}

/* Which other pairs are listed depends on when lists were made last, which a run that goes on from the file does not
 * know. */
static enum ts_status copy_with_history(struct tsim *sim, const struct ts_wall_contacts *c,
					struct ts_wall_contacts *kept)
{
	for (size_t k = 0; k < c->n; k++) {
		size_t at = kept->n;

		if (!has_history(c, k))
			continue;
		TS_TRY(ts_wall_contacts_add(sim, kept, 0, 0, 0));
		memcpy(kept->key[at], c->key[k], sizeof *c->key);
		copy_history(kept, at, c, k, false);
	}
	return TS_OK;
}

static enum ts_status write_with_history(struct ts_archive *archive, struct tsim *sim,
					 const struct ts_wall_contacts *c)
{
	struct ts_wall_contacts kept = { .width = c->width, .want_reports = c->report != NULL };
	enum ts_status status = copy_with_history(sim, c, &kept);
	int64_t size[2] = { (int64_t)kept.n, (int64_t)kept.width };

	if (status == TS_OK)
		status = ts_archive_fixed(archive, "contacts", TS_SAVED_I64, size, 2);
	if (status == TS_OK)
		status = archive_all(archive, sim, &kept);
	ts_wall_contacts_release(&kept);
	return status;
}

static enum ts_status read_contacts(struct ts_archive *archive, struct tsim *sim, struct ts_wall_contacts *c)
{
	int64_t size[2];

	if (!ts_archive_has(archive, "contacts")) /* files of version 1 have no wall contacts */
		return TS_OK;
	TS_TRY(ts_archive_fixed(archive, "contacts", TS_SAVED_I64, size, 2));
	if (size[0] < 0 || size[0] > INT32_MAX || size[1] < 0 || size[1] > 1024)
		return ts_fail(&sim->error, TS_DAMAGED, NULL, "impossible contacts with a wall");
	TS_TRY(ts_archive_expect(archive, "contact_keys", TS_SAVED_I32, 2 * (size_t)size[0]));
	TS_TRY(ts_archive_expect(archive, "contact_memory", TS_SAVED_F64, (size_t)size[0] * (size_t)size[1]));
	ts_wall_contacts_release(c);
	c->n = (size_t)size[0];
	c->width = (size_t)size[1];
	TS_TRY(reserve_pairs(sim, c, c->n));
	return archive_all(archive, sim, c);
}

enum ts_status ts_wall_contacts_archive(struct ts_archive *archive, struct tsim *sim,
					struct ts_wall_contacts *c)
{
	return ts_archive_writing(archive) ? write_with_history(archive, sim, c)
					   : read_contacts(archive, sim, c);
}

static bool is_connected(const struct ts_wall_contacts *c, const struct ts_particles *p)
{
	for (size_t k = 0; k < c->n; k++) {
		size_t i = (size_t)c->row[k];

		if (i >= p->n || p->tag[i] != c->key[k][0])
			return false;
	}
	return true;
}

enum ts_status ts_wall_contacts_connect(struct tsim *sim, struct ts_wall_contacts *c)
{
	struct ts_identities map;

	if (sim->run.epoch || sim->division || is_connected(c, sim->particles))
		return TS_OK;
	TS_TRY(ts_identities(sim, false, &map));
	for (size_t k = 0; k < c->n; k++)
		c->row[k] = ts_identity_row(&map, c->key[k][0]);
	return TS_OK;
}

void ts_wall_contacts_release(struct ts_wall_contacts *c)
{
	ts_free(c->row);
	ts_free(c->key);
	ts_free(c->touching);
	ts_free(c->last);
	ts_free(c->memory);
	ts_free(c->force);
	ts_free(c->report);
	*c = (struct ts_wall_contacts){ .want_reports = c->want_reports };
}
