/* Fix insert/pack/dense: fills a region once with a dense random packing. */
#include "insert/insertion_region.h"

#include "box/domain.h"
#include "geom/pairs.h"
#include "math/vec3.h"
#include "particle/identity.h"
#include "particle/particles.h"
#include "particle/sphere_shape.h"

#include "base/banned.h"

/* Relative gap: spheres are moved apart until they would not overlap with radii larger by this fraction. */
static const double MARGIN = 1e-3;
/* Minimisation by FIRE: E. Bitzek, P. Koskinen, F. Gaehler, M. Moseler, P. Gumbsch, Structural relaxation
 * made simple, Phys. Rev. Lett. 97 (2006) 170201, with the parameters given there. Mass and stiffness are
 * 1, so times are in units of sqrt(mass / stiffness). */
static const double FIRST_STEP = 0.1, LONGEST_STEP = 0.6, FASTER = 1.1, SLOWER = 0.5, MIXED = 0.1,
		    LESS_MIXED = 0.99;
enum { PATIENCE = 5 };

struct state {
	union {
		struct ts_insertion base;
		struct ts_insertion_region place;
	};
	double fraction;
	int64_t most_rounds;
};

/* All spheres: first the `fixed` present particles in the order of their tags, which do not move, then
 * new ones. */
struct packing {
	const struct ts_instance *region;
	double face[3][2]; /* faces of the box, infinite where the region does not reach beyond */
	size_t n, fixed;
	double (*x)[3], (*v)[3], (*f)[3], *radius, largest;
	double worst; /* largest overlap / sum of the radii */
	double step, mix;
	int well; /* iterations since the power f.v was last <= 0 */
};

static enum ts_status refuse_clumps(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_insertion *s = self->state;
	const struct ts_distribution *d = s->distribution->state;

	for (int64_t k = 0; k < d->n; k++)
		if (((const struct ts_template *)d->template[k] -> state)->clump)
			return ts_fail(&sim->error, TS_STATE, ts_instance_word(self, s->distribution_id),
				       "fix insert/pack/dense: fix %s makes clumps; spheres are packed, "
				       "only. For clumps take insert/pack and let them settle",
				       d->template[k] -> id);
	return TS_OK;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	s->base.every_word = "once";
	s->base.all_in = true;
	s->place.ntry_mc = 100000;
	TS_TRY(ts_insertion_region_init(self, sim));
	return refuse_clumps(self, sim);
}

/* ---- relaxation of overlaps */

static void free_packing(struct packing *p)
{
	ts_free(p->x);
	ts_free(p->v);
	ts_free(p->f);
	ts_free(p->radius);
}

static enum ts_status init_packing(struct state *s, struct tsim *sim, struct packing *p)
{
	const struct ts_particles *all = sim->particles;
	struct ts_identities order;

	TS_TRY(ts_identities(sim, true, &order));
	*p = (struct packing){ .region = s->place.region,
			       .n = order.n + s->base.list.n,
			       .fixed = order.n,
			       .step = FIRST_STEP,
			       .mix = MIXED };
	ts_insertion_region_faces(&s->place, &sim->domain->box, p->face);
	p->x = ts_alloc(p->n + 1, sizeof *p->x);
	p->v = ts_alloc(p->n + 1, sizeof *p->v);
	p->f = ts_alloc(p->n + 1, sizeof *p->f);
	p->radius = ts_alloc(p->n + 1, sizeof *p->radius);
	if (!p->x || !p->v || !p->f || !p->radius)
		return ts_nomem(&sim->error);
	for (size_t k = 0; k < p->n; k++) {
		const struct ts_new_particle *one = k < p->fixed ? NULL : &s->base.list.item[k - p->fixed];

		ts_scale(1, one ? one->x : all->x[order.row[k]], p->x[k]);
		p->radius[k] = one ? one->radius : all->radius[order.row[k]];
		p->largest = fmax(p->largest, p->radius[k]);
	}
	return TS_OK;
}

/* Repulsion of overlapping spheres: force = overlap. */
static void add_pair_force(void *context, size_t i, size_t j, const double d[3])
{
	struct packing *p = context;
	double sum = (1 + MARGIN) * (p->radius[i] + p->radius[j]), distance = ts_norm(d), share;

	if (i < p->fixed || distance >= sum)
		return;
	share = j < p->fixed ? 2 : 1; /* twice the force if the partner is fixed */
	p->worst = fmax(p->worst, (sum - distance) / sum);
	if (distance > 0)
		ts_axpy(share * (sum - distance) / distance, d, p->f[i]);
	else
		p->f[i][i % 3] += i < j ? sum : -sum;
}

