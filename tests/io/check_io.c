/* Saved state, files written, formats. */
#include <fcntl.h>
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "asserts.h"
#include "core/unclaimed_state.h"
#include "core/life.h"
#include "box/domain.h"
#include "particle/particles.h"
#include "io/format.h"
#include "io/replace.h"
#include "io/series.h"
#include "library/tsim_tables.h"
#include "restart/restart.h"
#include "io/textfile.h"
#include "io/vtk.h"
#include "io/vtk_xml.h"

static struct tsim *sim;
static long balance;

static void set_up(void)
{
	balance = ts_alloc_balance();
	sim = ts_sim_new(&ts_tables);
	ck_assert_ptr_nonnull(sim);
}

static void tear_down(void)
{
	ts_sim_free(sim);
	ck_assert_int_eq(ts_alloc_balance(), balance);
}

/* What the tests archive. */
struct sample {
	double real[3];
	int64_t whole;
	double *list;
	size_t n, capacity;
	const char *text;
};

static enum ts_status archive_sample(struct ts_archive *a, struct sample *s)
{
	TS_TRY(ts_archive_fixed(a, "real", TS_SAVED_F64, s->real, 3));
	TS_TRY(ts_archive_fixed(a, "whole", TS_SAVED_I64, &s->whole, 1));
	TS_TRY(ts_archive_array(a, "list", TS_SAVED_F64, (void **)&s->list, &s->capacity, &s->n));
	return ts_archive_string(a, "text", &s->text);
}

static struct ts_archive *written(const unsigned char **bytes, size_t *n)
{
	double list[] = { 2.385, -0.0, 1e-310, 7 };
	struct sample s = { { 1.5, -2.25, 1e300 }, -77, list, 4, 4, "two words" };
	struct ts_archive *a = ts_archive_new(sim, true);

	ck_assert_ptr_nonnull(a);
	ck_assert(ts_archive_writing(a));
	ck_assert_int_eq(archive_sample(a, &s), TS_OK);
	ck_assert_int_eq(ts_archive_bytes(a, bytes, n), TS_OK);
	return a;
}

/* Reads the block; true if all went well and all is equal. */
static bool reads_back(const unsigned char *bytes, size_t n)
{
	struct ts_archive *a = ts_archive_new(sim, false);
	struct sample s = { 0 };
	bool ok;

	ts_error_clear(&sim->error);
	ok = ts_archive_from(a, bytes, n) == TS_OK && archive_sample(a, &s) == TS_OK;
	if (ok) {
		ck_assert_int_eq(s.whole, -77);
		ck_assert(s.real[1] == -2.25 && s.real[2] == 1e300);
		ck_assert_uint_eq(s.n, 4);
		ck_assert(s.list[0] == 2.385 && signbit(s.list[1]) && s.list[2] == 1e-310);
		ck_assert_str_eq(s.text, "two words");
	} else {
		ck_assert_int_eq(sim->error.status, TS_DAMAGED);
		ck_assert(sim->error.message[0]);
	}
	ts_free(s.list);
	ts_archive_free(a);
	return ok;
}

START_TEST(archive_round_trip)
{
	const unsigned char *bytes;
	size_t n;
	struct ts_archive *a = written(&bytes, &n);

	ck_assert(reads_back(bytes, n));
	ts_archive_free(a);
}
END_TEST

START_TEST(archive_damaged)
{
	const unsigned char *bytes;
	size_t n;
	struct ts_archive *a = written(&bytes, &n);
	unsigned char *copy;

	for (size_t k = 0; k < n; k++) {
		copy = ts_alloc(k, 1); /* exactly as long: reading beyond it is caught */
		memcpy(copy, bytes, k);
		ck_assert_msg(!reads_back(copy, k), "cut to %zu bytes", k);
		ts_free(copy);
	}
	copy = ts_alloc(n, 1);
	for (size_t k = 0; k < n; k++)
		for (int bit = 0; bit < 8; bit++) {
			memcpy(copy, bytes, n);
			copy[k] = (unsigned char)(copy[k] ^ 1u << bit);
			ck_assert_msg(!reads_back(copy, n), "byte %zu, bit %d", k, bit);
		}
	ts_free(copy);
	ts_archive_free(a);
}
END_TEST

