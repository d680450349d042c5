/* Compute coordination: mean coordination numbers of a packing. */
#include "box/domain.h"
#include "geom/pairs.h"
#include "particle/particles.h"
#include "wall/wall.h"

#include "base/banned.h"

struct state {
	double gap;
	bool walls;
	uint32_t *count; /* [n] contacts of each particle */
	size_t capacity;
	struct tsim *sim;
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	size_t k = 0;

	s->sim = sim;
	if (s->walls && !ts_walls_next(sim, &k, NULL))
		return ts_fail(&sim->error, TS_STATE, ts_instance_word(self, "walls"),
			       "compute coordination: there is no fix wall/gran whose contacts could count");
	if (s->walls)
		ts_walls_want_reports(sim);
	return TS_OK;
}

struct task {
	const struct ts_particles *p;
	struct state *s;
	int group;
};

static void count_contact(void *context, size_t i, size_t j, const double d[3])
{
	const struct task *t = context;
	double reach = t->p->radius[i] + t->p->radius[j] + t->s->gap;

	if (ts_in_group(t->p, i, t->group) && ts_in_group(t->p, j, t->group))
		t->s->count[i] += d[0] * d[0] + d[1] * d[1] + d[2] * d[2] < reach * reach;
}

/* Adds the contacts with walls in the last force computation. Returns how many; a particle in a corner has one with each
 * surface. */
static double count_walls(const struct ts_instance *self, const struct state *s)
{
	const struct ts_particles *p = s->sim->particles;
	const struct ts_wall *w;
	double found = 0;

	for (size_t at = 0; s->walls && (w = ts_walls_next(s->sim, &at, NULL));)
		for (size_t k = 0; k < w->contacts.n; k++) {
			size_t i = (size_t)w->contacts.row[k];

			if (i >= p->n || !ts_in_group(p, i, self->group) || !ts_wall_report(&w->contacts, k))
				continue;
			s->count[i]++;
			found++;
		}
	return found;
}

/* Counts the contacts of all particles. */
static enum ts_status count_contacts(struct ts_instance *self)
{
	struct state *s = self->state;
	const struct ts_particles *p = s->sim->particles;
	struct task task = { p, s, self->group };
	double most = 0;

	if (s->walls)
		TS_TRY(ts_walls_connect(s->sim));
	if (TS_GROW(s->count, s->capacity, p->n + 1) != TS_OK)
		return ts_nomem(&s->sim->error);
	for (size_t i = 0; i < p->n; i++) {
		s->count[i] = 0;
		if (ts_in_group(p, i, self->group) && p->radius[i] > most)
			most = p->radius[i];
	}
	if (!(2 * most + s->gap > 0))
		return TS_OK;
	return ts_pairs_visit(&s->sim->domain->box, s->sim->dimension, (const double(*)[3])p->x, p->n,
			      2 * most + s->gap, count_contact, &task);
}

enum { GEOMETRIC, MECHANICAL, NONE, ONE, MOST, CONTACTS, PARTICLES, WALLS, NNUMBERS };
static const char *const numbers[] = { "geometric", "mechanical", "none",  "one", "most",
				       "contacts",  "particles",  "walls", NULL };

static enum ts_status eval_numbers(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct state *s = self->state;
	double *number = out->data, ends = 0, bearing;

	TS_TRY(count_contacts(self));
	for (int k = 0; k < NNUMBERS; k++)
		number[k] = 0;
	number[WALLS] = count_walls(self, s);
	for (size_t i = 0; i < sim->particles->n; i++) {
		uint32_t count = s->count[i];

		if (!ts_in_group(sim->particles, i, self->group))
			continue;
		number[PARTICLES] += 1;
		number[NONE] += count == 0;
		number[ONE] += count == 1;
		number[MOST] = count > number[MOST] ? count : number[MOST];
		ends += count;
	}
	bearing = number[PARTICLES] - number[NONE] - number[ONE];
	number[GEOMETRIC] = number[PARTICLES] > 0 ? ends / number[PARTICLES] : 0;
	number[MECHANICAL] = bearing > 0 ? (ends - number[ONE]) / bearing : 0;
	number[CONTACTS] = 0.5 * (ends - number[WALLS]);
	return TS_OK;
}

static enum ts_status eval_mean(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	double number[NNUMBERS];
	struct ts_table all = { .data = number };

	TS_TRY(eval_numbers(self, sim, &all));
	out->data[0] = number[GEOMETRIC];
	return TS_OK;
}

static void fini(struct ts_instance *self)
{
	ts_free(((struct state *)self->state)->count);
}

static const struct ts_value values[] = {
	{ "coordination", "", "mean coordination number; 0 without particles", TS_SCALAR, 1, NULL,
	  eval_mean },
	{ "numbers", "",
	  "mean and mechanical coordination number; numbers of particles without contact and with one; "
	  "largest number of contacts of a particle; number of contacts between particles, of particles, of "
	  "contacts with walls",
	  TS_VECTOR, NNUMBERS, numbers, eval_numbers },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_REAL("gap", struct state, gap, .fallback = "0", .range = TS_NOT_NEGATIVE, .unit = "length",
		.help = "particles with surfaces nearer than this are in contact; 0: those that overlap"),
	TS_BOOL("walls", struct state, walls, .fallback = "no",
		.help = "whether contacts with walls count, too: those of the last force computation"),
	TS_ARGS_END,
};

TS_STYLE(compute, ts_style, ts_compute_coordination)
const struct ts_style ts_compute_coordination = {
	.name = "coordination",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE,
	.summary = "Mean and mechanical coordination number of a packing",
	.doc = "The mean coordination number of the particles of the group, and the mechanical one, of those "
	       "that can bear a load:\n\n"
	       "    Z = 2 C/N,    Z_m = (2 C - N_1)/(N - N_0 - N_1)\n\n"
	       "for C contacts between N particles of the group, N_0 of which have no contact and N_1 a "
	       "single one (Thornton). Contacts are overlaps at present, across periodic faces, too, with or "
	       "without force; with `gap` also particles nearer than that. Contacts with particles outside "
	       "the group do not count, those with walls with `walls yes`: then each is an end of a contact "
	       "of one particle, as 2 C is the sum of the ends, and a particle in a corner has one with each "
	       "surface. Without it a particle that lies on a wall alone has none. compute contact/atom "
	       "gives the contacts of each particle. Z_m is 0 if no particle has two contacts.",
	.example = "compute z all coordination\nthermo_style custom step atoms c_z c_z[2]",
	.cite = "C. Thornton, Geotechnique 50 (2000) 43",
	.args = args,
	.state_size = sizeof(struct state),
	.values = values,
	.init = init,
	.fini = fini,
};
