/* Compute property/local: IDs and types of the particles of pairs and bonds. */
#include "bond/bonds.h"
#include "contact/contact_view.h"
#include "core/name_list.h"

#include "base/banned.h"

enum list { NEIGHBOURS, CONTACTS, BONDS };

typedef double column_fn(const struct tsim *sim, const struct ts_contact_view *v);

static double id_of_first(const struct tsim *sim, const struct ts_contact_view *v)
{
	return sim->particles->tag[v->a];
}

static double id_of_second(const struct tsim *sim, const struct ts_contact_view *v)
{
	return sim->particles->tag[v->b];
}

static double type_of_first(const struct tsim *sim, const struct ts_contact_view *v)
{
	return sim->particles->type[v->a];
}

static double type_of_second(const struct tsim *sim, const struct ts_contact_view *v)
{
	return sim->particles->type[v->b];
}

static double bond_type(const struct tsim *sim, const struct ts_contact_view *v)
{
	return sim->bonds->type[v->row];
}

static const struct column {
	const char *name;
	column_fn *value;
	enum list list;
} columns[] = {
	{ "natom1", id_of_first, NEIGHBOURS },	 { "natom2", id_of_second, NEIGHBOURS },
	{ "ntype1", type_of_first, NEIGHBOURS }, { "ntype2", type_of_second, NEIGHBOURS },
	{ "patom1", id_of_first, CONTACTS },	 { "patom2", id_of_second, CONTACTS },
	{ "ptype1", type_of_first, CONTACTS },	 { "ptype2", type_of_second, CONTACTS },
	{ "batom1", id_of_first, BONDS },	 { "batom2", id_of_second, BONDS },
	{ "btype", bond_type, BONDS },		 { .name = NULL },
};

struct property {
	struct ts_words words;
	int cutoff;
	struct ts_name_list list;
	struct tsim *sim;
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct property *s = self->state;

	s->sim = sim;
	sim->neigh->keep_forces = true;
	TS_TRY(ts_name_list_read(sim, "compute property/local", &self->arena, s->words, columns,
				 sizeof *columns, &s->list));
	for (size_t k = 1; k < s->list.n; k++)
		if (columns[s->list.item[k]].list != columns[s->list.item[0]].list)
			return ts_fail(&sim->error, TS_SYNTAX, &s->words.word[k].place,
				       "compute property/local: '%s' and '%s' are of different lists",
				       s->words.word[0].text, s->words.word[k].text);
	return TS_OK;
}

static void write_row(const struct property *s, const struct tsim *sim, const struct ts_contact_view *view,
		      struct ts_table *out, size_t n)
{
	for (size_t k = 0; k < s->list.n; k++)
		out->data[n * s->list.n + k] = columns[s->list.item[k]].value(sim, view);
}

static enum ts_status list_bonds(const struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct property *s = self->state;
	size_t n = 0;

	TS_TRY(ts_table_resize(out, sim->bonds->n, s->list.n));
	for (size_t b = 0; b < sim->bonds->n; b++) {
		struct ts_contact_view view;

		if (!ts_in_group(sim->particles, (size_t)sim->bonds->row[b][0], self->group) ||
		    !ts_in_group(sim->particles, (size_t)sim->bonds->row[b][1], self->group))
			continue;
		ts_contact_view_of_bond(sim, b, &view);
		write_row(s, sim, &view, out, n++);
	}
	out->rows = n;
	return TS_OK;
}

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct property *s = self->state;
	enum list list = columns[s->list.item[0]].list;
	struct ts_contact_rows rows;
	enum ts_status status;

	TS_TRY(ts_contacts_forces(s->sim, self));
	if (list == BONDS)
		return list_bonds(self, sim, out);
	TS_TRY(ts_contact_rows(s->sim, self->group, list != NEIGHBOURS, &rows));
	status = ts_table_resize(out, rows.n, s->list.n);
	for (size_t n = 0; n < rows.n && status == TS_OK; n++) {
		struct ts_contact_view view;

		ts_contact_view(sim, rows.row[n].r, &view);
		write_row(s, sim, &view, out, n);
	}
	ts_contact_rows_release(&rows);
	return status;
}

static size_t width(const struct ts_instance *self)
{
	return ((const struct property *)self->state)->list.n;
}

static const struct ts_value values[] = {
	{ "partners", "", "a row for each pair, the smaller ID first", TS_LOCAL, 0, NULL, eval },
	{ .name = NULL },
};

static const char *const cutoffs[] = { "type", "radius", NULL };

static const struct ts_arg args[] = {
	TS_LIST("columns", struct property, words,
		.help = "natom1 natom2 ntype1 ntype2, patom1 patom2 ptype1 ptype2, or batom1 batom2 btype"),
	TS_ENUM("cutoff", struct property, cutoff, cutoffs, .fallback = "radius",
		.help = "no effect: contacts are defined by the radii"),
	TS_ARGS_END,
};

TS_STYLE(compute, ts_style, ts_compute_property_local)
const struct ts_style ts_compute_property_local = {
	.name = "property/local",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE,
	.summary = "IDs and types of the particles of contacts and bonds",
	.doc = "A table with a row for each pair whose particles are both in the group. Words with n list "
	       "the pairs of the neighbour list, those with p the contacts, those with b the bonds; atom1, "
	       "atom2 are IDs, type1, type2 particle types, btype is the bond type. The rows are those of "
	       "compute pair/local, pair/gran/local and bond/local, in the same order. Contacts are those of "
	       "the last force computation.",
	.example = "compute who all property/local patom1 patom2\n"
		   "compute how all pair/local dist force\n"
		   "dump d all local 100 post/pairs*.txt index c_who[1] c_who[2] c_how[1] c_how[2]",
	.args = args,
	.state_size = sizeof(struct property),
	.values = values,
	.width = width,
	.init = init,
};
