#include "wall/mesh_sieve.h"

#include <stdio.h>

#include "base/hash.h"
#include "box/domain.h"
#include "geom/box_images.h"
#include "math/constants.h"
#include "math/rng.h"
#include "mesh/mesh_touch.h"
#include "particle/columns.h"
#include "particle/particles.h"
#include "rigid/rigid.h"

#include "base/banned.h"

enum { CLEAR, HELD, PASSING };

enum ts_status ts_mesh_sieve_init(struct ts_instance *self, struct tsim *sim, struct ts_mesh_sieve *sieve)
{
	const double clear = CLEAR;
	char name[128];

	if (!ts_mesh_sieve_is(sieve)) {
		if (isnan(sieve->spacing) && isnan(sieve->stiffness) && sieve->damping == 0)
			return TS_OK;
		return ts_fail(&sim->error, TS_SYNTAX, &self->where,
			       "fix massflow/mesh: a sieve needs the diameter of its openings, sieveSize");
	}
	if (isnan(sieve->spacing) || isnan(sieve->stiffness))
		return ts_fail(&sim->error, TS_SYNTAX, ts_instance_word(self, "sieveSize"),
			       "fix massflow/mesh: a sieve needs %s, too",
			       isnan(sieve->spacing) ? "sieveSpacing" : "sieveStiffness");
	snprintf(name, sizeof name, "sieve_%.100s", self->id);
	TS_TRY(ts_particles_add_column(sim, name, 1, TS_COL_NAMED, &sieve->column));
	return ts_particles_column_initial(sim, sieve->column, &clear);
}

static double *state_of(const struct ts_mesh_sieve *sieve, const struct tsim *sim, size_t i)
{
	return (double *)sim->particles->column[sieve->column].data + i;
}

bool ts_mesh_sieve_holds(const struct ts_mesh_sieve *sieve, const struct tsim *sim, size_t i)
{
	return ts_mesh_sieve_is(sieve) && *state_of(sieve, sim, i) == HELD;
}

/* Members of rigid bodies do not pass: a body could be stuck between its members. */
static double probability_to_pass(const struct ts_mesh_sieve *sieve, const struct tsim *sim, size_t i)
{
	const double width = sieve->size - 2 * sim->particles->radius[i];

	if (ts_rigid_member(sim->particles, i) || width <= 0)
		return 0;
	return 0.25 * TS_PI * (width / sieve->spacing) * (width / sieve->spacing);
}

/* Decided once for each contact, in its first step. */
static double decide(const struct ts_instance *self, const struct tsim *sim,
		     const struct ts_mesh_sieve *sieve, size_t i)
{
	struct ts_hash key = ts_hash_start();
	struct ts_rng rng;

	ts_hash_text(&key, self->id);
	rng = ts_rng_start(ts_hash_value(&key), (uint64_t)sim->particles->tag[i]);
	rng.counter = ts_clock_counter(&sim->clock, 1);
	return ts_rng_uniform(&rng) < probability_to_pass(sieve, sim, i) ? PASSING : HELD;
}

struct contact {
	struct ts_mesh_contact_point at; /* distance infinite: none */
	size_t triangle;
};

/* The nearest point of the mesh, or of its periodic images, within the radius. */
static enum ts_status find_contact(const struct tsim *sim, size_t i, const struct ts_mesh_surface *surface,
				   const struct ts_mesh_tree *tree, struct ts_mesh_list *list,
				   struct contact *out)
{
	const struct ts_particles *p = sim->particles;
	const struct ts_box *box = &sim->domain->box;
	struct ts_box_images images =
		ts_box_images(box, tree->lo[1], tree->hi[1], p->x[i], p->x[i], p->radius[i]);
	double x[3];

	*out = (struct contact){ .at.distance = INFINITY };
	while (ts_box_images_next(&images)) {
		ts_box_images_place(box, images.shift, p->x[i], x);
		TS_TRY(ts_mesh_tree_near(tree, &surface->mesh, x, p->radius[i], list));
		for (size_t k = 0; k < list->n; k++) {
			const size_t triangle = (size_t)list->item[k];
			struct ts_mesh_contact_point at;

			if (ts_mesh_nearest(&surface->mesh, triangle, x, &at) == TS_MESH_NOTHING ||
			    !(at.distance < p->radius[i]) || !(at.distance < out->at.distance))
				continue;
			*out = (struct contact){ at, triangle };
		}
	}
	return TS_OK;
}

/* Of the spring, and of the dashpot, along the normal. */
static void add_force(const struct ts_mesh_sieve *sieve, struct tsim *sim, size_t i,
		      const struct ts_mesh_surface *surface, const struct contact *contact)
{
	struct ts_particles *p = sim->particles;
	double v[3], u[3];

	ts_mesh_surface_velocity(surface, contact->triangle, contact->at.weight, v);
	ts_sub(p->v[i], v, u);
	ts_axpy(sieve->stiffness * (p->radius[i] - contact->at.distance) -
			sieve->damping * ts_dot(u, contact->at.n),
		contact->at.n, p->f[i]);
}

enum ts_status ts_mesh_sieve_add_forces(const struct ts_instance *self, struct tsim *sim,
					const struct ts_mesh_sieve *sieve,
					const struct ts_mesh_surface *surface,
					const struct ts_mesh_tree *tree, struct ts_mesh_list *list)
{
	const struct ts_particles *p = sim->particles;

	for (size_t i = 0; i < p->n; i++) {
		double *state = state_of(sieve, sim, i);
		struct contact contact;

		if (!ts_in_group(p, i, self->group))
			continue;
		if (find_contact(sim, i, surface, tree, list, &contact) != TS_OK)
			return ts_nomem(&sim->error);
		if (isinf(contact.at.distance)) {
			*state = CLEAR;
			continue;
		}
		if (*state == CLEAR)
			*state = decide(self, sim, sieve, i);
		if (*state == HELD)
			add_force(sieve, sim, i, surface, &contact);
	}
	return TS_OK;
}

void ts_mesh_sieve_ground(const struct ts_mesh_sieve *sieve, const struct tsim *sim, size_t i,
			  struct ts_ground_springs *sum)
{
	const double mass = sim->particles->mass[i];

	for (int d = 0; d < 3; d++) {
		sum->frequency2[d] += sieve->stiffness / mass;
		sum->rate[d] += sieve->damping / mass;
	}
	sum->estimated = true;
}
