#include "dump/dump_mesh.h"

#include <string.h>

#include "base/banned.h"

static enum ts_status add(struct ts_dump_mesh *d, struct tsim *sim, struct ts_mesh_surface *surface)
{
	if (TS_GROW(d->surface, d->capacity, d->nsurfaces + 1) != TS_OK)
		return ts_nomem(&sim->error);
	d->surface[d->nsurfaces++] = surface;
	return TS_OK;
}

static enum ts_status find_named(struct ts_instance *self, struct tsim *sim, ts_dump_mesh_word_fn *word)
{
	struct ts_dump_mesh *d = self->state;
	struct ts_mesh_surface *surface;

	for (size_t k = 0, taken; k < d->words.n; k += taken) {
		TS_TRY(word(self, sim, ts_words_from(d->words, k), &taken));
		if (taken)
			continue;
		taken = 1;
		TS_TRY(ts_mesh_surface_require(sim, &d->words.word[k], &surface));
		TS_TRY(add(d, sim, surface));
	}
	return TS_OK;
}

enum ts_status ts_dump_mesh_init(struct ts_instance *self, struct tsim *sim, ts_dump_mesh_word_fn *word)
{
	struct ts_dump_mesh *d = self->state;
	struct ts_mesh_surface *surface;
	bool in_one =
		self->style->archive == ts_dump_vtk_archive && ts_vtk_has_all_frames(d->vtk.common.file);

	if (!in_one && !strchr(d->vtk.common.file, '*'))
		return ts_fail(&sim->error, TS_SYNTAX, ts_instance_word(self, d->vtk.common.file),
			       "dump %s writes one file per frame: the name '%s' needs a `*` for the step",
			       self->style->name, d->vtk.common.file);
	d->nsurfaces = 0;
	TS_TRY(find_named(self, sim, word));
	if (d->nsurfaces)
		return TS_OK;
	for (size_t k = 0; (surface = ts_mesh_surface_next(sim, &k, NULL));)
		TS_TRY(add(d, sim, surface));
	return TS_OK;
}

enum ts_status ts_dump_mesh_begin(struct ts_instance *self, struct tsim *sim, bool *due)
{
	TS_TRY(ts_dump_due(self, sim, due));
	return *due ? ts_dump_open(self, sim) : TS_OK;
}

enum ts_status ts_dump_mesh_end(struct ts_instance *self, struct tsim *sim)
{
	struct ts_dump_common *d = self->state;

	if (d->text.failed)
		return ts_nomem(&sim->error);
	TS_TRY(ts_textfile_write(&d->out, ts_str_text(&d->text), d->text.length));
	return ts_dump_frame_done(d, sim);
}

size_t ts_dump_mesh_triangles(const struct ts_dump_mesh *d)
{
	size_t n = 0;

	for (size_t k = 0; k < d->nsurfaces; k++)
		for (size_t t = 0; t < d->surface[k]->mesh.n; t++)
			n += !ts_mesh_is_removed(&d->surface[k]->mesh, t);
	return n;
}

void ts_dump_mesh_fini(struct ts_instance *self)
{
	struct ts_dump_mesh *d = self->state;

	ts_free(d->surface);
	ts_dump_vtk_fini(self);
}
