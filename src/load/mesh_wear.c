#include "load/mesh_wear.h"

#include "core/ranks.h"
#include "law/contact_wear.h"
#include "material/property.h"

#include "base/banned.h"

const char *const ts_mesh_wear_names[] = { "off", "finnie", NULL };

static enum ts_status find_constant(struct ts_instance *self, struct tsim *sim,
				    const struct ts_mesh_surface *surface, int type, double *k)
{
	const struct ts_place *where = ts_instance_word(self, "wear");

	TS_TRY(ts_property_value(sim, "k_finnie", (int)surface->type, type, "wear finnie", where, k));
	if (*k >= 0)
		return TS_OK;
	return ts_fail(&sim->error, TS_RANGE, ts_property_place(sim, "k_finnie", (int)surface->type, type),
		       "property/global k_finnie is %.15g, expected a number >= 0", *k);
}

enum ts_status ts_mesh_wear_init(struct ts_instance *self, struct tsim *sim,
				 const struct ts_mesh_surface *surface, struct ts_mesh_wear *wear)
{
	double k;

	if (wear->law != TS_MESH_WEAR_OFF)
		TS_TRY(find_constant(self, sim, surface, (int)surface->type, &k));
	if (!wear->depth)
		wear->depth = ts_alloc(surface->mesh.n, sizeof *wear->depth);
	return wear->depth ? TS_OK : ts_nomem(&sim->error);
}

/* Of the types that particles have now, on any rank. */
enum ts_status ts_mesh_wear_find_constants(struct ts_instance *self, struct tsim *sim,
					   const struct ts_mesh_surface *surface, struct ts_mesh_wear *wear)
{
	const struct ts_particles *p = sim->particles;
	int most = 0;

	if (wear->law == TS_MESH_WEAR_OFF)
		return TS_OK;
	for (size_t i = 0; i < p->n; i++)
		most = p->type[i] > most ? p->type[i] : most;
	ts_free(wear->k);
	most = (int)ts_ranks_most(sim, most);
	wear->k = ts_alloc((size_t)most + 1, sizeof *wear->k);
	if (!wear->k)
		return ts_nomem(&sim->error);
	for (int type = 1; type <= most; type++)
		TS_TRY(find_constant(self, sim, surface, type, &wear->k[type]));
	return TS_OK;
}

void ts_mesh_wear_add(const struct ts_mesh_surface *surface, const struct ts_surface_contact *c,
		      struct ts_mesh_wear *wear)
{
	const struct ts_mesh *m = &surface->mesh;

	if (wear->law == TS_MESH_WEAR_OFF)
		return;
	if (ts_dot(c->normal, c->velocity) > 0) /* it parts */
		return;
	wear->depth[c->element] += ts_wear_finnie(wear->k[c->type], c->velocity, m->normal[c->element],
						  ts_norm(c->force), m->area[c->element], c->duration);
}

void ts_mesh_wear_release(struct ts_mesh_wear *wear)
{
	ts_free(wear->depth);
	ts_free(wear->k);
}
