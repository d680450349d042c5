#include "io/vtkhdf.h"

#include "io/h5out.h"

#ifdef TS_WITH_HDF5
#include <stdio.h>
#include <string.h>

#include "base/banned.h"

enum { LEVEL = 1 };				 /* of compression */
enum { LEAST_CHUNK = 1 << 10, CHUNK = 1 << 16 }; /* rows */
enum { STEPS_CHUNK = 256 };

/* Rows of a data set. */
struct rows {
	const char *name;
	hid_t type;	/* in the file and in memory */
	size_t columns; /* 0: a number for each row */
	hsize_t first, n;
	const void *data;
};

/* Where the frame goes: frames, points, cells and numbers of points of cells before it. */
struct place {
	hsize_t frame, points, cells, ids;
};

static hid_t create_set(hid_t at, const struct rows *r, bool of_steps)
{
	hid_t properties = H5Pcreate(H5P_DATASET_CREATE), space, set;
	hsize_t now[2] = { 0, r->columns }, most[2] = { H5S_UNLIMITED, r->columns };
	hsize_t chunk[2] = { r->n < LEAST_CHUNK ? LEAST_CHUNK : r->n > CHUNK ? CHUNK : r->n, r->columns };
	int rank = r->columns ? 2 : 1;

	chunk[0] = of_steps ? STEPS_CHUNK : chunk[0];
	H5Pset_chunk(properties, rank, chunk);
	/* chunks as long as a frame: compressed ones that change later would be moved, and leave holes */
	if (!of_steps && H5Zfilter_avail(H5Z_FILTER_DEFLATE) > 0) {
		H5Pset_shuffle(properties);
		H5Pset_deflate(properties, LEVEL);
	}
	space = H5Screate_simple(rank, now, most);
	set = H5Dcreate2(at, r->name, r->type, space, H5P_DEFAULT, properties, H5P_DEFAULT);
	H5Sclose(space);
	H5Pclose(properties);
	return set;
}

static bool has_shape(hid_t set, const struct rows *r)
{
	hid_t space = H5Dget_space(set);
	hsize_t now[8] = { 0 };
	int rank = H5Sget_simple_extent_ndims(space);
	bool same = rank == (r->columns ? 2 : 1) && H5Sget_simple_extent_dims(space, now, NULL) == rank &&
		    (rank == 1 || now[1] == r->columns) && now[0] >= r->first;

	H5Sclose(space);
	return same;
}

/* Later rows are removed. */
static bool store_rows(hid_t set, const struct rows *r)
{
	hsize_t first[2] = { r->first, 0 }, n[2] = { r->n, r->columns },
		size[2] = { r->first + r->n, r->columns };
	hid_t file, memory;
	bool good;

	if (H5Dset_extent(set, size) < 0)
		return false;
	if (!r->n)
		return true;
	file = H5Dget_space(set);
	memory = H5Screate_simple(r->columns ? 2 : 1, n, NULL);
	good = H5Sselect_hyperslab(file, H5S_SELECT_SET, first, NULL, n, NULL) >= 0 &&
	       H5Dwrite(set, r->type, memory, file, H5P_DEFAULT, r->data) >= 0;
	H5Sclose(memory);
	H5Sclose(file);
	return good;
}

static enum ts_status put_rows(struct ts_h5out *f, hid_t at, const struct rows *r, bool of_steps)
{
	bool there = ts_h5out_exists(at, r->name);
	hid_t set = there ? H5Dopen2(at, r->name, H5P_DEFAULT) : create_set(at, r, of_steps);
	enum ts_status status = TS_OK;

	if (set < 0)
		return ts_h5out_fail(f, "writing");
	if (!has_shape(set, r))
		status = ts_fail(&f->sim->error, TS_STATE, f->where,
				 "cannot append to '%s': its frames have no '%s' of this shape", f->path,
				 r->name);
	else if (!store_rows(set, r))
		status = ts_h5out_fail(f, "writing");
	if (H5Dclose(set) < 0 && status == TS_OK)
		status = ts_h5out_fail(f, "writing");
	return status;
}

