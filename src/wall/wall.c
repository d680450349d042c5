#include "wall/wall.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/inline.h"
#include "contact/limits.h"
#include "contact/multicontact.h"
#include "contact/substep_contacts.h"
#include "core/report.h"
#include "insert/template.h"
#include "math/exactsum.h"
#include "particle/columns.h"
#include "particle/prescribed.h"
#include "particle/rank_sums.h"
#include "rigid/rigid.h"

#include "base/banned.h"

/* ---- shape and surfaces ---- */

enum ts_status ts_wall_find(struct ts_instance *self, struct tsim *sim, const struct ts_wall_shape *shape,
			    void *geometry)
{
	struct ts_wall *w = self->state;

	w->by = self;
	w->shape = shape;
	w->geometry = geometry;
	return shape->find(self, sim);
}

enum ts_status ts_wall_check_type(struct ts_instance *self, struct tsim *sim, int64_t type, const char *word)
{
	const struct ts_wall *w = self->state;
	int most = sim->particles->ntypes;

	if (w->given || type <= most || !most) /* `given`: numbers, no material */
		return TS_OK;
	return ts_fail(&sim->error, TS_RANGE, ts_instance_word(self, word),
		       "fix wall/gran: the wall is of type %lld, but create_box made %d", (long long)type,
		       most);
}

int ts_wall_surface_type(const struct ts_wall *w, size_t surface)
{
	return w->shape->surface.type(ts_wall_surface(w, surface));
}

size_t ts_wall_find_surface(const struct ts_wall *w, const struct ts_instance *by)
{
	size_t n = ts_wall_surfaces(w);

	for (size_t k = 0; k < n; k++)
		if (ts_wall_surface(w, k) == by)
			return k;
	return SIZE_MAX;
}

size_t ts_wall_one_surface(const struct ts_wall *w)
{
	(void)w;
	return 1;
}

const struct ts_instance *ts_wall_own_fix(const struct ts_wall *w, size_t surface)
{
	(void)surface;
	return w->by;
}

void ts_wall_own_place(const struct ts_wall *w, size_t k, struct ts_wall_place *out)
{
	*out = (struct ts_wall_place){ .element = (size_t)w->contacts.key[k][1] };
}

size_t ts_wall_meshes(const struct ts_wall *w)
{
	size_t n = ts_wall_surfaces(w);

	return n && ts_wall_surface(w, 0) != w->by ? n : 0;
}

/* ---- arguments of all walls ---- */

/* Adds the particle column force_ID, the name that LIGGGHTS uses. */
static enum ts_status add_force_column(struct ts_instance *self, struct tsim *sim)
{
	struct ts_wall *w = self->state;
	struct ts_str name = { 0 };
	enum ts_status status;

	ts_str_addf(&name, "force_%s", self->id);
	status = name.failed ? ts_nomem(&sim->error)
			     : ts_particles_add_column(sim, ts_str_text(&name), 3,
						       TS_COL_NAMED | TS_COL_RESULT, &w->stored);
	ts_str_release(&name);
	return status;
}

static const struct ts_pair *pair_style_of(const struct tsim *sim)
{
	const struct ts_instance *pair = ts_sim_only(sim, TS_KIND_PAIR);

	return pair ? pair->state : NULL;
}

/* The liquid of particles is stored by the pair style, whose model is known when a run begins (`built`). */
static enum ts_status check_bridges(struct ts_instance *self, struct tsim *sim, bool built)
{
	const struct ts_wall *w = self->state;
	const struct ts_pair *pair = pair_style_of(sim);
	const struct ts_granular_model *m;

	if (!ts_wall_has_law(w, sim))
		return TS_OK;
	m = ts_wall_model(w, sim);
	if (!ts_cohesion_bridges(m))
		return TS_OK;
	if (m->cohesion == TS_COHESION_WASHINO)
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "fix %s: cohesion washino/capillary/viscous is for particles alone; give the "
			       "wall a model with `cohesion easo/capillary/viscous`, or without cohesion",
			       self->style->name);
	if (pair && (pair->model.normal || built) ? ts_cohesion_bridges(&pair->model) : !built)
		return TS_OK;
	return ts_fail(&sim->error, TS_STATE, &self->where,
		       "fix %s: particles are dry: bridges of liquid at a wall need a `pair_style gran ... "
		       "cohesion easo/capillary/viscous`, which keeps the liquid",
		       self->style->name);
}

