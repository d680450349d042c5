#include "core/written_files.h"

#include <string.h>

#include "base/banned.h"

struct written {
	const struct ts_instance *by;
	const char *path;
	bool shared; /* others may write to it */
};
struct written_files {
	struct written *item;
	size_t n, capacity;
};

/* ./a is a. */
static const char *plain(const char *path)
{
	while (path[0] == '.' && path[1] == '/')
		for (path += 2; *path == '/';)
			path++;
	return path;
}

static enum ts_status add_files_of(struct written_files *files, const struct ts_instance *by)
{
	for (const struct ts_arg *row = by->style->args; row && row->type != TS_ARG_END; row++) {
		const char *path = row->flags & TS_WRITES
					   ? *(const char *const *)((const char *)by->state + row->offset)
					   : NULL;

		if (!path || strncmp(path, "/dev/", 5) == 0)
			continue;
		TS_TRY(TS_GROW(files->item, files->capacity, files->n + 1));
		files->item[files->n++] =
			(struct written){ by, plain(path),
					  row->flags & TS_SHARES || ts_streq(row->name, "append") };
	}
	return TS_OK;
}

static bool collide(const struct written *a, const struct written *b)
{
	return a->by != b->by && ts_streq(a->path, b->path) && !(a->shared && b->shared);
}

/* The ending of XML files of VTK of which one is written for each frame: .vtp, .vti ...; NULL: the file is none. */
static const char *ending_of_frames(const char *path)
{
	const char *dot = strrchr(path, '.');

	return dot && strchr(path, '*') && strncmp(dot, ".vt", 3) == 0 && !ts_streq(dot, ".vtk") ? dot : NULL;
}

/* Frames NAME*.vti and NAME*.vtr are listed in the same collection, NAME.pvd (io/vtk.h). */
static bool collections_collide(const struct written *a, const struct written *b)
{
	const char *end = ending_of_frames(a->path), *other = ending_of_frames(b->path);

	return a->by != b->by && end && other && end - a->path == other - b->path &&
	       strncmp(a->path, b->path, (size_t)(end - a->path)) == 0;
}

static enum ts_status refuse(struct tsim *sim, const struct written *file, const struct ts_instance *other)
{
	if (ending_of_frames(file->path))
		return ts_fail(&sim->error, TS_STATE, &file->by->where,
			       "%s %s lists its frames '%s' in a collection (.pvd), and %s %s (%s:%d) in the "
			       "same one: each would destroy what the other has written; give them names "
			       "that differ before the ending",
			       ts_kind_name(file->by->style->kind), file->by->id, file->path,
			       ts_kind_name(other->style->kind), other->id, TS_FILE_AND_LINE(other->where));
	return ts_fail(&sim->error, TS_STATE, &file->by->where,
		       "%s %s writes to '%s', and so does %s %s (%s:%d): each would destroy what the other "
		       "has written; give them files of their own",
		       ts_kind_name(file->by->style->kind), file->by->id, file->path,
		       ts_kind_name(other->style->kind), other->id, TS_FILE_AND_LINE(other->where));
}

static enum ts_status find_files(struct tsim *sim, struct written_files *files)
{
	static const enum ts_kind kinds[] = { TS_KIND_FIX, TS_KIND_DUMP };
	enum ts_status status = TS_OK;

	for (size_t n = 0; n < sizeof kinds / sizeof *kinds; n++)
		for (size_t k = 0; k < sim->instances[kinds[n]].n && status == TS_OK; k++)
			status = add_files_of(files, sim->instances[kinds[n]].item[k]);
	return status == TS_OK ? TS_OK : ts_nomem(&sim->error);
}

enum ts_status ts_written_files_allow(struct tsim *sim, const char *what, const char *path,
				      const struct ts_place *where)
{
	struct written_files files = { 0 };
	enum ts_status status = find_files(sim, &files);

	for (size_t k = 0; k < files.n && status == TS_OK; k++) {
		const struct written *f = &files.item[k];

		if (ts_streq(f->path, plain(path)))
			status = ts_fail(&sim->error, TS_STATE, where,
					 "%s would write to '%s', to which %s %s (%s:%d) writes: it would "
					 "destroy what that has written; give it a file of its own",
					 what, f->path, ts_kind_name(f->by->style->kind), f->by->id,
					 TS_FILE_AND_LINE(f->by->where));
	}
	ts_free(files.item);
	return status;
}

enum ts_status ts_written_files_check(struct tsim *sim)
{
	struct written_files files = { 0 };
	enum ts_status status = find_files(sim, &files);

	for (size_t b = 1; b < files.n && status == TS_OK; b++)
		for (size_t a = 0; a < b && status == TS_OK; a++)
			if (collide(&files.item[a], &files.item[b]) ||
			    collections_collide(&files.item[a], &files.item[b])) {
				status = ts_sim_defer_error(sim,
							    refuse(sim, &files.item[b], files.item[a].by));
				break;
			}
	ts_free(files.item);
	return status;
}
