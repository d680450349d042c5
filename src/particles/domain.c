#include "particles/domain.h"

#include <math.h>

#include "core/plan.h"
#include "particles/particles.h"

#include "base/banned.h"

enum ts_status ts_domain_require(struct tsim *sim, const struct ts_place *where)
{
	if (sim->domain->exists)
		return TS_OK;
	return ts_fail(&sim->error, TS_STATE, where,
		       "there is no simulation box yet: use create_box or read_restart first");
}

bool ts_sim_has_box(const struct tsim *sim)
{
	return sim->domain->exists;
}

enum ts_status ts_domain_make(struct tsim *sim, int ntypes, const double lo[3], const double hi[3])
{
	struct ts_domain *domain = sim->domain;
	struct ts_particles *p = sim->particles;
	double *type_mass = ts_alloc((size_t)ntypes + 1, sizeof *type_mass);

	if (!type_mass)
		return ts_nomem(&sim->error);
	ts_free(p->type_mass);
	p->type_mass = type_mass;
	p->ntypes = ntypes;
	for (int d = 0; d < 3; d++) {
		domain->box.lo[d] = domain->first_lo[d] = lo[d];
		domain->box.hi[d] = domain->first_hi[d] = hi[d];
	}
	domain->exists = true;
	return TS_OK;
}

/* A moving face stays this part of the first box length outside the outermost centre. */
static const double SHRINK_MARGIN = 1e-4;

static void shrink_dimension(struct ts_domain *d, const struct ts_particles *p, int dim)
{
	double margin = SHRINK_MARGIN * (d->first_hi[dim] - d->first_lo[dim]);
	double lo = INFINITY, hi = -INFINITY;

	for (size_t i = 0; i < p->n; i++) {
		lo = fmin(lo, p->x[i][dim]);
		hi = fmax(hi, p->x[i][dim]);
	}
	if (!(lo <= hi))
		return;
	if (d->box.face[dim][0] == TS_FACE_SHRINK)
		d->box.lo[dim] = lo - margin;
	else if (d->box.face[dim][0] == TS_FACE_MINIMUM)
		d->box.lo[dim] = fmin(lo - margin, d->first_lo[dim]);
	if (d->box.face[dim][1] == TS_FACE_SHRINK)
		d->box.hi[dim] = hi + margin;
	else if (d->box.face[dim][1] == TS_FACE_MINIMUM)
		d->box.hi[dim] = fmax(hi + margin, d->first_hi[dim]);
}

void ts_domain_shrink(struct tsim *sim)
{
	for (int dim = 0; dim < 3; dim++)
		shrink_dimension(sim->domain, sim->particles, dim);
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct ts_domain *d = self->state;

	(void)sim;
	if (d->lattice <= 0) {
		d->lattice = 1;
		d->lattice_style = -1;
	}
	return TS_OK;
}

static void fingerprint(const struct ts_instance *self, const struct tsim *sim,
			struct ts_hash *hash)
{
	const struct ts_domain *d = self->state;

	(void)sim;
	ts_hash_add(hash, d->box.lo, sizeof d->box.lo);
	ts_hash_add(hash, d->box.hi, sizeof d->box.hi);
	ts_hash_add(hash, d->box.face, sizeof d->box.face);
}

static enum ts_status plan(struct ts_instance *self, struct tsim *sim,
			   struct ts_plan_report *report)
{
	const struct ts_domain *d = self->state;
	static const char letters[] = "pfsm";
	char faces[12] = "";

	(void)sim;
	for (int k = 0; k < 6; k++) {
		faces[k + k / 2] = letters[d->box.face[k / 2][k % 2]];
		if (k % 2)
			faces[k + k / 2 + 1] = ' ';
	}
	ts_report_line(report, "box", "(%g %g %g) to (%g %g %g), faces %.8s", d->box.lo[0],
		       d->box.lo[1], d->box.lo[2], d->box.hi[0], d->box.hi[1], d->box.hi[2], faces);
	return TS_OK;
}

static enum ts_status archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a)
{
	struct ts_domain *d = self->state;

	if (ts_archive_writing(a))
		return TS_OK;
	for (int k = 0; k < 3; k++)
		if (!(d->box.lo[k] < d->box.hi[k]) || !isfinite(d->box.hi[k] - d->box.lo[k]) ||
		    !(d->first_lo[k] < d->first_hi[k]) ||
		    d->box.face[k][0] > TS_FACE_MINIMUM || d->box.face[k][1] > TS_FACE_MINIMUM ||
		    ts_box_periodic(&d->box, k) != (d->box.face[k][1] == TS_FACE_PERIODIC))
			return ts_fail(&sim->error, TS_DAMAGED, NULL, "impossible simulation box");
	d->exists = true;
	return TS_OK;
}

static const struct ts_saved saved[] = {
	TS_SAVE_F64(struct ts_domain, box.lo),
	TS_SAVE_F64(struct ts_domain, box.hi),
	TS_SAVE_I32(struct ts_domain, box.face),
	TS_SAVE_F64(struct ts_domain, first_lo),
	TS_SAVE_F64(struct ts_domain, first_hi),
	TS_SAVE_F64(struct ts_domain, lattice),
	TS_SAVE_I32(struct ts_domain, lattice_style),
	TS_SAVED_ROWS_END,
};

const struct ts_system_style ts_domain_system = {
	.style = { .name = "domain",
		   .kind = TS_KIND_SYSTEM,
		   .summary = "the simulation box and its faces",
		   .state_size = sizeof(struct ts_domain),
		   .saved = saved,
		   .archive = archive,
		   .fingerprint = fingerprint,
		   .init = init,
		   .plan = plan },
	.slot = offsetof(struct tsim, domain),
};