/* Force of the surface of the region along the gradient of the depth, by central differences. */
static void add_region_force(struct packing *p, size_t i)
{
	double reach = (1 + MARGIN) * p->radius[i], miss = reach - ts_region_depth(p->region, p->x[i]);
	double up[3], size;

	if (!(miss > 0))
		return;
	p->worst = fmax(p->worst, miss / reach);
	ts_region_depth_slope(ts_region_depth, p->region, p->x[i], 1e-4 * reach, up);
	size = ts_norm(up);
	if (size > 0)
		ts_axpy(2 * miss / size, up, p->f[i]);
}

/* The same of faces of the box. */
static void add_face_forces(struct packing *p, size_t i)
{
	double reach = (1 + MARGIN) * p->radius[i];

	for (int k = 0; k < 6; k++) {
		const int d = k / 2, inwards = k % 2 ? -1 : 1;
		double miss = reach - inwards * (p->x[i][d] - p->face[d][k % 2]);

		if (!(miss > 0))
			continue;
		p->worst = fmax(p->worst, miss / reach);
		p->f[i][d] += 2 * miss * inwards;
	}
}

static enum ts_status compute_forces(struct packing *p, const struct tsim *sim)
{
	p->worst = 0;
	for (size_t i = 0; i < p->n; i++)
		ts_scale(0, p->f[i], p->f[i]);
	TS_TRY(ts_pairs_visit(&sim->domain->box, sim->dimension, (const double(*)[3])p->x, p->n,
			      2 * (1 + MARGIN) * p->largest, add_pair_force, p));
	for (size_t i = p->fixed; i < p->n; i++) {
		add_region_force(p, i);
		add_face_forces(p, i);
	}
	return TS_OK;
}

/* A step of FIRE: mixes velocities with the direction of forces, and stops all if the power f.v is not
 * positive. */
static void fire_step(struct packing *p)
{
	double power = 0, vv = 0, ff = 0, turn;

	for (size_t i = p->fixed; i < p->n; i++) {
		power += ts_dot(p->f[i], p->v[i]);
		vv += ts_dot(p->v[i], p->v[i]);
		ff += ts_dot(p->f[i], p->f[i]);
	}
	turn = ff > 0 ? p->mix * sqrt(vv / ff) : 0;
	for (size_t i = p->fixed; i < p->n; i++)
		for (int d = 0; d < 3; d++)
			p->v[i][d] = power > 0 ? (1 - p->mix) * p->v[i][d] + turn * p->f[i][d] : 0;
	if (power > 0 && ++p->well > PATIENCE) {
		p->step = fmin(p->step * FASTER, LONGEST_STEP);
		p->mix *= LESS_MIXED;
	} else if (!(power > 0)) {
		p->step *= vv > 0 ? SLOWER : 1;
		p->mix = MIXED;
		p->well = 0;
	}
	for (size_t i = p->fixed; i < p->n; i++) {
		ts_axpy(p->step, p->f[i], p->v[i]);
		ts_axpy(p->step, p->v[i], p->x[i]);
	}
}

static enum ts_status relax_overlaps(struct ts_instance *self, struct tsim *sim, struct packing *p)
{
	const struct state *s = self->state;

	for (int64_t round = 0; round < s->most_rounds; round++) {
		if (sim->requests.stop)
			return ts_fail(&sim->error, TS_STOPPED, &self->where, "stopped on request");
		if (compute_forces(p, sim) != TS_OK)
			return ts_nomem(&sim->error);
		if (p->worst < 0.9 * MARGIN)
			return TS_OK;
		fire_step(p);
	}
	return ts_fail(&sim->error, TS_RANGE, ts_instance_word(self, "volumefraction_region"),
		       "fix insert/pack/dense: %zu particles that fill %g of region %s were not moved apart: "
		       "after %lld rounds two overlap by %.3g %% of their radii. Ask for less (spheres at "
		       "random fill at most 0.64, near walls less), or raise max_rounds",
		       s->base.list.n, s->fraction, s->place.region->id, (long long)s->most_rounds,
		       100 * p->worst);
}

static enum ts_status relax_packing(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	struct packing p = { 0 };
	enum ts_status status = init_packing(s, sim, &p);

	if (status == TS_OK)
		status = relax_overlaps(self, sim, &p);
	for (size_t k = 0; status == TS_OK && k < s->base.list.n; k++)
		ts_scale(1, p.x[p.fixed + k], s->base.list.item[k].x);
	free_packing(&p);
	return status;
}

/* ---- insertion */

