/* Compute temp/profile: temperature of the motion relative to the mean velocities of bins. */
#include <math.h>

#include "base/sort.h"
#include "group/temperature.h"
#include "math/exactsum.h"

#include "base/banned.h"

enum { X, Y, Z, XY, YZ, XZ, XYZ };

struct temp_profile {
	struct ts_freedom freedom; /* first: see group/temperature.h */
	int64_t along[3];	   /* components of the mean velocity that are subtracted */
	int binning, out;
	int64_t bins[3]; /* along the axes of the binning */

	/* results of the last evaluation */
	int64_t filled;	       /* bins with particles */
	double (*mean)[3];     /* [particle] mean velocity of its bin */
	uint64_t *key, *spare; /* [particle] bin and particle */
	size_t mean_capacity, key_capacity, spare_capacity;
};

static const struct {
	int n, axis[3];
} binnings[] = {
	[X] = { 1, { 0 } },	[Y] = { 1, { 1 } },	[Z] = { 1, { 2 } },	    [XY] = { 2, { 0, 1 } },
	[YZ] = { 2, { 1, 2 } }, [XZ] = { 2, { 0, 2 } }, [XYZ] = { 3, { 0, 1, 2 } },
};

enum { BINS_MOST = 1 << 30 }; /* 30 bits of a key */

static double number_of_bins(const struct temp_profile *c)
{
	double bins = 1;

	for (int k = 0; k < binnings[c->binning].n; k++)
		bins *= (double)c->bins[k];
	return bins;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	const struct temp_profile *c = self->state;
	const double bins = number_of_bins(c);

	for (int k = 0; k < binnings[c->binning].n; k++)
		if (sim->dimension == 2 && binnings[c->binning].axis[k] == 2 && c->bins[k] != 1)
			return ts_fail(&sim->error, TS_RANGE, &self->where,
				       "compute temp/profile: in two dimensions there is one bin along z");
	if (bins > BINS_MOST)
		return ts_fail(&sim->error, TS_RANGE, &self->where,
			       "compute temp/profile: %g bins, expected at most %d", bins, BINS_MOST);
	if (sim->dimension == 2 && c->along[2])
		return ts_fail(&sim->error, TS_RANGE, &self->where,
			       "compute temp/profile: in two dimensions there is no motion along z: expected "
			       "zflag 0");
	return TS_OK;
}

/* Bins divide the present box. Particles outside of it are in the nearest bin. */
static uint64_t bin_of(const struct tsim *sim, const struct temp_profile *c, size_t i)
{
	const struct ts_box *box = &sim->domain->box;
	uint64_t bin = 0;
	int32_t image[3];
	double x[3];

	ts_wrapped(sim, i, x, image);
	for (int k = binnings[c->binning].n; k-- > 0;) {
		const int d = binnings[c->binning].axis[k];
		const double at = (x[d] - box->lo[d]) / ts_box_length(box, d) * (double)c->bins[k];

		bin = bin * (uint64_t)c->bins[k] + (uint64_t)fmin(fmax(at, 0), (double)c->bins[k] - 1);
	}
	return bin;
}

/* Mean velocity of n particles of one bin, weighted by mass, for all of them. */
static void set_mean(const struct tsim *sim, struct temp_profile *c, const uint64_t *key, size_t n)
{
	const struct ts_particles *p = sim->particles;
	struct ts_exactsum sum[4] = { 0 };
	double mean[3], mass;

	for (size_t k = 0; k < n; k++) {
		const size_t i = (size_t)(key[k] & UINT32_MAX);

		for (int d = 0; d < 3; d++)
			ts_exactsum_add(&sum[d], p->mass[i] * p->v[i][d]);
		ts_exactsum_add(&sum[3], p->mass[i]);
	}
	mass = ts_exactsum_value(&sum[3]);
	for (int d = 0; d < 3; d++)
		mean[d] = c->along[d] && mass > 0 ? ts_exactsum_value(&sum[d]) / mass : 0;
	for (size_t k = 0; k < n; k++)
		for (int d = 0; d < 3; d++)
			c->mean[key[k] & UINT32_MAX][d] = mean[d];
	c->filled++;
}

static enum ts_status find_means(const struct ts_instance *self, const struct tsim *sim)
{
	const struct ts_particles *p = sim->particles;
	struct temp_profile *c = self->state;
	size_t n = 0;

	TS_TRY(TS_GROW(c->mean, c->mean_capacity, p->n + 1));
	TS_TRY(TS_GROW(c->key, c->key_capacity, p->n + 1));
	TS_TRY(TS_GROW(c->spare, c->spare_capacity, p->n + 1));
	for (size_t i = 0; i < p->n; i++)
		if (ts_in_group(p, i, self->group))
			c->key[n++] = bin_of(sim, c, i) << 32 | i;
	ts_sort_keys(c->key, c->spare, n);
	c->filled = 0;
	for (size_t from = 0, to = 0; from < n; from = to) {
		while (to < n && c->key[to] >> 32 == c->key[from] >> 32)
			to++;
		set_mean(sim, c, c->key + from, to - from);
	}
	return TS_OK;
}

static void less_mean(const struct tsim *sim, size_t i, const void *context, double u[3])
{
	const struct temp_profile *c = context;

	for (int d = 0; d < 3; d++)
		u[d] = sim->particles->v[i][d] - c->mean[i][d];
}

/* The mean velocity of each bin takes a degree of freedom for each of its components; LAMMPS takes D of each bin, also of those
 * without particles, and D more. */
