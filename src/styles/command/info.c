/* Command info: what there is now. */
#include <inttypes.h>

#include "core/group.h"
#include "core/units.h"
#include "neigh/bonds.h"
#include "neigh/neigh.h"
#include "particles/domain.h"
#include "particles/particles.h"

#include "base/banned.h"

struct info {
	struct ts_words words;
};

static void system_now(struct tsim *sim)
{
	static const char letter[] = "pfsm"; /* in the order of enum ts_face */
	const struct ts_box *box = &sim->domain->box;
	const struct ts_particles *p = sim->particles;

	ts_log(&sim->log,
	       "System:\n  units %s, %d dimensions, step %" PRId64 ", time %g, time step %g\n",
	       ts_units_name(sim->units), sim->dimension, sim->clock.step, ts_sim_time(sim),
	       sim->clock.dt);
	if (!ts_sim_has_box(sim)) {
		ts_log(&sim->log, "  no box yet\n");
		return;
	}
	ts_log(&sim->log, "  box (%g %g %g) to (%g %g %g), faces", box->lo[0], box->lo[1],
	       box->lo[2], box->hi[0], box->hi[1], box->hi[2]);
	for (int d = 0; d < 3; d++)
		ts_log(&sim->log, " %c%c", letter[box->face[d][0]], letter[box->face[d][1]]);
	ts_log(&sim->log, "\n  %zu particles of %d types, %zu bonds of %d types, %" PRId64 " lost\n",
	       p->n, p->ntypes, sim->bonds->n, sim->bonds->ntypes, p->lost);
}

static void groups(struct tsim *sim)
{
	const struct ts_particles *p = sim->particles;

	ts_log(&sim->log, "Groups:\n");
	for (int bit = 0; bit < TS_MAX_GROUPS; bit++) {
		size_t count = 0;

		if (!p->group[bit])
			continue;
		for (size_t i = 0; i < p->n; i++)
			count += ts_in_group(p, i, bit);
		ts_log(&sim->log, "  %s, %s, %zu particles\n", p->group[bit],
		       p->dynamic[bit].every ? "dynamic" : "static", count);
	}
}

/* "  fall, gravity, group all, in.script:7" */
static void list(struct tsim *sim, const char *title, enum ts_kind kind)
{
	const struct ts_instances *all = &sim->instances[kind];

	ts_log(&sim->log, "%s:\n", title);
	for (size_t k = 0; k < all->n; k++) {
		const struct ts_instance *inst = all->item[k];

		ts_log(&sim->log, "  %s%s%s", inst->id, *inst->id ? ", " : "", inst->style->name);
		if (kind == TS_KIND_FIX || kind == TS_KIND_COMPUTE || kind == TS_KIND_DUMP)
			ts_log(&sim->log, ", group %s", ts_group_name(sim, inst->group));
		if (inst->where.file && inst->where.line)
			ts_log(&sim->log, ", %s:%d", inst->where.file, inst->where.line);
		ts_log(&sim->log, "\n");
	}
}

static void computes(struct tsim *sim)
{
	list(sim, "Computes", TS_KIND_COMPUTE);
}

static void dumps(struct tsim *sim)
{
	list(sim, "Dumps", TS_KIND_DUMP);
}

static void fixes(struct tsim *sim)
{
	list(sim, "Fixes", TS_KIND_FIX);
}

static void regions(struct tsim *sim)
{
	list(sim, "Regions", TS_KIND_REGION);
}

static void laws(struct tsim *sim)
{
	list(sim, "Pair style", TS_KIND_PAIR);
	list(sim, "Bond style", TS_KIND_BOND);
	list(sim, "Flow style", TS_KIND_FLOW);
}

static void styles(struct tsim *sim)
{
	enum ts_kind kind = TS_NKIND;

	ts_log(&sim->log, "Styles:");
	for (const struct ts_style *const *s = ts_style_table; *s; s++) {
		if ((*s)->kind != kind)
			ts_log(&sim->log, "\n  %s:", ts_kind_name((*s)->kind));
		kind = (*s)->kind;
		ts_log(&sim->log, " %s", (*s)->name);
	}
	ts_log(&sim->log, "\n");
}

static void memory(struct tsim *sim)
{
	const struct ts_particles *p = sim->particles;
	double bytes = 0;

	for (size_t k = 0; k < p->ncolumns; k++)
		if (p->column[k].active)
			bytes += (double)(p->capacity * p->column[k].width * p->column[k].element);
	ts_log(&sim->log, "Memory:\n  particles %.3g Mbytes, contact rows %zu\n", bytes / 1048576,
	       sim->neigh->rows.n);
}

static void communication(struct tsim *sim)
{
	ts_log(&sim->log, "Communication:\n  1 process, %d threads, %zu ghosts, skin %g\n",
	       sim->threads, sim->particles->nghost, sim->neigh->skin);
}

struct subject {
	const char *name;
	void (*print)(struct tsim *sim);
	bool in_all;
};

static const struct subject subjects[] = {
	{ "system", system_now, true },	  { "communication", communication, true },
	{ "memory", memory, true },	  { "groups", groups, true },
	{ "regions", regions, true },	  { "computes", computes, true },
	{ "fixes", fixes, true },	  { "dumps", dumps, true },
	{ "coeffs", laws, true },	  { "styles", styles, false },
};
enum { NSUBJECTS = sizeof subjects / sizeof *subjects };

static enum ts_status print(struct tsim *sim, const struct ts_word *word)
{
	struct ts_suggest suggest = ts_suggest_start(word->text);
	bool all = ts_streq(word->text, "all");
	bool found = all;

	for (int k = 0; k < NSUBJECTS; k++) {
		bool this = ts_streq(word->text, subjects[k].name);

		ts_suggest_try(&suggest, subjects[k].name);
		if (this || (all && subjects[k].in_all))
			subjects[k].print(sim);
		found |= this;
	}
	if (found)
		return TS_OK;
	return ts_fail(&sim->error, TS_UNKNOWN, &word->place, "info: unknown subject '%s'%s",
		       word->text, ts_suggest_text(&suggest));
}

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct info *c = state;

	(void)where;
	for (size_t k = 0; k < c->words.n; k++)
		TS_TRY(print(sim, &c->words.word[k]));
	return TS_OK;
}

static const struct ts_arg args[] = {
	TS_REST("subjects", struct info, words,
		.help = "all, or system, communication, memory, groups, regions, computes, fixes, dumps, "
			"coeffs, styles"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_info)
const struct ts_command_style ts_command_info = {
	.style = {
		.name = "info",
		.kind = TS_KIND_COMMAND,
		.summary = "Says what there is now",
		.doc = "Prints the present state in the log: box and particles, the names of groups, regions, computes,\n"
		       "fixes and dumps with the lines that made them, the pair and bond styles. all leaves out styles,\n"
		       "the list of everything a script can name.",
		.example = "info system groups\ninfo all",
		.args = args,
		.state_size = sizeof(struct info),
	},
	.run = run,
};
