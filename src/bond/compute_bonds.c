#include "bond/bonds.h"
#include "particle/columns.h"
#include "particle/rank_sums.h"

#include <stdio.h>
#include <string.h>

#include "base/banned.h"

enum { COLUMNS = 11 };

struct state {
	struct tsim *sim;
	/* with ranks: what all of them look at, while none has all bonds */
	int64_t count;
	size_t column; /* of particles: their bonds */
};

static bool is_in_group(const struct ts_instance *self, const struct tsim *sim, size_t b)
{
	const int32_t *row = sim->bonds->row[b];

	return ts_in_group(sim->particles, (size_t)row[0], self->group) &&
	       ts_in_group(sim->particles, (size_t)row[1], self->group);
}

/* Bonds whose first particle is one of the local ones: with ranks each bond is counted by one of them. */
static int64_t count_bonds(const struct ts_instance *self, const struct tsim *sim)
{
	int64_t n = 0;

	for (size_t b = 0; b < sim->bonds->n; b++)
		n += (size_t)sim->bonds->row[b][0] < sim->particles->n && is_in_group(self, sim, b);
	return n;
}

static void count_by_particle(const struct ts_instance *self, const struct tsim *sim, double *number)
{
	const size_t n = sim->particles->n;

	for (size_t i = 0; i < n; i++)
		number[i] = 0;
	for (size_t b = 0; b < sim->bonds->n; b++)
		for (int s = 0; is_in_group(self, sim, b) && s < 2; s++)
			if ((size_t)sim->bonds->row[b][s] < n)
				number[sim->bonds->row[b][s]] += 1;
}

static enum ts_status join(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	s->count = count_bonds(self, sim);
	ts_rank_sums_count(sim, &s->count);
	count_by_particle(self, sim, sim->particles->column[s->column].data);
	return TS_OK;
}

static enum ts_status eval_count(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct state *s = self->state;

	TS_TRY(ts_bonds_connect_if_changed(s->sim));
	out->data[0] = (double)(sim->run.looks ? s->count : count_bonds(self, sim));
	return TS_OK;
}

static enum ts_status eval_peratom(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct state *s = self->state;
	const struct ts_particles *p = sim->particles;

	TS_TRY(ts_bonds_connect_if_changed(s->sim));
	TS_TRY(ts_table_resize(out, p->n, 1));
	if (sim->run.looks && p->n)
		memcpy(out->data, p->column[s->column].data, p->n * sizeof *out->data);
	else
		count_by_particle(self, sim, out->data);
	return TS_OK;
}

static enum ts_status eval_local(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct ts_bonds *bonds = sim->bonds;
	const struct ts_particles *p = sim->particles;
	size_t n = 0;

	TS_TRY(ts_bonds_connect_if_changed(((const struct state *)self->state)->sim));
	TS_TRY(ts_table_resize(out, bonds->n, COLUMNS));
	for (size_t b = 0; b < bonds->n; b++) {
		double *row = out->data + COLUMNS * n;

		if (!is_in_group(self, sim, b))
			continue;
		n++;
		row[0] = bonds->tag[b][0];
		row[1] = bonds->tag[b][1];
		row[2] = bonds->type[b];
		row[3] = bonds->rest[b];
		row[4] = bonds->tension[b];
		for (int k = 0; k < 3; k++) {
			row[5 + k] = p->x[bonds->row[b][0]][k];
			row[8 + k] = p->x[bonds->row[b][1]][k];
		}
	}
	return ts_table_resize(out, n, COLUMNS);
}

/* Whether the instance may read the rows of the bonds: fixes that average numbers, by their name alone, do not. */
static bool reads_rows(const struct ts_instance *inst, const char *name)
{
	const size_t length = strlen(name);
	bool reads = false;

	for (size_t k = 0; k < inst->words.n; k++) {
		const char *text = inst->words.word[k].text;

		if (strncmp(text, name, length) == 0)
			reads |= text[length] == '[' ||
				 (!text[length] && !ts_streq(inst->style->name, "ave/time"));
	}
	return reads;
}

/* With ranks these all get the bonds of the others only if some output reads the rows. */
static enum ts_status show_rows(const struct ts_instance *self, struct tsim *sim)
{
	char name[300];

	snprintf(name, sizeof name, "c_%s", self->id);
	for (int kind = 0; kind < TS_NKIND; kind++)
		for (size_t k = 0; k < sim->instances[kind].n; k++)
			sim->run.needs_lists |= reads_rows(sim->instances[kind].item[k], name);
	sim->run.shows_lists |= sim->run.needs_lists;
	return TS_OK;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	char name[300];

	s->sim = sim;
	sim->bonds->shown = true; /* the list contains tensions */
	if (!sim->world)
		return TS_OK;
	snprintf(name, sizeof name, "bonds_%s", self->id);
	TS_TRY(ts_particles_add_column(sim, name, 1, TS_COL_RESULT, &s->column));
	return show_rows(self, sim);
}

static const char *const names[] = {
	"i", "j", "type", "rest", "tension", "xi", "yi", "zi", "xj", "yj", "zj"
};
static const struct ts_value values[] = {
	{ "count", "", "number of bonds", TS_SCALAR, 1, NULL, eval_count },
	{ "coordination", "", "number of bonds of each particle", TS_PERATOM, 1, NULL, eval_peratom },
	{ "list", "", "one row per bond, with the positions of both partners", TS_LOCAL, COLUMNS, names,
	  eval_local },
	{ .name = NULL },
};

TS_STYLE(compute, ts_style, ts_compute_bonds)
const struct ts_style ts_compute_bonds = {
	.name = "bonds",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.join = join,
	.state_size = sizeof(struct state),
	.summary = "number, coordination number and list of bonds",
	.doc = "Considers bonds with both partners in the group. The scalar c_ID is their number, the "
	       "per-atom vector c_ID the number of bonds of each particle, and the local array c_ID[k] (dump "
	       "local) lists them: IDs i and j of the partners, bond type, rest length, tension and the "
	       "positions of both. The tension is the force along the bond in the last force computation, > "
	       "0 attractive.",
	.example = "compute nb rock bonds\ndump b all local/vtk 1000 post/bonds*.vtp c_nb",
	.values = values,
	.init = init,
};
