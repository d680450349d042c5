/* The list of bonds: adding, deleting, archiving, and the local indices of partners after a rebuild. */
#include "bond/bonds.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/sort.h"
#include "box/domain.h"
#include "core/report.h"
#include "math/vec3.h"
#include "neigh/coincide.h"
#include "neigh/neigh.h"
#include "particle/identity.h"
#include "particle/particles.h"

#include "base/banned.h"

const char *ts_bond_failure_name(int mode)
{
	static const char *const name[TS_BOND_FAILURES] = {
		[TS_BOND_FORCE] = "force",   [TS_BOND_TENSION] = "tension",
		[TS_BOND_SHEARED] = "shear", [TS_BOND_CRUSHED] = "compression",
		[TS_BOND_CUT] = "cut",	     [TS_BOND_HEATED] = "temperature",
	};

	return mode >= 0 && mode < TS_BOND_FAILURES ? name[mode] : "unknown";
}

static enum ts_status reserve_bonds(struct ts_bonds *b, size_t n)
{
	size_t start = b->capacity, capacity = start;

#define GROW_COLUMN(column)                              \
	do {                                             \
		capacity = start;                        \
		TS_TRY(TS_GROW(b->column, capacity, n)); \
	} while (0)
	GROW_COLUMN(tag);
	GROW_COLUMN(type);
	GROW_COLUMN(rest);
	GROW_COLUMN(row);
	GROW_COLUMN(tension);
	GROW_COLUMN(breaks);
#undef GROW_COLUMN
	b->capacity = capacity;
	if (b->softens) {
		TS_TRY(TS_GROW(b->damage, b->damage_capacity, n));
		TS_TRY(TS_GROW(b->lost, b->lost_capacity, n));
	}
	if (!b->transmits)
		return TS_OK;
	TS_TRY(TS_GROW(b->reference, b->reference_capacity, n));
	return TS_GROW(b->load, b->load_capacity, n);
}

enum ts_status ts_bonds_transmit(struct tsim *sim, bool moments)
{
	struct ts_bonds *b = sim->bonds;

	if (b->transmits == moments)
		return TS_OK;
	b->transmits = moments;
	if (moments) {
		if (reserve_bonds(b, b->n + 1) != TS_OK)
			return ts_nomem(&sim->error);
		memset(b->reference, 0, b->n * sizeof *b->reference);
		memset(b->load, 0, b->n * sizeof *b->load);
		return TS_OK;
	}
	ts_free(b->reference);
	ts_free(b->load);
	b->reference = NULL;
	b->load = NULL;
	b->reference_capacity = b->load_capacity = 0;
	return TS_OK;
}

enum ts_status ts_bonds_soften(struct tsim *sim, bool softens)
{
	struct ts_bonds *b = sim->bonds;

	if (b->softens == softens)
		return TS_OK;
	b->softens = softens;
	if (softens) {
		if (reserve_bonds(b, b->n + 1) != TS_OK)
			return ts_nomem(&sim->error);
		memset(b->damage, 0, b->n * sizeof *b->damage);
		return TS_OK;
	}
	ts_free(b->damage);
	ts_free(b->lost);
	b->damage = NULL;
	b->lost = NULL;
	b->damage_capacity = b->lost_capacity = 0;
	return TS_OK;
}

enum ts_status ts_bonds_add(struct tsim *sim, int32_t tag_a, int32_t tag_b, int type, double rest)
{
	struct ts_bonds *b = sim->bonds;

	if (reserve_bonds(b, b->n + 1) != TS_OK)
		return ts_nomem(&sim->error);
	b->tag[b->n][0] = tag_a < tag_b ? tag_a : tag_b;
	b->tag[b->n][1] = tag_a < tag_b ? tag_b : tag_a;
	b->type[b->n] = type;
	b->rest[b->n] = rest;
	b->tension[b->n] = 0;
	if (b->transmits) {
		b->reference[b->n] = (struct ts_bond_reference){ 0 };
		b->load[b->n] = (struct ts_bond_load){ 0 };
	}
	if (b->softens)
		b->damage[b->n] = (struct ts_bond_damage){ 0 };
	b->n++;
	b->created++;
	return TS_OK;
}

