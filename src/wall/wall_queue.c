#include "base/clones.h"
TS_UNROLLED

#include "contact/multicontact.h"
#include "neigh/coincide.h"
#include "rigid/rigid.h"
#include "wall/wall_batch.h"
#include "wall/wall_queue.h"

#include "base/banned.h"

/* ---- a contact as its laws see it */

TS_INLINE double mass_of(const struct ts_particles *p, size_t i)
{
	/* a member of a rigid body has the mass of the body */
	return ts_rigid_member(p, i) ? 1 / p->imass[i] : p->mass[i];
}

static void ends_of(const struct ts_particles *p, size_t i, const struct ts_wall_contact_point *spot,
		    struct ts_wall_ends *e)
{
	*e = (struct ts_wall_ends){ .distance = spot->distance,
				    .curvature = spot->curvature,
				    .radius = p->radius[i],
				    .mass = mass_of(p, i),
				    .liquid = p->liquid ? p->liquid[i] : 0 };
	for (int d = 0; d < 3; d++) {
		e->n[d] = spot->n[d];
		e->v[d] = p->v[i][d] - spot->velocity[d];
		e->omega[d] = p->omega ? p->omega[i][d] : 0;
	}
}

void ts_wall_view(const struct ts_wall *w, const struct tsim *sim, size_t k, struct ts_wall_view *view)
{
	const struct ts_particles *p = sim->particles;
	const struct ts_wall_report *r = &w->contacts.report[k];
	size_t i = (size_t)w->contacts.row[k];
	struct ts_wall_contact_point spot = { .type = (int)r->type, .curvature = r->curvature };
	struct ts_wall_ends ends;

	for (int d = 0; d < 3; d++) {
		spot.n[d] = p->x[i][d] - r->point[d];
		spot.velocity[d] = r->velocity[d];
	}
	spot.distance = ts_norm(spot.n);
	for (int d = 0; d < 3; d++)
		spot.n[d] = spot.distance > 0 ? spot.n[d] / spot.distance : 0;
	view->model = ts_wall_model(w, sim);
	view->law = ts_wall_law(w, sim, spot.type, p->type[i]);
	ends_of(p, i, &spot, &ends);
	ts_wall_ends_touch(&ends, view->model, &view->touch);
	ts_granular_stand_out(view->model, ts_wall_memory(&w->contacts, k), &view->touch);
}

void ts_wall_force_now(const struct ts_wall *w, const struct tsim *sim, size_t k, double force[3],
		       double torque[3])
{
	double memory[TS_GRANULAR_MEMORY + 1] = { 0 };
	struct ts_granular_force f;
	struct ts_wall_view view;

	for (size_t m = 0; m < ts_wall_history(w, sim); m++)
		memory[m] = ts_wall_memory(&w->contacts, k)[m];
	ts_wall_view(w, sim, k, &view);
	ts_granular_contact(view.model, view.law, &view.touch, sim->clock.dt, false, memory, &f);
	for (int d = 0; d < 3; d++) {
		force[d] = f.force[d];
		torque[d] = view.touch.arm[0] * f.turn[d];
	}
}

/* ---- what a contact does */

/* The fourth numbers: overlap, R*, nothing. */
struct result {
	ts_four force, torque, roll;
};

static void report(struct ts_wall_report *r, const double x[3], const struct ts_wall_contact_point *spot,
		   const struct result *f)
{
	*r = (struct ts_wall_report){ .touching = 1,
				      .overlap = f->force[3],
				      .type = spot->type,
				      .mesh = spot->mesh,
				      .triangle = spot->triangle,
				      .curvature = spot->curvature };
	for (int k = 0; k < 3; k++) {
		r->force[k] = f->force[k];
		r->torque[k] = f->torque[k];
		r->rolling[k] = f->roll[k];
		r->velocity[k] = spot->velocity[k];
		r->point[k] = x[k] - spot->distance * spot->n[k];
	}
}

/* The force is noted, too; the sum over all contacts, in their order, is ts_wall_finish's. */
static void act(const struct ts_wall_queue *q, size_t at, const struct result *f)
{
	const struct ts_wall *w = q->w;
	const struct ts_wall_contact_point *spot = &q->spot[at];
	struct ts_particles *p = q->sim->particles;
	size_t k = q->contact[at], i = (size_t)w->contacts.row[k];

	for (int d = 0; d < 3; d++) {
		p->f[i][d] += f->force[d];
		w->contacts.force[k][d] = f->force[d];
	}
	for (int d = 0; d < 3 && ts_granular_turns(q->model); d++)
		p->torque[i][d] += f->torque[d];
	w->contacts.seen[k] = (struct ts_wall_seen){
		{ spot->n[0], spot->n[1], spot->n[2] }, f->force[3], f->torque[3], spot->type
	};
	for (size_t d = 0; d < 3 && w->store_force; d++)
		((double *)p->column[w->stored].data)[3 * i + d] += f->force[d];
	if (w->contacts.report)
		report(&w->contacts.report[k], p->x[i], spot, f);
}

