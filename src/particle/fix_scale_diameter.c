/* Fix scale/diameter: scales diameters by the distance from the centre of a region. */
#include <math.h>

#include "core/sim.h"
#include "particle/columns.h"
#include "particle/first_size.h"
#include "particle/particles.h"
#include "particle/sphere_shape.h"
#include "region/region.h"
#include "rigid/rigid_change.h"

#include "base/banned.h"

struct state {
	int64_t every;
	struct ts_instance *region;
	struct ts_number scale;
	double width;
	size_t column; /* of the original sizes: particle/first_size.h */
	bool begun;
	/* saved; a new epoch changes the fingerprint, so that forces are computed again */
	int64_t applied, epoch;
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	static const double somewhere[3];

	TS_TRY(ts_region_update(s->region, sim));
	if (isnan(ts_region_radial(s->region, somewhere)))
		return ts_fail(&sim->error, TS_RANGE, ts_instance_word(self, s->region->id),
			       "fix scale/diameter: region %s has no centre and radius, or is of `side out`; "
			       "expected a sphere or a cylinder",
			       s->region->id);
	if (!s->begun)
		TS_TRY(ts_first_size_start(sim, self, &s->column));
	s->begun = true;
	if (!s->applied)
		s->epoch++;
	return TS_OK;
}

/* Linear from 1 at the surface of the region to `scale` at the depth width * radius. */
static double diameter_factor(const struct state *s, const double x[3], double scale)
{
	double in;

	if (!ts_region_contains(s->region, x))
		return 1;
	in = 1 - ts_region_radial(s->region, x);
	return in < s->width ? 1 + (scale - 1) * in / s->width : scale;
}

static void set_size(const struct state *s, struct tsim *sim, size_t i, double f)
{
	struct ts_particles *p = sim->particles;
	const double *first = ts_first_size(sim, s->column, i);
	double volume;

	ts_first_size_note(sim, s->column, i);
	volume = ts_particle_volume(sim, f * first[TS_FIRST_RADIUS]) /
		 ts_particle_volume(sim, first[TS_FIRST_RADIUS]);
	p->radius[i] = f * first[TS_FIRST_RADIUS];
	p->mass[i] = f < 1 || f > 1 ? volume * first[TS_FIRST_MASS] : first[TS_FIRST_MASS];
	if (p->imass[i] > 0)
		p->imass[i] = 1 / p->mass[i];
}

static enum ts_status scale_diameters(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	const struct ts_particles *p = sim->particles;
	double scale;

	TS_TRY(ts_number_now(sim, &s->scale, &self->where, &scale));
	if (!(scale > 0) || !isfinite(scale))
		return ts_fail(&sim->error, TS_RANGE, &self->where,
			       "fix scale/diameter: the factor v_%s is %g, expected a number > 0",
			       s->scale.variable, scale);
	TS_TRY(ts_region_update(s->region, sim));
	TS_TRY(ts_rigid_refuse_resizing(sim, self->group, "fix scale/diameter", &self->where));
	for (size_t i = 0; i < p->n; i++)
		if (ts_in_group(p, i, self->group))
			set_size(s, sim, i, diameter_factor(s, p->x[i], scale));
	s->applied = 1;
	return TS_OK;
}

/* Before the contact list is built, which depends on the new sizes. */
static enum ts_status post_integrate(struct ts_instance *self, struct tsim *sim)
{
	const struct state *s = self->state;

	if (s->every == 0 || sim->clock.step % s->every != 0)
		return TS_OK;
	sim->run.rebuild = true;
	return scale_diameters(self, sim);
}

/* Applies the factor at the start of the first run. */
static enum ts_status exchange(struct ts_instance *self, struct tsim *sim)
{
	const struct state *s = self->state;

	return s->applied ? TS_OK : scale_diameters(self, sim);
}

static enum ts_status archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a)
{
	return ts_particles_archive_column(a, sim, "particles", ((struct state *)self->state)->column);
}

static void fingerprint(const struct ts_instance *self, const struct tsim *sim, struct ts_hash *hash)
{
	const struct state *s = self->state;

	(void)sim;
	ts_hash_add(hash, &s->epoch, sizeof s->epoch);
}

static const struct ts_arg args[] = {
	TS_INT("N", struct state, every, .flags = TS_POSITIONAL, .range = TS_WITHIN, .lo = 0, .hi = 1e15,
	       .help = "steps between changes; 0: only once, at the start of the first run"),
	TS_REGION("region", struct state, region, .help = "a sphere or a cylinder"),
	TS_NUMBER("scale", struct state, scale, .fallback = "1.0", .unit = "", .range = TS_POSITIVE,
		  .help = "factor of the diameter in the centre"),
	TS_REAL("scale_width", struct state, width, .fallback = "1.0", .range = TS_FRACTION, .unit = "",
		.help = "fraction of the radius of the region, from its surface inwards, over which the "
			"factor changes"),
	TS_ARGS_END,
};

static const struct ts_saved saved[] = {
	TS_SAVE_I64(struct state, applied),
	TS_SAVE_I64(struct state, epoch),
	TS_SAVED_ROWS_END,
};

static bool is_due(const struct ts_instance *self, const struct tsim *sim)
{
	const struct state *s = self->state;

	return s->every > 0 && sim->clock.step % s->every == 0;
}

TS_STYLE(fix, ts_style, ts_fix_scale_diameter)
const struct ts_style ts_fix_scale_diameter = {
	.name = "scale/diameter",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_STEPS,
	.due = is_due,
	.summary = "Scales diameters by the distance from the centre of a region",
	.doc = "At the start of the first run, and in each step that is a multiple of N, the diameter of "
	       "each particle of the group is set to f times its original diameter, that at the time when "
	       "the fix first processed the particle. With r the distance of its centre from the centre of "
	       "the sphere, or from the axis of the cylinder, of radius R, and w = scale_width:\n\n"
	       "    f = 1                              outside the region\n"
	       "    f = 1 + (scale - 1) (1 - r/R)/w    for 1 - r/R < w\n"
	       "    f = scale                          further inside\n\n"
	       "The mass changes with the volume at constant density. The region may move. Particles that "
	       "are inserted later are included from the next change on. Particles of rigid bodies are an "
	       "error. The fix exists in another edition of LIGGGHTS (PFM).",
	.example = "region core sphere 0 0 0 0.5 units box\n"
		   "fix fine all scale/diameter 10 region core scale 0.5 scale_width 0.2",
	.args = args,
	.state_size = sizeof(struct state),
	.saved = saved,
	.archive = archive,
	.fingerprint = fingerprint,
	.init = init,
	.hook = { [TS_STAGE_POST_INTEGRATE] = post_integrate, [TS_STAGE_EXCHANGE] = exchange },
};