enum ts_status ts_wall_init(struct ts_instance *self, struct tsim *sim)
{
	struct ts_wall *w = self->state;

	w->sim = sim;
	w->newest = sim->particles->max_tag;
	TS_TRY(ts_granular_words_check(sim, self, "fix wall/gran", &w->words));
	if (w->words.cohesion == TS_WORD_BOND)
		return ts_fail(&sim->error, TS_STATE, ts_instance_word(self, "cohesion"),
			       "fix %s: bonds with walls are not supported; leave `cohesion bond` out: "
			       "particles are bonded to each other by pair_style gran",
			       self->style->name);
	TS_TRY(ts_heat_read_area(sim, "fix wall/gran", w->area_words, &w->area));
	if (w->store_force)
		TS_TRY(add_force_column(self, sim));
	sim->run.needs_lists |= w->list_contacts;
	sim->run.shows_lists |= w->list_contacts;
	w->contacts.want_reports |= w->list_contacts;
	w->own_model = w->given || w->words.normal != TS_NORMAL_OFF;
	if (w->own_model && !w->given)
		w->model = ts_contact_model_of_words(sim, &w->words);
	TS_TRY(check_bridges(self, sim, false));
	if (!w->own_model)
		return TS_OK;
	return ts_granular_turns(&w->model) ? ts_particles_need(sim, TS_NEED(OMEGA) | TS_NEED(TORQUE))
					    : TS_OK;
}

const struct ts_granular_model *ts_wall_model(const struct ts_wall *w, const struct tsim *sim)
{
	return w->own_model ? &w->model : &pair_style_of(sim)->model;
}

const struct ts_granular_pair *ts_wall_law(const struct ts_wall *w, const struct tsim *sim, int wall,
					   int particle)
{
	return w->own_model ? &w->law[wall * (w->ntypes + 1) + particle]
			    : ts_pair_law(pair_style_of(sim), particle, wall);
}

bool ts_wall_has_law(const struct ts_wall *w, const struct tsim *sim)
{
	return w->own_model || pair_style_of(sim);
}

/* Allocates the constants of all pairs of types. */
static enum ts_status reserve_laws(struct ts_instance *self, struct tsim *sim, int type)
{
	struct ts_wall *w = self->state;
	int most = sim->particles->ntypes > type ? sim->particles->ntypes : type;
	size_t n = (size_t)most + 1;

	if (w->law && w->ntypes >= most)
		return TS_OK;
	w->law = ts_arena_alloc(&self->arena, n * n, sizeof *w->law);
	w->conductivity = ts_arena_alloc(&self->arena, n * n, sizeof *w->conductivity);
	w->softening = ts_arena_alloc(&self->arena, n * n, sizeof *w->softening);
	w->ntypes = most;
	return w->law && w->conductivity && w->softening ? TS_OK : ts_nomem(&sim->error);
}

bool ts_wall_heats(const struct tsim *sim)
{
	return ts_heat_of(sim) != NULL;
}

static enum ts_status make_law(struct ts_instance *self, struct tsim *sim, int wall, int particle)
{
	struct ts_wall *w = self->state;
	size_t k = (size_t)(wall * (w->ntypes + 1) + particle);
	double own, other;
	char who[80];

	snprintf(who, sizeof who, "fix %s", self->style->name);
	w->law[k] = w->numbers;
	if (w->own_model && !w->given)
		TS_TRY(ts_contact_law_of_materials(sim, &w->model, particle, wall, who, &self->where,
						   &w->law[k]));
	if (ts_cohesion_bridges(ts_wall_model(w, sim)))
		w->bridges = fmax(w->bridges, 2 * (ts_wall_law(w, sim, wall, particle)->most_gap - 1));
	if (!w->warm || !ts_wall_heats(sim))
		return TS_OK;
	TS_TRY(ts_heat_conductivity(sim, particle, who, &self->where, &own));
	TS_TRY(ts_heat_conductivity(sim, wall, who, &self->where, &other));
	w->conductivity[k] = ts_heat_pair_conductivity(own, other);
	w->softening[k] = 1;
	if (sim->legacy == TS_LEGACY_LIGGGHTS) /* corrects contacts of particles only */
		return TS_OK;
	return ts_heat_softening(sim, ts_heat_of(sim), ts_wall_model(w, sim), wall, particle, &self->where,
				 &w->softening[k]);
}

