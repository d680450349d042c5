/* Compute: one number out of one for each particle. */
#include "core/ref_list.h"

#include <math.h>

#include "math/exactsum.h"
#include "particles/particles.h"

#include "base/banned.h"

enum { SUM, MIN, MAX, AVE, SUMSQ, AVESQ };

struct reduce {
	int mode;
	struct ts_words words;
	bool at_run_end; /* accepted: outputs are always those of now */
	struct ts_ref_list input;
	struct ts_table each;
	struct tsim *sim; /* evaluation may need memory */
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct reduce *r = self->state;

	r->sim = sim;
	return ts_ref_list_init(sim, "compute reduce", &self->arena, r->words,
				TS_WANT(PERATOM) | TS_WANT(LOCAL), &r->input);
}

struct tally {
	struct ts_exactsum sum;
	double least, most;
	size_t n;
};

static void count(struct tally *t, double value, int mode)
{
	ts_exactsum_add(&t->sum, mode >= SUMSQ ? value * value : value);
	t->least = fmin(t->least, value);
	t->most = fmax(t->most, value);
	t->n++;
}

/* Of no values: 0. */
static double outcome(const struct tally *t, int mode)
{
	double sum = ts_exactsum_value(&t->sum);

	if (t->n == 0)
		return 0;
	switch (mode) {
	case MIN:
		return t->least;
	case MAX:
		return t->most;
	case AVE:
	case AVESQ:
		return sum / (double)t->n;
	default:
		return sum;
	}
}

static enum ts_status reduce_one(struct ts_instance *self, size_t k, double *out)
{
	struct reduce *r = self->state;
	const struct ts_particles *p = r->sim->particles;
	const struct ts_ref_input *input = &r->input.item[k];
	struct tally tally = { .least = INFINITY, .most = -INFINITY };

	TS_TRY(ts_ref_input_eval(r->sim, input, &r->each));
	for (size_t i = 0; i < r->each.rows; i++)
		if (input->shape == TS_LOCAL || ts_in_group(p, i, self->group))
			count(&tally, r->each.data[i], r->mode);
	*out = outcome(&tally, r->mode);
	return TS_OK;
}

static enum ts_status eval_scalar(struct ts_instance *self, const struct tsim *sim,
				  struct ts_table *out)
{
	(void)sim;
	return reduce_one(self, 0, out->data);
}

static enum ts_status eval_vector(struct ts_instance *self, const struct tsim *sim,
				  struct ts_table *out)
{
	struct reduce *r = self->state;

	(void)sim;
	if (ts_table_resize(out, 1, r->input.n) != TS_OK)
		return ts_nomem(&r->sim->error);
	for (size_t k = 0; k < r->input.n; k++)
		TS_TRY(reduce_one(self, k, &out->data[k]));
	return TS_OK;
}

static void fini(struct ts_instance *self)
{
	struct reduce *r = self->state;

	ts_table_release(&r->each);
	ts_ref_list_release(&r->input);
}

static const struct ts_value values[] = {
	{ .name = "first",
	  .unit = "",
	  .help = "of the first input",
	  .shape = TS_SCALAR,
	  .eval = eval_scalar },
	{ .name = "all",
	  .unit = "",
	  .help = "of each input",
	  .shape = TS_VECTOR,
	  .eval = eval_vector },
	{ .name = NULL },
};

static const char *const modes[] = { "sum", "min", "max", "ave", "sumsq", "avesq", NULL };

static const struct ts_arg args[] = {
	TS_ENUM("mode", struct reduce, mode, modes, .flags = TS_POSITIONAL,
		.help = "what is made of the values"),
	TS_LIST("inputs", struct reduce, words,
		.help = "x, vx, fx, radius ..., c_ID, c_ID[k], c_ID[*], f_ID, f_ID[k] or v_name"),
	TS_BOOL("update_on_run_end", struct reduce, at_run_end, .fallback = "no",
		.help = "accepted: outputs are always those of now"),
	TS_ARGS_END,
};

TS_STYLE(compute, ts_style, ts_compute_reduce)
const struct ts_style ts_compute_reduce = {
	.name = "reduce",
	.kind = TS_KIND_COMPUTE,
	.summary = "One number out of one for each particle",
	.doc = "Sum, least, largest, mean, sum of squares or mean of squares over the particles of "
	       "the\n"
	       "group, or over all rows of a local table (contacts, bonds). c_ID is that of the "
	       "first input,\n"
	       "c_ID[k] of the k-th. Sums are rounded once and do not depend on the order. Of no "
	       "values\n"
	       "all are 0.",
	.example = "compute fastest all reduce max vx vy vz\n"
		   "compute hits all reduce sum c_contacts",
	.args = args,
	.state_size = sizeof(struct reduce),
	.values = values,
	.init = init,
	.fini = fini,
};
