#include "core/written_files.h"

#include <string.h>

#include "base/banned.h"

/* One name of a file. */
struct written {
	const struct ts_instance *by;
	const char *path;
	bool shared; /* others may write to it */
};

/* ./a is a. */
static const char *plain(const char *path)
{
	while (path[0] == '.' && path[1] == '/')
		for (path += 2; *path == '/';)
			path++;
	return path;
}

/* The files of an instance from row *row on, one after the other; NULL: there are no more. */
static const char *next_file(const struct ts_instance *inst, const struct ts_arg **row, bool *shared)
{
	for (; *row && (*row)->type != TS_ARG_END; ++*row) {
		const char *path =
			(*row)->flags & TS_WRITES
				? *(const char *const *)((const char *)inst->state + (*row)->offset)
				: NULL;

		if (!path || strncmp(path, "/dev/", 5) == 0)
			continue;
		*shared = (*row)->flags & TS_SHARES || ts_streq((*row)->name, "append");
		++*row;
		return plain(path);
	}
	return NULL;
}

/* The style before `of`, in the order of kinds and of the script, that writes to its file, too; NULL: there is none. */
static const struct ts_instance *find_other(const struct tsim *sim, const struct written *of)
{
	static const enum ts_kind kinds[] = { TS_KIND_FIX, TS_KIND_DUMP };

	for (size_t n = 0; n < sizeof kinds / sizeof *kinds; n++) {
		const struct ts_instances *list = &sim->instances[kinds[n]];

		for (size_t k = 0; k < list->n; k++) {
			const struct ts_arg *row = list->item[k]->style->args;
			const char *path;
			bool shared;

			if (list->item[k] == of->by)
				return NULL;
			while ((path = next_file(list->item[k], &row, &shared)))
				if (ts_streq(path, of->path) && !(shared && of->shared))
					return list->item[k];
		}
	}
	return NULL;
}

static enum ts_status check_instance(struct tsim *sim, const struct ts_instance *inst)
{
	const struct ts_arg *row = inst->style->args;
	struct written file = { .by = inst };

	while ((file.path = next_file(inst, &row, &file.shared))) {
		const struct ts_instance *other = find_other(sim, &file);

		if (other)
			return ts_fail(&sim->error, TS_STATE, &inst->where,
				       "%s %s writes to '%s', and so does %s %s (%s:%d): each would destroy "
				       "what the "
				       "other has written; give them files of their own",
				       ts_kind_name(inst->style->kind), inst->id, file.path,
				       ts_kind_name(other->style->kind), other->id,
				       TS_FILE_AND_LINE(other->where));
	}
	return TS_OK;
}

enum ts_status ts_written_files_check(struct tsim *sim)
{
	static const enum ts_kind kinds[] = { TS_KIND_FIX, TS_KIND_DUMP };

	for (size_t n = 0; n < sizeof kinds / sizeof *kinds; n++) {
		const struct ts_instances *list = &sim->instances[kinds[n]];

		for (size_t k = 0; k < list->n; k++)
			TS_TRY(ts_sim_defer_error(sim, check_instance(sim, list->item[k])));
	}
	return TS_OK;
}
