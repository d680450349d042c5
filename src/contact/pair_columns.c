#include "contact/pair_columns.h"

#include "math/vec3.h"

#include "base/banned.h"

double ts_pair_dist(const struct tsim *sim, const struct ts_contact_view *view)
{
	(void)sim;
	return view->distance;
}

double ts_pair_force(const struct tsim *sim, const struct ts_contact_view *view)
{
	(void)sim;
	return view->distance > 0 ? ts_dot(view->force, view->d) / view->distance : 0;
}

#define COMPONENT(name, field, k)                                               \
	double name(const struct tsim *sim, const struct ts_contact_view *view) \
	{                                                                       \
		(void)sim;                                                      \
		return view->field[k];                                          \
	}
COMPONENT(ts_pair_fx, force, 0)
COMPONENT(ts_pair_fy, force, 1)
COMPONENT(ts_pair_fz, force, 2)
COMPONENT(ts_pair_dx, d, 0)
COMPONENT(ts_pair_dy, d, 1)
COMPONENT(ts_pair_dz, d, 2)