START_TEST(archive_mismatch)
{
	const unsigned char *bytes;
	size_t n;
	struct ts_archive *w = written(&bytes, &n), *a = ts_archive_new(sim, false);
	double numbers[4];

	ck_assert_int_eq(ts_archive_from(a, bytes, n), TS_OK);
	ck_assert(ts_archive_has(a, "whole"));
	ck_assert(!ts_archive_has(a, "nothing"));
	ck_assert_int_eq(ts_archive_fixed(a, "nothing", TS_SAVED_F64, numbers, 1), TS_DAMAGED);
	ck_assert_int_eq(ts_archive_fixed(a, "whole", TS_SAVED_F64, numbers, 1), TS_DAMAGED);
	ck_assert_int_eq(ts_archive_fixed(a, "real", TS_SAVED_F64, numbers, 4), TS_DAMAGED);
	ck_assert_int_eq(ts_archive_fixed(a, "real", TS_SAVED_F64, numbers, 3), TS_OK);
	ts_archive_free(a);
	ts_archive_free(w);
}
END_TEST

/* ---- files */

static char folder[] = "/tmp/tsim-check-XXXXXX";

static void path_in(char *out, size_t size, const char *name)
{
	snprintf(out, size, "%s/%s", folder, name);
}

static struct ts_str slurp(const char *path)
{
	struct ts_str text = { 0 };
	FILE *file = fopen(path, "rb");
	char part[256];
	size_t n;

	ck_assert_ptr_nonnull(file);
	while ((n = fread(part, 1, sizeof part, file)))
		ts_str_add_n(&text, part, n);
	fclose(file);
	return text;
}

static void spit(const char *path, const char *bytes, size_t n)
{
	FILE *file = fopen(path, "wb");

	ck_assert_ptr_nonnull(file);
	ck_assert_uint_eq(fwrite(bytes, 1, n, file), n);
	fclose(file);
}

START_TEST(text_file)
{
	struct ts_textfile file = { 0 };
	struct ts_str text;
	char path[128];

	path_in(path, sizeof path, "plain");
	ck_assert_int_eq(ts_textfile_open(&file, sim, NULL, path, false), TS_OK);
	ck_assert_int_eq(ts_textfile_printf(&file, "%d %s\n", 12, "a"), TS_OK);
	ck_assert_int_eq(ts_textfile_close(&file), TS_OK);
	ck_assert_int_eq(ts_textfile_open(&file, sim, NULL, path, true), TS_OK);
	ck_assert_int_eq(ts_textfile_write(&file, "xyz", 3), TS_OK);
	ck_assert_int_eq(ts_textfile_close(&file), TS_OK);
	text = slurp(path);
	ck_assert_str_eq(text.text, "12 a\nxyz");
	ts_str_release(&text);
	path_in(path, sizeof path, "packed.gz");
	ck_assert_int_eq(ts_textfile_open(&file, sim, NULL, path, false), TS_OK);
	ck_assert_int_eq(ts_textfile_write(&file, "abc", 3), TS_OK);
	ck_assert_int_eq(ts_textfile_close(&file), TS_OK);
	text = slurp(path);
	ck_assert(text.length > 2 && (unsigned char)text.text[0] == 0x1f);
	ts_str_release(&text);
}
END_TEST

START_TEST(text_file_disk_full)
{
	struct ts_textfile file = { 0 };
	enum ts_status status;

	if (access("/dev/full", W_OK) != 0)
		return;
	ck_assert_int_eq(ts_textfile_open(&file, sim, NULL, "/dev/full", false), TS_OK);
	status = ts_textfile_printf(&file, "some text\n");
	if (status == TS_OK)
		status = ts_textfile_flush(&file);
	ck_assert_int_eq(status, TS_IO);
	ck_assert_ptr_nonnull(strstr(sim->error.message, "/dev/full"));
	ck_assert_ptr_nonnull(strstr(sim->error.message, "No space left"));
	ts_textfile_close(&file);
}
END_TEST

