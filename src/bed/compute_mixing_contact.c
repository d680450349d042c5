/* Compute mixing/contact: share of contacts between unlike particles. */
#include "bed/component.h"
#include "box/domain.h"
#include "geom/pairs.h"
#include "particle/particles.h"

#include "base/banned.h"

struct state {
	struct ts_component component;
	double gap;
	int random;
};

enum random { BY_PARTICLES, BY_CONTACTS };
static const char *const randoms[] = { "particles", "contacts", NULL };

struct counts {
	double particles[2]; /* rest, component */
	double ends[3]; /* ends of contacts: rest-rest, unlike, component-component; two for each contact */
};

struct task {
	const struct ts_instance *self;
	const struct ts_component *component;
	const struct ts_particles *p;
	double gap;
	struct counts *counts;
};

static void count_pair(void *context, size_t i, size_t j, const double d[3])
{
	const struct task *t = context;
	double reach = t->p->radius[i] + t->p->radius[j] + t->gap;

	if (!ts_in_group(t->p, i, t->self->group) || !ts_in_group(t->p, j, t->self->group) ||
	    !(d[0] * d[0] + d[1] * d[1] + d[2] * d[2] < reach * reach))
		return;
	t->counts->ends[ts_component_has(t->component, i) + ts_component_has(t->component, j)] += 1;
}

static enum ts_status count(struct ts_instance *self, struct counts *out)
{
	const struct state *s = self->state;
	const struct tsim *sim = s->component.sim;
	const struct ts_particles *p = sim->particles;
	struct task task = { self, &s->component, p, s->gap, out };
	double most = 0;

	*out = (struct counts){ 0 };
	TS_TRY(ts_component_update(self));
	for (size_t i = 0; i < p->n; i++) {
		if (!ts_in_group(p, i, self->group))
			continue;
		out->particles[ts_component_has(&s->component, i)] += 1;
		most = p->radius[i] > most ? p->radius[i] : most;
	}
	if (!(2 * most + s->gap > 0))
		return TS_OK;
	return ts_pairs_visit(&sim->domain->box, sim->dimension, (const double(*)[3])p->x, p->n,
			      2 * most + s->gap, count_pair, &task);
}

enum { SHARE, RANDOM, CONTACTS, LIKE, UNLIKE, REST, NNUMBERS };
static const char *const numbers[] = { "share", "random", "contacts", "like", "unlike", "rest", NULL };

/* The share of unlike contacts if particles are exchanged at random: of the ordered pairs of different particles 2 n m
 * of N (N - 1) are unlike. By contacts: each end of a contact is at the component with its share of the ends. */
static double random_share(enum random random, const struct counts *c)
{
	double n = c->particles[0] + c->particles[1], ends = c->ends[0] + c->ends[1] + c->ends[2], part;

	if (random == BY_PARTICLES)
		return n > 1 ? 2 * c->particles[0] * c->particles[1] / (n * (n - 1)) : 0;
	part = ends > 0 ? (c->ends[2] + 0.5 * c->ends[1]) / ends : 0;
	return 2 * part * (1 - part);
}

static enum ts_status eval_numbers(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	struct counts c;
	double ends;

	(void)sim;
	TS_TRY(count(self, &c));
	ends = c.ends[0] + c.ends[1] + c.ends[2];
	out->data[SHARE] = ends > 0 ? c.ends[1] / ends : 0;
	out->data[RANDOM] = random_share((enum random)((const struct state *)self->state)->random, &c);
	out->data[CONTACTS] = 0.5 * ends;
	out->data[LIKE] = 0.5 * c.ends[2];
	out->data[UNLIKE] = 0.5 * c.ends[1];
	out->data[REST] = 0.5 * c.ends[0];
	return TS_OK;
}

static enum ts_status eval_index(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	double number[NNUMBERS];
	struct ts_table all = { .data = number };

	TS_TRY(eval_numbers(self, sim, &all));
	out->data[0] = number[RANDOM] > 0 ? number[SHARE] / number[RANDOM] : 0;
	return TS_OK;
}

static const struct ts_value values[] = {
	{ "index", "",
	  "share of unlike contacts divided by that of the random mixture; 0 where it is not defined",
	  TS_SCALAR, 1, NULL, eval_index },
	{ "numbers", "",
	  "share of unlike contacts, that of the random mixture; number of contacts, of those within the "
	  "component, unlike ones, within the rest",
	  TS_VECTOR, NNUMBERS, numbers, eval_numbers },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_COMPONENT_ROW(struct state),
	TS_REAL("gap", struct state, gap, .fallback = "0", .range = TS_NOT_NEGATIVE, .unit = "length",
		.help = "particles with surfaces nearer than this are in contact; 0: those that overlap"),
	TS_ENUM("random", struct state, random, randoms, .fallback = "particles",
		.help = "what is exchanged in the random mixture: particles, or the ends of contacts"),
	TS_ARGS_END,
};

TS_STYLE(compute, ts_style, ts_compute_mixing_contact)
const struct ts_style ts_compute_mixing_contact = {
	.name = "mixing/contact",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.summary = "How well a component is mixed, from the share of unlike contacts",
	.doc = "An index of mixing that needs no samples: the share X of the contacts that are between a "
	       "particle of the component and one of the rest, divided by its mean X_r over all random "
	       "mixtures,\n\n"
	       "    M = X/X_r\n\n"
	       "M = 1 is a random mixture; near 0 a segregated one, in which only the particles at the "
	       "boundary of the two regions have unlike contacts; > 1 an ordered one (up to 1/X_r, if all "
	       "contacts are unlike). 1 - M is a segregation index: 1 segregated, 0 random, < 0 ordered. It "
	       "measures mixing on the scale of the particles, whereas compute mixing does so on the scale "
	       "of the samples.\n\n"
	       "`random particles`: if the n particles of the component and the m others change places at "
	       "random, X_r = 2 n m/((n + m)(n + m - 1)), exactly. Large particles have more contacts than "
	       "small ones, which makes X differ from this in a random mixture of unequal sizes; `random "
	       "contacts` takes the contacts of each component as given: X_r = 2 k (1 - k) with the share k "
	       "of the ends of contacts that are at the component.\n\n"
	       "Contacts are overlaps between particles of the group as they are at present, across periodic "
	       "faces, too, with or without force; with `gap` also particles nearer than that, which suits "
	       "packings whose contacts have opened. M is 0 where it is not defined: without contacts, or "
	       "with a single component; c_ID[3], the number of contacts, and c_ID[2] tell.",
	.example = "compute m all mixing/contact type 2\n"
		   "compute m all mixing/contact group red gap 0.0001 random contacts",
	.args = args,
	.state_size = sizeof(struct state),
	.values = values,
	.init = ts_component_init,
	.fini = ts_component_fini,
};
