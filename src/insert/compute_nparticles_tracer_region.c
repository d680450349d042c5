/* Compute nparticles/tracer/region: counts marked particles in a region. */
#include "base/axes.h"
#include "box/domain.h"
#include "insert/tracer.h"
#include "math/exactsum.h"
#include "particle/group_moments.h"
#include "region/region.h"

#include "base/banned.h"

enum { NUMBER, MARKED, MASS, MARKED_MASS, NVALUES };

struct state {
	/* arguments */
	struct ts_instance *region;
	const char *tracer_id;
	struct ts_words periodic;
	bool reset;

	struct tsim *sim;
	struct ts_tracer *tracer;
	int dim; /* dimension in which only particles with this image flag count; -1: all count */
	int64_t image;
	/* saved: results, the same for all evaluations in a step */
	double answer[NVALUES];
	int64_t answered; /* their step + 1 */
};

/* Reads x|y|z IMAGE; the last of several is used. */
static enum ts_status read_periodic(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	size_t n = s->periodic.n;
	const struct ts_word *dim = n > 1 ? &s->periodic.word[n - 2] : s->periodic.word;

	s->dim = -1;
	if (!n)
		return TS_OK;
	for (int k = 0; k < 3; k++)
		if (ts_streq(dim->text, ts_axis_names[k]))
			s->dim = k;
	if (n % 2 || s->dim < 0)
		return ts_fail(&sim->error, TS_SYNTAX, &dim->place,
			       "compute nparticles/tracer/region: expected periodic x|y|z IMAGE");
	if (!ts_box_periodic(&sim->domain->box, s->dim))
		return ts_fail(&sim->error, TS_STATE, &dim->place,
			       "compute nparticles/tracer/region: the box is not periodic in %s", dim->text);
	if (ts_streq(dim[1].text, "all"))
		s->dim = -1;
	else if (!ts_parse_int(dim[1].text, &s->image))
		return ts_fail(&sim->error, TS_SYNTAX, &dim[1].place,
			       "compute nparticles/tracer/region: found '%s', expected a whole number or all",
			       dim[1].text);
	return TS_OK;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	struct ts_word tracer = { .text = s->tracer_id, .place = *ts_instance_word(self, s->tracer_id) };

	s->sim = sim;
	TS_TRY(read_periodic(self, sim));
	return ts_tracer_require(sim, &tracer, &s->tracer);
}

static bool is_counted(const struct ts_instance *self, const struct tsim *sim, size_t i)
{
	const struct state *s = self->state;
	int32_t image[3];
	double x[3];

	ts_wrapped(sim, i, x, image);
	return ts_in_group(sim->particles, i, self->group) && (s->dim < 0 || image[s->dim] == s->image) &&
	       ts_region_contains(s->region, x);
}

static void count_particles(struct ts_instance *self, const struct tsim *sim, double result[NVALUES])
{
	struct state *s = self->state;
	const struct ts_particles *p = sim->particles;
	double *mark = ts_tracer_marks(sim, s->tracer);
	struct ts_exactsum mass = ts_exactsum_start(), marked = ts_exactsum_start();

	result[NUMBER] = result[MARKED] = 0;
	for (size_t i = 0; i < p->n; i++) {
		if (!is_counted(self, sim, i))
			continue;
		result[NUMBER]++;
		ts_exactsum_add(&mass, p->mass[i]);
		if (mark[i] == 0)
			continue;
		result[MARKED]++;
		ts_exactsum_add(&marked, p->mass[i]);
		if (s->reset && !sim->reading.probing)
			mark[i] = 0;
	}
	result[MASS] = ts_exactsum_value(&mass);
	result[MARKED_MASS] = ts_exactsum_value(&marked);
}

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	struct state *s = self->state;

	if (sim->run.inside && s->answered == sim->clock.step + 1) {
		for (int k = 0; k < NVALUES; k++)
			out->data[k] = s->answer[k];
		return TS_OK;
	}
	TS_TRY(ts_region_update(s->region, s->sim));
	count_particles(self, sim, out->data);
	for (int k = 0; !sim->reading.probing && k < NVALUES; k++)
		s->answer[k] = out->data[k];
	if (!sim->reading.probing)
		s->answered = sim->clock.step + 1;
	return TS_OK;
}

static const struct ts_arg args[] = {
	TS_REGION("region_count", struct state, region, .help = "region in which particles are counted"),
	TS_WORD("tracer", struct state, tracer_id,
		.help = "ID of the fix property/atom/tracer or property/atom/tracer/stream that marks "
			"particles"),
	TS_SOME_KEYWORD("periodic", struct state, periodic, TS_REPEAT,
			.help = "x|y|z IMAGE: count only particles with this image flag (net number of "
				"crossings of the periodic faces); all: no restriction; the last of several "
				"is used"),
	TS_BOOL("reset_marker", struct state, reset, .fallback = "yes",
		.help = "remove the mark of particles that have been counted"),
	TS_ARGS_END,
};

static const char *const names[] = { "number", "marked", "mass", "marked_mass" };
static const struct ts_value values[] = {
	{ "particles", "1, 1, mass, mass",
	  "number of particles in the region, number of marked ones, masses of both", TS_VECTOR, NVALUES,
	  names, eval },
	{ .name = NULL },
};

static const struct ts_saved saved[] = {
	TS_SAVE_F64(struct state, answer),
	TS_SAVE_I64(struct state, answered),
	TS_SAVED_ROWS_END,
};

TS_STYLE(compute, ts_style, ts_compute_nparticles_tracer_region)
const struct ts_style ts_compute_nparticles_tracer_region = {
	.name = "nparticles/tracer/region",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE,
	.summary = "Counts particles, and particles marked by a tracer, in a region",
	.doc = "c_ID[1] and c_ID[2] are the number of particles of the group in the region and the number of "
	       "marked ones among them; c_ID[3] and c_ID[4] are the masses of both.\n\n"
	       "With reset_marker yes a marked particle is counted once: the evaluation of the compute "
	       "removes its mark. All evaluations in one step give the same values. Lines of the thermo "
	       "table that are printed only because a run begins or ends do not remove marks.\n\n"
	       "LIGGGHTS 3.8 counts nothing with `periodic ... all`; here `all` means no restriction.",
	.example = "compute passed all nparticles/tracer/region region_count outlet tracer tr periodic z -1\n"
		   "fix times all ave/time 100 1 100 c_passed[2] file post/residence.txt",
	.args = args,
	.state_size = sizeof(struct state),
	.saved = saved,
	.values = values,
	.init = init,
};