START_TEST(text_file_no_folder)
{
	struct ts_textfile file = { 0 };

	ck_assert_int_eq(ts_textfile_open(&file, sim, NULL, "/dev/null/such/file", false), TS_IO);
	ck_assert_ptr_nonnull(strstr(sim->error.message, "'/dev/null' is no folder"));
}
END_TEST

START_TEST(replace_keeps_old)
{
	struct ts_replace r = { 0 };
	struct ts_str text;
	char path[128];

	path_in(path, sizeof path, "kept");
	spit(path, "old", 3);
	ck_assert_int_eq(ts_replace_begin(&r, sim, NULL, path), TS_OK);
	ck_assert_int_eq(ts_replace_write(&r, "half", 4), TS_OK);
	ts_replace_abandon(&r);
	text = slurp(path);
	ck_assert_str_eq(text.text, "old");
	ts_str_release(&text);
	ck_assert_int_eq(ts_replace_begin(&r, sim, NULL, path), TS_OK);
	ck_assert_int_eq(ts_replace_write(&r, "new text", 8), TS_OK);
	ck_assert_int_eq(ts_replace_commit(&r, true), TS_OK);
	text = slurp(path);
	ck_assert_str_eq(text.text, "new text");
	ts_str_release(&text);
}
END_TEST

/* What a killed process has left goes when the same file is written again, not what a living one writes. */
START_TEST(stale_parts_go)
{
	struct ts_replace r = { 0 };
	char path[128], dead[160], fresh[160], alive[160], other[160];
	const struct timespec old[2] = { { 1000000000, 0 }, { 1000000000, 0 } };

	path_in(path, sizeof path, "again");
	snprintf(dead, sizeof dead, "%s.tmp.2147483647", path); /* beyond the largest process */
	snprintf(fresh, sizeof fresh, "%s.tmp.2147483646", path);
	snprintf(alive, sizeof alive, "%s.tmp.1", path);
	snprintf(other, sizeof other, "%s.tmp.2147483647x", path);
	spit(dead, "half", 4);
	spit(fresh, "half", 4); /* may be of another machine */
	spit(alive, "half", 4);
	spit(other, "half", 4);
	ck_assert_int_eq(utimensat(AT_FDCWD, dead, old, 0), 0);
	ck_assert_int_eq(utimensat(AT_FDCWD, alive, old, 0), 0);
	ck_assert_int_eq(utimensat(AT_FDCWD, other, old, 0), 0);
	ck_assert_int_eq(ts_replace_begin(&r, sim, NULL, path), TS_OK);
	ck_assert_int_eq(ts_replace_write(&r, "whole", 5), TS_OK);
	ck_assert_int_eq(ts_replace_commit(&r, true), TS_OK);
	ck_assert_int_ne(access(dead, F_OK), 0);
	ck_assert_int_eq(access(fresh, F_OK), 0);
	ck_assert_int_eq(access(alive, F_OK), 0);
	ck_assert_int_eq(access(other, F_OK), 0);
}
END_TEST

START_TEST(step_paths)
{
	struct ts_str path = { 0 };

	ts_series_path(&path, "post/a*.vtp", 42, 6);
	ck_assert_str_eq(path.text, "post/a000042.vtp");
	ts_series_path(&path, "plain", 42, 0);
	ck_assert_str_eq(path.text, "plain");
	ts_str_release(&path);
}
END_TEST

static enum ts_status read_fresh(const char *path)
{
	ts_error_clear(&sim->error);
	ck_assert_int_eq(ts_sim_clear(sim), TS_OK);
	return ts_restart_read(sim, path, NULL);
}

