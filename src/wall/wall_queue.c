#include "base/clones.h"
TS_UNROLLED

#include "contact/multicontact.h"
#include "neigh/coincide.h"
#include "rigid/rigid.h"
#include "wall/wall_batch.h"
#include "wall/wall_queue.h"

#include "base/banned.h"

/* ---- inputs of the contact law */

static void load_ends(const struct ts_particles *p, size_t i, const struct ts_wall_contact_point *point,
		      struct ts_wall_ends *e)
{
	*e = (struct ts_wall_ends){ .distance = point->distance,
				    .curvature = point->curvature,
				    .radius = p->radius[i],
				    .mass = ts_rigid_inertial_mass(p, i),
				    .liquid = p->liquid ? p->liquid[i] : 0 };
	for (int d = 0; d < 3; d++) {
		e->n[d] = point->n[d];
		e->v[d] = p->v[i][d] - point->velocity[d];
		e->omega[d] = p->omega ? p->omega[i][d] : 0;
	}
}

void ts_wall_view(const struct ts_wall *w, const struct tsim *sim, size_t k, struct ts_wall_view *view)
{
	const struct ts_particles *p = sim->particles;
	const struct ts_wall_report *r = &w->contacts.report[k];
	size_t i = (size_t)w->contacts.row[k];
	struct ts_wall_contact_point point = { .type = (int)r->type, .curvature = r->curvature };
	struct ts_wall_ends ends;

	for (int d = 0; d < 3; d++) {
		point.n[d] = p->x[i][d] - r->point[d];
		point.velocity[d] = r->velocity[d];
	}
	point.distance = ts_norm(point.n);
	for (int d = 0; d < 3; d++)
		point.n[d] = point.distance > 0 ? point.n[d] / point.distance : 0;
	view->model = ts_wall_model(w, sim);
	view->law = ts_wall_law(w, sim, point.type, p->type[i]);
	load_ends(p, i, &point, &ends);
	ts_wall_ends_touch(&ends, view->model, &view->touch);
	ts_granular_add_bulge(view->model, ts_wall_memory(&w->contacts, k), &view->touch);
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
		torque[d] = view.touch.arm[0] * f.turn[d] + f.roll[d];
	}
}

void ts_wall_queue_touch(const struct ts_wall_queue *q, size_t k, const struct ts_wall_contact_point *point,
			 struct ts_touch *t)
{
	struct ts_wall_ends ends;

	load_ends(q->sim->particles, (size_t)q->w->contacts.row[k], point, &ends);
	ts_wall_ends_touch(&ends, q->model, t);
}

/* ---- results of the contact law */

/* The fourth components: overlap, R*, unused. */
struct result {
	ts_four force, torque, roll;
};

/* Heat flow through a contact: conductance, energy/(time temperature); flow into the surface, energy/time;
 * temperature of the surface. */
struct heat {
	double conductance, flow, temperature;
};

/* Conducts heat between the surface and particle i. */
static struct heat conduct(const struct ts_wall *w, struct tsim *sim, size_t i,
			   const struct ts_wall_contact_point *point)
{
	const struct ts_particles *p = sim->particles;
	const struct ts_heat *heat = point->warm ? ts_heat_of(sim) : NULL;
	double h;
	int types;

	if (!heat || !(point->distance < p->radius[i])) /* no conduction through a contact without touch */
		return (struct heat){ 0 };
	types = point->type * (w->ntypes + 1) + p->type[i];
	h = ts_heat_conductance(w->conductivity[types],
				ts_heat_area_at_wall(&w->area, point->distance, p->radius[i],
						     w->softening[types]));
	return (struct heat){ h, -ts_heat_from_wall(heat, sim, i, h, point->temperature),
			      point->temperature };
}

static void fill_report(struct ts_wall_report *r, const double x[3],
			const struct ts_wall_contact_point *point, const struct result *f,
			const struct heat *heat)
{
	*r = (struct ts_wall_report){ .touching = 1,
				      .overlap = f->force[3],
				      .type = point->type,
				      .mesh = point->mesh,
				      .triangle = point->triangle,
				      .curvature = point->curvature,
				      .conductance = heat->conductance,
				      .heat = heat->flow,
				      .temperature = heat->temperature };
	for (int k = 0; k < 3; k++) {
		r->force[k] = f->force[k];
		r->torque[k] = f->torque[k];
		r->rolling[k] = f->roll[k];
		r->velocity[k] = point->velocity[k];
		r->point[k] = x[k] - point->distance * point->n[k];
	}
}

/* Adds force and heat to the particle and stores the force with the contact, from where ts_wall_finish sums the
 * force on the wall in the order of contacts. */
