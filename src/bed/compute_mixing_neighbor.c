/* Compute mixing/neighbor: share of unlike particles among the nearest neighbours. */
#include <math.h>

#include "bed/component.h"
#include "bed/nearest.h"
#include "box/domain.h"
#include "particle/particles.h"

#include "base/banned.h"

struct state {
	struct ts_component component;
	int64_t k;

	/* the particles of the group */
	double (*x)[3];
	int32_t *tag, *row;
	int32_t *neighbour; /* [n][k], numbers of particles of the group */
	size_t x_capacity, tag_capacity, row_capacity, neighbour_capacity;
};

/* Copies the particles of the group; *reach: about the distance of neighbours. */
static enum ts_status list_group(struct ts_instance *self, size_t *n, double *reach)
{
	struct state *s = self->state;
	const struct tsim *sim = s->component.sim;
	const struct ts_particles *p = sim->particles;
	double radii = 0;

	TS_TRY(TS_GROW(s->x, s->x_capacity, p->n + 1));
	TS_TRY(TS_GROW(s->tag, s->tag_capacity, p->n + 1));
	TS_TRY(TS_GROW(s->row, s->row_capacity, p->n + 1));
	*n = 0;
	for (size_t i = 0; i < p->n; i++) {
		if (!ts_in_group(p, i, self->group))
			continue;
		for (int d = 0; d < 3; d++)
			s->x[*n][d] = p->x[i][d];
		s->tag[*n] = p->tag[i];
		s->row[(*n)++] = (int32_t)i;
		radii += p->radius[i];
	}
	*reach = *n && radii > 0 ? 3 * radii / (double)*n : 1e-3 * ts_box_length(&sim->domain->box, 0);
	return TS_GROW(s->neighbour, s->neighbour_capacity, *n * (size_t)s->k + 1);
}

/* Finds the neighbours of the *n particles of the group; *n = 0 if there are not more than k. */
static enum ts_status find_neighbours(struct ts_instance *self, size_t *n)
{
	struct state *s = self->state;
	struct tsim *sim = s->component.sim;
	enum ts_status status;
	double reach;

	TS_TRY(ts_component_update(self));
	status = list_group(self, n, &reach);
	if (status == TS_OK && *n <= (size_t)s->k)
		*n = 0;
	if (status == TS_OK && *n)
		status = ts_nearest_find(&sim->domain->box, sim->dimension, (const double(*)[3])s->x, s->tag,
					 *n, (size_t)s->k, reach, s->neighbour);
	return status == TS_NOMEM ? ts_nomem(&sim->error) : status;
}

static bool is_component(const struct state *s, size_t m)
{
	return ts_component_has(&s->component, (size_t)s->row[m]);
}

/* Number of neighbours of particle m of the group that are of the other kind. */
static size_t count_unlike(const struct state *s, size_t m)
{
	size_t unlike = 0;
	bool kind = is_component(s, m);

	for (size_t j = 0; j < (size_t)s->k; j++)
		unlike += is_component(s, (size_t)s->neighbour[m * (size_t)s->k + j]) != kind;
	return unlike;
}

enum { SHARE, RANDOM, PARTICLES, NNUMBERS };
static const char *const numbers[] = { "share", "random", "particles", NULL };

static enum ts_status eval_numbers(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct state *s = self->state;
	double unlike = 0, component = 0, total;
	size_t n;

	(void)sim;
	TS_TRY(find_neighbours(self, &n));
	total = (double)n;
	for (size_t m = 0; m < n; m++) {
		unlike += (double)count_unlike(s, m);
		component += is_component(s, m);
	}
	out->data[SHARE] = n ? unlike / (total * (double)s->k) : 0;
	out->data[RANDOM] = n ? 2 * component * (total - component) / (total * (total - 1)) : 0;
	out->data[PARTICLES] = total;
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

static enum ts_status eval_particles(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct state *s = self->state;
	size_t n;

	TS_TRY(find_neighbours(self, &n));
	TS_TRY(ts_table_resize(out, sim->particles->n, 1));
	for (size_t i = 0; i < sim->particles->n; i++)
		out->data[i] = 0;
	for (size_t m = 0; m < n; m++)
		out->data[s->row[m]] = (double)count_unlike(s, m) / (double)s->k;
	return TS_OK;
}

static void fini(struct ts_instance *self)
{
	struct state *s = self->state;

	ts_component_fini(self);
	ts_free(s->x);
	ts_free(s->tag);
	ts_free(s->row);
	ts_free(s->neighbour);
}

static const struct ts_value values[] = {
	{ "index", "",
	  "share of unlike neighbours divided by that of the random mixture; 0 where it is not defined",
	  TS_SCALAR, 1, NULL, eval_index },
	{ "numbers", "", "share of unlike neighbours, that of the random mixture, number of particles",
	  TS_VECTOR, NNUMBERS, numbers, eval_numbers },
	{ "unlike", "",
	  "share of unlike particles among the neighbours of each particle; 0 outside the group", TS_PERATOM,
	  1, NULL, eval_particles },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_COMPONENT_ROW(struct state),
	TS_INT("neighbors", struct state, k, .fallback = "12", .range = TS_WITHIN, .lo = 1, .hi = 1000,
	       .help = "number of nearest neighbours of each particle"),
	TS_ARGS_END,
};

TS_STYLE(compute, ts_style, ts_compute_mixing_neighbor)
const struct ts_style ts_compute_mixing_neighbor = {
	.name = "mixing/neighbor",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.summary = "How well a component is mixed, from the nearest neighbors of each particle",
	.doc = "The nearest neighbors method: of each particle of the group the k nearest others are found, "
	       "and the share X of those that belong to the other component, the mean over all particles, is "
	       "divided by its mean X_r over all ways to exchange particles,\n\n"
	       "    M = X/X_r,    X_r = 2 n m/((n + m)(n + m - 1))\n\n"
	       "for n particles of the component and m others. M = 1 is a random mixture, near 0 a "
	       "segregated one, > 1 an ordered one. For n = m and many particles M is the index of Godlieb, "
	       "Deen and Kuipers, 2 X. It depends neither on a grid nor on contacts, so it also holds for "
	       "fluidized and flying particles. As a value of each particle c_ID is the share of unlike ones "
	       "among its neighbors.\n\n"
	       "Neighbors are found across periodic faces, too. Distances are those of the centres; of "
	       "equally distant particles the one with the smaller ID is taken first. M is 0 where it is not "
	       "defined: for k or fewer particles (c_ID[3] is then 0, too), or with a single component.",
	.example = "compute m all mixing/neighbor type 2\n"
		   "compute m all mixing/neighbor group red neighbors 20\n"
		   "dump d all custom 1000 post/mixing*.txt id type x y z c_m",
	.cite = "W. Godlieb, N. G. Deen, J. A. M. Kuipers, Proc. 6th Int. Conf. on CFD in Oil & Gas, "
		"Trondheim (2008)",
	.args = args,
	.state_size = sizeof(struct state),
	.values = values,
	.init = ts_component_init,
	.fini = fini,
};
