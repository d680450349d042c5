#include "mesh/mesh_style.h"

#include <math.h>
#include <stdio.h>

#include "box/domain.h"
#include "core/report.h"
#include "mesh/mesh_motion.h"
#include "mesh/mesh_recede.h"

#include "base/banned.h"

void ts_mesh_surface_release(struct ts_mesh_surface *s)
{
	ts_mesh_release(&s->mesh);
	ts_mesh_motions_release(s);
	ts_mesh_recede_release(s);
	ts_free(s->v);
	s->v = NULL;
}

enum ts_status ts_mesh_surface_post_build(struct ts_instance *self, struct tsim *sim)
{
	struct ts_mesh_surface *s = self->state;

	if (sim->run.resuming)
		return TS_OK;
	if (s->travelled > 0)
		TS_TRY(ts_mesh_surface_check_box(self, sim, s));
	s->travelled = 0;
	return TS_OK;
}

enum ts_status ts_mesh_surface_archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *archive)
{
	TS_TRY(ts_mesh_motions_archive(self, sim, archive));
	return ts_mesh_recede_archive(self->state, sim, archive);
}

void ts_mesh_surface_fingerprint(const struct ts_instance *self, const struct tsim *sim, struct ts_hash *hash)
{
	const struct ts_mesh_surface *s = self->state;

	(void)sim;
	ts_hash_add(hash, s->mesh.x, s->mesh.n * sizeof *s->mesh.x);
	if (s->v)
		ts_hash_add(hash, s->v, s->mesh.n * sizeof *s->v);
}

enum ts_status ts_mesh_surface_plan(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report)
{
	const struct ts_mesh_surface *s = self->state;
	char name[48];

	(void)sim;
	snprintf(name, sizeof name, "mesh %s", self->id);
	ts_report_line(report, name, "%zu triangles, %zu corners, area %.6g", s->mesh.n, s->mesh.nvertices,
		       ts_mesh_area(&s->mesh));
	return TS_OK;
}

void ts_mesh_surface_fini(struct ts_instance *self)
{
	ts_mesh_surface_release(self->state);
}

/* A flat mesh in a face of the box may be outside by rounding: 26 * 0.001 > 0.026, and binary files have
 * single precision. So a tolerance of 1e-6 of the box length is allowed. */
static bool is_outside(const struct ts_box *box, const double x[3])
{
	static const double ROUNDING = 1e-6;
	bool outside = false;

	for (int d = 0; d < 3; d++) {
		double slack = ROUNDING * (box->hi[d] - box->lo[d]);

		outside |= (box->face[d][0] == TS_FACE_FIXED && x[d] < box->lo[d] - slack) ||
			   (box->face[d][1] == TS_FACE_FIXED && x[d] > box->hi[d] + slack);
	}
	return outside;
}

enum ts_status ts_mesh_surface_check_box(const struct ts_instance *by, struct tsim *sim,
					 const struct ts_mesh_surface *s)
{
	const struct ts_mesh *m = &s->mesh;
	size_t lost = 0, first = 0;

	for (size_t t = m->n; t-- > 0;) {
		if (!is_outside(&sim->domain->box, m->centre[t]))
			continue;
		first = t;
		lost++;
	}
	if (!lost)
		return TS_OK;
	return ts_fail(&sim->error, TS_RANGE, &by->where,
		       "mesh %s: %zu of %zu triangles have their centre outside the box, the first is "
		       "triangle %zu at (%g, %g, %g); scale or move the mesh, take a larger box, or "
		       "`boundary m m m`, which follows the mesh",
		       by->id, lost, m->n, first + 1, m->centre[first][0], m->centre[first][1],
		       m->centre[first][2]);
}

void ts_mesh_surface_extent(const struct ts_instance *self, int dim, double *lo, double *hi)
{
	const struct ts_mesh_surface *s = self->state;
	double least[3], most[3];

	ts_mesh_bounds(&s->mesh, least, most);
	*lo = fmin(*lo, least[dim]);
	*hi = fmax(*hi, most[dim]);
}
