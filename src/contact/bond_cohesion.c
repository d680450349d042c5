/* Bond style cohesion: the bonds of pair_style gran with `cohesion bond`. */
#include <inttypes.h>
#include <math.h>

#include "bond/bond_arguments.h"
#include "bond/bond_force.h"
#include "bond/bond_moment.h"
#include "bond/bond_search.h"
#include "bond/bond_single_loop.h"
#include "contact/cohesive_bonds.h"
#include "contact/contact_energy.h"
#include "core/archive.h"
#include "insert/template.h"
#include "law/bond_local_damping.h"
#include "law/bond_section.h"
#include "material/property.h"
#include "neigh/neigh.h"
#include "particle/particles.h"

#include "base/banned.h"

struct cohesive_bond {
	struct ts_bond bond;
	struct ts_cohesive_words words;
	double when;	 /* step in which bonds are created; NaN: in each */
	int64_t created; /* saved: step + 1 in which bonds were created last */
	int64_t resets;	 /* saved: clock.resets then */
};

/* ---- law */

static void element(const void *coeff, const struct ts_bond_pair *pair, struct ts_bond_element *e)
{
	const struct ts_cohesive_coeff *c = coeff;
	double radius = c->radius_multiplier * fmin(pair->radius[0], pair->radius[1]);

	e->fraction = ts_bond_fraction(pair->rest, pair->radius);
	ts_bond_section_parallel(radius, c->kn, c->kt, e);
	ts_bond_section_stress(radius, 1, e);
	e->k[TS_BOND_SHEAR] *= c->words.shear;
	e->k[TS_BOND_BENDING] *= c->words.bending;
	e->k[TS_BOND_TWIST] *= c->words.twist;
	if (!c->words.by_stress)
		return;
	e->tension = c->ratio * c->sigma;
	e->compression = c->sigma;
	e->shear = c->tau;
}

TS_INLINE bool cohesive_law(const void *coeff, struct ts_bond_element *e, const struct ts_bond_ends *s,
			    bool whole, struct ts_bond_answer *out)
{
	const struct ts_cohesive_coeff *c = coeff;
	double r2 = ts_xyz_dot(s->d, s->d);

	if (r2 > e->length * e->length ? !c->words.tension : !c->words.compression)
		e->k[TS_BOND_NORMAL] = 0;
	ts_bond_elastic(e, s, out);
	ts_bond_stress(e, out);
	if (whole && c->words.damping)
		ts_bond_local_damping(c->damping, e, s, out);
	if (!c->words.by_stress && r2 > c->max_distance * c->max_distance)
		return false;
	return ts_bond_holds(e, out);
}

static bool law(const void *coeff, struct ts_bond_element *e, const struct ts_bond_ends *s, bool whole,
		struct ts_bond_answer *out)
{
	return cohesive_law(coeff, e, s, whole, out);
}

TS_BOND_SINGLE_LOOP(compute, cohesive_law)

static bool damped(const void *coeff)
{
	const struct ts_cohesive_coeff *c = coeff;

	for (int m = 0; m < TS_BOND_MODES; m++)
		if (c->damping[m] > 0)
			return true;
	return false;
}

/* ---- creation */

static double create_distance(const struct ts_bond *bond, int a, int b)
{
	const struct ts_cohesive_coeff *c = ts_coeff(&bond->coeffs, (size_t)ts_cohesive_type(a, b));

	return c->create_distance;
}

static bool is_near(const void *context, const struct tsim *sim, size_t i, size_t j, double distance)
{
	const struct ts_particles *p = sim->particles;

	return distance < create_distance(context, p->type[i], p->type[j]);
}

static double largest_create_distance(const struct tsim *sim, const struct ts_bond *bond)
{
	double most = 0;

	for (int t = 1; t <= sim->bonds->ntypes; t++)
		if (bond->coeffs.given[t])
			most = fmax(most,
				    ((const struct ts_cohesive_coeff *)ts_coeff(&bond->coeffs, (size_t)t))
					    ->create_distance);
	return most;
}

static enum ts_status add_bonds(struct tsim *sim, const struct ts_bond_candidates *found)
{
	const struct ts_particles *p = sim->particles;

	for (size_t k = 0; k < found->n; k++) {
		const struct ts_bond_candidate *c = &found->pair[k];

		TS_TRY(ts_bonds_add_pair(sim, c, ts_cohesive_type(p->type[c->row[0]], p->type[c->row[1]])));
	}
	return found->n ? ts_bonds_added(sim) : TS_OK;
}

/* Before the forces of a step, or of the set-up of a run, are computed: bonds begin without force. */
static enum ts_status create_bonds(struct ts_instance *self, struct tsim *sim)
{
	struct cohesive_bond *s = self->state;
	struct ts_bond_candidates found = { 0 };
	double reach = largest_create_distance(sim, &s->bond);
	enum ts_status status;

