#include "load/servo_response.h"

#include <math.h>

#include "insert/template.h"
#include "law/granular_limit.h"
#include "particle/particles.h"

#include "base/banned.h"

/* The smallest particle of a type, existing or to be inserted; radius infinite: there is none. */
struct smallest {
	double radius, mass;
};

static struct smallest smallest_of(const struct tsim *sim, int type)
{
	const struct ts_particles *p = sim->particles;
	struct smallest s = { INFINITY, 0 };
	double radius, inverse_mass = ts_template_inverse_mass(sim, type, &radius);

	for (size_t i = 0; i < p->n; i++)
		if (p->type[i] == type && p->radius[i] < s.radius)
			s = (struct smallest){ p->radius[i], p->mass[i] };
	if (inverse_mass > 0 && radius < s.radius)
		s = (struct smallest){ radius, 1 / inverse_mass };
	return s;
}

static bool inserts_particles(const struct tsim *sim)
{
	bool some = false;

	for (int t = 1; t <= sim->particles->ntypes; t++)
		some |= ts_template_inverse_mass(sim, t, NULL) > 0;
	return some;
}

/* ---- contacts ---- */

/* Stiffness and damping of one contact under this force. */
static struct ts_servo_contacts contact_response(const struct ts_granular_model *model,
						 const struct ts_granular_pair *law, const struct smallest *s,
						 double force)
{
	double unit = ts_granular_constants_at(model, law, s->radius, s->mass, 1).kn, overlap = force / unit;
	struct ts_normal f;

	if (ts_granular_stiffens(model)) /* F = K delta^(3/2), at delta = 1 the tangent is 3/2 K */
		overlap = pow(1.5 * force / unit, 2.0 / 3);
	if (!(unit > 0) || !isfinite(overlap))
		return (struct ts_servo_contacts){ 0 };
	f = ts_granular_constants_at(model, law, s->radius, s->mass, overlap);
	return (struct ts_servo_contacts){ 1, f.kn, fabs(f.gamman) };
}

/* Number of the mesh among the surfaces of the wall; SIZE_MAX: the wall does not have it. */
static size_t mesh_index(const struct ts_wall *w, const struct ts_mesh_surface *surface)
{
	size_t n = ts_wall_surfaces(w);

	for (size_t k = 0; k < n; k++)
		if (ts_wall_surface(w, k)->state == surface)
			return k;
	return SIZE_MAX;
}

/* K h + 2 C: the largest stable gain kp is proportional to its inverse (law/servo.h). */
static double step_gain(const struct tsim *sim, const struct ts_servo_contacts *c)
{
	return c->stiffness * sim->clock.dt + 2 * c->damping;
}

struct ts_servo_contacts ts_servo_contacts(const struct tsim *sim, const struct ts_servo_mesh *mesh, double n,
					   bool most)
{
	struct ts_servo_contacts best = { 0 };
	double force = mesh->load / (n * (mesh->lever > 0 ? mesh->arm : 1));
	double scale = n * (mesh->lever > 0 ? mesh->arm * mesh->arm / mesh->lever : 1);
	const struct ts_wall *w;

	for (size_t k = 0; (w = ts_walls_next(sim, &k, NULL));) {
		if (mesh_index(w, mesh->surface) == SIZE_MAX || !ts_wall_has_law(w, sim))
			continue;
		for (int t = 1; t <= sim->particles->ntypes; t++) {
			struct smallest s = smallest_of(sim, t);
			struct ts_servo_contacts c;

			if (!isfinite(s.radius) || !(s.mass > 0))
				continue;
			c = contact_response(ts_wall_model(w, sim),
					     ts_wall_law(w, sim, (int)mesh->surface->type, t), &s, force);
			if (c.n > 0 &&
			    (!(best.n > 0) || (step_gain(sim, &c) > step_gain(sim, &best)) == most))
				best = c;
		}
	}
	best.n *= n;
	best.stiffness *= scale;
	best.damping *= scale;
	return best;
}

/* ---- how many ---- */

size_t ts_servo_touching(const struct tsim *sim, const struct ts_mesh_surface *surface)
{
	const struct ts_wall *w;
	size_t n = 0;

	for (size_t k = 0; (w = ts_walls_next(sim, &k, NULL));) {
		size_t index = mesh_index(w, surface), last = SIZE_MAX;

		for (size_t c = 0; index != SIZE_MAX && c < w->contacts.n; c++) {
			size_t i = (size_t)w->contacts.row[c];
			struct ts_wall_place place;
			int type;

			ts_wall_place(w, c, &place);
			if (i == last || place.surface != index ||
			    !(w->shape->distance(w, sim, c, &type) < sim->particles->radius[i]))
				continue;
			last = i;
			n++;
		}
	}
	return n;
}

double ts_servo_most_contacts(const struct tsim *sim, const struct ts_servo_mesh *mesh)
{
	const struct ts_mesh *m = &mesh->surface->mesh;
	double area = 0, least = INFINITY, n;

	for (size_t t = 0; t < m->n; t++)
		area += m->area[t] * (mesh->lever > 0 ? 1 : fabs(ts_dot(m->normal[t], mesh->axis)));
	for (int t = 1; t <= sim->particles->ntypes; t++)
		least = fmin(least, smallest_of(sim, t).radius);
	n = fmax(1, area / (4 * least * least));
	return inserts_particles(sim) ? n : fmin(n, fmax(1, (double)sim->particles->n));
}
