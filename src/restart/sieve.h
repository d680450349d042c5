/* read_restart on several ranks, each of which keeps the particles of its block, and the contacts of these, out of the sections
 * of a file that come in pieces: the rank makes shorter sections, which are restored like whole ones. */
#ifndef TS_RESTART_SIEVE_H
#define TS_RESTART_SIEVE_H

#include "core/archive_pieces.h"
#include "core/sim.h"

struct ts_sieve {
	struct tsim *sim;
	/* particles */
	size_t n, kept;	     /* in the file, of this rank */
	unsigned char *keep; /* [n] */
	int32_t *tag;	     /* [n], while places are read */
	double (*x)[3];	     /* [n], the same */
	unsigned char *near; /* by identity: bits of particles that are, or may soon be, of this rank */
	size_t near_bytes;

	/* the field that is read; bits of those of places that have come */
	int field;
	unsigned seen;
	size_t row, width, have;  /* number of its row; bytes of a row; of the present one that have come */
	unsigned char part[8192]; /* of a row */

	/* contacts */
	size_t contacts, contacts_kept, history; /* in the file, of this rank; numbers of each */
	unsigned char *keep_contact;

	/* the shorter section */
	char *block;
	size_t length, capacity;
	size_t count_at; /* where the number of elements of the field is */
	size_t per_row;	 /* elements of a row; 0: the field is copied as it is */
	size_t number_at, written;
	bool rows; /* this field and those after it are columns of particles */
};

/* Takes the section of the particles: chooses the blocks of the ranks, and the particles of this one. */
struct ts_archive_taker ts_sieve_places(struct ts_sieve *sieve);
/* Whether all that is needed has come; else the section is not one of particles. */
bool ts_sieve_has_places(const struct ts_sieve *sieve);
/* Take the sections again, or those of contacts, and make shorter ones. */
struct ts_archive_taker ts_sieve_particles(struct ts_sieve *sieve);
struct ts_archive_taker ts_sieve_contacts(struct ts_sieve *sieve);
/* The shorter section, which belongs to the caller; *n: its bytes. NULL: out of memory. */
unsigned char *ts_sieve_section(struct ts_sieve *sieve, size_t *n);
void ts_sieve_release(struct ts_sieve *sieve);

#endif
