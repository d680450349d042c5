/* Compute bond/counter: bonds created and broken since the last thermo output, and the present number. */
#include "bond/bonds.h"
#include "thermo/thermo.h"

#include "base/banned.h"

enum { CREATED, BROKEN, INTACT, COLUMNS = 6 };

struct state {
	int64_t mark[2];   /* totals at the last thermo output; saved */
	int64_t before[2]; /* and at the one before it */
	int64_t marked;	   /* 1 + the step of this run in which the mark was set; 0: in none */
};

/* All readers in a step get the same. Thermo output in the set-up of a run does not count as the last one. */
static void set_mark(struct state *s, const struct tsim *sim, const int64_t total[2])
{
	const struct ts_clock *c = &sim->clock;

	if (!sim->run.inside || c->step == c->first_step || !ts_thermo_is_due(sim))
		return;
	for (int k = CREATED; k <= BROKEN; k++) {
		if (s->marked != c->step + 1)
			s->before[k] = s->mark[k];
		s->mark[k] = total[k];
	}
	s->marked = c->step + 1;
}

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	struct state *s = self->state;
	const int64_t total[2] = { sim->bonds->created, sim->bonds->broken };
	bool at_mark;

	set_mark(s, sim, total);
	at_mark = sim->run.inside && s->marked == sim->clock.step + 1;
	for (int k = 0; k < COLUMNS; k++)
		out->data[k] = 0;
	for (int k = CREATED; k <= BROKEN; k++)
		out->data[k] = (double)(total[k] - (at_mark ? s->before[k] : s->mark[k]));
	out->data[INTACT] = (double)ts_bonds_count(sim->bonds);
	return TS_OK;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	(void)sim;
	((struct state *)self->state)->marked = 0;
	return TS_OK;
}

static const char *const names[] = {
	"created", "broken", "bonds", "created_wall", "broken_wall", "bonds_wall"
};
static const struct ts_value values[] = {
	{ "counts", "",
	  "bonds created and broken since the last thermo output, present number; the same of bonds with "
	  "walls: 0",
	  TS_VECTOR, COLUMNS, names, eval },
	{ .name = NULL },
};
static const struct ts_saved saved[] = { TS_SAVE_I64(struct state, mark), TS_SAVED_ROWS_END };

TS_STYLE(compute, ts_style, ts_compute_bond_counter)
const struct ts_style ts_compute_bond_counter = {
	.name = "bond/counter",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.summary = "numbers of bonds created, broken and intact",
	.doc = "c_ID[1] and c_ID[2] are the numbers of bonds that were created and that broke since the "
	       "last row of thermo output in whose step this compute was read, c_ID[3] is the present number "
	       "of bonds. c_ID[4] to c_ID[6] are the same of bonds with walls, which do not exist here: 0. "
	       "Bonds of all particles and of all bond styles are counted. Rows that `thermo` asks for and "
	       "that at the end of a run begin a new count, the row in the set-up of a run does not. Reading "
	       "the compute in other steps, as by fix ave/time or fix print, begins no new count: to print "
	       "counts per interval give `thermo` the same interval. The thermo keywords bonds and "
	       "brokenbonds are the present number and the total of broken ones.\n\n"
	       "The meaning of the six numbers is that of the documentation of LIGGGHTS-INL "
	       "(compute_bond_counter.txt).",
	.example = "compute status all bond/counter\nthermo_style custom step c_status[2] c_status[3]",
	.state_size = sizeof(struct state),
	.saved = saved,
	.values = values,
	.init = init,
};
