/* Movies: what is written to ffmpeg, and each way in which it can fail. A script stands for ffmpeg: it is the first on the
 * PATH. */
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "asserts.h"
#include "core/life.h"
#include "base/alloc.h"
#include "io/movie.h"
#include "library/tsim_tables.h"

enum { WIDTH = 33, HEIGHT = 16, LARGE = 700 };

static char folder[] = "/tmp/check_movie_XXXXXX";
static struct tsim *sim;
static long balance;
static unsigned char picture[3 * LARGE * LARGE];

static void set_up(void)
{
	ck_assert_ptr_nonnull(mkdtemp(folder));
	ck_assert_int_eq(chdir(folder), 0);
	signal(SIGPIPE, SIG_DFL); /* as in a program that uses the library */
	balance = ts_alloc_balance();
	sim = ts_sim_new(&ts_tables);
	ck_assert_ptr_nonnull(sim);
	for (size_t k = 0; k < sizeof picture; k++)
		picture[k] = (unsigned char)(k * k >> 3);
}

static void tear_down(void)
{
	char command[64];

	ts_sim_free(sim);
	ck_assert_int_eq(ts_alloc_balance(), balance);
	snprintf(command, sizeof command, "rm -rf %s", folder);
	ck_assert_int_eq(system(command), 0);
}

/* What the script does; its last argument, file:PATH, is $file. */
static void ffmpeg_does(const char *what)
{
	char path[4096];
	FILE *file = fopen("ffmpeg", "w");

	ck_assert_ptr_nonnull(file);
	fprintf(file, "#!/bin/sh\necho \"$@\" >words\nfor file; do :; done\nfile=${file#file:}\n%s\n", what);
	ck_assert_int_eq(fclose(file), 0);
	ck_assert_int_eq(chmod("ffmpeg", 0755), 0);
	snprintf(path, sizeof path, "%s:/usr/bin:/bin", folder);
	ck_assert_int_eq(setenv("PATH", path, 1), 0);
}

static long size_of(const char *path)
{
	struct stat info;

	return stat(path, &info) == 0 ? (long)info.st_size : -1;
}

static bool is_empty(const char *path)
{
	return rmdir(path) == 0 || access(path, F_OK) != 0;
}

static enum ts_status add(struct ts_movie *m, int n)
{
	return ts_movie_add(m, sim, NULL, "post/film.mp4", (uint32_t)n, (uint32_t)n, picture);
}

/* All pixels of all frames arrive; the file appears at the end, in the folder where it began. */
START_TEST(frames_arrive)
{
	struct ts_movie m = { .rate = 12.5, .bitrate = 300 };
	char words[512] = "", expected[128];
	FILE *file;

	ffmpeg_does("cat >\"$file\"");
	for (int k = 0; k < 3; k++)
		ck_assert_int_eq(ts_movie_add(&m, sim, NULL, "post/film.mp4", WIDTH, HEIGHT, picture), TS_OK);
	ck_assert_int_eq(size_of("post/film.mp4"), -1);
	ck_assert_int_eq(chdir("/"), 0);
	ck_assert_int_eq(ts_movie_end(&m), TS_OK);
	ck_assert_int_eq(ts_movie_end(&m), TS_OK);
	ck_assert_int_eq(chdir(folder), 0);
	ck_assert_int_eq(size_of("post/film.mp4"), 3 * 3 * WIDTH * HEIGHT);
	ck_assert_ptr_nonnull(file = fopen("words", "r"));
	ck_assert_ptr_nonnull(fgets(words, sizeof words, file));
	fclose(file);
	snprintf(expected, sizeof expected, "-video_size %dx%d -framerate 12.5 -i pipe:0", WIDTH, HEIGHT);
	ck_assert_msg(strstr(words, expected) && strstr(words, "pad=34:16,fillborders=right=1:bottom=0") &&
			      strstr(words, "-b:v 300k -f mp4 -y file:/"),
		      "%s", words);
}
END_TEST

static const struct {
	const char *does, *says;
} failures[] = {
	{ "echo no codec >&2; exit 1", "exit status 1: no codec" },
	{ "head -c 5000 >/dev/null; echo No space left on device >&2; exit 228",
	  "exit status 228: No space left on device" },
	{ "cat >\"$file\"; exit 3", "exit status 3, without a message" },
	{ "cat >\"$file\"; kill -9 $$", "exit status 137, without a message" },
	{ "cat >\"$file\"; echo Error writing trailer of file: No space left on device >&2",
	  "exit status 0: Error writing trailer of file: No space" },
	/* more than fits into the pipe, before it reads */
	{ "head -c 1000000 /dev/zero | tr '\\0' x >&2; printf ' the\\tend' >&2; cat >\"$file\"; exit 1",
	  "x the end" },
};

/* Each failure is an error with the words of ffmpeg, while frames are written or at the end; no file is left. */
START_TEST(ffmpeg_fails)
{
	struct ts_movie m = { .rate = 25 };
	enum ts_status status = TS_OK;

	ffmpeg_does(failures[_i].does);
	for (int k = 0; k < 3 && status == TS_OK; k++)
		status = add(&m, LARGE);
	if (status == TS_OK)
		status = ts_movie_end(&m);
	ck_assert_int_eq(status, TS_IO);
	ck_assert_msg(strstr(sim->error.message, failures[_i].says) &&
			      strstr(sim->error.message, "post/film.mp4': ffmpeg failed after "),
		      "%s", sim->error.message);
	ts_movie_abandon(&m);
	ck_assert(is_empty("post"));
}
END_TEST

