/* New particles of the fixes that insert: positions of their spheres, creation. */
#include "insert/insertion.h"

#include <inttypes.h>

#include "core/ranks.h"
#include "math/constants.h"
#include "math/quaternion.h"
#include "math/rigid_turn.h"
#include "math/vec3.h"
#include "particle/columns.h"
#include "particle/division.h"
#include "particle/particles.h"
#include "particle/quantity.h"
#include "particle/sphere_shape.h"

#include "base/banned.h"

static const struct ts_template *template_of(const struct ts_new_particle *one)
{
	return one->template ? one->template->state : NULL;
}

static const struct ts_clump *clump_of(const struct ts_new_particle *one)
{
	return one->template ? template_of(one)->clump : NULL;
}

size_t ts_insertion_spheres(const struct ts_new_particle *one)
{
	return clump_of(one) ? clump_of(one)->n : 1;
}

double ts_insertion_sphere(const struct ts_new_particle *one, size_t k, double x[3])
{
	const struct ts_template *t = template_of(one);
	double m[3][3], d[3], arm[3];

	ts_scale(1, one->x, x);
	if (!clump_of(one))
		return one->radius;
	ts_sub(t->clump->sphere[k].x, t->origin, d);
	ts_quaternion_matrix(one->q, m);
	ts_rotate(m, d, arm);
	ts_add(x, arm, x);
	return t->clump->sphere[k].radius;
}

double ts_insertion_sphere_reach(const struct ts_new_particle *one, size_t k)
{
	const struct ts_template *t = template_of(one);

	if (!clump_of(one))
		return one->radius;
	return sqrt(ts_distance2(t->clump->sphere[k].x, t->origin)) + t->clump->sphere[k].radius;
}

/* density * volume, with the order of operations and the value of pi of LIGGGHTS, so that masses are
 * equal. */
static double sphere_mass(const struct tsim *sim, const struct ts_new_particle *one, double r)
{
	if (sim->dimension == 2)
		return one->density * ts_particle_volume(sim, r);
	if (clump_of(one)) /* 4 pi / 3 of LIGGGHTS */
		return one->density * (r * r * r * 4.18879020479);
	return one->density * (r * r * r * 4 * TS_PI / 3);
}

double ts_insertion_mass(const struct tsim *sim, const struct ts_new_particle *one)
{
	return clump_of(one) ? template_of(one)->mass : sphere_mass(sim, one, one->radius);
}

static void set_sphere(struct ts_instance *self, struct tsim *sim, const struct ts_new_particle *one,
		       const struct ts_new_sphere *sphere)
{
	struct ts_particles *p = sim->particles;
	const size_t i = (size_t)sphere->row;

	p->type[i] = one->type;
	p->mask[i] |= one->mask | 1u << self->group;
	p->radius[i] = sphere->radius;
	p->mass[i] = sphere_mass(sim, one, sphere->radius);
	p->imass[i] = 1 / p->mass[i];
	for (int d = 0; d < 3; d++) {
		p->x[i][d] = sphere->x[d];
		p->v[i][d] = one->v[d];
		if (p->omega)
			p->omega[i][d] = one->omega[d];
	}
}

/* Distributes the mass of a rigid clump among its spheres, which overlap, by their volumes. */
static void distribute_mass(struct ts_particles *p, double mass, size_t from, size_t n)
{
	double sum = 0;

	for (size_t i = from; i < from + n; i++)
		sum += p->mass[i];
	for (size_t i = from; i < from + n; i++)
		p->mass[i] *= mass / sum;
}

static enum ts_status create_body(struct ts_instance *self, struct tsim *sim,
				  const struct ts_new_particle *one, size_t from, size_t n)
{
	const struct ts_template *t = one->template->state;
	const struct ts_instance *fix = NULL;
	struct ts_body body = t->body;
	int32_t *row;
	enum ts_status status;

	for (size_t k = 0; k < sim->instances[TS_KIND_FIX].n; k++)
		if (ts_streq(sim->instances[TS_KIND_FIX].item[k]->style->name, "multisphere"))
			fix = sim->instances[TS_KIND_FIX].item[k];
	if (!fix)
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "fix %s: rigid clumps of fix %s need `fix ID all multisphere`",
			       self->style->name, one->template->id);
	ts_quaternion_multiply(one->q, t->body.q, body.q);
	ts_quaternion_normalise(body.q);
	for (int i = 0; i < 3; i++) {
		body.x[i] = one->x[i];
		body.v[i] = one->v[i];
		body.omega[i] = one->omega[i];
	}
	ts_rigid_angular_momentum(body.q, body.inertia, one->omega, body.spin);
	distribute_mass(sim->particles, body.mass, from, n);
	row = ts_alloc(n, sizeof *row);
	if (!row)
		return ts_nomem(&sim->error);
	for (size_t k = 0; k < n; k++)
		row[k] = (int32_t)(from + k);
	status = ts_rigid_add(sim, &body, ts_rigid_owner(fix->id), row, n);
	ts_free(row);
	return status;
}

