#include "mesh/mesh_read.h"

#include <string.h>

#include "base/str.h"
#include "mesh/mesh_obj.h"
#include "mesh/mesh_scan.h"
#include "mesh/mesh_stl.h"
#include "mesh/mesh_vtk.h"

#include "base/banned.h"

static bool begins_with(const struct ts_scan *s, const char *text)
{
	return s->n - s->at >= strlen(text) && memcmp(s->bytes + s->at, text, strlen(text)) == 0;
}

static enum ts_status read_triangles(struct ts_scan *s, struct ts_triangles *soup)
{
	size_t before = soup->n;

	soup->file = s->file;
	if (begins_with(s, "# vtk DataFile"))
		TS_TRY(ts_vtk_triangles(s, soup));
	else if (ts_ends_with(s->file, ".obj") || ts_ends_with(s->file, ".obj.gz") ||
		 ts_ends_with(s->file, ".OBJ"))
		TS_TRY(ts_obj_read(s, soup));
	else
		TS_TRY(ts_stl_read(s, soup));
	if (soup->n == before)
		return ts_scan_refuse(s, TS_DAMAGED, "there are no triangles in '%s'", s->file);
	return TS_OK;
}

enum ts_status ts_mesh_read(struct ts_triangles *soup, struct ts_files *files, struct ts_error *err,
			    struct ts_pool *pool, const struct ts_place *where, const char *path)
{
	struct ts_scan s;
	enum ts_status status = ts_scan_open(&s, files, err, pool, where, path);

	if (status == TS_OK)
		status = read_triangles(&s, soup);
	ts_scan_close(&s);
	return status;
}

enum ts_status ts_mesh_parse(struct ts_triangles *soup, struct ts_error *err, struct ts_pool *pool,
			     const char *name, const char *bytes, size_t n)
{
	struct ts_scan s;

	TS_TRY(ts_scan_memory(&s, err, pool, name, bytes, n));
	return read_triangles(&s, soup);
}

enum ts_status ts_vtk_cells_read(struct ts_vtk_cells *cells, struct ts_files *files, struct ts_error *err,
				 struct ts_pool *pool, const struct ts_place *where, const char *path)
{
	struct ts_scan s;
	enum ts_status status = ts_scan_open(&s, files, err, pool, where, path);

	if (status == TS_OK && !begins_with(&s, "# vtk DataFile"))
		status = ts_scan_refuse(&s, TS_DAMAGED,
					"'%s' is no VTK file: it does not begin with '# vtk DataFile'", path);
	if (status == TS_OK)
		status = ts_vtk_read(&s, cells);
	ts_scan_close(&s);
	return status;
}
