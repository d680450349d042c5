#include "particles/temperature.h"

#include "core/units.h"
#include "math/vec3.h"

#include "base/banned.h"

static void kinetic(const struct tsim *sim, size_t i, void *context, double *term)
{
	double v[3];

	ts_sub(sim->particles->v[i], context, v);
	for (int k = 0; k < 6; k++)
		term[k] = sim->particles->mass[i] * v[ts_tensor_row[k]] * v[ts_tensor_column[k]];
	term[6] = 1;
}

void ts_kinetic_tensor(const struct tsim *sim, int group, const double mean[3], double out[7])
{
	double shift[3] = { 0 };

	for (int d = 0; mean && d < 3; d++)
		shift[d] = mean[d];
	ts_group_sum(sim, group, 7, kinetic, shift, out);
}

double ts_temperature(const struct tsim *sim, const double t[7])
{
	double freedom = sim->dimension * (t[6] - 1);
	double twice_energy = t[0] + t[1] + (sim->dimension == 3 ? t[2] : 0);

	return freedom > 0 ? twice_energy / (freedom * ts_boltzmann(sim)) : 0;
}
