/* Rows of particles that all ranks give to each other. They are sent in pieces and received where they stay: a rank that has all
 * particles then has their columns once. */
#ifndef TS_PARTICLE_SHARED_ROWS_H
#define TS_PARTICLE_SHARED_ROWS_H

#include "particle/particles.h"

/* The order of the particles that a rank has then. */
enum ts_shared_order {
	TS_SHARED_OWN_FIRST, /* the own ones stay, those of the other ranks follow */
	TS_SHARED_BY_RANK    /* the same on all ranks */
};

/* Each rank gets the particles of all ranks; with TS_SHARED_OWN_FIRST of the others those with chosen[i] there (NULL: all). Ghosts
 * are dropped. */
enum ts_status ts_shared_rows(struct tsim *sim, enum ts_shared_order order, const unsigned char *chosen);

/* Copies rows from .. from+n-1 of the first `columns` columns to or from `bytes`, column by column; returns the number
 * of bytes. bytes NULL: only counts them. */
size_t ts_shared_rows_move(const struct ts_particles *p, size_t columns, size_t from, size_t n, bool out,
			   unsigned char *bytes);

#endif
