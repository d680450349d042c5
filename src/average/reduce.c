#include "average/reduce.h"

#include <math.h>

#include "math/reduction.h"
#include "particle/particles.h"
#include "region/region.h"

#include "base/banned.h"

enum { ANY, PERATOM, LOCAL };
const char *const ts_reduce_inputs[] = { [ANY] = "any", [PERATOM] = "peratom", [LOCAL] = "local", NULL };

static enum ts_status refuse_replace(struct ts_instance *self, struct tsim *sim, const char *why)
{
	const struct ts_reduce *r = self->state;

	return ts_fail(&sim->error, TS_SYNTAX, &r->replace.word[0].place, "compute %s: replace %s",
		       self->style->name, why);
}

/* Parses `m n replace m n ...`. */
static enum ts_status read_replace(struct ts_instance *self, struct tsim *sim)
{
	struct ts_reduce *r = self->state;
	struct ts_words rest = r->replace;

	r->instead = ts_arena_alloc(&self->arena, r->input.n, sizeof *r->instead);
	if (!r->instead)
		return ts_nomem(&sim->error);
	for (size_t k = 0; k < r->input.n; k++)
		r->instead[k] = -1;
	if (rest.n && r->mode != TS_REDUCTION_MIN && r->mode != TS_REDUCTION_MAX)
		return refuse_replace(self, sim, "can be used with min and max only");
	while (rest.n) {
		int64_t m, n;

		if (rest.n < 2 || !ts_parse_int(rest.word[0].text, &m) ||
		    !ts_parse_int(rest.word[1].text, &n) || m < 1 || n < 1 || m > (int64_t)r->input.n ||
		    n > (int64_t)r->input.n || m == n)
			return refuse_replace(self, sim, "takes the numbers of two of the inputs");
		if (r->input.item[m - 1].shape != r->input.item[n - 1].shape)
			return refuse_replace(self, sim, "takes inputs of the same kind");
		r->instead[m - 1] = n - 1;
		rest = ts_words_from(rest, 2);
		if (rest.n && !ts_streq(rest.word[0].text, "replace"))
			return refuse_replace(self, sim, "takes two numbers");
		rest = ts_words_from(rest, rest.n ? 1 : 0);
	}
	return TS_OK;
}

enum ts_status ts_reduce_init(struct ts_instance *self, struct tsim *sim)
{
	struct ts_reduce *r = self->state;
	unsigned shapes = (r->inputs != LOCAL ? TS_WANT(PERATOM) : 0) |
			  (r->inputs != PERATOM && !r->region ? TS_WANT(LOCAL) : 0);
	char what[64];

	snprintf(what, sizeof what, "compute %s", self->style->name);
	r->sim = sim;
	TS_TRY(ts_ref_list_init(sim, what, &self->arena, r->words, shapes, &r->input));
	return r->instead ? TS_OK : read_replace(self, sim);
}

/* Whether row i of an input is included: group and region for particles, all rows of local arrays. */
static bool includes_row(const struct ts_instance *self, const struct ts_ref_input *input, size_t i)
{
	const struct ts_reduce *r = self->state;
	const struct ts_particles *p = r->sim->particles;

	if (input->shape == TS_LOCAL)
		return true;
	return ts_in_group(p, i, self->group) && (!r->region || ts_region_contains(r->region, p->x[i]));
}

/* Row of the minimum or maximum; of equal values that of the smallest particle id or, in local arrays, the
 * first. -1: no values. */
static int64_t find_extreme_row(const struct ts_instance *self, const struct ts_ref_input *input,
				const struct ts_table *values)
{
	const struct ts_reduce *r = self->state;
	const int32_t *tag = r->sim->particles->tag;
	double sign = r->mode == TS_REDUCTION_MIN ? -1 : 1, most = -INFINITY;
	int64_t found = -1;

	for (size_t i = 0; i < values->rows; i++) {
		double value = sign * values->data[i];
		bool earlier = input->shape != TS_LOCAL && found >= 0 && tag[i] < tag[found];

		if (includes_row(self, input, i) &&
		    (found < 0 || value > most || (earlier && !(value < most)))) {
			found = (int64_t)i;
			most = value;
		}
	}
	return found;
}

static enum ts_status value_at_extreme(struct ts_instance *self, size_t k, double *out)
{
	struct ts_reduce *r = self->state;
	const struct ts_ref_input *criterion = &r->input.item[r->instead[k]];
	int64_t row;

	TS_TRY(ts_ref_input_eval(r->sim, criterion, &r->criterion));
	TS_TRY(ts_ref_input_eval(r->sim, &r->input.item[k], &r->values));
	if (r->criterion.rows != r->values.rows)
		return ts_fail(&r->sim->error, TS_STATE, &criterion->where,
			       "compute %s: '%s' has %zu rows, '%s' has %zu", self->style->name,
			       criterion->name, r->criterion.rows, r->input.item[k].name, r->values.rows);
	row = find_extreme_row(self, criterion, &r->criterion);
	*out = row >= 0 ? r->values.data[row] : 0;
	return TS_OK;
}

static enum ts_status reduce_input(struct ts_instance *self, size_t k, double *out)
{
	struct ts_reduce *r = self->state;
	const struct ts_ref_input *input = &r->input.item[k];
	enum ts_reduction_mode mode = (enum ts_reduction_mode)r->mode;
	struct ts_reduction tally = ts_reduction_start();

	TS_TRY(ts_region_update(r->region, r->sim));
	if (r->instead[k] >= 0)
		return value_at_extreme(self, k, out);
	TS_TRY(ts_ref_input_eval(r->sim, input, &r->values));
	for (size_t i = 0; i < r->values.rows; i++)
		if (includes_row(self, input, i))
			ts_reduction_add(&tally, mode, r->values.data[i]);
	*out = ts_reduction_value(&tally, mode);
	return TS_OK;
}

static enum ts_status eval_scalar(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	(void)sim;
	return reduce_input(self, 0, out->data);
}

static enum ts_status eval_vector(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct ts_reduce *r = self->state;

	(void)sim;
	TS_TRY(ts_table_resize(out, 1, r->input.n));
	for (size_t k = 0; k < r->input.n; k++)
		TS_TRY(reduce_input(self, k, &out->data[k]));
	return TS_OK;
}

void ts_reduce_fini(struct ts_instance *self)
{
	struct ts_reduce *r = self->state;

	ts_table_release(&r->values);
	ts_table_release(&r->criterion);
	ts_ref_list_release(&r->input);
}

size_t ts_reduce_width(const struct ts_instance *self)
{
	return ((const struct ts_reduce *)self->state)->input.n;
}

const struct ts_value ts_reduce_values[] = {
	{ .name = "first",
	  .unit = "",
	  .help = "reduction of the first input",
	  .shape = TS_SCALAR,
	  .eval = eval_scalar },
	{ .name = "all",
	  .unit = "",
	  .help = "reduction of each input",
	  .shape = TS_VECTOR,
	  .eval = eval_vector },
	{ .name = NULL },
};