static int compare_tags(const int32_t a[2], const int32_t b[2])
{
	if (a[0] != b[0])
		return a[0] < b[0] ? -1 : 1;
	return (a[1] > b[1]) - (a[1] < b[1]);
}

/* The bond that comes next. */
struct place {
	int32_t tag[2];
	uint32_t from;
};

static int compare_places(const void *a, const void *b)
{
	const struct place *p = a, *q = b;
	int c = compare_tags(p->tag, q->tag);

	return c ? c : (p->from > q->from) - (p->from < q->from);
}

/* Sorts a column, whose elements have `size` bytes. */
static void reorder(void *column, size_t size, const struct place *order, size_t n, char *room)
{
	for (size_t k = 0; k < n; k++)
		memcpy(room + k * size, (char *)column + order[k].from * size, size);
	memcpy(column, room, n * size);
}

static bool is_sorted(const struct ts_bonds *b)
{
	for (size_t k = 1; k < b->n; k++)
		if (compare_tags(b->tag[k - 1], b->tag[k]) > 0)
			return false;
	return true;
}

void ts_bonds_sort(struct ts_bonds *b)
{
	const struct {
		void *column;
		size_t size;
		bool there;
	} part[] = {
		{ b->tag, sizeof *b->tag, true },
		{ b->type, sizeof *b->type, true },
		{ b->rest, sizeof *b->rest, true },
		{ b->reference, sizeof *b->reference, b->transmits },
		{ b->load, sizeof *b->load, b->transmits },
		{ b->damage, sizeof *b->damage, b->softens },
	};
	size_t widest = 0;
	struct place *order;
	char *room;

	if (is_sorted(b))
		return;
	for (size_t k = 0; k < sizeof part / sizeof *part; k++)
		if (part[k].there && part[k].size > widest)
			widest = part[k].size;
	order = ts_alloc(b->n, sizeof *order);
	room = ts_alloc(b->n, widest);
	for (size_t k = 0; order && k < b->n; k++)
		order[k] = (struct place){ { b->tag[k][0], b->tag[k][1] }, (uint32_t)k };
	if (order && room) { /* the order only matters for the speed of look-up and for reproducible lists */
		ts_sort(order, b->n, sizeof *order, compare_places);
		for (size_t k = 0; k < sizeof part / sizeof *part; k++)
			if (part[k].there)
				reorder(part[k].column, part[k].size, order, b->n, room);
	}
	ts_free(order);
	ts_free(room);
}

bool ts_bonds_has(const struct ts_bonds *b, int32_t tag_a, int32_t tag_b)
{
	int32_t wanted[2] = { tag_a < tag_b ? tag_a : tag_b, tag_a < tag_b ? tag_b : tag_a };
	size_t lo = 0, hi = b->n;

	while (lo < hi) {
		size_t mid = (lo + hi) / 2;
		int c = compare_tags(b->tag[mid], wanted);

		if (c == 0)
			return true;
		if (c < 0)
			lo = mid + 1;
		else
			hi = mid;
	}
	return false;
}

void ts_bonds_delete(struct ts_bonds *b, const unsigned char *flag)
{
	size_t kept = 0;

	for (size_t k = 0; k < b->n; k++) {
		if (flag[k])
			continue;
		memcpy(b->tag[kept], b->tag[k], sizeof b->tag[k]);
		memcpy(b->row[kept], b->row[k], sizeof b->row[k]);
		b->type[kept] = b->type[k];
		b->rest[kept] = b->rest[k];
		if (b->transmits) {
			b->reference[kept] = b->reference[k];
			b->load[kept] = b->load[k];
		}
		if (b->softens)
			b->damage[kept] = b->damage[k];
		b->tension[kept++] = b->tension[k];
	}
	b->n = kept;
}

