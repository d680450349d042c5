#include "base/process.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/clock.h"

#include "base/banned.h"

enum { LONGEST_PATH = 4096 };

/* In the child process: executes the program, or reports errno to the parent. */
_Noreturn static void execute_program(const struct ts_process *p, int in, int out, int report)
{
	ssize_t told;
	int code;

	if (p->apart)
		setpgid(0, 0);
#ifdef __linux__
	if (p->follows)
		prctl(PR_SET_PDEATHSIG, SIGTERM);
#endif
	if (dup2(in, STDIN_FILENO) >= 0 && dup2(out, STDOUT_FILENO) >= 0 && dup2(out, STDERR_FILENO) >= 0 &&
	    (!p->folder || chdir(p->folder) == 0))
		execvp(p->words[0], (char *const *)p->words);
	code = errno;
	told = write(report, &code, sizeof code);
	_exit(told == (ssize_t)sizeof code ? 127 : 126);
}

/* Reads the report of the child: 0, or errno if it could not start. */
static int read_report(int report)
{
	int code = 0;
	ssize_t n;

	do
		n = read(report, &code, sizeof code);
	while (n < 0 && errno == EINTR);
	return n == (ssize_t)sizeof code ? code : 0;
}

/* Waits for the child with the options of waitpid; false: not ended. *status: its exit status, or 128 + signal number. */
static bool wait_for(pid_t child, int options, int *status)
{
	int code = 0;
	pid_t ended;

	do
		ended = waitpid(child, &code, options);
	while (ended < 0 && errno == EINTR);
	*status = ended < 0	      ? 127 /* somebody else has waited for it */
		  : WIFSIGNALED(code) ? 128 + WTERMSIG(code)
				      : WEXITSTATUS(code);
	return ended != 0;
}

static int start_process(const struct ts_process *p, int in, int out, pid_t *child)
{
	int report[2], code;

	if (pipe(report) != 0)
		return errno;
	fcntl(report[0], F_SETFD, FD_CLOEXEC);
	fcntl(report[1], F_SETFD, FD_CLOEXEC);
	*child = fork();
	if (*child == 0)
		execute_program(p, in, out, report[1]);
	code = *child < 0 ? errno : 0;
	close(report[1]);
	if (!code)
		code = read_report(report[0]);
	close(report[0]);
	return code;
}

enum ts_status ts_process_start(struct ts_process *p, struct ts_error *err)
{
	int in = open("/dev/null", O_RDONLY | O_CLOEXEC), code;
	int out = open(p->output, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);

	p->begin = ts_clock();
	p->child = 0;
	code = in < 0 || out < 0 ? errno : start_process(p, in, out, &p->child);
	if (in >= 0)
		close(in);
	if (out >= 0)
		close(out);
	if (!code)
		return TS_OK;
	if (p->child > 0)
		waitpid(p->child, NULL, 0); /* it has reported that it ends */
	p->child = 0;
	return ts_fail(err, TS_IO, NULL, "cannot start '%s': %s", p->words[0], strerror(code));
}

static bool end_process(struct ts_process *p, int options)
{
	int status;

	if (!wait_for(p->child, options, &status))
		return false;
	p->status = status;
	p->child = 0;
	p->seconds = ts_clock() - p->begin;
	return true;
}

bool ts_process_ended(struct ts_process *p)
{
	return p->child <= 0 || end_process(p, WNOHANG);
}

void ts_process_signal(const struct ts_process *p, int number)
{
	if (p->child > 0)
		kill(p->child, number);
}

enum ts_status ts_process_run(struct ts_process *p, struct ts_error *err)
{
	TS_TRY(ts_process_start(p, err));
	end_process(p, 0);
	return TS_OK;
}

/* ---- a program that is fed */

int ts_feed_start(struct ts_feed *feed, const char *const *words)
{
	const struct ts_process process = { .words = words, .apart = true };
	int end[2], code, status;
	pid_t child;

	*feed = (struct ts_feed){ 0 };
	if (socketpair(AF_UNIX, SOCK_STREAM, 0, end) != 0)
		return errno;
	fcntl(end[0], F_SETFD, FD_CLOEXEC);
	fcntl(end[1], F_SETFD, FD_CLOEXEC);
	code = start_process(&process, end[1], end[1], &child);
	close(end[1]);
	if (code) {
		close(end[0]);
		if (child > 0)
			wait_for(child, 0, &status);
		return code;
	}
	feed->child = child;
	feed->socket = end[0];
	return 0;
}

