/* Compute: pressure, forces and flows of the film of flow_style reynolds. */
#include "film/film_flow.h"
#include "film/film_measures.h"

#include "base/banned.h"

struct state {
	struct tsim *sim;
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct ts_film_flow *flow;

	((struct state *)self->state)->sim = sim;
	return ts_film_flow_require(sim, "compute film", &self->where, &flow);
}

static enum ts_status eval_vector(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	struct ts_film_measures m;
	struct ts_film_flow *flow;

	(void)sim;
	TS_TRY(ts_film_flow_require(((struct state *)self->state)->sim, "compute film", &self->where, &flow));
	ts_film_measure(&flow->film, &m);
	const double values[] = { m.load,
				  m.centre[0],
				  m.centre[1],
				  m.p_max,
				  m.p_max_at[0],
				  m.p_max_at[1],
				  m.least_gap,
				  m.shear[0][0],
				  m.shear[0][1],
				  m.shear[1][0],
				  m.shear[1][1],
				  m.pressure_force[0],
				  m.pressure_force[1],
				  m.outflow[0][0],
				  m.outflow[0][1],
				  m.outflow[1][0],
				  m.outflow[1][1],
				  m.volume,
				  (double)flow->film.report.cavitated,
				  flow->film.report.balance,
				  flow->film.report.imbalance,
				  m.touch_load,
				  m.touch_area,
				  m.touch_friction[0],
				  m.touch_friction[1] };

	for (size_t k = 0; k < sizeof values / sizeof *values; k++)
		out->data[k] = values[k];
	return TS_OK;
}

static const char *const vector_names[] = { "load",	 "cx",	       "cy",	 "pmax", "px",
					    "py",	 "hmin",       "flx",	 "fly",	 "fux",
					    "fuy",	 "fpx",	       "fpy",	 "qxlo", "qxhi",
					    "qylo",	 "qyhi",       "volume", "ncav", "balance",
					    "imbalance", "asperities", "area",	 "fax",	 "fay" };
enum { NVECTOR = sizeof vector_names / sizeof *vector_names };

static enum ts_status eval_cells(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	struct ts_film_flow *flow;
	const struct ts_film *f;
	double *row;

	(void)sim;
	TS_TRY(ts_film_flow_require(((struct state *)self->state)->sim, "compute film", &self->where, &flow));
	f = &flow->film;
	TS_TRY(ts_table_resize(out, ts_film_cells(f), 5));
	row = out->data;
	for (int j = 0; j < f->n[1]; j++)
		for (int i = 0; i < f->n[0]; i++, row += 5) {
			size_t c = ts_film_at(f, i, j);

			row[0] = ts_film_centre(f, 0, i);
			row[1] = ts_film_centre(f, 1, j);
			row[2] = f->gap[c];
			row[3] = f->p[c];
			row[4] = f->empty[c];
		}
	return TS_OK;
}

static const char *const cell_names[] = { "x", "y", "h", "p", "void" };

static const struct ts_value values[] = {
	{ "forces", "", "load, place of the load and of the largest pressure, forces, flows", TS_VECTOR,
	  NVECTOR, vector_names, eval_vector },
	{ "cells", "", "a row for each cell: x, y, gap, pressure, void fraction", TS_ARRAY, 5, cell_names,
	  eval_cells },
	{ .name = NULL },
};

TS_STYLE(compute, ts_style, ts_compute_film)
const struct ts_style ts_compute_film = {
	.name = "film",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.summary = "Pressure, load, friction and flows of the film of flow_style reynolds",
	.doc = "The vector:\n\n"
	       "  1            load: sum of p - ambient over the area, pushes the surfaces apart\n"
	       "  2, 3         x and y of the centre of pressure; NaN without a load\n"
	       "  4, 5, 6      largest pressure, and its x and y; by a parabola through the highest cells,\n"
	       "               at an edge that of the last cell, half a cell before it\n"
	       "  7            smallest gap; 4 to 7 are NaN where no cell has fluid\n"
	       "  8, 9         shear force of the fluid on the lower surface, along x and y\n"
	       "  10, 11       the same on the upper surface\n"
	       "  12, 13       forces of the pressure along x and y, on both surfaces together: the sum of "
	       "-(p -\n"
	       "               ambient) grad h; they act on the surface that is not plane. At the side of a\n"
	       "               solid cell (`touching solid`) the gap ends with a step to 0\n"
	       "  14 to 17     volume per time that leaves through xlo, xhi, ylo, yhi\n"
	       "  18           volume of the fluid\n"
	       "  19           number of cells in the cavity\n"
	       "  20           largest error of the balance of volume of a cell, volume per time\n"
	       "  21           volume per time that cavitation half or reynolds creates in the cavity\n"
	       "  22           load that `asperities` carry, in addition to the first\n"
	       "  23           area of their contacts\n"
	       "  24, 25       their friction on the upper surface, along x and y\n\n"
	       "Shear stresses are +-eta (1 - theta) (U2 - U1)/h - h/2 grad p, theta being the void fraction "
	       "of\n"
	       "cavitation jfo and eta the viscosity at the pressure p. With slip lengths b1, b2 and H = h + "
	       "b1 + b2 they are +-eta (1 - theta) (U2 - U1)/H\n"
	       "- h (h/2 + b2)/H grad p on the lower surface, and with b1 in place of b2 on the upper one.\n"
	       "Up to a closed edge or a solid cell the pressure is that without flow across.\n"
	       "Between rough surfaces they have the factors of Patir and Cheng (flow_style reynolds): what "
	       "is missing on a\n"
	       "rough surface is the force of the pressure on its asperities, so that the force on a smooth "
	       "one is that between both. In the cavity of half and reynolds the whole gap is sheared. The "
	       "array has a row\n"
	       "for each cell, x varying fastest: x, y, gap, pressure, void fraction.",
	.example = "compute oil all film\nthermo_style custom step c_oil[1] c_oil[4]\n"
		   "fix out all ave/time 100 1 100 c_oil[*] mode vector file film.txt",
	.state_size = sizeof(struct state),
	.values = values,
	.init = init,
};
