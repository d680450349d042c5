#include "geom/triangles.h"

#include <math.h>

#include "base/banned.h"

enum ts_status ts_triangles_add(struct ts_triangles *soup, const struct ts_triangle *t)
{
	TS_TRY(TS_GROW(soup->t, soup->capacity, soup->n + 1));
	soup->t[soup->n++] = *t;
	return TS_OK;
}

double ts_triangles_precision(const struct ts_triangles *soup)
{
	double lo[3] = { INFINITY, INFINITY, INFINITY }, hi[3] = { -INFINITY, -INFINITY, -INFINITY },
	       longest = 0;

	for (size_t t = 0; t < soup->n; t++)
		for (int k = 0; k < 9; k++) {
			lo[k % 3] = fmin(lo[k % 3], soup->t[t].v[k / 3][k % 3]);
			hi[k % 3] = fmax(hi[k % 3], soup->t[t].v[k / 3][k % 3]);
		}
	for (int d = 0; d < 3; d++)
		longest = fmax(longest, hi[d] - lo[d]);
	return longest > 0 ? 1e-7 * longest : 1;
}

void ts_triangles_release(struct ts_triangles *soup)
{
	ts_free(soup->t);
	*soup = (struct ts_triangles){ 0 };
}
