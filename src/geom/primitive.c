#include "geom/primitive.h"

#include <math.h>

#include "base/banned.h"

static double plane_distance(const struct ts_primitive *wall, const double x[3], double n[3])
{
	int dim = (int)wall->shape;
	double d = x[dim] - wall->position;

	n[dim] = d > 0 ? 1 : d < 0 ? -1 : 0;
	return fabs(d);
}

static double cylinder_distance(const struct ts_primitive *wall, const double x[3], double n[3])
{
	int axis = (int)wall->shape - TS_XCYLINDER;
	int a = (axis + 1) % 3, b = (axis + 2) % 3;
	double da = x[a] - wall->centre[0], db = x[b] - wall->centre[1];
	double r = sqrt(da * da + db * db), sign;

	if (!(r > 0))
		return wall->radius;
	sign = r > wall->radius ? 1 : r < wall->radius ? -1 : 0;
	n[a] = sign * da / r;
	n[b] = sign * db / r;
	return fabs(r - wall->radius);
}

double ts_primitive_distance(const struct ts_primitive *wall, const double x[3], double n[3])
{
	n[0] = n[1] = n[2] = 0;
	return wall->shape <= TS_ZPLANE ? plane_distance(wall, x, n) : cylinder_distance(wall, x, n);
}
