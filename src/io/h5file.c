#include "io/h5file.h"

#include "base/alloc.h"

#ifdef TS_WITH_HDF5
#include <errno.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/banned.h"

/* A driver of the library (its "virtual file layer"). */
struct driver {
	H5FD_t base; /* first: the library sees only this */
	struct ts_h5file *f;
	haddr_t end; /* of allocated addresses */
};

/* Driver information of a property list. */
struct link {
	struct ts_h5file *f;
};

static H5FD_t *open_driver(const char *name, unsigned flags, hid_t properties, haddr_t most)
{
	const struct link *link = H5Pget_driver_info(properties);
	struct driver *d = link ? ts_alloc(1, sizeof *d) : NULL;

	(void)name;
	(void)flags;
	(void)most;
	if (!d)
		return NULL;
	d->f = link->f;
	return &d->base;
}

static herr_t close_driver(H5FD_t *file)
{
	ts_free(file);
	return 0;
}

static herr_t query(const H5FD_t *file, unsigned long *flags)
{
	(void)file;
	*flags = H5FD_FEAT_AGGREGATE_METADATA | H5FD_FEAT_ACCUMULATE_METADATA | H5FD_FEAT_DATA_SIEVE |
		 H5FD_FEAT_AGGREGATE_SMALLDATA;
	return 0;
}

static haddr_t get_end(const H5FD_t *file, H5FD_mem_t type)
{
	(void)type;
	return ((const struct driver *)file)->end;
}

static herr_t set_end(H5FD_t *file, H5FD_mem_t type, haddr_t address)
{
	struct driver *d = (struct driver *)file;

	(void)type;
	d->end = d->f->end = address;
	return 0;
}

static haddr_t get_size(const H5FD_t *file, H5FD_mem_t type)
{
	(void)type;
	return ((const struct driver *)file)->f->size;
}

/* Reads bytes of the file; zeros behind its end. */
static int read_file(const struct ts_h5file *f, uint64_t at, size_t n, unsigned char *to)
{
	while (n) {
		ssize_t got = pread(fileno(f->file), to, n, (off_t)at);

		if (got < 0 && errno == EINTR)
			continue;
		if (got <= 0) {
			memset(to, 0, n);
			return got < 0 ? -1 : 0;
		}
		n -= (size_t)got;
		to += got;
		at += (uint64_t)got;
	}
	return 0;
}

static herr_t read_bytes(H5FD_t *file, H5FD_mem_t type, hid_t transfer, haddr_t at, size_t n, void *buffer)
{
	const struct ts_h5file *f = ((struct driver *)file)->f;
	unsigned char *to = buffer;

	(void)type;
	(void)transfer;
	if (read_file(f, at, n, to) != 0)
		return -1;
	for (size_t k = 0; k < f->nchanges; k++) {
		const struct ts_h5file_change *c = &f->change[k];
		uint64_t lo = c->at > at ? c->at : at, hi = c->at + c->n < at + n ? c->at + c->n : at + n;

		if (lo < hi)
			memcpy(to + (lo - at), c->byte + (lo - c->at), hi - lo);
	}
	return 0;
}

static int write_file(const struct ts_h5file *f, uint64_t at, size_t n, const unsigned char *from)
{
	while (n) {
		ssize_t done = pwrite(fileno(f->file), from, n, (off_t)at);

		if (done < 0 && errno == EINTR)
			continue;
		if (done <= 0)
			return done < 0 && errno ? errno : EIO;
		n -= (size_t)done;
		from += done;
		at += (uint64_t)done;
	}
	return 0;
}

static int hold_change(struct ts_h5file *f, uint64_t at, size_t n, const void *bytes)
{
	unsigned char *copy = ts_alloc(n, 1);

	if (!copy || TS_GROW(f->change, f->capacity, f->nchanges + 1) != TS_OK) {
		ts_free(copy);
		return ENOMEM;
	}
	memcpy(copy, bytes, n);
	f->change[f->nchanges++] = (struct ts_h5file_change){ at, n, copy };
	return 0;
}

/* Never fails: the library could not close the file after that. The failure is told by ts_h5file_close. */
static herr_t write_bytes(H5FD_t *file, H5FD_mem_t type, hid_t transfer, haddr_t at, size_t n,
			  const void *buffer)
{
	struct ts_h5file *f = ((struct driver *)file)->f;

	(void)type;
	(void)transfer;
	if (f->error)
		return 0;
	f->error = at < f->before ? hold_change(f, at, n, buffer) : write_file(f, at, n, buffer);
	if (!f->error && at + n > f->size)
		f->size = at + n;
	return 0;
}

