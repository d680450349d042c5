#include "particle/copies.h"

#include <stdlib.h>
#include <string.h>

#include "base/sort.h"
#include "box/domain.h"
#include "particle/columns.h"
#include "particle/division.h"
#include "particle/identity.h"

#include "base/banned.h"

enum ts_status ts_copies_init(struct ts_copies *copies, int ranks)
{
	size_t n = (size_t)ranks;

	copies->received = ts_alloc(n, sizeof *copies->received);
	copies->sent = ts_alloc(n, sizeof *copies->sent);
	copies->out = ts_alloc(n, sizeof *copies->out);
	copies->in = ts_alloc(n, sizeof *copies->in);
	return copies->received && copies->sent && copies->out && copies->in ? TS_OK : TS_NOMEM;
}

void ts_copies_release(struct ts_copies *copies, int ranks)
{
	for (int r = 0; r < ranks; r++) {
		if (copies->out)
			ts_parcel_release(&copies->out[r]);
		if (copies->in)
			ts_parcel_release(&copies->in[r]);
	}
	ts_free(copies->received);
	ts_free(copies->sent);
	ts_free(copies->row);
	ts_free(copies->out);
	ts_free(copies->in);
}

size_t ts_copies(const struct tsim *sim)
{
	return sim->division ? sim->division->copies.n : 0;
}

int ts_copies_rank(const struct ts_copies *copies, size_t k)
{
	int rank = 0;

	while (k >= copies->received[rank])
		k -= copies->received[rank++];
	return rank;
}

/* ---- copies by identity */

enum ts_status ts_copy_map_make(const struct tsim *sim, struct ts_copy_map *map)
{
	const int32_t *tag = sim->particles->tag + sim->particles->n;

	*map = (struct ts_copy_map){ .n = ts_copies(sim) };
	map->entry = ts_alloc(map->n, sizeof *map->entry);
	if (!map->entry)
		return TS_NOMEM;
	for (size_t k = 0; k < map->n; k++) {
		map->entry[k][0] = tag[k];
		map->entry[k][1] = (int32_t)k;
	}
	ts_sort(map->entry, map->n, sizeof *map->entry, ts_compare_int32);
	return TS_OK;
}

int32_t ts_copy_map_find(const struct ts_copy_map *map, int32_t tag)
{
	const int32_t *found =
		map->n ? bsearch(&tag, map->entry, map->n, sizeof *map->entry, ts_compare_int32) : NULL;

	return found ? found[1] : -1;
}

void ts_copy_map_release(struct ts_copy_map *map)
{
	ts_free(map->entry);
	*map = (struct ts_copy_map){ 0 };
}

/* ---- rows of all columns */

static bool is_forwarded(const struct ts_column *c)
{
	return c->active && c->flags & (TS_COL_FORWARD | TS_COL_COPIED);
}

size_t ts_copies_row_bytes(const struct ts_particles *p)
{
	size_t bytes = 0;

	for (size_t k = 0; k < p->ncolumns; k++)
		if (p->column[k].active)
			bytes += p->column[k].element * p->column[k].width;
	return bytes;
}

size_t ts_copies_step_bytes(const struct ts_particles *p)
{
	size_t bytes = 0;

	for (size_t k = 0; k < p->ncolumns; k++)
		if (is_forwarded(&p->column[k]))
			bytes += p->column[k].element * p->column[k].width;
	return bytes;
}

static void write_row(const struct ts_particles *p, size_t i, unsigned char *to)
{
	for (size_t k = 0; k < p->ncolumns; k++) {
		const struct ts_column *c = &p->column[k];
		size_t bytes = c->element * c->width;

		if (!c->active)
			continue;
		memcpy(to, (const char *)c->data + i * bytes, bytes);
		to += bytes;
	}
}

enum ts_status ts_copies_pack(const struct ts_particles *p, size_t i, struct ts_parcel *out)
{
	unsigned char *to = ts_parcel_extend(out, ts_copies_row_bytes(p));

	if (!to)
		return TS_NOMEM;
	write_row(p, i, to);
	return TS_OK;
}

void ts_copies_unpack(const struct ts_particles *p, size_t i, const unsigned char *from)
{
	for (size_t k = 0; k < p->ncolumns; k++) {
		const struct ts_column *c = &p->column[k];
		size_t bytes = c->element * c->width;

		if (!c->active)
			continue;
		memcpy((char *)c->data + i * bytes, from, bytes);
		from += bytes;
	}
}

