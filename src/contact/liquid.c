#include "contact/liquid.h"

#include <math.h>

#include "material/property.h"
#include "particle/columns.h"
#include "particle/style_column.h"

#include "base/banned.h"

static const char CONTENT[] = "surfaceLiquidContent", FLUX[] = "liquidFlux", SOURCE[] = "liquidSource";

static enum ts_status add_columns(struct tsim *sim, struct ts_liquid *l, double initial)
{
	struct ts_particles *p = sim->particles;
	const unsigned shared = TS_COL_NAMED | TS_COL_BORDER | TS_COL_FORWARD;

	TS_TRY(ts_particles_style_column(sim, CONTENT, 1, shared, initial, &l->content));
	TS_TRY(ts_particles_style_column(sim, FLUX, 1, TS_COL_NAMED, 0, &l->flux));
	TS_TRY(ts_particles_style_column(sim, SOURCE, 1, TS_COL_NAMED, 0, &l->source));
	p->column[l->content].bound = (void **)(void *)&p->liquid;
	p->liquid = p->column[l->content].data;
	return TS_OK;
}

static enum ts_status initial_content(struct tsim *sim, const struct ts_place *where, double *out)
{
	static const char name[] = "surfaceLiquidContentInitial";

	TS_TRY(ts_property_value(sim, name, 0, 0, "pair_style gran", where, out));
	if (*out >= 0)
		return TS_OK;
	return ts_fail(&sim->error, TS_RANGE, ts_property_place(sim, name, 0, 0),
		       "property/global %s is %.15g, expected a number >= 0", name, *out);
}

/* The initial content may not be given yet: NaN. */
enum ts_status ts_liquid_columns(struct tsim *sim, const struct ts_instance *self, struct ts_liquid *l)
{
	double initial = NAN;

	if (ts_property_given(sim, "surfaceLiquidContentInitial"))
		TS_TRY(initial_content(sim, &self->where, &initial));
	return add_columns(sim, l, initial);
}

enum ts_status ts_liquid_init(struct tsim *sim, const struct ts_instance *self, struct ts_liquid *l)
{
	const struct ts_particles *p = sim->particles;
	double initial;

	TS_TRY(initial_content(sim, &self->where, &initial));
	TS_TRY(add_columns(sim, l, initial));
	for (size_t i = 0; i < p->n + p->nghost; i++)
		p->liquid[i] = isnan(p->liquid[i]) ? initial : p->liquid[i];
	return TS_OK;
}

enum ts_status ts_liquid_archive(struct tsim *sim, struct ts_archive *a, struct ts_liquid *l)
{
	struct ts_particles *p = sim->particles;

	if (!ts_archive_writing(a))
		TS_TRY(add_columns(sim, l, 0));
	TS_TRY(ts_particles_archive_column(a, sim, p->column[l->content].name, l->content));
	TS_TRY(ts_particles_archive_column(a, sim, p->column[l->flux].name, l->flux));
	return ts_particles_archive_column(a, sim, p->column[l->source].name, l->source);
}

void ts_liquid_advance(struct tsim *sim, const struct ts_liquid *l)
{
	const struct ts_particles *p = sim->particles;
	double *content = p->column[l->content].data, *flux = p->column[l->flux].data,
	       *source = p->column[l->source].data;

	for (size_t i = 0; i < p->n; i++) {
		content[i] += sim->clock.dt * (flux[i] + source[i]);
		flux[i] = 0;
	}
}