/* Words are no failure: a warning. */
START_TEST(ffmpeg_speaks)
{
	struct ts_movie m = { .rate = 60.5 };

	ffmpeg_does("cat >\"$file\"; echo mind the gap >&2");
	ck_assert_int_eq(ts_movie_add(&m, sim, NULL, "film.mpg", 2, 2, picture), TS_OK);
	ck_assert_int_eq(ts_movie_end(&m), TS_OK);
	ck_assert_int_eq(size_of("film.mpg"), 12);
	ck_assert_int_eq(system("grep -q -- '-framerate 60.5 .* -r 60 .*-vf null .*-f mpeg' words"), 0);
}
END_TEST

START_TEST(no_ffmpeg)
{
	struct ts_movie m = { .rate = 25 };

	setenv("PATH", folder, 1);
	ck_assert(strstr(ts_movie_obstacle(sim), "not on the PATH"));
	ck_assert_int_eq(add(&m, WIDTH), TS_STATE);
	ck_assert_ptr_nonnull(strstr(sim->error.message, "post/film.mp4': movies are made by the program"));
	setenv("PATH", "/usr/bin:/bin", 1);
	ck_assert(is_empty("post"));
}
END_TEST

/* It is there, but cannot be executed: the reason is that of the system. */
START_TEST(no_program)
{
	struct ts_movie m = { .rate = 25 };
	FILE *file;

	ffmpeg_does("");
	ck_assert_ptr_nonnull(file = fopen("ffmpeg", "w"));
	fputs("#!/no/such/shell\n", file);
	fclose(file);
	setenv("PATH", folder, 1);
	ck_assert_int_eq(add(&m, WIDTH), TS_IO);
	setenv("PATH", "/usr/bin:/bin", 1);
	ck_assert_ptr_nonnull(strstr(sim->error.message, "cannot start ffmpeg: No such file"));
	ck_assert(is_empty("post"));
}
END_TEST

/* Refused before anything is started or written. */
START_TEST(refusals)
{
	struct ts_movie m = { .rate = 25 };

	ffmpeg_does("cat >\"$file\"");
	ck_assert(ts_movie_is_name("a/b.mp4") && ts_movie_is_name("x.gif") && !ts_movie_is_name("mp4") &&
		  !ts_movie_is_name("film.mp4.txt"));
	ck_assert_int_eq(ts_movie_add(&m, sim, NULL, "film.ogg", 2, 2, picture), TS_SYNTAX);
	ck_assert_ptr_nonnull(strstr(sim->error.message, ".mp4, .m4v"));
	ts_error_clear(&sim->error);
	ck_assert_int_eq(add(&m, WIDTH), TS_OK);
	ck_assert_int_eq(add(&m, WIDTH + 1), TS_STATE);
	ck_assert_ptr_nonnull(strstr(sim->error.message, "34 x 34 pixels, those before it 33 x 33"));
	ts_error_clear(&sim->error);
	ck_assert_int_eq(ts_movie_end(&m), TS_OK); /* that of the frames before */
	ck_assert_int_eq(size_of("post/film.mp4"), 3 * WIDTH * WIDTH);
	ts_files_close(&sim->files, 1000000);
	ck_assert_int_eq(add(&m, WIDTH), TS_STATE);
	ck_assert_ptr_nonnull(strstr(sim->error.message, "-sandbox allows no other programs"));
}
END_TEST

/* A movie that is given up leaves no file and no process; nor does -explain begin one. */
START_TEST(abandoned)
{
	struct ts_movie m = { .rate = 25 };

	ffmpeg_does("cat >\"$file\"; sleep 1000");
	ck_assert_int_eq(add(&m, WIDTH), TS_OK);
	ts_movie_abandon(&m);
	ts_movie_abandon(&m);
	ck_assert(is_empty("post"));
	sim->reading.explain = true;
	ck_assert_int_eq(add(&m, WIDTH), TS_OK);
	ck_assert_int_eq(ts_movie_end(&m), TS_OK);
	ck_assert(is_empty("post"));
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("movie");
	TCase *tcase = tcase_create("movie");
	SRunner *runner;
	int failed;

	tcase_add_checked_fixture(tcase, set_up, tear_down);
	tcase_add_test(tcase, frames_arrive);
	tcase_add_loop_test(tcase, ffmpeg_fails, 0, sizeof failures / sizeof *failures);
	tcase_add_test(tcase, ffmpeg_speaks);
	tcase_add_test(tcase, no_ffmpeg);
	tcase_add_test(tcase, no_program);
	tcase_add_test(tcase, refusals);
	tcase_add_test(tcase, abandoned);
	suite_add_tcase(suite, tcase);
	runner = srunner_create(suite);
	srunner_run_all(runner, CK_NORMAL);
	failed = srunner_ntests_failed(runner);
	srunner_free(runner);
	return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