static enum ts_status make_laws_of_type(struct ts_instance *self, struct tsim *sim, int type)
{
	struct ts_wall *w = self->state;
	int most = ts_template_max_type(sim);

	TS_TRY(check_bridges(self, sim, true));
	w->batch = ts_wall_batch_of(ts_wall_model(w, sim));
	TS_TRY(reserve_laws(self, sim, type));
	for (int t = 1; t <= most; t++)
		TS_TRY(make_law(self, sim, type, t));
	return TS_OK;
}

enum ts_status ts_wall_make_laws(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_wall *w = self->state;
	size_t n = ts_wall_surfaces(w);

	for (size_t k = 0; k < n; k++)
		TS_TRY(make_laws_of_type(self, sim, ts_wall_surface_type(w, k)));
	return TS_OK;
}

void ts_wall_rebuild_start(struct ts_wall *w, const struct tsim *sim, size_t own,
			   struct ts_wall_rebuild *rebuild)
{
	ts_wall_contacts_start(&w->contacts, rebuild,
			       (size_t)ts_granular_memory(ts_wall_model(w, sim)) + own);
}

enum ts_status ts_wall_rebuild_finish(struct ts_wall *w, struct tsim *sim, struct ts_wall_rebuild *rebuild,
				      enum ts_status status)
{
	if (status == TS_OK)
		return ts_wall_contacts_finish(sim, &w->contacts, rebuild);
	ts_wall_contacts_release(&rebuild->old);
	return status;
}

enum ts_status ts_wall_relist(struct ts_instance *self, struct tsim *sim, size_t own, ts_hook_fn *add)
{
	struct ts_wall *w = self->state;
	struct ts_wall_rebuild rebuild;

	ts_wall_rebuild_start(w, sim, own, &rebuild);
	return ts_wall_rebuild_finish(w, sim, &rebuild, add(self, sim));
}

bool ts_wall_long_ranged(const struct ts_wall *w, const struct tsim *sim)
{
	const struct ts_granular_model *m = ts_wall_has_law(w, sim) ? ts_wall_model(w, sim) : NULL;

	return m && (ts_granular_reaches(m) || m->multi);
}

double ts_wall_reach(const struct ts_wall *w, const struct tsim *sim, double radius)
{
	size_t types = (size_t)w->ntypes + 1;
	double most = w->bridges * radius;

	if (!w->law || !ts_wall_long_ranged(w, sim))
		return most;
	if (ts_wall_model(w, sim)->multi)
		return TS_BULGE_MOST * radius;
	if (!ts_normal_sticks(ts_wall_model(w, sim)))
		return most;
	if (!w->own_model)
		return ts_pair_reach(sim, 4 * radius); /* two spheres of this radius have R* = 2 R */
	/* adhesion to a concave surface reaches farther: R* = 2 R bounds it for radii of curvature of at
	 * least 2 R */
	for (size_t k = 0; k < types * types; k++)
		if (w->law[k].kn > 0)
			most = fmax(most, ts_jkr_reach(&w->law[k], 2 * radius));
	return most;
}

void ts_wall_start(struct ts_wall *w, struct tsim *sim)
{
	const struct ts_particles *p = sim->particles;

	w->force[0] = w->force[1] = w->force[2] = 0;
	w->unsummed = false;
	if (w->store_force && p->n)
		memset(p->column[w->stored].data, 0, p->n * 3 * sizeof(double));
}

void ts_wall_finish(struct ts_wall *w)
{
	const struct ts_wall_contacts *c = &w->contacts;
	const uint8_t *inside = c->n ? memchr(c->touching, TS_TOUCH_INSIDE, c->n) : NULL;

	w->unsummed = true;
	w->inside = inside ? (size_t)(inside - c->touching) : TS_WALL_NONE;
}

/* Adds the sums of the forces on the particles; of a contact that does not touch it is 0. */
static void add_sums(struct ts_wall *w, const double sum[3])
{
	ts_sub(w->force, sum, w->force);
	w->unsummed = false;
}

const double *ts_wall_force(struct ts_wall *w)
{
	const struct ts_wall_contacts *c = &w->contacts;
	double sum[3] = { 0 };

	for (int d = 0; w->unsummed && c->n && d < 3; d++)
		sum[d] = ts_exactsum_of(&c->force[0][d], c->n, 3);
	if (w->unsummed)
		add_sums(w, sum);
	return w->force;
}

