/* Sweeps over the cells of a contact in search of its pressures (rough/rough_contact.c): each changes arrays elementwise
 * and sums on the way. Sums are formed in eight lanes over blocks of cells, and over the blocks in order: neither the
 * number of threads nor the instruction set changes a bit. */
#ifndef TS_ROUGH_CONTACT_SWEEP_H
#define TS_ROUGH_CONTACT_SWEEP_H

#include <stddef.h>

#include "base/status.h"

struct ts_contact_sweep {
	size_t n; /* cells */
	int threads;
	double top;	       /* the pressures are within 0 and top */
	double *p, *gap;       /* given by the caller */
	double *gradient;      /* S p - h: the gap but for a constant */
	double *move, *change; /* of the pressures, and S times it */
	double (*part)[2];     /* sums of the blocks */
};

/* Allocates gradient, move, change and part. Returns TS_OK or TS_NOMEM; to be released also after a failure. */
enum ts_status ts_contact_sweep_make(struct ts_contact_sweep *s);
void ts_contact_sweep_release(struct ts_contact_sweep *s);

/* move = p - rate gap. */
void ts_contact_sweep_descend(struct ts_contact_sweep *s, double rate);
/* Sums of (move + shift), brought within the limits, and of the cells that are within them. */
void ts_contact_sweep_shift(struct ts_contact_sweep *s, double shift, double sum[2]);
/* move = (move + shift), brought within the limits, - p. Sums of gap move and move^2. */
void ts_contact_sweep_limit(struct ts_contact_sweep *s, double shift, double sum[2]);
/* Sums of move change and change^2. */
void ts_contact_sweep_respond(struct ts_contact_sweep *s, double sum[2]);
/* p += share move, gradient += share change. */
void ts_contact_sweep_advance(struct ts_contact_sweep *s, double share);
/* Sums over the cells with 0 < p < top: of the gradient, and of the cells. */
void ts_contact_sweep_contacts(struct ts_contact_sweep *s, double sum[2]);
/* gap = gradient - mean. Returns the largest violation of gap = 0 where 0 < p < top, gap >= 0 where p = 0, gap <= 0
 * where p = top. */
double ts_contact_sweep_gap(struct ts_contact_sweep *s, double mean);

#endif
