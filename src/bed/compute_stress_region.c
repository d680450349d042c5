/* Compute stress/region: mean stress of the grains in a region (Love 1927, Weber 1966; with the part of each branch that is
 * in the region: Lutsko 1988, Cormier, Rickman, Delph 2001). */
#include <math.h>

#include "bond/bonds.h"
#include "box/domain.h"
#include "contact/contact_view.h"
#include "contact/virial.h"
#include "core/name_list.h"
#include "math/exactsum.h"
#include "particle/group_moments.h"
#include "region/region.h"
#include "wall/wall.h"

#include "base/banned.h"

struct state {
	struct ts_instance *region;
	struct ts_words words;
	double volume; /* NaN: that of the region */
	bool kinetic, pair, bond, wall;
	struct tsim *sim;
};

static const char *const parts[] = { "ke", "pair", "bond", "wall", NULL };

static enum ts_status read_parts(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	bool *const flag[] = { &s->kinetic, &s->pair, &s->bond, &s->wall };
	struct ts_name_list list = { 0 };

	TS_TRY(ts_name_list_read(sim, "compute stress/region", &self->arena, s->words, parts, sizeof *parts,
				 &list));
	for (int k = 0; k < 4; k++)
		*flag[k] = !list.n;
	for (size_t k = 0; k < list.n; k++)
		*flag[list.item[k]] = true;
	return TS_OK;
}

/* The volume by which the sums are divided. A region that sticks out of the box has none that would be known. */
static enum ts_status find_volume(struct ts_instance *self, struct tsim *sim, double *volume)
{
	const struct state *s = self->state;
	const struct ts_box *box = &sim->domain->box;
	double lo[3], hi[3];
	bool out = false;

	*volume = s->volume;
	if (!isnan(s->volume))
		return TS_OK;
	ts_region_bounds(s->region, lo, hi);
	for (int d = 0; d < 3; d++) {
		double rounding = 1e-9 * ts_box_length(box, d);

		out |= lo[d] < box->lo[d] - rounding || hi[d] > box->hi[d] + rounding;
	}
	*volume = ts_region_volume(s->region);
	if (sim->dimension == 3 && !out && *volume > 0 && isfinite(*volume))
		return TS_OK;
	return ts_fail(&sim->error, TS_STATE, &self->where,
		       "compute stress/region: the volume of region %s %s; give it by `volume V`",
		       s->region->id,
		       sim->dimension == 2 ? "is an area in two dimensions"
		       : out		   ? "in the box is not known, since it reaches beyond the box"
					   : "is not known");
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	double volume;

	s->sim = sim;
	sim->neigh->keep_forces = true;
	TS_TRY(read_parts(self, sim));
	if (s->wall)
		ts_walls_want_reports(sim);
	return ts_region_varies(s->region) ? TS_OK : find_volume(self, sim, &volume);
}

/* ---- the part of a branch that is in the region */

static bool is_inside(const struct state *s, const double from[3], const double along[3], double t)
{
	const struct ts_box *box = &s->sim->domain->box;
	double x[3];
	int32_t image[3] = { 0 };

	for (int d = 0; d < 3; d++) {
		x[d] = from[d] + t * along[d];
		if (ts_box_periodic(box, d))
			ts_box_wrap(box, d, &x[d], &image[d]);
	}
	return ts_region_contains(s->region, x);
}

/* Where the line from t0 to t1 leaves or enters the region, by bisection. */
static double find_crossing(const struct state *s, const double from[3], const double along[3], double t0,
			    double t1, bool inside)
{
	for (int k = 0; k < 52; k++) {
		double middle = 0.5 * (t0 + t1);

		*(is_inside(s, from, along, middle) == inside ? &t0 : &t1) = middle;
	}
	return 0.5 * (t0 + t1);
}

/* The fraction of from ... from + along that is in the region. What is shorter than an eighth of it may be missed. */
static double fraction_inside(const struct state *s, const double from[3], const double along[3])
{
	enum { PIECES = 8 };
	bool before = is_inside(s, from, along, 0);
	double fraction = 0;

	for (int k = 0; k < PIECES; k++) {
		double t0 = (double)k / PIECES, t1 = (double)(k + 1) / PIECES;
		bool after = is_inside(s, from, along, t1);
		double at = before == after ? t1 : find_crossing(s, from, along, t0, t1, before);

		fraction += before ? at - t0 : after ? t1 - at : 0;
		before = after;
	}
	return fraction;
}

