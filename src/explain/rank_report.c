#include "explain/rank_report.h"

#include <math.h>

#include "core/ranks.h"
#include "explain/price.h"
#include "neigh/neigh.h"
#include "particle/copies.h"
#include "particle/rank_layout.h"
#include "rank/world.h"

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
enum {
	PARTICLES,
	COPIES,
	PAIRS,
	SHARED,
	MESSAGES,
	BYTES,
	MESSAGES_OF_ITERATION, /* besides, of the solver for the pressure of a fluid: one in each solve of a step */
	BYTES_OF_ITERATION,
	SECONDS,
	NFACTS
};

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

/* What a style sends besides: of each rank with `looks` iterations of its solver, then with twice as many. */
struct rehearsed {
	struct ts_world_counts *sent; /* [2 ranks]. Owned */
	int64_t steps;
	int looks;
};

static enum ts_status rehearse(struct tsim *sim, const struct ts_report_rehearsal *rehearsal,
			       const struct ts_rank_layout *layout, struct rehearsed *out)
{
	const size_t ranks = (size_t)layout->ranks;

	*out = (struct rehearsed){ ts_alloc(2 * ranks, sizeof *out->sent), rehearsal->steps,
				   rehearsal->looks };
	if (!out->sent)
		return ts_nomem(&sim->error);
	if (rehearsal->count)
		TS_TRY(rehearsal->count(rehearsal->self, sim, layout, out->looks, out->sent));
	return out->looks ? rehearsal->count(rehearsal->self, sim, layout, 2 * out->looks, out->sent + ranks)
			  : TS_OK;
}

/* Adds what rank r sends in a step without iterations, and sets what it sends in an iteration. */
static void add_rehearsed(const struct rehearsed *rehearsed, int ranks, int r, double *of)
{
	const struct ts_world_counts *once = &rehearsed->sent[r], *twice = once + ranks;
	const double steps = rehearsed->steps ? (double)rehearsed->steps : 1;
	double messages = (double)once->messages, bytes = (double)once->bytes;

	if (rehearsed->looks) {
		of[MESSAGES_OF_ITERATION] = (double)(twice->messages - once->messages) / rehearsed->looks;
		of[BYTES_OF_ITERATION] = (double)(twice->bytes - once->bytes) / rehearsed->looks;
		messages -= (double)(twice->messages - once->messages);
		bytes -= (double)(twice->bytes - once->bytes);
	}
	of[MESSAGES] += messages / steps;
	of[BYTES] += bytes / steps;
}

static void find_facts(const struct tsim *sim, const struct ts_plan_report *report,
		       const struct ts_rank_layout *layout, const struct rehearsed *rehearsed,
		       const struct pairs *pairs, size_t all_pairs, double seconds, struct facts *facts)
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
		add_rehearsed(rehearsed, layout->ranks, r, of);
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
		{ "particles", PARTICLES },
		{ "copies of others'", COPIES },
		{ "candidate pairs", PAIRS },
		{ "of them on two ranks", SHARED },
		{ "messages sent a step", MESSAGES },
		{ "bytes sent a step", BYTES },
		{ "messages an iteration", MESSAGES_OF_ITERATION },
		{ "bytes an iteration", BYTES_OF_ITERATION },
	};
	const size_t nrows = sizeof rows / sizeof *rows - (facts->most[MESSAGES_OF_ITERATION] > 0 ? 0 : 2);

	ts_log(&sim->log, "%d ranks, ", layout->ranks);
	if (layout->blocks.bisection)
		ts_log(&sim->log, "blocks of a recursive bisection");
	else
		ts_log(&sim->log, "%d x %d x %d blocks", layout->blocks.count[0], layout->blocks.count[1],
		       layout->blocks.count[2]);
	ts_log(&sim->log, ", now:\n  %-22s %12s %12s %12s\n", "of a rank", "first", "mean", "most");
	for (size_t k = 0; k < nrows; k++)
		ts_log(&sim->log, "  %-22s %12.10g %12.1f %12.10g\n", rows[k].name,
		       facts->first[rows[k].fact], facts->mean[rows[k].fact], facts->most[rows[k].fact]);
}

static void print_cost(struct tsim *sim, const struct ts_plan_report *report,
		       const struct ts_rank_layout *layout, const struct facts *facts, double seconds)
{
	double agreement = 2 * LATENCY * ceil(log2(layout->ranks)), step = facts->most[SECONDS] + agreement,
	       share = (facts->most[PARTICLES] + facts->most[COPIES]) / fmax((double)sim->particles->n, 1);
	double own, columns = (double)(ts_copies_row_bytes(sim->particles) * sim->particles->n);
	struct ts_str text = { 0 };

	share = fmin(share, 1);
	own = report->whole + share * (report->bytes - report->whole - report->elsewhere);
	ts_str_add(&text, "  all ranks agree once a step, some times more in a rebuild and at outputs\n  "
			  "memory of a rank about ");
	ts_price_bytes(own, &text);
	ts_str_add(&text, " in steps, ");
	ts_price_bytes(own + (1 - share) * columns, &text);
	ts_str_add(&text, " in set-up and at outputs of particles,\n  ");
	ts_price_bytes(report->bytes, &text);
	ts_str_add(&text, " at outputs of contacts, in set-up with bonds or clumps to insert, and before "
			  "another command\n");
	if (report->whole > 0)
		ts_str_add(&text, report->divides_grid
					  ? "  every rank has some planes of the grid of the fluid\n"
					  : "  every rank has the whole grid of the fluid or automaton\n");
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

static enum ts_status report_divided(struct tsim *sim, const struct ts_plan_report *report, double seconds)
{
	int ranks = ts_ranks(sim);
	struct pairs *pairs = ts_alloc((size_t)ranks, sizeof *pairs);
	struct ts_rank_layout layout = { .ranks = ranks };
	struct rehearsed rehearsed = { 0 };
	enum ts_status status = pairs ? TS_OK : ts_nomem(&sim->error);

	if (status == TS_OK)
		status = ts_rank_layout_make(sim, ranks, sim->neigh->copy_reach, &layout);
	if (status == TS_OK)
		status = rehearse(sim, &report->rehearsal, &layout, &rehearsed);
	if (status == TS_OK) {
		size_t all = count_pairs(sim, &layout, pairs);
		struct facts facts;

		find_facts(sim, report, &layout, &rehearsed, pairs, all, seconds, &facts);
		print_facts(sim, &layout, &facts);
		print_cost(sim, report, &layout, &facts, seconds);
	}
	ts_free(rehearsed.sent);
	ts_rank_layout_release(&layout);
	ts_free(pairs);
	return status;
}

enum ts_status ts_rank_report(struct tsim *sim, const struct ts_plan_report *report, double seconds)
{
	if (!sim->run.undivided)
		return report_divided(sim, report, seconds);
	ts_log(&sim->log,
	       "%d ranks: each does all steps with all particles, in the time and the memory of one\n",
	       ts_ranks(sim));
	return TS_OK;
}
