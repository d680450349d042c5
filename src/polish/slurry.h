/* Active particles between a pad and a wafer: what all computes active/MODEL have in common.
 *
 * A model is a function, numbers in, numbers out (law/active_particles.h). A style begins its state with a struct
 * ts_slurry_contact, its arguments with TS_SLURRY_ARGS, and its table has
 *
 *	.init: calls ts_slurry_contact_init,  .values = ts_slurry_values */
#ifndef TS_POLISH_SLURRY_H
#define TS_POLISH_SLURRY_H

#include "core/sim.h"
#include "law/active_particles.h"

typedef struct ts_active_particles ts_active_fn(const struct ts_slurry *s, const struct ts_polish_contact *c);

/* First member of the state. */
struct ts_slurry_contact {
	/* arguments; the hardness may be 0 in models that do not need it */
	const char *contact_id;
	struct ts_slurry slurry;
	double wafer_hardness;

	ts_active_fn *count;
	struct ts_instance *pressed; /* the compute surface/contact */
};

#define TS_SLURRY_ARGS(T)                                                                        \
	TS_WORD("contact", T, contact_id, .flags = TS_POSITIONAL,                                \
		.help = "ID of a compute surface/contact: the pad under the wafer"),             \
		TS_REAL("radius", T, slurry.radius, .range = TS_POSITIVE, .unit = "length",      \
			.help = "mean radius of the particles"),                                 \
		TS_REAL("fraction", T, slurry.fraction, .range = TS_WITHIN, .lo = 0, .hi = 0.74, \
			.help = "volume of the particles in a volume of slurry")

/* In the init of the style: finds the compute surface/contact. */
enum ts_status ts_slurry_contact_init(struct ts_instance *self, struct tsim *sim, ts_active_fn *count);
/* Outputs: c_ID the number of active particles, c_ID[1..3] all, eligible, active. */
extern const struct ts_value ts_slurry_values[];

#endif
