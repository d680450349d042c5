/* Which solver a problem gets where the script names none. */
#include "core/sim.h"
#include "flow/poisson.h"

#include "base/banned.h"

/* Its id tells the choice that was made here from the user's, who gives none. */
#define AUTOMATIC "auto"

static const struct ts_pressure_style *cheapest(struct tsim *sim, const struct ts_poisson *problem)
{
	(void)sim;
	return (const struct ts_pressure_style *)ts_style_find(TS_KIND_PRESSURE,
							       problem->weight[0] ? "cg" : "direct");
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
		if (style->suits && !style->suits(chosen, problem, &why))
			return ts_fail(&sim->error, TS_STATE, &chosen->where,
				       "pressure_style %s cannot be used here: %s", style->style.name,
				       why);
		return TS_OK;
	}
	style = cheapest(sim, problem);
	if (guess && guess->style == &style->style) {
		*out = guess;
		return TS_OK;
	}
	if (guess)
		TS_TRY(ts_sim_destroy(sim, TS_KIND_PRESSURE, &automatic));
	return ts_sim_create(sim, TS_KIND_PRESSURE, &style->style, AUTOMATIC, 0,
			     (struct ts_words){ 0 }, where, out);
}
