#include "contact/contact_system.h"

#include "contact/contact_view.h"
#include "contact/virial.h"
#include "contact/pair.h"
#include "core/standard.h"
#include "group/temperature.h"
#include "particle/division.h"

#include "base/banned.h"

static const struct ts_virial_parts all_parts = { .kinetic = true, .pair = true, .bond = true };

/* Pressure tensor as of compute pressure with all its parts. */
static enum ts_status pressure_tensor(struct tsim *sim, double out[6])
{
	const struct ts_instance *pair = ts_sim_only(sim, TS_KIND_PAIR);
	const struct ts_division *d = sim->particles->division;
	double kinetic[7], volume = ts_virial_box_volume(sim);

	TS_TRY(ts_virial_now(sim, pair, &all_parts, d ? d->look.virial : NULL, d ? d->look.virial_step : -1,
			     out));
	ts_temperature_tensor(sim, 0, NULL, kinetic);
	for (int k = 0; k < 6; k++)
		out[k] = volume > 0 ? (out[k] + kinetic[k]) / volume : 0;
	return TS_OK;
}

static enum ts_status evaluate_press(struct tsim *sim, double *out)
{
	double t[6];
	bool replaced;

	TS_TRY(ts_standard_value(sim, TS_STANDARD_PRESSURE, -1, &replaced, out));
	if (replaced)
		return TS_OK;
	TS_TRY(pressure_tensor(sim, t));
	*out = ts_virial_mean_pressure(sim, t);
	return TS_OK;
}

static enum ts_status evaluate_component(struct tsim *sim, int k, double *out)
{
	double t[6];
	bool replaced;

	TS_TRY(ts_standard_value(sim, TS_STANDARD_PRESSURE, k, &replaced, out));
	if (replaced)
		return TS_OK;
	TS_TRY(pressure_tensor(sim, t));
	*out = t[k];
	return TS_OK;
}

#define COMPONENT(name, k)                                        \
	static enum ts_status name(struct tsim *sim, double *out) \
	{                                                         \
		return evaluate_component(sim, k, out);           \
	}
COMPONENT(keyword_pxx, 0)
COMPONENT(keyword_pyy, 1)
COMPONENT(keyword_pzz, 2)
COMPONENT(keyword_pxy, 3)
COMPONENT(keyword_pxz, 4)
COMPONENT(keyword_pyz, 5)

static const struct ts_keyword keywords[] = {
	{ "press", "Press", "pressure", "pressure of all particles, see compute pressure",
	  TS_KEYWORD_CONTACTS, evaluate_press },
	{ "pxx", "Pxx", "pressure", "pressure tensor, xx", TS_KEYWORD_CONTACTS, keyword_pxx },
	{ "pyy", "Pyy", "pressure", "pressure tensor, yy", TS_KEYWORD_CONTACTS, keyword_pyy },
	{ "pzz", "Pzz", "pressure", "pressure tensor, zz", TS_KEYWORD_CONTACTS, keyword_pzz },
	{ "pxy", "Pxy", "pressure", "pressure tensor, xy", TS_KEYWORD_CONTACTS, keyword_pxy },
	{ "pxz", "Pxz", "pressure", "pressure tensor, xz", TS_KEYWORD_CONTACTS, keyword_pxz },
	{ "pyz", "Pyz", "pressure", "pressure tensor, yz", TS_KEYWORD_CONTACTS, keyword_pyz },
	{ .name = NULL },
};

static enum ts_status join(struct ts_instance *self, struct tsim *sim)
{
	struct ts_look *look = &sim->division->look;

	(void)self;
	if (!sim->run.shows_contacts || sim->run.needs_lists)
		return TS_OK;
	return ts_virial_join(sim, ts_sim_only(sim, TS_KIND_PAIR), &all_parts, look->virial,
			      &look->virial_step);
}

static void connect_contacts(struct tsim *sim)
{
	sim->neigh->callback.reach = ts_pair_reach;
	sim->neigh->callback.interact = ts_pair_interact;
}

const struct ts_system_style ts_contact_system = {
	.style = { .name = "contact",
		   .kind = TS_KIND_SYSTEM,
		   .join = join,
		   .summary = "contact laws for the neighbour search; the pressure in thermo output" },
	.keywords = keywords,
	.no_instance = true,
	.connect = connect_contacts,
};
