/* Touching rows, worked at in batches: what the laws need is brought into columns, so that a law that is written
 * for one contact is computed for several at once, as wide as the processor is. All contacts of a batch have the
 * same law. Numbers are those of the loop over single rows, bit for bit. */
#ifndef TS_NEIGH_ROW_BATCH_H
#define TS_NEIGH_ROW_BATCH_H

#include <string.h>

#include "base/four.h"
#include "neigh/row_loop.h"

struct ts_batch {
	/* the ends, see struct ts_row_ends; the fourth columns: radius of i, of j, nothing */
	double d[4][TS_ROW_BLOCK], omega[2][4][TS_ROW_BLOCK], v[4][TS_ROW_BLOCK];
	double mass[2][TS_ROW_BLOCK], imass[TS_ROW_BLOCK], stiffness[TS_ROW_BLOCK];
	double memory[TS_GRANULAR_MEMORY + 3][TS_ROW_BLOCK];
	/* the results */
	double force[4][TS_ROW_BLOCK], turn[4][TS_ROW_BLOCK], roll[4][TS_ROW_BLOCK];
} __attribute__((aligned(64)));

/* The contacts at .. at+3. */
TS_INLINE void ts_batch_load(const struct ts_particles *p, const struct ts_rows *rows,
			     const struct ts_granular_model *m, const uint32_t *list, size_t at,
			     struct ts_batch *b)
{
	const ts_four *place = (const ts_four *)rows->place;
	int width = ts_granular_memory(m);
	ts_four d[4], v[4], wi[4] = { 0 }, wj[4] = { 0 };

	for (size_t k = 0; k < 4; k++) {
		size_t r = list[at + k], i = (size_t)rows->i[r], j = (size_t)rows->j[r];

		d[k] = TS_FOUR_LAST(place[i] - place[j], place[i]);
		v[k] = TS_FOUR_AT(p->v[i]) - TS_FOUR_AT(p->v[j]);
		if (ts_granular_turns(m)) {
			wi[k] = TS_FOUR_AT(p->omega[i]);
			wj[k] = TS_FOUR_AT(p->omega[j]);
		}
		wi[k] = TS_FOUR_LAST(wi[k], place[j]);
		b->imass[at + k] = p->imass[i] + p->imass[j];
		if (ts_granular_weighs(m)) {
			b->mass[0][at + k] = p->mass[i];
			b->mass[1][at + k] = p->mass[j];
		}
	}
	ts_four_columns(d, b->d, at);
	ts_four_columns(v, b->v, at);
	ts_four_columns(wi, b->omega[0], at);
	if (ts_granular_turns(m))
		ts_four_columns(wj, b->omega[1], at);
	for (int c = 0; c < width; c += 3) {
		for (size_t k = 0; k < 4; k++)
			d[k] = TS_FOUR_AT(rows->history + list[at + k] * (size_t)width + c);
		ts_four_columns(d, b->memory + c, at);
	}
}

/* The stiffness of hooke has a fifth root in it: it is computed anew only for partners of other size or mass
 * than those before. */
TS_INLINE void ts_batch_stiffness(const struct ts_granular_model *m, const struct ts_granular_pair *law,
				  size_t n, struct ts_batch *b)
{
	const double *a = b->d[3], *c = b->omega[0][3];

	for (size_t k = 0; m->stiffness_known && k < n; k++) {
		struct ts_touch t = { .r_eff = a[k] * c[k] / (a[k] + c[k]), .m_eff = 1 / b->imass[k] };
		bool same = k && a[k] == a[k - 1] && c[k] == c[k - 1] && b->imass[k] == b->imass[k - 1];

		b->stiffness[k] = same ? b->stiffness[k - 1] : ts_hooke_stiffness(law, &t);
	}
}

TS_INLINE void ts_batch_contact(struct ts_batch *b, size_t k, const struct ts_granular_model *m,
				const struct ts_granular_pair *law, double dt, bool advance)
{
	struct ts_row_ends e = {
		.d = { b->d[0][k], b->d[1][k], b->d[2][k] },
		.v = { b->v[0][k], b->v[1][k], b->v[2][k] },
		.omega = { { b->omega[0][0][k], b->omega[0][1][k], b->omega[0][2][k] },
			   { b->omega[1][0][k], b->omega[1][1][k], b->omega[1][2][k] } },
		.radius = { b->d[3][k], b->omega[0][3][k] },
		.mass = { b->mass[0][k], b->mass[1][k] },
		.imass = b->imass[k],
	};
	double memory[TS_GRANULAR_MEMORY];
	struct ts_granular_force f;
	struct ts_touch t;

	for (int c = 0; c < ts_granular_memory(m); c++)
		memory[c] = b->memory[c][k];
	ts_ends_touch(&e, m, &t);
	if (m->stiffness_known)
		t.stiffness = b->stiffness[k];
	ts_granular_contact(m, law, &t, dt, advance, memory, &f);
	for (int c = 0; c < ts_granular_memory(m); c++)
		b->memory[c][k] = memory[c];
	for (int c = 0; c < 3; c++)
		b->force[c][k] = f.force[c];
	b->force[3][k] = ts_granular_short(m, &t);
	for (int c = 0; ts_granular_turns(m) && c < 4; c++)
		b->turn[c][k] = c < 3 ? f.turn[c] : 0;
	for (int c = 0; ts_granular_rolls(m) && c < 4; c++)
		b->roll[c][k] = c < 3 ? f.roll[c] : 0;
}

