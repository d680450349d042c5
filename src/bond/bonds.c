/* The list of bonds: archiving, and the local indices of partners after a rebuild. */
#include "bond/bonds.h"

#include <math.h>
#include <string.h>

#include "box/domain.h"
#include "core/report.h"
#include "math/vec3.h"
#include "neigh/coincide.h"
#include "neigh/neigh.h"
#include "particle/division.h"
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

/* Whether the contact list of the run is made again for other particles (particle/division.h). */
static bool is_remaking(const struct tsim *sim)
{
	const struct ts_division *d = sim->particles->division;

	return d && d->rebuilding;
}

static bool are_bonded(const struct tsim *sim, int32_t tag_a, int32_t tag_b)
{
	return is_remaking(sim) ? ts_bonds_were_listed(sim, tag_a, tag_b)
				: ts_bonds_has(sim->bonds, tag_a, tag_b);
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

/* Fails if bond k is so long that its periodic image cannot be told. */
static enum ts_status check_images(struct tsim *sim, const struct ts_bonds *b, size_t k, const double d[3])
{
	const double most = 0.49; /* of the length of the box; at a half the image is ambiguous */
	const struct ts_box *box = &sim->domain->box;

	for (int c = 0; c < 3; c++)
		if (ts_box_periodic(box, c) && fabs(d[c]) > most * ts_box_length(box, c))
			return ts_fail(&sim->error, TS_PHYSICS, NULL,
				       "the bond of particles %d and %d extends by %g along %c, about half "
				       "the periodic box of %g, so that it is ambiguous which image of the "
				       "partner it holds; use a larger box",
				       b->tag[k][0], b->tag[k][1], fabs(d[c]), "xyz"[c],
				       ts_box_length(box, c));
	return TS_OK;
}

/* Fails if bonds have no direction, or no certain one. */
static enum ts_status check_lengths(struct tsim *sim, const struct ts_bonds *b)
{
	const bool act = ts_sim_only(sim, TS_KIND_BOND) != NULL;
	double d[3];

	for (size_t k = 0; k < b->n; k++) {
		size_t i = (size_t)b->row[k][0], j = (size_t)b->row[k][1];

		TS_TRY(ts_coincide_bond(sim, NULL, i, j, ts_bond_separation(sim, i, j, d)));
		if (act)
			TS_TRY(check_images(sim, b, k, d));
	}
	return TS_OK;
}

enum ts_status ts_bonds_connect(struct tsim *sim)
{
	struct ts_bonds *b = sim->bonds;
	struct ts_identities map;

	if (!b->n && !b->ranks.divided)
		return TS_OK;
	if (sim->division) {
		TS_TRY(ts_bonds_connect_own(sim, b));
	} else {
		TS_TRY(ts_identities(sim, false, &map));
		TS_TRY(delete_bonds_of_lost_particles(sim, b, &map));
		for (size_t k = 0; k < b->n; k++)
			for (int s = 0; s < 2; s++)
				b->row[k][s] = ts_identity_row(&map, b->tag[k][s]);
	}
	TS_TRY(check_lengths(sim, b));
	return ts_bonds_build_index(sim);
}

bool ts_bonds_connected(const struct ts_bonds *b, const struct ts_particles *p)
{
	for (size_t k = 0; k < b->n; k++)
		for (int s = 0; s < 2; s++) {
			size_t i = (size_t)b->row[k][s];

			if (i >= p->n || p->tag[i] != b->tag[k][s])
				return false;
		}
	return true;
}

enum ts_status ts_bonds_connect_if_changed(struct tsim *sim)
{
	if (sim->run.epoch || sim->division || ts_bonds_connected(sim->bonds, sim->particles))
		return TS_OK;
	return ts_bonds_connect(sim);
}

/* After a rebuild local indices have changed, and particles may have left. */
static enum ts_status update_partner_indices(struct ts_instance *self, struct tsim *sim)
{
	struct ts_bonds *b = self->state;

	if (b->n && !is_remaking(sim))
		memset(b->fresh, 0, b->n);
	return ts_bonds_connect(sim);
}

static enum ts_status check_restored_bonds(struct tsim *sim, const struct ts_bonds *b)
{
	int32_t max_tag = sim->particles->max_tag;

	for (size_t k = 0; k < b->n; k++)
		if (b->tag[k][0] < 1 || b->tag[k][0] > max_tag || b->tag[k][1] < 1 ||
		    b->tag[k][1] > max_tag || b->tag[k][0] == b->tag[k][1] || b->type[k] < 1 ||
		    b->type[k] > b->ntypes || !isfinite(b->rest[k]) || !isfinite(b->own[k]))
			return ts_fail(&sim->error, TS_DAMAGED, NULL,
				       "bond %zu has an invalid partner or type", k + 1);
	return TS_OK;
}

/* Whether coefficients have given lengths that are not the bonds' own. */
static bool lengths_are_given(const struct ts_bonds *b)
{
	return b->n && memcmp(b->rest, b->own, b->n * sizeof *b->rest) != 0;
}

static enum ts_status archive_lengths(struct ts_bonds *b, struct ts_archive *a)
{
	TS_TRY(ts_archive_fixed(a, "rest", TS_SAVED_F64, b->rest, b->n));
	if (ts_archive_writing(a) ? lengths_are_given(b) : ts_archive_has(a, "own"))
		return ts_archive_fixed(a, "own", TS_SAVED_F64, b->own, b->n);
	if (b->n)
		memcpy(b->own, b->rest, b->n * sizeof *b->rest);
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
	TS_TRY(ts_bonds_reserve(sim, (size_t)n[0]));
	TS_TRY(ts_bonds_reserve_events(sim, (size_t)n[1]));
	b->n = (size_t)n[0];
	b->nevents = (size_t)n[1];
	TS_TRY(ts_archive_fixed(a, "tag", TS_SAVED_I32, b->tag, 2 * b->n));
	TS_TRY(ts_archive_fixed(a, "type", TS_SAVED_I32, b->type, b->n));
	TS_TRY(archive_lengths(b, a));
	TS_TRY(ts_archive_fixed(a, "tension", TS_SAVED_F64, b->tension, b->n));
	if (!ts_archive_writing(a) && b->n)
		memset(b->fresh, 1, b->n);
	if (!ts_archive_writing(a) && b->nevents) /* a list will be built that has their pairs */
		memset(b->event_fresh, 1, b->nevents);
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
	if (lengths_are_given(b))
		ts_hash_add(hash, b->own, b->n * sizeof *b->own);
	if (b->transmits)
		ts_hash_add(hash, b->reference, b->n * sizeof *b->reference);
	if (b->softens)
		ts_hash_add(hash, b->damage, b->n * sizeof *b->damage);
}

static enum ts_status report_memory(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report)
{
	const struct ts_bonds *b = self->state;
	size_t bytes = 5 * sizeof(double) + 11 * sizeof(int32_t);

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
	ts_free(b->own);
	ts_free(b->row);
	ts_free(b->tension);
	ts_free(b->breaks);
	ts_free(b->fresh);
	ts_free(b->reference);
	ts_free(b->load);
	ts_free(b->damage);
	ts_free(b->lost);
	ts_gather_release(&b->gather);
	ts_bond_slices_release(&b->slices);
	ts_bond_rows_release(&b->rows);
	ts_free(b->event);
	ts_free(b->event_energy);
	ts_free(b->event_fresh);
}

static enum ts_status count_bonds(struct tsim *sim, double *out)
{
	*out = (double)ts_bonds_count(sim->bonds);
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

const struct ts_system_style ts_bonds_system = {
	.style = { .name = "bonds",
		   .kind = TS_KIND_SYSTEM,
		   .summary = "the list of bonds",
		   .state_size = sizeof(struct ts_bonds),
		   .saved = saved,
		   .archive = archive_bonds,
		   .fingerprint = fingerprint_bonds,
		   .init = init_bonds,
		   .ranks = TS_RANKS_ROWLESS,
		   .hook = { [TS_STAGE_BUILD] = update_partner_indices },
		   .plan = report_memory,
		   .join = ts_bonds_join,
		   .carrier = &ts_bonds_carrier,
		   .claim = ts_bonds_claim,
		   .fini = release_bonds },
	.slot = offsetof(struct tsim, bonds),
	.connect = connect_bonds,
	.keywords = keywords,
};
