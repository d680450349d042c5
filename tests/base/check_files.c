/* The door to files, and what the kernel holds back behind it. */
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include "asserts.h"
#include "base/sandbox.h"

static char root[] = "/tmp/check_files_XXXXXX";
static char start[4096];

static void put(const char *path)
{
	FILE *file = fopen(path, "w");

	ck_assert_ptr_nonnull(file);
	fputs("17\n", file);
	fclose(file);
}

static void enter(void)
{
	ck_assert_ptr_nonnull(getcwd(start, sizeof start));
	memcpy(root + strlen(root) - 6, "XXXXXX", 6);
	ck_assert_ptr_nonnull(mkdtemp(root));
	ck_assert_int_eq(chdir(root), 0);
	mkdir("in", 0777);
	mkdir("run", 0777);
	mkdir("run/sub", 0777);
	mkdir("other", 0777);
	put("in/a");
	put("run/old");
	put("other/secret");
}

static void leave(void)
{
	char command[64];

	ck_assert_int_eq(chdir(start), 0);
	snprintf(command, sizeof command, "rm -rf %s", root);
	ck_assert_int_eq(system(command), 0);
}

static void close_door(struct ts_files *files)
{
	ck_assert_int_eq(ts_files_admit(files, "in", false), 0);
	ck_assert_int_eq(ts_files_admit(files, "run", true), 0);
	ck_assert_int_eq(ts_files_admit(files, "nowhere", true), -1);
	ts_files_close(files, 100000);
}

static bool opens(struct ts_files *files, const char *path, const char *mode)
{
	FILE *file = ts_files_open(files, path, mode);

	if (file)
		fclose(file);
	return file;
}

START_TEST(names)
{
	static const struct {
		const char *path, *of, *name;
	} cases[] = {
		{ "run", "run", "run" },
		{ "run/", "run", "run" },
		{ "run/../in", "in", "in" },
		{ "run/sub/../../in/./a", "in/a", "in/a" },
		{ "run/new", "run/new", "run/new" },
		{ "run/new/newer", "run/new/newer", "run/new/newer" },
		{ "run/new/", "run/new", "run/new" },
		{ "run/new/.", "run/new", NULL },
		{ "run/new/../x", NULL, NULL },
		{ "link", "in", "link" },
		{ "link/a", "in/a", "in/a" },
		{ "dangling", NULL, "dangling" },
		{ "in/a/x", NULL, NULL },
	};

	ck_assert_int_eq(symlink("in", "link"), 0);
	ck_assert_int_eq(symlink("nothing", "dangling"), 0);
	for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
		struct ts_str found = { 0 };
		bool got = ts_files_resolve(cases[k].path, &found) == 0;

		ck_assert_msg(got == !!cases[k].of, "%s", cases[k].path);
		if (got)
			ck_assert_str_eq(ts_str_text(&found) + strlen(root) + 1, cases[k].of);
		if (cases[k].name) {
			ck_assert_int_eq(ts_files_resolve_name(cases[k].path, &found), 0);
			ck_assert_str_eq(ts_str_text(&found) + strlen(root) + 1, cases[k].name);
		}
		ts_str_release(&found);
	}
	ck_assert(ts_files_below("/a/b", "/a") && ts_files_below("/a", "/a") && ts_files_below("/a", "/"));
	ck_assert(!ts_files_below("/ab", "/a") && !ts_files_below("/", "/a"));
}
END_TEST

START_TEST(open_door)
{
	struct ts_files files = { 0 };

	ck_assert(opens(&files, "other/secret", "r") && opens(NULL, "other/secret", "r"));
	ck_assert(opens(&files, "other/new", "wx") && !opens(&files, "other/new", "wx"));
	ck_assert_int_eq(symlink("secret", "other/link"), 0);
	ck_assert(!opens(&files, "other/link", "wx"));
	ck_assert_int_eq(ts_files_remove(&files, "other/link"), 0);
}
END_TEST

START_TEST(closed_door)
{
	struct ts_files files = { 0 };
	struct stat info;

	close_door(&files);
	ck_assert(opens(&files, "in/a", "r") && !opens(&files, "in/a", "a") && !opens(&files, "in/b", "w"));
	ck_assert(!opens(&files, "run/old", "r"));
	ck_assert(strstr(ts_files_why(&files), "reads only below") != NULL);
	ck_assert(opens(&files, "run/new", "w") && opens(&files, "run/new", "r") &&
		  opens(&files, "run/old", "a"));
	ck_assert(!opens(&files, "run/old", "r") && opens(&files, "run/old", "w") &&
		  opens(&files, "run/old", "r"));
	ck_assert(!opens(&files, "other/secret", "r") && !opens(&files, "run", "w") && errno == EISDIR);
	ck_assert_int_eq(ts_files_stat(&files, "other/secret", &info), -1);
	ck_assert_int_eq(errno, EACCES);
	ck_assert_int_eq(ts_files_stat(&files, "run/none", &info), -1);
	ck_assert_int_eq(errno, ENOENT);
	ck_assert_int_eq(ts_files_move(&files, "run/new", "run/sub/new"), 0);
	ck_assert_int_eq(ts_files_move(&files, "run/sub/new", "in/new"), -1);
	ck_assert_int_eq(ts_files_make_folder(&files, "in/x"), -1);
	ck_assert_int_eq(ts_files_remove(&files, "in/a"), -1);
	ck_assert_int_eq(ts_files_remove_folder(&files, "other"), -1);
	ck_assert_int_eq(ts_files_chdir(&files, "other"), -1);
	ck_assert_int_eq(ts_files_chdir(&files, "run/sub"), 0);
	ck_assert(opens(&files, "new", "r"));
	ck_assert_ptr_null(ts_files_list(&files, "../../other"));
	ts_files_release(&files);
}
END_TEST

