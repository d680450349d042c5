/* Fix bond/create: bonds each particle to its nearest partner. */
#include "bond/bond_choice.h"
#include "bond/bond_force.h"
#include "bond/bond_search.h"
#include "neigh/neigh.h"
#include "particle/particles.h"

#include "base/banned.h"

struct create {
	int64_t every, itype, jtype, bond_type;
	double reach;
	struct ts_words param[2]; /* iparam, jparam */
	struct ts_bond_chance chance;
	/* from these, for either type: most bonds of the type, 0: any; type that a particle with as many gets */
	int64_t most[2], becomes[2];
	int64_t number[2]; /* created in the last step of this fix, in all; saved */
};

/* Which of the two types a particle type is: 0, 1; -1: none. */
static int side_of(const struct create *c, int32_t type)
{
	return type == c->itype ? 0 : type == c->jtype ? 1 : -1;
}

/* Words MAXBOND NEWTYPE; false: they are not. */
static bool parse_param(struct ts_words w, const struct tsim *sim, int64_t *most, int64_t *becomes)
{
	return w.n == 2 && ts_parse_int(w.word[0].text, most) && *most >= 0 &&
	       ts_parse_int(w.word[1].text, becomes) && *becomes >= 1 && *becomes <= sim->particles->ntypes;
}

static int gives_type(const struct ts_instance *self, const struct tsim *sim)
{
	const struct create *c = self->state;
	int64_t largest = 0;

	for (int side = 0; side < 2; side++) {
		int64_t most, becomes;

		if (parse_param(c->param[side], sim, &most, &becomes) && becomes > largest)
			largest = becomes;
	}
	return (int)largest;
}

static enum ts_status read_param(const struct ts_instance *self, struct tsim *sim, int side)
{
	struct create *c = self->state;
	struct ts_words w = c->param[side];

	c->most[side] = 0;
	c->becomes[side] = side ? c->jtype : c->itype;
	if (!w.n)
		return TS_OK;
	if (!parse_param(w, sim, &c->most[side], &c->becomes[side]))
		return ts_fail(&sim->error, TS_SYNTAX, &w.word[0].place,
			       "fix bond/create: expected %cparam MAXBOND NEWTYPE, a number and a particle "
			       "type",
			       "ij"[side]);
	return TS_OK;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct create *c = self->state;
	int ntypes = sim->particles->ntypes;

	if (c->itype > ntypes || c->jtype > ntypes)
		return ts_fail(&sim->error, TS_RANGE, &self->where,
			       "fix bond/create: particle type %lld, but there are only %d types",
			       (long long)(c->itype > c->jtype ? c->itype : c->jtype), ntypes);
	if (c->bond_type > sim->bonds->ntypes)
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "fix bond/create: there is no bond type %lld: `bond_coeff %lld ...` or "
			       "`create_box ... bond/types` must come before this fix",
			       (long long)c->bond_type, (long long)c->bond_type);
	if (ts_sim_only(sim, TS_KIND_BOND) && !ts_bond_has_coeffs(sim, c->bond_type))
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "fix bond/create makes bonds of type %lld, but there is no `bond_coeff %lld "
			       "...`",
			       (long long)c->bond_type, (long long)c->bond_type);
	for (int side = 0; side < 2; side++)
		TS_TRY(read_param(self, sim, side));
	if (c->itype == c->jtype && (c->most[0] != c->most[1] || c->becomes[0] != c->becomes[1]))
		return ts_fail(&sim->error, TS_SYNTAX, &self->where,
			       "fix bond/create: iparam and jparam must be the same for partners of one "
			       "type");
	return ts_bond_chance_read(sim, "fix bond/create", &c->chance);
}

/* Bonds of each particle of the type that is created. */
static int64_t *count_bonds(const struct create *c, const struct tsim *sim)
{
	const struct ts_bonds *b = sim->bonds;
	int64_t *count = ts_alloc(sim->particles->n, sizeof *count);

	for (size_t k = 0; count && k < b->n; k++)
		for (int s = 0; b->type[k] == c->bond_type && s < 2; s++)
			count[b->row[k][s]]++;
	return count;
}

/* What decides in one step. */
struct choice {
	struct create *fix;
	int64_t *count;
	struct ts_bond_candidates found;
};

static bool wanted(const void *context, const struct tsim *sim, size_t i, size_t j, double distance)
{
	const struct choice *choice = context;
	const struct create *c = choice->fix;
	const struct ts_particles *p = sim->particles;
	int a = side_of(c, p->type[i]), b = side_of(c, p->type[j]);

	(void)distance;
	if (a < 0 || b < 0 || (a == b && c->itype != c->jtype))
		return false;
	return (!c->most[a] || choice->count[i] < c->most[a]) &&
	       (!c->most[b] || choice->count[j] < c->most[b]);
}

/* A particle that has as many bonds as it may have gets another type. */
static void update_type(struct tsim *sim, const struct choice *choice, size_t i)
{
	const struct create *c = choice->fix;
	struct ts_particles *p = sim->particles;
	int side = side_of(c, p->type[i]);

	choice->count[i]++;
	if (!c->most[side] || choice->count[i] < c->most[side] || p->type[i] == c->becomes[side])
		return;
	p->type[i] = (int32_t)c->becomes[side];
	sim->neigh->stale = true;
}

static enum ts_status add_bonds(struct tsim *sim, const struct choice *choice, const unsigned char *chosen)
{
	struct create *c = choice->fix;

