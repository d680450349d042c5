/* Fix insert/gap: particles in the gap between a height field and a face above it. */
#include <math.h>

#include "box/domain.h"
#include "core/unclaimed_state.h"
#include "insert/insertion.h"
#include "insert/sites.h"
#include "particle/sphere_shape.h"
#include "polish/gap.h"

#include "base/banned.h"

enum { STACKED, VOLUME };
/* Spheres placed one by one at random fill at most 0.38 of a volume; no packing more than 0.74. */
static const double MOST_FRACTION = 0.6;

struct state {
	struct ts_insertion base;
	const char *lower_id, *upper_id;
	double fraction;
	int count;
	bool contact;

	struct ts_gap gap;
	/* saved, of the insertion */
	double stacked, volume, filled;
};

static double largest_diameter(const struct state *s)
{
	return 2 * ((const struct ts_distribution *)s->base.distribution->state)->largest;
}

/* ---- how many ---- */

static double wanted_of(const struct state *s, const struct ts_gap_room *r)
{
	const struct ts_distribution *d = s->base.distribution->state;

	return s->count == STACKED ? s->fraction * (double)r->stacked : s->fraction * r->volume / d->volume;
}

static enum ts_status refuse_overlap(struct ts_instance *self, struct tsim *sim, const struct ts_gap_room *r)
{
	const struct state *s = self->state;

	return ts_fail(&sim->error, TS_PHYSICS, ts_instance_word(self, s->upper_id),
		       "fix insert/gap: the surfaces interpenetrate: %lld of %lld columns of %s reach up to "
		       "%g into %s; if they are in contact say `contact yes`",
		       (long long)r->touching, (long long)r->columns, s->lower_id, r->depth, s->upper_id);
}

/* The number of particles; fails if the gap has no place for one. */
static enum ts_status find_number(struct ts_instance *self, struct tsim *sim, struct ts_gap_room *r,
				  int64_t *n)
{
	struct state *s = self->state;
	double diameter = largest_diameter(s), wanted;

	*r = ts_gap_room(&s->gap, sim, diameter);
	if (r->depth > 0 && !s->contact)
		return refuse_overlap(self, sim, r);
	if (!(r->highest > 0))
		return ts_fail(&sim->error, TS_PHYSICS, ts_instance_word(self, s->upper_id),
			       "fix insert/gap: there is no gap: all columns of %s reach %s", s->lower_id,
			       s->upper_id);
	if (r->stacked == 0)
		return ts_fail(&sim->error, TS_PHYSICS, &self->where,
			       "fix insert/gap: the largest particle has the diameter %g, and the gap is at "
			       "most %g high",
			       diameter, r->highest);
	wanted = floor(wanted_of(s, r) + 0.5);
	if (!(wanted >= 1))
		return ts_fail(&sim->error, TS_PHYSICS, &self->where,
			       "fix insert/gap: no particle: the fraction %g gives %g of them", s->fraction,
			       wanted_of(s, r));
	if (wanted > 1e9)
		return ts_fail(&sim->error, TS_RANGE, &self->where,
			       "fix insert/gap: %g particles are too many, at most 1e9", wanted);
	*n = (int64_t)wanted;
	return TS_OK;
}

/* ---- where ---- */

/* A random point over the field, below the face. */
static void draw_point(struct state *s, const struct ts_gap_room *r, double radius, double x[3])
{
	const struct ts_voxel_surface *lower = s->gap.lower;
	const struct ts_voxel_field *f = &lower->field;
	double top = r->face - radius, deepest = r->face - r->highest;

	for (int d = 0; d < 2; d++)
		x[f->axis[d]] = f->origin[d] + lower->shift[f->axis[d]] +
				ts_minstd_uniform(&s->base.random) * (double)f->n[d] * f->width[d];
	x[f->axis[2]] = deepest + ts_minstd_uniform(&s->base.random) * (top - deepest);
}

static bool fits(const struct ts_instance *self, const struct tsim *sim, const struct ts_gap_room *r,
		 const struct ts_spherehash *occupied, const struct ts_new_particle *one)
{
	const struct state *s = self->state;

	return ts_sites_in_box(sim, one->x) && ts_gap_is_free(&s->gap, r->face, one->x, one->radius) &&
	       !(s->base.overlapcheck && ts_insertion_overlaps(sim, occupied, one));
}

static enum ts_status refuse_place(struct ts_instance *self, struct tsim *sim, size_t placed, int64_t tries)
{
	const struct state *s = self->state;

