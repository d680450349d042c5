/* Bytes are a polynomial over GF(2), and their CRC is its remainder by the polynomial of degree 32. 64 bytes at a time are folded
 * onto the next 64: multiplied by x^512 modulo that polynomial, which leaves the remainder the same. What is left, 16 bytes and
 * the end, goes to zlib. V. Gopal et al., Fast CRC Computation for Generic Polynomials Using PCLMULQDQ Instruction, Intel, 2009,
 * with its constants for polynomials whose bits are reflected. */
#include "base/crc32.h"

#if defined(__x86_64__) && defined(__GNUC__)
#include <immintrin.h>
#endif
#include <zlib.h>

#include "base/banned.h"

#if defined(__x86_64__) && defined(__GNUC__)
#define FOLDS __attribute__((target("pclmul")))

/* Bytes folded at once, and below which zlib is as fast. */
enum { WIDTH = 64, WORTHWHILE = 256 };

/* x^(n + 32) and x^(n - 32) for a distance of n = 512 and of n = 128 bits. */
#define FAR_HIGH 0x1c6e41596
#define FAR_LOW 0x154442bd4
#define NEAR_HIGH 0x0ccaa009e
#define NEAR_LOW 0x1751997d0

FOLDS static inline __m128i load(const unsigned char *from)
{
	return _mm_loadu_si128((const __m128i *)(const void *)from);
}

FOLDS static inline __m128i fold(__m128i a, __m128i by, __m128i onto)
{
	__m128i low = _mm_clmulepi64_si128(a, by, 0x00), high = _mm_clmulepi64_si128(a, by, 0x11);

	return _mm_xor_si128(_mm_xor_si128(low, high), onto);
}

/* n: a multiple of WIDTH, not 0. */
FOLDS static uint32_t fold_all(uint32_t sum, const unsigned char *bytes, size_t n)
{
	const __m128i far = _mm_set_epi64x(FAR_HIGH, FAR_LOW), near = _mm_set_epi64x(NEAR_HIGH, NEAR_LOW);
	unsigned char rest[16];
	__m128i a[4];

	for (int k = 0; k < 4; k++)
		a[k] = load(bytes + 16 * k);
	/* zlib's CRC starts with inverted bits, as those of the bytes before are added to the first bytes, and ends so */
	a[0] = _mm_xor_si128(a[0], _mm_cvtsi32_si128((int)~sum));
	for (const unsigned char *at = bytes + WIDTH; at < bytes + n; at += WIDTH)
		for (int k = 0; k < 4; k++)
			a[k] = fold(a[k], far, load(at + 16 * k));
	for (int k = 1; k < 4; k++)
		a[k] = fold(a[k - 1], near, a[k]);
	_mm_storeu_si128((__m128i *)(void *)rest, a[3]);
	return (uint32_t)crc32_z(~(uint32_t)0, rest, sizeof rest);
}

uint32_t ts_crc32(uint32_t sum, const void *bytes, size_t n)
{
	const unsigned char *from = bytes;
	size_t folded = n - n % WIDTH;

	if (n < WORTHWHILE || !__builtin_cpu_supports("pclmul"))
		return n ? (uint32_t)crc32_z(sum, from, n) : sum;
	sum = fold_all(sum, from, folded);
	return n > folded ? (uint32_t)crc32_z(sum, from + folded, n - folded) : sum;
}
#else
uint32_t ts_crc32(uint32_t sum, const void *bytes, size_t n)
{
	return n ? (uint32_t)crc32_z(sum, bytes, n) : sum;
}
#endif
