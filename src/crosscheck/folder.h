/* Folders of files: made, filled, listed and removed. */
#ifndef TS_CROSSCHECK_FOLDER_H
#define TS_CROSSCHECK_FOLDER_H

#include "base/status.h"
#include "base/str.h"

/* With all that lead to it. */
enum ts_status ts_folder_make(const char *path, struct ts_error *err);
/* The same, but it must not be there yet. */
enum ts_status ts_folder_new(const char *path, struct ts_error *err);
/* A new one for this process only, in TMPDIR. */
enum ts_status ts_folder_scratch(struct ts_str *path, struct ts_error *err);
/* Copies a file, making its folder, and gives it that date (seconds). */
enum ts_status ts_folder_copy(const char *from, const char *to, int64_t date, struct ts_error *err);
/* Removes it and all in it. */
void ts_folder_remove(const char *path);

/* Names of all files below a folder, except those with that date; in order, numbers in them by value. */
struct ts_listing {
	const char **name;
	size_t n, capacity;
};
enum ts_status ts_folder_list(const char *path, int64_t except, struct ts_listing *out, struct ts_pool *pool,
			      struct ts_error *err);

#endif