/* ---- making copies */

/* The copies that other ranks get of the particles of this one. */
struct sending {
	int own;
	int32_t (*copy)[2]; /* rank, particle */
	int32_t particle;   /* the present one */
	size_t n, capacity;
	enum ts_status status;
};

static void note_copy(void *context, int rank)
{
	struct sending *s = context;

	if (rank == s->own || s->status != TS_OK)
		return;
	s->status = TS_GROW(s->copy, s->capacity, s->n + 1);
	if (s->status != TS_OK)
		return;
	s->copy[s->n][0] = rank;
	s->copy[s->n++][1] = s->particle;
}

/* A rank may have claimed a particle several times, or be near several images of it. */
static void remove_repeated(struct sending *s)
{
	size_t kept = 0;

	ts_sort(s->copy, s->n, sizeof *s->copy, ts_compare_int32_pair);
	for (size_t k = 0; k < s->n; k++) {
		if (kept && !ts_compare_int32_pair(s->copy[kept - 1], s->copy[k]))
			continue;
		memmove(s->copy[kept++], s->copy[k], sizeof *s->copy);
	}
	s->n = kept;
}

/* Images across the sheared faces are displaced. */
static void visit_sheared(const struct ts_domain *domain, const struct ts_rank_blocks *blocks,
			  const double x[3], double cutoff, ts_rank_visit_fn *visit, void *context)
{
	const struct ts_shear *s = &domain->box.shear;
	const double at = x[s->gradient];
	double image[3] = { x[0], x[1], x[2] };

	if (at < domain->held_lo[s->gradient] + cutoff) {
		image[s->flow] = x[s->flow] + domain->held_offset;
		ts_rank_blocks_visit(blocks, image, cutoff, visit, context);
	}
	if (at >= domain->held_hi[s->gradient] - cutoff) {
		image[s->flow] = x[s->flow] - domain->held_offset;
		ts_rank_blocks_visit(blocks, image, cutoff, visit, context);
	}
}

void ts_copies_visit(const struct ts_domain *domain, const struct ts_rank_blocks *blocks,
		     const struct ts_rank_block *own, const double x[3], double cutoff,
		     ts_rank_visit_fn *visit, void *context)
{
	if (!ts_rank_block_inside(own, x, cutoff))
		ts_rank_blocks_visit(blocks, x, cutoff, visit, context);
	if (domain->box.shear.on)
		visit_sheared(domain, blocks, x, cutoff, visit, context);
}

static enum ts_status find_copies(const struct tsim *sim, double cutoff, struct sending *s)
{
	const struct ts_rank_blocks *blocks = &sim->division->blocks;
	const struct ts_rank_block own = ts_rank_blocks_block(blocks, s->own);
	const struct ts_particles *p = sim->particles;

	for (size_t i = 0; i < p->n && s->status == TS_OK; i++) {
		s->particle = (int32_t)i;
		ts_copies_visit(sim->domain, blocks, &own, p->xhold[i], cutoff, note_copy, s);
	}
	if (sim->domain->box.shear.on)
		remove_repeated(s);
	return s->status;
}

/* Lists them rank by rank, those of a rank in the order of the particles, and packs them. */
static enum ts_status list_copies(const struct tsim *sim, struct ts_copies *c, const struct sending *s)
{
	int ranks = sim->world->n;
	size_t first = 0, *at = ts_alloc((size_t)ranks, sizeof *at);
	enum ts_status status = at ? TS_GROW(c->row, c->row_capacity, s->n) : TS_NOMEM;

	memset(c->sent, 0, (size_t)ranks * sizeof *c->sent);
	for (size_t k = 0; k < s->n; k++)
		c->sent[s->copy[k][0]]++;
	for (int r = 0; status == TS_OK && r < ranks; r++) {
		c->out[r].n = 0;
		at[r] = first;
		first += c->sent[r];
	}
	for (size_t k = 0; status == TS_OK && k < s->n; k++) {
		int32_t rank = s->copy[k][0], i = s->copy[k][1];

		c->row[at[rank]++] = i;
		status = ts_copies_pack(sim->particles, (size_t)i, &c->out[rank]);
	}
	ts_free(at);
	return status;
}