static enum ts_status delete_bonds_of_lost_particles(struct tsim *sim, struct ts_bonds *b,
						     const struct ts_identities *map)
{
	unsigned char *lost = ts_alloc(b->n, 1);

	if (!lost)
		return ts_nomem(&sim->error);
	for (size_t k = 0; k < b->n; k++) {
		lost[k] = ts_identity_row(map, b->tag[k][0]) < 0 || ts_identity_row(map, b->tag[k][1]) < 0;
		b->gone += lost[k];
	}
	ts_bonds_delete(b, lost);
	ts_free(lost);
	return TS_OK;
}

enum ts_status ts_bonds_build_index(struct tsim *sim)
{
	struct ts_bonds *b = sim->bonds;
	struct ts_gather_pairs pairs = { .n = b->n, .stride = 2 };

	for (int s = 0; s < 2 && b->n; s++) {
		pairs.end[s] = &b->row[0][s];
		pairs.tag[s] = &b->tag[0][s];
	}
	if (b->n)
		memset(b->breaks, 0, b->n);
	if (ts_gather_index(sim, &b->gather, &pairs) != TS_OK ||
	    (b->transmits ? ts_bond_rows_build(sim, b) : ts_bond_slices_build(sim, b)) != TS_OK)
		return ts_nomem(&sim->error);
	return TS_OK;
}

static bool are_bonded(const struct tsim *sim, int32_t tag_a, int32_t tag_b)
{
	return ts_bonds_has(sim->bonds, tag_a, tag_b);
}

static void connect_bonds(struct tsim *sim)
{
	sim->neigh->callback.bonded = are_bonded;
}

static enum ts_status init_bonds(struct ts_instance *self, struct tsim *sim)
{
	(void)sim;
	/* outputs that read tensions set it in their init */
	((struct ts_bonds *)self->state)->shown = false;
	return TS_OK;
}

double ts_bond_separation(const struct tsim *sim, size_t i, size_t j, double d[3])
{
	const struct ts_particles *p = sim->particles;

	for (int k = 0; k < 3; k++)
		d[k] = p->x[i][k] - p->x[j][k];
	ts_box_nearest(&sim->domain->box, d);
	return ts_norm(d);
}

static enum ts_status refuse_coincident_partners(struct tsim *sim, const struct ts_bonds *b)
{
	double d[3];

	for (size_t k = 0; k < b->n; k++) {
		size_t i = (size_t)b->row[k][0], j = (size_t)b->row[k][1];

		TS_TRY(ts_coincide_bond(sim, NULL, i, j, ts_bond_separation(sim, i, j, d)));
	}
	return TS_OK;
}

enum ts_status ts_bonds_connect(struct tsim *sim)
{
	struct ts_bonds *b = sim->bonds;
	struct ts_identities map;

	if (!b->n)
		return TS_OK;
	TS_TRY(ts_identities(sim, false, &map));
	TS_TRY(delete_bonds_of_lost_particles(sim, b, &map));
	for (size_t k = 0; k < b->n; k++)
		for (int s = 0; s < 2; s++)
			b->row[k][s] = ts_identity_row(&map, b->tag[k][s]);
	TS_TRY(refuse_coincident_partners(sim, b));
	return ts_bonds_build_index(sim);
}

/* After a rebuild local indices have changed, and particles may have left. */
static enum ts_status update_partner_indices(struct ts_instance *self, struct tsim *sim)
{
	(void)self;
	return ts_bonds_connect(sim);
}

static enum ts_status check_restored_bonds(struct tsim *sim, const struct ts_bonds *b)
{
	int32_t max_tag = sim->particles->max_tag;

	for (size_t k = 0; k < b->n; k++)
		if (b->tag[k][0] < 1 || b->tag[k][0] > max_tag || b->tag[k][1] < 1 ||
		    b->tag[k][1] > max_tag || b->tag[k][0] == b->tag[k][1] || b->type[k] < 1 ||
		    b->type[k] > b->ntypes || !isfinite(b->rest[k]))
			return ts_fail(&sim->error, TS_DAMAGED, NULL,
				       "bond %zu has an invalid partner or type", k + 1);
	return TS_OK;
}

