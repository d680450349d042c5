/* Global state of the simulation: box, clock, settings, live styles. */
#include "library/library.h"

#include "box/domain.h"
#include "core/ranks.h"
#include "manual/help.h"
#include "particle/particles.h"

#include "base/banned.h"

void tsim_box(struct tsim *sim, struct tsim_box *out)
{
	static const char letter[] = { [TS_FACE_PERIODIC] = 'p',
				       [TS_FACE_FIXED] = 'f',
				       [TS_FACE_SHRINK] = 's',
				       [TS_FACE_MINIMUM] = 'm' };
	const struct ts_box *box = sim ? &sim->domain->box : NULL;
	struct tsim_box full = { 0 };

	if (!sim || !out) {
		ts_library_null(sim, __func__, "out");
		return;
	}
	full.exists = ts_sim_has_box(sim);
	full.dimension = sim->dimension;
	for (int d = 0; d < 3; d++) {
		full.lo[d] = box->lo[d];
		full.hi[d] = box->hi[d];
		full.periodic[d] = ts_box_periodic(box, d);
		for (int side = 0; side < 2; side++)
			full.face[d][side] = letter[box->face[d][side]];
	}
	ts_library_copy_struct(out, &full, sizeof full);
}

void tsim_clock(struct tsim *sim, int64_t *step, double *time, double *dt)
{
	if (step)
		*step = sim ? sim->clock.step : 0;
	if (time)
		*time = sim ? ts_sim_time(sim) : 0;
	if (dt)
		*dt = sim ? sim->clock.dt : 0;
}

typedef double setting_fn(const struct tsim *sim);

static double dimension(const struct tsim *sim)
{
	return sim->dimension;
}

static double box_exists(const struct tsim *sim)
{
	return ts_sim_has_box(sim);
}

static double particles(const struct tsim *sim)
{
	return (double)sim->particles->n;
}

static double ghosts(const struct tsim *sim)
{
	return (double)sim->particles->nghost;
}

static double types(const struct tsim *sim)
{
	return sim->particles->ntypes;
}

static double largest_id(const struct tsim *sim)
{
	return sim->particles->max_tag;
}

static double lost(const struct tsim *sim)
{
	return (double)sim->particles->lost;
}

static double groups(const struct tsim *sim)
{
	int n = 0;

	for (int bit = 0; bit < TS_MAX_GROUPS; bit++)
		n += ts_group_name(sim, bit) != NULL;
	return n;
}

static double step(const struct tsim *sim)
{
	return (double)sim->clock.step;
}

static double dt(const struct tsim *sim)
{
	return sim->clock.dt;
}

static double threads(const struct tsim *sim)
{
	return sim->threads;
}

static double rank(const struct tsim *sim)
{
	return sim->world ? sim->world->rank : 0;
}

static double divided(const struct tsim *sim)
{
	return sim->division != NULL;
}

static double ranks(const struct tsim *sim)
{
	return ts_ranks(sim);
}

static double running(const struct tsim *sim)
{
	return sim->run.inside;
}

static double halted(const struct tsim *sim)
{
	return sim->run.halted;
}

static double warnings(const struct tsim *sim)
{
	return sim->log.warnings;
}

static const struct {
	const char *name, *help;
	setting_fn *value;
} settings[] = {
	{ "box_exist", "1 after create_box or read_restart", box_exists },
	{ "dimension", "2 or 3", dimension },
	{ "divided", "1 in a step in which each rank has its own particles only", divided },
	{ "dt", "time step", dt },
	{ "halted", "1 after fix halt has ended a run: later runs do nothing", halted },
	{ "nghost", "ghost particles: periodic images", ghosts },
	{ "ngroups", "groups, including `all`", groups },
	{ "nlocal", "particles", particles },
	{ "nlost", "particles lost through fixed faces so far", lost },
	{ "ntypes", "particle types, as given by create_box", types },
	{ "nwarnings", "warnings so far", warnings },
	{ "rank", "number of this rank, from 0", rank },
	{ "ranks", "number of ranks", ranks },
	{ "running", "1 inside a step", running },
	{ "step", "the step counter", step },
	{ "tag_max", "largest identity assigned so far", largest_id },
	{ "threads", "number of threads", threads },
};
enum { NSETTINGS = sizeof settings / sizeof *settings };

const char *tsim_setting_name(size_t k, const char **help)
{
	if (k >= NSETTINGS)
		return NULL;
	if (help)
		*help = settings[k].help;
	return settings[k].name;
}

int tsim_setting(struct tsim *sim, const char *name, double *out)
{
	TS_LIBRARY_NEEDS(sim, sim);
	TS_LIBRARY_NEEDS(sim, name);
	TS_LIBRARY_NEEDS(sim, out);

	struct ts_suggest suggest = ts_suggest_start(name);

	for (int k = 0; k < NSETTINGS; k++) {
		if (ts_streq(settings[k].name, name)) {
			*out = settings[k].value(sim);
			return TSIM_OK;
		}
		ts_suggest_try(&suggest, settings[k].name);
	}
	return (int)ts_fail(&sim->error, TS_UNKNOWN, NULL, "there is no setting '%s'%s", name,
			    ts_suggest_text(&suggest));
}

const char *tsim_live(struct tsim *sim, const char *kind, size_t k, const char **style)
{
	const struct ts_instances *list;
	enum ts_kind number;

	if (!sim || !kind || !ts_kind_find(kind, &number) || number == TS_KIND_SYSTEM)
		return NULL;
	list = &sim->instances[number];
	if (k >= list->n)
		return NULL;
	if (style)
		*style = list->item[k]->style->name;
	return list->item[k]->id;
}
