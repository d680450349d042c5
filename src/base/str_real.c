/* Numbers from text, with the bits of strtod and several times faster: it takes most of the time in which a large
 * file is read.
 *
 * A number of up to 19 digits is w 10^q with a whole number w below 2^64. With q = 27 a + b, 0 <= b < 27, it is the
 * product of w, of 5^b, which 64 bits hold exactly, of 10^(27 a), of which a table has the first 64 bits, and of a power
 * of two. Each product keeps its first 64 bits, so that the result is too small by less than SHORT units of the last of
 * them; 53 are wanted. Only if a number that much larger were rounded to another double is strtod needed: once in three
 * hundred numbers of 17 digits. (D. Lemire, Number parsing at a gigabyte per second, Software: Practice and Experience
 * 51, 2021, has 128 bits of each power and need not ask.) */
#include "base/str.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/banned.h"

/* MOST_DIGITS: of w. EXACT: largest power of ten that a double holds exactly. FIVES: largest of five in 64 bits. TABLE: of
 * the exponents of the table. SPARE: bits of the product that a double has not. SHORT: see above; a product of two
 * numbers too small by x and y units, shifted left by at most one bit, is too small by less than 2 (x + y + 1). */
enum { MOST_DIGITS = 19, EXACT = 22, FIVES = 27, TABLE = 12, SPARE = 11, SHORT = 8 };
enum { LEAST_BINARY = -1022, LARGEST_BINARY = 1023, MANTISSA = 53, MOST_EXPONENT = 9999 };

/* Mantissa in [2^63, 2^64) times 2^binary. */
struct wide {
	uint64_t mantissa;
	int binary;
};

/* 10^(27 k), rounded down, for k from -TABLE on. */
static const struct wide powers[2 * TABLE] = {
	{ 0xcf42894a5dce35ea, -1140 }, { 0xa76c582338ed2621, -1050 }, { 0x873e4f75e2224e68, -960 },
	{ 0xda7f5bf590966848, -871 },  { 0xb080392cc4349dec, -781 },  { 0x8e938662882af53e, -691 },
	{ 0xe65829b3046b0afa, -602 },  { 0xba121a4650e4ddeb, -512 },  { 0x964e858c91ba2655, -422 },
	{ 0xf2d56790ab41c2a2, -333 },  { 0xc428d05aa4751e4c, -243 },  { 0x9e74d1b791e07e48, -153 },
	{ 0x8000000000000000, -63 },   { 0xcecb8f27f4200f3a, 26 },    { 0xa70c3c40a64e6c51, 116 },
	{ 0x86f0ac99b4e8dafd, 206 },   { 0xda01ee641a708de9, 295 },   { 0xb01ae745b101e9e4, 385 },
	{ 0x8e41ade9fbebc27d, 475 },   { 0xe5d3ef282a242e81, 564 },   { 0xb9a74a0637ce2ee1, 654 },
	{ 0x95f83d0a1fb69cd9, 744 },   { 0xf24a01a73cf2dccf, 833 },   { 0xc3b8358109e84f07, 923 },
};

/* The text as sign, w and q. */
struct decimal {
	bool negative;
	uint64_t digits;
	int exponent;
};

static bool is_digit(char c)
{
	return c >= '0' && c <= '9';
}

static const char *scan_exponent(const char *p, struct decimal *d)
{
	bool negative = *p == '-';
	int size = 0;

	p += *p == '-' || *p == '+';
	if (!is_digit(*p))
		return NULL;
	for (; is_digit(*p); p++)
		if (size <= MOST_EXPONENT)
			size = 10 * size + (*p - '0');
	d->exponent += negative ? -size : size;
	return p;
}

/* False: not a number, or one of more digits than w can have. */
static bool scan(const char *p, struct decimal *d)
{
	const char *begin, *point;
	ptrdiff_t n;

	*d = (struct decimal){ .negative = *p == '-' };
	p += *p == '-' || *p == '+';
	while (p[0] == '0' && is_digit(p[1]))
		p++;
	for (begin = p; is_digit(*p); p++)
		d->digits = 10 * d->digits + (uint64_t)(*p - '0');
	n = p - begin;
	if (*p == '.') {
		point = ++p;
		if (!d->digits) /* zeros that begin a number are not digits of w */
			for (; *p == '0'; p++)
				n--;
		for (; is_digit(*p); p++)
			d->digits = 10 * d->digits + (uint64_t)(*p - '0');
		n += p - point;
		d->exponent = (int)(point - p < -MOST_EXPONENT ? -MOST_EXPONENT : point - p);
		if (p == point && point == begin + 1)
			return false; /* no digit at all */
	} else if (!n) {
		return false;
	}
	if (*p == 'e' || *p == 'E')
		p = scan_exponent(p + 1, d);
	return p && !*p && n <= MOST_DIGITS;
}