static enum ts_status send_copies(struct tsim *sim, struct ts_copies *c, const struct sending *s)
{
	return list_copies(sim, c, s) == TS_OK && ts_world_deliver(sim->world, c->out, c->in) == TS_OK
		       ? TS_OK
		       : ts_nomem(&sim->error);
}

static enum ts_status add_received(struct tsim *sim, struct ts_copies *c, int rank)
{
	struct ts_particles *p = sim->particles;
	size_t bytes = ts_copies_row_bytes(p), n = rank == sim->world->rank ? 0 : c->in[rank].n / bytes;

	TS_TRY(ts_particles_reserve_ghosts(sim, p->nghost + n));
	for (size_t k = 0; k < n; k++) {
		size_t g = p->nghost++;

		ts_copies_unpack(p, p->n + g, c->in[rank].data + k * bytes);
		p->ghost_owner[g] = (int32_t)(p->n + g);
		memset(p->ghost_shift[g], 0, sizeof p->ghost_shift[g]);
	}
	c->received[rank] = n;
	c->n += n;
	return TS_OK;
}

static enum ts_status receive_copies(struct tsim *sim, struct ts_copies *c)
{
	sim->particles->nghost = c->n = 0;
	for (int r = 0; r < sim->world->n; r++)
		TS_TRY(add_received(sim, c, r));
	return TS_OK;
}

/* ---- copies that are claimed */

enum ts_status ts_claims_add(struct tsim *sim, struct ts_claims *claims, int32_t tag)
{
	const int32_t row[2] = { claims->rank, tag };

	return ts_parcel_add(&claims->rows, row, sizeof row) == TS_OK ? TS_OK : ts_nomem(&sim->error);
}

enum ts_status ts_claims_add_body(struct tsim *sim, struct ts_claims *claims, int32_t body)
{
	return ts_claims_add(sim, claims, -body);
}

static enum ts_status ask_styles(struct tsim *sim, const struct ts_copy_map *map, struct ts_claims *claims)
{
	for (int kind = 0; kind < TS_NKIND; kind++)
		for (size_t k = 0; k < sim->instances[kind].n; k++) {
			struct ts_instance *inst = sim->instances[kind].item[k];

			if (inst->style->claim)
				TS_TRY(inst->style->claim(inst, sim, map, claims));
		}
	return TS_OK;
}

static enum ts_status find_claims(struct tsim *sim, struct ts_claims *claims)
{
	struct ts_copy_map map;
	enum ts_status status;

	if (ts_copy_map_make(sim, &map) != TS_OK)
		return ts_nomem(&sim->error);
	status = ask_styles(sim, &map, claims);
	ts_copy_map_release(&map);
	return status;
}

/* The own members of bodies: numbers of bodies, ascending, and particles. */
struct members {
	int32_t (*entry)[2];
	size_t n;
};

static enum ts_status list_members(const struct ts_particles *p, struct members *m)
{
	m->n = 0;
	m->entry = ts_alloc(p->body ? p->n : 0, sizeof *m->entry);
	if (!m->entry)
		return TS_NOMEM;
	for (size_t i = 0; p->body && i < p->n; i++) {
		if (!p->body[i])
			continue;
		m->entry[m->n][0] = p->body[i];
		m->entry[m->n++][1] = (int32_t)i;
	}
	ts_sort(m->entry, m->n, sizeof *m->entry, ts_compare_int32);
	return TS_OK;
}

static void add_body(const struct members *m, int32_t body, int rank, struct sending *s)
{
	size_t k = ts_find_int32(m->entry, m->n, sizeof *m->entry, body);

	for (; k < m->n && m->entry[k][0] == body; k++) {
		s->particle = m->entry[k][1];
		note_copy(s, rank);
	}
}

/* Adds the own particles that other ranks claim. */
static enum ts_status add_claimed(struct tsim *sim, const struct ts_parcel *claims, struct sending *s)
{
	struct ts_identities own;
	struct members members;

	TS_TRY(ts_identities(sim, false, &own));
	if (list_members(sim->particles, &members) != TS_OK)
		return ts_nomem(&sim->error);
	for (size_t k = 0; k < claims->n / sizeof(int32_t[2]); k++) {
		int32_t row[2];

		memcpy(row, claims->data + k * sizeof row, sizeof row);
		if (row[1] < 0) {
			add_body(&members, -row[1], row[0], s);
			continue;
		}
		s->particle = ts_identity_row(&own, row[1]);
		if (s->particle >= 0)
			note_copy(s, row[0]);
	}
	ts_free(members.entry);
	return s->status == TS_OK ? TS_OK : ts_nomem(&sim->error);
}

