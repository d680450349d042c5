/* Kinetic tensors and the temperature made of them. */
#ifndef TS_PARTICLES_TEMPERATURE_H
#define TS_PARTICLES_TEMPERATURE_H

#include "particles/moments.h"

/* Sums of m u_a u_b, u = v - mean, over the group, in the order of ts_tensor_names, and the number of
 * particles behind them. mean NULL: 0. */
void ts_kinetic_tensor(const struct tsim *sim, int group, const double mean[3], double out[7]);
/* sum m u^2 / (D (N - 1) k_B); 0 without degrees of freedom. */
double ts_temperature(const struct tsim *sim, const double tensor[7]);

#endif
