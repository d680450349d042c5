/* Compute: distances and forces of bonds. */
#include <math.h>

#include "bond/bond_moment.h"
#include "contact/contact_energy.h"
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

static double column_energy(const struct tsim *sim, const struct ts_contact_view *view)
{
	return ts_bond_elastic_energy(sim, view->row);
}

/* ---- bonds that transmit moments */

static struct ts_bond_element element_of(const struct tsim *sim, const struct ts_contact_view *view,
					 struct ts_bond_answer *state)
{
	struct ts_bond_element e;

	ts_bond_state_of(sim, view->row, &e, state);
	return e;
}

#define OF_STATE(name, value)                                                          \
	static double name(const struct tsim *sim, const struct ts_contact_view *view) \
	{                                                                              \
		struct ts_bond_answer s;                                               \
		struct ts_bond_element e = element_of(sim, view, &s);                  \
                                                                                       \
		(void)e;                                                               \
		return value;                                                          \
	}
OF_STATE(column_shear, s.load[TS_BOND_SHEAR] * s.acting)
OF_STATE(column_bending, s.load[TS_BOND_BENDING] * s.acting)
OF_STATE(column_twist, s.load[TS_BOND_TWIST] * s.acting)
OF_STATE(column_sigma, s.tension)
OF_STATE(column_tau, s.shear)
OF_STATE(column_sigma_strength, e.tension)
OF_STATE(column_tau_strength, e.shear)
OF_STATE(column_ratio,
	 fmax(fmax(s.tension / e.tension, ts_bond_shear_ratio(&e, &s)), s.compression / e.compression))
OF_STATE(column_mode,
	 isinf(e.tension) && isinf(e.shear) && isinf(e.compression) ? 0 : (double)ts_bond_failure_of(&e, &s))

#define OF_LOAD(name, k)                                                               \
	static double name(const struct tsim *sim, const struct ts_contact_view *view) \
	{                                                                              \
		return sim->bonds->load[view->row].torque[0][k];                       \
	}
OF_LOAD(column_tx, 0)
OF_LOAD(column_ty, 1)
OF_LOAD(column_tz, 2)

/* The columns from `shear` on are those of bonds that transmit moments. */
static const struct ts_pair_column columns[] = { TS_PAIR_COLUMNS,
						 { "rest", column_rest_length },
						 { "engpot", column_energy },
						 { "shear", column_shear },
						 { "bending", column_bending },
						 { "twist", column_twist },
						 { "tx", column_tx },
						 { "ty", column_ty },
						 { "tz", column_tz },
						 { "sigma", column_sigma },
						 { "tau", column_tau },
						 { "sigma_c", column_sigma_strength },
						 { "tau_c", column_tau_strength },
						 { "ratio", column_ratio },
						 { "mode", column_mode },
						 { .name = NULL } };

static bool is_of_moments(int item)
{
	int first = 0;

	while (columns[first].value != column_shear)
		first++;
	return item >= first;
}

static enum ts_status refuse_central_springs(const struct ts_instance *self, struct tsim *sim)
{
	const struct state *s = self->state;
	const struct ts_instance *style = ts_sim_only(sim, TS_KIND_BOND);

	for (size_t k = 0; k < s->list.n; k++)
		if (is_of_moments(s->list.item[k]) && !(style && ts_bond_style_of(style)->element))
			return ts_fail(&sim->error, TS_STATE, &s->words.word[k].place,
				       "compute bond/local: %s is known of bonds that transmit moments, such "
				       "as bond_style parallel; %s%s",
				       s->words.word[k].text,
				       style ? "the bond style is " : "there is no bond style",
				       style ? style->style->name : "");
	return TS_OK;
}

static enum ts_status init_columns(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	s->sim = sim;
	sim->bonds->shown = true;
	TS_TRY(ts_name_list_read(sim, "compute bond/local", &self->arena, s->words, columns, sizeof *columns,
				 &s->list));
	return refuse_central_springs(self, sim);
}

static bool shows_energy(const struct state *s)
{
	for (size_t k = 0; k < s->list.n; k++)
		if (columns[s->list.item[k]].value == column_energy)
			return true;
	return false;
}

static bool is_in_group(const struct ts_instance *self, const struct tsim *sim, size_t r)
{
	const int32_t *row = sim->bonds->row[r];

	return ts_in_group(sim->particles, (size_t)row[0], self->group) &&
	       ts_in_group(sim->particles, (size_t)row[1], self->group);
}

static enum ts_status require_bond_style(struct tsim *sim, const struct ts_instance *self)
{
	const struct ts_instance *style = ts_sim_only(sim, TS_KIND_BOND);

	if (!sim->bonds->n || (style && ((const struct ts_bond *)style->state)->coeffs.n))
		return TS_OK;
	return ts_fail(&sim->error, TS_STATE, &self->where,
		       "compute bond/local: there is no bond_style with bond_coeff");
}

static enum ts_status eval_list(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	static const struct ts_contact_energy_parts of_bonds = { .bond = true };
	const struct state *s = self->state;
	size_t rows = sim->bonds->n, n = 0;

	TS_TRY(require_bond_style(s->sim, self));
	TS_TRY(shows_energy(s) ? ts_contact_energy_require(s->sim, self, &of_bonds)
			       : ts_contacts_require(s->sim, self));
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

static size_t width(const struct ts_instance *self)
{
	return ((const struct state *)self->state)->list.n;
}

static const struct ts_value values[] = {
	{ "list", "", "a row for each bond", TS_LOCAL, 0, NULL, eval_list },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_REST("columns", struct state, words,
		.help = "dist, rest, engpot, force, fx, fy, fz, dx, dy, dz; shear, bending, twist, tx, ty, "
			"tz, sigma, tau, sigma_c, tau_c, ratio, mode"),
	TS_ARGS_END,
};

TS_STYLE(compute, ts_style, ts_compute_bond_local)
const struct ts_style ts_compute_bond_local = {
	.name = "bond/local",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE,
	.summary = "length, force, moments and stresses of each bond",
	.doc = "A local array with one row for each bond whose partners are both in the group. Columns: "
	       "dist (length), rest (length without force), engpot (elastic energy), force (force along the "
	       "bond, > 0 repulsive), fx fy fz (force on the partner with the smaller ID), dx dy dz (vector "
	       "from the other partner to it). Of bonds that transmit moments also: shear (shear force), "
	       "bending (bending moment) and twist (torque about the bond, with its sign), without damping; "
	       "tx ty tz (torque on the partner with the smaller ID); sigma and tau (largest stresses of "
	       "the section, as defined by the bond style); sigma_c and tau_c (strengths of this bond, inf: "
	       "none); ratio (largest ratio of stress and strength); mode (that of this ratio: 1 tension, 2 "
	       "shear, 3 compression; 0: the bond has no strengths). Forces are those of the last force "
	       "computation. Compute property/local gives the IDs of the partners in the same order.",
	.example = "compute b all bond/local dist force\n"
		   "compute s all bond/local sigma tau ratio mode",
	.args = args,
	.state_size = sizeof(struct state),
	.values = values,
	.width = width,
	.init = init_columns,
};
