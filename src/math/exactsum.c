#include "math/exactsum.h"

#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <string.h>

#include "base/clones.h"

#include "base/banned.h"

/* An addition changes a limb by less than 2^32: limbs cannot overflow before this number of additions. */
enum { MOST_CARRIES = 1 << 29 };

/* Normalises all limbs but the last, which carries the sign, to [0, 2^32). */
static void propagate_carries(struct ts_exactsum *sum)
{
	int64_t up = 0;

	for (int k = 0; k < TS_EXACTSUM_LIMBS; k++) {
		int64_t now = sum->limb[k] + up;

		if (k == TS_EXACTSUM_LIMBS - 1) {
			sum->limb[k] = now;
			break;
		}
		sum->limb[k] = now & 0xffffffff;
		up = (now - sum->limb[k]) / (INT64_C(1) << 32);
	}
	sum->carries = 0;
}

static void add_to_limbs(struct ts_exactsum *sum, double term)
{
	uint64_t bits, mantissa, low, high;
	unsigned exponent, shift;
	int64_t *limb;

	memcpy(&bits, &term, sizeof bits);
	exponent = (unsigned)(bits >> 52) & 0x7ff;
	mantissa = bits & ((UINT64_C(1) << 52) - 1);
	if (exponent == 0x7ff) {
		sum->special += term;
		return;
	}
	if (exponent) {
		mantissa |= UINT64_C(1) << 52;
		exponent--;
	}
	/* term = +-mantissa 2^(exponent - 1074); its 53 bits are distributed over three limbs */
	limb = &sum->limb[exponent / 32];
	shift = exponent % 32;
	low = mantissa << shift;
	high = shift ? mantissa >> (64 - shift) : 0;
	if (bits >> 63) {
		limb[0] -= (int64_t)(low & 0xffffffff);
		limb[1] -= (int64_t)(low >> 32);
		limb[2] -= (int64_t)high;
	} else {
		limb[0] += (int64_t)(low & 0xffffffff);
		limb[1] += (int64_t)(low >> 32);
		limb[2] += (int64_t)high;
	}
	if (++sum->carries >= MOST_CARRIES)
		propagate_carries(sum);
}

/* ---- terms together
 *
 * Each term is split at the same power of two u: into a multiple of u, and a rest of at most u/2. Adding a number sigma whose
 * unit in the last place is u rounds a term to that multiple. The multiples of all terms have so few digits that their sum in
 * doubles is exact, in any order; the rests are split in the next round, until none is left. */
enum {
	DIGITS = 46,	  /* of a multiple of u: 2^46 times 128 terms is 2^53 */
	FEW = 24,	  /* fewer terms are faster one by one, */
	ROUNDS = 3,	  /* and so is what is left after these */
	SMALLEST = -1022, /* exponent of sigma when u is 2^-1074, of which each double is a multiple */
};
#define LARGE 0x1p960 /* larger terms are added one by one, as sigma could overflow */
_Static_assert(TS_EXACTSUM_WAITING <= 1 << (53 - DIGITS), "sums of a round are exact");

/* The largest absolute value; infinite if one is LARGE, infinite or NaN. */
TS_CLONES static double largest(const double term[TS_EXACTSUM_WAITING])
{
	double most = 0;
	int64_t beyond = 0;

#pragma omp simd reduction(max : most) reduction(+ : beyond)
	for (size_t i = 0; i < TS_EXACTSUM_WAITING; i++) {
		double size = fabs(term[i]);

		most = size > most ? size : most;
		beyond += size < LARGE ? 0 : 1; /* 1 for NaN */
	}
	return beyond ? INFINITY : most;
}

/* Sum of the multiples; leaves the rests, of which the largest is *most. */
TS_CLONES static double split(double term[TS_EXACTSUM_WAITING], double sigma, double *most)
{
	double sum = 0, rest = 0;

#pragma omp simd reduction(max : rest) reduction(+ : sum)
	for (size_t i = 0; i < TS_EXACTSUM_WAITING; i++) {
		double multiple = (term[i] + sigma) - sigma, left = term[i] - multiple, size = fabs(left);

		term[i] = left;
		sum += multiple;
		rest = size > rest ? size : rest;
	}
	*most = rest;
	return sum;
}

/* One round. *most: the largest term, then the largest rest. */
static void add_multiples(struct ts_exactsum *sum, double term[TS_EXACTSUM_WAITING], double *most)
{
	int exponent;

	(void)frexp(*most, &exponent); /* *most < 2^exponent, u = 2^(exponent - DIGITS) */
	exponent += 52 - DIGITS;
	add_to_limbs(sum, split(term, ldexp(1.5, exponent > SMALLEST ? exponent : SMALLEST), most));
}

