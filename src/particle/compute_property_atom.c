/* Compute property/atom: per-particle quantities by name. */
#include "core/sim.h"

#include "particle/particles.h"

#include "base/banned.h"

struct property {
	struct ts_words names;
	struct ts_table one;
	struct tsim *sim; /* for eval, which gets a const one: evaluation may allocate */
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct property *c = self->state;

	c->sim = sim;
	for (size_t k = 0; k < c->names.n; k++) {
		const struct ts_word *word = &c->names.word[k];
		struct ts_suggest suggest = ts_suggest_start(word->text);

		if (ts_quantity_has(sim, word->text))
			continue;
		ts_quantity_suggest(sim, &suggest);
		return ts_fail(&sim->error, TS_UNKNOWN, &word->place, "particles have no property '%s'%s",
			       word->text, ts_suggest_text(&suggest));
	}
	return TS_OK;
}

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	struct property *c = self->state;
	const struct ts_particles *p = sim->particles;

	if (ts_table_resize(out, p->n, c->names.n) != TS_OK)
		return ts_nomem(&c->sim->error);
	for (size_t k = 0; k < c->names.n; k++) {
		TS_TRY(ts_quantity_eval(c->sim, c->names.word[k].text, &c->one));
		for (size_t i = 0; i < p->n; i++)
			out->data[i * c->names.n + k] = ts_in_group(p, i, self->group) ? c->one.data[i] : 0;
	}
	return TS_OK;
}

static void fini(struct ts_instance *self)
{
	struct property *c = self->state;

	ts_table_release(&c->one);
}

static size_t width(const struct ts_instance *self)
{
	return ((const struct property *)self->state)->names.n;
}

static const struct ts_value values[] = {
	{ .name = "property",
	  .unit = "",
	  .help = "the properties, one column each; 0 for particles outside the group",
	  .shape = TS_PERATOM,
	  .eval = eval },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_REST("names", struct property, names, .help = "properties: id, type, x, vx, fx, radius, mass ..."),
	TS_ARGS_END,
};

TS_STYLE(compute, ts_style, ts_compute_property_atom)
const struct ts_style ts_compute_property_atom = {
	.name = "property/atom",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.summary = "Properties of each particle",
	.doc = "Makes per-particle quantities available by name: c_ID[k] is the k-th of them, and c_ID that "
	       "of a compute with a single one. The value is 0 for particles outside the group.",
	.example = "compute size all property/atom radius mass",
	.args = args,
	.state_size = sizeof(struct property),
	.values = values,
	.width = width,
	.init = init,
	.fini = fini,
};