/* The spheres of all particles that found a place, in the order of their identities. */
static enum ts_status list_spheres(struct ts_insertion *s, struct tsim *sim)
{
	size_t n = 0;

	for (size_t k = 0; k < s->list.n; k++)
		n += s->list.item[k].placed ? ts_insertion_spheres(&s->list.item[k]) : 0;
	if (TS_GROW(s->sphere, s->sphere_capacity, n) != TS_OK)
		return ts_nomem(&sim->error);
	s->spheres = 0;
	for (size_t k = 0; k < s->list.n; k++) {
		const struct ts_new_particle *one = &s->list.item[k];

		for (size_t m = 0; one->placed && m < ts_insertion_spheres(one); m++) {
			struct ts_new_sphere *sphere = &s->sphere[s->spheres++];

			sphere->radius = ts_insertion_sphere(one, m, sphere->x);
		}
	}
	return TS_OK;
}

/* Adds rows for the spheres of this rank. */
static enum ts_status add_rows(struct ts_insertion *s, struct tsim *sim, size_t *from)
{
	struct ts_particles *p = sim->particles;
	size_t own = 0;

	for (size_t k = 0; k < s->spheres; k++) {
		bool is = !sim->division || ts_division_owns(sim, s->sphere[k].x);

		s->sphere[k].row = is ? (int32_t)own : -1;
		own += is;
	}
	TS_TRY(ts_division_begin_new(sim));
	TS_TRY(ts_particles_add_some(sim, own, s->spheres, from));
	for (size_t k = 0; k < s->spheres; k++) {
		if (s->sphere[k].row < 0)
			continue;
		s->sphere[k].row += (int32_t)*from;
		p->tag[s->sphere[k].row] = p->max_tag - (int32_t)(s->spheres - 1 - k);
	}
	ts_division_end_new(sim, s->spheres);
	return TS_OK;
}

/* `first`: number of its first sphere. */
static enum ts_status create_particle(struct ts_instance *self, struct tsim *sim,
				      const struct ts_new_particle *one, size_t first)
{
	const struct ts_template *t = template_of(one);
	struct ts_insertion *s = self->state;
	const struct ts_new_sphere *sphere = s->sphere + first;

	for (size_t k = 0; k < ts_insertion_spheres(one); k++)
		if (sphere[k].row >= 0)
			set_sphere(self, sim, one, &sphere[k]);
	s->mass += ts_insertion_mass(sim, one);
	s->inserted++;
	return t && t->rigid ? create_body(self, sim, one, (size_t)sphere->row, t->clump->n) : TS_OK;
}

static enum ts_status set_property(struct ts_instance *self, struct tsim *sim, size_t from)
{
	struct ts_insertion *s = self->state;
	const struct ts_word *name = s->property_words.word;
	const struct ts_column *column;
	size_t k;

	if (!s->property_words.n)
		return TS_OK;
	column = ts_particles_named_column(sim->particles, name->text, &k);
	if (!column)
		return ts_fail(&sim->error, TS_UNKNOWN, &name->place,
			       "fix %s: set_property: no fix property/atom gives particles '%s'",
			       self->style->name, name->text);
	for (size_t i = from; i < sim->particles->n; i++)
		((double *)column->data)[i * column->width + k] = s->property;
	return TS_OK;
}

static void print_insertion(struct ts_instance *self, struct tsim *sim, size_t made, double mass)
{
	struct ts_insertion *s = self->state;

	if (s->verbose)
		ts_log(&sim->log,
		       "INFO: Particle insertion %s: inserted %zu particle templates (mass %e) at step "
		       "%" PRId64 "\n - a total of %" PRId64
		       " particle templates (mass %e) inserted so far.\n",
		       self->id, made, mass, sim->clock.step, s->inserted, s->mass);
	if (made >= s->list.n || s->warned)
		return;
	s->warned = true;
	if (ts_ranks_first(sim))
		ts_warn(&sim->log, &self->where,
			"fix %s %s: fewer insertions than requested: %zu of %zu particles found a place at "
			"step %" PRId64 " with %" PRId64
			" tries each on average; raise maxattempt, ask for less, "
			"or give them more room (said once)",
			self->style->name, self->id, made, s->list.n, sim->clock.step, s->maxattempt);
}

enum ts_status ts_insertion_make(struct ts_instance *self, struct tsim *sim, size_t *from)
{
	struct ts_insertion *s = self->state;
	double before = s->mass;
	size_t made = 0, first = 0;

	TS_TRY(list_spheres(s, sim));
	TS_TRY(add_rows(s, sim, from));
	for (size_t k = 0; k < s->list.n; k++) {
		if (!s->list.item[k].placed)
			continue;
		TS_TRY(create_particle(self, sim, &s->list.item[k], first));
		first += ts_insertion_spheres(&s->list.item[k]);
		made++;
	}
	TS_TRY(set_property(self, sim, *from));
	if (s->list.n)
		print_insertion(self, sim, made, s->mass - before);
	return TS_OK;
}
