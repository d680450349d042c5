#include "bond/bond_reference.h"
#include "bond/bonds.h"

#include <inttypes.h>
#include <math.h>

#include "box/domain.h"
#include "neigh/cells.h"
#include "neigh/coincide.h"
#include "particle/exchange.h"
#include "particle/identity.h"
#include "particle/particles.h"

#include "base/banned.h"

enum { MANY, GAP, SINGLE };

struct create_bonds {
	int mode, group_a, group_b;
	int64_t type, tag_a, tag_b;
	double rmin, rmax;
	double gap; /* largest distance of the surfaces, with GAP */
	const struct ts_place *where;
};

/* Spheres that are placed side by side touch, whatever the rounding of their positions. */
static const double ROUNDING = 1e-9;

static double nearest_image_distance(const struct tsim *sim, size_t i, size_t j)
{
	const double *a = sim->particles->x[i], *b = sim->particles->x[j];
	double d[3] = { a[0] - b[0], a[1] - b[1], a[2] - b[2] };

	ts_box_nearest(&sim->domain->box, d);
	return sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
}

static bool matches_groups(const struct create_bonds *c, const struct ts_particles *p, size_t i, size_t j)
{
	return (ts_in_group(p, i, c->group_a) && ts_in_group(p, j, c->group_b)) ||
	       (ts_in_group(p, i, c->group_b) && ts_in_group(p, j, c->group_a));
}

static bool matches_distance(const struct create_bonds *c, const struct ts_particles *p, size_t i, size_t j,
			     double d)
{
	if (c->mode == GAP)
		return d <= (1 + ROUNDING) * (p->radius[i] + p->radius[j]) + c->gap;
	return d >= c->rmin && d <= c->rmax;
}

/* Bonds particle i to all partners of larger identity that match; they are within rmax. */
static enum ts_status bond_to_neighbors(struct tsim *sim, const struct create_bonds *c,
					const struct ts_level *level, size_t i)
{
	const struct ts_particles *p = sim->particles;
	int lo[3], hi[3];

	ts_cells_range(level, p->xhold[i], c->rmax, lo, hi);
	for (int z = lo[2]; z <= hi[2]; z++) {
		for (int y = lo[1]; y <= hi[1]; y++) {
			int row = level->cells[0] * (y + level->cells[1] * z);

			for (int32_t k = level->start[row + lo[0]]; k < level->start[row + hi[0] + 1]; k++) {
				size_t j = (size_t)level->list[k];
				double d;

				if (j >= p->n)
					j = (size_t)p->ghost_owner[j - p->n];
				if (p->tag[j] <= p->tag[i] || !matches_groups(c, p, i, j))
					continue;
				d = nearest_image_distance(sim, i, j);
				if (!matches_distance(c, p, i, j, d))
					continue;
				TS_TRY(ts_coincide_bond(sim, c->where, i, j, d));
				TS_TRY(ts_bonds_add(sim, p->tag[i], p->tag[j], (int)c->type, d));
			}
		}
	}
	return TS_OK;
}

/* In a small periodic box a pair is found several times, by its images: keep one bond a pair, and of
 * pairs that were bonded before the old one. */
static enum ts_status remove_duplicates(struct tsim *sim)
{
	struct ts_bonds *b = sim->bonds;
	unsigned char *drop = ts_alloc(b->n, 1);

	if (!drop)
		return ts_nomem(&sim->error);
	ts_bonds_sort(b);
	for (size_t k = 1; k < b->n; k++) {
		drop[k] = b->tag[k][0] == b->tag[k - 1][0] && b->tag[k][1] == b->tag[k - 1][1];
		b->created -= drop[k];
	}
	ts_bonds_delete(b, drop);
	ts_free(drop);
	return TS_OK;
}

/* The largest distance of the centres at which two particles can have the gap; 0: no two can. */
static double reach_of_gap(const struct create_bonds *c, const struct ts_particles *p)
{
	double radius = 0;

	for (size_t i = 0; i < p->n; i++)
		if (p->mask[i] & (1u << c->group_a | 1u << c->group_b))
			radius = fmax(radius, p->radius[i]);
	return radius > 0 ? fmax((1 + ROUNDING) * 2 * radius + c->gap, 0) : 0;
}

static enum ts_status create_many(struct tsim *sim, const struct create_bonds *c)
{
	struct ts_particles *p = sim->particles;
	struct ts_cells cells = { 0 };
	enum ts_status status;

	ts_exchange_hold(sim);
	TS_TRY(ts_exchange_borders(sim, c->rmax, c->rmax, c->rmax));
	status = ts_cells_fill(sim, &cells, c->rmax);
	for (int l = 0; status == TS_OK && l < cells.nlevels; l++)
		for (size_t i = 0; status == TS_OK && i < p->n; i++)
			if (p->mask[i] & (1u << c->group_a | 1u << c->group_b))
				status = bond_to_neighbors(sim, c, &cells.level[l], i);
	ts_cells_release(&cells);
	return status;
}

static enum ts_status create_single(struct tsim *sim, const struct create_bonds *c,
				    const struct ts_place *where)
{
	struct ts_identities map;
	int64_t tags[2] = { c->tag_a, c->tag_b };
	size_t i, j;
	double d;

	TS_TRY(ts_identities(sim, false, &map));
	for (int k = 0; k < 2; k++)
		if (ts_identity_row(&map, tags[k]) < 0)
			return ts_fail(&sim->error, TS_RANGE, where,
				       "create_bonds: there is no particle %" PRId64, tags[k]);
	if (c->tag_a == c->tag_b)
		return ts_fail(&sim->error, TS_RANGE, where,
			       "create_bonds: a particle cannot be bonded to itself");
	i = (size_t)ts_identity_row(&map, c->tag_a);
	j = (size_t)ts_identity_row(&map, c->tag_b);
	d = nearest_image_distance(sim, i, j);
	TS_TRY(ts_coincide_bond(sim, where, i, j, d));
	return ts_bonds_add(sim, (int32_t)c->tag_a, (int32_t)c->tag_b, (int)c->type, d);
}