/* ---- sums */

struct sums {
	struct ts_exactsum term[6];
	double contacts;
};

/* A force on the end `x` of the branch d, from the other end to x; symmetric part. */
static void add_branch(const struct state *s, struct sums *sums, const double x[3], const double d[3],
		       const double force[3])
{
	double back[3] = { -d[0], -d[1], -d[2] }, weight = fraction_inside(s, x, back);

	for (int k = 0; k < 6 && weight > 0; k++) {
		int i = ts_tensor_row[k], j = ts_tensor_column[k];

		ts_exactsum_add(&sums->term[k], 0.5 * weight * (d[i] * force[j] + d[j] * force[i]));
	}
	sums->contacts += weight > 0;
}

static void add_pairs(struct ts_instance *self, const struct state *s, struct sums *sums)
{
	struct tsim *sim = s->sim;
	struct ts_contact_view view;

	for (size_t r = 0; s->pair && r < sim->neigh->contacts.n; r++) {
		if (!ts_contact_touches(&sim->neigh->contacts, r) || !ts_contact_counts(sim, r, self->group))
			continue;
		ts_contact_view(sim, r, &view);
		add_branch(s, sums, sim->particles->x[view.a], view.d, view.force);
	}
	for (size_t b = 0; s->bond && b < sim->bonds->n; b++) {
		ts_contact_view_of_bond(sim, b, &view);
		if (ts_in_group(sim->particles, view.a, self->group) &&
		    ts_in_group(sim->particles, view.b, self->group))
			add_branch(s, sums, sim->particles->x[view.a], view.d, view.force);
	}
}

/* The branch of a contact with a wall goes from the point of contact to the centre. */
static void add_walls(struct ts_instance *self, const struct state *s, struct sums *sums)
{
	const struct ts_particles *p = s->sim->particles;
	const struct ts_wall *w;

	for (size_t at = 0; s->wall && (w = ts_walls_next(s->sim, &at, NULL));)
		for (size_t k = 0; k < w->contacts.n; k++) {
			const struct ts_wall_report *report = ts_wall_report(&w->contacts, k);
			size_t i = (size_t)w->contacts.row[k];
			double d[3];

			if (!report || i >= p->n || !ts_in_group(p, i, self->group))
				continue;
			for (int a = 0; a < 3; a++)
				d[a] = p->x[i][a] - report->point[a];
			add_branch(s, sums, p->x[i], d, report->force);
		}
}

/* Whether the centre of particle i is in the region. */
static bool holds(const struct tsim *sim, const struct state *s, size_t i)
{
	int32_t image[3];
	double x[3];

	ts_wrapped(sim, i, x, image);
	return ts_region_contains(s->region, x);
}

struct motion {
	const struct state *s;
	double mean[3];
};

static void mass_term(const struct tsim *sim, size_t i, const void *context, double *term)
{
	const struct motion *m = context;
	const struct ts_particles *p = sim->particles;
	double mass = holds(sim, m->s, i) ? p->mass[i] : 0;

	term[0] = mass;
	for (int d = 0; d < 3; d++)
		term[1 + d] = mass * p->v[i][d];
}

static void flux_term(const struct tsim *sim, size_t i, const void *context, double *term)
{
	const struct motion *m = context;
	const struct ts_particles *p = sim->particles;
	double mass = holds(sim, m->s, i) ? p->mass[i] : 0, v[3];

	for (int d = 0; d < 3; d++)
		v[d] = p->v[i][d] - m->mean[d];
	for (int k = 0; k < 6; k++)
		term[k] = mass * v[ts_tensor_row[k]] * v[ts_tensor_column[k]];
}

/* Momentum that particles whose centre is in the region carry, relative to their mean velocity. */
static void add_motion(struct ts_instance *self, const struct state *s, struct sums *sums)
{
	struct motion m = { .s = s };
	double total[4], flux[6];

	if (!s->kinetic)
		return;
	ts_group_sum(s->sim, self->group, 4, mass_term, &m, total);
	for (int d = 0; d < 3; d++)
		m.mean[d] = total[0] > 0 ? total[1 + d] / total[0] : 0;
	ts_group_sum(s->sim, self->group, 6, flux_term, &m, flux);
	for (int k = 0; k < 6; k++)
		ts_exactsum_add(&sums->term[k], flux[k]);
}

