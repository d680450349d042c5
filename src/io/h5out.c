#include "io/h5out.h"

#ifdef TS_WITH_HDF5
#include <errno.h>
#include <string.h>
#include <sys/stat.h>

#include "base/files_peers.h"
#include "base/mkdirs.h"

#include "base/banned.h"

static herr_t take_reason(unsigned n, const H5E_error2_t *error, void *data)
{
	struct ts_h5out *f = data;

	if (n == 0)
		snprintf(f->reason, sizeof f->reason, "%s", error->desc ? error->desc : "");
	return 0;
}

enum ts_status ts_h5out_fail(struct ts_h5out *f, const char *what)
{
	int code = errno;

	H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, take_reason, f);
	errno = code;
	return ts_fail(&f->sim->error, TS_IO, f->where, "%s '%s' failed: %s", what, f->path,
		       f->reason[0] ? f->reason : ts_files_why(&f->sim->files));
}

bool ts_h5out_exists(hid_t at, const char *name)
{
	return H5Lexists(at, name, H5P_DEFAULT) > 0;
}

hid_t ts_h5out_group(hid_t at, const char *name)
{
	return ts_h5out_exists(at, name) ? H5Gopen2(at, name, H5P_DEFAULT)
					 : H5Gcreate2(at, name, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
}

bool ts_h5out_attribute(hid_t at, const char *name, hid_t type, hsize_t n, const void *value)
{
	hid_t space = n ? H5Screate_simple(1, &n, NULL) : H5Screate(H5S_SCALAR);
	hid_t attribute = H5Acreate2(at, name, type, space, H5P_DEFAULT, H5P_DEFAULT);
	bool good = attribute >= 0 && H5Awrite(attribute, type, value) >= 0;

	H5Aclose(attribute);
	H5Sclose(space);
	return good;
}

bool ts_h5out_texts(hid_t at, const char *name, hsize_t n, const char *text, size_t size)
{
	hid_t type = H5Tcopy(H5T_C_S1);
	bool good = H5Tset_size(type, size) >= 0 && ts_h5out_attribute(at, name, type, n, text);

	H5Tclose(type);
	return good;
}

bool ts_h5out_text(hid_t at, const char *name, const char *text)
{
	return ts_h5out_texts(at, name, 0, text, strlen(text) + 1);
}

/* Opens the file, or creates it, and then adds to it. */
static enum ts_status change_file(struct ts_h5out *f, bool create, ts_h5out_fn *write, const void *data)
{
	FILE *file = ts_files_open(&f->sim->files, f->path, create ? "w+" : "r+");
	enum ts_status status;

	if (!file)
		return ts_h5out_fail(f, "writing");
	f->h5 = (struct ts_h5file){ 0 };
	if (ts_h5file_open(&f->h5, file, f->path, create) < 0)
		status = ts_h5out_fail(f, "opening");
	else
		status = write(f, create, data);
	if (ts_h5file_close(&f->h5, status == TS_OK))
		return status;
	if (f->h5.error) { /* the reason of what the library tells */
		ts_error_clear(&f->sim->error);
		f->reason[0] = 0;
		H5Eclear2(H5E_DEFAULT);
		errno = f->h5.error;
		return ts_h5out_fail(f, "writing");
	}
	return status == TS_OK ? ts_h5out_fail(f, "writing") : status;
}

struct frame {
	struct ts_h5out *f;
	bool fresh;
	ts_h5out_fn *write;
	const void *data;
};

static int append(void *frame)
{
	const struct frame *of = frame;
	struct ts_h5out *f = of->f;
	struct stat info;

	ts_mkdirs_for(&f->sim->files, f->path); /* an error shows when the file is opened */
	if (of->fresh || ts_files_stat(&f->sim->files, f->path, &info) != 0 || info.st_size == 0)
		return change_file(f, true, of->write, of->data);
	if (H5Fis_hdf5(f->path) > 0)
		return change_file(f, false, of->write, of->data);
	return ts_fail(&f->sim->error, TS_DAMAGED, f->where,
		       "cannot append to '%s': it is not an HDF5 file, or it is damaged", f->path);
}

enum ts_status ts_h5out_append(struct tsim *sim, const char *path, const struct ts_place *where, bool fresh,
			       ts_h5out_fn *write, const void *data)
{
	struct ts_h5out f = { .sim = sim, .path = path, .where = where };
	struct frame frame = { &f, fresh, write, data };
	H5E_auto2_t print;
	void *print_data;
	enum ts_status status;

	if (ts_files_closed(&sim->files))
		return ts_fail(&sim->error, TS_STATE, where,
			       "HDF5 files cannot be written with -sandbox: their library opens files "
			       "itself");
	if (!ts_h5_loads(f.reason, sizeof f.reason))
		return ts_fail(&sim->error, TS_STATE, where,
			       "writing '%s': the HDF5 library does not load: %s", path, f.reason);
	H5Eget_auto2(H5E_DEFAULT, &print, &print_data);
	H5Eset_auto2(H5E_DEFAULT, NULL, NULL); /* errors are reported here */
	status = (enum ts_status)ts_peers_by_first(&sim->files, append, &frame);
	if (status != TS_OK && sim->error.status == TS_OK) /* it is another rank that writes */
		status = ts_fail(&sim->error, status, where, "writing '%s' failed", path);
	H5Eclear2(H5E_DEFAULT);
	H5Eset_auto2(H5E_DEFAULT, print, print_data);
	return status;
}
#else
#include "base/banned.h"
#endif

bool ts_h5out_available(void)
{
#ifdef TS_WITH_HDF5
	return true;
#else
	return false;
#endif
}
