#include "mesh/triangles.h"

#include "base/banned.h"

enum ts_status ts_triangles_add(struct ts_triangles *soup, const struct ts_triangle *t)
{
	TS_TRY(TS_GROW(soup->t, soup->capacity, soup->n + 1));
	soup->t[soup->n++] = *t;
	return TS_OK;
}

void ts_triangles_release(struct ts_triangles *soup)
{
	ts_free(soup->t);
	*soup = (struct ts_triangles){ 0 };
}