static double missing(const struct tsim *sim, const struct temp_profile *c)
{
	if (sim->legacy == TS_LEGACY_LAMMPS)
		return sim->dimension * number_of_bins(c) +
		       (c->freedom.given ? c->freedom.missing : sim->dimension);
	return (double)((c->along[0] + c->along[1] + c->along[2]) * c->filled) +
	       (c->freedom.given ? c->freedom.missing : 0);
}

static enum ts_status eval_temperature(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct temp_profile *c = self->state;
	double sum[7];

	TS_TRY(find_means(self, sim));
	ts_temperature_tensor_in(sim, self->group, less_mean, c, sum);
	out->data[0] = ts_temperature_without(sim, sum, missing(sim, c));
	return TS_OK;
}

static enum ts_status eval_tensor(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	double sum[7];

	TS_TRY(find_means(self, sim));
	ts_temperature_tensor_in(sim, self->group, less_mean, self->state, sum);
	return ts_temperature_write_tensor(sum, out);
}

static void fini(struct ts_instance *self)
{
	struct temp_profile *c = self->state;

	ts_free(c->mean);
	ts_free(c->key);
	ts_free(c->spare);
}

#define BINS_ALONG(axis_, k)                                                                          \
	TS_INT("N" axis_, struct temp_profile, bins[k], .flags = TS_POSITIONAL, .range = TS_POSITIVE, \
	       .help = "number of bins along " axis_)

static const struct ts_arg x_args[] = { BINS_ALONG("x", 0), TS_ARGS_END };
static const struct ts_arg y_args[] = { BINS_ALONG("y", 0), TS_ARGS_END };
static const struct ts_arg z_args[] = { BINS_ALONG("z", 0), TS_ARGS_END };
static const struct ts_arg xy_args[] = { BINS_ALONG("x", 0), BINS_ALONG("y", 1), TS_ARGS_END };
static const struct ts_arg yz_args[] = { BINS_ALONG("y", 0), BINS_ALONG("z", 1), TS_ARGS_END };
static const struct ts_arg xz_args[] = { BINS_ALONG("x", 0), BINS_ALONG("z", 1), TS_ARGS_END };
static const struct ts_arg xyz_args[] = { BINS_ALONG("x", 0), BINS_ALONG("y", 1), BINS_ALONG("z", 2),
					  TS_ARGS_END };

static const struct ts_mode modes[] = {
	[X] = { "x", "bins along x", x_args },
	[Y] = { "y", "bins along y", y_args },
	[Z] = { "z", "bins along z", z_args },
	[XY] = { "xy", "bins along x and y", xy_args },
	[YZ] = { "yz", "bins along y and z", yz_args },
	[XZ] = { "xz", "bins along x and z", xz_args },
	[XYZ] = { "xyz", "bins along all axes", xyz_args },
	{ .name = NULL },
};

static const char *const outs[] = { "tensor", NULL };

static const struct ts_arg args[] = {
	TS_INT("xflag", struct temp_profile, along[0], .flags = TS_POSITIONAL, .range = TS_WITHIN, .lo = 0,
	       .hi = 1, .help = "1: the mean velocity along x is subtracted; 0: it is not"),
	TS_INT("yflag", struct temp_profile, along[1], .flags = TS_POSITIONAL, .range = TS_WITHIN, .lo = 0,
	       .hi = 1, .help = "the same for y"),
	TS_INT("zflag", struct temp_profile, along[2], .flags = TS_POSITIONAL, .range = TS_WITHIN, .lo = 0,
	       .hi = 1, .help = "the same for z"),
	TS_MODE("binning", struct temp_profile, binning, modes, .help = "how the box is divided"),
	TS_ENUM("out", struct temp_profile, out, outs, .fallback = "tensor",
		.help = "the vector is the kinetic tensor"),
	TS_ARGS_END,
};

static const struct ts_value values[] = {
	{ "temperature", "temperature", "temperature relative to the mean velocities", TS_SCALAR, 1, NULL,
	  eval_temperature },
	{ "tensor", "energy", "kinetic tensor: sum of m u_a u_b", TS_VECTOR, 6, ts_tensor_names,
	  eval_tensor },
	{ .name = NULL },
};

TS_STYLE(compute, ts_style, ts_compute_temp_profile)
const struct ts_style ts_compute_temp_profile = {
	.name = "temp/profile",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.summary = "Temperature relative to the mean velocities of bins",
	.doc = "Divides the present box into bins of equal size and subtracts from the velocity of each "
	       "particle the mean velocity of the particles of the group in its bin, weighted by mass, of f "
	       "components. With these velocities u\n\n"
	       "    T = sum m u^2 / ((D N - f B) k_B)\n\n"
	       "for N particles in D dimensions and B bins with particles, since each mean velocity that was "
	       "found from the particles takes f degrees of freedom. `compute_modify ID extra M` subtracts M "
	       "more. With `legacy lammps` D B + D or D B + M are subtracted, as in LAMMPS, where B are all "
	       "bins.\n\n"
	       "The bins must be so small that the flow is uniform in each, and hold many particles. The "
	       "temperatures of single bins are those of compute temp/chunk and, in velocity^2, of "
	       "temp/granular/chunk.",
	.example = "compute heat gas temp/profile 1 0 0 z 20",
	.cite = "D. J. Evans, G. P. Morriss, Phys. Rev. Lett. 56 (1986) 2172",
	.args = args,
	.state_size = sizeof(struct temp_profile),
	.init = init,
	.fini = fini,
	.values = values,
	.modify = ts_freedom_modify,
};
