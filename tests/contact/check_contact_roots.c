/* Distances, their reciprocals and the roots of contacts have the bits of sqrt() and of a division. */
#include <math.h>
#include <stdint.h>
#include <string.h>

#include "asserts.h"
#include "../deck.h"
#include "contact/contact_roots.h"

enum { N = 64 };

struct columns {
	double d[3][N], radius[2][N], r_eff[N], distance[N], inverse[N], root[N];
} __attribute__((aligned(64)));

static struct columns columns;
static size_t filled;

static bool same(double a, double b)
{
	return memcmp(&a, &b, sizeof a) == 0 || (isnan(a) && isnan(b));
}

static void compare_columns(bool rooted)
{
	struct columns *c = &columns;

	ts_contact_roots(&(struct ts_contact_roots){ { c->d[0], c->d[1], c->d[2] },
						     { c->radius[0], c->radius[1] },
						     rooted ? c->r_eff : NULL,
						     c->distance,
						     c->inverse,
						     c->root },
			 filled);
	for (size_t k = 0; k < filled; k++) {
		volatile double square = c->d[0][k] * c->d[0][k] + c->d[1][k] * c->d[1][k] +
					 c->d[2][k] * c->d[2][k],
				distance = sqrt(square), inverse = distance > 0 ? 1 / distance : 0,
				overlap = c->radius[0][k] + c->radius[1][k] - distance;

		if (!same(c->distance[k], distance) || !same(c->inverse[k], inverse) ||
		    (rooted && !same(c->root[k], sqrt(c->r_eff[k] * overlap))))
			ck_abort_msg("square %a: distance %a, not %a; reciprocal %a, not %a", square,
				     c->distance[k], distance, c->inverse[k], inverse);
	}
	filled = 0;
}

static void add(double x, double y, double z)
{
	columns.d[0][filled] = x;
	columns.d[1][filled] = y;
	columns.d[2][filled] = z;
	columns.radius[0][filled] = 0.5;
	columns.radius[1][filled] = 0.75;
	columns.r_eff[filled] = 0.3;
	if (++filled == N)
		compare_columns(true);
}

/* A vector of this squared length: x has 20 bits, so that its square is exact, and y makes up the rest. */
static void add_square(double square)
{
	double x = sqrt(square), rest, y;
	int exponent;

	x = frexp(x, &exponent);
	x = ldexp(floor(ldexp(x, 20)), exponent - 20);
	rest = square - x * x;
	y = sqrt(rest);
	ck_assert(x * x + y * y == square);
	add(x, y, 0);
}

/* Root of t = 1 mod 8, modulo 2^bits. */
static uint64_t root_modulo(uint64_t t, int bits)
{
	uint64_t y = 1;

	for (int b = 3; b <= bits; b++)
		if (((y * y - t) >> b) & 1)
			y += UINT64_C(1) << (b - 1);
	return y;
}

__extension__ typedef unsigned __int128 wide;

/* All x with roots so near to a boundary between two numbers, m/2 of a unit in the last place with m odd: 2^bits x' = m^2 +
 * rest. bits: 54 or 55, for even and odd exponents. */
static size_t add_hard_squares(int rest, int bits)
{
	const uint64_t modulus = UINT64_C(1) << bits, y = root_modulo((uint64_t)(int64_t)-rest, bits);
	size_t n = 0;

	for (int q = 0; q < 4; q++) {
		uint64_t m = ((q & 1 ? -y : y) + (q & 2 ? modulus >> 1 : 0)) & (modulus - 1);
		wide x = (wide)m * m + (wide)rest;

		if (m < UINT64_C(1) << 53 || m >> 54)
			continue;
		ck_assert((uint64_t)x % modulus == 0);
		x >>= bits;
		if (x >> 52 != 1)
			continue;
		for (int shift = -300; shift <= 300; shift += 20)
			add_square(ldexp((double)(uint64_t)x, bits - 106 + shift));
		n++;
	}
	return n;
}

START_TEST(hard_roots)
{
	size_t n = 0;

	for (int rest = -4096; rest <= 4096; rest++)
		if ((-rest & 7) == 1) /* an odd square is 1 modulo 8 */
			n += add_hard_squares(rest, 54) + add_hard_squares(rest, 55);
	compare_columns(true);
	ck_assert_uint_gt(n, 1000);
}
END_TEST

/* Reciprocals of distances all bits of whose mantissas are 1, or nearly all; and of those just above powers of two. */
START_TEST(hard_reciprocals)
{
	for (int exponent = -250; exponent <= 250; exponent++)
		for (int k = -40; k <= 40; k++)
			add(ldexp(1 + k * 0x1p-53, exponent), 0, 0);
	compare_columns(true);
}
END_TEST

START_TEST(unusual)
{
	static const double odd[] = { 0,	-0.0,	  0x1p-1074, 0x1p-540, 0x1p-512, 0x1p-511,
				      0x1p-256, 0x1p-255, 0x1p-254,  0x1p254,  0x1p255,	 0x1p256,
				      0x1p511,	0x1p512,  0x1p1000,  INFINITY, NAN };

	for (size_t a = 0; a < sizeof odd / sizeof *odd; a++)
		for (size_t b = 0; b < sizeof odd / sizeof *odd; b++) {
			add(odd[a], odd[b], 0);
			add(0, 1, -odd[b]);
		}
	compare_columns(false);
	add(1, 0, 0); /* fewer than a vector */
	compare_columns(true);
}
END_TEST

static uint64_t next(uint64_t *state)
{
	*state ^= *state << 13;
	*state ^= *state >> 7;
	return *state ^= *state << 17;
}

static double mantissa(uint64_t bits)
{
	return 1 + ldexp((double)(bits >> 12), -52);
}

START_TEST(random_distances)
{
	uint64_t state = 88172645463325252u;

	for (long k = 0; k < 4000000; k++) {
		double x = mantissa(next(&state)), y = mantissa(next(&state)), z = mantissa(next(&state));

		if (k % 3 == 0)
			add_square(ldexp(x, (int)(k % 7) - 3));
		else
			add(ldexp(x, (int)(k % 11) - 5), k % 3 == 1 ? y : 0, z - 1);
	}
	compare_columns(true);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("roots of contacts");
	TCase *tests = tcase_create("roots");

	tcase_set_timeout(tests, 60);
	tcase_add_test(tests, hard_roots);
	tcase_add_test(tests, hard_reciprocals);
	tcase_add_test(tests, unusual);
	tcase_add_test(tests, random_distances);
	suite_add_tcase(suite, tests);
	return deck_main(suite);
}