static void apply_contact(const struct ts_wall_queue *q, size_t at, const struct result *f)
{
	const struct ts_wall *w = q->w;
	const struct ts_wall_contact_point *point = &q->point[at];
	struct ts_particles *p = q->sim->particles;
	size_t k = q->contact[at], i = (size_t)w->contacts.row[k];
	struct heat heat = { 0 };

	if (point->warm)
		heat = conduct(w, q->sim, i, point);
	for (int d = 0; d < 3; d++) {
		p->f[i][d] += f->force[d];
		w->contacts.force[k][d] = f->force[d];
	}
	for (int d = 0; d < 3 && ts_granular_turns(q->model); d++)
		p->torque[i][d] += f->torque[d];
	w->contacts.last[k] = (struct ts_wall_last_contact){
		{ point->n[0], point->n[1], point->n[2] }, f->force[3], f->torque[3], point->type
	};
	for (size_t d = 0; d < 3 && w->store_force; d++)
		((double *)p->column[w->stored].data)[3 * i + d] += f->force[d];
	if (w->contacts.report)
		fill_report(&w->contacts.report[k], p->x[i], point, f, &heat);
}

/* The law of the queued contact `at`. */
static const struct ts_granular_pair *contact_law(const struct ts_wall_queue *q, size_t at)
{
	const struct ts_particles *p = q->sim->particles;
	int type = p->ntypes > 1 ? p->type[q->w->contacts.row[q->contact[at]]] : 1;

	return ts_wall_law(q->w, q->sim, q->point[at].type, type);
}

/* ---- contact by contact */

static void compute_contact(const struct ts_wall_queue *q, size_t at)
{
	size_t k = q->contact[at];
	struct ts_granular_force f;
	struct ts_wall_ends ends;
	struct result result = { 0 };
	struct ts_touch t;

	load_ends(q->sim->particles, (size_t)q->w->contacts.row[k], &q->point[at], &ends);
	ts_wall_ends_touch(&ends, q->model, &t);
	ts_granular_add_bulge(q->model, ts_wall_memory(&q->w->contacts, k), &t);
	ts_granular_contact(q->model, contact_law(q, at), &t, q->sim->clock.dt, !q->sim->run.in_setup,
			    ts_wall_memory(&q->w->contacts, k), &f);
	for (int d = 0; d < 3; d++) {
		result.force[d] = f.force[d];
		result.torque[d] = t.arm[0] * f.turn[d] + f.roll[d];
		result.roll[d] = f.roll[d];
	}
	result.force[3] = t.overlap;
	result.torque[3] = t.r_eff;
	apply_contact(q, at, &result);
}

/* ---- batches */