	for (size_t k = 0; k < choice->found.n; k++) {
		const struct ts_bond_candidate *pair = &choice->found.pair[k];

		if (!chosen[k])
			continue;
		TS_TRY(ts_bonds_add(sim, pair->tag[0], pair->tag[1], (int)c->bond_type, pair->distance));
		for (int s = 0; s < 2; s++)
			update_type(sim, choice, pair->row[s]);
		c->number[0]++;
	}
	return TS_OK;
}

static enum ts_status choose_and_add(struct tsim *sim, const struct choice *choice)
{
	size_t n = choice->found.n;
	struct ts_bond_option *option = ts_alloc(n, sizeof *option);
	unsigned char *chosen = ts_alloc(n, sizeof *chosen);
	enum ts_status status = option && chosen ? TS_OK : ts_nomem(&sim->error);

	for (size_t k = 0; status == TS_OK && k < n; k++) {
		const struct ts_bond_candidate *p = &choice->found.pair[k];

		option[k] = (struct ts_bond_option){ { p->row[0], p->row[1] },
						     { p->tag[0], p->tag[1] },
						     p->distance };
	}
	if (status == TS_OK)
		status = ts_bond_choose(sim, option, n, &choice->fix->chance, chosen);
	if (status == TS_OK)
		status = add_bonds(sim, choice, chosen);
	ts_free(option);
	ts_free(chosen);
	return status;
}

static bool is_due(const struct ts_instance *self, const struct tsim *sim)
{
	const struct create *c = self->state;

	return !(sim->clock.step % c->every);
}

static enum ts_status create_bonds(struct ts_instance *self, struct tsim *sim)
{
	struct create *c = self->state;
	struct choice choice = { .fix = c };
	enum ts_status status;

	if (!is_due(self, sim))
		return TS_OK;
	c->number[0] = 0;
	choice.count = count_bonds(c, sim);
	status = choice.count ? TS_OK : ts_nomem(&sim->error);
	if (status == TS_OK)
		status = ts_bond_search(sim, self->group, c->reach, wanted, &choice, &self->where,
					&choice.found);
	if (status == TS_OK)
		status = choose_and_add(sim, &choice);
	c->number[1] += c->number[0];
	ts_free(choice.found.pair);
	ts_free(choice.count);
	return status == TS_OK && c->number[0] ? ts_bonds_added(sim) : status;
}

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	(void)sim;
	for (int k = 0; k < 2; k++)
		out->data[k] = (double)((const struct create *)self->state)->number[k];
	return TS_OK;
}

static const char *const names[] = { "last", "all" };
static const struct ts_value values[] = {
	{ "created", "", "bonds created in the last step in which this fix acted, and in all", TS_VECTOR, 2,
	  names, eval },
	{ .name = NULL },
};
static const struct ts_saved saved[] = { TS_SAVE_I64(struct create, number), TS_SAVED_ROWS_END };

#define TYPE(name, field, text) \
	TS_INT(name, struct create, field, .flags = TS_POSITIONAL, .range = TS_POSITIVE, .help = text)

static const struct ts_arg args[] = {
	TS_INT("Nevery", struct create, every, .flags = TS_POSITIONAL, .range = TS_POSITIVE, .unit = "steps",
	       .help = "interval"),
	TYPE("itype", itype, "particle type of one partner"),
	TYPE("jtype", jtype, "particle type of the other partner; may be the same"),
	TS_REAL("Rmin", struct create, reach, .flags = TS_POSITIONAL, .range = TS_POSITIVE, .unit = "length",
		.help = "pairs with a smaller distance of the centres may be bonded"),
	TYPE("bondtype", bond_type, "bond type"),
	TS_SOME_KEYWORD("iparam", struct create, param[0], 0,
			.help = "MAXBOND NEWTYPE: most bonds of this type of a particle of itype, 0: any; "
				"the type that a particle with as many gets"),
	TS_SOME_KEYWORD("jparam", struct create, param[1], 0, .help = "the same of jtype"),
	TS_BOND_CHANCE_ROW(struct create, chance),
	TS_ARGS_END,
};

TS_STYLE(fix, ts_style, ts_fix_bond_create)
const struct ts_style ts_fix_bond_create = {
	.name = "bond/create",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_STEPS,
	.summary = "bonds each particle to its nearest partner",
	.doc = "In every step that is a multiple of Nevery, before the forces, pairs of the group with these "
	       "types, closer than Rmin and not bonded, may get a bond, whose rest length is their distance. "
	       "A pair is bonded if each of the two is the nearest of these partners of the other, so that a "
	       "particle gets at most one bond in a step; with `prob` only with this probability. Particles "
	       "with MAXBOND bonds of this type get no more, and become particles of NEWTYPE; a bond that "
	       "broke does not count, in LAMMPS it does if fix bond/break deleted it. The random numbers are "
	       "functions of the seed, the step and the IDs of the particles; they are not those of LAMMPS. "
	       "f_ID[1] is the number of bonds created in the last step in which this fix acted, "
	       "f_ID[2] in all. fix bond/create/gran bonds all near pairs.",
	.example = "fix join all bond/create 10 1 2 0.8 1\n"
		   "fix join all bond/create 1 1 1 1.05 1 prob 0.5 85784 iparam 2 1 jparam 2 1",
	.args = args,
	.state_size = sizeof(struct create),
	.saved = saved,
	.values = values,
	.init = init,
	.due = is_due,
	.gives_type = gives_type,
	.hook = { [TS_STAGE_POST_INTEGRATE] = create_bonds },
};
