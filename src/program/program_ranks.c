/* All operations are started without blocking and then polled: so the first rank learns while it waits that another one
 * has failed, prints its message and ends all. */
#include "program/program_ranks.h"

#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/alloc.h"
#include "base/clock.h"
#include "base/str.h"
#ifdef TS_WITH_MPI
#include "program/program_mpi.h"
#include "rank/waiting.h"
#endif

#include "base/banned.h"

/* Variables by which the usual launchers tell how many processes they have started, or that they have. */
enum { LAUNCHERS = 3 };
static const char *const numbers[LAUNCHERS] = { "OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "MV2_COMM_WORLD_SIZE" };
static const char *const ranks[LAUNCHERS] = { "OMPI_COMM_WORLD_RANK", "PMI_RANK", "MV2_COMM_WORLD_RANK" };

/* The number of the first of these variables that has one. */
static int64_t number_of(const char *const *variables, int64_t otherwise)
{
	int64_t n;

	for (int k = 0; k < LAUNCHERS; k++) {
		const char *text = getenv(variables[k]);

		if (text && ts_parse_int(text, &n))
			return n;
	}
	return otherwise;
}

static int64_t started_processes(void)
{
	return number_of(numbers, 1);
}

bool ts_program_ranks_first(void)
{
	return number_of(ranks, 0) == 0;
}

static void spread_bytes(void *data, void *bytes, size_t n)
{
	ts_world_spread(data, 0, bytes, n);
}

static void end_astray(void *data, const char *called)
{
	struct ts_world *world = data;
	char text[128];

	snprintf(text, sizeof text,
		 "tsim: internal error: rank %d calls '%s' of files while the first rank calls something "
		 "else\n",
		 world->rank, called);
	ts_program_ranks_fail(world, text);
}

struct ts_files_peers ts_program_ranks_files(struct ts_world *world)
{
	return (struct ts_files_peers){
		.first = world->rank == 0, .spread = spread_bytes, .astray = end_astray, .data = world
	};
}

#ifndef TS_WITH_MPI

const char *ts_program_ranks_standard(void)
{
	return "no";
}

struct ts_world *ts_program_ranks_begin(int *argc, char ***argv, const char **why)
{
	(void)argc;
	(void)argv;
	if (started_processes() > 1)
		*why = "this tsim was built without MPI, so that mpirun would only run the same script "
		       "several times: install libopenmpi-dev and run configure --with-mpi again, or use "
		       "threads (OMP_NUM_THREADS)";
	return NULL;
}

void ts_program_ranks_end(struct ts_world *world)
{
	(void)world;
}

struct ts_world *ts_program_ranks_join(const void *communicator, const char **why)
{
	(void)communicator;
	*why = "this library was built without MPI";
	return NULL;
}

void ts_program_ranks_leave(struct ts_world *world)
{
	(void)world;
}

void ts_program_ranks_fail(struct ts_world *world, const char *message)
{
	(void)world;
	(void)message;
}

void ts_program_ranks_listen(struct ts_world *world, struct ts_log *log)
{
	(void)world;
	(void)log;
}

#else

#define TEXT_OF(word) #word
#define TEXT(number) TEXT_OF(number)

const char *ts_program_ranks_standard(void)
{
	return "MPI " TEXT(MPI_VERSION) "." TEXT(MPI_SUBVERSION);
}

struct mpi {
	struct ts_world base;
	struct ts_program_mpi mpi;
	MPI_Comm all, trouble; /* trouble: messages of ranks that have failed */
	MPI_Request *request;  /* [capacity] */
	size_t capacity;
	unsigned rounds; /* deliveries so far */
	struct ts_waiting waiting;
	struct ts_log *log; /* gets the message that ends all */
};

enum {
	PIECE = 1 << 30, /* bytes of a message: MPI counts with int */
	/* Within a machine Open MPI sends up to 4 KiB at once, and for more waits for the receiver: parcels of SHORT bytes go in
	 * pieces of EAGER. */
	EAGER = 4000,
	SHORT = 1 << 15,
	LOOK = 200,	/* polls between two looks for failures of others */
	MESSAGE = 8192, /* bytes of an error message */
	PATIENCE = 60	/* s until a rank ends all by itself, if the first one does not */
};

static void abort_all(struct mpi *m)
{
	m->mpi.Abort(m->all, EXIT_FAILURE);
	_exit(EXIT_FAILURE);
}

/* On the first rank: prints the message of a rank that has failed, and ends all. */
static void look_for_trouble(struct mpi *m)
{
	char text[MESSAGE] = "";
	MPI_Status status;
	int there = 0, n = 0;

	m->mpi.Iprobe(MPI_ANY_SOURCE, 0, m->trouble, &there, &status);
	if (!there)
		return;
	m->mpi.Get_count(&status, m->mpi.byte, &n);
	m->mpi.Recv(text, n < MESSAGE ? n : MESSAGE, m->mpi.byte, status.MPI_SOURCE, 0, m->trouble,
		    MPI_STATUS_IGNORE);
	text[MESSAGE - 1] = '\0';
	if (m->log)
		ts_log_fatal(m->log, text);
	abort_all(m);
}

/* Between two polls of an operation: the first rank learns of failures, and after a while others get the processor. */
static void go_on_polling(struct mpi *m, int *spin)
{
	if (m->base.rank == 0 && *spin % LOOK == LOOK - 1)
		look_for_trouble(m);
	if (++*spin > m->waiting.polls)
		ts_waiting_offer(&m->waiting, *spin == m->waiting.polls + 1);
}

static void wait_for(struct mpi *m, MPI_Request *request, int n)
{
	int done = 0, spin = 0;

	for (;;) {
		m->mpi.Testall(n, request, &done, MPI_STATUSES_IGNORE);
		if (done)
			return;
		go_on_polling(m, &spin);
	}
}

static void most(struct ts_world *world, double *value, size_t n)
{
	struct mpi *m = (struct mpi *)world;
	MPI_Request request;

	m->mpi.Iallreduce(MPI_IN_PLACE, value, (int)n, m->mpi.real, m->mpi.most, m->all, &request);
	wait_for(m, &request, 1);
}

static void spread(struct ts_world *world, int from, void *bytes, size_t n)
{
	struct mpi *m = (struct mpi *)world;
	char *at = bytes;

	while (n) {
		size_t piece = n < PIECE ? n : PIECE;
		MPI_Request request;

		m->mpi.Ibcast(at, (int)piece, m->mpi.byte, from, m->all, &request);
		wait_for(m, &request, 1);
		at += piece;
		n -= piece;
	}
}

static void sizes(struct ts_world *world, uint64_t n, uint64_t *size)
{
	struct mpi *m = (struct mpi *)world;
	MPI_Request request;

	m->mpi.Iallgather(&n, 1, m->mpi.count, size, 1, m->mpi.count, m->all, &request);
	wait_for(m, &request, 1);
}

/* Where MPI cannot count the bytes with int, they are copied from one rank after the other. */
static void collect_one_by_one(struct ts_world *world, const void *mine, const uint64_t *size,
			       unsigned char *all)
{
	for (int r = 0; r < world->n; all += size[r++]) {
		if (r == world->rank && size[r])
			memcpy(all, mine, size[r]);
		spread(world, r, all, size[r]);
	}
}

static enum ts_status collect(struct ts_world *world, const void *mine, const uint64_t *size,
			      unsigned char *all)
{
	struct mpi *m = (struct mpi *)world;
	int *n = ts_alloc(2 * (size_t)world->n, sizeof *n), *at = n ? n + world->n : NULL;
	uint64_t end = 0;
	MPI_Request request;

	for (int r = 0; r < world->n; r++)
		end += size[r];
	if (n && end > INT_MAX) {
		collect_one_by_one(world, mine, size, all);
	} else if (n) {
		end = 0;
		for (int r = 0; r < world->n; end += size[r++]) {
			n[r] = (int)size[r];
			at[r] = (int)end;
		}
		m->mpi.Iallgatherv(mine, n[world->rank], m->mpi.byte, all, n, at, m->mpi.byte, m->all,
				   &request);
		wait_for(m, &request, 1);
	}
	ts_free(n);
	return at ? TS_OK : TS_NOMEM;
}

static void sum(struct ts_world *world, int64_t *number, size_t n)
{
	struct mpi *m = (struct mpi *)world;
	MPI_Request request;

	m->mpi.Iallreduce(MPI_IN_PLACE, number, (int)n, m->mpi.whole, m->mpi.sum, m->all, &request);
	wait_for(m, &request, 1);
}

static MPI_Request *next_request(struct mpi *m, size_t *n)
{
	if (TS_GROW(m->request, m->capacity, *n + 1) != TS_OK)
		ts_program_ranks_fail(&m->base, "tsim: error: out of memory\n");
	return &m->request[(*n)++];
}

/* The next piece of a parcel of n bytes, of which `at` are under way. */
static int piece_of(size_t n, size_t at)
{
	size_t most = n <= SHORT ? EAGER : PIECE;

	return (int)(n - at < most ? n - at : most);
}

/* Parcels go in pieces, which arrive in the order in which they were sent. */
static void swap(struct ts_world *world, const struct ts_parcel *out, struct ts_parcel *in)
{
	struct mpi *m = (struct mpi *)world;
	size_t n = 0;
	int piece;

	for (int r = 0; r < world->n; r++)
		for (size_t at = 0; r != world->rank && at < in[r].n; at += (size_t)piece) {
			piece = piece_of(in[r].n, at);
			m->mpi.Irecv(in[r].data + at, piece, m->mpi.byte, r, 0, m->all, next_request(m, &n));
		}
	for (int r = 0; r < world->n; r++)
		for (size_t at = 0; r != world->rank && at < out[r].n; at += (size_t)piece) {
			piece = piece_of(out[r].n, at);
			m->mpi.Isend(out[r].data + at, piece, m->mpi.byte, r, 0, m->all, next_request(m, &n));
		}
	wait_for(m, m->request, (int)n);
}

/* Receives a message of this round, if there is one. */
static enum ts_status receive_piece(struct mpi *m, int tag, struct ts_parcel *in)
{
	MPI_Status status;
	unsigned char *to;
	int there = 0, n = 0;

	m->mpi.Iprobe(MPI_ANY_SOURCE, tag, m->all, &there, &status);
	if (!there)
		return TS_OK;
	m->mpi.Get_count(&status, m->mpi.byte, &n);
	to = ts_parcel_extend(&in[status.MPI_SOURCE], (size_t)n);
	if (!to)
		return TS_NOMEM;
	m->mpi.Recv(to, n, m->mpi.byte, status.MPI_SOURCE, tag, m->all, MPI_STATUS_IGNORE);
	return TS_OK;
}

/* T. Hoefler, C. Siebert, A. Lumsdaine, Scalable communication protocols for dynamic sparse data exchange, PPoPP 2010:
 * a rank enters the barrier when all that it has sent is received, so that behind it nothing is under way. The time
 * grows with the partners of a rank and the logarithm of the ranks. A rank may begin the next round while another one
 * still looks for messages of this one: two tags in turn. */
static enum ts_status deliver(struct ts_world *world, const struct ts_parcel *out, struct ts_parcel *in)
{
	struct mpi *m = (struct mpi *)world;
	MPI_Request barrier;
	int tag = 1 + (int)(m->rounds++ % 2), sent = 0, inside = 0, done = 0, spin = 0;
	size_t n = 0;

	for (int r = 0; r < world->n; r++)
		for (size_t at = 0; r != world->rank && at < out[r].n; at += PIECE) {
			size_t piece = out[r].n - at < PIECE ? out[r].n - at : PIECE;

			m->mpi.Issend(out[r].data + at, (int)piece, m->mpi.byte, r, tag, m->all,
				      next_request(m, &n));
		}
	while (!done) {
		if (receive_piece(m, tag, in) != TS_OK)
			return TS_NOMEM;
		if (inside)
			m->mpi.Test(&barrier, &done, MPI_STATUS_IGNORE);
		else
			m->mpi.Testall((int)n, m->request, &sent, MPI_STATUSES_IGNORE);
		if (sent && !inside)
			m->mpi.Ibarrier(m->all, &barrier);
		inside = sent;
		go_on_polling(m, &spin);
	}
	return TS_OK;
}

static const struct ts_world_functions functions = { .most = most,
						     .spread = spread,
						     .sizes = sizes,
						     .collect = collect,
						     .sum = sum,
						     .deliver = deliver,
						     .swap = swap,
						     .fail = ts_program_ranks_fail };

static bool was_started_by_launcher(void)
{
	bool found = getenv("PMIX_RANK") != NULL;

	for (size_t k = 0; k < sizeof numbers / sizeof *numbers; k++)
		found |= getenv(numbers[k]) != NULL;
	return found;
}

static const char not_loaded[] =
	"the library of MPI cannot be loaded: install it (apt-get install libopenmpi3), or use threads "
	"(OMP_NUM_THREADS)";

/* Loads MPI. */
static struct mpi *new_mpi(const char **why)
{
	struct mpi *m = ts_alloc(1, sizeof *m);

	if (m && ts_program_mpi_load(&m->mpi))
		return m;
	*why = m ? not_loaded : "out of memory";
	ts_free(m);
	return NULL;
}

static struct ts_world *join(struct mpi *m, MPI_Comm all)
{
	m->base.call = &functions;
	m->waiting = ts_waiting_policy(getenv("OMP_WAIT_POLICY"));
	m->mpi.Comm_dup(all, &m->all);
	m->base.communicator = &m->all;
	m->mpi.Comm_dup(all, &m->trouble);
	m->mpi.Comm_rank(m->all, &m->base.rank);
	m->mpi.Comm_size(m->all, &m->base.n);
	return &m->base;
}

struct ts_world *ts_program_ranks_begin(int *argc, char ***argv, const char **why)
{
	struct ts_world *world;
	struct mpi *m;
	int given;

	if (!was_started_by_launcher())
		return NULL;
	m = new_mpi(why);
	if (!m)
		return NULL;
	m->mpi.Init_thread(argc, argv, MPI_THREAD_FUNNELED, &given);
	world = join(m, m->mpi.world);
	ts_waiting_be_exact(&m->waiting);
	if (world->n == 1 && started_processes() > 1)
		*why = "mpirun has started several processes, but each of them is alone: tsim was built with "
		       "another MPI than that of this mpirun";
	return world;
}

struct ts_world *ts_program_ranks_join(const void *communicator, const char **why)
{
	struct mpi *m = new_mpi(why);
	int initialised = 0, finalised = 0;

	if (!m)
		return NULL;
	m->mpi.Initialized(&initialised);
	m->mpi.Finalized(&finalised);
	if (initialised && !finalised)
		return join(m, communicator ? *(const MPI_Comm *)communicator : m->mpi.world);
	*why = "MPI is not initialised: call MPI_Init_thread first, or import mpi4py.MPI";
	ts_free(m);
	return NULL;
}

void ts_program_ranks_leave(struct ts_world *world)
{
	struct mpi *m = (struct mpi *)world;
	MPI_Request request;
	int finalised = 0;

	m->mpi.Finalized(&finalised); /* by a program that closes its simulations after that */
	if (!finalised) {
		m->mpi.Ibarrier(m->all, &request);
		wait_for(m, &request, 1);
		m->mpi.Comm_free(&m->all);
		m->mpi.Comm_free(&m->trouble);
	}
	ts_free(m->request);
	ts_free(m);
}

void ts_program_ranks_end(struct ts_world *world)
{
	int (*finalize)(void);

	if (!world)
		return;
	finalize = ((struct mpi *)world)->mpi.Finalize;
	ts_program_ranks_leave(world);
	finalize();
}

void ts_program_ranks_listen(struct ts_world *world, struct ts_log *log)
{
	struct mpi *m = (struct mpi *)world;

	m->log = log;
}

void ts_program_ranks_fail(struct ts_world *world, const char *message)
{
	struct mpi *m = (struct mpi *)world;
	double begin = ts_clock();
	MPI_Request request;
	size_t n = strlen(message) + 1;

	if (world->rank == 0) {
		if (m->log)
			ts_log_fatal(m->log, message);
		abort_all(m);
	}
	m->mpi.Isend(message, (int)(n < MESSAGE ? n : MESSAGE), m->mpi.byte, 0, 0, m->trouble, &request);
	while (ts_clock() - begin < PATIENCE) { /* the first rank ends this one */
		int done;

		m->mpi.Test(&request, &done, MPI_STATUS_IGNORE);
		usleep(1000);
	}
	fputs(message, stderr);
	abort_all(m);
}

#endif
