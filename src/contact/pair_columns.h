/* Columns that computes of contacts and of bonds have in common: distance and force along the line of
 * centres, and by components. */
#ifndef TS_CONTACT_PAIR_COLUMNS_H
#define TS_CONTACT_PAIR_COLUMNS_H

#include "contact/contact_view.h"

typedef double ts_pair_column_fn(const struct tsim *sim, const struct ts_contact_view *view);

struct ts_pair_column {
	const char *name;
	ts_pair_column_fn *value;
};

/* Distance of the centres, length; force along the line of centres, > 0 repelling; the force on the first
 * particle; the vector to it from the second. */
double ts_pair_dist(const struct tsim *sim, const struct ts_contact_view *view);
double ts_pair_force(const struct tsim *sim, const struct ts_contact_view *view);
double ts_pair_fx(const struct tsim *sim, const struct ts_contact_view *view);
double ts_pair_fy(const struct tsim *sim, const struct ts_contact_view *view);
double ts_pair_fz(const struct tsim *sim, const struct ts_contact_view *view);
double ts_pair_dx(const struct tsim *sim, const struct ts_contact_view *view);
double ts_pair_dy(const struct tsim *sim, const struct ts_contact_view *view);
double ts_pair_dz(const struct tsim *sim, const struct ts_contact_view *view);

#define TS_PAIR_COLUMNS                                                                                   \
	{ "dist", ts_pair_dist }, { "force", ts_pair_force }, { "fx", ts_pair_fx }, { "fy", ts_pair_fy }, \
		{ "fz", ts_pair_fz }, { "dx", ts_pair_dx }, { "dy", ts_pair_dy },                         \
	{                                                                                                 \
		"dz", ts_pair_dz                                                                          \
	}

#endif