enum ts_status ts_wall_join(struct ts_instance *self, struct tsim *sim)
{
	struct ts_wall *w = self->state;
	double sum[3];

	if (!w->unsummed)
		return TS_OK;
	TS_TRY(ts_rank_sums(sim, (const double *)w->contacts.force, w->contacts.n, 3, 3, sum));
	add_sums(w, sum);
	return TS_OK;
}

size_t ts_wall_history(const struct ts_wall *w, const struct tsim *sim)
{
	return ts_wall_has_law(w, sim) ? (size_t)ts_granular_memory(ts_wall_model(w, sim)) : 0;
}

static enum ts_status check_pair_coeffs(struct ts_instance *self, struct tsim *sim, int type)
{
	const struct ts_wall *w = self->state;
	const struct ts_instance *pair = ts_sim_only(sim, TS_KIND_PAIR);
	const struct ts_pair *state;

	if (w->own_model)
		return TS_OK;
	if (!pair)
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "fix %s takes the contact law of the pair_style, and there is none",
			       self->style->name);
	state = pair->state;
	if (type > state->ntypes)
		return ts_fail(&sim->error, TS_RANGE, ts_instance_word(self, "type"),
			       "fix %s: type %d does not exist, create_box made %d", self->style->name, type,
			       state->ntypes);
	for (size_t i = 0; i < sim->particles->n; i++) {
		int met = sim->particles->type[i];

		if (ts_in_group(sim->particles, i, self->group) &&
		    !state->coeffs.given[met * (state->ntypes + 1) + type])
			return ts_fail(&sim->error, TS_STATE, &self->where,
				       "a wall of type %d meets particles of type %d, but there is no "
				       "`pair_coeff %d %d ...`",
				       type, met, met, type);
	}
	return TS_OK;
}

static enum ts_status plan_type(struct ts_instance *self, struct tsim *sim, int type,
				struct ts_plan_report *plan)
{
	const struct ts_wall *w = self->state;
	struct ts_lightest *lightest;
	double speed = ts_prescribed_max_speed(sim, self->group);
	enum ts_status status = TS_OK;
	char what[64];

	TS_TRY(check_pair_coeffs(self, sim, type));
	TS_TRY(ts_multicontact_check(sim, ts_wall_model(w, sim), &self->where));
	TS_TRY(ts_substep_check(sim, ts_wall_model(w, sim), ts_instance_word(self, "located")));
	if (w->exact) /* no contact is stepped through */
		return TS_OK;
	lightest = ts_lightest(sim, self->group);
	if (!lightest)
		return ts_nomem(&sim->error);
	for (int t = 1; t <= sim->particles->ntypes && status == TS_OK; t++) {
		struct ts_contact_case c = { ts_wall_model(w, sim),
					     ts_wall_law(w, sim, type, t),
					     lightest[t].radius[0],
					     1 / lightest[t].inverse_mass[0],
					     0,
					     speed };

		snprintf(what, sizeof what, "of type %d with wall %.24s", t, self->id);
		if (lightest[t].inverse_mass[0] > 0)
			status = ts_contact_report_limits(plan, sim, &self->where, &c, what);
	}
	ts_free(lightest);
	return status;
}

enum ts_status ts_wall_plan(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *plan)
{
	const struct ts_wall *w = self->state;
	size_t n = ts_wall_surfaces(w);

	if (w->shape->check_law)
		TS_TRY(w->shape->check_law(self, sim));
	if (w->shape->plan && !plan->limits_only)
		w->shape->plan(self, sim);
	for (size_t k = 0; k < n; k++)
		TS_TRY(plan_type(self, sim, ts_wall_surface_type(w, k), plan));
	return TS_OK;
}

size_t ts_wall_deepest_contact(const struct ts_wall *w, const struct tsim *sim, size_t k, size_t *next,
			       double *distance, int *type)
{
	const struct ts_wall_contacts *c = &w->contacts;
	size_t first = k;

	*distance = INFINITY;
	for (; k < c->n && c->row[k] == c->row[first]; k++) {
		int of;
		double d = w->shape->distance(w, sim, k, &of);

		if (d < *distance) {
			*distance = d;
			*type = of;
		}
	}
	*next = k;
	return (size_t)c->row[first];
}

