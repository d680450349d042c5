#include "bed/component.h"

#include <stdio.h>

#include "particle/particles.h"

#include "base/banned.h"

static const struct ts_arg type[] = {
	TS_TYPES("types", struct ts_component, types, .flags = TS_POSITIONAL,
		 .help = "types of its particles: n, n*, *m, n*m"),
	TS_ARGS_END,
};

static const struct ts_arg group[] = {
	TS_GROUP("name", struct ts_component, group, .flags = TS_POSITIONAL,
		 .help = "group of its particles"),
	TS_ARGS_END,
};

static const struct ts_arg above[] = {
	TS_WORD("value", struct ts_component, name, .flags = TS_POSITIONAL,
		.help = "a number of each particle: radius, density, c_ID, c_ID[k], f_ID, v_name ..."),
	TS_REAL("limit", struct ts_component, limit, .flags = TS_POSITIONAL,
		.help = "its particles have a value greater than this, in the unit of the value"),
	TS_ARGS_END,
};

const struct ts_mode ts_component_modes[] = {
	[TS_COMPONENT_TYPE] = { "type", "particles of these types", type },
	[TS_COMPONENT_GROUP] = { "group", "members of a group", group },
	[TS_COMPONENT_ABOVE] = { "above", "particles with a value above a limit", above },
	{ .name = NULL },
};

enum ts_status ts_component_init(struct ts_instance *self, struct tsim *sim)
{
	struct ts_component *c = self->state;
	char what[80];

	c->sim = sim;
	snprintf(what, sizeof what, "compute %s", self->style->name);
	if (c->kind == TS_COMPONENT_TYPE)
		return ts_particles_require_types(sim, what, &c->types, &self->where);
	if (c->kind != TS_COMPONENT_ABOVE)
		return TS_OK;
	c->value.name = c->name;
	c->value.where = *ts_instance_word(self, c->name);
	return ts_ref_input_resolve(sim, what, TS_WANT(PERATOM), &c->value);
}

void ts_component_fini(struct ts_instance *self)
{
	ts_table_release(&((struct ts_component *)self->state)->table);
}

enum ts_status ts_component_update(struct ts_instance *self)
{
	struct ts_component *c = self->state;

	return c->kind == TS_COMPONENT_ABOVE ? ts_ref_input_eval(c->sim, &c->value, &c->table) : TS_OK;
}

bool ts_component_has(const struct ts_component *c, size_t i)
{
	const struct ts_particles *p = c->sim->particles;

	if (c->kind == TS_COMPONENT_GROUP)
		return ts_in_group(p, i, c->group);
	if (c->kind == TS_COMPONENT_ABOVE)
		return c->table.data[i] > c->limit;
	return p->type[i] >= c->types.lo && (!c->types.hi || p->type[i] <= c->types.hi);
}
