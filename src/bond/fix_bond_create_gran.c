/* Fix bond/create/gran: bonds between particles that are near each other, during a run. */
#include "bond/bond_force.h"
#include "bond/bond_search.h"
#include "particle/particles.h"

#include "base/banned.h"

struct create {
	int64_t every, itype, jtype, bond_type, most;
	double cutoff;
	int64_t created; /* saved */
};

static bool has_types(const void *context, const struct tsim *sim, size_t i, size_t j, double distance)
{
	const struct create *c = context;
	const struct ts_particles *p = sim->particles;

	(void)distance;
	return (p->type[i] == c->itype && p->type[j] == c->jtype) ||
	       (p->type[i] == c->jtype && p->type[j] == c->itype);
}

static enum ts_status add_bonds(struct tsim *sim, struct create *c, const struct ts_bond_candidates *found)
{
	int64_t *fresh = ts_alloc(sim->particles->n, sizeof *fresh);
	enum ts_status status = fresh ? TS_OK : ts_nomem(&sim->error);

	for (size_t k = 0; status == TS_OK && k < found->n; k++) {
		const struct ts_bond_candidate *p = &found->pair[k];

		if (fresh[p->row[0]] >= c->most || fresh[p->row[1]] >= c->most)
			continue;
		fresh[p->row[0]]++;
		fresh[p->row[1]]++;
		c->created++;
		status = ts_bonds_add(sim, p->tag[0], p->tag[1], (int)c->bond_type, p->distance);
	}
	ts_free(fresh);
	return status;
}

static bool is_due(const struct ts_instance *self, const struct tsim *sim)
{
	const struct create *c = self->state;

	return c->every && !(sim->clock.step % c->every);
}

static enum ts_status create_bonds(struct ts_instance *self, struct tsim *sim)
{
	struct create *c = self->state;
	struct ts_bond_candidates found = { 0 };
	int64_t before = c->created;
	enum ts_status status;

	if (!is_due(self, sim))
		return TS_OK;
	status = ts_bond_search(sim, self->group, c->cutoff, has_types, c, &self->where, &found);
	if (status == TS_OK)
		status = add_bonds(sim, c, &found);
	ts_free(found.pair);
	return status != TS_OK || c->created == before ? status : ts_bonds_added(sim);
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	const struct create *c = self->state;
	int ntypes = sim->particles->ntypes;

	if (c->itype > ntypes || c->jtype > ntypes)
		return ts_fail(&sim->error, TS_RANGE, &self->where,
			       "fix bond/create/gran: particle type %lld, but there are only %d types",
			       (long long)(c->itype > c->jtype ? c->itype : c->jtype), ntypes);
	if (!ts_bond_has_coeffs(sim, c->bond_type))
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "fix bond/create/gran: there is no `bond_coeff %lld ...` yet; it must come "
			       "before this fix",
			       (long long)c->bond_type);
	return TS_OK;
}

static const struct ts_arg every_rows[] = {
	TS_INT("every", struct create, every, .flags = TS_POSITIONAL, .range = TS_NOT_NEGATIVE,
	       .unit = "steps", .help = "interval; 0: no more bonds are created"),
	TS_ARGS_END,
};

static enum ts_status modify(struct ts_instance *self, struct tsim *sim, struct ts_words words, size_t *used)
{
	struct ts_words rest = ts_words_from(words, 1);

	*used = 0;
	if (!ts_streq(words.word[0].text, "every"))
		return TS_OK;
	rest.n = rest.n < 1 ? rest.n : 1;
	*used = 1 + rest.n;
	return ts_args_parse(sim, "fix_modify every", every_rows, rest, &words.word[0].place, &self->arena,
			     self->state);
}

static enum ts_status eval_created(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	(void)sim;
	out->data[0] = (double)((const struct create *)self->state)->created;
	return TS_OK;
}

static const struct ts_value values[] = {
	{ "created", "", "bonds created by this fix", TS_SCALAR, 1, NULL, eval_created },
	{ .name = NULL },
};

static const struct ts_saved saved[] = {
	TS_SAVE_I64(struct create, created),
	TS_SAVED_ROWS_END,
};

#define TYPE(name, field, text) \
	TS_INT(name, struct create, field, .flags = TS_POSITIONAL, .range = TS_POSITIVE, .help = text)

static const struct ts_arg args[] = {
	TS_INT("every", struct create, every, .flags = TS_POSITIONAL, .range = TS_NOT_NEGATIVE,
	       .unit = "steps", .help = "interval; 0: never"),
	TYPE("itype", itype, "particle type of one partner"),
	TYPE("jtype", jtype, "particle type of the other partner; may be the same"),
	TS_REAL("cutoff", struct create, cutoff, .flags = TS_POSITIONAL, .range = TS_POSITIVE,
		.unit = "length", .help = "pairs with a smaller distance of the centres are bonded"),
	TYPE("bondtype", bond_type, "bond type"),
	TYPE("newperts", most, "largest number of new bonds of a particle in a step"),
	TS_ARGS_END,
};

TS_STYLE(fix, ts_style, ts_fix_bond_create_gran)
const struct ts_style ts_fix_bond_create_gran = {
	.name = "bond/create/gran",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_STEPS,
	.summary = "bonds particles that are near each other, during a run",
	.doc = "In every step that is a multiple of `every`, pairs of the group with these types, closer "
	       "than the cutoff and not bonded, get a bond of the given type, whose rest length is their "
	       "distance. A particle gets at most `newperts` bonds in a step; pairs are taken in the order "
	       "of their IDs. `fix_modify ID every N` changes the interval, 0 ends the creation: LIGGGHTS "
	       "scripts do this after `run 1`. f_ID is the number of bonds created. For bonds at the start "
	       "of a run create_bonds is simpler.\n\n"
	       "The grammar is that of LIGGGHTS with bonds (richti83/LIGGGHTS-WITH-BONDS, LIGGGHTS-PFM, "
	       "Flexible Fibers). There `bonds_per_atom` of atom_style also limits the number of bonds; here "
	       "it does not.",
	.example = "fix bonds all bond/create/gran 1 1 1 1.05e-3 1 6\n"
		   "run 1\n"
		   "fix_modify bonds every 0",
	.args = args,
	.state_size = sizeof(struct create),
	.saved = saved,
	.values = values,
	.init = init,
	.modify = modify,
	.due = is_due,
	.hook = { [TS_STAGE_POST_INTEGRATE] = create_bonds },
};