static enum ts_status archive_moments(struct tsim *sim, struct ts_bonds *b, struct ts_archive *a)
{
	enum { REFERENCE = sizeof *b->reference / sizeof(double), LOAD = sizeof *b->load / sizeof(double) };

	if (ts_archive_writing(a) ? !b->transmits : !ts_archive_has(a, "reference"))
		return TS_OK;
	TS_TRY(ts_bonds_transmit(sim, true));
	TS_TRY(ts_archive_fixed(a, "reference", TS_SAVED_F64, b->reference, REFERENCE * b->n));
	return ts_archive_fixed(a, "load", TS_SAVED_F64, b->load, LOAD * b->n);
}

static enum ts_status archive_damage(struct tsim *sim, struct ts_bonds *b, struct ts_archive *a)
{
	enum { DAMAGE = sizeof *b->damage / sizeof(double) };

	if (ts_archive_writing(a) ? !b->softens : !ts_archive_has(a, "damage"))
		return TS_OK;
	TS_TRY(ts_bonds_soften(sim, true));
	return ts_archive_fixed(a, "damage", TS_SAVED_F64, b->damage, DAMAGE * b->n);
}

static enum ts_status archive_bonds(struct ts_instance *self, struct tsim *sim, struct ts_archive *a)
{
	struct ts_bonds *b = self->state;
	int64_t n[2] = { (int64_t)b->n, (int64_t)b->nevents };
	int32_t ntypes = b->ntypes;

	TS_TRY(ts_archive_fixed(a, "n", TS_SAVED_I64, n, 2));
	TS_TRY(ts_archive_fixed(a, "ntypes", TS_SAVED_I32, &ntypes, 1));
	b->ntypes = ntypes;
	if (n[0] < 0 || n[0] > INT32_MAX || n[1] < 0 || n[1] > INT32_MAX)
		return ts_fail(&sim->error, TS_DAMAGED, NULL, "impossible number of bonds");
	TS_TRY(ts_archive_expect(a, "tag", TS_SAVED_I32, 2 * (size_t)n[0]));
	TS_TRY(ts_archive_expect(a, "events", TS_SAVED_U8, (size_t)n[1] * sizeof *b->event));
	if (reserve_bonds(b, (size_t)n[0]) != TS_OK ||
	    TS_GROW(b->event, b->event_capacity, (size_t)n[1]) != TS_OK ||
	    TS_GROW(b->event_energy, b->energy_capacity, (size_t)n[1]) != TS_OK)
		return ts_nomem(&sim->error);
	b->n = (size_t)n[0];
	b->nevents = (size_t)n[1];
	TS_TRY(ts_archive_fixed(a, "tag", TS_SAVED_I32, b->tag, 2 * b->n));
	TS_TRY(ts_archive_fixed(a, "type", TS_SAVED_I32, b->type, b->n));
	TS_TRY(ts_archive_fixed(a, "rest", TS_SAVED_F64, b->rest, b->n));
	TS_TRY(ts_archive_fixed(a, "tension", TS_SAVED_F64, b->tension, b->n));
	TS_TRY(archive_moments(sim, b, a));
	TS_TRY(archive_damage(sim, b, a));
	TS_TRY(ts_archive_fixed(a, "events", TS_SAVED_U8, b->event, b->nevents * sizeof *b->event));
	if (ts_archive_writing(a) || ts_archive_has(a, "event_energy"))
		TS_TRY(ts_archive_fixed(a, "event_energy", TS_SAVED_F64, b->event_energy, b->nevents));
	else
		for (size_t k = 0; k < b->nevents; k++)
			b->event_energy[k] = NAN;
	return ts_archive_writing(a) ? TS_OK : check_restored_bonds(sim, b);
}

