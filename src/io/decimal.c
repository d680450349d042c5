#include "io/decimal.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "base/banned.h"

enum { DIGITS = 6, FIRST = 100000 }; /* significant digits of %g; smallest integer of 6 digits */

/* Writes the digits of n so that they end before `to`; returns their start. */
static char *digits_before(char *to, uint64_t n)
{
	do {
		*--to = (char)('0' + n % 10);
		n /= 10;
	} while (n);
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

/* a 10^power. Powers of 10 up to 10^22 are exact in double and long double, so that the result is rounded
 * once. */
enum { MOST = 22 };
static long double scale_by_ten(double a, int power)
{
	static const long double ten[MOST + 1] = { 1e0L,  1e1L,	 1e2L,	1e3L,  1e4L,  1e5L,  1e6L,  1e7L,
						   1e8L,  1e9L,	 1e10L, 1e11L, 1e12L, 1e13L, 1e14L, 1e15L,
						   1e16L, 1e17L, 1e18L, 1e19L, 1e20L, 1e21L, 1e22L };

	return power < 0 ? a / ten[-power] : a * ten[power];
}

/* The first six digits of a > 0, rounded, and the decimal exponent of the first. Returns 0 if this method
 * cannot round correctly: for very large and small numbers, and near ties between two roundings. */
static int round_to_six_digits(double a, uint32_t *digits, int *exponent)
{
	int binary, e;
	long double y, rest;

	frexp(a, &binary);
	e = (int)floor((binary - 1) * 0.30102999566398120); /* or one more */
	if (e < DIGITS - 1 - MOST || e > DIGITS - 2 + MOST)
		return 0;
	y = scale_by_ten(a, DIGITS - 1 - e);
	if (y >= 10 * FIRST)
		y = scale_by_ten(a, DIGITS - 1 - ++e);
	*digits = (uint32_t)y;
	rest = y - *digits;
	if (fabsl(rest - 0.5L) < 1e-6L)
		return 0;
	*digits += rest > 0.5L;
	if (*digits == 10 * FIRST) {
		*digits = FIRST;
		e++;
	}
	*exponent = e;
	return 1;
}

/* d.ddde+XX */
static char *write_exponential(char *to, const char *digit, int n, int exponent)
{
	int size = exponent < 0 ? -exponent : exponent;

	*to++ = *digit;
	if (n > 1)
		*to++ = '.';
	memcpy(to, digit + 1, (size_t)(n - 1));
	to += n - 1;
	*to++ = 'e';
	*to++ = exponent < 0 ? '-' : '+';
	*to++ = (char)('0' + size / 10); /* less than 100 */
	*to++ = (char)('0' + size % 10);
	return to;
}

/* ddd.ddd, or 0.000ddd */
static char *write_fixed(char *to, const char *digit, int n, int exponent)
{
	int k = 0;

	if (exponent < 0)
		*to++ = '0';
	for (; k <= exponent; k++) /* with trailing zeros before the point */
		*to++ = k < n ? digit[k] : '0';
	if (k < n)
		*to++ = '.';
	for (int zero = -1; zero > exponent; zero--)
		*to++ = '0';
	for (; k < n; k++)
		*to++ = digit[k];
	return to;
}

size_t ts_decimal_g(double value, char out[TS_DECIMAL_SIZE])
{
	char text[DIGITS + 1], *to = out;
	uint32_t digits;
	int exponent, n = DIGITS;

	if (value == 0) {
		memcpy(out, "-0", 2);
		out[0] = signbit(value) ? '-' : '0';
		return signbit(value) ? 2 : 1;
	}
	if (!isfinite(value) || !round_to_six_digits(fabs(value), &digits, &exponent))
		return (size_t)snprintf(out, TS_DECIMAL_SIZE, "%g", value);
	digits_before(text + DIGITS, digits);
	while (n > 1 && text[n - 1] == '0')
		n--;
	if (value < 0)
		*to++ = '-';
	to = exponent < -4 || exponent >= DIGITS ? write_exponential(to, text, n, exponent)
						 : write_fixed(to, text, n, exponent);
	return (size_t)(to - out);
}
