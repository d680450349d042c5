/* Particles squeezed between two walls: those on which both press at once. The force of a wall on a particle is the sum
 * of the normal forces of its contacts with the wall; the smaller of the two squeezes the particle. */
#ifndef TS_WALL_SQUEEZE_H
#define TS_WALL_SQUEEZE_H

#include "wall/wall.h"

/* First member of the state of styles that look for them. */
struct ts_squeeze {
	const char *id[2];
	double threshold; /* force */

	struct tsim *sim;
	const struct ts_wall *wall[2]; /* found in init */
	double (*force)[2];	       /* [n] of the last ts_squeeze_find_forces */
	size_t capacity;
};

#define TS_SQUEEZE_ARGS(T, f)                                                                   \
	TS_WORD("first", T, f.id[0], .flags = TS_POSITIONAL, .help = "ID of a fix wall/gran"),  \
		TS_WORD("second", T, f.id[1], .flags = TS_POSITIONAL,                           \
			.help = "ID of another fix wall/gran"),                                 \
		TS_REAL("threshold", T, f.threshold, .fallback = "0", .range = TS_NOT_NEGATIVE, \
			.unit = "force", .help = "force that both walls exceed")

/* In init and fini of the style. */
enum ts_status ts_squeeze_init(struct ts_instance *self, struct tsim *sim, struct ts_squeeze *s);
void ts_squeeze_release(struct ts_squeeze *s);

/* Finds the forces of both walls on all particles, 0 on those outside the group. */
enum ts_status ts_squeeze_find_forces(struct ts_instance *self, struct ts_squeeze *s);

/* The force that squeezes particle i; 0: it is not squeezed. */
static inline double ts_squeeze_force(const struct ts_squeeze *s, size_t i)
{
	double least = s->force[i][0] < s->force[i][1] ? s->force[i][0] : s->force[i][1];

	return least > s->threshold ? least : 0;
}

#endif
