#include "load/mesh_stress.h"

#include <string.h>

#include "mesh/mesh_style.h"
#include "wall/shared_contacts.h"

#include "base/banned.h"

const char *const ts_mesh_stress_triangle_names[] = { "normal", "shear", "x", "y", "z", "wear" };

/* ---- the fix of the mesh ---- */

const struct ts_instance *ts_mesh_stress_surface(const struct ts_instance *self)
{
	return self;
}

static const struct ts_mesh_surface *surface_of(const struct ts_instance *self)
{
	return self->state;
}

enum ts_status ts_mesh_stress_init(struct ts_instance *self, struct tsim *sim,
				   struct ts_mesh_surface *surface, struct ts_mesh_stress *s)
{
	size_t n = surface->mesh.n;

	surface->stress = s;
	TS_TRY(ts_mesh_wear_init(self, sim, surface, &s->wear));
	if (s->load)
		return TS_OK;
	ts_scale(1, s->given, surface->anchor);
	ts_scale(1, s->given, surface->anchor_given);
	s->load = ts_alloc(n, sizeof *s->load);
	s->normal = ts_alloc(n, sizeof *s->normal);
	s->shear = ts_alloc(n, sizeof *s->shear);
	return s->load && s->normal && s->shear ? TS_OK : ts_nomem(&sim->error);
}

void ts_mesh_stress_fini(struct ts_instance *self)
{
	struct ts_mesh_stress *s = surface_of(self)->stress;

	if (s) { /* else init has not come so far */
		ts_free(s->load);
		ts_free(s->normal);
		ts_free(s->shear);
		ts_mesh_wear_release(&s->wear);
	}
	ts_mesh_surface_fini(self);
}

enum ts_status ts_mesh_stress_archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a)
{
	const struct ts_mesh_surface *surface = surface_of(self);
	struct ts_mesh_stress *s = surface->stress;
	size_t n = surface->mesh.n;

	TS_TRY(ts_mesh_surface_archive(self, sim, a));
	TS_TRY(ts_archive_fixed(a, "load", TS_SAVED_F64, s->load, 3 * n));
	TS_TRY(ts_archive_fixed(a, "sum", TS_SAVED_F64, s->sum, 6));
	TS_TRY(ts_archive_fixed(a, "total", TS_SAVED_F64, s->total, 6));
	TS_TRY(ts_archive_fixed(a, "normal", TS_SAVED_F64, s->normal, n));
	TS_TRY(ts_archive_fixed(a, "shear", TS_SAVED_F64, s->shear, n));
	return ts_archive_fixed(a, "wear", TS_SAVED_F64, s->wear.depth, n);
}

enum ts_status ts_mesh_stress_eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct ts_mesh_stress *s = surface_of(self)->stress;

	(void)sim;
	for (int k = 0; k < 3; k++) {
		out->data[k] = s->total[0][k];
		out->data[3 + k] = s->total[1][k];
		out->data[6 + k] = surface_of(self)->anchor[k];
	}
	return TS_OK;
}

enum ts_status ts_mesh_stress_post_build(struct ts_instance *self, struct tsim *sim)
{
	TS_TRY(ts_mesh_surface_post_build(self, sim));
	return ts_mesh_wear_find_constants(self, sim, surface_of(self), &surface_of(self)->stress->wear);
}

/* Adds force and torque of one contact, their mean in the step. */
static void add_contact(const struct ts_surface_contact *c, double step, const double about[3],
			struct ts_mesh_stress *s)
{
	double arm[3], torque[3], force[3];

	ts_scale(step > 0 ? c->duration / step : 1, c->force, force);
	ts_add(s->load[c->element], force, s->load[c->element]);
	ts_add(s->sum[0], force, s->sum[0]);
	ts_sub(c->point, about, arm);
	ts_cross(arm, force, torque);
	ts_add(s->sum[1], torque, s->sum[1]);
}

static enum ts_status sum_contacts(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_mesh_surface *surface = surface_of(self);
	struct ts_mesh_stress *s = surface->stress;
	struct ts_surface_contacts contacts;
	struct ts_surface_contact c;

	TS_TRY(ts_shared_contacts_find(sim, self));
	contacts = ts_surface_contacts(sim, self);
	memset(s->load, 0, surface->mesh.n * sizeof *s->load);
	memset(s->sum, 0, sizeof s->sum);
	while (ts_surface_contacts_next(&contacts, &c)) {
		add_contact(&c, sim->clock.dt, surface->anchor, s);
		if (!sim->run.in_setup)
			ts_mesh_wear_add(surface, &c, &s->wear);
	}
	return TS_OK;
}

enum ts_status ts_mesh_stress_sum(struct ts_instance *self, struct tsim *sim)
{
	struct ts_mesh_stress *s = surface_of(self)->stress;

	s->unsummed = sim->division && !s->followed && s->wear.law == TS_MESH_WEAR_OFF;
	return s->unsummed ? TS_OK : sum_contacts(self, sim);
}

enum ts_status ts_mesh_stress_join(struct ts_instance *self, struct tsim *sim)
{
	struct ts_mesh_stress *s = surface_of(self)->stress;

	if (!s->unsummed)
		return TS_OK;
	s->unsummed = false;
	TS_TRY(sum_contacts(self, sim));
	if (!sim->run.resuming && sim->clock.step == sim->clock.first_step) /* a set-up is no complete step */
		return TS_OK;
	return ts_mesh_stress_settle(self, sim);
}

enum ts_status ts_mesh_stress_settle(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_mesh_surface *surface = surface_of(self);
	const struct ts_mesh *m = &surface->mesh;
	struct ts_mesh_stress *s = surface->stress;

	(void)sim;
	if (!s->tracks)
		return TS_OK;
	for (int k = 0; k < 6; k++)
		s->total[k / 3][k % 3] = s->sum[k / 3][k % 3];
	for (size_t t = 0; t < m->n; t++) {
		double across = ts_dot(s->load[t], m->normal[t]), along[3];

		ts_scale(1, s->load[t], along);
		ts_axpy(-across, m->normal[t], along);
		s->normal[t] = m->area[t] > 0 ? fabs(across) / m->area[t] : 0;
		s->shear[t] = m->area[t] > 0 ? ts_norm(along) / m->area[t] : 0;
	}
	return TS_OK;
}

enum ts_status ts_mesh_stress_eval_triangles(struct ts_instance *self, const struct tsim *sim,
					     struct ts_table *out)
{
	const struct ts_mesh *m = &surface_of(self)->mesh;
	const struct ts_mesh_stress *s = surface_of(self)->stress;

	(void)sim;
	TS_TRY(ts_table_resize(out, m->n, 6));
	for (size_t t = 0; t < m->n; t++) {
		double *row = out->data + 6 * t;

		row[0] = s->normal[t];
		row[1] = s->shear[t];
		for (int d = 0; d < 3; d++)
			row[2 + d] = s->tracks && m->area[t] > 0 ? s->load[t][d] / m->area[t] : 0;
		row[5] = s->wear.depth[t];
	}
	return TS_OK;
}