/* A number of the frame. */
static enum ts_status put_count(struct ts_h5out *f, hid_t at, const char *name, hsize_t frame, hsize_t value,
				bool of_steps)
{
	int64_t number = (int64_t)value;

	return put_rows(f, at, &(struct rows){ name, H5T_NATIVE_INT64, 0, frame, 1, &number }, of_steps);
}

/* ---- what the file has */

/* Reads the first n numbers of a set; n < 0: all. The caller frees them. *n: how many. */
static int64_t *read_numbers(hid_t at, const char *name, hssize_t *n)
{
	hid_t set = ts_h5out_exists(at, name) ? H5Dopen2(at, name, H5P_DEFAULT) : -1;
	hid_t space = set >= 0 ? H5Dget_space(set) : -1;
	hssize_t have = space >= 0 ? H5Sget_simple_extent_npoints(space) : 0;
	int64_t *number = ts_alloc(have > 0 ? (size_t)have : 1, sizeof *number);

	*n = have;
	if (number && have > 0 && H5Dread(set, H5T_NATIVE_INT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, number) < 0)
		*n = -1;
	if (space >= 0)
		H5Sclose(space);
	if (set >= 0)
		H5Dclose(set);
	return number;
}

/* The sum of the first `frames` numbers. */
static bool sum_numbers(hid_t at, const char *name, hsize_t frames, hsize_t *sum)
{
	hssize_t n;
	int64_t *number = read_numbers(at, name, &n);
	bool good = number && n >= (hssize_t)frames;

	*sum = 0;
	for (hsize_t k = 0; good && k < frames; k++)
		*sum += (hsize_t)number[k];
	ts_free(number);
	return good;
}

static enum ts_status find_place(struct ts_h5out *f, hid_t root, struct place *to)
{
	hid_t own = ts_h5out_group(f->h5.id, "tsim");
	hssize_t n;
	int64_t *step = read_numbers(own, "step", &n);
	bool good = step && n >= 0;

	H5Gclose(own);
	*to = (struct place){ 0 };
	while (good && (hssize_t)to->frame < n && step[to->frame] < f->sim->clock.step)
		to->frame++;
	ts_free(step);
	good = good && sum_numbers(root, "NumberOfPoints", to->frame, &to->points) &&
	       sum_numbers(root, "NumberOfCells", to->frame, &to->cells) &&
	       sum_numbers(root, "NumberOfConnectivityIds", to->frame, &to->ids);
	return good ? TS_OK : ts_h5out_fail(f, "reading");
}

/* ---- a frame */

/* Points of the cells, which they do not share: 0, 1, 2 ...; where each cell begins; the types of VTK. */
static enum ts_status put_cells(struct ts_h5out *f, hid_t root, const struct ts_vtk_poly *poly,
				const struct place *to)
{
	static const unsigned char types[] = { 0, 1 /* vertex */, 3 /* line */, 5 /* triangle */,
					       9 /* quad */ };
	size_t size = ts_vtk_cell_size(poly), cells = poly->npoints / size;
	int64_t *number = ts_alloc(cells * size + 1, sizeof *number);
	unsigned char *type = ts_alloc(cells + 1, 1);
	enum ts_status status = number && type ? TS_OK : ts_nomem(&f->sim->error);

	for (size_t k = 0; status == TS_OK && k < cells * size; k++)
		number[k] = (int64_t)k;
	if (status == TS_OK)
		status = put_rows(f, root,
				  &(struct rows){ "Connectivity", H5T_NATIVE_INT64, 0, to->ids, cells * size,
						  number },
				  false);
	for (size_t k = 0; status == TS_OK && k <= cells; k++)
		number[k] = (int64_t)(k * size);
	for (size_t k = 0; status == TS_OK && k < cells; k++)
		type[k] = types[size];
	if (status == TS_OK) /* each frame has one more offset than cells */
		status = put_rows(f, root,
				  &(struct rows){ "Offsets", H5T_NATIVE_INT64, 0, to->cells + to->frame,
						  cells + 1, number },
				  false);
	if (status == TS_OK)
		status = put_rows(f, root,
				  &(struct rows){ "Types", H5T_NATIVE_UCHAR, 0, to->cells, cells, type },
				  false);
	ts_free(number);
	ts_free(type);
	return status;
}

