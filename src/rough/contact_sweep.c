#include "base/clones.h"
TS_UNROLLED
#include "rough/contact_sweep.h"

#include <math.h>

#include "base/alloc.h"
#include "base/parallel.h"

#include "base/banned.h"

enum { LANES = 8, BLOCK = 2048 /* cells, a multiple of LANES */ };

static size_t blocks(const struct ts_contact_sweep *s)
{
	return (s->n + BLOCK - 1) / BLOCK;
}

enum ts_status ts_contact_sweep_make(struct ts_contact_sweep *s)
{
	s->part = ts_alloc(blocks(s), sizeof *s->part);
	s->gradient = ts_alloc(s->n, 3 * sizeof *s->gradient);
	if (!s->part || !s->gradient)
		return TS_NOMEM;
	s->move = s->gradient + s->n;
	s->change = s->move + s->n;
	return TS_OK;
}

void ts_contact_sweep_release(struct ts_contact_sweep *s)
{
	ts_free(s->part);
	ts_free(s->gradient);
	s->part = NULL;
	s->gradient = NULL;
}

struct task {
	struct ts_contact_sweep *s;
	double number; /* rate, shift, share or mean */
};

static double limited(double x, double top)
{
	x = x > 0 ? x : 0;
	return x < top ? x : top;
}

/* Defines NAME_range, which does BODY for cell k of all blocks from .. to-1; it changes first[l] and
 * second[l], the sums of a lane, which COMBINE unites. */
#define SWEEP(name, BODY, COMBINE)                                                                     \
	TS_CLONES                                                                                      \
	static void name##_block(const struct ts_contact_sweep *s, const double number, size_t from,   \
				 size_t to, double part[2])                                            \
	{                                                                                              \
		double *restrict p = s->p, *restrict gap = s->gap, *restrict gradient = s->gradient;   \
		double *restrict move = s->move, *restrict change = s->change;                         \
		const double top = s->top;                                                             \
		double first[LANES] = { 0 }, second[LANES] = { 0 };                                    \
		size_t k = from;                                                                       \
                                                                                                       \
		(void)p, (void)gap, (void)gradient, (void)move, (void)change, (void)top, (void)number; \
		for (; k + LANES <= to; k += LANES) {                                                  \
			_Pragma("omp simd") for (size_t l = 0; l < LANES; l++) BODY(k + l, l)          \
		}                                                                                      \
		for (size_t l = 0; k < to; k++, l++)                                                   \
			BODY(k, l)                                                                     \
		for (size_t l = 0; l < LANES; l++) {                                                   \
			part[0] = COMBINE(part[0], first[l]);                                          \
			part[1] = COMBINE(part[1], second[l]);                                         \
		}                                                                                      \
	}                                                                                              \
	static void name##_range(void *context, size_t from, size_t to)                                \
	{                                                                                              \
		struct task *task = context;                                                           \
		struct ts_contact_sweep *s = task->s;                                                  \
                                                                                                       \
		for (size_t b = from; b < to; b++) {                                                   \
			size_t end = (b + 1) * BLOCK < s->n ? (b + 1) * BLOCK : s->n;                  \
                                                                                                       \
			s->part[b][0] = s->part[b][1] = 0;                                             \
			name##_block(s, task->number, b *BLOCK, end, s->part[b]);                      \
		}                                                                                      \
	}

/* clang-format off */
#define DESCEND(k, l) { move[k] = p[k] - number * gap[k]; }
#define SHIFT(k, l) {                                                                                        \
		double moved = move[k] + number, kept = limited(moved, top);                                 \
		first[l] += kept;                                                                            \
		second[l] += kept <= moved && kept >= moved ? 1.0 : 0.0;                                     \
	}
#define LIMIT(k, l) {                                                                                        \
		double moved = limited(move[k] + number, top) - p[k];                                        \
		move[k] = moved;                                                                             \
		first[l] += gap[k] * moved;                                                                  \
		second[l] += moved * moved;                                                                  \
	}
#define RESPOND(k, l) {                                                                                      \
		first[l] += move[k] * change[k];                                                             \
		second[l] += change[k] * change[k];                                                          \
	}
#define ADVANCE(k, l) {                                                                                      \
		p[k] += number * move[k];                                                                    \
		gradient[k] += number * change[k];                                                           \
	}
#define CONTACTS(k, l) {                                                                                     \
		double in = p[k] > 0 && p[k] < top ? 1.0 : 0.0;                                              \
		first[l] += in * gradient[k];                                                                \
		second[l] += in;                                                                             \
	}
#define GAP(k, l) {                                                                                          \
		double open = gradient[k] - number, least = p[k] > 0 ? open : 0, most = p[k] < top ? -open : 0; \
		double wrong = LARGER(least, most);                                                  \
		gap[k] = open;                                                                               \
		first[l] = LARGER(first[l], wrong);                                              \
	}
/* clang-format on */
#define ADD(a, b) ((a) + (b))
#define LARGER(a, b) ((a) > (b) ? (a) : (b))
SWEEP(descend, DESCEND, ADD)
SWEEP(shift, SHIFT, ADD)
SWEEP(limit, LIMIT, ADD)
SWEEP(respond, RESPOND, ADD)
SWEEP(advance, ADVANCE, ADD)
SWEEP(contacts, CONTACTS, ADD)
SWEEP(gap, GAP, LARGER)

static void add_parts(struct ts_contact_sweep *s, ts_range_fn *range, double number, double sum[2])
{
	struct task task = { s, number };

	ts_parallel(s->threads, blocks(s), range, &task);
	sum[0] = sum[1] = 0;
	for (size_t b = 0; b < blocks(s); b++)
		for (int d = 0; d < 2; d++)
			sum[d] += s->part[b][d];
}

void ts_contact_sweep_descend(struct ts_contact_sweep *s, double rate)
{
	struct task task = { s, rate };

	ts_parallel(s->threads, blocks(s), descend_range, &task);
}

void ts_contact_sweep_shift(struct ts_contact_sweep *s, double shift, double sum[2])
{
	add_parts(s, shift_range, shift, sum);
}

void ts_contact_sweep_limit(struct ts_contact_sweep *s, double shift, double sum[2])
{
	add_parts(s, limit_range, shift, sum);
}

void ts_contact_sweep_respond(struct ts_contact_sweep *s, double sum[2])
{
	add_parts(s, respond_range, 0, sum);
}

void ts_contact_sweep_advance(struct ts_contact_sweep *s, double share)
{
	struct task task = { s, share };

	ts_parallel(s->threads, blocks(s), advance_range, &task);
}

void ts_contact_sweep_contacts(struct ts_contact_sweep *s, double sum[2])
{
	add_parts(s, contacts_range, 0, sum);
}

double ts_contact_sweep_gap(struct ts_contact_sweep *s, double mean)
{
	struct task task = { s, mean };
	double most = 0;

	ts_parallel(s->threads, blocks(s), gap_range, &task);
	for (size_t b = 0; b < blocks(s); b++)
		most = fmax(most, s->part[b][0]);
	return most;
}
