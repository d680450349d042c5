#include "geom/frustum.h"

#include <math.h>

#include "base/banned.h"

/* Nearest point on the side, a line segment in the half-plane. */
static void nearest_on_side(const struct ts_frustum *f, double r, double s,
			    struct ts_frustum_contact_point *out)
{
	double dr = f->radius[1] - f->radius[0], ds = f->hi - f->lo, t;

	*out = (struct ts_frustum_contact_point){ TS_FRUSTUM_SIDE, f->radius[0],
						  fmin(fmax(s, f->lo), f->hi) };
	if (dr == 0) /* a cylinder, which may be infinite */
		return;
	t = ((r - f->radius[0]) * dr + (s - f->lo) * ds) / (dr * dr + ds * ds);
	/* at the rims exactly: points nearest to them are as far from the end faces */
	if (t >= 1)
		*out = (struct ts_frustum_contact_point){ TS_FRUSTUM_SIDE, f->radius[1], f->hi };
	else if (t > 0)
		*out = (struct ts_frustum_contact_point){ TS_FRUSTUM_SIDE, f->radius[0] + t * dr,
							  f->lo + t * ds };
	else
		out->s = f->lo;
}

int ts_frustum_faces(const struct ts_frustum *f, unsigned open, double r, double s,
		     struct ts_frustum_contact_point out[TS_FRUSTUM_FACES])
{
	int n = 0;

	if (!(open & 1u << TS_FRUSTUM_SIDE))
		nearest_on_side(f, r, s, &out[n++]);
	if (!(open & 1u << TS_FRUSTUM_LOW) && isfinite(f->lo))
		out[n++] = (struct ts_frustum_contact_point){ TS_FRUSTUM_LOW, fmin(r, f->radius[0]), f->lo };
	if (!(open & 1u << TS_FRUSTUM_HIGH) && isfinite(f->hi))
		out[n++] = (struct ts_frustum_contact_point){ TS_FRUSTUM_HIGH, fmin(r, f->radius[1]), f->hi };
	return n;
}

int ts_frustum_nearest(const struct ts_frustum *f, unsigned open, double r, double s,
		       struct ts_frustum_contact_point *out)
{
	struct ts_frustum_contact_point faces[TS_FRUSTUM_FACES];
	int n = ts_frustum_faces(f, open, r, s, faces);
	double smallest = INFINITY;

	for (int k = 0; k < n; k++) {
		double dr = r - faces[k].r, ds = s - faces[k].s, d2 = dr * dr + ds * ds;

		if (!(d2 < smallest))
			continue;
		smallest = d2;
		*out = faces[k];
	}
	return n > 0;
}
