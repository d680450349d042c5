/* Compute bond/counter: bonds created and broken since the last output, and the present number. */
#include "bond/bonds.h"

#include "base/banned.h"

enum { CREATED, BROKEN, INTACT, COLUMNS = 6 };

struct state {
	int64_t mark[2]; /* totals at the last output; saved */
};

/* Outputs in the set-up of a run and between runs do not count as the last one. */
static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	struct state *s = self->state;
	const int64_t total[2] = { sim->bonds->created, sim->bonds->broken };
	bool counts = sim->run.inside && sim->clock.step > sim->clock.first_step;

	for (int k = 0; k < COLUMNS; k++)
		out->data[k] = 0;
	for (int k = CREATED; k <= BROKEN; k++) {
		out->data[k] = (double)(total[k] - s->mark[k]);
		if (counts)
			s->mark[k] = total[k];
	}
	out->data[INTACT] = (double)ts_bonds_count(sim->bonds);
	return TS_OK;
}

static const char *const names[] = {
	"created", "broken", "bonds", "created_wall", "broken_wall", "bonds_wall"
};
static const struct ts_value values[] = {
	{ "counts", "",
	  "bonds created and broken since the last output, present number; the same of bonds with walls: 0",
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
	.doc = "c_ID[1] and c_ID[2] are the numbers of bonds that were created and that broke since this "
	       "compute was output last, c_ID[3] is the present number of bonds. c_ID[4] to c_ID[6] are the "
	       "same of bonds with walls, which do not exist here: 0. Bonds of all particles and of all bond "
	       "styles are counted. Outputs in the set-up of a run and between runs are not taken for the "
	       "last output; that at the end of a run is. The thermo keywords bonds and brokenbonds are the "
	       "present number and the total of broken ones.\n\n"
	       "The meaning of the six numbers is that of the documentation of LIGGGHTS-INL "
	       "(compute_bond_counter.txt).",
	.example = "compute status all bond/counter\nthermo_style custom step c_status[2] c_status[3]",
	.state_size = sizeof(struct state),
	.saved = saved,
	.values = values,
};
