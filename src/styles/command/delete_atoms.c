/* Command delete_atoms: removes particles. */
#include "core/sim.h"

#include "geom/pointhash.h"
#include "particles/domain.h"
#include "particles/particles.h"
#include "particles/region.h"

#include "base/banned.h"

enum { GROUP, REGION, OVERLAP };

struct state {
	int mode, group, other;
	struct ts_instance *region;
	double cutoff;
	bool compress;
};

/* In order of identity, so that the result does not depend on the order of rows: a member of
 * `group` goes if a particle of `other` that stays is nearer than the cutoff. */
static enum ts_status mark_overlaps(struct tsim *sim, const struct state *s,
				    struct ts_pointhash *hash, unsigned char *flag)
{
	struct ts_particles *p = sim->particles;
	const int32_t *row;

	TS_TRY(ts_particles_map(sim, &row));
	for (size_t i = 0; i < p->n; i++)
		if (ts_in_group(p, i, s->other) && !ts_in_group(p, i, s->group) &&
		    ts_pointhash_add(hash, p->x[i]) != TS_OK)
			return ts_nomem(&sim->error);
	for (int32_t tag = 1; tag <= p->max_tag; tag++) {
		int32_t i = row[tag];

		if (i < 0 || !ts_in_group(p, (size_t)i, s->group))
			continue;
		flag[i] = ts_pointhash_near_periodic(hash, &sim->domain->box, p->x[i], s->cutoff);
		if (!flag[i] && ts_in_group(p, (size_t)i, s->other) &&
		    ts_pointhash_add(hash, p->x[i]) != TS_OK)
			return ts_nomem(&sim->error);
	}
	return TS_OK;
}

static enum ts_status mark(struct tsim *sim, const struct state *s, unsigned char *flag)
{
	const struct ts_particles *p = sim->particles;
	struct ts_pointhash hash;
	enum ts_status status;

	if (s->mode == OVERLAP) {
		if (ts_pointhash_start(&hash, s->cutoff) != TS_OK)
			return ts_nomem(&sim->error);
		status = mark_overlaps(sim, s, &hash, flag);
		ts_pointhash_release(&hash);
		return status;
	}
	for (size_t i = 0; i < p->n; i++)
		flag[i] = s->mode == GROUP ? ts_in_group(p, i, s->group)
					   : ts_region_contains(s->region, p->x[i]);
	return TS_OK;
}

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct state *s = state;
	struct ts_particles *p = sim->particles;
	size_t before = p->n;
	unsigned char *flag = ts_alloc(p->n, 1);
	enum ts_status status;

	(void)where;
	if (!flag)
		return ts_nomem(&sim->error);
	status = mark(sim, s, flag);
	if (status == TS_OK)
		status = ts_particles_delete(sim, flag);
	ts_free(flag);
	if (status == TS_OK)
		ts_log(&sim->log, "Deleted %zu atoms, new total = %zu\n", before - p->n, p->n);
	return status;
}

static const struct ts_arg group_args[] = {
	TS_GROUP("group", struct state, group, .flags = TS_POSITIONAL, .help = "who is removed"),
	TS_ARGS_END,
};

static const struct ts_arg region_args[] = {
	TS_REGION("region", struct state, region, .flags = TS_POSITIONAL,
		  .help = "where particles are removed"),
	TS_ARGS_END,
};

static const struct ts_arg overlap_args[] = {
	TS_REAL("cutoff", struct state, cutoff, .flags = TS_POSITIONAL, .range = TS_POSITIVE,
		.unit = "length", .help = "distance of centers below which one is removed"),
	TS_GROUP("group", struct state, group, .flags = TS_POSITIONAL,
		 .help = "particles that may be removed"),
	TS_GROUP("other", struct state, other, .flags = TS_POSITIONAL,
		 .help = "particles that they may be too near to"),
	TS_ARGS_END,
};

static const struct ts_mode modes[] = {
	[GROUP] = { "group", "all particles of a group", group_args },
	[REGION] = { "region", "all particles whose centers lie in a region", region_args },
	[OVERLAP] = { "overlap", "particles too near to others", overlap_args },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_MODE("style", struct state, mode, modes, .help = "which particles are removed"),
	TS_BOOL("compress", struct state, compress, .fallback = "no",
		.help = "no effect: identities are kept and never used again"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_delete_atoms)
const struct ts_command_style ts_command_delete_atoms = {
	.style = {
		.name = "delete_atoms",
		.kind = TS_KIND_COMMAND,
		.summary = "Removes particles",
		.doc = "Bonds of removed particles go with them. overlap looks at the particles in the order\n"
		       "of their identities; of two members of both groups that are too near the first stays.",
		.example = "delete_atoms group loose\n"
			   "delete_atoms region hole\n"
			   "delete_atoms overlap 0.001 all all",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.needs_box = true,
	.run = run,
};
