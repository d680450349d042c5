/* Hashes of rows: independent of their order, changed by each of their bytes and by their numbers. */
#include <stdlib.h>
#include <string.h>

#include "asserts.h"
#include "base/hash.h"

enum { ROWS = 5, BYTES = 20 };

static uint64_t hash_of(const int32_t *key, const unsigned char *rows, size_t n)
{
	struct ts_hash seed = ts_hash_start();

	return ts_hash_rows(&seed, key, rows, BYTES, n);
}

static void fill(int32_t *key, unsigned char *rows)
{
	for (int i = 0; i < ROWS; i++)
		key[i] = 3 * i + 1;
	for (int k = 0; k < ROWS * BYTES; k++)
		rows[k] = (unsigned char)(k * 37 % 11);
}

START_TEST(order_makes_no_difference)
{
	int32_t key[ROWS], turned[ROWS];
	unsigned char rows[ROWS * BYTES], back[ROWS * BYTES];

	fill(key, rows);
	for (int i = 0; i < ROWS; i++) {
		turned[i] = key[ROWS - 1 - i];
		memcpy(back + i * BYTES, rows + (ROWS - 1 - i) * BYTES, BYTES);
	}
	ck_assert_uint_eq(hash_of(key, rows, ROWS), hash_of(turned, back, ROWS));
	ck_assert_uint_eq(hash_of(key, rows, 2) + hash_of(key + 2, rows + 2 * BYTES, ROWS - 2),
			  hash_of(key, rows, ROWS));
	ck_assert_uint_eq(hash_of(key, rows, 0), 0);
}
END_TEST

START_TEST(each_byte_counts)
{
	int32_t key[ROWS];
	unsigned char rows[ROWS * BYTES];
	uint64_t whole;

	fill(key, rows);
	whole = hash_of(key, rows, ROWS);
	for (int k = 0; k < ROWS * BYTES; k++) {
		rows[k] ^= 1;
		ck_assert_uint_ne(hash_of(key, rows, ROWS), whole);
		rows[k] ^= 1;
	}
	for (int i = 0; i + 1 < ROWS; i++) { /* two rows change their numbers */
		int32_t other = key[i];

		key[i] = key[i + 1];
		key[i + 1] = other;
		ck_assert_uint_ne(hash_of(key, rows, ROWS), whole);
		key[i + 1] = key[i];
		key[i] = other;
	}
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("hash");
	TCase *tcase = tcase_create("hash");
	SRunner *runner = srunner_create(suite);
	int failed;

	tcase_add_test(tcase, order_makes_no_difference);
	tcase_add_test(tcase, each_byte_counts);
	suite_add_tcase(suite, tcase);
	srunner_run_all(runner, CK_NORMAL);
	failed = srunner_ntests_failed(runner);
	srunner_free(runner);
	return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
