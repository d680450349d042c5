#include "io/h5md.h"

#ifdef TS_WITH_HDF5
#include <math.h>
#include <string.h>

#include "io/h5out.h"

#include "base/banned.h"

enum { LEVEL = 1 };		       /* of compression */
enum { ROWS = 1 << 16, FRAMES = 256 }; /* particles, frames in a chunk */
enum {
	METADATA = 8192,
	SETS = 4,
	FIXED = 8
}; /* bytes reserved for a data set; sets of an element, of the box */
enum { MOST_RANK = 3 };

/* A data set with a row for each frame. */
struct layout {
	const char *name;
	hid_t type;
	int rank;
	hsize_t size[MOST_RANK - 1]; /* of a row */
	bool grows;		     /* size[0] may differ between frames */
	double missing;		     /* value of what a frame does not have */
};

static bool describe(hid_t file, const struct ts_h5md_frame *frame)
{
	static const int version[2] = { 1, 1 };
	hid_t head = ts_h5out_group(file, "h5md"), author = ts_h5out_group(head, "author");
	hid_t creator = ts_h5out_group(head, "creator");
	bool good = ts_h5out_attribute(head, "version", H5T_NATIVE_INT, 2, version) &&
		    ts_h5out_text(author, "name", frame->author) && ts_h5out_text(creator, "name", "tsim") &&
		    ts_h5out_text(creator, "version", PACKAGE_VERSION);

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
static enum ts_status check_set(struct ts_h5out *f, hid_t set, const struct layout *l, hsize_t now[MOST_RANK])
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

static enum ts_status store_row(struct ts_h5out *f, hid_t set, const struct layout *l, hsize_t row,
				hid_t type, const void *data)
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
	return good ? TS_OK : ts_h5out_fail(f, "writing");
}

static enum ts_status put_row(struct ts_h5out *f, hid_t at, const struct layout *l, hsize_t row, hid_t type,
			      const void *data)
{
	bool there = ts_h5out_exists(at, l->name);
	hid_t set = there ? H5Dopen2(at, l->name, H5P_DEFAULT) : create_set(at, l);
	enum ts_status status = set < 0 ? ts_h5out_fail(f, "writing") : TS_OK;

	if (status == TS_OK)
		status = store_row(f, set, l, row, type, data);
	if (set >= 0 && H5Dclose(set) < 0 && status == TS_OK)
		status = ts_h5out_fail(f, "writing");
	return status;
}

/* *row: the number of rows of an element with steps before this one. */
static enum ts_status find_row(struct ts_h5out *f, hid_t element, int64_t step, hsize_t *row)
{
	hid_t set, space;
	int64_t *steps;
	hssize_t n;
	bool good;

	*row = 0;
	if (!ts_h5out_exists(element, "step"))
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
	return good ? TS_OK : ts_h5out_fail(f, "reading");
}

/* ---- a frame ---- */

/* Steps and times of an element: its own, or those of the group, by hard links. */
static enum ts_status put_time(struct ts_h5out *f, hid_t element, hid_t common,
			       const struct ts_h5md_frame *frame, hsize_t row)
{
	struct layout step = { .name = "step", .type = H5T_STD_I64LE, .rank = 1, .missing = -1 };
	struct layout time = { .name = "time", .type = H5T_IEEE_F64LE, .rank = 1, .missing = NAN };

	if (common >= 0 && ts_h5out_exists(element, "step"))
		return TS_OK;
	if (common >= 0)
		return H5Lcreate_hard(common, "step", element, "step", H5P_DEFAULT, H5P_DEFAULT) >= 0 &&
				       H5Lcreate_hard(common, "time", element, "time", H5P_DEFAULT,
						      H5P_DEFAULT) >= 0
			       ? TS_OK
			       : ts_h5out_fail(f, "writing");
	TS_TRY(put_row(f, element, &step, row, H5T_NATIVE_INT64, &frame->step));
	return put_row(f, element, &time, row, H5T_NATIVE_DOUBLE, &frame->time);
}

/* Adds the value of an element, of the row that its steps have, and its step. `common` < 0: it has its own. */
static enum ts_status put_value(struct ts_h5out *f, hid_t group, hid_t common,
				const struct ts_h5md_frame *frame, hsize_t row, const char *name,
				const struct layout *l, const double *data)
{
	bool begins = !ts_h5out_exists(group, name);
	hid_t element = ts_h5out_group(group, name);
	enum ts_status status = element < 0 ? ts_h5out_fail(f, "writing") : TS_OK;

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

static enum ts_status put_element(struct ts_h5out *f, hid_t group, hid_t common,
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
	return ts_h5out_attribute(box, "dimension", H5T_NATIVE_INT, 0, &dimension) &&
	       ts_h5out_texts(box, "boundary", 3, face[0], sizeof face[0]);
}

static enum ts_status put_box(struct ts_h5out *f, hid_t group, hid_t common,
			      const struct ts_h5md_frame *frame, hsize_t row)
{
	struct layout l = {
		.name = "value", .type = H5T_IEEE_F64LE, .rank = 2, .size = { 3, 3 }, .missing = NAN
	};
	double length[3];
	hid_t box = ts_h5out_group(group, "box");
	enum ts_status status = box < 0 || !describe_box(box, frame) ? ts_h5out_fail(f, "writing") : TS_OK;

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
static enum ts_status put_frame(struct ts_h5out *f, hid_t group, const struct ts_h5md_frame *frame)
{
	bool begins = !ts_h5out_exists(group, frame->element[0].name);
	hid_t common = ts_h5out_group(group, frame->element[0].name);
	enum ts_status status = common < 0 ? ts_h5out_fail(f, "writing") : TS_OK;
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

static enum ts_status put_group(struct ts_h5out *f, const struct ts_h5md_frame *frame)
{
	hid_t particles = ts_h5out_group(f->h5.id, "particles"),
	      group = ts_h5out_group(particles, frame->group);
	enum ts_status status = group < 0 ? ts_h5out_fail(f, "writing") : put_frame(f, group, frame);

	H5Gclose(group);
	H5Gclose(particles);
	return status;
}

static enum ts_status write_frame(struct ts_h5out *f, bool created, const void *data)
{
	const struct ts_h5md_frame *frame = data;

	if (created && !describe(f->h5.id, frame))
		return ts_h5out_fail(f, "writing");
	return put_group(f, frame);
}

enum ts_status ts_h5md_append(struct tsim *sim, const char *path, const struct ts_place *where,
			      const struct ts_h5md_frame *frame, bool fresh)
{
	return ts_h5out_append(sim, path, where, fresh, write_frame, frame);
}
#else
#include "base/banned.h"

enum ts_status ts_h5md_append(struct tsim *sim, const char *path, const struct ts_place *where,
			      const struct ts_h5md_frame *frame, bool fresh)
{
	(void)frame;
	(void)fresh;
	return ts_fail(&sim->error, TS_STATE, where, "cannot write '%s': this tsim was built without HDF5",
		       path);
}
#endif
