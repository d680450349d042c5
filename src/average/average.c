#include "average/average.h"

#include <math.h>

#include "base/banned.h"

/* Step of the first sample of the next average; averages end on multiples of Nfreq. */
static int64_t first_sample_step(const struct ts_average *a, int64_t step)
{
	int64_t length = (a->repeat - 1) * a->every;
	int64_t least = step + length > a->start ? step + length : a->start;

	return (least + a->freq - 1) / a->freq * a->freq - length;
}

enum ts_status ts_average_init(struct ts_instance *self, struct tsim *sim, struct ts_average *a)
{
	if (a->freq % a->every != 0 || a->repeat > a->freq / a->every)
		return ts_fail(&sim->error, TS_RANGE, &self->where,
			       "fix %s: Nfreq (%lld) must be a multiple of Nevery (%lld) and not less than "
			       "Nrepeat (%lld) times Nevery",
			       self->style->name, (long long)a->freq, (long long)a->every,
			       (long long)a->repeat);
	if (!a->started)
		a->next = first_sample_step(a, sim->clock.step);
	a->started = 1;
	return TS_OK;
}

enum ts_status ts_average_resize(struct ts_instance *self, struct tsim *sim, struct ts_average *a, size_t n)
{
	size_t ring = a->ave == TS_AVE_WINDOW ? n * (size_t)a->window : 0;

	if (a->averages > 0 && a->ave != TS_AVE_ONE && n != a->n)
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "fix %s %s: the number of its values has changed from %zu to %zu, so that "
			       "averages cannot be combined; use `ave one`",
			       self->style->name, self->id, a->n, n);
	a->n = n;
	if (a->result_n == n && a->history_n == ring)
		return TS_OK;
	if (TS_GROW(a->sum, a->sum_capacity, n) != TS_OK ||
	    TS_GROW(a->total, a->total_capacity, n) != TS_OK ||
	    TS_GROW(a->result, a->result_capacity, n) != TS_OK ||
	    TS_GROW(a->history, a->history_capacity, ring) != TS_OK)
		return ts_nomem(&sim->error);
	for (size_t k = a->result_n; k < n; k++)
		a->sum[k] = a->total[k] = a->result[k] = 0;
	a->sum_n = a->total_n = a->result_n = n;
	a->history_n = ring;
	return TS_OK;
}

/* Whether the clock is not where the last step has left it: it has passed the next sample, or that comes later than the next
 * average. Frames of rerun and read_dump set it. */
static bool has_clock_jumped(const struct ts_average *a, int64_t step)
{
	return step > a->next || a->next > first_sample_step(a, step + 1);
}

bool ts_average_due(struct ts_average *a, const struct tsim *sim)
{
	if (has_clock_jumped(a, sim->clock.step)) {
		a->samples = 0;
		a->next = first_sample_step(a, sim->clock.step);
	}
	if (sim->clock.step != a->next)
		return false;
	for (size_t k = 0; a->samples == 0 && k < a->n; k++)
		a->sum[k] = 0;
	return true;
}

bool ts_average_waits(const struct ts_instance *self, const struct tsim *sim)
{
	const struct ts_average *a = self->state;

	return sim->clock.step == a->next || has_clock_jumped(a, sim->clock.step);
}

int64_t ts_average_until(const struct ts_average *a, const struct tsim *sim)
{
	return sim->clock.step + (a->repeat - 1) * a->every + (a->ave == TS_AVE_ONE ? 0 : a->freq);
}

bool ts_average_sampled(struct ts_average *a, const struct tsim *sim)
{
	a->samples++;
	a->next += a->every;
	if (a->samples < a->repeat)
		return false;
	a->samples = 0;
	a->next = sim->clock.step + a->freq - (a->repeat - 1) * a->every;
	return true;
}

int64_t ts_average_weight(const struct ts_average *a)
{
	if (a->ave == TS_AVE_ONE)
		return 1;
	return a->ave == TS_AVE_WINDOW && a->averages > a->window ? a->window : a->averages;
}

/* Combines number k of two averages: the sum, or the minimum or maximum for the last two numbers. */
static double add_or_extreme(const struct ts_average *a, size_t k, double x, double y)
{
	if (a->extremes && k + 2 == a->n)
		return fmin(x, y);
	return a->extremes && k + 1 == a->n ? fmax(x, y) : x + y;
}

static bool is_mean(const struct ts_average *a, size_t k)
{
	return !a->totals && !(a->extremes && k + 2 >= a->n);
}

void ts_average_combine(struct ts_average *a)
{
	size_t place = a->ave == TS_AVE_WINDOW ? (size_t)(a->averages % a->window) * a->n : 0;
	int64_t count;

	a->averages++;
	count = ts_average_weight(a);
	for (size_t k = 0; k < a->n; k++) {
		double value = a->sum[k];

		if (a->ave == TS_AVE_RUNNING)
			value = a->total[k] =
				a->averages == 1 ? value : add_or_extreme(a, k, a->total[k], value);
		if (a->ave == TS_AVE_WINDOW) {
			a->history[place + k] = value;
			value = a->history[k];
			for (int64_t j = 1; j < count; j++)
				value = add_or_extreme(a, k, value, a->history[(size_t)j * a->n + k]);
		}
		a->result[k] = is_mean(a, k) ? value / (double)count : value;
	}
}

enum ts_status ts_average_archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *archive,
				  struct ts_average *a)
{
	size_t expected;

	TS_TRY(ts_archive_array(archive, "sum", TS_SAVED_F64, (void **)&a->sum, &a->sum_capacity, &a->sum_n));
	TS_TRY(ts_archive_array(archive, "total", TS_SAVED_F64, (void **)&a->total, &a->total_capacity,
				&a->total_n));
	TS_TRY(ts_archive_array(archive, "history", TS_SAVED_F64, (void **)&a->history, &a->history_capacity,
				&a->history_n));
	TS_TRY(ts_archive_array(archive, "result", TS_SAVED_F64, (void **)&a->result, &a->result_capacity,
				&a->result_n));
	if (ts_archive_writing(archive))
		return TS_OK;
	a->n = a->result_n;
	expected = a->ave == TS_AVE_WINDOW ? a->n * (size_t)a->window : 0;
	if (a->samples < 0 || a->samples >= a->repeat || a->averages < 0 || a->sum_n != a->n ||
	    a->total_n != a->n || a->history_n != expected)
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "fix %s %s: the restart file holds averages of another number of values or "
			       "another window",
			       self->style->name, self->id);
	return TS_OK;
}

void ts_average_release(struct ts_average *a)
{
	ts_free(a->sum);
	ts_free(a->total);
	ts_free(a->history);
	ts_free(a->result);
}
