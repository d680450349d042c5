/* Compute displace/atom: displacement of each particle. */
#include <string.h>

#include "math/vec3.h"
#include "particle/group_moments.h"
#include "particle/reference.h"

#include "base/banned.h"

struct displace {
	struct ts_reference start;
	struct tsim *sim;
	const char *variable; /* != 0: particles whose reference a dump resets; NULL: all */
};

static void unwrapped_position(const struct ts_instance *self, const struct tsim *sim, size_t i,
			       double now[3])
{
	(void)self;
	ts_unwrapped(sim, i, now);
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct displace *s = self->state;
	const char *name = s->variable;

	s->sim = sim;
	if (name && strncmp(name, "v_", 2) == 0)
		s->variable = name += 2;
	if (name && !sim->reading.unreached &&
	    !(sim->script_api && sim->script_api->has_variable(sim->script_api_data, name) &&
	      sim->script_api->is_peratom(sim->script_api_data, name)))
		return ts_fail(&sim->error, TS_UNKNOWN, ts_instance_word(self, name),
			       "compute displace/atom: refresh takes an atom-style variable, there is no "
			       "such variable '%s'",
			       name);
	return ts_reference_init(self, sim, &s->start, unwrapped_position);
}

static enum ts_status store_new_references(struct ts_instance *self, struct tsim *sim)
{
	ts_reference_add(sim, &((struct displace *)self->state)->start);
	return TS_OK;
}

static enum ts_status refresh(struct ts_instance *self, struct tsim *sim)
{
	struct displace *s = self->state;
	struct ts_table chosen = { 0 };
	enum ts_status status = TS_OK;

	TS_TRY(store_new_references(self, sim));
	if (s->variable)
		status = sim->script_api->peratom(sim->script_api_data, s->variable, &self->where, &chosen);
	for (size_t i = 0; i < sim->particles->n && status == TS_OK; i++)
		if (!s->variable || chosen.data[i] != 0)
			unwrapped_position(self, sim, i, ts_reference_of(sim, &s->start, i));
	ts_table_release(&chosen);
	return status;
}

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	struct displace *s = self->state;
	const struct ts_particles *p = sim->particles;

	TS_TRY(ts_table_resize(out, p->n, 4));
	TS_TRY(store_new_references(self, s->sim));
	for (size_t i = 0; i < p->n; i++) {
		double *row = out->data + 4 * i, x[3] = { 0 };

		if (ts_in_group(p, i, self->group)) {
			ts_unwrapped(sim, i, x);
			ts_sub(x, ts_reference_of(sim, &s->start, i), x);
		}
		for (int d = 0; d < 3; d++)
			row[d] = x[d];
		row[3] = ts_norm(x);
	}
	return TS_OK;
}

static enum ts_status archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a)
{
	return ts_reference_archive(a, sim, &((struct displace *)self->state)->start);
}

static const struct ts_arg args[] = {
	TS_WORD("refresh", struct displace, variable, .flags = TS_OPTIONAL,
		.help = "an atom-style variable, NAME or v_NAME: after a frame of a dump with dump_modify "
			"refresh the present positions become the reference of the particles for which it is "
			"not 0; without it, of all"),
	TS_ARGS_END,
};

static const char *const names[] = { "dx", "dy", "dz", "distance", NULL };
static const struct ts_value values[] = {
	{ "displacement", "length", "displacement and its length; 0 outside the group", TS_PERATOM, 4, names,
	  eval },
	{ .name = NULL },
};

TS_STYLE(compute, ts_style, ts_compute_displace_atom)
const struct ts_style ts_compute_displace_atom = {
	.name = "displace/atom",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_OWN | TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.summary = "Displacement of each particle",
	.doc = "Displacement of each particle of the group from its reference position: that at the time "
	       "when the compute was defined, or when the particle was inserted if that was later. Positions "
	       "are unwrapped: periodic wrapping does not change the displacement. Reference positions are "
	       "written to restart files.",
	.example = "compute way all displace/atom\ndump d all custom 100 post/way*.txt id c_way[4]",
	.args = args,
	.state_size = sizeof(struct displace),
	.archive = archive,
	.values = values,
	.init = init,
	.refresh = refresh,
	.hook = { [TS_STAGE_POST_BUILD] = store_new_references, [TS_STAGE_SETUP] = store_new_references },
};