	if (sim->requests.stop)
		return ts_fail(&sim->error, TS_STOPPED, &self->where,
			       "fix insert/gap: stopped on request: %zu of %zu particles had been placed, "
			       "none is made",
			       placed, s->base.list.n);
	return ts_fail(&sim->error, TS_PHYSICS, &self->where,
		       "fix insert/gap: %zu of %zu particles found a place between %s and %s without "
		       "overlap, in %lld tries; insert fewer (`fraction`), smaller ones, or raise "
		       "`maxattempt`",
		       placed, s->base.list.n, s->lower_id, s->upper_id, (long long)tries);
}

static enum ts_status place_particles(struct ts_instance *self, struct tsim *sim, const struct ts_gap_room *r,
				      struct ts_spherehash *occupied)
{
	struct state *s = self->state;
	const struct ts_box *box = &sim->domain->box;
	int64_t tries = 0, most = (int64_t)s->base.list.n * s->base.maxattempt;

	for (size_t k = 0; k < s->base.list.n; k++) {
		struct ts_new_particle *one = &s->base.list.item[k];

		while (!one->placed) {
			int32_t turns = 0;

			if (tries++ == most || (sim->requests.stop && tries % 1024 == 0))
				return refuse_place(self, sim, k, tries - 1);
			draw_point(s, r, one->radius, one->x);
			for (int d = 0; d < 3; d++)
				if (ts_box_periodic(box, d))
					ts_box_wrap(box, d, &one->x[d], &turns);
			one->placed = fits(self, sim, r, occupied, one);
		}
		for (int d = 0; d < 3; d++)
			one->omega[d] = s->base.omega[d];
		TS_TRY(ts_insertion_hash_add(sim, occupied, one));
	}
	return TS_OK;
}

static enum ts_status insert(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	const struct ts_box *box = &sim->domain->box;
	struct ts_spherehash occupied = { .nlevels = 0 };
	struct ts_gap_room room;
	enum ts_status status = TS_OK;
	int64_t n;
	size_t from;

	TS_TRY(find_number(self, sim, &room, &n));
	TS_TRY(ts_distribution_draw(s->base.distribution, sim, self, n, true, &s->base.list));
	if (s->base.overlapcheck)
		status = ts_insertion_hash_near(sim, &occupied, box->lo, box->hi,
						ts_insertion_reach(&s->base.list));
	if (status == TS_OK)
		status = place_particles(self, sim, &room, &occupied);
	ts_spherehash_release(&occupied);
	TS_TRY(status);
	s->stacked = (double)room.stacked;
	s->volume = room.volume;
	s->filled = 0;
	for (size_t k = 0; k < s->base.list.n; k++)
		s->filled += ts_particle_volume(sim, s->base.list.item[k].radius) / room.volume;
	return ts_insertion_make(self, sim, &from);
}

/* ---- stages ---- */

/* Clumps and sizes that change with time have no diameter to stack. */
static enum ts_status check_templates(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_distribution *d = ((struct state *)self->state)->base.distribution->state;

	for (int64_t k = 0; k < d->n; k++)
		if (((const struct ts_template *)d->template[k] -> state)->clump)
			return ts_fail(&sim->error, TS_STATE, &self->where,
				       "fix insert/gap inserts spheres, and %s is a clump",
				       d->template[k] -> id);
	return TS_OK;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	struct ts_gap_room room;
	int64_t n;
	bool first;

	if (s->fraction > MOST_FRACTION)
		return ts_fail(&sim->error, TS_RANGE, ts_instance_word(self, "fraction"),
			       "fix insert/gap: fraction is %g, expected at most %g: no slurry is denser",
			       s->fraction, MOST_FRACTION);
	TS_TRY(ts_insertion_init(self, sim, &first));
	TS_TRY(check_templates(self, sim));
	TS_TRY(ts_gap_find(self, sim, s->lower_id, s->upper_id, &s->gap));
	if (!first ||
	    ts_unclaimed_exists(sim, self)) /* continued from a restart file: the surfaces have moved */
		return TS_OK;
	return find_number(self, sim, &room, &n);
}

static enum ts_status pre_exchange(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	if (!s->base.due)
		return TS_OK;
	ts_insertion_next(self);
	return insert(self, sim);
}

/* ---- outputs ---- */

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct state *s = self->state;

	(void)sim;
	out->data[0] = (double)s->base.inserted;
	out->data[1] = s->base.mass;
	out->data[2] = s->stacked;
	out->data[3] = s->volume;
	out->data[4] = s->filled;
	return TS_OK;
}

static const char *const names[] = { "number", "mass", "stacked", "volume", "filled", NULL };