static void fingerprint_bonds(const struct ts_instance *self, const struct tsim *sim, struct ts_hash *hash)
{
	const struct ts_bonds *b = self->state;

	(void)sim;
	ts_hash_add(hash, &b->n, sizeof b->n);
	if (!b->n)
		return;
	ts_hash_add(hash, b->tag, b->n * sizeof *b->tag);
	ts_hash_add(hash, b->type, b->n * sizeof *b->type);
	ts_hash_add(hash, b->rest, b->n * sizeof *b->rest);
	if (b->transmits)
		ts_hash_add(hash, b->reference, b->n * sizeof *b->reference);
	if (b->softens)
		ts_hash_add(hash, b->damage, b->n * sizeof *b->damage);
}

static enum ts_status report_memory(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report)
{
	const struct ts_bonds *b = self->state;
	size_t bytes = 4 * sizeof(double) + 11 * sizeof(int32_t);

	if (b->transmits)
		bytes += sizeof *b->reference + sizeof *b->load +
			 (sizeof(struct ts_bond_row) + sizeof(struct ts_bond_sections)) / TS_BOND_LANES;
	if (b->softens)
		bytes += sizeof *b->damage + sizeof *b->lost +
			 sizeof(struct ts_bond_softening) / TS_BOND_LANES;
	(void)sim;
	report->bytes += (double)(b->n * bytes);
	if (b->n)
		ts_report_line(report, "bonds", "%zu, %zu bytes each", b->n, bytes);
	return TS_OK;
}

static void release_bonds(struct ts_instance *self)
{
	struct ts_bonds *b = self->state;

	ts_free(b->tag);
	ts_free(b->type);
	ts_free(b->rest);
	ts_free(b->row);
	ts_free(b->tension);
	ts_free(b->breaks);
	ts_free(b->reference);
	ts_free(b->load);
	ts_free(b->damage);
	ts_free(b->lost);
	ts_gather_release(&b->gather);
	ts_bond_slices_release(&b->slices);
	ts_bond_rows_release(&b->rows);
	ts_free(b->event);
	ts_free(b->event_energy);
}

static enum ts_status count_bonds(struct tsim *sim, double *out)
{
	*out = (double)sim->bonds->n;
	return TS_OK;
}

static enum ts_status count_broken(struct tsim *sim, double *out)
{
	*out = (double)sim->bonds->broken;
	return TS_OK;
}

static enum ts_status count_gone(struct tsim *sim, double *out)
{
	*out = (double)sim->bonds->gone;
	return TS_OK;
}

static const struct ts_keyword keywords[] = {
	{ "bonds", "Bonds", "", "number of bonds", 1, count_bonds },
	{ "numbonds", "numbonds", "", "number of bonds", 1, count_bonds },
	{ "numbond", "numbond", "", "number of bonds", 1, count_bonds },
	{ "brokenbonds", "Broken", "", "bonds broken so far", 1, count_broken },
	{ "gonebonds", "GoneBond", "", "unbroken bonds removed with particles that left", 1, count_gone },
	{ .name = NULL },
};

static const struct ts_saved saved[] = {
	TS_SAVE_I64(struct ts_bonds, created),
	TS_SAVE_I64(struct ts_bonds, broken),
	TS_SAVE_I64(struct ts_bonds, gone),
	TS_SAVED_ROWS_END,
};

static const char *undivided(const struct tsim *sim)
{
	return sim->bonds->n ? "a scene with bonds" : NULL;
}

const struct ts_system_style ts_bonds_system = {
	.style = { .name = "bonds",
		   .kind = TS_KIND_SYSTEM,
		   .summary = "the list of bonds",
		   .state_size = sizeof(struct ts_bonds),
		   .saved = saved,
		   .archive = archive_bonds,
		   .fingerprint = fingerprint_bonds,
		   .init = init_bonds,
		   .hook = { [TS_STAGE_BUILD] = update_partner_indices },
		   .plan = report_memory,
		   .fini = release_bonds },
	.slot = offsetof(struct tsim, bonds),
	.connect = connect_bonds,
	.undivided = undivided,
	.keywords = keywords,
};