static const H5FD_class_t driver_class = {
#if H5_VERSION_GE(1, 13, 0)
	.version = H5FD_CLASS_VERSION,
	.value = (H5FD_class_value_t)600, /* of drivers that are not registered with the HDF Group */
#endif
	.name = "tsim",
	.maxaddr = INT64_MAX,
	.fc_degree = H5F_CLOSE_STRONG,
	.fapl_size = sizeof(struct link),
	.open = open_driver,
	.close = close_driver,
	.query = query,
	.get_eoa = get_end,
	.set_eoa = set_end,
	.get_eof = get_size,
	.read = read_bytes,
	.write = write_bytes,
	.fl_map = H5FD_FLMAP_DICHOTOMY,
};

hid_t ts_h5file_open(struct ts_h5file *f, FILE *file, const char *path, bool create)
{
	hid_t properties = H5Pcreate(H5P_FILE_ACCESS);
	struct link link = { f };
	struct stat info;

	f->file = file;
	f->id = -1;
	f->driver = H5FDregister(&driver_class);
	if (fstat(fileno(file), &info) != 0)
		f->error = errno;
	else
		f->before = f->size = f->end = (uint64_t)info.st_size;
	if (!f->error && H5Pset_driver(properties, f->driver, &link) >= 0)
		f->id = create ? H5Fcreate(path, H5F_ACC_TRUNC, H5P_DEFAULT, properties)
			       : H5Fopen(path, H5F_ACC_RDWR, properties);
	H5Pclose(properties);
	return f->id;
}

static int write_changes(const struct ts_h5file *f)
{
	int error = 0;

	for (size_t k = 0; k < f->nchanges && !error; k++)
		error = write_file(f, f->change[k].at, f->change[k].n, f->change[k].byte);
	return error;
}

/* Bytes from..to of the file that all changes are within, whole pages. */
static void find_span(const struct ts_h5file *f, uint64_t page, uint64_t *from, uint64_t *to)
{
	*from = UINT64_MAX;
	*to = 0;
	for (size_t k = 0; k < f->nchanges; k++) {
		uint64_t first = f->change[k].at / page * page, end = f->change[k].at + f->change[k].n;

		*from = first < *from ? first : *from;
		*to = end > *to ? end : *to;
	}
}

/* Has the pages of all changes present, writable and with room on the disk, so that copying to them waits for nothing. */
static bool fetch_pages(const struct ts_h5file *f, unsigned char *map, uint64_t from, uint64_t page)
{
#ifdef MADV_POPULATE_WRITE
	for (size_t k = 0; k < f->nchanges; k++) {
		uint64_t first = f->change[k].at / page * page;

		if (madvise(map + (first - from), f->change[k].at + f->change[k].n - first,
			    MADV_POPULATE_WRITE) != 0)
			return false;
	}
	return true;
#else
	(void)f;
	(void)map;
	(void)from;
	(void)page;
	return false;
#endif
}

/* Makes the changes through a mapping of the file: a run that is killed is hardly ever within the microsecond that this takes, and
 * so leaves none or all of them, while it would often be between two writes. Returns whether they are made: not every file
 * can be mapped. */
static bool copy_changes(const struct ts_h5file *f)
{
	uint64_t page = (uint64_t)sysconf(_SC_PAGESIZE), from, to;
	unsigned char *map;
	bool present;

	find_span(f, page, &from, &to);
	if (from >= to || to > f->before)
		return false;
	map = mmap(NULL, to - from, PROT_READ | PROT_WRITE, MAP_SHARED, fileno(f->file), (off_t)from);
	if (map == MAP_FAILED)
		return false;
	present = fetch_pages(f, map, from, page);
	for (size_t k = 0; k < f->nchanges && present; k++)
		memcpy(map + (f->change[k].at - from), f->change[k].byte, f->change[k].n);
	munmap(map, to - from);
	return present;
}

/* The contents must be within the file before they are told to be longer. */
static int make_changes(const struct ts_h5file *f)
{
	int error = f->end > f->size && ftruncate(fileno(f->file), (off_t)f->end) != 0 ? errno : 0;

	if (!error && !copy_changes(f))
		error = write_changes(f);
	if (!error && f->end < f->size && ftruncate(fileno(f->file), (off_t)f->end) != 0)
		error = errno;
	return error;
}

bool ts_h5file_close(struct ts_h5file *f, bool keep)
{
	bool good = f->id >= 0 && H5Fclose(f->id) >= 0 && !f->error && keep;

	H5FDunregister(f->driver); /* not before: H5Fclose uses it to the end */
	if (good)
		f->error = make_changes(f);
	else if (ftruncate(fileno(f->file), (off_t)f->before) != 0 && !f->error)
		f->error = errno;
	if (fclose(f->file) != 0 && !f->error)
		f->error = errno;
	for (size_t k = 0; k < f->nchanges; k++)
		ts_free(f->change[k].byte);
	ts_free(f->change);
	f->change = NULL;
	f->nchanges = f->capacity = 0;
	return good && !f->error;
}
#else
#include "base/banned.h"
#endif