	if ((!isnan(s->when) && (double)sim->clock.step != s->when) ||
	    (s->created == sim->clock.step + 1 && s->resets == sim->clock.resets))
		return TS_OK;
	s->created = sim->clock.step + 1;
	s->resets = sim->clock.resets;
	if (!(reach > 0))
		return TS_OK;
	ts_bonds_divide(sim);
	status = ts_bond_search(sim, 0, reach, is_near, &s->bond, &self->where, &found);
	if (status == TS_OK)
		status = add_bonds(sim, &found);
	ts_free(found.pair);
	return status;
}

/* ---- constants */

static enum ts_status complete(struct tsim *sim, void *coeff, const struct ts_place *where)
{
	(void)sim, (void)coeff, (void)where;
	return TS_OK;
}

static enum ts_status read_materials(struct ts_instance *self, struct tsim *sim)
{
	struct cohesive_bond *s = self->state;
	int most = ts_template_max_type(sim);

	s->when = NAN;
	if (!s->words.always)
		TS_TRY(ts_property_value(sim, "tsCreateBond", 0, 0, "pair_style gran cohesion bond",
					 &self->where, &s->when));
	for (int b = 1; b <= most; b++)
		for (int a = 1; a <= b; a++) {
			int t = ts_cohesive_type(a, b);

			TS_TRY(ts_cohesive_read(sim, &s->words, a, b, &self->where,
						ts_coeff(&s->bond.coeffs, (size_t)t)));
			s->bond.coeffs.given[t] = true;
		}
	sim->bonds->rows.filled = false;
	if (!(s->when <= (double)sim->clock.step)) /* in later steps, or all */
		sim->neigh->centre_reach =
			fmax(sim->neigh->centre_reach, largest_create_distance(sim, &s->bond));
	return TS_OK;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct cohesive_bond *s = self->state;
	int types = sim->particles->ntypes, most = types * (types + 1) / 2;

	TS_TRY(ts_cohesive_words_check(sim, self, "pair gran", &s->words));
	if (sim->bonds->ntypes < most)
		sim->bonds->ntypes = most;
	s->bond.coeffs.rows = self->style->coeff;
	s->bond.coeffs.size = sizeof(struct ts_cohesive_coeff);
	TS_TRY(ts_coeffs_resize(sim, &s->bond.coeffs, (size_t)sim->bonds->ntypes + 1));
	TS_TRY(read_materials(self, sim));
	return ts_bond_init(self, sim);
}

static void fingerprint(const struct ts_instance *self, const struct tsim *sim, struct ts_hash *hash)
{
	const struct cohesive_bond *s = self->state;

	for (int t = 1; t <= sim->bonds->ntypes && (size_t)t < s->bond.coeffs.n; t++) {
		const struct ts_cohesive_coeff *c = ts_coeff(&s->bond.coeffs, (size_t)t);
		const double numbers[] = { c->radius_multiplier, c->kn,	   c->kt,  c->create_distance,
					   c->max_distance,	 c->sigma, c->tau, c->ratio };

		ts_hash_add(hash, numbers, sizeof numbers);
		ts_hash_add(hash, c->damping, sizeof c->damping);
	}
}

static const struct ts_arg args[] = { TS_COHESIVE_ARGS(struct cohesive_bond, words), TS_ARGS_END };
static const struct ts_arg coeff_rows[] = { TS_ARGS_END };
static const struct ts_saved saved[] = { TS_SAVE_I64(struct cohesive_bond, created), TS_SAVED_ROWS_END };

static enum ts_status archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a)
{
	struct cohesive_bond *s = self->state;

	if (ts_archive_writing(a) || ts_archive_has(a, "resets")) /* older files have none */
		TS_TRY(ts_archive_fixed(a, "resets", TS_SAVED_I64, &s->resets, 1));
	return ts_bond_archive(self, sim, a);
}

