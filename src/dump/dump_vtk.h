/* What the VTK dumps share: columns merged into vectors, files, the collection over time. */
#ifndef TS_DUMP_DUMP_VTK_H
#define TS_DUMP_DUMP_VTK_H

#include "dump/dump.h"
#include "io/vtk.h"

/* First member of their states. */
struct ts_dump_vtk {
	struct ts_dump_common common;
	struct ts_words names;
	struct ts_vtk_series series;
	struct ts_vtk_array *array; /* in the instance's arena, at most one per column */
	size_t narrays;
	struct ts_table merged; /* their numbers, one after another */
	struct ts_table points;
};

#define TS_DUMP_VTK_FILE_ARGS(T)                                                                        \
	TS_INT("every", T, vtk.common.every, .flags = TS_POSITIONAL, .range = TS_POSITIVE,              \
	       .help = "steps between frames"),                                                         \
		TS_WORD("file", T, vtk.common.file, .flags = TS_POSITIONAL | TS_WRITES,                 \
			.help = "name of the frames, ending in .vtk, .vtp, .vtu, .pvtp or .pvtu, with " \
				"a `*` for the step")
#define TS_DUMP_VTK_ARGS(T, columns_help) \
	TS_DUMP_VTK_FILE_ARGS(T), TS_REST("columns", T, vtk.names, .help = (columns_help))
#define TS_DUMP_VTK_SAVED(T) TS_SAVE_I64(T, vtk.common.last), TS_SAVE_I64(T, vtk.common.frames)

/* Refuses file names of an unknown type. */
enum ts_status ts_dump_vtk_check_name(struct ts_instance *self, struct tsim *sim);
/* The same, and finds the columns. */
enum ts_status ts_dump_vtk_init(struct ts_instance *self, struct tsim *sim, bool local);
/* A frame of columns, if one is due. `place` fills `points`: one for each row, or of local rows two, the
 * ends of a line. Of particles three columns that are components of one vector (vx vy vz, c_ID[1] c_ID[2]
 * c_ID[3]) become one array; x, y, z are left out. */
typedef enum ts_status ts_dump_vtk_place_fn(struct ts_instance *self, struct tsim *sim);
enum ts_status ts_dump_vtk_frame(struct ts_instance *self, struct tsim *sim, bool local,
				 ts_dump_vtk_place_fn *place);
/* The name of the frame of this step, into common.path. */
enum ts_status ts_dump_vtk_path(struct ts_dump_common *d, struct tsim *sim);
/* Enters the frame of this step in the collection, and writes that; without a `*` in the name there is
 * none, and the second frame gets a warning. */
enum ts_status ts_dump_vtk_list(struct ts_instance *self, struct tsim *sim);
/* The two ends of a line: from a to the nearest periodic image of b. */
void ts_dump_vtk_line(const struct tsim *sim, const double a[3], const double b[3], double to[6]);
/* Writes a frame and the collection. */
enum ts_status ts_dump_vtk_write(struct ts_instance *self, struct tsim *sim, struct ts_vtk_poly *poly);
enum ts_status ts_dump_vtk_archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *archive);
void ts_dump_vtk_fini(struct ts_instance *self);

#endif
