/* Sums over the particles of a group, number and mass, and positions for them. Sums are exact and rounded once, so they do
 * not depend on the order of the particles. Positions are unwrapped. */
#ifndef TS_PARTICLE_GROUP_MOMENTS_H
#define TS_PARTICLE_GROUP_MOMENTS_H

#include "box/domain.h"
#include "math/exactsum.h"
#include "particle/particles.h"

/* Unwrapped position of particle i: x + image * box length, plus the displacements of sheared images. */
static inline void ts_unwrapped(const struct tsim *sim, size_t i, double x[3])
{
	const struct ts_particles *p = sim->particles;

	for (int d = 0; d < 3; d++)
		x[d] = p->x[i][d] + p->image[i][d] * ts_box_length(&sim->domain->box, d);
	ts_unwrap_shear(&sim->domain->box, p->image[i], x);
}

/* Moves x to its periodic image in the box, and counts that in image[]. */
static inline void ts_wrap_point(const struct ts_box *box, double x[3], int32_t image[3])
{
	for (int d = 0; d < 3; d++) {
		const int32_t before = image[d];

		if (!ts_box_periodic(box, d) || !ts_box_wrap(box, d, &x[d], &image[d]))
			continue;
		if (box->shear.on && d == box->shear.gradient)
			(void)ts_box_wrap_shear(box, x, image, image[d] - before);
	}
}

/* Position of particle i in the box, and its image: between rebuilds of the contact list particles may be beyond a periodic
 * face. */
static inline void ts_wrapped(const struct tsim *sim, size_t i, double x[3], int32_t image[3])
{
	const struct ts_particles *p = sim->particles;

	for (int d = 0; d < 3; d++) {
		x[d] = p->x[i][d];
		image[d] = p->image[i][d];
	}
	ts_wrap_point(&sim->domain->box, x, image);
}

/* Number and mass of the particles in the group. */
double ts_group_count(const struct tsim *sim, int group);
double ts_group_mass(const struct tsim *sim, int group);

/* Sums `width` <= TS_MOST_TERMS numbers over the group; the function, called by several threads, writes those of particle i to
 * term[]. */
enum { TS_MOST_TERMS = 8 };
typedef void ts_term_fn(const struct tsim *sim, size_t i, const void *context, double *term);
void ts_group_sum(const struct tsim *sim, int group, size_t width, ts_term_fn *term, const void *context,
		  double *out);
/* The same with a function that writes the terms of the particles from .. from+n-1, in the group or not, to columns: term[k][0]
 * .. term[k][n-1]. There are TS_MOST_TERMS columns, of which the first `width` are summed. */
enum { TS_TERM_BLOCK = TS_EXACTSUM_WAITING };
typedef void ts_terms_fn(const struct tsim *sim, size_t from, size_t n, const void *context,
			 double (*term)[TS_TERM_BLOCK]);
void ts_group_sum_blocks(const struct tsim *sim, int group, size_t width, ts_terms_fn *terms,
			 const void *context, double *out);

/* Components of symmetric tensors in the order xx, yy, zz, xy, xz, yz. */
extern const int ts_tensor_row[6], ts_tensor_column[6];
extern const char *const ts_tensor_names[];
/* Terms m v_a v_b of n particles, in columns as above. */
void ts_group_tensor_terms(const double *m, size_t n, double (*v)[TS_TERM_BLOCK],
			   double (*term)[TS_TERM_BLOCK]);

#endif
