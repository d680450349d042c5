/* Sums over the points of a body: impulses of the forcing, the momentum of the fluid inside. */
#include <math.h>
#include <string.h>

#include "base/parallel.h"
#include "base/sort.h"
#include "flow/fluid_slabs.h"
#include "immersed/immersed.h"
#include "math/vec3.h"

#include "base/banned.h"

/* Over the fluid of one component inside. */
struct mean {
	double volume, u, x[3], xu[3];
};

/* Of a layer, as ranks tell each other. */
struct layer_sums {
	int32_t part, component, plane, turn;
	double impulse[3];
	double slip; /* largest of its points */
	struct mean inside;
};

struct layer_task {
	struct ts_immersed *ib;
	const struct ts_fluid *fluid;
	double dt;
};

static void for_layers(struct ts_immersed *ib, const struct ts_fluid *fluid, double dt, ts_range_fn *share)
{
	const int team = ts_fluid_team(fluid, ib->npoints);

	ts_parallel(ib->nlayers < (size_t)team ? (int)ib->nlayers : team, ib->nlayers, share,
		    &(struct layer_task){ ib, fluid, dt });
}

/* ---- impulses */

void ts_immersed_begin_step(struct ts_immersed *ib)
{
	for (size_t k = 0; k < ib->nlayers; k++) {
		memset(ib->layer[k].impulse, 0, sizeof ib->layer[k].impulse);
		memset(ib->layer[k].stage, 0, sizeof ib->layer[k].stage);
	}
	ib->first_dt = 0;
}

void ts_immersed_end_substep(struct ts_immersed *ib)
{
	for (size_t k = 0; k < ib->nlayers; k++) {
		struct ts_immersed_layer *layer = &ib->layer[k];

		ts_add(layer->impulse, layer->stage, layer->impulse);
		memset(layer->stage, 0, sizeof layer->stage);
	}
	ib->first_dt = 0;
}

/* Adds the impulse of the forcing at one point, and its moments about the two other axes. */
static void add_impulse(const struct ts_fluid *fluid, const struct ts_immersed_point *p, int c, double sum[3])
{
	double e = fluid->void_fraction ? fluid->void_fraction_face[c][p->at] : 1;
	double impulse = fluid->density * e * p->volume * (fluid->u[c][p->at] - p->before);
	int a = (c + 1) % 3, b = (c + 2) % 3;

	sum[0] += impulse;
	sum[1] += p->arm[b] * impulse;
	sum[2] -= p->arm[a] * impulse;
}

/* A step of several stages s, each u <- keep_s u_0 + take_s (u + dt ...) with dt_s = take_s dt and take_0
 * = 1: the impulses of earlier stages are multiplied by take_s. */
static void add_layer_impulses(void *context, size_t from, size_t to)
{
	const struct layer_task *task = context;
	const struct ts_immersed *ib = task->ib;

	for (size_t k = from; k < to; k++) {
		struct ts_immersed_layer *layer = &ib->layer[k];

		ts_scale(task->dt / ib->first_dt, layer->stage, layer->stage);
		for (size_t m = layer->first; m < layer->end; m++)
			add_impulse(task->fluid, &ib->point[m], layer->component, layer->stage);
	}
}

void ts_immersed_add_impulses(struct ts_immersed *ib, const struct ts_fluid *fluid, double dt)
{
	if (!(ib->first_dt > 0))
		ib->first_dt = dt;
	for_layers(ib, fluid, dt, add_layer_impulses);
}

/* ---- sums of layers */

static void add_inside(const struct ts_fluid *fluid, const struct ts_immersed_point *p, int c, struct mean *m)
{
	double volume = p->solid * p->volume, u = fluid->u[c][p->at];

	m->volume += volume;
	m->u += volume * u;
	for (int d = 0; d < 3; d++) {
		m->x[d] += volume * p->arm[d];
		m->xu[d] += volume * p->arm[d] * u;
	}
}

static struct layer_sums *sums_of(struct ts_parcel *parcel)
{
	return (struct layer_sums *)(void *)parcel->data;
}

static void sum_layers(void *context, size_t from, size_t to)
{
	const struct layer_task *task = context;
	struct ts_immersed *ib = task->ib;

	for (size_t k = from; k < to; k++) {
		const struct ts_immersed_layer *layer = &ib->layer[k];
		const int c = layer->component;
		struct layer_sums *sums = &sums_of(&ib->own_layers)[k];

		*sums = (struct layer_sums){
			.part = layer->part, .component = c, .plane = layer->plane, .turn = layer->turn
		};
		memcpy(sums->impulse, layer->impulse, sizeof sums->impulse);
		for (size_t m = layer->first; m < layer->end; m++) {
			const struct ts_immersed_point *p = &ib->point[m];

			add_inside(task->fluid, p, c, &sums->inside);
			if (!p->outside && !p->deep)
				sums->slip = fmax(sums->slip, fabs(task->fluid->u[c][p->at] - p->target));
		}
	}
}

