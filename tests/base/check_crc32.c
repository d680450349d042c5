/* CRC-32 beside that of zlib. */
#include <stdint.h>
#include <stdlib.h>
#include <zlib.h>

#include "asserts.h"
#include "base/crc32.h"

enum { MOST = 1200 };

static unsigned char bytes[MOST];

static void draw_bytes(void)
{
	uint64_t bits = 88172645463325252u;

	for (size_t i = 0; i < MOST; i++) {
		bits ^= bits << 13;
		bits ^= bits >> 7;
		bits ^= bits << 17;
		bytes[i] = (unsigned char)bits;
	}
}

static uint32_t zlib_crc(uint32_t sum, const unsigned char *from, size_t n)
{
	return n ? (uint32_t)crc32_z(sum, from, n) : sum;
}

/* The check value of CRC-32/ISO-HDLC, as in the catalogue of CRC algorithms. */
START_TEST(check_value)
{
	ck_assert_uint_eq(ts_crc32(0, "123456789", 9), 0xcbf43926);
}
END_TEST

START_TEST(every_length_and_start)
{
	draw_bytes();
	for (size_t start = 0; start < 20; start++)
		for (size_t n = 0; n + start <= MOST; n++)
			ck_assert_uint_eq(ts_crc32(0, bytes + start, n), zlib_crc(0, bytes + start, n));
}
END_TEST

/* A sum of two parts is that of the whole, wherever it is parted; no bytes change nothing. */
START_TEST(parts)
{
	uint32_t whole;

	draw_bytes();
	whole = zlib_crc(0, bytes, MOST);
	for (size_t n = 0; n <= MOST; n++)
		ck_assert_uint_eq(ts_crc32(ts_crc32(0, bytes, n), bytes + n, MOST - n), whole);
	ck_assert_uint_eq(ts_crc32(whole, NULL, 0), whole);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("crc32");
	TCase *tcase = tcase_create("crc32");
	SRunner *runner = srunner_create(suite);
	int failed;

	tcase_add_test(tcase, check_value);
	tcase_add_test(tcase, every_length_and_start);
	tcase_add_test(tcase, parts);
	suite_add_tcase(suite, tcase);
	srunner_run_all(runner, CK_NORMAL);
	failed = srunner_ntests_failed(runner);
	srunner_free(runner);
	return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