/* As rows->parts. */
TS_INLINE size_t ts_batch_parts(const struct ts_granular_model *m)
{
	return ts_granular_rolls(m) ? 3 : ts_granular_turns(m) ? 2 : 1;
}

/* One part of the results of the contacts at .. at+3. */
TS_INLINE void ts_batch_result(const double (*column)[TS_ROW_BLOCK], size_t at, ts_four *const to[4], size_t part)
{
	ts_four row[4];

	ts_four_rows(column, at, row);
	for (size_t k = 0; k < 4; k++)
		to[k][part] = row[k];
}

/* The contacts at .. at+3; of those behind the last only what does no harm. */
TS_INLINE void ts_batch_store(const struct ts_batch *b, const struct ts_granular_model *m,
			      const uint32_t *list, size_t at, struct ts_rows *rows)
{
	int width = ts_granular_memory(m);
	size_t parts = ts_batch_parts(m);
	ts_four row[4], *to[4];

	for (size_t k = 0; k < 4; k++)
		to[k] = (ts_four *)rows->result[rows->slot[list[at + k]] * parts];
	ts_batch_result(b->force, at, to, 0);
	if (parts > 1)
		ts_batch_result(b->turn, at, to, 1);
	if (parts > 2)
		ts_batch_result(b->roll, at, to, 2);
	for (int c = 0; c < width; c += 3) {
		ts_four_rows(b->memory + c, at, row);
		for (size_t k = 0; k < 4; k++)
			ts_four_keep(&row[k], width - c,
				      rows->history + list[at + k] * (size_t)width + c);
	}
}

/* Marks which of the rows r .. r+n-1, n at most four, touch. */
TS_INLINE void ts_batch_touch(const struct ts_rows *rows, size_t r, size_t n, ts_four_marks *touch)
{
	static const ts_four signs = { -1, -1, -1, 1 };
	const ts_four *place = (const ts_four *)rows->place;
	ts_four d[4];

	for (size_t k = 0; k < 4; k++) { /* d and the sum of the radii */
		size_t row = r + (k < n ? k : 0);

		d[k] = place[rows->i[row]] + signs * place[rows->j[row]];
	}
	ts_four_turn(d);
	*touch = d[0] * d[0] + d[1] * d[1] + d[2] * d[2] < d[3] * d[3];
	for (size_t k = n; k < 4; k++)
		(*touch)[k] = 0;
}

/* Notes for the rows from r on which of them touch, eight at a time: mostly nothing has changed. */
TS_INLINE void ts_batch_note(struct ts_rows *rows, size_t r, size_t n, const long long *touch, bool keep)
{
	uint8_t now[TS_ROW_BLOCK];

	for (size_t k = 0; k < n; k++)
		now[k] = (uint8_t)(touch[k] & 1);
	for (size_t at = 0; at < n; at += 8) {
		size_t most = n - at < 8 ? n - at : 8;

		if (most == 8 && !memcmp(now + at, rows->touching + r + at, 8))
			continue;
		for (size_t k = at; k < at + most; k++) {
			if (rows->touching[r + k] > now[k])
				ts_row_part(rows, r + k, keep);
			rows->touching[r + k] = now[k];
		}
	}
}

/* Lists the touching ones of the rows from .. to-1; returns how many. The others have no force. It does not branch on
 * what touches. */
TS_INLINE size_t ts_batch_find(struct ts_rows *rows, size_t from, size_t to, size_t parts, bool keep,
			       uint32_t *list)
{
	union {
		ts_four_marks four[TS_ROW_BLOCK / 4];
		long long one[TS_ROW_BLOCK];
	} touch;
	uint32_t rest[TS_ROW_BLOCK];
	size_t n = 0, rows_n = to - from;

	for (size_t k = 0; k + 4 <= rows_n; k += 4)
		ts_batch_touch(rows, from + k, 4, &touch.four[k / 4]);
	if (rows_n % 4)
		ts_batch_touch(rows, to - rows_n % 4, rows_n % 4, &touch.four[rows_n / 4]);
	for (size_t k = 0; k < rows_n; k += 4) /* by four, which compilers unroll; behind the last nothing touches */
		for (size_t at = k; at < k + 4; at++) {
			list[n] = rest[at - n] = (uint32_t)(from + at);
			n -= (size_t)touch.one[at];
		}
	ts_batch_note(rows, from, rows_n, touch.one, keep);
	for (size_t k = 0; k < rows_n - n; k++)
		ts_row_still(rows, rest[k], parts);
	return n;
}

