/* Shared by the dumps of meshes: which meshes are written, and at which steps. */
#ifndef TS_DUMP_DUMP_MESH_H
#define TS_DUMP_DUMP_MESH_H

#include "dump/dump_vtk.h"
#include "mesh/mesh_surface.h"

/* First member of their states. */
struct ts_dump_mesh {
	struct ts_dump_vtk vtk;		  /* of dumps of STL files only its member `common` is used */
	struct ts_words words;		  /* arguments after the file name */
	struct ts_mesh_surface **surface; /* [nsurfaces] meshes to write */
	size_t nsurfaces, capacity;
};

#define TS_DUMP_MESH_ARGS(T, ending, help_)                                                     \
	TS_INT("every", T, mesh.vtk.common.every, .flags = TS_POSITIONAL, .range = TS_POSITIVE, \
	       .help = "steps between frames"),                                                 \
		TS_WORD("file", T, mesh.vtk.common.file, .flags = TS_POSITIONAL | TS_WRITES,    \
			.help = "name of the frames (" ending "), with a `*` for the step"),    \
		TS_REST_OPTIONAL("words", T, mesh.words, .help = (help_))
#define TS_DUMP_MESH_SAVED(T) TS_SAVE_I64(T, mesh.vtk.common.last), TS_SAVE_I64(T, mesh.vtk.common.frames)

/* Parses arguments of the style itself. *taken: number of words used; 0: the word must be the id of a
 * mesh. */
typedef enum ts_status ts_dump_mesh_word_fn(struct ts_instance *self, struct tsim *sim, struct ts_words rest,
					    size_t *taken);
/* Finds the meshes: those named, or all if none is. Refuses a file name without `*`. */
enum ts_status ts_dump_mesh_init(struct ts_instance *self, struct tsim *sim, ts_dump_mesh_word_fn *word);

/* Begins a frame if one is due; the style adds its text to common.text. */
enum ts_status ts_dump_mesh_begin(struct ts_instance *self, struct tsim *sim, bool *due);
/* Writes common.text and ends the frame. */
enum ts_status ts_dump_mesh_end(struct ts_instance *self, struct tsim *sim);
/* Number of triangles of all meshes of the dump, without those that have been removed. */
size_t ts_dump_mesh_triangles(const struct ts_dump_mesh *d);

void ts_dump_mesh_fini(struct ts_instance *self);

#endif
