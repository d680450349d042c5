/* Sums over the particles of a group, without rounding in the sum. Positions are those without periodic
 * wrapping. */
#ifndef TS_PARTICLE_GROUP_MOMENTS_H
#define TS_PARTICLE_GROUP_MOMENTS_H

#include "box/domain.h"
#include "particle/particles.h"

/* Where particle i would be had it never been wrapped. */
static inline void ts_unwrapped(const struct tsim *sim, size_t i, double x[3])
{
	const struct ts_particles *p = sim->particles;

	for (int d = 0; d < 3; d++)
		x[d] = p->x[i][d] + p->image[i][d] * ts_box_length(&sim->domain->box, d);
}

double ts_group_count(const struct tsim *sim, int group);
double ts_group_mass(const struct tsim *sim, int group);
/* Centre of mass and its velocity; 0 for a group without particles. */
void ts_group_centre(const struct tsim *sim, int group, double x[3]);
void ts_group_velocity(const struct tsim *sim, int group, double v[3]);

/* The sum of any `width` <= 8 numbers over the group. */
enum { TS_MOST_TERMS = 8 };
typedef void ts_term_fn(const struct tsim *sim, size_t i, void *context, double *term);
void ts_group_sum(const struct tsim *sim, int group, size_t width, ts_term_fn *term, void *context,
		  double *out);

/* Components of symmetric tensors in the order xx, yy, zz, xy, xz, yz. */
extern const int ts_tensor_row[6], ts_tensor_column[6];
extern const char *const ts_tensor_names[];

#endif