static const char *const more[] = {
	"Properties, by fix property/global, per pair of particle types: normalBondStiffnessPerUnitArea kn, "
	"tangentialBondStiffnessPerUnitArea kt, radiusMultiplierBond (1 if it is not given), "
	"createDistanceBond; maxDistanceBond without, maxSigmaBond and maxTauBond with `stressBreak on`; "
	"with `dampingBond on`, the default, dampingNormalForceBond, dampingTangentialForceBond, "
	"dampingNormalTorqueBond and dampingTangentialTorqueBond, each >= 0 and < 1; with "
	"`ratioTensionCompression on` the property of that name. One number: tsCreateBond.\n\n"
	"Breakage: a bond breaks when the distance of the centres exceeds maxDistanceBond, or with "
	"`stressBreak on` when |N|/A + M R/I reaches maxSigmaBond or V/A + |M_t| R/J reaches maxTauBond. "
	"With `ratioTensionCompression on` it breaks when N/A + M R/I, N > 0 in tension, reaches ratio times "
	"maxSigmaBond, or -N/A + M R/I reaches maxSigmaBond. Broken bonds are counted and listed as those of "
	"the other bond styles: compute bond/counter, fix bond/breakage.\n\n"
	"Damping is local: against each of the four motions acts the fraction alpha of the force or moment "
	"of its spring, F_d = -alpha |F| v/|v|. Each half of a vibration ends sqrt((1 - alpha)/(1 + alpha)) "
	"times as far as it began. As the sign of the velocity decides, a bond at rest under load chatters "
	"by the steps; dashpots (bond_style parallel) do not.",
	"Compared with the documentation of LIGGGHTS-INL (github.com/idaholab/LIGGGHTS-INL, "
	"doc/gran_cohesion_bond.txt) and with its scripts, not with the program: words, properties, "
	"sections, stiffnesses, stresses, damping. Forces are in total form, as those of bond parallel, "
	"where LIGGGHTS adds up increments. Not supported: bonds with walls, temperatureBreak, "
	"dampingBondSmooth, dissipationBond, druckerPrager, templates with `bonded yes`, and `cohesion "
	"bond/nonlinear`, of which no description is public.\n\n"
	"The contact law acts between bonded particles as well; special_bonds switches it off. Bonds act on "
	"particles that are integrated by fix nve/sphere; a bond that turns by more than 90 degrees between "
	"its ends, or extends over half a periodic box, is an error.",
	NULL
};

TS_STYLE(bond, ts_bond_style, ts_bond_cohesion)
const struct ts_bond_style ts_bond_cohesion = {
	.style = { .name = "cohesion",
		   .kind = TS_KIND_BOND,
		   .ranks = TS_RANKS_OWN,
		   .summary = "the bonds of pair_style gran with `cohesion bond`",
		   .doc = "This bond style is chosen by `pair_style gran ... cohesion bond`, which takes its "
			  "keywords. In the step tsCreateBond, or in each step with `createBondAlways on`, "
			  "all pairs of particles nearer than createDistanceBond (distance of the centres) "
			  "that are not bonded get a bond without force. The type of the bond of particles "
			  "of types a <= b is b (b - 1)/2 + a.\n\n"
			  "A bond is a disc of cement, as that of bond_style parallel, of radius R = "
			  "radiusMultiplierBond min(R_a, R_b), A = pi R^2, I = pi R^4/4, J = pi R^4/2:\n\n"
			  "  N = kn A (r - r0),   dV = -kt A dU_s,   dM_t = -kt J dtheta_n,   dM = -kn I "
			  "dtheta_s\n\n"
			  "Each of the switches tensionStress, compressionStress, shearStress, "
			  "normalTorqueStress and shearTorqueStress removes one of these forces and moments.",
		   .doc_more = more,
		   .example =
			   "fix k1 all property/global normalBondStiffnessPerUnitArea peratomtypepair 1 1e8\n"
			   "fix k2 all property/global tangentialBondStiffnessPerUnitArea peratomtypepair 1 "
			   "4e7\n"
			   "fix k3 all property/global maxSigmaBond peratomtypepair 1 1e5\n"
			   "fix k4 all property/global maxTauBond peratomtypepair 1 1e5\n"
			   "fix k5 all property/global tsCreateBond scalar 1\n"
			   "fix k6 all property/global createDistanceBond peratomtypepair 1 1.05e-3\n"
			   "pair_style gran model hertz tangential history cohesion bond stressBreak on "
			   "dampingBond off\n"
			   "pair_coeff * *",
		   .cite = "D. O. Potyondy, P. A. Cundall, Int. J. Rock Mech. Min. Sci. 41 (2004) 1329",
		   .args = args,
		   .coeff = coeff_rows,
		   .state_size = sizeof(struct cohesive_bond),
		   .saved = saved,
		   .archive = archive,
		   .fingerprint = fingerprint,
		   .init = init,
		   .hook = { [TS_STAGE_POST_INTEGRATE] = ts_bond_turn,
			     [TS_STAGE_PRE_FORCE] = create_bonds,
			     [TS_STAGE_FORCE] = ts_bond_force },
		   .energy = ts_contact_energy_of_bonds,
		   .plan = ts_bond_plan,
		   .fini = ts_bond_fini },
	.coeff_size = sizeof(struct ts_cohesive_coeff),
	.complete = complete,
	.compute = compute,
	.damped = damped,
	.element = element,
	.law = law,
};