/* An array of whole numbers is stored as such. */
static enum ts_status put_array(struct ts_h5out *f, hid_t at, const char *name, const struct ts_vtk_array *a,
				hsize_t first, size_t n)
{
	struct rows r = { name, H5T_NATIVE_DOUBLE, a->components > 1 ? a->components : 0, first, n, a->data };
	int64_t *number;
	enum ts_status status;

	if (!a->integer)
		return put_rows(f, at, &r, false);
	number = ts_alloc(n * a->components + 1, sizeof *number);
	if (!number)
		return ts_nomem(&f->sim->error);
	for (size_t k = 0; k < n * a->components; k++)
		number[k] = (int64_t)a->data[k];
	r.type = H5T_NATIVE_INT64;
	r.data = number;
	status = put_rows(f, at, &r, false);
	ts_free(number);
	return status;
}

static hsize_t links_of(hid_t group)
{
	H5G_info_t info = { 0 };

	return H5Gget_info(group, &info) >= 0 ? info.nlinks : 0;
}

/* The arrays of the points or of the cells, and where those of this frame begin. */
static enum ts_status put_data(struct ts_h5out *f, hid_t root, hid_t steps, const char *kind,
			       const struct ts_vtk_array *array, size_t narrays, const struct place *to,
			       hsize_t first, size_t n)
{
	enum ts_status status = TS_OK;
	char offsets[32], name[256];
	hid_t data, places;

	snprintf(offsets, sizeof offsets, "%sOffsets", kind);
	data = ts_h5out_group(root, kind);
	places = ts_h5out_group(steps, offsets);
	if (to->frame && links_of(data) != narrays)
		status = ts_fail(&f->sim->error, TS_STATE, f->where,
				 "cannot append to '%s': its frames have other quantities than this dump",
				 f->path);
	for (size_t k = 0; k < narrays && status == TS_OK; k++) {
		snprintf(name, sizeof name, "%s", array[k].name);
		for (char *slash = name; (slash = strchr(slash, '/'));)
			*slash = '_'; /* it would be a group */
		status = put_array(f, data, name, &array[k], first, n);
		if (status == TS_OK)
			status = put_count(f, places, name, to->frame, first, true);
	}
	H5Gclose(places);
	H5Gclose(data);
	return status;
}

static bool set_number_of_steps(hid_t steps, int64_t n)
{
	if (H5Aexists(steps, "NSteps") > 0 && H5Adelete(steps, "NSteps") < 0)
		return false;
	return ts_h5out_attribute(steps, "NSteps", H5T_NATIVE_INT64, 0, &n);
}

static enum ts_status put_steps(struct ts_h5out *f, hid_t steps, const struct ts_vtk_poly *poly,
				const struct place *to)
{
	const struct {
		const char *name;
		hsize_t value;
	} count[] = { { "PartOffsets", to->frame },
		      { "NumberOfParts", 1 },
		      { "PointOffsets", to->points },
		      { "CellOffsets", to->cells },
		      { "ConnectivityIdOffsets", to->ids } };
	int64_t step = f->sim->clock.step;
	hid_t own = ts_h5out_group(f->h5.id, "tsim");
	enum ts_status status =
		put_rows(f, steps,
			 &(struct rows){ "Values", H5T_NATIVE_DOUBLE, 0, to->frame, 1, &poly->time }, true);

	for (size_t k = 0; k < sizeof count / sizeof *count && status == TS_OK; k++)
		status = put_count(f, steps, count[k].name, to->frame, count[k].value, true);
	if (status == TS_OK)
		status = put_rows(f, own, &(struct rows){ "step", H5T_NATIVE_INT64, 0, to->frame, 1, &step },
				  true);
	if (status == TS_OK && !set_number_of_steps(steps, (int64_t)to->frame + 1))
		status = ts_h5out_fail(f, "writing");
	H5Gclose(own);
	return status;
}

