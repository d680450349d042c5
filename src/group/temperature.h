/* Kinetic tensors and the temperature made of them. */
#ifndef TS_GROUP_TEMPERATURE_H
#define TS_GROUP_TEMPERATURE_H

#include "particle/group_moments.h"

/* Sums of m u_a u_b, u = v - mean, over the group, in the order of ts_tensor_names, and the number of
 * particles behind them. mean NULL: 0. */
void ts_temperature_tensor(const struct tsim *sim, int group, const double mean[3], double out[7]);
/* How many of the D N degrees of freedom do not count: D, or what compute_modify extra says. First member
 * of the state of computes that give temperatures. */
struct ts_freedom {
	bool given;
	double missing;
};
/* The words of compute_modify: the slot modify of such computes; and the same for other owners. */
enum ts_status ts_freedom_modify(struct ts_instance *self, struct tsim *sim, struct ts_words words,
				 size_t *used);
enum ts_status ts_freedom_read(struct ts_freedom *freedom, struct tsim *sim, struct ts_words words,
			       size_t *used);
/* sum m u^2 / ((D N - missing) k_B); 0 without degrees of freedom. freedom NULL: D are missing. */
double ts_temperature(const struct tsim *sim, const double tensor[7], const struct ts_freedom *freedom);

#endif
