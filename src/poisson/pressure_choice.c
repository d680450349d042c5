/* Choice of the pressure solver if the script names none. */
#include "poisson/pressure_choice.h"

#include "core/life.h"
#include "core/report.h"

#include "base/banned.h"

/* Id of the solver chosen here; a solver of the script has no id. */
#define AUTOMATIC "auto"

/* The applicable style of the smallest estimated time. */
static const struct ts_pressure_style *cheapest(const struct tsim *sim, const struct ts_poisson *problem)
{
	const struct ts_pressure_style *best = NULL;
	const char *why;

	for (const struct ts_style *const *s = sim->tables->styles; *s; s++) {
		const struct ts_pressure_style *style = (const struct ts_pressure_style *)*s;

		if ((*s)->kind == TS_KIND_PRESSURE && ts_pressure_suits(style, problem, &why) &&
		    (!best || style->cost(NULL, problem) < best->cost(NULL, problem)))
			best = style;
	}
	return best;
}

enum ts_status ts_pressure_choose(struct tsim *sim, const struct ts_poisson *problem,
				  const struct ts_place *where, struct ts_instance **out)
{
	const struct ts_word automatic = { .text = AUTOMATIC, .place = *where };
	struct ts_instance *chosen = ts_sim_find(sim, TS_KIND_PRESSURE, "");
	struct ts_instance *guess = ts_sim_find(sim, TS_KIND_PRESSURE, AUTOMATIC);
	const struct ts_pressure_style *style;
	const char *why = "";

	if (chosen) {
		if (guess)
			TS_TRY(ts_sim_destroy(sim, TS_KIND_PRESSURE, &automatic));
		*out = chosen;
		style = ts_pressure_style_of(chosen);
		if (!ts_pressure_suits(style, problem, &why))
			return ts_fail(&sim->error, TS_STATE, &chosen->where,
				       "pressure_style %s cannot be used here: %s", style->style.name, why);
		return TS_OK;
	}
	style = cheapest(sim, problem);
	if (guess && guess->style == &style->style) {
		*out = guess;
		return TS_OK;
	}
	if (guess)
		TS_TRY(ts_sim_destroy(sim, TS_KIND_PRESSURE, &automatic));
	return ts_sim_create(sim, TS_KIND_PRESSURE, &style->style, AUTOMATIC, 0, (struct ts_words){ 0 },
			     where, out);
}

void ts_pressure_explain(const struct tsim *sim, const struct ts_poisson *problem, bool weights,
			 struct ts_plan_report *report)
{
	const struct ts_instance *chosen = ts_sim_find(sim, TS_KIND_PRESSURE, "");
	struct ts_poisson now = *problem;
	const struct ts_pressure_style *style;

	/* only the presence of weights matters, not their values */
	for (int d = 0; d < 3; d++)
		now.weight[d] = weights ? problem->grid->memory : NULL;
	style = chosen ? ts_pressure_style_of(chosen) : cheapest(sim, &now);
	ts_report_line(report, "pressure", "%s (%s), %s: about %.2g s a solve", style->style.name,
		       style->style.summary,
		       chosen	 ? "chosen by the script"
		       : weights ? "the cheapest here, where void fractions vary"
				 : "the cheapest here",
		       style->cost(chosen, &now));
	report->bytes += 8.0 * style->fields * (double)ts_grid_cells(problem->grid);
}
