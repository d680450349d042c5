/* Kinetic tensor of a group, and its temperature. */
#ifndef TS_GROUP_TEMPERATURE_H
#define TS_GROUP_TEMPERATURE_H

#include "particle/group_moments.h"

/* Kinetic tensor: sums of m u_a u_b, u = v - mean, over the group in the order of ts_tensor_names;
 * out[6]: number of particles. mean NULL: 0. */
void ts_temperature_tensor(const struct tsim *sim, int group, const double mean[3], double out[7]);
/* The same with u the peculiar velocity of particle i: that relative to a flow. */
typedef void ts_peculiar_velocity(const struct tsim *sim, size_t i, const void *flow, double u[3]);
void ts_temperature_tensor_in(const struct tsim *sim, int group, ts_peculiar_velocity *peculiar,
			      const void *flow, double out[7]);
/* Writes the tensor without the number of particles: an output of six numbers. */
enum ts_status ts_temperature_write_tensor(const double tensor[7], struct ts_table *out);
/* Number of degrees of freedom that are subtracted from D N: D, or that of compute_modify extra. First
 * member of the state of computes that give temperatures. */
struct ts_freedom {
	bool given; /* by compute_modify */
	double missing;
};
/* Reads the words of compute_modify: as the slot `modify` of such computes, and for any ts_freedom. */
enum ts_status ts_freedom_modify(struct ts_instance *self, struct tsim *sim, struct ts_words words,
				 size_t *used);
enum ts_status ts_freedom_read(struct ts_freedom *freedom, struct tsim *sim, struct ts_words words,
			       size_t *used);
/* T = sum m u^2 / ((D N - missing) k_B); 0 without degrees of freedom. freedom NULL: missing = D. */
double ts_temperature(const struct tsim *sim, const double tensor[7], const struct ts_freedom *freedom);
/* The same with this number of missing degrees of freedom. */
double ts_temperature_without(const struct tsim *sim, const double tensor[7], double missing);

#endif
