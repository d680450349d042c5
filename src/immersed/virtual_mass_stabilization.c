#include "immersed/virtual_mass_stabilization.h"

#include <string.h>

#include "particle/particles.h"
#include "particle/sphere_shape.h"
#include "rigid/rigid.h"

#include "base/banned.h"

void ts_net_force_stabilize(const struct ts_net_force *net, double share, double force[3], double torque[3])
{
	for (int k = 0; k < 6; k++) {
		double *f = k < 3 ? &force[k] : &torque[k - 3];

		*f = share * *f + (1 - share) * net->mean[k];
	}
}

void ts_net_force_record(struct ts_net_force *net, bool in_setup, const double force[3],
			 const double torque[3])
{
	for (int k = 0; k < 6; k++) {
		double f = k < 3 ? force[k] : torque[k - 3];

		if (!in_setup)
			net->sum[k] += 0.5 * ((net->begun != 0 ? net->last[k] : f) + f);
		net->last[k] = f;
	}
	net->steps += !in_setup;
	net->begun = 1;
}

void ts_net_force_average(struct ts_net_force *net)
{
	if (!(net->steps > 0))
		return;
	for (int k = 0; k < 6; k++)
		net->mean[k] = net->sum[k] / net->steps;
	memset(net->sum, 0, sizeof net->sum);
	net->steps = 0;
}

double ts_virtual_mass_density(const struct tsim *sim, size_t i)
{
	const struct ts_body *body = ts_rigid_body_of(sim, i);
	const struct ts_rigid *rigid = sim->rigid;
	double volume = 0;
	size_t b;

	if (!body || body->density > 0)
		return ts_rigid_material_density(sim, i);
	b = (size_t)(body - rigid->body);
	for (size_t k = rigid->start[b]; k < rigid->start[b + 1]; k++)
		volume += ts_particle_volume(sim, sim->particles->radius[rigid->member[k]]);
	return body->mass / volume;
}
