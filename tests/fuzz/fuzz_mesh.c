/* Any bytes as a mesh: as OBJ, and as what they look like (STL, VTK). */
#include <math.h>
#include <stdlib.h>

#include "sandbox.h"

#include "base/str.h"
#include "mesh/mesh_read.h"

int LLVMFuzzerInitialize(int *argc, char ***argv)
{
	(void)argc;
	(void)argv;
	return 0;
}

/* What is read is finite, and what is refused has a message. */
static void parse(const char *name, const uint8_t *data, size_t size)
{
	struct ts_error err = { 0 };
	struct ts_triangles soup = { 0 };
	struct ts_pool *pool = ts_pool_new();

	if (!pool)
		return;
	if (ts_mesh_parse(&soup, &err, pool, name, (const char *)data, size) != TS_OK && !err.message[0])
		abort();
	for (size_t k = 0; k < 9 * soup.n; k++)
		if (!isfinite(soup.t[k / 9].v[k / 3 % 3][k % 3]))
			abort();
	ts_triangles_release(&soup);
	ts_pool_free(pool);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
	parse("input.stl", data, size);
	parse("input.obj", data, size);
	return 0;
}
