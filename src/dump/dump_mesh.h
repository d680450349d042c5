/* What the dumps of meshes share: which meshes are written, and when. */
#ifndef TS_DUMP_DUMP_MESH_H
#define TS_DUMP_DUMP_MESH_H

#include "dump/dump.h"
#include "mesh/mesh_surface.h"

/* First member of their states. */
struct ts_dump_mesh {
	struct ts_dump_common common;
	struct ts_words words; /* of the line, from behind the file name */
	struct ts_mesh_surface **surface;
	size_t nsurfaces, capacity;
};

#define TS_DUMP_MESH_ARGS(T, ending, help_)                                                  \
	TS_INT("every", T, mesh.common.every, .flags = TS_POSITIONAL, .range = TS_POSITIVE,  \
	       .help = "steps between frames"),                                              \
		TS_WORD("file", T, mesh.common.file, .flags = TS_POSITIONAL | TS_WRITES,     \
			.help = "name of the frames (" ending "), with a `*` for the step"), \
		TS_REST_OPTIONAL("words", T, mesh.words, .help = (help_))
#define TS_DUMP_MESH_SAVED(T) TS_SAVE_I64(T, mesh.common.last), TS_SAVE_I64(T, mesh.common.frames)

/* What else a word of the line may be. *taken: so many words, 0 if it must be the id of a mesh. */
typedef enum ts_status ts_dump_mesh_word_fn(struct ts_instance *self, struct tsim *sim, struct ts_words rest,
					    size_t *taken);
/* Finds the meshes, all of them if none is named. Refuses a file name without `*`. */
enum ts_status ts_dump_mesh_init(struct ts_instance *self, struct tsim *sim, ts_dump_mesh_word_fn *word);

/* Begins a frame if one is due; the style adds to common.text. */
enum ts_status ts_dump_mesh_begin(struct ts_instance *self, struct tsim *sim, bool *due);
enum ts_status ts_dump_mesh_end(struct ts_instance *self, struct tsim *sim);
size_t ts_dump_mesh_triangles(const struct ts_dump_mesh *d);

void ts_dump_mesh_fini(struct ts_instance *self);

#endif
