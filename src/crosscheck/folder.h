/* Folders: creation, copies of files, lists, removal. */
#ifndef TS_CROSSCHECK_FOLDER_H
#define TS_CROSSCHECK_FOLDER_H

#include "base/status.h"
#include "base/str.h"

/* Creates the folder and its parents. */
enum ts_status ts_folder_make(const char *path, struct ts_error *err);
/* The same; an error if it exists. */
enum ts_status ts_folder_new(const char *path, struct ts_error *err);
/* Creates a folder for this process in TMPDIR. */
enum ts_status ts_folder_scratch(struct ts_str *path, struct ts_error *err);
/* Copies a file, creates its folder, and sets the modification time of the copy (s). */
enum ts_status ts_folder_copy(const char *from, const char *to, int64_t date, struct ts_error *err);
/* Removes the folder and its contents. */
void ts_folder_remove(const char *path);

/* Names of all files below a folder, except those with this modification time; sorted, numbers by value. */
struct ts_listing {
	const char **name;
	size_t n, capacity;
};
enum ts_status ts_folder_list(const char *path, int64_t except, struct ts_listing *out, struct ts_pool *pool,
			      struct ts_error *err);

#endif
