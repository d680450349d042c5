/* Ranks: processes that compute one simulation together.
 *
 * The program that started them provides the functions (program/program_ranks.c: MPI). Without ranks there is no
 * communicator: a pointer to it is NULL. All functions are collective: every rank calls the same ones in the same
 * order. They do not return if a rank has failed: then all of them end with the message of that rank. */
#ifndef TS_RANK_WORLD_H
#define TS_RANK_WORLD_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/status.h"

struct ts_world;

/* Bytes for another rank, or from it. */
struct ts_parcel {
	unsigned char *data;
	size_t n, capacity;
};

struct ts_world_functions {
	/* value[k] becomes the largest of all ranks. */
	void (*most)(struct ts_world *world, double *value, size_t n);
	/* The bytes of rank `from` are copied to all. */
	void (*spread)(struct ts_world *world, int from, void *bytes, size_t n);
	/* size[r] becomes the number of bytes that rank r has, of which this one has n. */
	void (*sizes)(struct ts_world *world, uint64_t n, uint64_t *size);
	/* The bytes of all ranks, size[r] of rank r, one after the other. TS_NOMEM: out of memory. */
	enum ts_status (*collect)(struct ts_world *world, const void *mine, const uint64_t *size,
				  unsigned char *all);
	/* number[k] becomes the sum of those of all ranks. */
	void (*sum)(struct ts_world *world, int64_t *number, size_t n);
	/* Sends out[r] to rank r where it is not empty, and appends what rank r has sent to in[r]: no rank knows from whom
	 * it receives. Also out of memory: TS_NOMEM. */
	enum ts_status (*deliver)(struct ts_world *world, const struct ts_parcel *out, struct ts_parcel *in);
	/* Sends out[r] to rank r and receives in[r], whose n is known on both sides; nothing where n is 0. */
	void (*swap)(struct ts_world *world, const struct ts_parcel *out, struct ts_parcel *in);
	/* Ends all ranks with a message of this one; does not return. */
	void (*fail)(struct ts_world *world, const char *message);
};

struct ts_world {
	int rank, n;
	const struct ts_world_functions *call;
	const void *
		communicator; /* MPI_Comm of these ranks, for libraries that use MPI themselves; NULL: not MPI */
	struct ts_world_counts {
		int64_t messages, bytes; /* sent by this rank to another one */
		int64_t agreements;	 /* operations in which all ranks wait for each other */
	} counts;
	/* Requests of signal handlers of this rank; all ranks agree on them in the next step. */
	volatile int stop, save;
};

/* Adds bytes to a parcel. */
enum ts_status ts_parcel_add(struct ts_parcel *parcel, const void *bytes, size_t n);
/* Makes room for n bytes, which the caller writes; NULL: out of memory. */
unsigned char *ts_parcel_extend(struct ts_parcel *parcel, size_t n);
void ts_parcel_release(struct ts_parcel *parcel);

/* value[k] becomes the largest of all ranks. */
void ts_world_most(struct ts_world *world, double *value, size_t n);
/* *number, or number[k], becomes the sum of those of all ranks. */
void ts_world_sum(struct ts_world *world, int64_t *number);
void ts_world_sums(struct ts_world *world, int64_t *number, size_t n);
/* The bytes of rank `from` are copied to all. */
void ts_world_spread(struct ts_world *world, int from, void *bytes, size_t n);
/* size[r] becomes the number that rank r has, of which this one has n. */
void ts_world_sizes(struct ts_world *world, uint64_t n, uint64_t *size);
/* Sends out[r] to rank r for all r, and receives in[r], of any size; out[rank] is copied to in[rank]. */
enum ts_status ts_world_deliver(struct ts_world *world, const struct ts_parcel *out, struct ts_parcel *in);
/* The same if in[r].n is known; out[rank] is ignored. */
void ts_world_swap(struct ts_world *world, const struct ts_parcel *out, struct ts_parcel *in);
/* Appends the parcels of all ranks, in the order of ranks, to `all`; of all other ranks to `others`. *own: where that of
 * this rank begins in `all`. */
enum ts_status ts_world_share(struct ts_world *world, const struct ts_parcel *mine, struct ts_parcel *all);
enum ts_status ts_world_share_own(struct ts_world *world, const struct ts_parcel *mine, struct ts_parcel *all,
				  size_t *own);
enum ts_status ts_world_share_others(struct ts_world *world, const struct ts_parcel *mine,
				     struct ts_parcel *others);

/* The same as ts_world_share if the bytes of each rank are known. */
enum ts_status ts_world_share_known(struct ts_world *world, const struct ts_parcel *mine,
				    const uint64_t *size, struct ts_parcel *all);

#endif
