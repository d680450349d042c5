/* A height field pressed against a plane or another field: what compute surface/contact solves, and others read of it by
 * its ID. */
#ifndef TS_ROUGH_PRESSED_SURFACE_H
#define TS_ROUGH_PRESSED_SURFACE_H

#include "core/sim.h"
#include "rough/rough_contact.h"
#include "voxel/voxel_field.h"

#define TS_FAMILY_PRESSED "pressed surface"

enum ts_pressed_model { TS_PRESSED_WINKLER, TS_PRESSED_HALF_SPACE };

/* First member of the state of every style of TS_FAMILY_PRESSED. */
struct ts_pressed_surface {
	/* arguments; hardness NaN: elastic, counter_young NaN: rigid */
	const char *surface_id, *counter_id;
	int model; /* enum ts_pressed_model */
	double stiffness, young, poisson, counter_young, counter_poisson, hardness, tolerance;
	int64_t iterations;
	struct ts_number mean_pressure;

	struct tsim *sim;
	const struct ts_instance *by; /* the fix of the surface */
	const struct ts_voxel_field *field, *counter;
	/* the solution; arrays have a number for each column */
	size_t n;
	double *height, *pressure, *gap; /* height: sum of both surfaces */
	struct ts_rough_result result;
	struct ts_half_space half_space;
	double solved_pressure; /* it belongs to this mean pressure and these heights */
	bool solved;
};

/* In the init of the style: finds the surfaces. */
enum ts_status ts_pressed_surface_init(struct ts_instance *self, struct tsim *sim);
void ts_pressed_surface_release(struct ts_pressed_surface *s);
/* Solves for the present heights and pressure, unless that is done already. */
enum ts_status ts_pressed_surface_solve(struct ts_instance *self);

/* Finds the compute of this ID; fails with an error at the word, and a suggestion, if there is none. */
enum ts_status ts_pressed_surface_require(struct tsim *sim, const struct ts_word *id,
					  struct ts_instance **out);

#endif
