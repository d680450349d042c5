#include "io/decimal.h"

#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "base/str.h"

#include "base/banned.h"

/* A whole number of up to LIMBS digits of base 2^32, the lowest first. The largest one is twice the largest
 * double; the smallest double times the power of ten that makes it a number of 17 digits has 27 digits. */
enum { LIMBS = 36, MANTISSA = 53 };
struct whole {
	uint32_t limb[LIMBS];
	int n;	   /* limbs in use; the highest is not zero */
	bool rest; /* parts that are not zero were dropped */
};

/* Powers of five, and the largest of them below 2^32. */
enum { FIVES = 13 };
static const uint32_t five[FIVES + 1] = { 1,	 5,	 25,	  125,	   625,	     3125,	15625,
					  78125, 390625, 1953125, 9765625, 48828125, 244140625, 1220703125 };

static void multiply(struct whole *a, uint32_t factor)
{
	uint64_t carry = 0;

	for (int k = 0; k < a->n; k++) {
		carry += (uint64_t)a->limb[k] * factor;
		a->limb[k] = (uint32_t)carry;
		carry >>= 32;
	}
	if (carry)
		a->limb[a->n++] = (uint32_t)carry;
}

static void divide(struct whole *a, uint32_t divisor)
{
	uint64_t left = 0;

	for (int k = a->n; k-- > 0;) {
		left = left << 32 | a->limb[k];
		a->limb[k] = (uint32_t)(left / divisor);
		left %= divisor;
	}
	while (a->n && !a->limb[a->n - 1])
		a->n--;
	a->rest |= left != 0;
}

static void apply_fives(struct whole *a, int power, void (*apply)(struct whole *, uint32_t))
{
	for (; power > FIVES; power -= FIVES)
		apply(a, five[FIVES]);
	apply(a, five[power]);
}

static void shift_left(struct whole *a, int bits)
{
	int limbs = bits / 32;

	multiply(a, (uint32_t)1 << bits % 32);
	memmove(a->limb + limbs, a->limb, (size_t)a->n * sizeof *a->limb);
	memset(a->limb, 0, (size_t)limbs * sizeof *a->limb);
	a->n += limbs;
}

static void shift_right(struct whole *a, int bits)
{
	int limbs = bits / 32, odd = bits % 32;

	if (limbs > a->n)
		limbs = a->n;
	for (int k = 0; k < limbs; k++)
		a->rest |= a->limb[k] != 0;
	a->n -= limbs;
	if (!a->n)
		return;
	a->rest |= (a->limb[limbs] & (((uint32_t)1 << odd) - 1)) != 0;
	a->limb[limbs + a->n] = 0;
	for (int k = 0; k < a->n; k++)
		a->limb[k] = (uint32_t)(((uint64_t)a->limb[limbs + k + 1] << 32 | a->limb[limbs + k]) >> odd);
	a->n -= !a->limb[a->n - 1];
}

/* mantissa 2^binary 10^power, which is below 2^63, in units of one half: the last bit tells whether a half is
 * left; *rest whether there is more than that. All digits are exact. */
static uint64_t halves(uint64_t mantissa, int binary, int power, bool *rest)
{
	int shift = binary + power + 1; /* 10^p = 2^p 5^p */
	struct whole a;			/* an initializer would clear all limbs */

	a.limb[0] = (uint32_t)mantissa;
	a.limb[1] = (uint32_t)(mantissa >> 32);
	a.n = 2;
	a.rest = false;

	if (power > 0)
		apply_fives(&a, power, multiply);
	if (shift > 0)
		shift_left(&a, shift);
	else if (shift < 0)
		shift_right(&a, -shift);
	if (power < 0)
		apply_fives(&a, -power, divide);
	*rest = a.rest;
	return (a.n > 0 ? a.limb[0] : 0) | (a.n > 1 ? (uint64_t)a.limb[1] << 32 : 0);
}

/* The first `digits` digits of a > 0 as a whole number, rounded to nearest, ties to even; *exponent is that of
 * the first digit. */
static uint64_t round_to_digits(double a, int digits, int *exponent)
{
	static const uint64_t ten[TS_DECIMAL_DIGITS + 1] = { 1,
							     10,
							     100,
							     1000,
							     10000,
							     100000,
							     1000000,
							     10000000,
							     100000000,
							     1000000000,
							     10000000000,
							     100000000000,
							     1000000000000,
							     10000000000000,
							     100000000000000,
							     1000000000000000,
							     10000000000000000,
							     100000000000000000 };
	uint64_t end = ten[digits], mantissa, twice, n;
	double fraction, estimate;
	int binary, e;
	bool rest;

	fraction = frexp(a, &binary);
	mantissa = (uint64_t)(fraction * 0x1p53);
	/* lb(2 f) >= 2 f - 1 for 1/2 <= f < 1: the exponent, or now and then one less */
	estimate = (binary - 2 + 2 * fraction) * 0.30102999566398120;
	e = (int)estimate - (estimate < 0); /* or one less than the floor, also for a whole number below 0 */
	twice = halves(mantissa, binary - MANTISSA, digits - 1 - e, &rest);
	if (twice >= 2 * end)
		twice = halves(mantissa, binary - MANTISSA, digits - 1 - ++e, &rest);
	n = twice >> 1;
	n += (twice & 1) && (rest || (n & 1));
	if (n == end) {
		n /= 10;
		e++;
	}
	*exponent = e;
	return n;
}

