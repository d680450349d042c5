#include "flow/fluid_fields.h"

#include "base/banned.h"

struct list {
	unsigned uses;
	bool without;
	size_t n;
	double **field;
};

static void add(struct list *list, double *field, unsigned uses)
{
	if (field && list->n < TS_FIELDS_MOST && ((uses & list->uses) != 0) != list->without)
		list->field[list->n++] = field;
}

static void add_vector(struct list *list, double *const field[3], unsigned uses)
{
	for (int d = 0; d < 3; d++)
		add(list, field[d], uses);
}

static void add_fluid(struct list *list, const struct ts_fluid *fluid)
{
	enum {
		READ = TS_FIELDS_NEAR | TS_FIELDS_STEP | TS_FIELDS_LASTING,
		SUM = TS_FIELDS_NEAR | TS_FIELDS_PLACE | TS_FIELDS_SUM
	};
	const unsigned pressure = fluid->near.pressure ? READ | TS_FIELDS_PLACE : TS_FIELDS_LASTING;

	add_vector(list, fluid->u, READ | TS_FIELDS_PLACE);
	add(list, fluid->p, pressure);
	add_vector(list, fluid->exchange_velocity, READ);
	add(list, fluid->p_mean, READ);
	add_vector(list, fluid->force, SUM);
	add_vector(list, fluid->exchange, SUM);
	add(list, fluid->void_fraction, TS_FIELDS_NEAR | TS_FIELDS_PLACE | TS_FIELDS_LASTING);
	add(list, fluid->void_fraction_rate, TS_FIELDS_LASTING);
	add_vector(list, fluid->void_fraction_face, TS_FIELDS_LASTING);
	add_vector(list, fluid->momentum_void_fraction, TS_FIELDS_LASTING);
}

/* The history is completed by itself (flow/slab_step.c): it need not be, where only the fluid is. */
static void add_projection(struct list *list, const struct ts_projection *p)
{
	add(list, p->increment, TS_FIELDS_LASTING);
	add(list, p->void_fraction_before, TS_FIELDS_LASTING);
	add(list, p->rhs, 0);
	add_vector(list, p->work, 0);
	add_vector(list, p->second_stage, 0);
	add_vector(list, p->history, 0);
	add_vector(list, p->weight, 0);
	add_vector(list, p->void_before, 0);
	add_vector(list, p->void_rate, 0);
	add_vector(list, p->void_start, 0);
	add_vector(list, p->void_stage, 0);
}

static void add_part(struct list *list, struct ts_instance *part)
{
	const struct ts_flow_part *flow_part = part->state;
	struct ts_flow_part_fields of = { 0 };

	if (!flow_part->fields)
		return;
	flow_part->fields(part, &of);
	for (int k = 0; k < TS_FLOW_PART_FIELDS; k++) {
		add(list, of.near[k], TS_FIELDS_NEAR | TS_FIELDS_STEP | TS_FIELDS_PLACE | TS_FIELDS_LASTING);
		add(list, of.sum[k], TS_FIELDS_NEAR | TS_FIELDS_PLACE | TS_FIELDS_SUM);
		add(list, of.plane[k], TS_FIELDS_LASTING);
		add(list, of.work[k], 0);
	}
}

size_t ts_fluid_fields_list(struct ts_projection *p, const struct tsim *sim, unsigned uses, bool without,
			    double *field[TS_FIELDS_MOST])
{
	struct list list = { .uses = uses, .without = without, .field = field };
	struct ts_instance *part;

	add_fluid(&list, &p->fluid);
	add_projection(&list, p);
	for (size_t k = 0; (part = ts_sim_next_of(sim, TS_KIND_FIX, TS_FAMILY_FLOW_PART, &k));)
		add_part(&list, part);
	return list.n;
}
