#include "base/script_folders.h"

#include <limits.h>
#include <string.h>
#include <unistd.h>

#include "base/alloc.h"

#include "base/banned.h"

bool ts_files_note_script(struct ts_files *files, const char *name)
{
	struct ts_script_folder *new;

	for (size_t k = files->nscripts; k-- > 0;)
		if (strcmp(files->script[k].name, name) == 0 && !files->script[k].folder)
			return true;
	if (TS_GROW(files->script, files->script_capacity, files->nscripts + 1) != TS_OK)
		return false;
	new = &files->script[files->nscripts];
	*new = (struct ts_script_folder){ .name = ts_strdup(name) };
	files->nscripts += new->name != NULL;
	return new->name != NULL;
}

/* The absolute name of the folder of a file; NULL: not found, or out of memory. */
static char *absolute_folder(const char *name)
{
	const char *slash = strrchr(name, '/');
	char here[PATH_MAX], *folder = NULL;
	struct ts_str path = { 0 };

	if (getcwd(here, sizeof here)) {
		ts_str_addf(&path, "%s/", name[0] == '/' ? "" : here);
		ts_str_add_n(&path, name, slash ? (size_t)(slash + 1 - name) : 0);
		folder = path.failed ? NULL : ts_strdup(ts_str_text(&path));
	}
	ts_str_release(&path);
	return folder;
}

void ts_files_keep_script_folders(struct ts_files *files)
{
	for (size_t k = 0; files && k < files->nscripts; k++)
		if (!files->script[k].folder)
			files->script[k].folder = absolute_folder(files->script[k].name);
}

void ts_files_forget_scripts(struct ts_files *files)
{
	for (size_t k = 0; k < files->nscripts; k++) {
		ts_free(files->script[k].name);
		ts_free(files->script[k].folder);
	}
	ts_free(files->script);
	files->script = NULL;
	files->nscripts = files->script_capacity = 0;
}

/* The folder of the script that was opened last by this name, if the working folder has changed since; else NULL. */
static const char *folder_kept(const struct ts_files *files, const char *name)
{
	for (size_t k = files ? files->nscripts : 0; k-- > 0;)
		if (strcmp(files->script[k].name, name) == 0)
			return files->script[k].folder;
	return NULL;
}

bool ts_files_beside(const struct ts_files *files, struct ts_str *out, const char *file, const char *path)
{
	const char *folder = folder_kept(files, file), *slash = strrchr(file, '/');

	if (*path == '/' || (!folder && !slash))
		return false;
	if (folder)
		ts_str_add(out, folder);
	else
		ts_str_add_n(out, file, (size_t)(slash + 1 - file));
	ts_str_add(out, path);
	return true;
}
