/* A film of grains sheared between two rough walls, in units of the script: of gap, solid fraction (or amount of grains),
 * speed and load one is unknown and follows from the others by granular_couette.h. */
#ifndef TS_KINETIC_SHEARED_FILM_H
#define TS_KINETIC_SHEARED_FILM_H

#include <stdbool.h>

#include "kinetic/granular_couette.h"

/* Which solution, where several solid fractions carry the load. */
enum ts_sheared_branch { TS_SHEARED_DENSE, TS_SHEARED_DILUTE };

struct ts_sheared_film {
	/* given */
	struct ts_gas gas;
	struct ts_bumpy_wall wall[2];
	double diameter, density; /* of the grains */
	double gap;
	double solids; /* mean solid fraction */
	double amount; /* volume of the grains over the area: solids times gap */
	double speed;  /* of the lower wall */
	double load;   /* normal stress */
	/* of gap, solids and amount together, speed, load one is NaN: unknown */
	enum ts_sheared_branch branch;
	int points; /* of the profile */
	double tolerance;
	bool count; /* count the solutions */

	/* solution; zero-initialise, release by ts_sheared_film_release */
	struct ts_couette couette;	   /* without units */
	struct ts_couette_figures figures; /* in units of the script: velocities, T, energy/(area time) */
	int solutions;			   /* found; 0: not counted */
};

/* Checks the input. Errors: TS_RANGE, TS_STATE. */
enum ts_status ts_sheared_film_check(const struct ts_sheared_film *f, const struct ts_place *where,
				     struct ts_error *error);

/* Checks the input and solves; the unknown one is set. Further errors: TS_NOMEM, TS_PHYSICS: there is no solution, or
 * none was found. */
enum ts_status ts_sheared_film_solve(struct ts_sheared_film *f, const struct ts_place *where,
				     struct ts_error *error);

/* Rows of y, velocity, solid fraction, T at the points of the profile. */
enum ts_status ts_sheared_film_profile(const struct ts_sheared_film *f, double (*out)[4]);
void ts_sheared_film_release(struct ts_sheared_film *f);

#endif
