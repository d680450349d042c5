#include "particle/shared_rows.h"

#include <string.h>

#include "particle/columns.h"
#include "particle/copies.h"
#include "rank/world.h"

#include "base/banned.h"

/* Bytes of a piece, of all ranks together, and the least number of particles of a rank in it. */
enum { PIECE = 1 << 22, LEAST = 64 };

struct sharing {
	const unsigned char *chosen; /* own particles that are sent; NULL: all */
	uint64_t *n, *at, *bytes;    /* by rank: particles left; row of the next one; bytes of this piece */
	size_t next;		     /* own particle */
	size_t most;		     /* particles of a rank in a piece */
	int32_t *row;		     /* [most], chosen ones of this piece */
	struct ts_parcel mine, all;
};

static char *row_of(const struct ts_column *c, size_t i)
{
	return (char *)c->data + i * c->element * c->width;
}

size_t ts_shared_rows_move(const struct ts_particles *p, size_t columns, size_t from, size_t n, bool out,
			   unsigned char *bytes)
{
	size_t at = 0;

	for (size_t k = 0; k < columns; k++) {
		const struct ts_column *c = &p->column[k];
		size_t size = n * c->element * c->width;

		if (!c->active || !n)
			continue;
		if (bytes && out)
			memcpy(bytes + at, row_of(c, from), size);
		else if (bytes)
			memcpy(row_of(c, from), bytes + at, size);
		at += size;
	}
	return at;
}

/* The next n chosen particles. */
static void pack_chosen(struct sharing *s, const struct ts_particles *p, size_t n, unsigned char *to)
{
	for (size_t k = 0; k < n; s->next++)
		if (s->chosen[s->next])
			s->row[k++] = (int32_t)s->next;
	for (size_t c = 0; c < p->ncolumns; c++) {
		const struct ts_column *column = &p->column[c];
		size_t width = column->element * column->width;

		for (size_t k = 0; column->active && k < n; k++, to += width)
			memcpy(to, row_of(column, (size_t)s->row[k]), width);
	}
}

static enum ts_status pack_piece(struct sharing *s, const struct ts_particles *p, size_t n)
{
	unsigned char *to;

	s->mine.n = 0;
	to = ts_parcel_extend(&s->mine, n * ts_copies_row_bytes(p));
	if (!to)
		return TS_NOMEM;
	if (s->chosen) {
		pack_chosen(s, p, n, to);
		return TS_OK;
	}
	ts_shared_rows_move(p, p->ncolumns, s->next, n, true, to);
	s->next += n;
	return TS_OK;
}

/* Writes what each rank has sent to its place. */
static void unpack_piece(struct sharing *s, const struct tsim *sim)
{
	const struct ts_particles *p = sim->particles;
	unsigned char *from = s->all.data;

	for (int r = 0; r < sim->world->n; from += s->bytes[r++]) {
		size_t n = (size_t)s->bytes[r] / ts_copies_row_bytes(p);

		if (r != sim->world->rank)
			ts_shared_rows_move(p, p->ncolumns, (size_t)s->at[r], n, false, from);
		s->n[r] -= n;
		s->at[r] += n;
	}
}

static enum ts_status share_piece(struct sharing *s, const struct tsim *sim)
{
	const struct ts_particles *p = sim->particles;

	for (int r = 0; r < sim->world->n; r++)
		s->bytes[r] = (s->n[r] < s->most ? s->n[r] : s->most) * ts_copies_row_bytes(p);
	TS_TRY(pack_piece(s, p, (size_t)s->bytes[sim->world->rank] / ts_copies_row_bytes(p)));
	s->all.n = 0;
	TS_TRY(ts_world_share_known(sim->world, &s->mine, s->bytes, &s->all));
	unpack_piece(s, sim);
	return TS_OK;
}

static bool some_left(const struct sharing *s, const struct ts_world *world)
{
	for (int r = 0; r < world->n; r++)
		if (s->n[r])
			return true;
	return false;
}

/* Makes room for the particles of all ranks; returns their number in *rows. */
static enum ts_status place(struct sharing *s, struct tsim *sim, enum ts_shared_order order, size_t *rows)
{
	struct ts_particles *p = sim->particles;
	size_t first = order == TS_SHARED_OWN_FIRST ? p->n : 0;

	for (int r = 0; r < sim->world->n; r++) {
		if (order == TS_SHARED_OWN_FIRST && r == sim->world->rank)
			continue;
		s->at[r] = first;
		first += (size_t)s->n[r];
	}
	*rows = first;
	return ts_particles_reserve(sim, first);
}

/* The own particles go to row `to`. */
static void move_own(const struct ts_particles *p, size_t to)
{
	for (size_t k = 0; k < p->ncolumns; k++) {
		const struct ts_column *c = &p->column[k];

		if (c->active && p->n && to)
			memmove(row_of(c, to), c->data, p->n * c->element * c->width);
	}
}

static enum ts_status share_all(struct sharing *s, struct tsim *sim, enum ts_shared_order order)
{
	struct ts_particles *p = sim->particles;
	uint64_t n = s->chosen ? 0 : p->n;
	size_t rows;

	for (size_t i = 0; s->chosen && i < p->n; i++)
		n += s->chosen[i] != 0;
	ts_world_sizes(sim->world, n, s->n);
	p->nghost = 0;
	TS_TRY(place(s, sim, order, &rows));
	if (order == TS_SHARED_BY_RANK) {
		s->next = (size_t)s->at[sim->world->rank];
		move_own(p, s->next);
	}
	while (some_left(s, sim->world))
		if (share_piece(s, sim) != TS_OK)
			return ts_nomem(&sim->error);
	p->n = rows;
	sim->generation++;
	return TS_OK;
}

enum ts_status ts_shared_rows(struct tsim *sim, enum ts_shared_order order, const unsigned char *chosen)
{
	size_t ranks = (size_t)sim->world->n;
	size_t most = PIECE / (ts_copies_row_bytes(sim->particles) * ranks);
	struct sharing s = { .chosen = chosen, .most = most > LEAST ? most : LEAST };
	enum ts_status status = TS_OK;

	s.n = ts_alloc(3 * ranks, sizeof *s.n);
	s.row = chosen ? ts_alloc(s.most, sizeof *s.row) : NULL;
	if (!s.n || (chosen && !s.row))
		status = ts_nomem(&sim->error);
	if (status == TS_OK) {
		s.at = s.n + ranks;
		s.bytes = s.at + ranks;
		status = share_all(&s, sim, order);
	}
	ts_parcel_release(&s.mine);
	ts_parcel_release(&s.all);
	ts_free(s.row);
	ts_free(s.n);
	return status;
}
