#include "load/mesh_quantities.h"

#include <math.h>

#include "base/banned.h"

static bool tracked(const struct ts_mesh_surface *s)
{
	return s->stress && s->stress->tracks;
}

static bool worn(const struct ts_mesh_surface *s)
{
	return s->stress && s->stress->wear.law != TS_MESH_WEAR_OFF;
}

static bool moves(const struct ts_mesh_surface *s)
{
	return s->v || s->has_mover;
}

static void get_normal_stress(const struct ts_mesh_surface *s, size_t t, int corner, double out[3])
{
	(void)corner;
	out[0] = tracked(s) ? s->stress->normal[t] : 0;
}

static void get_shear_stress(const struct ts_mesh_surface *s, size_t t, int corner, double out[3])
{
	(void)corner;
	out[0] = tracked(s) ? s->stress->shear[t] : 0;
}

static void get_stress(const struct ts_mesh_surface *s, size_t t, int corner, double out[3])
{
	(void)corner;
	for (int d = 0; d < 3; d++)
		out[d] = tracked(s) ? s->stress->load[t][d] / s->mesh.area[t] : 0;
}

static void get_wear(const struct ts_mesh_surface *s, size_t t, int corner, double out[3])
{
	(void)corner;
	out[0] = worn(s) ? s->stress->wear.depth[t] : 0;
}

static bool warm(const struct ts_mesh_surface *s)
{
	return !isnan(s->temperature);
}

static void get_temperature(const struct ts_mesh_surface *s, size_t t, int corner, double out[3])
{
	(void)t;
	(void)corner;
	out[0] = warm(s) ? s->temperature : 0;
}

static void get_index(const struct ts_mesh_surface *s, size_t t, int corner, double out[3])
{
	(void)s;
	(void)corner;
	out[0] = (double)t;
}

static void get_owner(const struct ts_mesh_surface *s, size_t t, int corner, double out[3])
{
	(void)s;
	(void)t;
	(void)corner;
	out[0] = 0;
}

static void get_area(const struct ts_mesh_surface *s, size_t t, int corner, double out[3])
{
	(void)corner;
	out[0] = s->mesh.area[t];
}

static void get_active_edges(const struct ts_mesh_surface *s, size_t t, int corner, double out[3])
{
	(void)corner;
	out[0] = 0;
	for (int k = 0; k < 3; k++)
		out[0] += ts_mesh_edge_active(&s->mesh, t, k);
}

static void get_active_corners(const struct ts_mesh_surface *s, size_t t, int corner, double out[3])
{
	(void)corner;
	out[0] = 0;
	for (int k = 0; k < 3; k++)
		out[0] += ts_mesh_corner_active(&s->mesh, t, k);
}

static bool has_vertex(const struct ts_mesh *m, size_t t, int32_t vertex)
{
	return m->vertex[t][0] == vertex || m->vertex[t][1] == vertex || m->vertex[t][2] == vertex;
}

static void get_neighbours(const struct ts_mesh_surface *s, size_t t, int corner, double out[3])
{
	const struct ts_mesh *m = &s->mesh;

	(void)corner;
	out[0] = 0;
	for (int k = 0; k < 3; k++) {
		out[0] += m->neighbour[t][k] >= 0;
		for (size_t o = 0; m->neighbour[t][k] == TS_MESH_MANY && o < m->n; o++)
			out[0] += o != t && has_vertex(m, o, m->vertex[t][k]) &&
				  has_vertex(m, o, m->vertex[t][(k + 1) % 3]);
	}
}

static void get_velocity(const struct ts_mesh_surface *s, size_t t, int corner, double out[3])
{
	for (int d = 0; d < 3; d++) {
		out[d] = 0;
		for (int k = 0; s->v && k < 3; k++)
			if (corner < 0 || corner == k)
				out[d] += s->v[t][k][d] / (corner < 0 ? 3 : 1);
	}
}

const struct ts_mesh_quantity ts_mesh_quantities[TS_MESH_QUANTITIES] = {
	{ "stress", "normal_stress_average", 1, false, get_normal_stress, tracked },
	{ "stress", "shear_stress_average", 1, false, get_shear_stress, tracked },
	{ "stresscomponents", "stress", 3, false, get_stress, tracked },
	{ "id", "meshid", 1, true, get_index, NULL },
	{ "wear", "wear", 1, false, get_wear, worn },
	{ "temp", "Temp", 1, false, get_temperature, warm },
	{ "owner", "owner", 1, true, get_owner, NULL },
	{ "area", "area", 1, false, get_area, NULL },
	{ "aedges", "active_edges", 1, true, get_active_edges, NULL },
	{ "acorners", "active_corners", 1, true, get_active_corners, NULL },
	{ "index", "index", 1, true, get_index, NULL },
	{ "nneighs", "nneighs", 1, true, get_neighbours, NULL },
	{ "vel", "v", 3, false, get_velocity, moves },
};

bool ts_mesh_quantity_sizes(const struct ts_mesh_surface *s, const char *name, double *out)
{
	for (int k = 0; k < TS_MESH_QUANTITIES; k++) {
		const struct ts_mesh_quantity *q = &ts_mesh_quantities[k];

		if ((!ts_streq(q->word, name) && !ts_streq(q->name, name)) || (q->of && !q->of(s)))
			continue;
		for (size_t t = 0; t < s->mesh.n; t++) {
			double v[3] = { 0 };

			q->get(s, t, -1, v);
			out[t] = q->components == 1 ? v[0] : sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
		}
		return true;
	}
	return false;
}
