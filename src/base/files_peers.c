#include "base/files_peers.h"

#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

#include "base/alloc.h"
#include "base/hash.h"

#include "base/banned.h"

enum { PIECE = 1 << 16 };

/* What the first one says. */
struct answer {
	int result, code;
	uint64_t called; /* hash */
};

int ts_peers_agree(const struct ts_files_peers *peers, const char *called, int result)
{
	struct ts_hash hash = ts_hash_start();
	struct answer answer = { result, errno, 0 };

	ts_hash_text(&hash, called);
	answer.called = ts_hash_value(&hash);
	peers->spread(peers->data, &answer, sizeof answer);
	if (answer.called != ts_hash_value(&hash))
		peers->astray(peers->data, called);
	errno = answer.code;
	return answer.result;
}

int ts_peers_agree_on(const struct ts_files_peers *peers, const char *called, int result, void *bytes,
		      size_t n)
{
	result = ts_peers_agree(peers, called, result);
	if (result == 0)
		peers->spread(peers->data, bytes, n);
	return result;
}

static ssize_t read_piece(int from, char *piece)
{
	ssize_t n;

	do
		n = read(from, piece, PIECE);
	while (n < 0 && errno == EINTR);
	return n;
}

static bool write_piece(int to, const char *piece, size_t n)
{
	size_t done = 0;

	while (done < n) {
		ssize_t some = write(to, piece + done, n - done);

		if (some < 0 && errno == EINTR)
			continue;
		if (some <= 0)
			return false;
		done += (size_t)some;
	}
	return true;
}

int ts_peers_copy(const struct ts_files_peers *peers, int from)
{
	int to = memfd_create("tsim", MFD_CLOEXEC), n;
	char piece[PIECE];
	bool written = to >= 0;

	do {
		n = ts_peers_agree(peers, "read", peers->first ? (int)read_piece(from, piece) : 0);
		if (n > 0)
			peers->spread(peers->data, piece, (size_t)n);
		if (n > 0 && written)
			written = write_piece(to, piece, (size_t)n);
	} while (n > 0);
	if (peers->first)
		close(from);
	if (n == 0 && written && lseek(to, 0, SEEK_SET) == 0)
		return to;
	if (to >= 0)
		close(to);
	return -1;
}

int ts_peers_descriptor(const struct ts_files_peers *peers, const char *path)
{
	int from = peers->first ? open(path, O_RDONLY | O_CLOEXEC) : -1;

	if (ts_peers_agree(peers, "open to read", from) < 0)
		return -1;
	return ts_peers_copy(peers, from);
}

static FILE *open_to_write(const struct ts_files_peers *peers, const char *path, const char *mode)
{
	FILE *file = peers->first ? fopen(path, mode) : fopen("/dev/null", "w");

	if (ts_peers_agree(peers, "open to write", file ? 0 : -1) == 0)
		return file;
	if (file)
		fclose(file);
	return NULL;
}

FILE *ts_peers_open(const struct ts_files_peers *peers, const char *path, const char *mode)
{
	int descriptor;
	FILE *file;

	if (mode[0] != 'r')
		return open_to_write(peers, path, mode);
	descriptor = ts_peers_descriptor(peers, path);
	file = descriptor < 0 ? NULL : fdopen(descriptor, "r");
	if (descriptor >= 0 && !file)
		close(descriptor);
	return file;
}

/* ---- files that are read along: where all are, and the piece that the first one has read last */

enum { ALONG = 1 << 20 };

struct along {
	const struct ts_files_peers *peers;
	int descriptor; /* of the first one */
	bool seekable;
	off_t at; /* of the byte behind the piece */
	size_t n, used;
	char piece[ALONG];
};

static int read_next(struct along *a)
{
	ssize_t n;

	do
		n = a->seekable ? pread(a->descriptor, a->piece, ALONG, a->at)
				: read(a->descriptor, a->piece, ALONG);
	while (n < 0 && errno == EINTR);
	return (int)n;
}

static ssize_t along_read(void *cookie, char *to, size_t size)
{
	struct along *a = cookie;
	size_t n;

	if (a->used == a->n) {
		int got = ts_peers_agree(a->peers, "read along", a->peers->first ? read_next(a) : 0);

		if (got <= 0)
			return got;
		a->peers->spread(a->peers->data, a->piece, (size_t)got);
		a->n = (size_t)got;
		a->used = 0;
		a->at += got;
	}
	n = a->n - a->used < size ? a->n - a->used : size;
	memcpy(to, a->piece + a->used, n);
	a->used += n;
	return (ssize_t)n;
}

static int along_seek(void *cookie, off64_t *offset, int whence)
{
	struct along *a = cookie;

	if (!a->seekable || whence == SEEK_END) {
		errno = ESPIPE;
		return -1;
	}
	if (whence == SEEK_CUR)
		*offset += a->at - (off_t)(a->n - a->used);
	a->at = *offset;
	a->n = a->used = 0;
	return 0;
}

static int along_close(void *cookie)
{
	struct along *a = cookie;
	int result = a->descriptor >= 0 ? close(a->descriptor) : 0;

	ts_free(a);
	return result;
}

FILE *ts_peers_open_along(const struct ts_files_peers *peers, const char *path)
{
	static const cookie_io_functions_t functions = { .read = along_read,
							 .seek = along_seek,
							 .close = along_close };
	int from = peers->first ? open(path, O_RDONLY | O_CLOEXEC) : -1, seekable;
	struct along *a;
	FILE *file;

	if (ts_peers_agree(peers, "open to read along", from) < 0)
		return NULL;
	seekable = ts_peers_agree(peers, "seek", peers->first && lseek(from, 0, SEEK_CUR) == 0);
	a = ts_alloc(1, sizeof *a);
	file = a ? fopencookie(a, "r", functions) : NULL;
	if (!file) {
		ts_free(a);
		if (from >= 0)
			close(from);
		errno = ENOMEM;
		return NULL;
	}
	a->peers = peers;
	a->descriptor = from;
	a->seekable = seekable == 1;
	return file;
}

int ts_peers_stat(const struct ts_files_peers *peers, const char *path, struct stat *out)
{
	int result = peers->first ? stat(path, out) : 0;

	return ts_peers_agree_on(peers, "stat", result, out, sizeof *out);
}

int ts_peers_apart(struct ts_files *files, int (*act)(void *data), void *data)
{
	const struct ts_files_peers *peers = files->peers;
	int result;

	files->peers = NULL;
	result = act(data);
	files->peers = peers;
	return result;
}

int ts_peers_by_first(struct ts_files *files, int (*act)(void *data), void *data)
{
	if (!ts_peers(files))
		return act(data);
	return ts_peers_agree(files->peers, "act",
			      files->peers->first ? ts_peers_apart(files, act, data) : 0);
}
