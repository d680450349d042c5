/* Bonds that transmit moments, in the order in which they are computed (bond_moment_loop.c).
 *
 * Each bond is computed once, eight at a time. Particles are taken in chunks, in the order of memory: the bonds
 * of a chunk to later particles are computed, then the forces of its particles are summed, as those of their
 * bonds to earlier particles are known. Until both particles have summed it, the result of a bond stays in a
 * slot; slots are reused, as in neigh/force_slots.h, so that few are in use and stay in the cache. Each thread
 * has a share of the chunks. A bond between two shares is computed in both: both get the same bits, as all
 * bonds are computed from their first partner. */
#ifndef TS_BOND_BOND_ROWS_H
#define TS_BOND_BOND_ROWS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/status.h"

struct tsim;
struct ts_bonds;

enum { TS_BOND_CHUNK = 64 };	/* particles */
enum { TS_BOND_ROW_LANES = 8 }; /* bonds of a row */

/* A row of bonds, and the constants (law/bond_element.h) in which most bonds differ. Where there is no bond, both
 * partners are the same particle, and the length is 0. */
struct ts_bond_row {
	int32_t particle[2][TS_BOND_ROW_LANES]; /* local indices of the partners */
	uint32_t bond[TS_BOND_ROW_LANES];	/* TS_BOND_NONE: no bond */
	uint32_t slot[TS_BOND_ROW_LANES];	/* where the result is put */
	double frame[2][4][TS_BOND_ROW_LANES];	/* of ts_bond_reference */
	double length[TS_BOND_ROW_LANES], fraction[TS_BOND_ROW_LANES];
};

/* The other constants of a row. Rows of equal bonds share them, which halves what is read from memory. */
struct ts_bond_sections {
	double k[4][TS_BOND_ROW_LANES];
	double per_area[TS_BOND_ROW_LANES], per_moment[TS_BOND_ROW_LANES], per_torque[TS_BOND_ROW_LANES],
		lever[TS_BOND_ROW_LANES];
	double tension[TS_BOND_ROW_LANES], shear[TS_BOND_ROW_LANES], compression[TS_BOND_ROW_LANES];
};

/* Damping constants of a row. */
struct ts_bond_dashpots {
	double c[4][TS_BOND_ROW_LANES];
};

/* Softening and friction of a row (law/bond_softening.h): constants, and what the bonds remember. */
struct ts_bond_softening {
	double onset[TS_BOND_ROW_LANES], rupture[TS_BOND_ROW_LANES], shear_rupture[TS_BOND_ROW_LANES];
	double friction[TS_BOND_ROW_LANES];
	double reached[TS_BOND_ROW_LANES], release[TS_BOND_ROW_LANES];
};

/* Force on the second partner and torques on both, each with an unused fourth number. */
struct ts_bond_result {
	double force[4], torque[2][4];
};

struct ts_bond_rows {
	size_t *first;			   /* rows of chunk c: first[c] .. first[c + 1] - 1 */
	struct ts_bond_row *row;	   /* [n] */
	struct ts_bond_sections *sections; /* [n] */
	uint32_t *sections_of;		   /* [n]: index in sections */
	struct ts_bond_dashpots *dashpots; /* [n] if a bond is damped, else NULL */
	struct ts_bond_softening *soft;	   /* [n] if a bond softens, else NULL */
	/* 2 slot + side of the bonds of each particle, in the order of ts_bonds.gather */
	uint32_t *sum;
	struct ts_bond_result *result; /* slots; the first of each share is for lanes without a bond */
	size_t n, particles, chunks;
	int shares;
	bool filled;	      /* constants are up to date */
	bool damped, softens; /* what has been filled in besides */
	size_t first_capacity, row_capacity, sections_capacity, sections_of_capacity, dashpots_capacity,
		soft_capacity, sum_capacity, result_capacity;
};

/* Lists the bonds; their gather must be up to date. The constants are not filled in. */
enum ts_status ts_bond_rows_build(const struct tsim *sim, struct ts_bonds *bonds);
void ts_bond_rows_release(struct ts_bond_rows *rows);

/* Chunks of share k: from here to that of share k + 1. */
size_t ts_bond_share_begin(const struct ts_bond_rows *rows, size_t k);
/* One past the last particle of chunk c. */
size_t ts_bond_chunk_end(const struct ts_bond_rows *rows, size_t c);

#endif
