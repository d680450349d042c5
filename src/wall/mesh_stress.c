#include "wall/mesh_stress.h"

#include <stdlib.h>

#include "box/domain.h"
#include "law/wear.h"
#include "material/property.h"
#include "mesh/mesh_style.h"
#include "mesh/mesh_touch.h"

#include "base/banned.h"

const char *const ts_mesh_wear_names[] = { "off", "finnie", NULL };
const char *const ts_mesh_stress_names[] = { "fx", "fy", "fz", "tx", "ty", "tz", "x", "y", "z" };

/* ---- the fix of the mesh ---- */

static const struct ts_mesh_surface *surface_of(const struct ts_instance *self)
{
	return self->state;
}

enum ts_status ts_mesh_stress_init(struct ts_instance *self, struct tsim *sim,
				   struct ts_mesh_surface *surface, struct ts_mesh_stress *s)
{
	size_t n = surface->mesh.n;
	double k;

	surface->stress = s;
	if (s->wear_law != TS_MESH_WEAR_OFF)
		TS_TRY(ts_property_value(sim, "k_finnie", (int)surface->type, (int)surface->type,
					 "wear finnie", ts_instance_word(self, "wear"), &k));
	if (s->load)
		return TS_OK;
	ts_scale(1, s->given, surface->anchor);
	s->load = ts_alloc(n, sizeof *s->load);
	s->normal = ts_alloc(n, sizeof *s->normal);
	s->shear = ts_alloc(n, sizeof *s->shear);
	s->wear = ts_alloc(n, sizeof *s->wear);
	return s->load && s->normal && s->shear && s->wear ? TS_OK : ts_nomem(&sim->error);
}

void ts_mesh_stress_fini(struct ts_instance *self)
{
	struct ts_mesh_stress *s = surface_of(self)->stress;

	if (s) { /* else init has not come so far */
		ts_free(s->load);
		ts_free(s->normal);
		ts_free(s->shear);
		ts_free(s->wear);
		ts_free(s->k);
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
	return ts_archive_fixed(a, "wear", TS_SAVED_F64, s->wear, n);
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

/* For the types that particles have. */
static enum ts_status find_constants(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_mesh_surface *surface = surface_of(self);
	struct ts_mesh_stress *s = surface->stress;
	const struct ts_particles *p = sim->particles;
	int most = 0;

	if (s->wear_law == TS_MESH_WEAR_OFF)
		return TS_OK;
	for (size_t i = 0; i < p->n; i++)
		most = p->type[i] > most ? p->type[i] : most;
	ts_free(s->k);
	s->ntypes = most;
	s->k = ts_alloc((size_t)most + 1, sizeof *s->k);
	if (!s->k)
		return ts_nomem(&sim->error);
	for (int t = 1; t <= most; t++)
		TS_TRY(ts_property_value(sim, "k_finnie", (int)surface->type, t, "wear finnie",
					 ts_instance_word(self, "wear"), &s->k[t]));
	return TS_OK;
}

enum ts_status ts_mesh_stress_post_build(struct ts_instance *self, struct tsim *sim)
{
	TS_TRY(ts_mesh_surface_post_build(self, sim));
	return find_constants(self, sim);
}

enum ts_status ts_mesh_stress_clear(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_mesh_surface *surface = surface_of(self);
	struct ts_mesh_stress *s = surface->stress;

	(void)sim;
	for (size_t k = 0; k < 3 * surface->mesh.n; k++)
		s->load[k / 3][k % 3] = 0;
	for (int k = 0; k < 6; k++)
		s->sum[k / 3][k % 3] = 0;
	s->near = 0;
	return TS_OK;
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

/* ---- the walls ---- */

bool ts_mesh_stress_wanted(const struct ts_mesh_wall *mw)
{
	bool wanted = false;

	for (size_t k = 0; k < mw->nmeshes; k++)
		wanted |= mw->mesh[k].surface->stress != NULL;
	return wanted;
}

static int by_element(const void *a, const void *b)
{
	const struct ts_mesh_touching *p = a, *q = b;

	if (p->element != q->element)
		return p->element < q->element ? -1 : 1;
	return (p->tag > q->tag) - (p->tag < q->tag);
}

static const struct ts_mesh_surface *surface_at(const struct ts_mesh_wall *mw, size_t k)
{
	return mw->mesh[mw->near[k].mesh].surface;
}

static size_t list_touching(const struct ts_wall_contacts *c, struct ts_mesh_wall *mw)
{
	size_t n = 0;

	for (size_t k = 0; k < c->n; k++) {
		struct ts_mesh_stress *s = surface_at(mw, k)->stress;

		if (!s)
			continue;
		s->near++;
		if (ts_wall_report(c, k))
			mw->touching[n++] = (struct ts_mesh_touching){ c->key[k][1], c->key[k][0], k };
	}
	if (n)
		qsort(mw->touching, n, sizeof *mw->touching, by_element);
	return n;
}

/* Into the frame of the image of the mesh that is meant. */
static void into_frame(const struct tsim *sim, const struct ts_mesh_near *near, const double x[3],
		       double out[3])
{
	for (int d = 0; d < 3; d++)
		out[d] = x[d] - near->shift[d] * ts_box_length(&sim->domain->box, d);
}

static void wear_down(struct tsim *sim, const struct ts_wall_contacts *c, size_t k,
		      const struct ts_mesh_surface *surface, const struct ts_mesh_near *near)
{
	const struct ts_particles *p = sim->particles;
	struct ts_mesh_stress *s = surface->stress;
	size_t t = (size_t)near->triangle, i = (size_t)c->row[k];
	struct ts_mesh_contact_point at;
	double x[3], v[3];

	into_frame(sim, near, p->x[i], x);
	ts_mesh_nearest(&surface->mesh, t, x, &at);
	ts_mesh_surface_velocity(surface, t, at.weight, v);
	ts_sub(p->v[i], v, v);
	if (ts_dot(at.n, v) > 0) /* it leaves */
		return;
	s->wear[t] += ts_wear_finnie(s->k[p->type[i]], v, surface->mesh.normal[t],
				     ts_norm(c->report[k].force), surface->mesh.area[t], sim->clock.dt);
}

static void add(struct tsim *sim, const struct ts_wall_contacts *c, size_t k,
		const struct ts_mesh_surface *surface, const struct ts_mesh_near *near)
{
	struct ts_mesh_stress *s = surface->stress;
	const struct ts_wall_report *r = &c->report[k];
	double arm[3], torque[3];

	ts_sub(s->load[near->triangle], r->force, s->load[near->triangle]);
	ts_sub(s->sum[0], r->force, s->sum[0]);
	into_frame(sim, near, r->point, arm);
	ts_sub(arm, surface->anchor, arm);
	ts_cross(arm, r->force, torque);
	ts_sub(s->sum[1], torque, s->sum[1]);
	if (s->wear_law != TS_MESH_WEAR_OFF && !sim->run.in_setup)
		wear_down(sim, c, k, surface, near);
}

enum ts_status ts_mesh_stress_collect(struct tsim *sim, const struct ts_wall *w, struct ts_mesh_wall *mw)
{
	const struct ts_wall_contacts *c = &w->contacts;
	size_t n;

	if (!c->report || !ts_mesh_stress_wanted(mw))
		return TS_OK;
	if (TS_GROW(mw->touching, mw->touching_capacity, c->n) != TS_OK)
		return ts_nomem(&sim->error);
	n = list_touching(c, mw);
	for (size_t j = 0; j < n; j++) {
		size_t k = mw->touching[j].k;

		add(sim, c, k, surface_at(mw, k), &mw->near[k]);
	}
	return TS_OK;
}