static const struct ts_value values[] = {
	{ "inserted", "-, mass, -, length^3, -",
	  "number and mass of the particles inserted; number of spheres that could be stacked; volume of the "
	  "gap, and the fraction of it that particles fill",
	  TS_VECTOR, 5, names, eval },
	{ .name = NULL },
};

static const char *const counts[] = { "stacked", "volume", NULL };

static const struct ts_arg args[] = {
	TS_INSERTION_SOURCE_ARGS(struct state),
	TS_WORD("lower", struct state, lower_id, .help = "ID of a fix surface/voxel: the lower surface"),
	TS_WORD("upper", struct state, upper_id,
		.help = "ID of a fix wall/gran with a plane, or of a fix surface/voxel with a `base`: the "
			"upper surface"),
	TS_REAL("fraction", struct state, fraction, .range = TS_POSITIVE,
		.help = "volume fraction phi of the particles, at most 0.6"),
	TS_ENUM("count", struct state, count, counts, .fallback = "stacked",
		.help = "number of particles: by those stacked over the columns, or by the volume of the "
			"gap"),
	TS_BOOL("contact", struct state, contact, .fallback = "no",
		.help = "whether columns may reach into the upper surface: these are in contact with it, and "
			"have no gap"),
	TS_INSERTION_MOTION_ARGS(struct state),
	TS_BOOL("verbose", struct state, base.verbose, .fallback = "yes",
		.help = "print the insertion to the log"),
	TS_ARGS_END,
};

static const struct ts_saved saved[] = { TS_INSERTION_SAVED(struct state), TS_SAVE_F64(struct state, stacked),
					 TS_SAVE_F64(struct state, volume), TS_SAVE_F64(struct state, filled),
					 TS_SAVED_ROWS_END };

static const char doc[] =
	"In the step after the definition, or in the step start, particles are placed at random between two "
	"surfaces, so that they overlap neither these nor each other nor present particles. Over the column "
	"i of the lower surface the gap has the height H_i up to the upper one. The number of particles is, "
	"rounded to the nearest integer,\n\n"
	"  N = fraction * sum of floor(H_i/d_max)     count stacked\n"
	"  N = fraction * sum of H_i A_i/V_p          count volume\n\n"
	"with the largest diameter d_max and the mean volume V_p of the mixture and the area A_i of a "
	"column. The first one counts a single stack over each column, however wide it is. The second one "
	"fills the volume fraction of the gap.\n\n"
	"Particles are drawn from a mixture, fix particledistribution/discrete, and placed in the order of "
	"decreasing size, each at the first of a sequence of random points, uniform over the gap, where it "
	"fits. If N * maxattempt points are not enough, the run stops. It also stops, or is refused, if "
	"there is no place for a single particle, or if the surfaces interpenetrate; with `contact yes` "
	"columns that reach into the upper surface are in contact with it. Other walls are not looked at. "
	"The positions are those of the surfaces in the step of the insertion; `seed` defines them, whatever "
	"the number of threads.\n\n"
	"The upper surface is a plane across the axis of the heights, or the underside of a second height "
	"field on the same rectangle.\n\n"
	"Related: compute active/paml, fix insert/pack, compute surface/contact.";

TS_STYLE(fix, ts_style, ts_fix_insert_gap)
const struct ts_style ts_fix_insert_gap = {
	.name = "insert/gap",
	.kind = TS_KIND_FIX,
	.summary = "Inserts particles into the gap between a rough surface and a face above it",
	.doc = doc,
	.example = "fix silica all particletemplate/sphere 15485863 atom_type 1 density constant 2000 radius "
		   "gaussian number 0.272e-6 0.043e-6 volume_limit 1e-25\n"
		   "fix mix all particledistribution/discrete 32452843 1 silica 1.0\n"
		   "fix pad all surface/voxel gaussian mean 10.5e-6 deviation 4.7e-6 correlation 0 seed 1 "
		   "type 2 cells 25 25\n"
		   "fix wafer all wall/gran primitive type 3 zplane 20e-6\n"
		   "fix slurry all insert/gap seed 32452867 distributiontemplate mix lower pad upper wafer "
		   "fraction 0.04 contact yes",
	.cite = "E. J. Terrell, C. F. Higgs III, J. Tribol. 131 (2009) 012201",
	.args = args,
	.ranks = TS_RANKS_STEPS,
	.due = ts_insertion_due,
	.state_size = sizeof(struct state),
	.saved = saved,
	.archive = ts_insertion_archive,
	.values = values,
	.init = init,
	.hook = { [TS_STAGE_CHECK] = ts_insertion_check, [TS_STAGE_PRE_EXCHANGE] = pre_exchange },
	.fini = ts_insertion_fini,
};