/* If a rank claims particles, all make their copies again, with these. */
static enum ts_status make_claimed(struct tsim *sim, struct ts_copies *c, struct sending *s)
{
	struct ts_claims claims = { .rank = sim->world->rank };
	struct ts_parcel all = { 0 };
	enum ts_status status = find_claims(sim, &claims);
	double most = (double)claims.rows.n;

	if (status == TS_OK && claims.any)
		ts_world_most(sim->world, &most, 1);
	if (status == TS_OK && claims.any && most > 0) {
		status = ts_world_share(sim->world, &claims.rows, &all);
		status = status == TS_OK ? add_claimed(sim, &all, s) : ts_nomem(&sim->error);
		remove_repeated(s);
		if (status == TS_OK)
			status = send_copies(sim, c, s);
		if (status == TS_OK)
			status = receive_copies(sim, c);
	}
	ts_parcel_release(&claims.rows);
	ts_parcel_release(&all);
	return status;
}

enum ts_status ts_copies_make(struct tsim *sim, double cutoff)
{
	struct ts_copies *c = &sim->division->copies;
	struct sending s = { .own = sim->world->rank };
	enum ts_status status = find_copies(sim, cutoff, &s) == TS_OK ? TS_OK : ts_nomem(&sim->error);

	if (status == TS_OK)
		status = send_copies(sim, c, &s);
	if (status == TS_OK)
		status = receive_copies(sim, c);
	if (status == TS_OK)
		status = make_claimed(sim, c, &s);
	ts_free(s.copy);
	TS_TRY(status);
	sim->division->built++;
	sim->division->made += (int64_t)c->n;
	return TS_OK;
}

/* ---- in each step */

/* A constant size lets the compiler inline memcpy. */
static void collect_rows(unsigned char *to, const struct ts_column *c, const int32_t *row, size_t n)
{
	const char *data = c->data;
	size_t bytes = c->element * c->width;

	if (bytes == 3 * sizeof(double))
		for (size_t k = 0; k < n; k++)
			memcpy(to + 3 * sizeof(double) * k, data + 3 * sizeof(double) * (size_t)row[k],
			       3 * sizeof(double));
	else
		for (size_t k = 0; k < n; k++)
			memcpy(to + bytes * k, data + bytes * (size_t)row[k], bytes);
}

/* The parcels were as large when the copies were made, so that there is room. */
static void pack_forwarded(const struct ts_particles *p, const int32_t *row, size_t n, struct ts_parcel *out)
{
	out->n = 0;
	for (size_t k = 0; k < p->ncolumns; k++) {
		const struct ts_column *c = &p->column[k];

		if (!is_forwarded(c))
			continue;
		collect_rows(out->data + out->n, c, row, n);
		out->n += n * c->element * c->width;
	}
}

static void unpack_forwarded(const struct ts_particles *p, size_t first, size_t n, const struct ts_parcel *in)
{
	size_t at = 0;

	for (size_t k = 0; n && k < p->ncolumns; k++) {
		const struct ts_column *c = &p->column[k];
		size_t bytes = c->element * c->width;

		if (!is_forwarded(c))
			continue;
		memcpy((char *)c->data + first * bytes, in->data + at, n * bytes);
		at += n * bytes;
	}
}

void ts_copies_forward(struct tsim *sim)
{
	const struct ts_particles *p = sim->particles;
	struct ts_copies *c;
	size_t row = 0, ghost = p->n, bytes;

	if (!sim->division)
		return;
	c = &sim->division->copies;
	bytes = ts_copies_step_bytes(p);
	for (int r = 0; r < sim->world->n; r++) {
		pack_forwarded(p, c->row + row, c->sent[r], &c->out[r]);
		row += c->sent[r];
		c->in[r].n = c->received[r] * bytes;
	}
	ts_world_swap(sim->world, c->out, c->in);
	for (int r = 0; r < sim->world->n; r++) {
		unpack_forwarded(p, ghost, c->received[r], &c->in[r]);
		ghost += c->received[r];
	}
}

/* ---- rows of any number */

/* Sends the numbers of rows. */
static enum ts_status swap_counts(struct tsim *sim, const size_t *first, uint32_t *count)
{
	struct ts_copies *c = &sim->division->copies;
	const int32_t *row = c->row;

