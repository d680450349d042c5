/* Fix bond/store/local: bonds that broke in the present interval, in the quantities of LAMMPS. */
#include "bond/bonds.h"
#include "core/name_list.h"

#include "base/banned.h"

struct store {
	int64_t every;
	struct ts_words words;
	struct ts_name_list list;
};

typedef double quantity_fn(const struct ts_bond_event *event);

static double quantity_id1(const struct ts_bond_event *e)
{
	return e->tag[0];
}

static double quantity_id2(const struct ts_bond_event *e)
{
	return e->tag[1];
}

static double quantity_time(const struct ts_bond_event *e)
{
	return (double)e->step;
}

static double quantity_x(const struct ts_bond_event *e)
{
	return e->x[0];
}

static double quantity_y(const struct ts_bond_event *e)
{
	return e->x[1];
}

static double quantity_z(const struct ts_bond_event *e)
{
	return e->x[2];
}

static const struct quantity {
	const char *name;
	quantity_fn *value;
} quantities[] = { { "id1", quantity_id1 }, { "id2", quantity_id2 }, { "time", quantity_time },
		   { "x", quantity_x },	    { "y", quantity_y },     { "z", quantity_z },
		   { NULL, NULL } };

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct store *s = self->state;

	return ts_name_list_read(sim, "fix bond/store/local", &self->arena, s->words, quantities,
				 sizeof *quantities, &s->list);
}

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct store *s = self->state;
	const struct ts_bonds *b = sim->bonds;
	/* the last multiple of `every` before this step */
	int64_t after = sim->clock.step > 0 ? (sim->clock.step - 1) / s->every * s->every : -1;
	size_t n = 0;

	for (size_t k = b->nevents; k > b->past_events && b->event[k - 1].step > after; k--)
		n++;
	TS_TRY(ts_table_resize(out, n, s->list.n));
	for (size_t k = 0; k < n; k++)
		for (size_t c = 0; c < s->list.n; c++)
			out->data[k * s->list.n + c] =
				quantities[s->list.item[c]].value(&b->event[b->nevents - n + k]);
	return TS_OK;
}

static const struct ts_arg args[] = {
	TS_INT("N", struct store, every, .flags = TS_POSITIONAL, .range = TS_POSITIVE, .unit = "steps",
	       .help = "interval: the list begins anew after each multiple of N"),
	TS_REST("quantities", struct store, words,
		.help = "any of id1, id2, IDs of the particles; time, the step in which the bond broke; x, "
			"y, z, where"),
	TS_ARGS_END,
};

static const struct ts_value values[] = {
	{ "list", "", "a row for each bond broken since the last multiple of N before this step", TS_LOCAL, 0,
	  NULL, eval },
	{ .name = NULL },
};

TS_STYLE(fix, ts_style, ts_fix_bond_store_local)
const struct ts_style ts_fix_bond_store_local = {
	.name = "bond/store/local",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.summary = "lists the bonds broken in an interval, for dump local",
	.doc = "A local array with one row for each bond that broke after the last multiple of N before the "
	       "present step: at a multiple of N, those of the last N steps. A dump local every N steps "
	       "writes each broken bond once. x, y, z is the middle between the two particles when the bond "
	       "broke. This is the list of `store/local FIX N ...` of LAMMPS' bond styles bpm/..., which "
	       "make this fix; it lists the broken bonds of any bond style. x/ref, y/ref and z/ref are not "
	       "supported. fix bond/breakage lists all broken bonds, with force and mode.",
	.example = "fix broken all bond/store/local 1000 time id1 id2\n"
		   "dump b all local 1000 post/broken.txt f_broken[1] f_broken[2] f_broken[3]",
	.args = args,
	.state_size = sizeof(struct store),
	.values = values,
	.init = init,
};