static void write_pair(char *to, uint32_t n)
{
	static const char pair[] = "0001020304050607080910111213141516171819202122232425262728293031323334353"
				   "6373839404142434445464748495051525354555657585960616263646566676869707172"
				   "737475767778798081828384858687888990919293949596979899";

	memcpy(to, pair + 2 * n, 2);
}

static void write_four(char *to, uint32_t n)
{
	write_pair(to, n / 100);
	write_pair(to + 2, n % 100);
}

/* Writes the digits of n so that they end before `to`, in pairs that do not wait for each other; returns their
 * start. */
static char *digits_before(char *to, uint64_t n)
{
	for (; n >= 100000000; n /= 100000000) {
		uint32_t low = (uint32_t)(n % 100000000);

		to -= 8;
		write_four(to, low / 10000);
		write_four(to + 4, low % 10000);
	}
	for (; n >= 100; n /= 100)
		write_pair(to -= 2, (uint32_t)(n % 100));
	if (n >= 10)
		write_pair(to -= 2, (uint32_t)n);
	else
		*--to = (char)('0' + n);
	return to;
}

size_t ts_decimal_lld(long long value, char out[TS_DECIMAL_SIZE])
{
	char text[TS_DECIMAL_SIZE], *end = text + sizeof text;
	char *begin = digits_before(end, value < 0 ? 0 - (uint64_t)value : (uint64_t)value);
	size_t n;

	if (value < 0)
		*--begin = '-';
	n = (size_t)(end - begin);
	memcpy(out, begin, n);
	return n;
}

/* d.ddde+09, d.ddde-120 */
static char *write_exponential(char *to, const char *digit, size_t n, int exponent)
{
	char text[TS_DECIMAL_SIZE], *end = text + sizeof text, *begin;
	uint64_t size = (uint64_t)(exponent < 0 ? -exponent : exponent);

	*to++ = *digit;
	if (n > 1) {
		*to++ = '.';
		memcpy(to, digit + 1, n - 1);
		to += n - 1;
	}
	*to++ = 'e';
	*to++ = exponent < 0 ? '-' : '+';
	begin = digits_before(end, size);
	if (size < 10)
		*--begin = '0';
	memcpy(to, begin, (size_t)(end - begin));
	return to + (end - begin);
}

/* ddd.ddd, or 0.000ddd */
static char *write_fixed(char *to, const char *digit, size_t n, int exponent)
{
	size_t k = 0, before = exponent < 0 ? 0 : (size_t)exponent + 1; /* digits before the point */

	if (exponent < 0)
		*to++ = '0';
	for (; k < before; k++) /* with trailing zeros before the point */
		*to++ = k < n ? digit[k] : '0';
	if (k < n)
		*to++ = '.';
	for (int zero = -1; zero > exponent; zero--)
		*to++ = '0';
	for (; k < n; k++)
		*to++ = digit[k];
	return to;
}

/* Writes the number of `digits` digits n, the first of which has the exponent. */
static size_t write_digits(bool negative, uint64_t number, int digits, int exponent,
			   char out[TS_DECIMAL_SIZE])
{
	char text[TS_DECIMAL_DIGITS + 1], *to = out;
	size_t n = (size_t)digits;

	digits_before(text + digits, number);
	while (n > 1 && text[n - 1] == '0')
		n--;
	if (negative)
		*to++ = '-';
	to = exponent < -4 || exponent >= digits ? write_exponential(to, text, n, exponent)
						 : write_fixed(to, text, n, exponent);
	return (size_t)(to - out);
}

/* Zero, inf and nan. */
static size_t write_special(double value, char out[TS_DECIMAL_SIZE])
{
	if (value == 0) {
		memcpy(out, "-0", 2);
		out[0] = signbit(value) ? '-' : '0';
		return signbit(value) ? 2 : 1;
	}
	return (size_t)snprintf(out, TS_DECIMAL_SIZE, "%g", value);
}

size_t ts_decimal_g(double value, int digits, char out[TS_DECIMAL_SIZE])
{
	uint64_t number;
	int exponent;

	if (value == 0 || !isfinite(value))
		return write_special(value, out);
	number = round_to_digits(fabs(value), digits, &exponent);
	return write_digits(value < 0, number, digits, exponent, out);
}

/* Whether a number with the 17 digits n can be that of a double which fewer digits give, the last of which counts
 * `unit`: the nearest such number is not farther away than half a unit in the last place of the double, at most n 2^-53;
 * a unit of the 17 digits for how they were rounded, and for that product. */
static bool may_be_shorter(uint64_t n, uint64_t unit)
{
	uint64_t rest = n % unit, away = rest < unit - rest ? rest : unit - rest;

	return (double)away <= (double)n * 0x1p-53 + 1;
}

size_t ts_decimal_shortest(double value, char out[TS_DECIMAL_SIZE])
{
	uint64_t all, unit = 100;
	int exponent;

	if (value == 0 || !isfinite(value))
		return write_special(value, out);
	all = round_to_digits(fabs(value), TS_DECIMAL_DIGITS, &exponent);
	for (int digits = 15; digits < TS_DECIMAL_DIGITS; digits++, unit /= 10) {
		double back;
		size_t n;

		if (fabs(value) >= DBL_MIN && !may_be_shorter(all, unit))
			continue;
		n = ts_decimal_g(value, digits, out);
		out[n] = '\0';
		if (ts_parse_real(out, &back) && !(back < value) && !(back > value))
			return n;
	}
	return write_digits(value < 0, all, TS_DECIMAL_DIGITS, exponent, out);
}
