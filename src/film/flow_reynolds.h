/* State and arguments of flow_style reynolds. */
#ifndef TS_FILM_FLOW_REYNOLDS_H
#define TS_FILM_FLOW_REYNOLDS_H

#include "film/film_flow.h"

struct ts_reynolds {
	struct ts_film_flow flow;
	struct ts_words cells, set, closed, open, roelands, roughness, asperities;
	double edge[2][2]; /* pressures given; NaN: ambient */
	double viscosity, density, ambient, cavity;
	double slip[2]; /* slip lengths, lower and upper */
	double barus;	/* NaN: not given */
	int shape, cavitation, update, touching;
	bool floating;

	bool ready;	/* solved since the beginning of the run */
	bool solved;	/* `input` is that of the present solution */
	bool began;	/* transient: content is set; saved */
	bool told;	/* the warning that nothing drives the film */
	uint64_t input; /* hash of all that the solution depends on */
};

/* ---- flow_reynolds_words.c: in the init of the style */

/* The film ends at the faces of the box, which must not follow particles. */
enum ts_status ts_reynolds_check_faces(struct ts_instance *self, struct tsim *sim);
/* Kinds and pressures of the edges. */
enum ts_status ts_reynolds_read_edges(struct ts_instance *self, struct tsim *sim);
enum ts_status ts_reynolds_read_roughness(struct ts_instance *self, struct tsim *sim);
enum ts_status ts_reynolds_read_asperities(struct ts_instance *self, struct tsim *sim);
/* As a function of the pressure. */
enum ts_status ts_reynolds_read_viscosity(struct ts_instance *self, struct tsim *sim);

#endif
