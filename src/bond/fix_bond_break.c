/* Fix bond/break: breaks bonds that are longer than a given length. */
#include "bond/bond_choice.h"
#include "bond/bond_force.h"
#include "bond/bonds.h"
#include "particle/particles.h"

#include "base/banned.h"

struct cut {
	int64_t every, type;
	double most;
	struct ts_bond_chance chance;
	int64_t number[2]; /* broken in the last step of this fix, in all; saved */
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct cut *c = self->state;

	if (c->type > sim->bonds->ntypes)
		return ts_fail(&sim->error, TS_RANGE, &self->where,
			       "fix bond/break: bond type %lld, but there are %d", (long long)c->type,
			       sim->bonds->ntypes);
	return ts_bond_chance_read(sim, "fix bond/break", &c->chance);
}

static bool is_long(const struct ts_instance *self, const struct tsim *sim, size_t b, double *length)
{
	const struct cut *c = self->state;
	const struct ts_bonds *bonds = sim->bonds;
	size_t i = (size_t)bonds->row[b][0], j = (size_t)bonds->row[b][1];
	double d[3];

	*length = ts_bond_separation(sim, i, j, d);
	return bonds->type[b] == c->type && *length > c->most &&
	       ts_in_group(sim->particles, i, self->group) && ts_in_group(sim->particles, j, self->group);
}

static size_t list_options(const struct ts_instance *self, const struct tsim *sim,
			   struct ts_bond_option *option, size_t *bond)
{
	const struct ts_bonds *bonds = sim->bonds;
	size_t n = 0;

	for (size_t b = 0; b < bonds->n; b++) {
		double length;

		if (!is_long(self, sim, b, &length))
			continue;
		bond[n] = b;
		option[n++] = (struct ts_bond_option){ { (size_t)bonds->row[b][0], (size_t)bonds->row[b][1] },
						       { bonds->tag[b][0], bonds->tag[b][1] },
						       -length };
	}
	return n;
}

static bool is_due(const struct ts_instance *self, const struct tsim *sim)
{
	const struct cut *c = self->state;

	return !(sim->clock.step % c->every);
}

static enum ts_status break_bonds(struct ts_instance *self, struct tsim *sim)
{
	struct cut *c = self->state;
	struct ts_bonds *bonds = sim->bonds;
	struct ts_bond_option *option;
	unsigned char *chosen;
	enum ts_status status;
	size_t *bond, n;

	if (!is_due(self, sim))
		return TS_OK;
	option = ts_alloc(bonds->n, sizeof *option);
	chosen = ts_alloc(bonds->n, sizeof *chosen);
	bond = ts_alloc(bonds->n, sizeof *bond);
	status = option && chosen && bond ? TS_OK : ts_nomem(&sim->error);
	n = status == TS_OK ? list_options(self, sim, option, bond) : 0;
	if (status == TS_OK)
		status = ts_bond_choose(sim, option, n, &c->chance, chosen);
	c->number[0] = 0;
	for (size_t k = 0; status == TS_OK && k < n; k++) {
		bonds->breaks[bond[k]] = chosen[k] ? TS_BOND_BREAKS_BY(TS_BOND_CUT) : 0;
		c->number[0] += chosen[k];
	}
	c->number[1] += c->number[0];
	ts_free(option);
	ts_free(chosen);
	ts_free(bond);
	return status == TS_OK && c->number[0] ? ts_bonds_break(sim) : status;
}

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	(void)sim;
	for (int k = 0; k < 2; k++)
		out->data[k] = (double)((const struct cut *)self->state)->number[k];
	return TS_OK;
}

static const char *const names[] = { "last", "all" };
static const struct ts_value values[] = {
	{ "broken", "", "bonds broken in the last step in which this fix acted, and in all", TS_VECTOR, 2,
	  names, eval },
	{ .name = NULL },
};
static const struct ts_saved saved[] = { TS_SAVE_I64(struct cut, number), TS_SAVED_ROWS_END };

static const struct ts_arg args[] = {
	TS_INT("Nevery", struct cut, every, .flags = TS_POSITIONAL, .range = TS_POSITIVE, .unit = "steps",
	       .help = "interval"),
	TS_INT("bondtype", struct cut, type, .flags = TS_POSITIONAL, .range = TS_POSITIVE,
	       .help = "type of the bonds"),
	TS_REAL("Rmax", struct cut, most, .flags = TS_POSITIONAL, .range = TS_NOT_NEGATIVE, .unit = "length",
		.help = "bonds that are longer may break"),
	TS_BOND_CHANCE_ROW(struct cut, chance),
	TS_ARGS_END,
};

TS_STYLE(fix, ts_style, ts_fix_bond_break)
const struct ts_style ts_fix_bond_break = {
	.name = "bond/break",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_STEPS,
	.summary = "breaks bonds that are longer than a given length",
	.doc = "In every step that is a multiple of Nevery, before the forces, bonds of this type that are "
	       "longer than Rmax and whose particles are both in the group may break. A bond breaks if it is "
	       "the longest of these of both its particles, so that a particle loses at most one bond in a "
	       "step; with `prob` only with this probability. The random numbers are functions of the seed, "
	       "the step and the IDs of the particles; they are not those of LAMMPS. Broken bonds are "
	       "recorded as those that break by the bond style, see fix bond/breakage. f_ID[1] is the number "
	       "of bonds broken in the last step in which this fix acted, f_ID[2] in all.",
	.example = "fix cut all bond/break 10 1 1.2\nfix cut all bond/break 10 1 1.2 prob 0.5 49829",
	.args = args,
	.state_size = sizeof(struct cut),
	.saved = saved,
	.values = values,
	.init = init,
	.due = is_due,
	.hook = { [TS_STAGE_POST_INTEGRATE] = break_bonds },
};