/* ---- sums of parts */

static int by_part(const void *first, const void *second)
{
	const struct layer_sums *a = first, *b = second;

	if (a->part != b->part)
		return a->part < b->part ? -1 : 1;
	if (a->component != b->component)
		return a->component - b->component;
	if (a->plane != b->plane)
		return a->plane < b->plane ? -1 : 1;
	return (a->turn > b->turn) - (a->turn < b->turn);
}

static void add_means(struct mean *sum, const struct mean *more)
{
	sum->volume += more->volume;
	sum->u += more->u;
	ts_add(sum->x, more->x, sum->x);
	ts_add(sum->xu, more->xu, sum->xu);
}

/* (x - X) x u, X the mean position of the points of each component: exactly 0 in uniform flow. */
static void add_mean_torque(struct ts_immersed_sums *s, int c, const struct mean *m, int dimensions)
{
	int a = (c + 1) % 3, b = (c + 2) % 3;
	double v = m->volume;

	if (!(v > 0))
		return;
	s->volume += v / dimensions;
	s->velocity[c] = m->u / v;
	ts_scale(1 / v, m->x, s->arm[c]);
	s->spin[a] += m->xu[b] / v - m->x[b] / v * (m->u / v);
	s->spin[b] -= m->xu[a] / v - m->x[a] / v * (m->u / v);
}

/* Adds the layers of one component of the first part in the list, in the order of planes; returns their number. */
static size_t add_component(struct ts_immersed *ib, const struct layer_sums *list, size_t n, int dimensions)
{
	const int c = list->component;
	struct ts_immersed_sums *s = &ib->sums[list->part];
	struct mean inside = { 0 };
	size_t k = 0;

	for (; k < n && list[k].part == list->part && list[k].component == c; k++) {
		s->impulse[c] += list[k].impulse[0];
		s->angular_impulse[(c + 1) % 3] += list[k].impulse[1];
		s->angular_impulse[(c + 2) % 3] += list[k].impulse[2];
		add_means(&inside, &list[k].inside);
		ib->slip = fmax(ib->slip, list[k].slip);
	}
	add_mean_torque(s, c, &inside, dimensions);
	return k;
}

static enum ts_status tell_layers(struct ts_immersed *ib, const struct ts_fluid *fluid,
				  struct ts_parcel **all)
{
	*all = ts_fluid_divided(fluid) ? &ib->all_layers : &ib->own_layers;
	if (!ts_fluid_divided(fluid))
		return TS_OK;
	ib->all_layers.n = 0;
	return ts_world_share(fluid->slabs->world, &ib->own_layers, &ib->all_layers);
}

static enum ts_status make_room(struct ts_immersed *ib, size_t layers)
{
	ib->own_layers.n = 0;
	return ts_parcel_extend(&ib->own_layers, layers * sizeof(struct layer_sums)) ? TS_OK : TS_NOMEM;
}

enum ts_status ts_immersed_sum_parts(struct ts_immersed *ib, const struct ts_fluid *fluid, size_t parts)
{
	struct ts_parcel *all;
	struct layer_sums *list;
	size_t n;

	TS_TRY(make_room(ib, ib->nlayers));
	for_layers(ib, fluid, 0, sum_layers);
	TS_TRY(tell_layers(ib, fluid, &all));
	list = sums_of(all);
	n = all->n / sizeof *list;
	ts_sort(list, n, sizeof *list, by_part);
	if (parts)
		memset(ib->sums, 0, parts * sizeof *ib->sums);
	ib->slip = 0;
	for (size_t k = 0; k < n;)
		k += add_component(ib, list + k, n - k, fluid->grid.dimensions);
	return TS_OK;
}

/* The points are those of all planes. */
enum ts_status ts_immersed_rehearse_sums(struct ts_immersed *ib, const struct ts_fluid *fluid)
{
	struct ts_parcel *all;
	int first, end;
	size_t n = 0;

	ts_fluid_slabs_planes(fluid, &first, &end);
	for (size_t k = 0; k < ib->nlayers; k++)
		n += ib->layer[k].plane >= first && ib->layer[k].plane < end;
	TS_TRY(make_room(ib, n));
	return tell_layers(ib, fluid, &all);
}
