#include "wear/evolution.h"

#include <math.h>

#include "core/archive.h"
#include "math/exactsum.h"
#include "wear/wear.h"

#include "base/banned.h"

const char *const ts_through_names[] = { "stop", "open", "error", NULL };

/* ---- arguments ---- */

/* Words that have no effect without `evolve yes`. */
static enum ts_status check_unused(struct ts_instance *self, struct tsim *sim, const struct ts_evolution *e)
{
	const char *word = !isnan(e->thickness) ? "thickness" : !isnan(e->layer) ? "layer" : NULL;

	if (!word && e->through != TS_THROUGH_STOP)
		word = "through";
	return word ? ts_fail(&sim->error, TS_SYNTAX, ts_instance_word(self, word),
			      "fix %s: `%s` belongs to a surface that recedes: `evolve yes`",
			      self->style->name, word)
		    : TS_OK;
}

/* Each of two fixes would take its own volume for the whole depth of an element. */
static enum ts_status check_alone(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_wear *mine = self->state;
	const struct ts_instance *by;

	for (size_t k = 0; (by = ts_sim_next_of(sim, TS_KIND_FIX, TS_FAMILY_WEAR, &k));) {
		const struct ts_wear *other = by->state;

		if (!ts_streq(by->id, self->id) && other->evolution.on &&
		    ts_streq(other->surface_id, mine->surface_id))
			return ts_fail(&sim->error, TS_STATE, ts_instance_word(self, "evolve"),
				       "fix %s: surface '%s' recedes by fix %s already; only one fix may "
				       "change its geometry",
				       self->style->name, mine->surface_id, by->id);
	}
	return TS_OK;
}

static struct ts_recession recession_of(const struct ts_evolution *e)
{
	return (struct ts_recession){ .thickness = isnan(e->thickness) ? INFINITY : e->thickness,
				      .layer = isnan(e->layer) ? 0 : e->layer,
				      .through = e->through };
}

enum ts_status ts_evolution_init(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_wear *w = self->state;
	struct ts_recession how = recession_of(&w->evolution);

	if (!w->evolution.on)
		return check_unused(self, sim, &w->evolution);
	TS_TRY(check_alone(self, sim));
	return ts_surface_check_recession(sim, &w->surface, &how, ts_instance_word(self, "evolve"));
}

/* ---- wear ---- */

static enum ts_status reserve(struct tsim *sim, struct ts_evolution *e, size_t rows)
{
	if (TS_GROW(e->sums, e->capacity, rows) != TS_OK)
		return ts_nomem(&sim->error);
	for (; e->n < rows; e->n++)
		e->sums[e->n] = (struct ts_evolution_sums){ 0 };
	return TS_OK;
}

enum ts_status ts_evolution_add(struct tsim *sim, struct ts_evolution *e, size_t row, double volume,
				bool back)
{
	TS_TRY(reserve(sim, e, row + 1));
	if (back)
		e->sums[row].back += volume;
	return TS_OK;
}

/* ---- geometry ---- */

/* The elements that have volume to give; item k is that of row[k]. Returns their number. */
static size_t collect(const struct ts_wear *w, struct ts_recession_element *item)
{
	const struct ts_evolution_sums *s = w->evolution.sums;
	size_t n = 0;

	for (size_t k = 0; k < w->rows.n; k++) {
		double due = ts_wear_sums(w, k)->volume - s[k].taken - s[k].surplus;

		if (due > 0)
			item[n++] = (struct ts_recession_element){ .element = (size_t)w->rows.touched[k],
								   .due = due,
								   .back = s[k].back };
	}
	return n;
}

/* Of the first element that is worn through; `error`: in any case. */
static enum ts_status tell_through(struct ts_instance *self, struct tsim *sim, size_t element)
{
	const struct ts_wear *w = self->state;
	bool before = ts_evolution_total(&w->evolution,
					 offsetof(struct ts_evolution_sums, through) / sizeof(double)) > 0;
	double x[3];

