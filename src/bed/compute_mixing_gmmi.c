/* Compute mixing/gmmi: the generalised mean mixing index, from centres of components. */
#include <math.h>

#include "bed/component.h"
#include "box/domain.h"
#include "math/exactsum.h"
#include "particle/particles.h"

#include "base/banned.h"

struct state {
	struct ts_component component;
	double reference[3]; /* NaN: the smallest coordinate */
};

/* Along one axis, of the component [1] and the rest [0]. */
struct axis {
	double n[2], mean[2];
	double lowest, all, deviation; /* of all particles: smallest coordinate, mean, standard deviation */
};

static double sum_coordinate(const struct ts_instance *self, int d, int which, double from, int power)
{
	const struct state *s = self->state;
	const struct ts_particles *p = s->component.sim->particles;
	struct ts_exactsum sum = ts_exactsum_start();

	for (size_t i = 0; i < p->n; i++) {
		double x = p->x[i][d] - from;

		if (ts_in_group(p, i, self->group) &&
		    (which < 0 || ts_component_has(&s->component, i) == (which > 0)))
			ts_exactsum_add(&sum, power == 2 ? x * x : power == 1 ? x : 1);
	}
	return ts_exactsum_value(&sum);
}

static void measure_axis(const struct ts_instance *self, int d, struct axis *a)
{
	const struct state *s = self->state;
	const struct ts_particles *p = s->component.sim->particles;
	double n;

	*a = (struct axis){ .lowest = INFINITY };
	for (size_t i = 0; i < p->n; i++)
		if (ts_in_group(p, i, self->group))
			a->lowest = fmin(a->lowest, p->x[i][d]);
	for (int k = 0; k < 2; k++) {
		a->n[k] = sum_coordinate(self, d, k, 0, 0);
		a->mean[k] = a->n[k] > 0 ? sum_coordinate(self, d, k, 0, 1) / a->n[k] : 0;
	}
	n = a->n[0] + a->n[1];
	a->all = n > 0 ? sum_coordinate(self, d, -1, 0, 1) / n : 0;
	a->deviation = n > 0 ? sqrt(sum_coordinate(self, d, -1, a->all, 2) / n) : 0;
}

/* Whether the index is defined along axis d: both components, a mean that is not at the reference, and coordinates that
 * are not periodic. */
static bool is_defined(const struct state *s, int d, const struct axis *a, double reference)
{
	return d < s->component.sim->dimension && !ts_box_periodic(&s->component.sim->domain->box, d) &&
	       a->n[0] > 0 && a->n[1] > 0 && a->deviation > 0 && a->all != reference;
}

enum { NNUMBERS = 6 };

static enum ts_status measure(struct ts_instance *self, double number[NNUMBERS], double *mean)
{
	const struct state *s = self->state;
	int axes = 0;

	TS_TRY(ts_component_update(self));
	*mean = 0;
	for (int d = 0; d < 3; d++) {
		struct axis a;
		double reference;

		measure_axis(self, d, &a);
		reference = isnan(s->reference[d]) ? a.lowest : s->reference[d];
		number[d] = number[3 + d] = 0;
		if (!is_defined(s, d, &a, reference))
			continue;
		number[d] = (a.mean[1] - reference) / (a.all - reference);
		number[3 + d] = (a.mean[1] - a.mean[0]) / a.deviation;
		*mean += number[d];
		axes++;
	}
	*mean = axes ? *mean / axes : 0;
	return TS_OK;
}

static enum ts_status eval_index(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	double number[NNUMBERS];

	(void)sim;
	return measure(self, number, &out->data[0]);
}

static enum ts_status eval_numbers(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	double mean;

	(void)sim;
	return measure(self, out->data, &mean);
}

static const char *const numbers[] = { "x", "y", "z", "distance_x", "distance_y", "distance_z", NULL };
static const struct ts_value values[] = {
	{ "index", "", "mean of the indices along the axes; 0 where it is not defined", TS_SCALAR, 1, NULL,
	  eval_index },
	{ "numbers", "",
	  "index along x, y and z; distance of the centres of the component and the rest, in standard "
	  "deviations of the coordinates of all",
	  TS_VECTOR, NNUMBERS, numbers, eval_numbers },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_COMPONENT_ROW(struct state),
	TS_VEC3("reference", struct state, reference, .flags = TS_OPTIONAL, .unit = "length",
		.help = "point from which coordinates count; default: the smallest coordinates of the "
			"particles"),
	TS_ARGS_END,
};

TS_STYLE(compute, ts_style, ts_compute_mixing_gmmi)
const struct ts_style ts_compute_mixing_gmmi = {
	.name = "mixing/gmmi",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.summary =
		"How well a component is mixed, from the place of its centre (generalized mean mixing index)",
	.doc = "The generalized mean mixing index of the component along each axis is the mean coordinate of "
	       "its particles divided by that of all particles of the group, both from a reference point "
	       "r:\n\n"
	       "    M_x = (<x>_component - r_x)/(<x> - r_x)\n\n"
	       "1 is mixed; < 1 the component is nearer to the reference, > 1 farther. c_ID[1] to c_ID[3] "
	       "are M_x, M_y and M_z, c_ID their mean. c_ID[4] to c_ID[6] are the distances of the centres, "
	       "(<x>_component - <x>_rest) divided by the standard deviation of x of all particles: 0 mixed, "
	       "+-2 for two equal parts that are separated and thin, +-sqrt(3) if each fills half of an even "
	       "bed; > 0 along the vertical if the component rises. The index sees only centres: two layers "
	       "with the component between them are mixed for it.\n\n"
	       "Particles count alike. Directions that are periodic, and z in two dimensions, have 0 and are "
	       "not part of the mean; so have all directions with a single component. Sums are exact and "
	       "rounded once.",
	.example = "compute m all mixing/gmmi type 2\nvariable rise equal c_m[6]",
	.cite = "B. N. Asmar, P. A. Langston, A. J. Matchett, Granular Matter 4 (2002) 129",
	.args = args,
	.state_size = sizeof(struct state),
	.values = values,
	.init = ts_component_init,
	.fini = ts_component_fini,
};
