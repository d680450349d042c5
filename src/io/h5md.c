#include "io/h5md.h"

#ifdef TS_WITH_HDF5
#include <errno.h>
#include <hdf5.h>
#include <math.h>
#include <string.h>

#include "base/mkdirs.h"
#include "io/h5file.h"

#include "base/banned.h"

enum { LEVEL = 1 };		       /* of compression */
enum { ROWS = 1 << 16, FRAMES = 256 }; /* particles, frames in a chunk */
enum {
	METADATA = 8192,
	SETS = 4,
	FIXED = 8
}; /* bytes reserved for a data set; sets of an element, of the box */
enum { MOST_RANK = 3 };

struct file {
	struct tsim *sim;
	const char *path;
	const struct ts_place *where;
	struct ts_h5file h5;
	char reason[160]; /* innermost message of the library */
};

/* A data set with a row for each frame. */
struct layout {
	const char *name;
	hid_t type;
	int rank;
	hsize_t size[MOST_RANK - 1]; /* of a row */
	bool grows;		     /* size[0] may differ between frames */
	double missing;		     /* value of what a frame does not have */
};

bool ts_h5md_available(void)
{
	return true;
}

/* ---- errors ---- */

static herr_t take_reason(unsigned n, const H5E_error2_t *error, void *data)
{
	struct file *f = data;

	if (n == 0)
		snprintf(f->reason, sizeof f->reason, "%s", error->desc ? error->desc : "");
	return 0;
}

static enum ts_status fail(struct file *f, const char *what)
{
	int code = errno;

	H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, take_reason, f);
	errno = code;
	return ts_fail(&f->sim->error, TS_IO, f->where, "%s '%s' failed: %s", what, f->path,
		       f->reason[0] ? f->reason : ts_files_why(&f->sim->files));
}

/* ---- groups, attributes ---- */

static bool exists(hid_t at, const char *name)
{
	return H5Lexists(at, name, H5P_DEFAULT) > 0;
}