void ts_exactsum_add_block(struct ts_exactsum *sum, double term[TS_EXACTSUM_WAITING], size_t n)
{
	double most = INFINITY;

	if (FLT_EVAL_METHOD == 0 && n >= FEW) {
		memset(term + n, 0, (TS_EXACTSUM_WAITING - n) * sizeof *term);
		most = largest(term);
	}
	for (int round = 0; round < ROUNDS && most > 0 && isfinite(most); round++)
		add_multiples(sum, term, &most);
	for (size_t k = 0; most > 0 && k < n; k++)
		add_to_limbs(sum, term[k]);
}

void ts_exactsum_absorb(struct ts_exactsum *sum)
{
	ts_exactsum_add_block(sum, sum->term, sum->waiting);
	sum->waiting = 0;
}

static void normalise(struct ts_exactsum *sum)
{
	ts_exactsum_absorb(sum);
	propagate_carries(sum);
}

void ts_exactsum_merge(struct ts_exactsum *sum, const struct ts_exactsum *other)
{
	struct ts_exactsum copy = *other;

	normalise(&copy);
	normalise(sum);
	for (int k = 0; k < TS_EXACTSUM_LIMBS; k++)
		sum->limb[k] += copy.limb[k];
	sum->special += copy.special;
	sum->carries = 1;
}

/* Changes the sign if the sum, which must be normalised, is negative; returns whether it was. */
static bool make_positive(struct ts_exactsum *sum)
{
	if (sum->limb[TS_EXACTSUM_LIMBS - 1] >= 0)
		return false;
	for (int k = 0; k < TS_EXACTSUM_LIMBS; k++)
		sum->limb[k] = -sum->limb[k];
	propagate_carries(sum);
	return true;
}

/* Limbs of a negative sum are all negative, so that only those of its digits are not 0. Behind the limbs: numbers of sums
 * that are not finite, by kind. */
void ts_exactsum_pack(struct ts_exactsum *sum, int64_t integer[TS_EXACTSUM_INTEGERS])
{
	int64_t *kind = integer + TS_EXACTSUM_LIMBS, sign;

	normalise(sum);
	sign = make_positive(sum) ? -1 : 1;
	for (int k = 0; k < TS_EXACTSUM_LIMBS; k++)
		integer[k] = sum->limb[k] *= sign;
	kind[0] = isnan(sum->special);
	kind[1] = sum->special == INFINITY;
	kind[2] = sum->special == -INFINITY;
}

struct ts_exactsum ts_exactsum_unpack(const int64_t integer[TS_EXACTSUM_INTEGERS])
{
	const int64_t *kind = integer + TS_EXACTSUM_LIMBS;
	struct ts_exactsum sum = ts_exactsum_start();

	memcpy(sum.limb, integer, sizeof sum.limb);
	propagate_carries(&sum);
	if (kind[0] || (kind[1] && kind[2]))
		sum.special = NAN;
	else if (kind[1] || kind[2])
		sum.special = kind[1] ? INFINITY : -INFINITY;
	return sum;
}

static bool get_bit(const struct ts_exactsum *sum, int k)
{
	return (sum->limb[k / 32] >> (k % 32)) & 1;
}

/* Index of the highest bit that is set; -1: none. The sum must be normalised and not negative. */
static int top_bit(const struct ts_exactsum *sum)
{
	for (int k = TS_EXACTSUM_LIMBS - 1; k >= 0; k--)
		if (sum->limb[k])
			for (int b = 62;; b--)
				if (sum->limb[k] >> b)
					return 32 * k + b;
	return -1;
}

/* Whether any bit below bit k is set. */
static bool any_bit_below(const struct ts_exactsum *sum, int k)
{
	while (--k >= 0)
		if (get_bit(sum, k))
			return true;
	return false;
}

double ts_exactsum_value(const struct ts_exactsum *sum)
{
	struct ts_exactsum s = *sum;
	bool negative;
	int64_t mantissa = 0;
	int top, lowest;

	normalise(&s);
	if (s.special != 0) /* true for NaN too */
		return s.special;
	negative = make_positive(&s);
	top = top_bit(&s);
	if (top < 0)
		return 0;
	lowest = top > 52 ? top - 52 : 0; /* the last bit that a double can represent */
	for (int k = top; k >= lowest; k--)
		mantissa = 2 * mantissa + get_bit(&s, k);
	if (lowest > 0 && get_bit(&s, lowest - 1) && (mantissa % 2 || any_bit_below(&s, lowest - 1)))
		mantissa++;
	return ldexp((double)(negative ? -mantissa : mantissa), lowest - 1074);
}

double ts_exactsum_of(const double *data, size_t n, size_t stride)
{
	struct ts_exactsum sum = ts_exactsum_start();

	for (size_t i = 0; i < n; i++)
		ts_exactsum_add(&sum, data[i * stride]);
	return ts_exactsum_value(&sum);
}
