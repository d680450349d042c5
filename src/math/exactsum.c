#include "math/exactsum.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

#include "base/banned.h"

/* An addition changes a limb by less than 2^32: limbs cannot overflow before this number of additions. */
enum { MOST_WAITING = 1 << 29 };

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
	sum->waiting = 0;
}

void ts_exactsum_add(struct ts_exactsum *sum, double term)
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
	if (++sum->waiting >= MOST_WAITING)
		propagate_carries(sum);
}

void ts_exactsum_merge(struct ts_exactsum *sum, const struct ts_exactsum *other)
{
	struct ts_exactsum copy = *other;

	propagate_carries(&copy);
	propagate_carries(sum);
	for (int k = 0; k < TS_EXACTSUM_LIMBS; k++)
		sum->limb[k] += copy.limb[k];
	sum->special += other->special;
	sum->waiting = 1;
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

	propagate_carries(sum);
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

	if (s.special != 0) /* true for NaN too */
		return s.special;
	propagate_carries(&s);
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