static hid_t open_group(hid_t at, const char *name)
{
	return exists(at, name) ? H5Gopen2(at, name, H5P_DEFAULT)
				: H5Gcreate2(at, name, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
}

static bool write_attribute(hid_t at, const char *name, hid_t type, hsize_t n, const void *value)
{
	hid_t space = n ? H5Screate_simple(1, &n, NULL) : H5Screate(H5S_SCALAR);
	hid_t attribute = H5Acreate2(at, name, type, space, H5P_DEFAULT, H5P_DEFAULT);
	bool good = attribute >= 0 && H5Awrite(attribute, type, value) >= 0;

	H5Aclose(attribute);
	H5Sclose(space);
	return good;
}

/* n texts of the same size, with their zeros; n 0: one, as a scalar. */
static bool write_texts(hid_t at, const char *name, hsize_t n, const char *text, size_t size)
{
	hid_t type = H5Tcopy(H5T_C_S1);
	bool good = H5Tset_size(type, size) >= 0 && write_attribute(at, name, type, n, text);

	H5Tclose(type);
	return good;
}

static bool write_text(hid_t at, const char *name, const char *text)
{
	return write_texts(at, name, 0, text, strlen(text) + 1);
}

static bool describe(hid_t file, const struct ts_h5md_frame *frame)
{
	static const int version[2] = { 1, 1 };
	hid_t head = open_group(file, "h5md"), author = open_group(head, "author");
	hid_t creator = open_group(head, "creator");
	bool good = write_attribute(head, "version", H5T_NATIVE_INT, 2, version) &&
		    write_text(author, "name", frame->author) && write_text(creator, "name", "tsim") &&
		    write_text(creator, "version", PACKAGE_VERSION);

	H5Gclose(creator);
	H5Gclose(author);
	return H5Gclose(head) >= 0 && good;
}

/* ---- data sets ---- */

static void set_chunks(hid_t properties, const struct layout *l)
{
	hsize_t chunk[MOST_RANK] = { l->rank == 1 || !l->grows ? FRAMES : 1, 1, 1 };

	for (int d = 1; d < l->rank; d++)
		chunk[d] = l->size[d - 1];
	if (l->grows)
		chunk[1] = l->size[0] < 1 ? 1 : l->size[0] < ROWS ? l->size[0] : ROWS;
	H5Pset_chunk(properties, l->rank, chunk);
	/* compressed chunks that change would be moved, and leave holes */
	if (l->grows && H5Zfilter_avail(H5Z_FILTER_DEFLATE) > 0) {
		H5Pset_shuffle(properties);
		H5Pset_deflate(properties, LEVEL);
	}
	H5Pset_fill_value(properties, H5T_NATIVE_DOUBLE, &l->missing);
}

static hid_t create_set(hid_t at, const struct layout *l)
{
	hid_t properties = H5Pcreate(H5P_DATASET_CREATE), space, set;
	hsize_t now[MOST_RANK] = { 0 }, most[MOST_RANK] = { H5S_UNLIMITED };

	for (int d = 1; d < l->rank; d++)
		now[d] = most[d] = l->size[d - 1];
	if (l->grows)
		most[1] = H5S_UNLIMITED;
	set_chunks(properties, l);
	space = H5Screate_simple(l->rank, now, most);
	set = H5Dcreate2(at, l->name, l->type, space, H5P_DEFAULT, properties, H5P_DEFAULT);
	H5Sclose(space);
	H5Pclose(properties);
	return set;
}

/* *now: the extent. Fails if the set has another shape than the layout. */
static enum ts_status check_set(struct file *f, hid_t set, const struct layout *l, hsize_t now[MOST_RANK])
{
	hid_t space = H5Dget_space(set);
	bool same = H5Sget_simple_extent_ndims(space) == l->rank;

	if (same)
		H5Sget_simple_extent_dims(space, now, NULL);
	H5Sclose(space);
	for (int d = 1; d < l->rank && same; d++)
		same = now[d] == l->size[d - 1] || (d == 1 && l->grows);
	if (same)
		return TS_OK;
	return ts_fail(&f->sim->error, TS_STATE, f->where,
		       "cannot append to '%s': its quantities have other shapes than those of this dump",
		       f->path);
}

static bool write_row(hid_t set, const struct layout *l, hsize_t row, hid_t type, const void *data)
{
	hsize_t first[MOST_RANK] = { row }, count[MOST_RANK] = { 1 };
	hid_t file = H5Dget_space(set), memory;
	bool good;

	for (int d = 1; d < l->rank; d++)
		count[d] = l->size[d - 1];
	memory = H5Screate_simple(l->rank, count, NULL);
	good = H5Sselect_hyperslab(file, H5S_SELECT_SET, first, NULL, count, NULL) >= 0 &&
	       H5Dwrite(set, type, memory, file, H5P_DEFAULT, data) >= 0;
	H5Sclose(memory);
	H5Sclose(file);
	return good;
}

static enum ts_status store_row(struct file *f, hid_t set, const struct layout *l, hsize_t row, hid_t type,
				const void *data)
{
	hsize_t now[MOST_RANK];
	bool good = true;

	TS_TRY(check_set(f, set, l, now));
	if (now[0] > row) { /* removes later rows, so that what this one does not have is missing */
		now[0] = row;
		good = H5Dset_extent(set, now) >= 0;
	}
	now[0] = row + 1;
	if (l->grows && l->size[0] > now[1])
		now[1] = l->size[0];
	good = good && H5Dset_extent(set, now) >= 0;
	if (good && (l->rank == 1 || l->size[0]))
		good = write_row(set, l, row, type, data);
	return good ? TS_OK : fail(f, "writing");
}

static enum ts_status put_row(struct file *f, hid_t at, const struct layout *l, hsize_t row, hid_t type,
			      const void *data)
{
	bool there = exists(at, l->name);
	hid_t set = there ? H5Dopen2(at, l->name, H5P_DEFAULT) : create_set(at, l);
	enum ts_status status = set < 0 ? fail(f, "writing") : TS_OK;

	if (status == TS_OK)
		status = store_row(f, set, l, row, type, data);
	if (set >= 0 && H5Dclose(set) < 0 && status == TS_OK)
		status = fail(f, "writing");
	return status;
}

/* *row: the number of rows of an element with steps before this one. */
static enum ts_status find_row(struct file *f, hid_t element, int64_t step, hsize_t *row)
{
	hid_t set, space;
	int64_t *steps;
	hssize_t n;
	bool good;

	*row = 0;
	if (!exists(element, "step"))
		return TS_OK;
	set = H5Dopen2(element, "step", H5P_DEFAULT);
	space = H5Dget_space(set);
	n = H5Sget_simple_extent_npoints(space);
	steps = ts_alloc(n > 0 ? (size_t)n : 1, sizeof *steps);
	good = steps && n >= 0 &&
	       (n == 0 || H5Dread(set, H5T_NATIVE_INT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, steps) >= 0);
	while (good && *row < (hsize_t)n && steps[*row] < step)
		++*row;
	H5Sclose(space);
	H5Dclose(set);
	if (!steps)
		return ts_nomem(&f->sim->error);
	ts_free(steps);
	return good ? TS_OK : fail(f, "reading");
}

/* ---- a frame ---- */

/* Steps and times of an element: its own, or those of the group, by hard links. */
static enum ts_status put_time(struct file *f, hid_t element, hid_t common, const struct ts_h5md_frame *frame,
			       hsize_t row)
{
	struct layout step = { .name = "step", .type = H5T_STD_I64LE, .rank = 1, .missing = -1 };
	struct layout time = { .name = "time", .type = H5T_IEEE_F64LE, .rank = 1, .missing = NAN };

	if (common >= 0 && exists(element, "step"))
		return TS_OK;
	if (common >= 0)
		return H5Lcreate_hard(common, "step", element, "step", H5P_DEFAULT, H5P_DEFAULT) >= 0 &&
				       H5Lcreate_hard(common, "time", element, "time", H5P_DEFAULT,
						      H5P_DEFAULT) >= 0
			       ? TS_OK
			       : fail(f, "writing");
	TS_TRY(put_row(f, element, &step, row, H5T_NATIVE_INT64, &frame->step));
	return put_row(f, element, &time, row, H5T_NATIVE_DOUBLE, &frame->time);
}

/* Adds the value of an element, of the row that its steps have, and its step. `common` < 0: it has its own. */
static enum ts_status put_value(struct file *f, hid_t group, hid_t common, const struct ts_h5md_frame *frame,
				hsize_t row, const char *name, const struct layout *l, const double *data)
{
	bool begins = !exists(group, name);
	hid_t element = open_group(group, name);
	enum ts_status status = element < 0 ? fail(f, "writing") : TS_OK;

	if (begins && row > 0 && common >= 0)
		status = ts_fail(&f->sim->error, TS_STATE, f->where,
				 "cannot append to '%s': its frames have no '%s'", f->path, name);
	if (status == TS_OK && common < 0)
		status = find_row(f, element, frame->step, &row);
	if (status == TS_OK)
		status = put_row(f, element, l, row, H5T_NATIVE_DOUBLE, data);
	if (status == TS_OK)
		status = put_time(f, element, common, frame, row);
	H5Gclose(element);
	return status;
}

static enum ts_status put_element(struct file *f, hid_t group, hid_t common,
				  const struct ts_h5md_frame *frame, hsize_t row,
				  const struct ts_h5md_element *e)
{
	struct layout l = {
		.name = "value",
		.type = e->integer ? H5T_STD_I32LE : H5T_IEEE_F64LE,
		.rank = e->components > 1 ? 3 : 2,
		.size = { frame->n, e->components },
		.grows = true,
		.missing = e->integer ? -1 : NAN,
	};

	return put_value(f, group, common, frame, row, e->name, &l, e->data);
}

static bool describe_box(hid_t box, const struct ts_h5md_frame *frame)
{
	static const int dimension = 3;
	char face[3][9] = { "", "", "" };

	if (H5Aexists(box, "dimension") > 0)
		return true;
	for (int d = 0; d < 3; d++)
		snprintf(face[d], sizeof face[d], "%s", frame->periodic[d] ? "periodic" : "none");
	return write_attribute(box, "dimension", H5T_NATIVE_INT, 0, &dimension) &&
	       write_texts(box, "boundary", 3, face[0], sizeof face[0]);
}

static enum ts_status put_box(struct file *f, hid_t group, hid_t common, const struct ts_h5md_frame *frame,
			      hsize_t row)
{
	struct layout l = {
		.name = "value", .type = H5T_IEEE_F64LE, .rank = 2, .size = { 3, 3 }, .missing = NAN
	};
	double length[3];
	hid_t box = open_group(group, "box");
	enum ts_status status = box < 0 || !describe_box(box, frame) ? fail(f, "writing") : TS_OK;

	for (int d = 0; d < 3; d++)
		length[d] = frame->edges[d][d];
	if (status == TS_OK)
		status = put_value(f, box, common, frame, row, "offset", &l, frame->offset);
	l.rank = frame->sheared ? 3 : 2;
	if (status == TS_OK)
		status = put_value(f, box, common, frame, row, "edges", &l,
				   frame->sheared ? frame->edges[0] : length);
	H5Gclose(box);
	return status;
}

/* The first element has the steps of all that are not apart. */
static enum ts_status put_frame(struct file *f, hid_t group, const struct ts_h5md_frame *frame)
{
	bool begins = !exists(group, frame->element[0].name);
	hid_t common = open_group(group, frame->element[0].name);
	enum ts_status status = common < 0 ? fail(f, "writing") : TS_OK;
	hsize_t row = 0;

	if (status == TS_OK && !begins)
		status = find_row(f, common, frame->step, &row);
	if (status == TS_OK)
		status = put_element(f, group, -1, frame, row, &frame->element[0]);
	if (status == TS_OK)
		status = put_box(f, group, common, frame, row);
	for (size_t k = 1; k < frame->nelements && status == TS_OK; k++)
		status = put_element(f, group, frame->element[k].apart ? -1 : common, frame, row,
				     &frame->element[k]);
	H5Gclose(common);
	return status;
}

static enum ts_status put_group(struct file *f, const struct ts_h5md_frame *frame)
{
	hid_t particles = open_group(f->h5.id, "particles"), group = open_group(particles, frame->group);
	enum ts_status status = group < 0 ? fail(f, "writing") : put_frame(f, group, frame);

	H5Gclose(group);
	H5Gclose(particles);
	return status;
}

/* ---- the file ---- */

/* Opens the file, or creates it, and then adds to it. */
static enum ts_status change_file(struct file *f, const struct ts_h5md_frame *frame, bool create)
{
	FILE *file = ts_files_open(&f->sim->files, f->path, create ? "w+" : "r+");
	enum ts_status status = TS_OK;

	if (!file)
		return fail(f, "writing");
	f->h5 = (struct ts_h5file){ 0 };
	if (ts_h5file_open(&f->h5, file, f->path, create) < 0)
		status = fail(f, "opening");
	else if (create && !describe(f->h5.id, frame))
		status = fail(f, "writing");
	if (status == TS_OK)
		status = put_group(f, frame);
	if (ts_h5file_close(&f->h5, status == TS_OK))
		return status;
	if (f->h5.error) { /* the reason of what the library tells */
		ts_error_clear(&f->sim->error);
		f->reason[0] = 0;
		H5Eclear2(H5E_DEFAULT);
		errno = f->h5.error;
		return fail(f, "writing");
	}
	return status == TS_OK ? fail(f, "writing") : status;
}

static enum ts_status append(struct file *f, const struct ts_h5md_frame *frame, bool fresh)
{
	struct stat info;

	ts_mkdirs_for(&f->sim->files, f->path); /* an error shows when the file is opened */
	if (fresh || ts_files_stat(&f->sim->files, f->path, &info) != 0 || info.st_size == 0)
		return change_file(f, frame, true);
	if (H5Fis_hdf5(f->path) > 0)
		return change_file(f, frame, false);
	return ts_fail(&f->sim->error, TS_DAMAGED, f->where,
		       "cannot append to '%s': it is not an HDF5 file, or it is damaged", f->path);
}

enum ts_status ts_h5md_append(struct tsim *sim, const char *path, const struct ts_place *where,
			      const struct ts_h5md_frame *frame, bool fresh)
{
	struct file f = { .sim = sim, .path = path, .where = where };
	H5E_auto2_t print;
	void *print_data;
	enum ts_status status;

	if (ts_files_closed(&sim->files))
		return ts_fail(&sim->error, TS_STATE, where,
			       "HDF5 files cannot be written with -sandbox: their library opens files "
			       "itself");
	H5Eget_auto2(H5E_DEFAULT, &print, &print_data);
	H5Eset_auto2(H5E_DEFAULT, NULL, NULL); /* errors are reported here */
	status = append(&f, frame, fresh);
	H5Eclear2(H5E_DEFAULT);
	H5Eset_auto2(H5E_DEFAULT, print, print_data);
	return status;
}
#else
#include "base/banned.h"

bool ts_h5md_available(void)
{
	return false;
}

enum ts_status ts_h5md_append(struct tsim *sim, const char *path, const struct ts_place *where,
			      const struct ts_h5md_frame *frame, bool fresh)
{
	(void)frame;
	(void)fresh;
	return ts_fail(&sim->error, TS_STATE, where, "cannot write '%s': this tsim was built without HDF5",
		       path);
}
#endif