static enum ts_status put_grid(struct ts_h5out *f, hid_t root, const struct ts_vtk_poly *poly,
			       const struct place *to)
{
	size_t size = ts_vtk_cell_size(poly), cells = poly->npoints / size;

	TS_TRY(put_count(f, root, "NumberOfPoints", to->frame, poly->npoints, true));
	TS_TRY(put_count(f, root, "NumberOfCells", to->frame, cells, true));
	TS_TRY(put_count(f, root, "NumberOfConnectivityIds", to->frame, cells * size, true));
	TS_TRY(put_rows(f, root,
			&(struct rows){ "Points", H5T_NATIVE_DOUBLE, 3, to->points, poly->npoints,
					poly->points },
			false));
	return put_cells(f, root, poly, to);
}

static enum ts_status put_frame(struct ts_h5out *f, hid_t root, hid_t steps, const struct ts_vtk_poly *poly)
{
	size_t cells = poly->npoints / ts_vtk_cell_size(poly);
	struct place to;

	TS_TRY(find_place(f, root, &to));
	TS_TRY(put_grid(f, root, poly, &to));
	TS_TRY(put_data(f, root, steps, "PointData", poly->point_data, poly->npoint_data, &to, to.points,
			poly->npoints));
	TS_TRY(put_data(f, root, steps, "CellData", poly->cell_data, poly->ncell_data, &to, to.cells, cells));
	return put_steps(f, steps, poly, &to);
}

/* The attributes by which a reader knows the file. The text has no zero at its end, as in files of VTK. */
static bool describe(hid_t root)
{
	static const int64_t version[2] = { 2, 0 };
	static const char type[] = "UnstructuredGrid";
	hid_t text = H5Tcopy(H5T_C_S1), space = H5Screate(H5S_SCALAR), attribute;
	bool good = H5Tset_size(text, strlen(type)) >= 0 && H5Tset_strpad(text, H5T_STR_NULLPAD) >= 0;

	attribute = H5Acreate2(root, "Type", text, space, H5P_DEFAULT, H5P_DEFAULT);
	good = good && attribute >= 0 && H5Awrite(attribute, text, type) >= 0;
	H5Aclose(attribute);
	H5Sclose(space);
	H5Tclose(text);
	return good && ts_h5out_attribute(root, "Version", H5T_NATIVE_INT64, 2, version);
}

static enum ts_status write_frame(struct ts_h5out *f, bool created, const void *data)
{
	hid_t root, steps;
	enum ts_status status;

	if (!created && !ts_h5out_exists(f->h5.id, "VTKHDF"))
		return ts_fail(&f->sim->error, TS_DAMAGED, f->where,
			       "cannot append to '%s': it is an HDF5 file of another kind", f->path);
	root = ts_h5out_group(f->h5.id, "VTKHDF");
	steps = ts_h5out_group(root, "Steps");
	status = root < 0 || steps < 0 || (created && !describe(root)) ? ts_h5out_fail(f, "writing")
								       : put_frame(f, root, steps, data);
	H5Gclose(steps);
	H5Gclose(root);
	return status;
}

enum ts_status ts_vtkhdf_append(struct tsim *sim, const char *path, const struct ts_place *where,
				const struct ts_vtk_poly *poly, bool fresh)
{
	return sim->reading.explain ? TS_OK : ts_h5out_append(sim, path, where, fresh, write_frame, poly);
}
#else
#include "base/banned.h"

enum ts_status ts_vtkhdf_append(struct tsim *sim, const char *path, const struct ts_place *where,
				const struct ts_vtk_poly *poly, bool fresh)
{
	(void)poly;
	(void)fresh;
	return ts_fail(&sim->error, TS_STATE, where, "cannot write '%s': this tsim was built without HDF5",
		       path);
}
#endif
