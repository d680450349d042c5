/* Fix bond/create/gran: bonds between particles that are near each other, during a run. */
#include <math.h>

#include "base/sort.h"
#include "bond/bond_reference.h"
#include "box/domain.h"
#include "neigh/coincide.h"
#include "neigh/neigh.h"
#include "particle/particles.h"

#include "base/banned.h"

struct create {
	int64_t every, itype, jtype, bond_type, most;
	double cutoff;
	int64_t created; /* saved */
};

/* A pair to be bonded; the smaller identity first. */
struct candidate {
	int32_t tag[2];
	size_t row[2];
	double distance;
};

struct candidates {
	struct candidate *pair;
	size_t n, capacity;
};

/* Position along x, for the sweep. */
struct place {
	double x;
	size_t i;
};

static int compare_places(const void *a, const void *b)
{
	double x = ((const struct place *)a)->x, y = ((const struct place *)b)->x;

	return (x > y) - (x < y);
}

static int compare_candidates(const void *a, const void *b)
{
	const int32_t *s = ((const struct candidate *)a)->tag, *t = ((const struct candidate *)b)->tag;

	return s[0] != t[0] ? (s[0] > t[0]) - (s[0] < t[0]) : (s[1] > t[1]) - (s[1] < t[1]);
}

static bool has_types(const struct create *c, const struct ts_particles *p, size_t i, size_t j)
{
	return (p->type[i] == c->itype && p->type[j] == c->jtype) ||
	       (p->type[i] == c->jtype && p->type[j] == c->itype);
}

static enum ts_status consider_pair(struct tsim *sim, const struct ts_instance *self, size_t i, size_t j,
				    struct candidates *out)
{
	const struct create *c = self->state;
	const struct ts_particles *p = sim->particles;
	double d[3], distance;

	if (p->tag[i] > p->tag[j]) {
		size_t k = i;

		i = j;
		j = k;
	}
	if (!has_types(c, p, i, j))
		return TS_OK;
	distance = ts_bond_separation(sim, i, j, d);
	if (!(distance < c->cutoff) || ts_bonds_has(sim->bonds, p->tag[i], p->tag[j]))
		return TS_OK;
	TS_TRY(ts_coincide_bond(sim, &self->where, i, j, distance));
	if (TS_GROW(out->pair, out->capacity, out->n + 1) != TS_OK)
		return ts_nomem(&sim->error);
	out->pair[out->n++] = (struct candidate){ { p->tag[i], p->tag[j] }, { i, j }, distance };
	return TS_OK;
}

/* Sweep along x, around a periodic box. */
static enum ts_status sweep(struct tsim *sim, const struct ts_instance *self, const struct place *place,
			    size_t n, struct candidates *out)
{
	const struct create *c = self->state;
	const struct ts_box *box = &sim->domain->box;
	double length = ts_box_length(box, 0);
	bool around = ts_box_periodic(box, 0);

	for (size_t k = 0; k < n; k++)
		for (size_t step = 1; step < n; step++) {
			size_t m = k + step;
			double shift = 0;

			if (m >= n && !around)
				break;
			if (m >= n) {
				m -= n;
				shift = length;
			}
			if (!(place[m].x + shift - place[k].x < c->cutoff))
				break;
			TS_TRY(consider_pair(sim, self, place[k].i, place[m].i, out));
		}
	return TS_OK;
}

static enum ts_status find_candidates(struct tsim *sim, const struct ts_instance *self,
				      struct candidates *out)
{
	const struct ts_particles *p = sim->particles;
	const struct ts_box *box = &sim->domain->box;
	double length = ts_box_length(box, 0);
	struct place *place = ts_alloc(p->n, sizeof *place);
	enum ts_status status;
	size_t n = 0;

	if (!place)
		return ts_nomem(&sim->error);
	for (size_t i = 0; i < p->n; i++)
		if (ts_in_group(p, i, self->group)) {
			double x = p->x[i][0] - box->lo[0];

			place[n++] =
				(struct place){ ts_box_periodic(box, 0) ? x - length * floor(x / length) : x,
						i };
		}
	ts_sort(place, n, sizeof *place, compare_places);
	status = sweep(sim, self, place, n, out);
	ts_free(place);
	/* by identities: which bonds are created does not depend on the order of particles */
	ts_sort(out->pair, out->n, sizeof *out->pair, compare_candidates);
	return status;
}

static enum ts_status add_bonds(struct tsim *sim, struct create *c, const struct candidates *found)
{
	int64_t *fresh = ts_alloc(sim->particles->n, sizeof *fresh);
	enum ts_status status = fresh ? TS_OK : ts_nomem(&sim->error);

	for (size_t k = 0; status == TS_OK && k < found->n; k++) {
		const struct candidate *p = &found->pair[k];

		/* in a small periodic box a pair is found twice */
		if ((k && !compare_candidates(p, p - 1)) || fresh[p->row[0]] >= c->most ||
		    fresh[p->row[1]] >= c->most)
			continue;
		fresh[p->row[0]]++;
		fresh[p->row[1]]++;
		c->created++;
		status = ts_bonds_add(sim, p->tag[0], p->tag[1], (int)c->bond_type, p->distance);
	}
	ts_free(fresh);
	return status;
}

static enum ts_status create_bonds(struct ts_instance *self, struct tsim *sim)
{
	struct create *c = self->state;
	struct candidates found = { 0 };
	int64_t before = c->created;
	enum ts_status status;

	if (!c->every || sim->clock.step % c->every)
		return TS_OK;
	status = find_candidates(sim, self, &found);
	if (status == TS_OK)
		status = add_bonds(sim, c, &found);
	ts_free(found.pair);
	if (status != TS_OK || c->created == before)
		return status;
	ts_bonds_sort(sim->bonds);
	TS_TRY(ts_bond_reference_complete(sim));
	sim->neigh->stale |= sim->neigh->skip_bonded;
	return ts_bonds_connect(sim);
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	const struct create *c = self->state;
	const struct ts_instance *style = ts_sim_only(sim, TS_KIND_BOND);
	const struct ts_bond *bond = style ? style->state : NULL;
	int ntypes = sim->particles->ntypes;

	if (c->itype > ntypes || c->jtype > ntypes)
		return ts_fail(&sim->error, TS_RANGE, &self->where,
			       "fix bond/create/gran: particle type %lld, but there are only %d types",
			       (long long)(c->itype > c->jtype ? c->itype : c->jtype), ntypes);
	if (!bond || c->bond_type > sim->bonds->ntypes || (size_t)c->bond_type >= bond->coeffs.n ||
	    !bond->coeffs.given[c->bond_type])
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
	.hook = { [TS_STAGE_POST_INTEGRATE] = create_bonds },
};
