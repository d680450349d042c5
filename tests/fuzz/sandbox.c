#include "sandbox.h"

#include <errno.h>
#include <signal.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <unistd.h>
#include <zlib.h>

#include "core/sim.h"
#include "tsim.h"

enum { LARGEST_BLOCK = 1 << 26, MOST_MEMORY = 1 << 29, PATIENCE_US = 333333 };

/* Of the address sanitizer; NULL without it. */
size_t __attribute__((weak)) __sanitizer_get_current_allocated_bytes(void);

static struct {
	volatile bool inside;
	struct tsim *volatile sim;
	const uint8_t *input;
	size_t n;
} box;

static void on_timer(int number)
{
	(void)number;
	if (box.sim)
		box.sim->requests.stop = 1;
}

static void set_timer(long us)
{
	struct itimerval timer = { .it_value = { .tv_usec = us } };

	setitimer(ITIMER_VIRTUAL, &timer, NULL);
}

void sandbox_enter(struct tsim *sim, const uint8_t *input, size_t n)
{
	struct sigaction action = { .sa_handler = on_timer };

	box.sim = sim;
	box.input = input;
	box.n = n;
	box.inside = true;
	sim->requests.stop = 0;
	sim->threads = 1;
	sim->log.screen = NULL;
	sigaction(SIGVTALRM, &action, NULL);
	set_timer(PATIENCE_US);
}

void sandbox_report(struct tsim *sim)
{
	if (getenv("FUZZ_VERBOSE"))
		fputs(tsim_error(sim), stderr);
}

void sandbox_leave(void)
{
	set_timer(0);
	box.sim = NULL;
	box.inside = false;
}

/* ---- calls that are let through outside of an input only */

#define WRAPPED(result, name, parameters, arguments, instead) \
	result __real_##name parameters;                      \
	result __wrap_##name parameters;                      \
	result __wrap_##name parameters                       \
	{                                                     \
		if (!box.inside)                              \
			return __real_##name arguments;       \
		return instead;                               \
	}

static int deny(const void *unused)
{
	(void)unused;
	errno = EACCES;
	return -1;
}

static void *deny_pointer(const void *unused)
{
	deny(unused);
	return NULL;
}

FILE *__real_fopen(const char *path, const char *mode);
gzFile __real_gzopen(const char *path, const char *mode);

static FILE *pretend_open(const char *path, const char *mode)
{
	if (strncmp(path, "../found.", 9) == 0) /* what libFuzzer has found */
		return __real_fopen(path, mode);
	if (mode[0] != 'r')
		return __real_fopen("/dev/null", "w");
	if (strcmp(path, "input") == 0 && box.n)
		return fmemopen((void *)(uintptr_t)box.input, box.n, "r");
	errno = ENOENT;
	return NULL;
}

static gzFile pretend_gzopen(const char *path, const char *mode)
{
	int memory;

	if (mode[0] != 'r')
		return __real_gzopen("/dev/null", "wb");
	memory = strcmp(path, "input") == 0 ? memfd_create("input", 0) : -1;
	if (memory < 0 || write(memory, box.input, box.n) < 0 || lseek(memory, 0, SEEK_SET) < 0)
		return deny_pointer(NULL);
	return gzdopen(memory, "rb");
}

WRAPPED(FILE *, fopen, (const char *path, const char *mode), (path, mode), pretend_open(path, mode))
WRAPPED(gzFile, gzopen, (const char *path, const char *mode), (path, mode), pretend_gzopen(path, mode))
WRAPPED(int, mkdir, (const char *path, mode_t mode), (path, mode), 0)
WRAPPED(int, rmdir, (const char *path), (path), 0)
WRAPPED(int, unlink, (const char *path), (path), 0)
WRAPPED(int, remove, (const char *path), (path), 0)
WRAPPED(int, rename, (const char *from, const char *to), (from, to), 0)
WRAPPED(int, chdir, (const char *path), (path), 0)
WRAPPED(int, fsync, (int descriptor), (descriptor), 0)
WRAPPED(int, stat, (const char *path, struct stat *out), (path, out), deny(path))
WRAPPED(int, setenv, (const char *name, const char *value, int replace), (name, value, replace), 0)
WRAPPED(int, system, (const char *command), (command), deny(command))
WRAPPED(FILE *, popen, (const char *command, const char *mode), (command, mode), deny_pointer(command))
WRAPPED(void *, opendir, (const char *path), (path), deny_pointer(path))
WRAPPED(int, glob, (const char *pattern, int flags, void *failed, void *out), (pattern, flags, failed, out),
	deny(pattern))
WRAPPED(int, fork, (void), (), deny(NULL))
WRAPPED(int, execvp, (const char *path, char *const *argv), (path, argv), deny(path))
WRAPPED(int, kill, (int process, int number), (process, number), 0)

static bool too_much(size_t n)
{
	return n > LARGEST_BLOCK || (__sanitizer_get_current_allocated_bytes &&
				     __sanitizer_get_current_allocated_bytes() + n > MOST_MEMORY);
}

WRAPPED(void *, calloc, (size_t n, size_t size), (n, size),
	size && (n > LARGEST_BLOCK / size || too_much(n * size)) ? NULL : __real_calloc(n, size))
WRAPPED(int, posix_memalign, (void **out, size_t alignment, size_t n), (out, alignment, n),
	too_much(n) ? ENOMEM : __real_posix_memalign(out, alignment, n))

FILE *sandbox_open(const char *path, const char *mode)
{
	return __real_fopen(path, mode);
}