/* The law of the contact that stands at `at`. */
static const struct ts_granular_pair *law_of(const struct ts_wall_queue *q, size_t at)
{
	const struct ts_particles *p = q->sim->particles;
	int type = p->ntypes > 1 ? p->type[q->w->contacts.row[q->contact[at]]] : 1;

	return ts_wall_law(q->w, q->sim, q->spot[at].type, type);
}

/* ---- one after the other */

static void work(const struct ts_wall_queue *q, size_t at)
{
	size_t k = q->contact[at];
	struct ts_granular_force f;
	struct ts_wall_ends ends;
	struct result result = { 0 };
	struct ts_touch t;

	ends_of(q->sim->particles, (size_t)q->w->contacts.row[k], &q->spot[at], &ends);
	ts_wall_ends_touch(&ends, q->model, &t);
	ts_granular_stand_out(q->model, ts_wall_memory(&q->w->contacts, k), &t);
	ts_granular_contact(q->model, law_of(q, at), &t, q->sim->clock.dt, !q->sim->run.in_setup,
			    ts_wall_memory(&q->w->contacts, k), &f);
	for (int d = 0; d < 3; d++) {
		result.force[d] = f.force[d];
		result.torque[d] = t.arm[0] * f.turn[d] + f.roll[d];
		result.roll[d] = f.roll[d];
	}
	result.force[3] = t.overlap;
	result.torque[3] = t.r_eff;
	act(q, at, &result);
}

/* ---- in columns */

/* Four contacts of the queue become numbers k .. k+3 of the batch. */
TS_INLINE void load_four(const struct ts_wall_queue *q, const size_t at[4], struct ts_wall_batch *b, size_t k)
{
	const struct ts_particles *p = q->sim->particles;
	const struct ts_wall_contacts *c = &q->w->contacts;
	int width = ts_granular_memory(q->model);
	ts_four n[4], v[4], omega[4];

	for (int j = 0; j < 4; j++) {
		const struct ts_wall_contact_point *spot = &q->spot[at[j]];
		const double *memory = ts_wall_memory(c, q->contact[at[j]]);
		size_t i = (size_t)c->row[q->contact[at[j]]];

		n[j] = TS_FOUR_AT(spot->n); /* and the distance */
		v[j] = TS_FOUR_AT(p->v[i]) - TS_FOUR_AT(spot->velocity);
		v[j][3] = mass_of(p, i);
		omega[j] = TS_FOUR_ALL(0);
		if (p->omega)
			omega[j] = TS_FOUR_AT(p->omega[i]);
		omega[j][3] = p->radius[i];
		b->curvature[k + (size_t)j] = spot->curvature;
		for (int d = 0; d < width; d++)
			b->memory[d][k + (size_t)j] = memory[d];
	}
	ts_four_columns(n, b->n, k);
	ts_four_columns(v, b->v, k);
	ts_four_columns(omega, b->omega, k);
}

TS_INLINE void store_four(const struct ts_wall_queue *q, const size_t at[4], const struct ts_wall_batch *b,
			  size_t k, struct result *result)
{
	int width = ts_granular_memory(q->model);
	ts_four force[4], torque[4], roll[4];

	ts_four_rows(b->force, k, force);
	ts_four_rows(b->torque, k, torque);
	ts_four_rows(b->roll, k, roll);
	for (int j = 0; j < 4; j++) {
		double *memory = ts_wall_memory(&q->w->contacts, q->contact[at[j]]);

		result[at[j]] = (struct result){ force[j], torque[j], roll[j] };
		for (int d = 0; d < width; d++)
			memory[d] = b->memory[d][k + (size_t)j];
	}
}

/* The n listed contacts, whole vectors of them. */
TS_CLONES static void load(const struct ts_wall_queue *q, const size_t *list, size_t n,
			   struct ts_wall_batch *b)
{
	for (size_t k = 0; k < n; k += 4)
		load_four(q, list + k, b, k);
}

TS_CLONES static void store(const struct ts_wall_queue *q, const size_t *list, size_t n,
			    const struct ts_wall_batch *b, struct result *result)
{
	for (size_t k = 0; k < n; k += 4)
		store_four(q, list + k, b, k, result);
}

/* Lists which of those that `left` has bits of have the law of the first of them, and takes their bits;
 * returns how many there are. */
