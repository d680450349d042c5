#include "explain/rank_report.h"

#include <math.h>

#include "core/ranks.h"
#include "explain/price.h"
#include "neigh/neigh.h"
#include "particle/copies.h"
#include "particle/rank_layout.h"

#include "base/banned.h"

/* A network with the latency and bandwidth that MPI has over 100 Gbit/s InfiniBand: seconds of a message between two
 * processes, bytes per second. */
static const double LATENCY = 1.5e-6, BANDWIDTH = 12e9;
/* Of the time of a step of one rank the part that is in proportion to its contacts; the rest is to its particles. What
 * a copy costs, by what a particle costs beside its contacts. Measured: doc/scaling.md. */
static const double OF_CONTACTS = 0.6, OF_COPY = 0.5;

/* Candidate pairs that a rank computes, and those of them that another one computes, too, because it has one of the particles. */
struct pairs {
	size_t n, shared;
};

/* Counts pairs by rank; returns those of one rank that has all particles. */
static size_t count_pairs(const struct tsim *sim, const struct ts_rank_layout *layout, struct pairs *pairs)
{
	const struct ts_contact_list *list = &sim->neigh->contacts;
	const struct ts_particles *p = sim->particles;
	size_t n = sim->neigh->wanted ? list->n : 0;

	for (size_t k = 0; k < n; k++) {
		bool image = (size_t)list->j[k] >= p->n; /* listed again with the other particle as i */
		int32_t a = layout->owner[list->i[k]], b = image ? a : layout->owner[list->j[k]];

		pairs[a].n++;
		pairs[b].n += a != b;
		pairs[a].shared += a != b;
		pairs[b].shared += a != b;
	}
	return n;
}

/* The numbers of a rank that are printed, and the time of its step. */
enum { PARTICLES, COPIES, PAIRS, SHARED, MESSAGES, BYTES, SECONDS, NFACTS };

struct facts {
	double first[NFACTS], mean[NFACTS], most[NFACTS];
};

static void add_facts(struct facts *facts, const double *of, int rank, int ranks)
{
	for (int k = 0; k < NFACTS; k++) {
		if (rank == 0)
			facts->first[k] = of[k];
		facts->mean[k] += of[k] / ranks;
		facts->most[k] = fmax(facts->most[k], of[k]);
	}
}

static void find_facts(const struct tsim *sim, const struct ts_plan_report *report,
		       const struct ts_rank_layout *layout, const struct pairs *pairs, size_t all_pairs,
		       double seconds, struct facts *facts)
{
	double bytes = (double)ts_copies_step_bytes(sim->particles), n = (double)sim->particles->n,
	       contacts = all_pairs ? OF_CONTACTS : 0;

	*facts = (struct facts){ .first = { 0 } };
	for (int r = 0; r < layout->ranks; r++) {
		const struct ts_rank_part *part = &layout->part[r];
		double of[NFACTS] = { [PARTICLES] = (double)part->particles,
				      [COPIES] = (double)part->copies,
				      [PAIRS] = (double)pairs[r].n,
				      [SHARED] = (double)pairs[r].shared,
				      [MESSAGES] = (double)part->partners * (1 + report->copied.messages) +
						   report->shared.messages,
				      [BYTES] = (bytes + report->copied.bytes) * (double)part->sent +
						report->shared.bytes * (double)part->particles };
		double work = (1 - contacts) * (of[PARTICLES] + OF_COPY * of[COPIES]) / fmax(n, 1);

		if (all_pairs)
			work += contacts * of[PAIRS] / (double)all_pairs;
		of[SECONDS] = seconds * work + LATENCY * of[MESSAGES] + of[BYTES] / BANDWIDTH;
		add_facts(facts, of, r, layout->ranks);
	}
}