/* Keeps the end of what has been printed. */
static void keep_said(struct ts_feed *feed, const char *text, size_t n)
{
	const size_t room = sizeof feed->said - 1;
	size_t had = strlen(feed->said), drop;

	if (n > room) {
		text += n - room;
		n = room;
	}
	drop = had + n > room ? had + n - room : 0;
	memmove(feed->said, feed->said + drop, had - drop);
	had -= drop;
	for (size_t k = 0; k < n; k++)
		feed->said[had + k] = (unsigned char)text[k] < ' ' || text[k] == 127 ? ' ' : text[k];
	feed->said[had + n] = '\0';
}

/* Reads what the program prints; false: it has ended. */
static bool listen_to(struct ts_feed *feed, int flags)
{
	char text[512];
	ssize_t n;

	do
		n = recv(feed->socket, text, sizeof text, flags);
	while (n < 0 && errno == EINTR);
	if (n > 0)
		keep_said(feed, text, (size_t)n);
	return n > 0 || (n < 0 && (errno == EAGAIN || errno == EWOULDBLOCK));
}

int ts_feed_write(struct ts_feed *feed, const void *bytes, size_t n)
{
	struct pollfd ready = { .fd = feed->socket, .events = POLLIN | POLLOUT };
	const char *next = bytes;

	if (!feed->child)
		return EPIPE;
	while (n > 0) {
		ssize_t taken = 0;

		if (poll(&ready, 1, -1) < 0 && errno != EINTR)
			return errno;
		if (!listen_to(feed, MSG_DONTWAIT))
			return EPIPE;
		if (ready.revents & POLLOUT)
			taken = send(feed->socket, next, n, MSG_NOSIGNAL | MSG_DONTWAIT);
		if (taken < 0 && errno != EAGAIN && errno != EWOULDBLOCK && errno != EINTR)
			return errno;
		taken = taken < 0 ? 0 : taken;
		next += taken;
		n -= (size_t)taken;
	}
	return 0;
}

int ts_feed_end(struct ts_feed *feed)
{
	const pid_t child = feed->child;
	int status;

	if (!child)
		return 0;
	shutdown(feed->socket, SHUT_WR);
	while (listen_to(feed, 0))
		;
	close(feed->socket);
	feed->child = 0;
	wait_for(child, 0, &status);
	return status;
}

void ts_feed_kill(struct ts_feed *feed)
{
	if (feed->child)
		kill(feed->child, SIGKILL);
	ts_feed_end(feed);
}

/* Absolute path, valid in any working directory. */
static bool add_path(const char *name, struct ts_str *path)
{
	char here[LONGEST_PATH];

	if (name[0] != '/' && getcwd(here, sizeof here))
		ts_str_addf(path, "%s/", here);
	ts_str_add(path, name);
	return !path->failed && access(path->text, X_OK) == 0;
}

bool ts_process_find(const char *name, struct ts_str *path)
{
	const char *folder = getenv("PATH"), *end;

	ts_str_clear(path);
	if (strchr(name, '/'))
		return add_path(name, path);
	for (; folder && *folder; folder = *end ? end + 1 : end) {
		end = strchr(folder, ':');
		end = end ? end : folder + strlen(folder);
		ts_str_clear(path);
		ts_str_add_n(path, folder, (size_t)(end - folder));
		ts_str_addf(path, "/%s", name);
		if (!path->failed && access(path->text, X_OK) == 0)
			return true;
	}
	return false;
}

void ts_process_self(const char *called, struct ts_str *path)
{
	char file[LONGEST_PATH];
	ssize_t n = readlink("/proc/self/exe", file, sizeof file);

	ts_str_clear(path);
	if (n > 0 && n < (ssize_t)sizeof file)
		ts_str_add_n(path, file, (size_t)n);
	else if (!ts_process_find(called, path))
		ts_str_add(path, called);
}