static size_t alike(const struct ts_wall_queue *q, uint64_t *left, const struct ts_granular_pair **law,
		    size_t *list)
{
	size_t n = 0;

	for (uint64_t bits = *left; bits; bits &= bits - 1) {
		size_t at = (size_t)__builtin_ctzll(bits);
		const struct ts_granular_pair *its = law_of(q, at);

		*law = n ? *law : its;
		if (its != *law)
			continue;
		list[n++] = at;
		*left &= ~((uint64_t)1 << at);
	}
	return n;
}

static void work_in_columns(const struct ts_wall_queue *q)
{
	uint64_t left = ~(uint64_t)0 >> (TS_BATCH - q->n);
	struct result result[TS_BATCH];
	struct ts_wall_batch b;

	while (left) {
		const struct ts_granular_pair *law = NULL;
		size_t list[TS_BATCH], n = alike(q, &left, &law, list);

		for (; n & 7; n++) /* whole vectors: the last contact again and again */
			list[n] = list[n - 1];
		load(q, list, n, &b);
		q->w->batch(&b, n, q->model, law, q->sim->clock.dt);
		store(q, list, n, &b, result);
	}
	for (size_t at = 0; at < q->n; at++)
		act(q, at, &result[at]);
}

/* ---- the queue */

void ts_wall_queue_start(struct ts_wall_queue *q, const struct ts_wall *w, struct tsim *sim)
{
	q->w = w;
	q->sim = sim;
	q->model = ts_wall_model(w, sim);
	q->sticks = ts_wall_pulls(w, sim);
	q->n = 0;
}

/* How far the surface stands out at the spot: the contact remembers it while it lasts. */
static double stand_out(const struct ts_wall_queue *q, size_t k, size_t i,
			const struct ts_wall_contact_point *spot)
{
	double *memory = ts_wall_memory(&q->w->contacts, k) + ts_granular_multi_at(q->model);
	double bulge = ts_multicontact_at_wall(q->sim, i, spot->n, spot->distance, q->w);
	double radius = q->sim->particles->radius[i] + bulge;

	if (spot->distance < radius) {
		memory[TS_MULTI_BULGE] = bulge;
		memory[TS_MULTI_RADIUS] = ts_wall_effective_radius(radius, spot->curvature);
	}
	return bulge;
}

bool ts_wall_sticks(const struct ts_wall_queue *q, size_t k, const struct ts_wall_contact_point *spot)
{
	const struct ts_particles *p = q->sim->particles;
	size_t i = (size_t)q->w->contacts.row[k];
	const struct ts_granular_pair *law = ts_wall_law(q->w, q->sim, spot->type, p->type[i]);
	const double *memory = ts_wall_memory(&q->w->contacts, k);
	double radius = p->radius[i], beyond;

	if (q->model->multi)
		return spot->distance < radius + stand_out(q, k, i, spot);
	if (ts_cohesion_bridges(q->model))
		beyond = ts_granular_bridged(q->model, law, (double[2]){ p->liquid[i] },
					     (double[2]){ radius }, true, memory);
	else
		beyond = ts_granular_beyond(q->model, law, ts_wall_effective_radius(radius, spot->curvature),
					    memory);
	return spot->distance < radius + beyond;
}

static void conduct(const struct ts_wall *w, struct tsim *sim, size_t i,
		    const struct ts_wall_contact_point *spot)
{
	const struct ts_particles *p = sim->particles;
	const struct ts_heat *heat = ts_heat_of(sim);
	double k, area;

	if (!heat || !(spot->distance < p->radius[i])) /* they may stick beyond their touch */
		return;
	k = w->conductivity[spot->type * (w->ntypes + 1) + p->type[i]];
	area = ts_heat_area_at_wall(&w->area, spot->distance, p->radius[i]);
	ts_heat_from_wall(heat, sim, i, ts_heat_conductance(k, area), spot->temperature);
}

void ts_wall_enqueue_contact(struct ts_wall_queue *q, size_t k, const struct ts_wall_contact_point *spot)
{
	const struct ts_wall_contacts *c = &q->w->contacts;
	size_t i = (size_t)c->row[k];

	c->touching[k] = 1;
	if (spot->warm)
		conduct(q->w, q->sim, i, spot);
	if (!(q->sim->particles->imass[i] > 0 || spot->sums)) {
		ts_wall_contact_rest(c, k);
		return;
	}
	if (ts_coincide(spot->distance, q->sim->particles->radius[i]))
		c->touching[k] = TS_TOUCH_INSIDE;
	q->spot[q->n] = *spot;
	q->contact[q->n++] = k;
	if (q->n == TS_BATCH)
		ts_wall_queue_end(q);
}

void ts_wall_queue_end(struct ts_wall_queue *q)
{
	if (q->n && q->w->batch && !q->sim->run.in_setup && q->sim->clock.dt > 0)
		work_in_columns(q);
	else
		for (size_t at = 0; at < q->n; at++)
			work(q, at);
	q->n = 0;
}
