/* Slip between fluid and particle, and the particles on which a drag has an effect. */
#ifndef TS_COUPLING_DRAG_SLIP_H
#define TS_COUPLING_DRAG_SLIP_H

#include "coupling/drag_force.h"
#include "coupling/sphere_rows.h"
#include "particle/sphere_shape.h"
#include "rigid/rigid.h"

/* Whether the drag acts along axis k (keyword axes). */
static inline bool ts_drag_acts_along(const struct ts_drag *drag, int k)
{
	static const int bits[] = { 1, 2, 4, 3, 5, 6, 7 };

	return bits[drag->axes] >> k & 1;
}
/* Whether forces do not change the velocity of particle i: it is frozen or no fix integrates it. (With an
 * outside program attached, particles without such a fix are not counted: the program may move them.) */
static inline bool ts_drag_motion_prescribed(const struct ts_drag *s, const struct tsim *sim, size_t i)
{
	const struct ts_particles *p = sim->particles;

	return p->imass[i] == 0 ||
	       (!(p->mask[i] & s->moving_groups) && !sim->outside && !ts_rigid_member(p, i));
}

/* Force by slip velocity, by the law of the style. */
static inline double ts_drag_coefficient(const struct ts_instance *self, const struct tsim *sim,
					 const struct ts_slip *slip)
{
	return ts_drag_style_of(self)->coefficient(self->state, slip) *
	       ts_spheres_in_row(sim, slip->diameter);
}

/* Mass of particle i, including added mass. */
static inline double ts_drag_mass(const struct ts_drag *s, const struct tsim *sim, size_t i)
{
	const struct ts_particles *p = sim->particles;

	if (!s->added.n)
		return p->mass[i];
	return p->mass[i] + ts_added_mass_density(&s->added, p, i) * ts_particle_volume(sim, p->radius[i]);
}

/* Finds the slip w = u - v at particle i, and diameter, speed and void fraction for the law; false if the
 * particle is outside the fluid. */
bool ts_drag_slip_at(const struct ts_instance *self, const struct ts_particles *p, size_t i,
		     struct ts_slip *slip, double w[3]);

/* Several particles at once. */
enum { TS_DRAG_BATCH = 32 };
struct ts_drag_slips {
	size_t n, of[TS_DRAG_BATCH]; /* the particles */
	double density, viscosity;
	struct ts_slip slip[TS_DRAG_BATCH];
	double w[TS_DRAG_BATCH][3];
	bool inside[TS_DRAG_BATCH]; /* there is fluid, and slip and w are set */
};
/* As ts_drag_slip_at, for each of them. */
void ts_drag_find_slips(const struct ts_instance *self, const struct ts_particles *p,
			struct ts_drag_slips *slips);

#endif
