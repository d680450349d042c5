/* Folders of scripts, in which the files that they name are looked for. A script is known by the name by which it was opened,
 * which is relative to the working folder of that moment. */
#ifndef TS_BASE_SCRIPT_FOLDERS_H
#define TS_BASE_SCRIPT_FOLDERS_H

#include "base/files.h"

struct ts_script_folder {
	char *name;   /* owned */
	char *folder; /* absolute; NULL: the working folder has not changed since it was opened. Owned */
};

/* A script has been opened by this name; false: out of memory. */
bool ts_files_note_script(struct ts_files *files, const char *name);
/* Before the working folder changes. */
void ts_files_keep_script_folders(struct ts_files *files);
void ts_files_forget_scripts(struct ts_files *files);
/* Adds the path in the folder of the script `file`; false if it is absolute, or `file` is in the working folder. `files` may be
 * NULL: the working folder has not changed. */
bool ts_files_beside(const struct ts_files *files, struct ts_str *out, const char *file, const char *path);

#endif