/* What others put in the way after a path was looked at: each look is a new one, and follows no link. */
START_TEST(in_the_way)
{
	struct ts_files files = { 0 };

	close_door(&files);
	ck_assert(opens(&files, "run/sub/x", "w"));
	ck_assert_int_eq(rename("run/sub", "run/away"), 0);
	ck_assert_int_eq(symlink("../other", "run/sub"), 0);
	ck_assert(!opens(&files, "run/sub/x", "w") && !opens(&files, "run/sub/secret", "r"));
	ck_assert_int_eq(access("other/x", F_OK), -1);
	ck_assert_int_eq(rename("run", "moved"), 0);
	ck_assert_int_eq(symlink("other", "run"), 0);
	ck_assert(!opens(&files, "run/x", "w"));
	ck_assert_int_eq(access("other/x", F_OK), -1);
	ts_files_release(&files);
}
END_TEST

START_TEST(budget)
{
	struct ts_files files = { 0 };
	char bytes[1000] = "";
	FILE *file;
	size_t n = 0;

	close_door(&files);
	file = ts_files_open(&files, "run/large", "w");
	ck_assert_ptr_nonnull(file);
	setvbuf(file, NULL, _IONBF, 0);
	while (n < 1000 && fwrite(bytes, 1, sizeof bytes, file) == sizeof bytes)
		n++;
	ck_assert_int_eq(errno, EDQUOT);
	ck_assert_uint_eq(n, 95); /* the file itself counts as 4096 */
	fclose(file);
	ck_assert(!opens(&files, "run/more", "w"));
	ts_files_release(&files);
}
END_TEST

/* The kernel by itself, with none of the checks above: 0, or the number of what it let through. */
static int attack(struct ts_files *files, bool paths, bool calls)
{
	char *const words[] = { (char[]){ "true" }, NULL };
	int own = 0;

	if (paths && (open("other/secret", O_RDONLY) >= 0 || errno != EACCES))
		return 1;
	if (paths && (open("in/a", O_WRONLY) >= 0 || open("in/new", O_WRONLY | O_CREAT, 0666) >= 0))
		return 2;
	if (paths && (unlink("other/secret") == 0 || rename("other/secret", "run/secret") == 0 ||
		      mkdir("in/x", 0777) == 0))
		return 3;
	if (paths && (open("/proc/self/environ", O_RDONLY) >= 0 || open("/etc/passwd", O_RDONLY) >= 0))
		return 4;
	own = open("run/own", O_RDWR | O_CREAT, 0666);
	if (own < 0 || write(own, "x", 1) != 1 || open("in/a", O_RDONLY) < 0 ||
	    open("/dev/null", O_WRONLY) < 0)
		return 5;
	(void)files;
	if (!calls)
		return 0;
	if (execv("/bin/true", words) == 0 || errno != EPERM || fork() >= 0 || errno != EPERM)
		return 6;
	if (socket(AF_UNIX, SOCK_STREAM, 0) >= 0 || socket(AF_INET, SOCK_STREAM, 0) >= 0)
		return 7;
	if (symlink("../other", "run/link") == 0 || link("in/a", "run/hard") == 0 ||
	    chmod("other/secret", 0) == 0)
		return 8;
	return 0;
}

START_TEST(kernel)
{
	struct ts_files files = { 0 };
	int status;
	pid_t child;

	close_door(&files);
	child = fork();
	if (child == 0) {
		bool paths = ts_sandbox_paths(&files) > 0;

		_exit(attack(&files, paths, ts_sandbox_calls(false)));
	}
	ck_assert_int_eq(waitpid(child, &status, 0), child);
	ck_assert(WIFEXITED(status));
	ck_assert_msg(WEXITSTATUS(status) == 0, "the kernel let through number %d", WEXITSTATUS(status));
	ts_files_release(&files);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("files");
	TCase *all = tcase_create("all");
	SRunner *runner;
	int failed;

	tcase_add_checked_fixture(all, enter, leave);
	tcase_add_test(all, names);
	tcase_add_test(all, open_door);
	tcase_add_test(all, closed_door);
	tcase_add_test(all, in_the_way);
	tcase_add_test(all, budget);
	tcase_add_test(all, kernel);
	suite_add_tcase(suite, all);
	runner = srunner_create(suite);
	srunner_run_all(runner, CK_NORMAL);
	failed = srunner_ntests_failed(runner);
	srunner_free(runner);
	return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