enum { CONTACTS = 6, NVALUES };

static enum ts_status eval_tensor(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct state *s = self->state;
	struct sums sums = { .contacts = 0 };
	double volume;

	(void)sim;
	for (int k = 0; k < 6; k++)
		sums.term[k] = ts_exactsum_start();
	TS_TRY(ts_region_update(s->region, s->sim));
	TS_TRY(find_volume(self, s->sim, &volume));
	TS_TRY(ts_contacts_forces(s->sim, self));
	TS_TRY(ts_walls_connect(s->sim));
	add_pairs(self, s, &sums);
	add_walls(self, s, &sums);
	add_motion(self, s, &sums);
	for (int k = 0; k < 6; k++)
		out->data[k] = ts_exactsum_value(&sums.term[k]) / volume;
	out->data[CONTACTS] = sums.contacts;
	return TS_OK;
}

static enum ts_status eval_pressure(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	double number[NVALUES];
	struct ts_table all = { .data = number };

	TS_TRY(eval_tensor(self, sim, &all));
	out->data[0] = ts_virial_mean_pressure(sim, number);
	return TS_OK;
}

static const char *const names[] = { "xx", "yy", "zz", "xy", "xz", "yz", "contacts", NULL };
static const struct ts_value values[] = {
	{ "pressure", "pressure", "mean of the diagonal of the tensor", TS_SCALAR, 1, NULL, eval_pressure },
	{ "tensor", "pressure", "stress, > 0 under pressure; number of contacts and bonds", TS_VECTOR,
	  NVALUES, names, eval_tensor },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_REGION("region", struct state, region, .flags = TS_POSITIONAL, .help = "ID of a region"),
	{ .name = "parts",
	  .type = TS_ARG_REST,
	  .flags = TS_POSITIONAL | TS_OPTIONAL | TS_TO_KEYWORD,
	  .offset = TS_FIELD(struct state, words, struct ts_words *),
	  .help = "ke, pair, bond, wall; none: all" },
	TS_REAL("volume", struct state, volume, .flags = TS_OPTIONAL, .range = TS_POSITIVE,
		.unit = "length^3",
		.help = "volume of the region in the box, in two dimensions its area; default: that of the "
			"shape"),
	TS_ARGS_END,
};

TS_STYLE(compute, ts_style, ts_compute_stress_region)
const struct ts_style ts_compute_stress_region = {
	.name = "stress/region",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE,
	.summary = "Mean stress of the grains in a region, from contacts, bonds, walls and motion",
	.doc = "The Cauchy stress of a granular assembly, averaged over a region of volume V:\n\n"
	       "    s_ab = (sum_c w_c (d_a F_b + d_b F_a)/2 + sum_i m (v_a - u_a)(v_b - u_b)) / V\n\n"
	       "The first sum is over the contacts and bonds between particles of the group, d the vector "
	       "from the partner to the particle on which F acts, and over their contacts with walls, d from "
	       "the point of contact to the centre. w_c is the fraction of this branch that is in the region "
	       "(Lutsko; Cormier, Rickman, Delph), so that cells that fill a larger one have its stress as "
	       "their mean. The second sum is over the particles with their centre in the region, u their "
	       "mean velocity. As for compute pressure, s is > 0 under pressure; its antisymmetric part, of "
	       "contacts that are not in balance of moments, is left out. Forces are those of the last force "
	       "computation.\n\n"
	       "Of a region whose surface crosses a branch twice within an eighth of its length the inner "
	       "part may be missed. A region smaller than some grains gives the stress of a few contacts: "
	       "check the seventh number. The volume of a region that reaches beyond the box, of a union or "
	       "in two dimensions is not known: give it. compute stress/atom shares the virial of a contact "
	       "among its particles instead; compute pressure is that of the whole box, without walls.",
	.example = "region mid block -0.01 0.01 -0.01 0.01 0.02 0.04 units box\n"
		   "compute s all stress/region mid\ncompute f all stress/region mid pair wall\n"
		   "thermo_style custom step c_s c_s[3]",
	.cite = "J. F. Lutsko, J. Appl. Phys. 64 (1988) 1152; J. Cormier, J. M. Rickman, T. J. Delph, J. "
		"Appl. Phys. 89 (2001) 99",
	.args = args,
	.state_size = sizeof(struct state),
	.values = values,
	.init = init,
};