START_TEST(restart_damaged)
{
	char path[128], bad[128];
	const double lo[3] = { 0 }, hi[3] = { 1, 2.385, 3 };
	struct ts_str whole;

	ck_assert_int_eq(ts_particles_make_box(sim, 1, lo, hi, NULL), TS_OK);
	path_in(path, sizeof path, "state");
	path_in(bad, sizeof bad, "bad");
	sim->clock.step = 4711;
	sim->clock.base_time = 2.385;
	ck_assert_int_eq(ts_restart_write(sim, path, NULL), TS_OK);
	ck_assert_int_eq(read_fresh(path), TS_OK);
	ck_assert_int_eq(sim->clock.step, 4711);
	ck_assert(sim->clock.base_time == 2.385);
	whole = slurp(path);
	for (size_t k = 0; k < whole.length; k++) {
		whole.text[k] = (char)(whole.text[k] ^ (1 << k % 8));
		spit(bad, whole.text, whole.length);
		whole.text[k] = (char)(whole.text[k] ^ (1 << k % 8));
		ck_assert_msg(read_fresh(bad) == TS_DAMAGED, "byte %zu", k);
		spit(bad, whole.text, k);
		ck_assert_msg(read_fresh(bad) == TS_DAMAGED, "length %zu", k);
	}
	spit(bad, whole.text, whole.length);
	ck_assert_int_eq(read_fresh(bad), TS_OK);
	ts_str_release(&whole);
}
END_TEST

START_TEST(restart_cannot_be_written)
{
	ck_assert_int_eq(ts_restart_write(sim, "/dev/null/such/file", NULL), TS_IO);
	ts_error_clear(&sim->error);
	ck_assert_int_eq(ts_restart_read(sim, "none/such/file", NULL), TS_IO);
}
END_TEST

/* ---- text */

START_TEST(base64)
{
	/* RFC 4648, section 10 */
	static const char *const plain[] = { "", "f", "fo", "foo", "foob", "fooba", "foobar" };
	static const char *const coded[] = { "", "Zg==", "Zm8=", "Zm9v", "Zm9vYg==", "Zm9vYmE=", "Zm9vYmFy" };
	struct ts_str out = { 0 };

	for (size_t k = 0; k < sizeof plain / sizeof *plain; k++) {
		ts_str_clear(&out);
		ts_vtk_add_base64(&out, (const unsigned char *)plain[k], strlen(plain[k]));
		ck_assert_str_eq(ts_str_text(&out), coded[k]);
	}
	ts_str_release(&out);
}
END_TEST

START_TEST(formats)
{
	char out[TS_FORMAT_SIZE];
	struct ts_str text = { 0 };

	ck_assert(ts_format_check("%14.8g", false, out));
	ck_assert(ts_format_check("%-20.15e", false, out));
	ck_assert(!ts_format_check("%s", false, out));
	ck_assert(!ts_format_check("%d", false, out));
	ck_assert(!ts_format_check("%g %g", false, out));
	ck_assert(!ts_format_check("%*g", false, out));
	ck_assert(!ts_format_check("%", false, out));
	ck_assert(!ts_format_check("no conversion", false, out));
	ck_assert(!ts_format_check("%10000g", false, out));
	ck_assert(!ts_format_check("%n", true, out));
	ck_assert(!ts_format_check("%g", true, out));
	ck_assert(ts_format_check("[%6ld]", true, out));
	ts_format_add(&text, out, true, 42);
	ck_assert_str_eq(text.text, "[    42]");
	ts_str_release(&text);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("io");
	TCase *tests = tcase_create("io");
	SRunner *runner = srunner_create(suite);
	char command[128];
	int failed;

	if (!mkdtemp(folder))
		return EXIT_FAILURE;
	suite_add_tcase(suite, tests);
	tcase_set_timeout(tests, 60);
	tcase_add_checked_fixture(tests, set_up, tear_down);
	tcase_add_test(tests, archive_round_trip);
	tcase_add_test(tests, archive_damaged);
	tcase_add_test(tests, archive_mismatch);
	tcase_add_test(tests, text_file);
	tcase_add_test(tests, text_file_disk_full);
	tcase_add_test(tests, text_file_no_folder);
	tcase_add_test(tests, replace_keeps_old);
	tcase_add_test(tests, stale_parts_go);
	tcase_add_test(tests, step_paths);
	tcase_add_test(tests, restart_damaged);
	tcase_add_test(tests, restart_cannot_be_written);
	tcase_add_test(tests, base64);
	tcase_add_test(tests, formats);
	srunner_run_all(runner, CK_NORMAL);
	failed = srunner_ntests_failed(runner);
	srunner_free(runner);
	snprintf(command, sizeof command, "rm -rf '%s'", folder);
	return system(command) || failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
