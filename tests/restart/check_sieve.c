/* Sections of restart files that no run writes: refused before their bytes are taken for numbers. */
#include <stdlib.h>
#include <string.h>

#include "asserts.h"
#include "restart/sieve.h"

static enum ts_status begin(const struct ts_archive_taker *t, const char *name, uint32_t type, uint64_t count)
{
	struct ts_archive_head head = { (uint32_t)strlen(name) + 1, type, count };

	return t->begin(t->data, name, &head);
}

START_TEST(places_out_of_order)
{
	struct ts_sieve sieve = { 0 };
	const struct ts_archive_taker t = ts_sieve_places(&sieve);
	const int64_t n = 2;

	ck_assert_int_eq(begin(&t, "tag", TS_SAVED_I32, 2), TS_DAMAGED);
	ck_assert_int_eq(begin(&t, "n", TS_SAVED_U8, 1), TS_DAMAGED);
	ck_assert_int_eq(begin(&t, "n", TS_SAVED_I64, 2), TS_DAMAGED);
	ck_assert_int_eq(begin(&t, "n", TS_SAVED_I64, 1), TS_OK);
	ck_assert_int_eq(t.bytes(t.data, (const unsigned char *)&n, sizeof n), TS_OK);
	ck_assert_uint_eq(sieve.n, 2);
	ck_assert_int_eq(begin(&t, "n", TS_SAVED_I64, 1), TS_DAMAGED);
	ck_assert_int_eq(begin(&t, "x", TS_SAVED_F64, 6), TS_DAMAGED);
	ck_assert_int_eq(begin(&t, "tag", TS_SAVED_I64, 2), TS_DAMAGED);
	ck_assert_int_eq(begin(&t, "tag", TS_SAVED_I32, 3), TS_DAMAGED);
	ck_assert_int_eq(begin(&t, "tag", TS_SAVED_I32, 2), TS_OK);
	ck_assert_int_eq(begin(&t, "xhold", TS_SAVED_F64, 6), TS_DAMAGED);
	ck_assert_int_eq(begin(&t, "x", TS_SAVED_U8, 6), TS_DAMAGED);
	ck_assert_int_eq(begin(&t, "radius", TS_SAVED_U8, 1), TS_OK); /* is skipped */
	ck_assert(!ts_sieve_has_places(&sieve));
	ts_sieve_release(&sieve);
}
END_TEST

/* Keys of another type are copied, as fields that are not known are, and refused by who restores them. */
START_TEST(keys_of_another_type)
{
	struct ts_sieve sieve = { 0 };
	const struct ts_archive_taker t = ts_sieve_contacts(&sieve);
	const int64_t size[2] = { 2, 3 };
	const unsigned char few[6] = { 0 };

	ck_assert_int_eq(begin(&t, "history_size", TS_SAVED_I32, 2), TS_DAMAGED);
	ts_sieve_release(&sieve);
	ck_assert_int_eq(begin(&t, "history_size", TS_SAVED_I64, 2), TS_OK);
	ck_assert_int_eq(t.bytes(t.data, (const unsigned char *)size, sizeof size), TS_OK);
	ck_assert_int_eq(t.end(t.data), TS_OK);
	ck_assert_int_eq(begin(&t, "history_keys", TS_SAVED_U8, 6), TS_OK);
	ck_assert_int_eq(t.bytes(t.data, few, sizeof few), TS_OK);
	ck_assert_int_eq(t.end(t.data), TS_OK);
	ck_assert_uint_eq(sieve.contacts_kept, 0);
	ck_assert_uint_eq(sieve.per_row, 0);
	ts_sieve_release(&sieve);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("sieve");
	TCase *tests = tcase_create("sieve");
	SRunner *runner = srunner_create(suite);
	int failed;

	tcase_add_test(tests, places_out_of_order);
	tcase_add_test(tests, keys_of_another_type);
	suite_add_tcase(suite, tests);
	srunner_run_all(runner, CK_NORMAL);
	failed = srunner_ntests_failed(runner);
	srunner_free(runner);
	return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
