/* Compute: profiles of the automaton across the gap. */
#include "automaton/automaton.h"

#include "base/banned.h"

enum { Y, U, V, FILL, TEMPERATURE, NCOLUMNS };
static const char *const columns[] = { "y", "u", "v", "nu", "T", NULL };

enum { SLIP_LOWER, SLIP_UPPER, DUE, MOVED, COLLIDED, CLIPPED, NNUMBERS };
static const char *const numbers[] = {
	"slip_lower", "slip_upper", "due", "moved", "collided", "clipped", NULL
};

struct state {
	struct tsim *sim;
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct ts_automaton *a;

	((struct state *)self->state)->sim = sim;
	return ts_automaton_require(sim, "compute automaton/profile", &self->where, &a);
}

static enum ts_status require(struct ts_instance *self, struct ts_automaton **out)
{
	return ts_automaton_require(((struct state *)self->state)->sim, "compute automaton/profile",
				    &self->where, out);
}

/* Rows without granules have the velocity 0. */
static void fill_row(const struct ts_automaton *a, int y, double *out)
{
	const double unit = ts_automaton_unit(a);
	struct ts_automaton_row row;
	double n, u, v;

	ts_automaton_sum_row(&a->lattice, y, &row);
	n = row.granules > 0 ? (double)row.granules : 1;
	u = (double)row.x / n;
	v = (double)row.y / n;
	out[Y] = a->lo[1] + (y + 0.5) * a->cell;
	out[U] = unit * u;
	out[V] = unit * v;
	out[FILL] = row.open > 0 ? (double)row.granules / (double)row.open : 0;
	out[TEMPERATURE] = unit * unit * ((double)row.squares / n - u * u - v * v) / 2;
}

static enum ts_status eval_rows(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	struct ts_automaton *a;

	(void)sim;
	TS_TRY(require(self, &a));
	if (ts_table_resize(out, (size_t)a->lattice.ny, NCOLUMNS) != TS_OK)
		return ts_nomem(&((struct state *)self->state)->sim->error);
	for (int y = 0; y < a->lattice.ny; y++)
		fill_row(a, y, out->data + (size_t)y * NCOLUMNS);
	return TS_OK;
}

static enum ts_status eval_numbers(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	struct ts_automaton *a;
	double row[2][NCOLUMNS], updates;

	(void)sim;
	TS_TRY(require(self, &a));
	fill_row(a, 0, row[0]);
	fill_row(a, a->lattice.ny - 1, row[1]);
	updates = a->steps > 0 ? (double)a->steps * (double)a->lattice.granules : 1;
	out->data[SLIP_LOWER] = a->wall[0] - row[0][U];
	out->data[SLIP_UPPER] = a->wall[1] - row[1][U];
	out->data[DUE] = (double)a->count.due / updates;
	out->data[MOVED] = (double)a->count.moved / updates;
	out->data[COLLIDED] = (double)a->count.collided / updates;
	out->data[CLIPPED] = (double)a->count.clipped / updates;
	return TS_OK;
}

static enum ts_status eval_granules(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	struct ts_automaton *a;
	double n = 0;

	(void)sim;
	TS_TRY(require(self, &a));
	for (int y = 0; y < a->lattice.ny; y++) {
		struct ts_automaton_row row;

		ts_automaton_sum_row(&a->lattice, y, &row);
		n += (double)row.granules;
	}
	out->data[0] = n;
	return TS_OK;
}

static const struct ts_value values[] = {
	{ "granules", "", "number of granules, counted", TS_SCALAR, 1, NULL, eval_granules },
	{ "numbers", "",
	  "slip_lower, slip_upper: velocity of the wall minus that of the row beside it [velocity]; due, "
	  "moved, collided, clipped: granules that were to move, that did, collisions with granules, and "
	  "results of collisions that were reduced to one cell a step, by granules and steps so far",
	  TS_VECTOR, NNUMBERS, numbers, eval_numbers },
	{ "rows", "", "one row for each row of cells, from ylo on: y u v nu T", TS_ARRAY, NCOLUMNS, columns,
	  eval_rows },
	{ .name = NULL },
};

TS_STYLE(compute, ts_style, ts_compute_automaton_profile)
const struct ts_style ts_compute_automaton_profile = {
	.name = "automaton/profile",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.summary = "Velocity, fill and granular temperature of an automaton across the gap",
	.doc = "One row for each row of cells: y, the coordinate of its centre; u and v, the mean velocity "
	       "of\n"
	       "its granules (0 if there are none); nu, granules by cells without obstacle; T, the granular\n"
	       "temperature, the mean of ((u_i - u)^2 + (v_i - v)^2)/2. c_ID[i][j] is column j of row i,\n"
	       "c_ID[*] in fix ave/time with `mode vector` are all columns. c_ID is the number of granules,\n"
	       "which never changes, and c_ID[1] and c_ID[2] are the slip at the lower and the upper wall.",
	.example = "compute p all automaton/profile\n"
		   "fix av all ave/time 10 100 1000 c_p[*] mode vector file profile.txt\n"
		   "fix slip all ave/time 10 100 1000 c_p[1] c_p[2] file slip.txt",
	.state_size = sizeof(struct state),
	.values = values,
	.init = init,
};
