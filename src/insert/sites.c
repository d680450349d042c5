#include "insert/sites.h"

#include <math.h>
#include <stdlib.h>

#include "base/sort.h"
#include "box/domain.h"
#include "math/rng.h"
#include "region/region.h"

#include "base/banned.h"

enum ts_status ts_sites_add(struct tsim *sim, struct ts_sites *sites, const double x[3], int type)
{
	struct ts_site *site;

	if (TS_GROW(sites->site, sites->capacity, sites->n + 1) != TS_OK)
		return ts_nomem(&sim->error);
	site = &sites->site[sites->n++];
	for (int d = 0; d < 3; d++)
		site->x[d] = x[d];
	site->type = type;
	return TS_OK;
}

void ts_sites_release(struct ts_sites *sites)
{
	ts_free(sites->site);
	*sites = (struct ts_sites){ 0 };
}

size_t ts_sites_first(const struct ts_sites *sites, size_t n, size_t *end)
{
	const size_t parts = sites->parts ? (size_t)sites->parts : 1,
		     part = sites->parts ? (size_t)sites->part : 0;

	*end = n * (part + 1) / parts;
	return n * part / parts;
}

static bool is_within(const double lo[3], const double hi[3], const double x[3])
{
	for (int d = 0; d < 3; d++)
		if (!(x[d] >= lo[d] && x[d] < hi[d]))
			return false;
	return true;
}

bool ts_sites_in_box(const struct tsim *sim, const double x[3])
{
	return is_within(sim->domain->box.lo, sim->domain->box.hi, x);
}

void ts_sites_limits(const struct tsim *sim, const struct ts_instance *region, double lo[3], double hi[3])
{
	const struct ts_box *box = &sim->domain->box;
	double a[3] = { -INFINITY, -INFINITY, -INFINITY }, b[3] = { INFINITY, INFINITY, INFINITY };

	if (region)
		ts_region_bounds(region, a, b);
	for (int d = 0; d < 3; d++) {
		lo[d] = fmax(box->lo[d], a[d]);
		hi[d] = fmin(box->hi[d], b[d]);
	}
}

/* Range of the lattice cells that intersect the box from lo to hi. */
static enum ts_status find_cells(struct tsim *sim, const double lo[3], const double hi[3],
				 const struct ts_place *where, long first[3], long last[3])
{
	double a[3] = { INFINITY, INFINITY, INFINITY }, b[3] = { -INFINITY, -INFINITY, -INFINITY };
	double cells = 1;

	for (int corner = 0; corner < 8; corner++) {
		double x[3], c[3];

		for (int d = 0; d < 3; d++)
			x[d] = corner >> d & 1 ? hi[d] : lo[d];
		ts_lattice_from_space(&sim->domain->lattice, x, c);
		for (int d = 0; d < 3; d++) {
			a[d] = fmin(a[d], c[d]);
			b[d] = fmax(b[d], c[d]);
		}
	}
	for (int d = 0; d < 3; d++) {
		a[d] = d < sim->dimension ? floor(a[d]) - 1 : 0;
		b[d] = d < sim->dimension ? ceil(b[d]) + 1 : 0;
		cells *= fmax(0, b[d] - a[d] + 1);
		if (!(cells <= 1e9) || fabs(a[d]) > 1e15 || fabs(b[d]) > 1e15)
			return ts_fail(&sim->error, TS_RANGE, where,
				       "create_atoms: the lattice has more than 1e9 cells here");
		first[d] = (long)a[d];
		last[d] = (long)b[d];
	}
	return TS_OK;
}

static enum ts_status fill_cell(struct tsim *sim, const struct ts_instance *region, const int *type_of_basis,
				const struct ts_box *fill, const long cell[3], struct ts_sites *sites)
{
	const struct ts_lattice *l = &sim->domain->lattice;
	const double *lo = sim->domain->box.lo;

	for (size_t k = 0; k < l->nbasis; k++) {
		double c[3], x[3];

		for (int d = 0; d < 3; d++)
			c[d] = (double)cell[d] + l->basis[k][d];
		ts_lattice_to_space(l, c, x);
		if (!is_within(fill->lo, fill->hi, x) || (region && !ts_region_contains(region, x)))
			continue;
		for (int d = 0; d < 3; d++)
			x[d] = fmax(x[d], lo[d]); /* removes rounding errors */
		TS_TRY(ts_sites_add(sim, sites, x, type_of_basis[k]));
	}
	return TS_OK;
}

enum ts_status ts_sites_on_lattice(struct tsim *sim, const struct ts_instance *region,
				   const int *type_of_basis, const struct ts_place *where,
				   struct ts_sites *sites)
{
	struct ts_box fill = sim->domain->box;
	double lo[3], hi[3];
	long first[3], last[3], c[3];
	size_t rows, end;

	ts_sites_limits(sim, region, lo, hi);
	for (int d = 0; d < 3; d++) {
		double slack = 1e-6 * ts_box_length(&fill, d);

		if (ts_box_periodic(&fill, d)) {
			fill.lo[d] -= slack;
			fill.hi[d] -= 2 * slack;
		}
		if (!(lo[d] <= hi[d]))
			return TS_OK;
	}
	TS_TRY(find_cells(sim, lo, hi, where, first, last));
	rows = (size_t)(last[1] - first[1] + 1);
	for (size_t k = ts_sites_first(sites, rows * (size_t)(last[2] - first[2] + 1), &end); k < end; k++) {
		c[2] = first[2] + (long)(k / rows);
		c[1] = first[1] + (long)(k % rows);
		if (sim->requests.stop)
			return ts_fail(&sim->error, TS_STOPPED, where,
				       "stopped on request: the lattice was not filled yet, no particle is "
				       "made");
		for (c[0] = first[0]; c[0] <= last[0]; c[0]++)
			TS_TRY(fill_cell(sim, region, type_of_basis, &fill, c, sites));
	}
	return TS_OK;
}

struct draw {
	double number;
	size_t index;
};

static int compare_draws(const void *a, const void *b)
{
	const struct draw *x = a, *y = b;

	if (x->number != y->number)
		return x->number < y->number ? -1 : 1;
	return (x->index > y->index) - (x->index < y->index);
}

/* Each site has a random number, a function of seed and index; the sites with the smallest are kept. */
enum ts_status ts_sites_choose(struct tsim *sim, struct ts_sites *sites, size_t count, uint64_t seed)
{
	struct draw *draw = ts_alloc(sites->n, sizeof *draw);
	unsigned char *is_kept = ts_alloc(sites->n, 1);
	size_t kept = 0;

	if (!draw || !is_kept) {
		ts_free(draw);
		ts_free(is_kept);
		return ts_nomem(&sim->error);
	}
	for (size_t k = 0; k < sites->n; k++) {
		struct ts_rng rng = ts_rng_start(seed, k);

		draw[k] = (struct draw){ ts_rng_uniform(&rng), k };
	}
	ts_sort(draw, sites->n, sizeof *draw, compare_draws);
	for (size_t k = 0; k < count && k < sites->n; k++)
		is_kept[draw[k].index] = 1;
	for (size_t k = 0; k < sites->n; k++)
		if (is_kept[k])
			sites->site[kept++] = sites->site[k];
	sites->n = kept;
	ts_free(draw);
	ts_free(is_kept);
	return TS_OK;
}