/* The contacts 0 .. n-1 of a batch by a constant model; the time step is positive. */
typedef void ts_batch_fn(struct ts_batch *b, size_t n, const struct ts_granular_pair *law, double dt);

TS_INLINE void ts_batch_contacts(struct ts_batch *restrict b, size_t n,
				 const struct ts_granular_model *m,
				 const struct ts_granular_pair *restrict law, double dt)
{
	if (!(dt > 0)) /* never; but so the compiler knows */
		return;
#pragma omp simd
	for (size_t k = 0; k < n; k++)
		ts_batch_contact(b, k, m, law, dt, true);
}

/* Brings those of the listed rows whose partners are of types a and b to the front; returns how many. */
TS_INLINE size_t ts_batch_alike(const struct ts_particles *p, const struct ts_pair *pair,
				const struct ts_rows *rows, int a, int b, uint32_t *list, size_t n)
{
	size_t alike = 0;
	int other = 0;

	for (size_t k = 0; k < n && pair->ntypes > 1; k++)
		other |= (p->type[rows->i[list[k]]] ^ a) | (p->type[rows->j[list[k]]] ^ b);
	if (!other) /* mostly */
		return n;
	for (size_t k = 0; k < n; k++) {
		uint32_t r = list[k];

		list[k] = list[alike];
		list[alike] = r;
		alike += p->type[rows->i[r]] == a && p->type[rows->j[r]] == b;
	}
	return alike;
}

/* Contacts of one law, all of the list. */
TS_INLINE void ts_batch_work(const struct ts_row_task *task, const struct ts_granular_model *m,
			     ts_batch_fn *contacts, const struct ts_granular_pair *law,
			     const uint32_t *list, size_t n)
{
	const struct ts_particles p = *task->p;
	struct ts_rows rows = *task->rows;
	uint32_t whole[TS_ROW_BLOCK + 8];
	struct ts_batch b;

	memcpy(whole, list, n * sizeof *list);
	for (size_t k = 0; k < 8; k++) /* whole vectors: the last contact again and again */
		whole[n + k] = list[n - 1];
	n = (n + 7) & ~(size_t)7;
	for (size_t at = 0; at < n; at += 4)
		ts_batch_load(&p, &rows, m, whole, at, &b);
	ts_batch_stiffness(m, law, n, &b);
	contacts(&b, n, law, task->dt);
	for (size_t at = 0; at < n; at += 4)
		ts_batch_store(&b, m, whole, at, &rows);
}

/* What the listed rows will need of their second partners and their history is sent for, so that many come at a time;
 * first partners follow each other in memory. */
TS_INLINE void ts_batch_send_for(const struct ts_particles *p, const struct ts_rows *rows,
				 const struct ts_granular_model *m, const uint32_t *list, size_t n)
{
	size_t width = (size_t)ts_granular_memory(m);

	for (size_t k = 0; k < n; k++) {
		size_t j = (size_t)rows->j[list[k]];

		__builtin_prefetch(p->v[j]);
		if (ts_granular_turns(m))
			__builtin_prefetch(p->omega[j]);
		if (width)
			__builtin_prefetch(rows->history + list[k] * width, 1);
	}
}

/* Where the second partners of the block of rows from `from` are. */
TS_INLINE void ts_batch_send_places(const struct ts_rows *rows, size_t from)
{
	size_t to = rows->n - from < TS_ROW_BLOCK ? rows->n : from + TS_ROW_BLOCK;

	for (size_t r = from; r < to; r++)
		__builtin_prefetch(rows->place[rows->j[r]]);
}

/* The listed rows, law by law. */
TS_INLINE void ts_batch_list(const struct ts_row_task *task, const struct ts_granular_model *m,
			     ts_batch_fn *contacts, uint32_t *list, size_t n)
{
	const struct ts_particles *p = task->p;
	const struct ts_rows *rows = task->rows;

	for (size_t k = 0, run; k < n; k += run) {
		int a = p->type[rows->i[list[k]]], b = p->type[rows->j[list[k]]];

		run = ts_batch_alike(p, task->pair, rows, a, b, list + k, n - k);
		ts_batch_work(task, m, contacts, ts_pair_law(task->pair, a, b), list + k, run);
	}
}

/* The share of a constant model; see ts_row_share_generic. */
TS_INLINE void ts_row_share_batched(const struct ts_row_task *task, size_t from, size_t to,
				    const struct ts_granular_model *m, ts_batch_fn *contacts)
{
	struct ts_rows rows = *task->rows;
	uint32_t list[TS_ROW_BLOCK];

	for (; from < to; from += TS_ROW_BLOCK) {
		size_t end = to - from < TS_ROW_BLOCK ? to : from + TS_ROW_BLOCK;
		size_t n = ts_batch_find(&rows, from, end, ts_batch_parts(m), task->keep, list);

		ts_batch_send_for(task->p, &rows, m, list, n);
		ts_batch_send_places(&rows, end);
		ts_batch_list(task, m, contacts, list, n);
	}
}

#endif