	ts_surface_centre(&w->surface, sim, element, x);
	if (w->evolution.through == TS_THROUGH_ERROR)
		return ts_fail(&sim->error, TS_PHYSICS, ts_instance_word(self, "through"),
			       "fix %s: element %zu of surface %s, at (%g %g %g), is worn through at step "
			       "%lld",
			       self->style->name, element + 1, w->surface_id, x[0], x[1], x[2],
			       (long long)sim->clock.step);
	if (before)
		return TS_OK;
	ts_warn(&sim->log, ts_instance_word(self, "evolve"),
		"fix %s: element %zu of surface %s, at (%g %g %g), is the first that is worn through, at "
		"step %lld; %s",
		self->style->name, element + 1, w->surface_id, x[0], x[1], x[2], (long long)sim->clock.step,
		w->evolution.through == TS_THROUGH_OPEN ? "particles pass there"
							: "it gives no more volume: f_ID[11] and f_ID[12]");
	return TS_OK;
}

static enum ts_status take_results(struct ts_instance *self, struct tsim *sim,
				   const struct ts_recession_element *item, size_t n)
{
	struct ts_wear *w = self->state;

	for (size_t k = 0; k < n; k++) {
		const struct ts_recession_element *e = &item[k];
		struct ts_evolution_sums *s = &w->evolution.sums[w->rows.row[e->element] - 1];
		double pending = fmax(e->due - e->taken - e->surplus, 0);

		s->taken += e->taken;
		s->surplus += e->surplus;
		s->back *= pending / e->due;
		if (e->through && !(s->through > 0))
			TS_TRY(tell_through(self, sim, e->element));
		s->through = e->through; /* a thickness that has been enlarged since: no longer */
	}
	return TS_OK;
}

enum ts_status ts_evolution_update(struct ts_instance *self, struct tsim *sim)
{
	struct ts_wear *w = self->state;
	struct ts_evolution *e = &w->evolution;
	struct ts_recession how = recession_of(e);
	size_t n;

	if (!e->on || sim->clock.step % e->every != 0)
		return TS_OK;
	if (TS_GROW(e->item, e->item_capacity, w->rows.n) != TS_OK)
		return ts_nomem(&sim->error);
	TS_TRY(reserve(sim, e, w->rows.n));
	n = collect(w, e->item);
	TS_TRY(ts_surface_recede(sim, &w->surface, &how, ts_instance_word(self, "evolve"), e->item, n));
	return take_results(self, sim, e->item, n);
}

/* ---- outputs and restart files ---- */

double ts_evolution_total(const struct ts_evolution *e, size_t member)
{
	return e->n ? ts_exactsum_of(&e->sums[0].taken + member, e->n, TS_EVOLUTION_SUMS) : 0;
}

enum ts_status ts_evolution_archive(struct ts_archive *archive, struct tsim *sim, struct ts_evolution *e,
				    size_t rows)
{
	size_t n, capacity;

	if (!e->on)
		return TS_OK;
	TS_TRY(reserve(sim, e, ts_archive_writing(archive) ? rows : 0));
	n = e->n * TS_EVOLUTION_SUMS;
	capacity = e->capacity * TS_EVOLUTION_SUMS;
	TS_TRY(ts_archive_array(archive, "evolution", TS_SAVED_F64, (void **)&e->sums, &capacity, &n));
	e->capacity = capacity / TS_EVOLUTION_SUMS;
	e->n = n / TS_EVOLUTION_SUMS;
	return e->n == rows ? TS_OK
			    : ts_fail(&sim->error, TS_DAMAGED, NULL,
				      "saved volumes of %zu worn elements, expected %zu", e->n, rows);
}

void ts_evolution_release(struct ts_evolution *e)
{
	ts_free(e->sums);
	ts_free(e->item);
}
