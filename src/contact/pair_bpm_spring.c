#include <math.h>

#include "contact/contact_energy.h"
#include "contact/contact_loop.h"
#include "contact/contact_models.h"
#include "contact/pair.h"

#include "base/banned.h"

struct bpm_spring {
	struct ts_pair pair;
	bool anharmonic; /* refused */
};

struct coeff {
	double k, cutoff, gamma;
	struct ts_granular_pair law; /* from these */
};

static enum ts_status complete(struct tsim *sim, void *coeff, const struct ts_place *where)
{
	struct coeff *c = coeff;

	(void)sim, (void)where;
	c->law = (struct ts_granular_pair){ .kn = c->k, .gamman = c->gamma };
	return TS_OK;
}

/* Atom styles of LAMMPS whose particles have no radius. */
static bool are_points(const struct tsim *sim)
{
	static const char *const styles[] = { "bond", "atomic", "molecular", "angle", "full", NULL };
	const char *style = sim->particles->atom_style;

	for (int k = 0; style && styles[k]; k++)
		if (ts_streq(style, styles[k]))
			return true;
	return false;
}

static const struct coeff *coeff_of(const struct ts_pair *pair, int a, int b)
{
	return ts_coeff(&pair->coeffs, (size_t)(a * (pair->ntypes + 1) + b));
}

/* Points get half the cutoff of their type as radius. */
static void give_radii(struct tsim *sim, const struct ts_pair *pair)
{
	struct ts_particles *p = sim->particles;

	for (size_t i = 0; are_points(sim) && i < p->n; i++)
		if (coeff_of(pair, p->type[i], p->type[i])->cutoff > 0)
			p->radius[i] = 0.5 * coeff_of(pair, p->type[i], p->type[i])->cutoff;
}

/* Contacts begin where the radii add up to the distance: that must be the cutoff. */
static enum ts_status check_cutoffs(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_pair *pair = self->state;
	const struct ts_particles *p = sim->particles;
	double *radius = ts_alloc((size_t)pair->ntypes + 1, sizeof *radius);
	enum ts_status status = radius ? TS_OK : ts_nomem(&sim->error);

	for (size_t i = 0; status == TS_OK && i < p->n; i++) {
		double *of = &radius[p->type[i]];

		if (*of > 0 && !(fabs(p->radius[i] - *of) <= 1e-9 * *of))
			status = ts_fail(&sim->error, TS_STATE, &self->where,
					 "pair bpm/spring: particles of type %d have different radii, but "
					 "one cutoff; `set type %d diameter D` gives all the same",
					 p->type[i], p->type[i]);
		*of = p->radius[i];
	}
	for (int a = 1; status == TS_OK && a <= pair->ntypes; a++)
		for (int b = a; status == TS_OK && b <= pair->ntypes; b++) {
			double sum = radius[a] + radius[b], cutoff = coeff_of(pair, a, b)->cutoff;

			if (radius[a] > 0 && radius[b] > 0 && !(fabs(cutoff - sum) <= 1e-9 * sum))
				status = ts_fail(&sim->error, TS_STATE, &self->where,
						 "pair bpm/spring: the cutoff of types %d and %d is %g, but "
						 "their radii add up to %g, where contacts begin; use this "
						 "cutoff, or other diameters (`set type %d diameter ...`)",
						 a, b, cutoff, sum, a);
		}
	ts_free(radius);
	return status;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct bpm_spring *s = self->state;

	s->pair.model = (struct ts_granular_model){ .normal = TS_NORMAL_SPRING, .fades = true };
	if (s->anharmonic)
		return ts_fail(&sim->error, TS_STATE, ts_instance_word(self, "anharmonic"),
			       "pair bpm/spring: anharmonic yes is not supported");
	if (!sim->particles->ntypes)
		return TS_OK;
	TS_TRY(ts_pair_init(self, sim));
	give_radii(sim, &s->pair);
	return check_cutoffs(self, sim);
}

static enum ts_status force(struct ts_instance *self, struct tsim *sim)
{
	const struct bpm_spring *s = self->state;

	return ts_contact_loop(sim, &s->pair, ts_contact_share_of(&s->pair, false));
}

static const struct ts_arg args[] = {
	TS_BOOL("anharmonic", struct bpm_spring, anharmonic, .fallback = "no", .help = "only no"),
	TS_ARGS_END,
};

static const struct ts_arg coeff[] = {
	TS_REAL("k", struct coeff, k, .flags = TS_POSITIONAL, .range = TS_NOT_NEGATIVE,
		.unit = "force/length", .help = "stiffness"),
	TS_REAL("r_c", struct coeff, cutoff, .flags = TS_POSITIONAL, .range = TS_POSITIVE, .unit = "length",
		.help = "distance of the centres at which contacts begin"),
	TS_REAL("gamma", struct coeff, gamma, .flags = TS_POSITIONAL, .range = TS_NOT_NEGATIVE,
		.unit = "force/velocity", .help = "damping"),
	TS_ARGS_END,
};

static const char *const more[] = {
	"Contacts in tsim begin where the radii of two particles add up to their distance, so r_c must be "
	"this sum. Particles of the atom styles without radii (bond, atomic, molecular) get half the r_c of "
	"their type as radius at the start of a run; their mass does not change.\n\n"
	"Compared with the documentation of LAMMPS, and by examples/bpm/impact/in.bpm.impact.spring with its "
	"published log (doc/bonds.md). Not supported: anharmonic yes, and mixed coefficients: each pair of "
	"types needs its pair_coeff.",
	NULL
};

TS_STYLE(pair, ts_pair_style, ts_pair_bpm_spring)
const struct ts_pair_style ts_pair_bpm_spring = {
	.style = { .name = "bpm/spring",
		   .kind = TS_KIND_PAIR,
		   .ranks = TS_RANKS_OWN,
		   .summary =
			   "repulsive spring with a damping that begins at zero, of LAMMPS' bonded particles",
		   .doc = "Particles nearer than r_c repel each other with\n\n"
			  "  F = k (r_c - r) - gamma w v_n,   w = 1 - (r/r_c)^8\n\n"
			  "along the line of centres, v_n > 0 while separating. The damping begins and ends "
			  "without a jump. Bonded particles do not interact if `special_bonds lj 0 1 1` says "
			  "so.",
		   .doc_more = more,
		   .example = "pair_style bpm/spring\n"
			      "pair_coeff 1 1 1.0 1.0 1.0",
		   .cite = "J. T. Clemmer, J. M. Monti, J. B. Lechman, Soft Matter 20 (2024) 1702",
		   .args = args,
		   .coeff = coeff,
		   .state_size = sizeof(struct bpm_spring),
		   .archive = ts_pair_archive,
		   .fingerprint = ts_pair_fingerprint,
		   .init = init,
		   .hook = { [TS_STAGE_FORCE] = force },
		   .energy = ts_contact_energy_of_pairs,
		   .plan = ts_pair_plan,
		   .fini = ts_pair_fini },
	.coeff_size = sizeof(struct coeff),
	.complete = complete,
	.law_offset = offsetof(struct coeff, law),
};
