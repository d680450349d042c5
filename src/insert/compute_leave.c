/* Compute leave: counts particles that leave a region. */
#include "particle/columns.h"
#include "particle/group_moments.h"
#include "particle/particles.h"
#include "particle/rank_sums.h"
#include "region/region.h"

#include "base/banned.h"

struct leave {
	struct ts_instance *region;
	int64_t seen;	/* entries into the region, particles inside at the start included */
	int64_t inside; /* particles inside now */
	size_t column;	/* of the particles: 1 inside, 0 outside */
	bool started;
	/* Of the particles of this rank, while they are divided: entries since the last `join`, particles inside. */
	int64_t part_seen, part_inside;
	bool parted; /* a step has counted these */
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct leave *s = self->state;
	struct ts_str name = { 0 };
	enum ts_status status;

	ts_str_addf(&name, "compute leave %s", self->id);
	status = ts_particles_add_column(sim, ts_str_text(&name), 1, TS_COL_RESULT, &s->column);
	ts_str_release(&name);
	/* a former compute of this name may have left its column */
	for (size_t i = 0; status == TS_OK && !s->started && i < sim->particles->n; i++)
		((double *)sim->particles->column[s->column].data)[i] = 0;
	s->started = status == TS_OK;
	return status;
}

static enum ts_status count_entries(struct ts_instance *self, struct tsim *sim)
{
	struct leave *s = self->state;
	const struct ts_particles *p = sim->particles;
	double *flag = p->column[s->column].data;
	int64_t *seen = sim->division ? &s->part_seen : &s->seen;
	int64_t *now = sim->division ? &s->part_inside : &s->inside;

	TS_TRY(ts_region_update(s->region, sim));
	s->parted = sim->division != NULL;
	*now = 0;
	for (size_t i = 0; i < p->n; i++) {
		bool inside = ts_in_group(p, i, self->group);
		int32_t image[3];
		double x[3];

		ts_wrapped(sim, i, x, image);
		inside = inside && ts_region_contains(s->region, x);

		*seen += inside && flag[i] == 0;
		*now += inside;
		flag[i] = inside;
	}
	return TS_OK;
}

static enum ts_status join(struct ts_instance *self, struct tsim *sim)
{
	struct leave *s = self->state;

	if (!s->parted)
		return TS_OK;
	ts_rank_sums_count(sim, &s->part_seen);
	ts_rank_sums_count(sim, &s->part_inside);
	s->seen += s->part_seen;
	s->inside = s->part_inside;
	s->part_seen = 0;
	s->parted = false;
	return TS_OK;
}

static enum ts_status eval_left(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct leave *s = self->state;

	(void)sim;
	out->data[0] = (double)(s->seen - s->inside);
	return TS_OK;
}

static enum ts_status eval_counts(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct leave *s = self->state;

	(void)sim;
	out->data[0] = (double)(s->seen - s->inside);
	out->data[1] = (double)s->inside;
	out->data[2] = (double)s->seen;
	return TS_OK;
}

static enum ts_status archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a)
{
	return ts_particles_archive_column(a, sim, "flags", ((struct leave *)self->state)->column);
}

static const struct ts_arg args[] = {
	TS_REGION("region", struct leave, region, .flags = TS_POSITIONAL | TS_STATEFUL,
		  .help = "region that is monitored"),
	TS_ARGS_END,
};

static const char *const names[] = { "left", "inside", "entered" };
static const struct ts_value values[] = {
	{ "left", "", "number of times that a particle of the group has left the region", TS_SCALAR, 1, NULL,
	  eval_left },
	{ "counts", "", "numbers of particles that have left, are inside, have entered", TS_VECTOR, 3, names,
	  eval_counts },
	{ .name = NULL },
};

static const struct ts_saved saved[] = {
	TS_SAVE_I64(struct leave, seen),
	TS_SAVE_I64(struct leave, inside),
	TS_SAVED_ROWS_END,
};

TS_STYLE(compute, ts_style, ts_compute_leave)
const struct ts_style ts_compute_leave = {
	.name = "leave",
	.kind = TS_KIND_COMPUTE,
	.summary = "Counts particles that leave a region",
	.doc = "At the end of each step the particles of the group in the region are counted. Particles that "
	       "are no longer there count as having left, also if they were lost through a fixed face or "
	       "deleted: left = entered - inside.",
	.example = "region hole block INF INF INF INF INF 0.02\ncompute out rock leave hole",
	.args = args,
	.state_size = sizeof(struct leave),
	.saved = saved,
	.archive = archive,
	.values = values,
	.init = init,
	.hook = { [TS_STAGE_SETUP] = count_entries, [TS_STAGE_END_OF_STEP] = count_entries },
	.ranks = TS_RANKS_OWN | TS_RANKS_OUTPUTS | TS_RANKS_PARTICLES,
	.join = join,
};
