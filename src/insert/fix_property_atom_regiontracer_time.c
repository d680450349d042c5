/* Fix property/atom/regiontracer/time: residence times of particles in regions. */
#include "math/exactsum.h"
#include "particle/columns.h"
#include "particle/particles.h"
#include "region/region.h"

#include "base/banned.h"

/* The regions that contain a particle at the last check are bits of a whole number in a double. */
enum { MOST_REGIONS = 53 };

struct state {
	struct ts_words region_words;
	int64_t every;

	struct ts_instance *region[MOST_REGIONS];
	size_t width;	 /* numbers in the column of times: for the box, then for each region */
	size_t time, in; /* indices of the columns: times; bits of the regions */
	bool started;
};

static double *residence_times(const struct state *s, const struct tsim *sim, size_t i)
{
	return (double *)sim->particles->column[s->time].data + i * s->width;
}

static double *region_bits(const struct state *s, const struct tsim *sim, size_t i)
{
	return (double *)sim->particles->column[s->in].data + i;
}

static enum ts_status add_column(struct ts_instance *self, struct tsim *sim, const char *what, size_t width,
				 size_t *column)
{
	struct ts_str name = { 0 };
	enum ts_status status;

	ts_str_addf(&name, "%s %s %s %zu", self->style->name, what, self->id, width);
	status = ts_particles_add_column(sim, ts_str_text(&name), width, TS_COL_RESULT, column);
	ts_str_release(&name);
	return status;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	if (s->region_words.n > MOST_REGIONS)
		return ts_fail(&sim->error, TS_RANGE, &s->region_words.word[MOST_REGIONS].place,
			       "fix property/atom/regiontracer/time: at most %d regions", MOST_REGIONS);
	for (size_t k = 0; k < s->region_words.n; k++)
		TS_TRY(ts_sim_require(sim, TS_KIND_REGION, &s->region_words.word[k], &s->region[k]));
	s->width = 1 + s->region_words.n;
	TS_TRY(add_column(self, sim, "times", s->width, &s->time));
	TS_TRY(add_column(self, sim, "inside", 1, &s->in));
	/* a former fix of this name may have left its columns */
	for (size_t i = 0; !s->started && i < sim->particles->n; i++) {
		*region_bits(s, sim, i) = 0;
		for (size_t k = 0; k < s->width; k++)
			residence_times(s, sim, i)[k] = 0;
	}
	s->started = true;
	return TS_OK;
}

static enum ts_status update_regions(struct ts_instance *self, struct tsim *sim)
{
	const struct state *s = self->state;
	const struct ts_particles *p = sim->particles;

	for (size_t k = 0; k < s->region_words.n; k++)
		TS_TRY(ts_region_update(s->region[k], sim));
	for (size_t i = 0; i < p->n; i++) {
		uint64_t in = 0;

		for (size_t k = 0; k < s->region_words.n; k++)
			in |= (uint64_t)ts_region_contains(s->region[k], p->x[i]) << k;
		*region_bits(s, sim, i) = (double)in;
	}
	return TS_OK;
}

static enum ts_status end_of_step(struct ts_instance *self, struct tsim *sim)
{
	const struct state *s = self->state;
	const struct ts_particles *p = sim->particles;

	if (sim->clock.step % s->every == 0)
		TS_TRY(update_regions(self, sim));
	for (size_t i = 0; i < p->n; i++) {
		uint64_t in = (uint64_t)*region_bits(s, sim, i);

		if (!ts_in_group(p, i, self->group))
			continue;
		residence_times(s, sim, i)[0] += sim->clock.dt;
		for (size_t k = 1; k < s->width; k++, in >>= 1)
			if (in & 1)
				residence_times(s, sim, i)[k] += sim->clock.dt;
	}
	return TS_OK;
}

/* ---- outputs ---- */

static enum ts_status eval_times(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct state *s = self->state;

	TS_TRY(ts_table_resize(out, sim->particles->n, s->width));
	for (size_t i = 0; i < out->rows; i++)
		for (size_t k = 0; k < s->width; k++)
			out->data[i * s->width + k] = residence_times(s, sim, i)[k];
	return TS_OK;
}

static enum ts_status eval_means(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct state *s = self->state;
	size_t n = sim->particles->n;

	TS_TRY(ts_table_resize(out, s->width, 1));
	for (size_t k = 0; k < s->width; k++)
		out->data[k] =
			n ? ts_exactsum_of(residence_times(s, sim, 0) + k, n, s->width) / (double)n : 0;
	return TS_OK;
}

static enum ts_status archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a)
{
	const struct state *s = self->state;

	TS_TRY(ts_particles_archive_column(a, sim, "times", s->time));
	return ts_particles_archive_column(a, sim, "inside", s->in);
}

static const struct ts_arg args[] = {
	TS_LIST_KEYWORD("add_region", struct state, region_words,
			.flags = TS_TO_KEYWORD | TS_OPTIONAL | TS_REPEAT | TS_STATEFUL,
			.help = "a region; may be repeated"),
	TS_INT("check_region_every", struct state, every, .fallback = "10", .range = TS_POSITIVE,
	       .help = "regions are checked in steps that are multiples of this number"),
	TS_ARGS_END,
};

static const struct ts_value values[] = {
	{ "times", "time", "per particle: time in the box, then in each region", TS_PERATOM, 0, NULL,
	  eval_times },
	{ "means", "time", "means of these times over all particles", TS_VECTOR, 0, NULL, eval_means },
	{ .name = NULL },
};

TS_STYLE(fix, ts_style, ts_fix_property_atom_regiontracer_time)
const struct ts_style ts_fix_property_atom_regiontracer_time = {
	.name = "property/atom/regiontracer/time",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_OWN | TS_RANKS_OUTPUTS,
	.summary = "Residence times of particles in the box and in regions",
	.doc = "In each step dt is added to the time in the box of each particle of the group, and to the "
	       "time in the regions that contained its center at the last check. Particles that are inserted "
	       "later start at 0.\n\n"
	       "f_ID of a particle, or f_ID[1], f_ID[2] ... with regions, are the times in the box and in "
	       "the regions in the given order. f_ID[k] as a vector are the means over all particles, "
	       "including those outside the group, whose times are 0.",
	.example = "fix stay all property/atom/regiontracer/time add_region mixer add_region chute "
		   "check_region_every 5\n"
		   "thermo_style custom step f_stay[1] f_stay[2]",
	.args = args,
	.state_size = sizeof(struct state),
	.archive = archive,
	.values = values,
	.init = init,
	.hook = { [TS_STAGE_END_OF_STEP] = end_of_step },
};
