/* Members of rigid bodies; creation and deletion of bodies. */
#include "rigid/rigid.h"

#include <string.h>

#include "base/sort.h"
#include "core/deferred_loops.h"
#include "core/report.h"
#include "math/rigid_turn.h"
#include "particle/columns.h"
#include "particle/copies.h"
#include "particle/group_moments.h"
#include "particle/sphere_shape.h"
#include "rigid/rigid_motion.h"

#include "base/banned.h"

int64_t ts_rigid_owner(const char *fix)
{
	struct ts_hash hash = ts_hash_start();

	ts_hash_text(&hash, fix);
	return (int64_t)(ts_hash_value(&hash) >> 1);
}

enum ts_status ts_rigid_reserve(struct tsim *sim, size_t n)
{
	struct ts_rigid *r = sim->rigid;

	if (TS_GROW(r->body, r->body_capacity, n) != TS_OK || TS_GROW(r->id, r->id_capacity, n) != TS_OK ||
	    TS_GROW(r->size, r->size_capacity, n) != TS_OK ||
	    TS_GROW(r->owner, r->owner_capacity, n) != TS_OK)
		return ts_nomem(&sim->error);
	return TS_OK;
}

enum ts_status ts_rigid_add(struct tsim *sim, const struct ts_body *body, int64_t owner, const int32_t *row,
			    size_t n)
{
	struct ts_rigid *r = sim->rigid;

	TS_TRY(ts_particles_need(sim, TS_NEED(BODY) | TS_NEED(BODY_X) | TS_NEED(OMEGA) | TS_NEED(TORQUE)));
	TS_TRY(ts_rigid_reserve(sim, r->n + 1));
	r->body[r->n] = *body;
	r->id[r->n] = ++r->last_id;
	r->size[r->n] = (int32_t)n;
	r->owner[r->n] = owner;
	r->n++;
	ts_rigid_attach(sim, body, r->last_id, row, n);
	r->generation = 0;
	ts_rigid_place(sim, body, row, n);
	return TS_OK;
}

static void move_body(struct ts_rigid *r, size_t from, size_t to)
{
	r->body[to] = r->body[from];
	r->id[to] = r->id[from];
	r->size[to] = r->size[from];
	r->owner[to] = r->owner[from];
}

void ts_rigid_drop(struct tsim *sim, const unsigned char *gone)
{
	struct ts_particles *p = sim->particles;
	struct ts_rigid *r = sim->rigid;
	size_t kept = 0;

	for (size_t b = 0; b < r->n; b++) {
		for (size_t k = r->start[b]; gone[b] && k < r->start[b + 1]; k++) {
			size_t i = (size_t)r->member[k];

			p->body[i] = 0;
			p->imass[i] = 1 / p->mass[i];
		}
		if (gone[b])
			continue;
		move_body(r, b, kept++);
	}
	r->n = kept;
	r->generation = 0;
}

enum ts_status ts_rigid_dissolve(struct tsim *sim, int64_t owner)
{
	struct ts_rigid *r = sim->rigid;
	unsigned char *gone;

	if (!r->n)
		return TS_OK;
	TS_TRY(ts_rigid_list(sim));
	gone = ts_alloc(r->n, 1);
	if (!gone)
		return ts_nomem(&sim->error);
	for (size_t b = 0; b < r->n; b++)
		gone[b] = r->owner[b] == owner;
	ts_rigid_drop(sim, gone);
	ts_free(gone);
	return TS_OK;
}

size_t ts_rigid_find(const struct ts_rigid *r, int32_t id)
{
	size_t b = r->n && id > r->id[0] ? (size_t)(id - r->id[0]) : 0;

	if (b < r->n && r->id[b] == id) /* mostly no body has been deleted */
		return b;
	b = ts_find_int32(r->id, r->n, sizeof *r->id, id);
	return b < r->n && r->id[b] == id ? b : r->n;
}

const struct ts_body *ts_rigid_body_of(const struct tsim *sim, size_t i)
{
	const struct ts_rigid *r = sim->rigid;
	size_t b;

	if (!ts_rigid_member(sim->particles, i))
		return NULL;
	b = ts_rigid_find(r, sim->particles->body[i]);
	return b < r->n ? &r->body[b] : NULL;
}