static enum ts_status pre_exchange(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	struct ts_region_content now;
	enum ts_status status;
	double wanted;
	size_t from;

	if (!s->base.due)
		return TS_OK;
	ts_insertion_next(self);
	TS_TRY(ts_insertion_region_content(self, sim, &now));
	wanted = (s->fraction * now.room - now.volume) /
		 ((const struct ts_distribution *)s->base.distribution->state)->volume;
	if (!(wanted >= 0.5))
		return TS_OK;
	TS_TRY(ts_insertion_region_scatter(self, sim, (int64_t)(wanted + 0.5)));
	status = relax_packing(self, sim);
	if (status == TS_STOPPED) /* a run that continues from the saved state repeats the insertion */
		s->base.wait = 1;
	TS_TRY(status);
	return ts_insertion_make(self, sim, &from);
}

static const struct ts_arg args[] = {
	TS_INT("seed", struct state, base.seed, .range = TS_POSITIVE,
	       .help = TS_SEED_HELP " - and another one than those of the distribution and its templates"),
	TS_WORD("distributiontemplate", struct state, base.distribution_id,
		.help = "ID of the fix particledistribution/discrete whose particles are inserted"),
	TS_REGION("region", struct state, place.region, .help = "region that is filled"),
	TS_REAL("volumefraction_region", struct state, fraction, .range = TS_WITHIN, .lo = 0, .hi = 0.74,
		.unit = "", .help = "fraction of the volume of the region that particles fill"),
	TS_INT("max_rounds", struct state, most_rounds, .fallback = "5000", .range = TS_POSITIVE,
	       .help = "largest number of iterations of the relaxation"),
	TS_INT("start", struct state, base.start, .flags = TS_OPTIONAL, .range = TS_NOT_NEGATIVE,
	       .help = "step of the insertion; default: the next step"),
	TS_LIST_KEYWORD("vel", struct state, base.velocity_words, .flags = TS_TO_KEYWORD | TS_OPTIONAL,
			.help = "constant vx vy vz | uniform vx vy vz dx dy dz | gaussian vx vy vz sx sy sz: "
				"velocity; 0 by default"),
	TS_LIST_KEYWORD("omega", struct state, base.omega_words, .flags = TS_TO_KEYWORD | TS_OPTIONAL,
			.help = "constant wx wy wz: angular velocity, 0 by default"),
	TS_BOOL("verbose", struct state, base.verbose, .fallback = "yes",
		.help = "print the insertion to the log"),
	TS_ARGS_END,
};

static const struct ts_saved saved[] = { TS_INSERTION_REGION_SAVED(struct state), TS_SAVED_ROWS_END };

TS_STYLE(fix, ts_style, ts_fix_insert_pack_dense)
const struct ts_style ts_fix_insert_pack_dense = {
	.name = "insert/pack/dense",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_STEPS,
	.due = ts_insertion_due,
	.summary = "Fills a region with a dense random packing",
	.doc = "Fills the region once, in the step after the definition or in the step start, so that "
	       "particles occupy volumefraction_region of its volume. The number of new particles is the "
	       "missing volume divided by the mean particle volume of the mixture, rounded. They are drawn "
	       "from a mixture, fix particledistribution/discrete.\n\n"
	       "New particles are placed at random and then moved apart: overlapping spheres repel each "
	       "other with a force equal to the overlap, the surface of the region repels them, and "
	       "particles that were present before do not move. If the region reaches out of the box, the "
	       "part of it in the box is filled, and the faces of the box repel, too. The method FIRE "
	       "(Bitzek et al., Phys. Rev. Lett. 97 (2006) 170201) minimises the overlaps until none is left "
	       "and each particle lies completely in the region. A gap of about 1e-3 of their radii is left "
	       "between neighbours. The packing is random and isotropic, except for layers at the surface of "
	       "the region. No particles are in contact: under gravity the packing settles.\n\n"
	       "Random packings of equal spheres reach a fraction of at most 0.64. Some hundred iterations "
	       "are sufficient up to 0.55, thousands are needed beyond 0.57, and narrow regions hold less. "
	       "It is an error if overlaps remain after max_rounds iterations. fix insert/pack, which tries "
	       "random positions, reaches about 0.3.\n\n"
	       "The fix exists in another edition of LIGGGHTS (PFM), which gives other positions.",
	.example = "fix bed all insert/pack/dense seed 32452867 distributiontemplate mix region drum "
		   "volumefraction_region 0.55",
	.args = args,
	.state_size = sizeof(struct state),
	.saved = saved,
	.archive = ts_insertion_region_archive,
	.values = ts_insertion_values,
	.init = init,
	.hook = { [TS_STAGE_CHECK] = ts_insertion_check, [TS_STAGE_PRE_EXCHANGE] = pre_exchange },
	.fini = ts_insertion_fini,
};
