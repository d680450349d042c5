/* -sweep and -calibrate on the command line. */
#include <math.h>
#include <stdlib.h>

#include "program/program.h"
#include "study/study.h"

#include "base/banned.h"

static struct ts_words words_of(const struct ts_word_list *list)
{
	return (struct ts_words){ list->word, list->n };
}

/* Options that say what the runs of a study cannot do, or what only one run can. */
static int refuse_conflicts(const struct tsim *sim, const struct ts_setup *setup)
{
	const char *name = setup->sweep.n ? "-sweep" : "-calibrate";
	const char *other = setup->sweep.n && setup->calibrate.n		? "-calibrate"
			    : setup->sweep.n && setup->vary.n			? "-vary"
			    : setup->sweep.n && setup->tolerance > 0		? "-tolerance"
			    : setup->check					? "-check"
			    : setup->explain					? "-explain"
			    : setup->advised					? "-advise"
			    : setup->crosscheck.n				? "-crosscheck"
			    : setup->sandboxed					? "-sandbox"
			    : sim->full						? "-full"
			    : setup->screen					? "-screen"
			    : sim->requests.restart_file			? "-restart-on-signal"
			    : setup->log_given && !ts_streq(setup->log, "none") ? "-log FILE"
										: NULL;

	return other ? ts_program_usage_error("%s and %s cannot be given together", name, other) : 0;
}

int ts_program_study(struct tsim *sim, struct ts_setup *setup, const char *called)
{
	const struct ts_study_input input = { .scripts = words_of(&setup->inputs),
					      .sweep = words_of(&setup->sweep),
					      .calibrate = words_of(&setup->calibrate),
					      .vary = words_of(&setup->vary),
					      .replicate = words_of(&setup->replicate),
					      .vars = words_of(&setup->variables),
					      .own = words_of(&setup->own),
					      .called = called,
					      .results = setup->results,
					      .tolerance = setup->tolerance > 0 ? setup->tolerance : NAN,
					      .jobs = (int)setup->jobs,
					      .no_log = setup->log_given };
	int status = refuse_conflicts(sim, setup);

	if (status)
		return status;
	sim->log.screen = stdout;
	return setup->sweep.n ? ts_study_sweep(sim, &input) : ts_study_calibrate(sim, &input);
}