double ts_rigid_material_density(const struct tsim *sim, size_t i)
{
	const struct ts_body *body = ts_rigid_body_of(sim, i);
	const struct ts_particles *p = sim->particles;

	return body && body->density > 0 ? body->density : p->mass[i] / ts_particle_volume(sim, p->radius[i]);
}

/* Insertion sort by tag, so that sums over members do not depend on their order in memory. */
static void sort_members(const struct ts_particles *p, int32_t *member, size_t n)
{
	for (size_t k = 1; k < n; k++) {
		int32_t i = member[k];
		size_t at = k;

		for (; at > 0 && p->tag[member[at - 1]] > p->tag[i]; at--)
			member[at] = member[at - 1];
		member[at] = i;
	}
}

/* Particles whose bodies are listed: the own ones, and copies of those of other ranks. */
static size_t listed_particles(const struct tsim *sim)
{
	const struct ts_particles *p = sim->particles;

	return p->n + (p->nghost ? ts_copies(sim) : 0);
}

/* Counts the members of each body, in start[b + 2], and lists bodies in the order of their first members. */
static void count_members(const struct ts_particles *p, size_t n, struct ts_rigid *r)
{
	r->ordered = 0;
	memset(r->start, 0, (r->n + 2) * sizeof *r->start);
	for (size_t i = 0; i < n; i++) {
		size_t b = ts_rigid_index(r, p, i);

		if (b < r->n && !r->start[b + 2]++)
			r->order[r->ordered++] = (int32_t)b;
	}
}

/* Bodies of other ranks alone, which all had while they looked at all particles, or before members moved, are left out. */
static enum ts_status keep_own_bodies(struct tsim *sim)
{
	const struct ts_particles *p = sim->particles;
	struct ts_rigid *r = sim->rigid;
	unsigned char *own = ts_alloc(r->n, 1);
	size_t kept = 0;

	if (!own)
		return ts_nomem(&sim->error);
	for (size_t i = 0; i < p->n; i++) {
		size_t b = ts_rigid_index(r, p, i);

		if (b < r->n)
			own[b] = 1;
	}
	for (size_t b = 0; b < r->n; b++)
		if (own[b])
			move_body(r, b, kept++);
	r->n = kept;
	ts_free(own);
	return TS_OK;
}

/* Once more the members, in the order in which bodies are visited, so that they are read one after the other. */
static void list_rows(struct ts_rigid *r)
{
	size_t n = 0;

	for (size_t k = 0; k < r->ordered; k++) {
		size_t b = (size_t)r->order[k];

		r->row_start[k] = n;
		for (size_t m = r->start[b]; m < r->start[b + 1]; m++)
			r->row[n++] = r->member[m];
	}
	r->row_start[r->ordered] = n;
}

enum ts_status ts_rigid_list(struct tsim *sim)
{
	const struct ts_particles *p = sim->particles;
	struct ts_rigid *r = sim->rigid;
	size_t n = listed_particles(sim);

	if (!r->n)
		r->ordered = 0;
	if (!r->n || r->generation == sim->generation)
		return TS_OK;
	if (sim->division)
		TS_TRY(keep_own_bodies(sim));
	if (TS_GROW(r->start, r->start_capacity, r->n + 2) != TS_OK ||
	    TS_GROW(r->order, r->order_capacity, r->n) != TS_OK ||
	    TS_GROW(r->row_start, r->row_start_capacity, r->n + 1) != TS_OK ||
	    TS_GROW(r->member, r->member_capacity, n) != TS_OK ||
	    TS_GROW(r->row, r->row_capacity, n) != TS_OK)
		return ts_nomem(&sim->error);
	count_members(p, n, r);
	for (size_t b = 2; b <= r->n; b++)
		r->start[b] += r->start[b - 1];
	for (size_t i = 0; i < n; i++) {
		size_t b = ts_rigid_index(r, p, i);

		if (b < r->n)
			r->member[r->start[b + 1]++] = (int32_t)i;
	}
	for (size_t b = 0; b < r->n; b++)
		sort_members(p, r->member + r->start[b], r->start[b + 1] - r->start[b]);
	list_rows(r);
	r->generation = sim->generation;
	return TS_OK;
}

bool ts_rigid_in_group(const struct ts_rigid *r, const struct ts_particles *p, size_t b, int group)
{
	bool within = group == 0 && r->start[b] < r->start[b + 1]; /* all */

	for (size_t k = r->start[b]; k < r->start[b + 1] && !within; k++)
		within = ts_in_group(p, (size_t)r->member[k], group);
	return within;
}