static void print_facts(struct tsim *sim, const struct ts_rank_layout *layout, const struct facts *facts)
{
	static const struct {
		const char *name;
		int fact;
	} rows[] = {
		{ "particles", PARTICLES },	      { "copies of others'", COPIES },
		{ "candidate pairs", PAIRS },	      { "of them on two ranks", SHARED },
		{ "messages sent a step", MESSAGES }, { "bytes sent a step", BYTES },
	};

	ts_log(&sim->log, "%d ranks, ", layout->ranks);
	if (layout->bisected)
		ts_log(&sim->log, "blocks of a recursive bisection");
	else
		ts_log(&sim->log, "%d x %d x %d blocks", layout->count[0], layout->count[1],
		       layout->count[2]);
	ts_log(&sim->log, ", now:\n  %-22s %12s %12s %12s\n", "of a rank", "first", "mean", "most");
	for (size_t k = 0; k < sizeof rows / sizeof *rows; k++)
		ts_log(&sim->log, "  %-22s %12.0f %12.1f %12.0f\n", rows[k].name, facts->first[rows[k].fact],
		       facts->mean[rows[k].fact], facts->most[rows[k].fact]);
}

static void print_cost(struct tsim *sim, const struct ts_plan_report *report,
		       const struct ts_rank_layout *layout, const struct facts *facts, double seconds)
{
	double agreement = 2 * LATENCY * ceil(log2(layout->ranks)), step = facts->most[SECONDS] + agreement,
	       share = (facts->most[PARTICLES] + facts->most[COPIES]) / fmax((double)sim->particles->n, 1);
	double own, columns = (double)(ts_copies_row_bytes(sim->particles) * sim->particles->n);
	struct ts_str text = { 0 };

	share = fmin(share, 1);
	own = report->whole + share * (report->bytes - report->whole);
	ts_str_add(&text, "  all ranks agree once a step, some times more in a rebuild and at outputs\n  "
			  "memory of a rank about ");
	ts_price_bytes(own, &text);
	ts_str_add(&text, " in steps, ");
	ts_price_bytes(own + (1 - share) * columns, &text);
	ts_str_add(&text, " in set-up and at outputs of particles,\n  ");
	ts_price_bytes(report->bytes, &text);
	ts_str_add(&text, " at outputs of contacts, in set-up with bonds, a fluid or insertions, and before "
			  "another command\n");
	if (report->whole > 0)
		ts_str_add(&text,
			   "  every rank has the whole grid of the fluid or automaton; messages by which "
			   "ranks divide a fluid's steps are not counted\n");
	else if (isfinite(seconds)) {
		ts_str_add(&text, "  time per step about ");
		ts_price_time(step, &text);
		ts_str_addf(&text,
			    ": %.3g times as fast as one rank, efficiency %.2g, without rebuilds and outputs",
			    seconds / step, seconds / step / layout->ranks);
		ts_str_addf(&text,
			    "\n  (each rank on a core like this one; network: %g us a message, %g GB/s)\n",
			    LATENCY * 1e6, BANDWIDTH / 1e9);
	}
	ts_log(&sim->log, "%s", ts_str_text(&text));
	ts_str_release(&text);
}

enum ts_status ts_rank_report(struct tsim *sim, const struct ts_plan_report *report, double seconds)
{
	int ranks = ts_ranks(sim);
	struct pairs *pairs = ts_alloc((size_t)ranks, sizeof *pairs);
	struct ts_rank_layout layout = { .ranks = ranks };
	enum ts_status status = pairs ? TS_OK : ts_nomem(&sim->error);

	if (status == TS_OK)
		status = ts_rank_layout_make(sim, ranks, sim->neigh->copy_reach, &layout);
	if (status == TS_OK) {
		size_t all = count_pairs(sim, &layout, pairs);
		struct facts facts;

		find_facts(sim, report, &layout, pairs, all, seconds, &facts);
		print_facts(sim, &layout, &facts);
		print_cost(sim, report, &layout, &facts, seconds);
	}
	ts_rank_layout_release(&layout);
	ts_free(pairs);
	return status;
}
