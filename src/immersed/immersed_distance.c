/* Distances of places from the surface of a body and of its periodic images. */
#include "immersed/immersed.h"

#include <math.h>

#include "base/banned.h"

struct places {
	size_t n;
	const double (*x)[3];
	double reach, *distance;
};

static enum ts_status lower(struct ts_solid *solid, size_t part, const double x[3], double reach,
			    double *distance)
{
	struct ts_solid_surface surface;
	enum ts_solid_side side;

	TS_TRY(solid->kind->find_surface(solid, 0, part, x, reach, &side, &surface));
	if (side == TS_SOLID_FAR)
		surface.distance = solid->kind->inside(solid, part, x) ? -reach : reach;
	*distance = fmin(*distance, surface.distance);
	return TS_OK;
}

/* Of the image of a part that is displaced by `shift`. */
static enum ts_status find_image(struct ts_solid *solid, size_t part, const double shift[3],
				 const struct places *p)
{
	double lo[3], hi[3];

	solid->kind->bounds(solid, part, lo, hi);
	for (size_t k = 0; k < p->n; k++) {
		double at[3];
		bool near = true;

		for (int d = 0; d < 3; d++) {
			at[d] = p->x[k][d] - shift[d];
			near &= at[d] > lo[d] - p->reach && at[d] < hi[d] + p->reach;
		}
		if (near)
			TS_TRY(lower(solid, part, at, p->reach, &p->distance[k]));
	}
	return TS_OK;
}

enum ts_status ts_immersed_distances(struct ts_solid *solid, const struct ts_grid *grid, size_t n,
				     const double (*x)[3], double reach, double *distance)
{
	const struct places places = { n, x, reach, distance };

	for (int image = 0; image < 27; image++) {
		const int step[3] = { image % 3 - 1, image / 3 % 3 - 1, image / 9 - 1 };
		double shift[3];
		bool exists = true;

		for (int d = 0; d < 3; d++) {
			shift[d] = step[d] * (grid->face[d][grid->n[d]] - grid->face[d][0]);
			exists &= step[d] == 0 || (grid->periodic[d] && d < grid->dimensions);
		}
		for (size_t part = 0; exists && part < solid->parts; part++)
			TS_TRY(find_image(solid, part, shift, &places));
	}
	return TS_OK;
}