bool ts_wall_case(const struct ts_wall *w, const struct tsim *sim, size_t k, struct ts_contact_case *out)
{
	const struct ts_wall_last_contact *last = &w->contacts.last[k];
	size_t i = (size_t)w->contacts.row[k];

	if (!(last->overlap > 0) || !(sim->particles->imass[i] > 0))
		return false;
	*out = (struct ts_contact_case){
		ts_wall_model(w, sim), ts_wall_law(w, sim, last->type, sim->particles->type[i]),
		last->r_eff,	       1 / sim->particles->imass[i],
		last->overlap,	       0
	};
	return true;
}

enum ts_status ts_wall_eval_force(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	(void)sim;
	ts_scale(1, ts_wall_force(self->state), out->data);
	return TS_OK;
}

const char *const ts_wall_force_names[] = { "fx", "fy", "fz" };

enum ts_status ts_wall_eval_contacts(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	struct ts_wall *w = self->state;
	const struct ts_particles *p = sim->particles;

	TS_TRY(ts_wall_contacts_connect(w->sim, &w->contacts));
	TS_TRY(ts_table_resize(out, p->n, TS_WALL_CONTACT_COLUMNS));
	if (p->n)
		memset(out->data, 0, p->n * TS_WALL_CONTACT_COLUMNS * sizeof *out->data);
	for (size_t k = 0; k < w->contacts.n; k++) {
		const struct ts_wall_report *r = ts_wall_report(&w->contacts, k);
		size_t i = (size_t)w->contacts.row[k];
		double *to = out->data + i * TS_WALL_CONTACT_COLUMNS;

		if (!r || i >= p->n)
			continue;
		to[0] = 1;
		for (int d = 0; d < 3; d++) {
			to[1 + d] = r->force[d];
			to[4 + d] = r->point[d];
		}
		to[7] = p->radius[i];
	}
	return TS_OK;
}

bool ts_wall_gives(const struct ts_instance *self, const struct ts_value *value)
{
	return value->eval != ts_wall_eval_contacts || ((const struct ts_wall *)self->state)->list_contacts;
}

const char *const ts_wall_contact_names[] = { "touches", "fx", "fy", "fz", "x", "y", "z", "radius" };

struct ts_wall *ts_walls_next(const struct tsim *sim, size_t *k, const struct ts_instance **by)
{
	const struct ts_instance *inst = ts_sim_next_of(sim, TS_KIND_FIX, TS_FAMILY_WALL, k);

	if (by)
		*by = inst;
	return inst ? inst->state : NULL;
}

enum ts_status ts_walls_connect(struct tsim *sim)
{
	struct ts_wall *w;

	for (size_t k = 0; (w = ts_walls_next(sim, &k, NULL));)
		TS_TRY(ts_wall_contacts_connect(sim, &w->contacts));
	return TS_OK;
}

void ts_walls_want_reports(const struct tsim *sim)
{
	struct ts_wall *w;

	for (size_t k = 0; (w = ts_walls_next(sim, &k, NULL));)
		w->contacts.want_reports = true;
}

enum ts_status ts_wall_archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a)
{
	struct ts_wall *w = self->state;

	ts_wall_force(w);
	TS_TRY(ts_archive_fixed(a, "force", TS_SAVED_F64, w->force, 3));
	if (w->store_force)
		TS_TRY(ts_particles_archive_column(a, sim, sim->particles->column[w->stored].name,
						   w->stored));
	return ts_wall_contacts_archive(a, sim, &w->contacts);
}

static enum ts_status give_contacts(struct ts_instance *self, struct tsim *sim, bool results,
				    const struct ts_leaving *leaving, struct ts_carried *out)
{
	(void)results;
	ts_wall_force(self->state);
	return ts_wall_contacts_give(sim, &((struct ts_wall *)self->state)->contacts, leaving, out);
}

static enum ts_status take_contacts(struct ts_instance *self, struct tsim *sim, const struct ts_carried *rows)
{
	return ts_wall_contacts_take(sim, &((struct ts_wall *)self->state)->contacts, rows);
}

const struct ts_carrier ts_wall_carrier = { .give = give_contacts, .take = take_contacts };

void ts_wall_fini(struct ts_instance *self)
{
	struct ts_wall *w = self->state;

	ts_wall_contacts_release(&w->contacts);
	ts_free(w->observers);
	ts_free(w->touching);
	ts_free(w->brief);
	ts_parcel_release(&w->shared);
}
