#include "particle/columns.h"
#include "particle/particles.h"
#include "region/region.h"

#include "base/banned.h"

struct leave {
	struct ts_instance *region;
	int64_t seen;	/* entries into the region, those there at the start included */
	int64_t inside; /* now */
	size_t column;	/* per particle: 1 inside, 0 not */
	bool started;
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct leave *s = self->state;
	struct ts_str name = { 0 };
	enum ts_status status;

	ts_str_addf(&name, "compute leave %s", self->id);
	status = ts_particles_add_column(sim, ts_str_text(&name), 1, TS_COL_RESULT, &s->column);
	ts_str_release(&name);
	/* a column of this name may be left over from a compute that is gone */
	for (size_t i = 0; status == TS_OK && !s->started && i < sim->particles->n; i++)
		((double *)sim->particles->column[s->column].data)[i] = 0;
	s->started = status == TS_OK;
	return status;
}

static enum ts_status look(struct ts_instance *self, struct tsim *sim)
{
	struct leave *s = self->state;
	const struct ts_particles *p = sim->particles;
	double *flag = p->column[s->column].data;

	TS_TRY(ts_region_update(s->region, sim));
	s->inside = 0;
	for (size_t i = 0; i < p->n; i++) {
		bool inside = ts_in_group(p, i, self->group) && ts_region_contains(s->region, p->x[i]);

		s->seen += inside && flag[i] == 0;
		s->inside += inside;
		flag[i] = inside;
	}
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
		  .help = "region to watch"),
	TS_ARGS_END,
};

static const char *const names[] = { "left", "inside", "entered" };
static const struct ts_value values[] = {
	{ "left", "", "how often a particle of the group has left the region", TS_SCALAR, 1, NULL,
	  eval_left },
	{ "counts", "", "how many have left, are inside now, have entered", TS_VECTOR, 3, names,
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
	.summary = "counts the particles that leave a region",
	.doc = "Looks at the end of every step which particles of the group are in the region. Those "
	       "that are not any more, also because they left the simulation through a fixed face or "
	       "were deleted, count as having left: left = entered - inside.",
	.example = "region hole block INF INF INF INF INF 0.02\ncompute out rock leave hole",
	.args = args,
	.state_size = sizeof(struct leave),
	.saved = saved,
	.archive = archive,
	.values = values,
	.init = init,
	.hook = { [TS_STAGE_SETUP] = look, [TS_STAGE_END_OF_STEP] = look },
};
