/* Compute: distances and forces of bonds. */
#include "bond/bonds.h"
#include "contact/pair_columns.h"
#include "core/name_list.h"

#include "base/banned.h"

struct state {
	struct ts_words words;
	struct ts_name_list list;
	struct tsim *sim;
};

static double column_rest_length(const struct tsim *sim, const struct ts_contact_view *view)
{
	return sim->bonds->rest[view->row];
}

static const struct ts_pair_column columns[] = { TS_PAIR_COLUMNS,
						 { "rest", column_rest_length },
						 { .name = NULL } };

static enum ts_status init_columns(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	s->sim = sim;
	sim->bonds->shown = true;
	return ts_name_list_read(sim, "compute bond/local", &self->arena, s->words, columns, sizeof *columns,
				 &s->list);
}

static bool is_in_group(const struct ts_instance *self, const struct tsim *sim, size_t r)
{
	const int32_t *row = sim->bonds->row[r];

	return ts_in_group(sim->particles, (size_t)row[0], self->group) &&
	       ts_in_group(sim->particles, (size_t)row[1], self->group);
}

static enum ts_status eval_list(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct state *s = self->state;
	size_t rows = sim->bonds->n, n = 0;

	TS_TRY(ts_contacts_require(s->sim, self));
	TS_TRY(ts_table_resize(out, rows, s->list.n));
	for (size_t r = 0; r < rows; r++) {
		struct ts_contact_view view;

		if (!is_in_group(self, sim, r))
			continue;
		ts_contact_view_of_bond(sim, r, &view);
		for (size_t k = 0; k < s->list.n; k++)
			out->data[n * s->list.n + k] = columns[s->list.item[k]].value(sim, &view);
		n++;
	}
	out->rows = n;
	return TS_OK;
}

static const struct ts_value values[] = {
	{ "list", "", "a row for each bond", TS_LOCAL, 0, NULL, eval_list },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_REST("columns", struct state, words, .help = "dist, rest, force, fx, fy, fz, dx, dy, dz"),
	TS_ARGS_END,
};

TS_STYLE(compute, ts_style, ts_compute_bond_local)
const struct ts_style ts_compute_bond_local = {
	.name = "bond/local",
	.kind = TS_KIND_COMPUTE,
	.summary = "length and force of each bond",
	.doc = "A local array with one row for each bond whose partners are both in the group. Columns: "
	       "dist (length), rest (rest length), force (force along the bond, > 0 repulsive), fx fy fz "
	       "(force on the partner with the smaller ID), dx dy dz (vector from the other partner to it). "
	       "Forces are those of the last force computation. Compute property/local gives the IDs of the "
	       "partners in the same order.",
	.example = "compute b all bond/local dist force",
	.args = args,
	.state_size = sizeof(struct state),
	.values = values,
	.init = init_columns,
};