size_t ts_rigid_members_in_group(const struct ts_rigid *r, const struct ts_particles *p, size_t b, int group)
{
	size_t n = 0;

	for (size_t k = r->start[b]; k < r->start[b + 1]; k++)
		n += ts_in_group(p, (size_t)r->member[k], group);
	return n;
}

bool ts_rigid_all_in_group(const struct ts_rigid *r, const struct ts_particles *p, size_t b, int group)
{
	const size_t n = r->start[b + 1] - r->start[b];

	return n && ts_rigid_members_in_group(r, p, b, group) == n;
}

/* The mass of a clump is not that of its spheres, which overlap: the force acts on it as a whole. Else each member gets its
 * weight, as in LAMMPS, so that fixes that change the forces on members change this one, too. */
static void accelerate_body(struct ts_rigid *r, struct ts_particles *p, size_t b, const double a[3])
{
	if (r->body[b].kind > 0) {
		ts_axpy(r->body[b].mass, a, r->body[b].external);
		return;
	}
	for (size_t k = r->start[b]; k < r->start[b + 1]; k++)
		if ((size_t)r->member[k] < p->n)
			ts_axpy(p->mass[r->member[k]], a, p->f[r->member[k]]);
}

enum ts_status ts_rigid_accelerate(struct tsim *sim, int group, const double a[3])
{
	struct ts_particles *p = sim->particles;
	struct ts_rigid *r = sim->rigid;
	bool spheres = false;

	if (!r->n)
		return TS_OK;
	TS_TRY(ts_rigid_list(sim));
	for (size_t b = 0; b < r->n && !spheres; b++)
		spheres = !(r->body[b].kind > 0);
	if (spheres)
		ts_deferred_loops_run(sim);
#pragma omp parallel for num_threads(ts_team(sim, r->n)) schedule(static)
	for (size_t b = 0; b < r->n; b++)
		if (ts_rigid_in_group(r, p, b, group))
			accelerate_body(r, p, b, a);
	return TS_OK;
}

enum ts_status ts_rigid_delete(struct tsim *sim, const unsigned char *torn)
{
	const struct ts_rigid *r = sim->rigid;
	size_t n = sim->particles->n;
	unsigned char *gone = ts_alloc(n, 1);
	enum ts_status status;

	if (!gone)
		return ts_nomem(&sim->error);
	for (size_t b = 0; b < r->n; b++)
		for (size_t k = r->start[b]; torn[b] && k < r->start[b + 1]; k++)
			if ((size_t)r->member[k] < n)
				gone[r->member[k]] = 1;
	ts_rigid_drop(sim, torn);
	status = ts_particles_delete(sim, gone);
	ts_free(gone);
	return status == TS_OK ? ts_rigid_list(sim) : status;
}

enum ts_status ts_rigid_drop_incomplete(struct tsim *sim)
{
	const struct ts_rigid *r = sim->rigid;
	unsigned char *torn = ts_alloc(r->n, 1);
	bool any = false;
	enum ts_status status = TS_OK;

	if (!torn)
		return ts_nomem(&sim->error);
	for (size_t b = 0; b < r->n; b++) {
		torn[b] = r->start[b + 1] - r->start[b] < (size_t)r->size[b];
		any |= torn[b];
	}
	if (any)
		status = ts_rigid_delete(sim, torn);
	ts_free(torn);
	return status;
}

bool ts_rigid_owner_lives(const struct tsim *sim, int64_t owner)
{
	const struct ts_instances *fixes = &sim->instances[TS_KIND_FIX];

	for (size_t k = 0; k < fixes->n; k++)
		if (ts_rigid_owner(fixes->item[k]->id) == owner)
			return true;
	return false;
}

enum ts_status ts_rigid_dissolve_orphans(struct tsim *sim)
{
	const struct ts_rigid *r = sim->rigid;
	int64_t lives = -1; /* consecutive bodies mostly have the same owner */
	size_t b = 0;

	while (b < r->n) {
		if (r->owner[b] == lives || ts_rigid_owner_lives(sim, r->owner[b])) {
			lives = r->owner[b++];
		} else {
			TS_TRY(ts_rigid_dissolve(sim, r->owner[b]));
			b = 0;
		}
	}
	return TS_OK;
}
