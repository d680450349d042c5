/* HDF5 files that change as a whole: until a change is made the file has its old contents, for whoever opens it. */
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>

#include "asserts.h"
#include "io/h5file.h"

#ifdef TS_WITH_HDF5
static char folder[] = "/tmp/check_h5file.XXXXXX", path[64];

/* Opens the file to change it, or begins it. */
static void begin(struct ts_h5file *f, bool create)
{
	FILE *file = fopen(path, create ? "w+" : "r+");

	ck_assert_ptr_nonnull(file);
	*f = (struct ts_h5file){ 0 };
	ck_assert_int_ge(ts_h5file_open(f, file, path, create), 0);
}

/* Adds n numbers, each of the value, to a data set of the file. */
static void add_numbers(struct ts_h5file *f, hsize_t n, double value)
{
	hsize_t now = 0, most = H5S_UNLIMITED, chunk = 100;
	bool there = H5Lexists(f->id, "x", H5P_DEFAULT) > 0;
	hid_t properties = H5Pcreate(H5P_DATASET_CREATE), space = H5Screate_simple(1, &now, &most), memory,
	      set;
	double *data = calloc(n, sizeof *data);

	ck_assert_ptr_nonnull(data);
	for (hsize_t k = 0; k < n; k++)
		data[k] = value;
	H5Pset_chunk(properties, 1, &chunk);
	set = there ? H5Dopen2(f->id, "x", H5P_DEFAULT)
		    : H5Dcreate2(f->id, "x", H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, properties, H5P_DEFAULT);
	H5Sclose(space);
	space = H5Dget_space(set);
	H5Sget_simple_extent_dims(space, &now, NULL);
	H5Sclose(space);
	most = now + n;
	ck_assert_int_ge(H5Dset_extent(set, &most), 0);
	space = H5Dget_space(set);
	memory = H5Screate_simple(1, &n, NULL);
	ck_assert_int_ge(H5Sselect_hyperslab(space, H5S_SELECT_SET, &now, NULL, &n, NULL), 0);
	ck_assert_int_ge(H5Dwrite(set, H5T_NATIVE_DOUBLE, memory, space, H5P_DEFAULT, data), 0);
	H5Sclose(memory);
	H5Sclose(space);
	H5Dclose(set);
	H5Pclose(properties);
	free(data);
}

/* What another process sees: the number of values, and their sum. */
static void holds(hsize_t n, double sum)
{
	hid_t file = H5Fopen(path, H5F_ACC_RDONLY, H5P_DEFAULT), set, space;
	static double x[100000];
	hsize_t got = 0;
	double total = 0;

	ck_assert_int_ge(file, 0);
	set = H5Dopen2(file, "x", H5P_DEFAULT);
	space = H5Dget_space(set);
	H5Sget_simple_extent_dims(space, &got, NULL);
	ck_assert_uint_eq(got, n);
	ck_assert_int_ge(H5Dread(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, x), 0);
	for (hsize_t k = 0; k < n; k++)
		total += x[k];
	ck_assert(total == sum);
	H5Sclose(space);
	H5Dclose(set);
	H5Fclose(file);
}

static long size_of_file(void)
{
	FILE *file = fopen(path, "r");
	long size;

	ck_assert(file && fseek(file, 0, SEEK_END) == 0);
	size = ftell(file);
	fclose(file);
	return size;
}

START_TEST(changes_as_a_whole)
{
	struct ts_h5file f;
	long size;

	begin(&f, true);
	add_numbers(&f, 250, 1);
	ck_assert(ts_h5file_close(&f, true));
	holds(250, 250);
	for (int k = 1; k < 20; k++) {
		begin(&f, false);
		add_numbers(&f, 1000, 2);
		H5Fflush(f.id, H5F_SCOPE_LOCAL); /* all is written, behind the contents or held */
		ck_assert_uint_gt(f.nchanges, 0);
		holds((hsize_t)(250 + 1000 * (k - 1)), 250 + 2000 * (k - 1));
		ck_assert(ts_h5file_close(&f, true));
		holds((hsize_t)(250 + 1000 * k), 250 + 2000 * k);
	}
	size = size_of_file();
	begin(&f, false);
	add_numbers(&f, 5000, 3);
	ck_assert(!ts_h5file_close(&f, false)); /* given up */
	ck_assert_int_eq(f.error, 0);
	ck_assert_int_eq(size_of_file(), size);
	holds(19250, 38250);
}
END_TEST

/* A process that was killed has left bytes behind the contents. */
START_TEST(bytes_behind)
{
	struct ts_h5file f;
	FILE *file;

	begin(&f, true);
	add_numbers(&f, 10, 1);
	ck_assert(ts_h5file_close(&f, true));
	file = fopen(path, "a");
	ck_assert_ptr_nonnull(file);
	for (int k = 0; k < 100000; k++)
		fputc('x', file);
	fclose(file);
	holds(10, 10);
	begin(&f, false);
	add_numbers(&f, 500, 1);
	ck_assert(ts_h5file_close(&f, true));
	holds(510, 510);
	ck_assert_int_lt(size_of_file(), 50000);
}
END_TEST

/* Objects that are still open do not keep the file open. */
START_TEST(left_open)
{
	struct ts_h5file f;

	begin(&f, true);
	add_numbers(&f, 10, 1);
	ck_assert_int_ge(H5Dopen2(f.id, "x", H5P_DEFAULT), 0);
	ck_assert(ts_h5file_close(&f, true));
	holds(10, 10);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("h5file");
	TCase *tests = tcase_create("h5file");
	SRunner *runner;
	char command[80];
	int failed;

	if (!mkdtemp(folder))
		return EXIT_FAILURE;
	snprintf(path, sizeof path, "%s/a.h5", folder);
	tcase_add_test(tests, changes_as_a_whole);
	tcase_add_test(tests, bytes_behind);
	tcase_add_test(tests, left_open);
	suite_add_tcase(suite, tests);
	runner = srunner_create(suite);
	srunner_run_all(runner, CK_NORMAL);
	failed = srunner_ntests_failed(runner);
	srunner_free(runner);
	snprintf(command, sizeof command, "rm -rf '%s'", folder);
	return system(command) || failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
#else
int main(void)
{
	puts("skipped: needs HDF5 (apt-get install libhdf5-dev; configure)");
	return 77;
}
#endif
