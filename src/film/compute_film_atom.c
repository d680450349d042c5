/* Compute film/atom: the film of flow_style reynolds at the particles. */
#include "film/film_flow.h"
#include "film/film_velocity.h"
#include "flow/flow.h"
#include "particle/particles.h"

#include "base/banned.h"

enum { COLUMNS = 6 };

struct state {
	struct tsim *sim;
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct ts_film_flow *flow;

	((struct state *)self->state)->sim = sim;
	return ts_film_flow_require(sim, "compute film/atom", &self->where, &flow);
}

static void sample(const struct ts_instance *flow, const double x[3], double *row)
{
	const struct ts_film_flow *f = flow->state;
	struct ts_film_point point;
	double z, slope[2];

	ts_film_sample_with(&f->film, f->bottom, x, &point, &z, slope);
	row[0] = point.p;
	row[1] = point.gap;
	row[2] = (x[2] - z) / point.gap;
	ts_flow_style_of(flow)->velocity(flow, x, row + 3);
}

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct ts_particles *p = sim->particles;
	struct ts_film_flow *flow;

	TS_TRY(ts_film_flow_require(((struct state *)self->state)->sim, "compute film/atom", &self->where,
				    &flow));
	TS_TRY(ts_table_resize(out, p->n, COLUMNS));
	for (size_t i = 0; i < p->n; i++) {
		double *row = out->data + i * COLUMNS;

		for (int k = 0; k < COLUMNS; k++)
			row[k] = 0;
		if (ts_in_group(p, i, self->group))
			sample(ts_sim_only(sim, TS_KIND_FLOW), p->x[i], row);
	}
	return TS_OK;
}

static const char *const columns[] = { "p", "gap", "s", "ux", "uy", "uz" };

static const struct ts_value values[] = {
	{ "film", "",
	  "pressure, gap, relative height, velocity of the fluid; 0 for particles outside the group",
	  TS_PERATOM, COLUMNS, columns, eval },
	{ .name = NULL },
};

TS_STYLE(compute, ts_style, ts_compute_film_atom)
const struct ts_style ts_compute_film_atom = {
	.name = "film/atom",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.summary = "Pressure, gap and velocity of the film of flow_style reynolds at each particle",
	.doc = "For each particle of the group:\n\n"
	       "  1            pressure of the film at its x and y: linear between the centres of cells and\n"
	       "               up to the edges; beside solid cells that of the cell\n"
	       "  2            gap h there\n"
	       "  3            relative height s = (z - h1)/h of its centre: 0 at the lower surface, 1 at "
	       "the upper\n"
	       "  4, 5, 6      velocity of the fluid at its centre, as drag fixes feel it\n\n"
	       "A particle fits between the surfaces if its radius is at most h s and h (1 - s).\n\n"
	       "Related: flow_style reynolds, compute film.",
	.example = "compute q all film/atom\ndump d all custom 100 film.dump id x y z c_q[1] c_q[2] c_q[3]",
	.state_size = sizeof(struct state),
	.values = values,
	.init = init,
};