/* Copies four queued contacts to columns k .. k+3 of the batch. */
TS_INLINE void load_four(const struct ts_wall_queue *q, const size_t at[4], struct ts_wall_batch *b, size_t k)
{
	const struct ts_particles *p = q->sim->particles;
	const struct ts_wall_contacts *c = &q->w->contacts;
	int width = ts_granular_memory(q->model);
	ts_four n[4], v[4], omega[4];

	for (int j = 0; j < 4; j++) {
		const struct ts_wall_contact_point *point = &q->point[at[j]];
		const double *memory = ts_wall_memory(c, q->contact[at[j]]);
		size_t i = (size_t)c->row[q->contact[at[j]]];

		n[j] = TS_FOUR_LOAD(point->n); /* n and, behind it, distance */
		v[j] = TS_FOUR_LOAD(p->v[i]) - TS_FOUR_LOAD(point->velocity);
		v[j][3] = ts_rigid_inertial_mass(p, i);
		omega[j] = TS_FOUR_BROADCAST(0);
		if (p->omega)
			omega[j] = TS_FOUR_LOAD(p->omega[i]);
		omega[j][3] = p->radius[i];
		b->curvature[k + (size_t)j] = point->curvature;
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

/* Copies the n listed contacts to the batch; n is a multiple of 4. */
TS_CLONES static void load_batch(const struct ts_wall_queue *q, const size_t *list, size_t n,
				 struct ts_wall_batch *b)
{
	for (size_t k = 0; k < n; k += 4)
		load_four(q, list + k, b, k);
}

TS_CLONES static void store_batch(const struct ts_wall_queue *q, const size_t *list, size_t n,
				  const struct ts_wall_batch *b, struct result *result)
{
	for (size_t k = 0; k < n; k += 4)
		store_four(q, list + k, b, k, result);
}

/* `left` has a bit for each queued contact that is not computed yet. Lists those with the same law as the
 * first of them, clears their bits, and returns their number. */
static size_t select_same_law(const struct ts_wall_queue *q, uint64_t *left,
			      const struct ts_granular_pair **law, size_t *list)
{
	size_t n = 0;

	for (uint64_t bits = *left; bits; bits &= bits - 1) {
		size_t at = (size_t)__builtin_ctzll(bits);
		const struct ts_granular_pair *its = contact_law(q, at);

		*law = n ? *law : its;
		if (its != *law)
			continue;
		list[n++] = at;
		*left &= ~((uint64_t)1 << at);
	}
	return n;
}

static void compute_batches(const struct ts_wall_queue *q)
{
	uint64_t left = ~(uint64_t)0 >> (TS_BATCH - q->n);
	struct result result[TS_BATCH];
	struct ts_wall_batch b;

	while (left) {
		const struct ts_granular_pair *law = NULL;
		size_t list[TS_BATCH], n = select_same_law(q, &left, &law, list);

		for (; n & 7; n++) /* pad to whole vectors by repeating the last contact */
			list[n] = list[n - 1];
		load_batch(q, list, n, &b);
		q->w->batch(&b, n, q->model, law, q->sim->clock.dt);
		store_batch(q, list, n, &b, result);
	}
	for (size_t at = 0; at < q->n; at++)
		apply_contact(q, at, &result[at]);
}

/* ---- the queue */

void ts_wall_queue_start(struct ts_wall_queue *q, const struct ts_wall *w, struct tsim *sim)
{
	q->w = w;
	q->sim = sim;
	q->model = ts_wall_model(w, sim);
	q->long_ranged = ts_wall_long_ranged(w, sim);
	q->n = 0;
}

/* Displacement of the surface of particle i at the contact point by its other contacts (fix
 * multicontact/halfspace); stored in the contact history while the contact lasts. */
static double surface_bulge(const struct ts_wall_queue *q, size_t k, size_t i,
			    const struct ts_wall_contact_point *point)
{
	double *memory = ts_wall_memory(&q->w->contacts, k) + ts_granular_multi_at(q->model);
	double bulge = ts_multicontact_at_wall(q->sim, i, point->n, point->distance, q->w, k);
	double radius = q->sim->particles->radius[i] + bulge;

	if (point->distance < radius) {
		memory[TS_MULTI_BULGE] = bulge;
		memory[TS_MULTI_RADIUS] = ts_wall_effective_radius(radius, point->curvature);
	}
	return bulge;
}

bool ts_wall_in_range(const struct ts_wall_queue *q, size_t k, const struct ts_wall_contact_point *point)
{
	const struct ts_particles *p = q->sim->particles;
	size_t i = (size_t)q->w->contacts.row[k];
	const struct ts_granular_pair *law = ts_wall_law(q->w, q->sim, point->type, p->type[i]);
	const double *memory = ts_wall_memory(&q->w->contacts, k);
	double radius = p->radius[i], beyond;

	if (q->model->multi)
		return point->distance < radius + surface_bulge(q, k, i, point);
	if (ts_cohesion_bridges(q->model))
		beyond = ts_granular_bridge_reach(q->model, law, (double[2]){ p->liquid[i] },
						  (double[2]){ radius }, true, memory);
	else
		beyond = ts_granular_pull_off_reach(q->model, law,
						    ts_wall_effective_radius(radius, point->curvature),
						    memory);
	return point->distance < radius + beyond;
}

/* An immobile particle feels no force, but conducts heat: where nobody observes the force, or it has no direction. */
static void hold_contact(const struct ts_wall_queue *q, size_t k, const struct ts_wall_contact_point *point)
{
	const struct ts_wall_contacts *c = &q->w->contacts;
	size_t i = (size_t)c->row[k];
	struct heat heat = conduct(q->w, q->sim, i, point);
	struct result none = { 0 };

	ts_wall_contact_zero_force(c, k);
	if (!c->report)
		return;
	none.force[3] = q->sim->particles->radius[i] - point->distance;
	fill_report(&c->report[k], q->sim->particles->x[i], point, &none, &heat);
	c->report[k].touching = 0;
	for (int d = 0; d < 3; d++)
		c->last[k].n[d] = point->n[d];
}

void ts_wall_enqueue_contact(struct ts_wall_queue *q, size_t k, const struct ts_wall_contact_point *point)
{
	const struct ts_wall_contacts *c = &q->w->contacts;
	size_t i = (size_t)c->row[k];
	const bool inside = ts_coincide(point->distance, q->sim->particles->radius[i]);

	c->touching[k] = 1;
	if (!(q->sim->particles->imass[i] > 0 || (point->observed && !inside))) {
		hold_contact(q, k, point);
		return;
	}
	if (inside)
		c->touching[k] = TS_TOUCH_INSIDE;
	if (point != &q->point[q->n])
		q->point[q->n] = *point;
	q->contact[q->n++] = k;
	if (q->n == TS_BATCH)
		ts_wall_queue_end(q);
}

void ts_wall_queue_end(struct ts_wall_queue *q)
{
	if (q->n && q->w->batch && !q->sim->run.in_setup && q->sim->clock.dt > 0)
		compute_batches(q);
	else
		for (size_t at = 0; at < q->n; at++)
			compute_contact(q, at);
	q->n = 0;
}