static struct wide normalised(uint64_t mantissa, int binary)
{
	int shift = __builtin_clzll(mantissa);

	return (struct wide){ mantissa << shift, binary - shift };
}

static struct wide product(struct wide a, struct wide b)
{
	const uint64_t low = UINT32_MAX;
	uint64_t a1 = a.mantissa >> 32, a0 = a.mantissa & low, b1 = b.mantissa >> 32, b0 = b.mantissa & low;
	uint64_t middle = a1 * b0 + (a0 * b0 >> 32), other = a0 * b1 + (middle & low); /* neither overflows */
	uint64_t high = a1 * b1 + (middle >> 32) + (other >> 32), next = other << 32;  /* of the product */
	int top = (int)(high >> 63);

	return (struct wide){ top ? high : high << 1 | next >> 63, a.binary + b.binary + 63 + top };
}

/* Rounded to nearest; false if that is not certain, or if the double is not a normal one. */
static bool round_wide(struct wide a, double *out)
{
	const uint64_t half = (uint64_t)1 << (SPARE - 1), rest = a.mantissa & (2 * half - 1);
	uint64_t bits = a.mantissa >> SPARE;
	int exponent = a.binary + 63; /* of the first bit */

	if ((rest <= half && rest + SHORT >= half) || exponent < LEAST_BINARY || exponent >= LARGEST_BINARY)
		return false;
	/* the first bit of the mantissa, and a carry out of it, count in the exponent */
	bits += (uint64_t)(exponent - LEAST_BINARY) << (MANTISSA - 1);
	bits += rest > half;
	memcpy(out, &bits, sizeof bits);
	return true;
}

static bool convert(const struct decimal *d, double *out)
{
	static const double ten[EXACT + 1] = { 1,    1e1,  1e2,	 1e3,  1e4,  1e5,  1e6,	 1e7,
					       1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
					       1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22 };
	static const uint64_t five[FIVES] = { 1,
					      5,
					      25,
					      125,
					      625,
					      3125,
					      15625,
					      78125,
					      390625,
					      1953125,
					      9765625,
					      48828125,
					      244140625,
					      1220703125,
					      6103515625,
					      30517578125,
					      152587890625,
					      762939453125,
					      3814697265625,
					      19073486328125,
					      95367431640625,
					      476837158203125,
					      2384185791015625,
					      11920928955078125,
					      59604644775390625,
					      298023223876953125,
					      1490116119384765625 };
	int q = d->exponent, a, b;
	struct wide value;

	if (d->digits <= (uint64_t)1 << MANTISSA && abs(q) <= EXACT) { /* rounded once; also zero */
		*out = q < 0 ? (double)d->digits / ten[-q] : (double)d->digits * ten[q];
		return true;
	}
	if (!d->digits || q < -TABLE * FIVES || q >= TABLE * FIVES)
		return false;
	a = (q + TABLE * FIVES) / FIVES;
	b = (q + TABLE * FIVES) % FIVES;
	value = product(normalised(d->digits, 0), normalised(five[b], b));
	return round_wide(product(value, powers[a]), out);
}

/* All that is rare: zeros with an exponent, numbers of more digits, subnormal ones, and what is not a number. */
static bool parse_slowly(const char *text, double *out)
{
	char *end;
	double value;

	if (!*text || strspn(text, "0123456789+-.eE") != strlen(text))
		return false;
	value = strtod(text, &end);
	if (*end || !isfinite(value))
		return false;
	*out = value;
	return true;
}

bool ts_parse_real(const char *text, double *out)
{
	struct decimal d;
	double value;

	if (!scan(text, &d) || !convert(&d, &value))
		return parse_slowly(text, out);
	*out = d.negative ? -value : value;
	return true;
}
