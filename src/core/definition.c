#include "core/definition.h"
#include "core/life.h"

#include "base/banned.h"

enum ts_status ts_define(struct tsim *sim, enum ts_kind kind, const struct ts_definition *made)
{
	const struct ts_word *name = &made->line.word[0];
	const struct ts_style *style;

	TS_TRY(ts_style_require(sim, kind, name, &style));
	if (!style->boxless && !ts_sim_has_box(sim))
		return ts_fail(&sim->error, TS_STATE, &name->place,
			       "%s %s needs a simulation box: use create_box or read_restart first",
			       ts_kind_name(kind), style->name);
	return ts_sim_create(sim, kind, style, made->id, made->group,
			     ts_words_from(made->line, 1 + made->passed), &name->place, NULL);
}
