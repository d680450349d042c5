/* Whether new particles overlap present ones, of all ranks. */
#include "insert/insertion.h"

#include "box/domain.h"
#include "particle/group_moments.h"
#include "particle/particles.h"

#include "base/banned.h"

/* Distances that differ by less than this part of them are taken to be equal, so that no rounding error leaves out a particle. */
static const double MARGIN = 1e-6;

struct sphere {
	double x[3], radius;
};

/* Space where centres of new particles are, which reach at most `reach` beyond them. */
struct space {
	const struct ts_box *box;
	const double *lo, *hi;
	double reach;
};

void ts_insertion_wrap(const struct ts_box *box, double x[3])
{
	int32_t image[3] = { 0 };

	ts_wrap_point(box, x, image);
}

/* Distance of x, or of its nearest periodic image, from the space along d; in a sheared box 0 along the flow. */
static double distance_along(const struct space *s, int d, double x)
{
	double length = ts_box_periodic(s->box, d) ? ts_box_length(s->box, d) : 0, least = INFINITY;

	if (s->box->shear.on && d == s->box->shear.flow)
		return 0;
	for (int turn = -1; turn <= 1; turn++) {
		double image = x + turn * length;

		least = fmin(least, fmax(0, fmax(s->lo[d] - image, image - s->hi[d])));
	}
	return least;
}

static bool is_near(const struct space *s, const double x[3], double radius)
{
	bool near = true;

	for (int d = 0; d < 3; d++)
		near &= distance_along(s, d, x[d]) <= (1 + MARGIN) * (s->reach + radius);
	return near;
}

/* Those of this rank that are near, wrapped into the box, and the largest one: periodic images are looked for as far as that reaches. */
static enum ts_status pack_near(const struct ts_particles *p, const struct space *s, struct ts_parcel *out)
{
	size_t largest = 0;

	for (size_t i = 1; i < p->n; i++)
		largest = p->radius[i] > p->radius[largest] ? i : largest;
	for (size_t i = 0; i < p->n; i++) {
		struct sphere one = { { p->x[i][0], p->x[i][1], p->x[i][2] }, p->radius[i] };

		ts_insertion_wrap(s->box, one.x);
		if (i == largest || is_near(s, one.x, one.radius))
			TS_TRY(ts_parcel_add(out, &one, sizeof one));
	}
	return TS_OK;
}

static enum ts_status add_spheres(struct ts_spherehash *occupied, const struct ts_parcel *from)
{
	const struct sphere *one = (const void *)from->data;

	for (size_t k = 0; k < from->n / sizeof *one; k++)
		TS_TRY(ts_spherehash_add(occupied, one[k].x, one[k].radius));
	return TS_OK;
}

double ts_insertion_reach(const struct ts_new_particles *list)
{
	double most = 0;

	for (size_t k = 0; k < list->n; k++)
		for (size_t m = 0; m < ts_insertion_spheres(&list->item[k]); m++)
			most = fmax(most, ts_insertion_sphere_reach(&list->item[k], m));
	return most;
}

enum ts_status ts_insertion_hash_near(struct tsim *sim, struct ts_spherehash *occupied, const double lo[3],
				      const double hi[3], double reach)
{
	const struct space space = { &sim->domain->box, lo, hi, reach };
	struct ts_parcel mine = { 0 }, all = { 0 };
	enum ts_status status = pack_near(sim->particles, &space, &mine);

	if (status == TS_OK && sim->division)
		status = ts_world_share(sim->world, &mine, &all);
	if (status == TS_OK)
		status = add_spheres(occupied, sim->division ? &all : &mine);
	ts_parcel_release(&mine);
	ts_parcel_release(&all);
	return status == TS_OK ? TS_OK : ts_nomem(&sim->error);
}

bool ts_insertion_overlaps(const struct tsim *sim, const struct ts_spherehash *occupied,
			   const struct ts_new_particle *one)
{
	for (size_t k = 0; k < ts_insertion_spheres(one); k++) {
		double x[3], radius = ts_insertion_sphere(one, k, x);

		ts_insertion_wrap(&sim->domain->box, x);
		if (ts_spherehash_overlaps_periodic(occupied, &sim->domain->box, x, radius))
			return true;
	}
	return false;
}

enum ts_status ts_insertion_hash_add(struct tsim *sim, struct ts_spherehash *occupied,
				     const struct ts_new_particle *one)
{
	for (size_t k = 0; k < ts_insertion_spheres(one); k++) {
		double x[3], radius = ts_insertion_sphere(one, k, x);

		ts_insertion_wrap(&sim->domain->box, x);
		if (ts_spherehash_add(occupied, x, radius) != TS_OK)
			return ts_nomem(&sim->error);
	}
	return TS_OK;
}
