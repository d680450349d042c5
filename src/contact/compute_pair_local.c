/* Compute pair/local: distances and forces of contacts. */
#include "contact/contact_energy.h"
#include "contact/pair_columns.h"
#include "core/name_list.h"
#include "math/vec3.h"

#include "base/banned.h"

struct state {
	struct ts_words words;
	int cutoff;
	struct ts_name_list list;
	struct tsim *sim;
};

static double energy(const struct tsim *sim, const struct ts_contact_view *view)
{
	return ts_contact_energy_of_row(sim, view->row);
}

/* The force on the first particle without its part along the line of centres. */
static void tangential(const struct ts_contact_view *view, double out[3])
{
	double square = ts_dot(view->d, view->d);

	ts_scale(1, view->force, out);
	if (square > 0)
		ts_axpy(-ts_dot(view->force, view->d) / square, view->d, out);
}

#define TANGENTIAL(name, k)                                                            \
	static double name(const struct tsim *sim, const struct ts_contact_view *view) \
	{                                                                              \
		double t[3];                                                           \
		(void)sim;                                                             \
		tangential(view, t);                                                   \
		return t[k];                                                           \
	}
TANGENTIAL(tangential_x, 0)
TANGENTIAL(tangential_y, 1)
TANGENTIAL(tangential_z, 2)

static double tangential_size(const struct tsim *sim, const struct ts_contact_view *view)
{
	double t[3];

	(void)sim;
	tangential(view, t);
	return ts_norm(t);
}

/* The p columns have the names that LAMMPS gives them in its granular pair styles. */
static const struct ts_pair_column columns[] = {
	TS_PAIR_COLUMNS,	{ "eng", energy },	   { "p1", tangential_x }, { "p2", tangential_y },
	{ "p3", tangential_z }, { "p4", tangential_size }, { .name = NULL },
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	s->sim = sim;
	sim->neigh->keep_forces = true;
	return ts_name_list_read(sim, "compute pair/local", &self->arena, s->words, columns, sizeof *columns,
				 &s->list);
}

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct state *s = self->state;
	struct ts_contact_rows rows;
	enum ts_status status;

	for (size_t k = 0; k < s->list.n; k++)
		if (columns[s->list.item[k]].value == energy)
			TS_TRY(ts_contact_energy_require(s->sim, self,
							 &(struct ts_contact_energy_parts){ .pair = true }));
	TS_TRY(ts_contacts_forces(s->sim, self));
	TS_TRY(ts_contact_rows(s->sim, self->group, true, &rows));
	status = ts_table_resize(out, rows.n, s->list.n);
	for (size_t n = 0; n < rows.n && status == TS_OK; n++) {
		struct ts_contact_view view;

		ts_contact_view(sim, rows.row[n].r, &view);
		for (size_t k = 0; k < s->list.n; k++)
			out->data[n * s->list.n + k] = columns[s->list.item[k]].value(sim, &view);
	}
	ts_contact_rows_release(&rows);
	return status;
}

static size_t width(const struct ts_instance *self)
{
	return ((const struct state *)self->state)->list.n;
}

static const struct ts_value values[] = {
	{ "list", "", "a row for each contact", TS_LOCAL, 0, NULL, eval },
	{ .name = NULL },
};

static const char *const cutoffs[] = { "type", "radius", NULL };

static const struct ts_arg args[] = {
	TS_LIST("columns", struct state, words,
		.help = "dist, force, fx, fy, fz, dx, dy, dz, eng, p1, p2, p3, p4"),
	TS_ENUM("cutoff", struct state, cutoff, cutoffs, .fallback = "radius",
		.help = "no effect: contacts are defined by the radii"),
	TS_ARGS_END,
};

TS_STYLE(compute, ts_style, ts_compute_pair_local)
const struct ts_style ts_compute_pair_local = {
	.name = "pair/local",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE,
	.summary = "Distance, force and energy of each contact",
	.doc = "A table with a row for each contact whose particles are both in the group: dist is the "
	       "distance of the centres, force the force along the line of centres, > 0 if repulsive; fx fy "
	       "fz is the force on the particle with the smaller ID, dx dy dz the vector to it from the "
	       "other one. Periodic images are taken into account. Contacts are those of the last force "
	       "computation; compute property/local gives the IDs, in the same order.\n\n"
	       "eng is the elastic energy of the contact, whose sum is that of `compute pe pair`; in "
	       "LAMMPS it is 0 for granular contacts. p1 p2 p3 are the part of fx fy fz across the line of "
	       "centres, and p4 is its magnitude, as in the granular pair styles of LAMMPS, whose further "
	       "columns (p5 ...) there are not.",
	.example = "compute f all pair/local dist force fx fy fz",
	.args = args,
	.state_size = sizeof(struct state),
	.values = values,
	.width = width,
	.init = init,
};
