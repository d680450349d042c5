/* Shared by the VTK dumps: columns merged into vectors, files, the collection of frames. */
#ifndef TS_DUMP_DUMP_VTK_H
#define TS_DUMP_DUMP_VTK_H

#include "dump/dump.h"
#include "io/vtk.h"

/* First member of their states. */
struct ts_dump_vtk {
	struct ts_dump_common common;
	struct ts_words names;	     /* columns as given */
	struct ts_vtk_series series; /* frames written so far */
	struct ts_vtk_array *array;  /* [narrays] in the instance's arena, at most one per column */
	size_t narrays;
	struct ts_table merged; /* data of the arrays, one array after another */
	struct ts_table points; /* [points][3] positions (length) */
};

#define TS_DUMP_VTK_FILE_ARGS(T)                                                                        \
	TS_INT("every", T, vtk.common.every, .flags = TS_POSITIONAL, .range = TS_POSITIVE,              \
	       .help = "steps between frames"),                                                         \
		TS_WORD("file", T, vtk.common.file, .flags = TS_POSITIONAL | TS_WRITES,                 \
			.help = "name of the frames, ending in .vtk, .vtp, .vtu, .pvtp or .pvtu, with " \
				"a `*` for the step; of all frames: .vtkhdf")
#define TS_DUMP_VTK_ARGS(T, columns_help) \
	TS_DUMP_VTK_FILE_ARGS(T), TS_REST("columns", T, vtk.names, .help = (columns_help))
#define TS_DUMP_VTK_SAVED(T) TS_SAVE_I64(T, vtk.common.last), TS_SAVE_I64(T, vtk.common.frames)

/* Refuses file names of an unknown type. */
enum ts_status ts_dump_vtk_check_name(struct ts_instance *self, struct tsim *sim);
/* Checks the file name and makes the columns. */
enum ts_status ts_dump_vtk_init(struct ts_instance *self, struct tsim *sim, bool local);
/* Writes a frame of the columns if one is due. `fill_points` fills `points`: one point for each particle,
 * or two for each local row, the ends of a line. For particles, three columns that are the components of a
 * vector (vx vy vz, c_ID[1] c_ID[2] c_ID[3]) become one array; x, y, z are left out. */
typedef enum ts_status ts_dump_vtk_points_fn(struct ts_instance *self, struct tsim *sim);
enum ts_status ts_dump_vtk_frame(struct ts_instance *self, struct tsim *sim, bool local,
				 ts_dump_vtk_points_fn *fill_points);
/* Sets common.path to the file name of this step. */
enum ts_status ts_dump_vtk_path(struct ts_dump_common *d, struct tsim *sim);
/* Adds the frame of this step to the collection and writes it. Without a `*` in the file name there is no
 * collection, and the second frame, which replaces the first, causes a warning. */
enum ts_status ts_dump_vtk_list(struct ts_instance *self, struct tsim *sim);
/* The two ends of a line: from a to the nearest periodic image of b. */
void ts_dump_vtk_line(const struct tsim *sim, const double a[3], const double b[3], double to[6]);
/* Writes a frame and the collection. */
enum ts_status ts_dump_vtk_write(struct ts_instance *self, struct tsim *sim, struct ts_vtk_poly *poly);
enum ts_status ts_dump_vtk_archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *archive);
void ts_dump_vtk_fini(struct ts_instance *self);

#endif