static void warn_no_bond(struct tsim *sim, const struct create_bonds *c)
{
	if (sim->reading.planned) /* particles are not where they will be */
		return;
	if (c->mode == SINGLE)
		ts_warn(&sim->log, c->where,
			"create_bonds created no bond: particles %" PRId64 " and %" PRId64
			" are bonded already",
			c->tag_a, c->tag_b);
	else if (c->mode == GAP)
		ts_warn(&sim->log, c->where,
			"create_bonds created no bond: no pair that is not bonded has a gap of at most %g",
			c->gap);
	else
		ts_warn(&sim->log, c->where,
			"create_bonds created no bond: no pair that is not bonded has a distance from %g to "
			"%g",
			c->rmin, c->rmax);
}

static enum ts_status create_bonds_command(struct tsim *sim, void *state, const struct ts_place *where)
{
	struct create_bonds *c = state;
	size_t before = sim->bonds->n;

	c->where = where;
	if (c->type > sim->bonds->ntypes)
		return ts_fail(&sim->error, TS_RANGE, where,
			       "create_bonds: there is no `bond_coeff %" PRId64 " ...` yet", c->type);
	if (c->mode == MANY && c->rmin > c->rmax)
		return ts_fail(&sim->error, TS_RANGE, where, "create_bonds: rmin (%g) is above rmax (%g)",
			       c->rmin, c->rmax);
	if (c->mode == GAP)
		c->rmax = reach_of_gap(c, sim->particles);
	if (c->mode == SINGLE)
		TS_TRY(create_single(sim, c, where));
	else if (c->rmax > 0)
		TS_TRY(create_many(sim, c));
	TS_TRY(remove_duplicates(sim));
	TS_TRY(ts_bond_reference_complete(sim));
	ts_log(&sim->log, "Added %zu bonds, total bonds = %zu\n", sim->bonds->n - before, sim->bonds->n);
	if (sim->bonds->n == before)
		warn_no_bond(sim, c);
	return TS_OK;
}

static const struct ts_arg many_rows[] = {
	TS_GROUP("group_a", struct create_bonds, group_a, .flags = TS_POSITIONAL,
		 .help = "group of one partner"),
	TS_GROUP("group_b", struct create_bonds, group_b, .flags = TS_POSITIONAL,
		 .help = "group of the other partner; may be the same group"),
	TS_INT("type", struct create_bonds, type, .flags = TS_POSITIONAL, .range = TS_POSITIVE,
	       .help = "bond type"),
	TS_REAL("rmin", struct create_bonds, rmin, .flags = TS_POSITIONAL, .range = TS_NOT_NEGATIVE,
		.unit = "length", .help = "minimum distance of the centres"),
	TS_REAL("rmax", struct create_bonds, rmax, .flags = TS_POSITIONAL, .range = TS_POSITIVE,
		.unit = "length", .help = "maximum distance of the centres"),
	TS_ARGS_END,
};
static const struct ts_arg gap_rows[] = {
	TS_GROUP("group_a", struct create_bonds, group_a, .flags = TS_POSITIONAL,
		 .help = "group of one partner"),
	TS_GROUP("group_b", struct create_bonds, group_b, .flags = TS_POSITIONAL,
		 .help = "group of the other partner; may be the same group"),
	TS_INT("type", struct create_bonds, type, .flags = TS_POSITIONAL, .range = TS_POSITIVE,
	       .help = "bond type"),
	TS_REAL("gap", struct create_bonds, gap, .flags = TS_POSITIONAL, .unit = "length",
		.help = "largest distance of the surfaces; 0: particles that touch, < 0: that overlap by "
			"more; to 1e-9 of the sum of the radii"),
	TS_ARGS_END,
};
static const struct ts_arg single_rows[] = {
	TS_INT("type", struct create_bonds, type, .flags = TS_POSITIONAL, .range = TS_POSITIVE,
	       .help = "bond type"),
	TS_INT("id_a", struct create_bonds, tag_a, .flags = TS_POSITIONAL, .range = TS_POSITIVE,
	       .help = "ID of one partner"),
	TS_INT("id_b", struct create_bonds, tag_b, .flags = TS_POSITIONAL, .range = TS_POSITIVE,
	       .help = "ID of the other partner"),
	TS_ARGS_END,
};
static const struct ts_mode modes[] = {
	{ "many", "all pairs of the two groups with a distance from rmin to rmax", many_rows },
	{ "gap", "all pairs of the two groups whose surfaces are at most this far apart", gap_rows },
	{ "single/bond", "one pair", single_rows },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_MODE("mode", struct create_bonds, mode, modes, .help = "which pairs to bond"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_create_bonds)
const struct ts_command_style ts_command_create_bonds = {
	.style = { .name = "create_bonds",
		   .kind = TS_KIND_COMMAND,
		   .summary = "creates bonds between pairs of particles",
		   .doc = "The rest length of each bond is the current distance of the centres. Pairs that "
			  "are bonded already keep their bond. Two particles at the same position cannot be "
			  "bonded, as the bond has no direction: this is an error.",
		   .example = "create_bonds many rock rock 1 0.0 1.05e-3\ncreate_bonds gap rock rock 1 1e-6\n"
			      "create_bonds single/bond 1 12 17",
		   .args = args,
		   .state_size = sizeof(struct create_bonds) },
	.needs_box = true,
	.run = create_bonds_command,
};