	for (int r = 0; r < sim->world->n; r++) {
		c->out[r].n = c->in[r].n = 0;
		for (size_t k = 0; k < c->sent[r]; k++, row++) {
			const uint32_t n = (uint32_t)(first[*row + 1] - first[*row]);

			TS_TRY(ts_parcel_add(&c->out[r], &n, sizeof n));
		}
		if (!ts_parcel_extend(&c->in[r], c->received[r] * sizeof *count))
			return TS_NOMEM;
	}
	ts_world_swap(sim->world, c->out, c->in);
	for (int r = 0; r < sim->world->n; r++) {
		if (c->in[r].n)
			memcpy(count, c->in[r].data, c->in[r].n);
		count += c->received[r];
	}
	return TS_OK;
}

static enum ts_status swap_rows(struct tsim *sim, size_t bytes, const size_t *first, const void *rows,
				struct ts_copied_rows *got)
{
	struct ts_copies *c = &sim->division->copies;
	const int32_t *row = c->row;
	const uint32_t *count = got->count;

	for (int r = 0; r < sim->world->n; r++) {
		size_t n = 0;

		c->out[r].n = c->in[r].n = 0;
		for (size_t k = 0; k < c->sent[r]; k++, row++)
			TS_TRY(ts_parcel_add(&c->out[r], (const char *)rows + first[*row] * bytes,
					     (first[*row + 1] - first[*row]) * bytes));
		for (size_t k = 0; k < c->received[r]; k++)
			n += *count++;
		if (!ts_parcel_extend(&c->in[r], n * bytes))
			return TS_NOMEM;
	}
	ts_world_swap(sim->world, c->out, c->in);
	for (int r = 0; r < sim->world->n; r++)
		TS_TRY(ts_parcel_add(&got->rows, c->in[r].data, c->in[r].n));
	return TS_OK;
}

enum ts_status ts_copies_forward_rows(struct tsim *sim, size_t bytes, const size_t *first, const void *row,
				      struct ts_copied_rows *got)
{
	got->rows.n = 0;
	TS_TRY(TS_GROW(got->count, got->capacity, ts_copies(sim)));
	TS_TRY(swap_counts(sim, first, got->count));
	return swap_rows(sim, bytes, first, row, got);
}

void ts_copied_rows_release(struct ts_copied_rows *rows)
{
	ts_free(rows->count);
	ts_parcel_release(&rows->rows);
}

/* ---- forces on members of bodies */

static void pack_forces(const struct ts_particles *p, const int32_t *row, size_t n, struct ts_parcel *out)
{
	double *to = (double *)out->data;

	for (size_t k = 0; k < n; k++) {
		if (!p->body[row[k]])
			continue;
		memcpy(to, p->f[row[k]], sizeof *p->f);
		memcpy(to + 3, p->torque[row[k]], sizeof *p->torque);
		to += 6;
	}
	out->n = (size_t)((unsigned char *)to - out->data);
}

static size_t count_members(const struct ts_particles *p, size_t first, size_t n)
{
	size_t members = 0;

	for (size_t i = first; i < first + n; i++)
		members += p->body[i] != 0;
	return members;
}

static void unpack_forces(const struct ts_particles *p, size_t first, size_t n, const struct ts_parcel *in)
{
	const double *from = (const double *)in->data;

	for (size_t i = first; i < first + n; i++) {
		if (!p->body[i])
			continue;
		memcpy(p->f[i], from, sizeof *p->f);
		memcpy(p->torque[i], from + 3, sizeof *p->torque);
		from += 6;
	}
}

void ts_copies_forward_forces(struct tsim *sim)
{
	const struct ts_particles *p = sim->particles;
	struct ts_copies *c;
	size_t row = 0, ghost = p->n;

	if (!sim->division || !ts_columns_have_bodies(p))
		return;
	c = &sim->division->copies;
	for (int r = 0; r < sim->world->n; r++) {
		pack_forces(p, c->row + row, c->sent[r], &c->out[r]);
		row += c->sent[r];
		c->in[r].n = 6 * sizeof(double) * count_members(p, ghost, c->received[r]);
		ghost += c->received[r];
	}
	ts_world_swap(sim->world, c->out, c->in);
	ghost = p->n;
	for (int r = 0; r < sim->world->n; r++) {
		unpack_forces(p, ghost, c->received[r], &c->in[r]);
		ghost += c->received[r];
	}
}
