#include "box/domain.h"

#include <math.h>
#include <string.h>

#include "core/report.h"
#include "core/settings.h"

#include "base/banned.h"

enum ts_status ts_domain_require(struct tsim *sim, const struct ts_place *where)
{
	if (sim->has_box)
		return TS_OK;
	return ts_fail(&sim->error, TS_STATE, where,
		       "there is no simulation box yet: use create_box or read_restart first");
}

enum ts_status ts_domain_refuse_shear(struct tsim *sim, const char *what, const struct ts_place *where)
{
	if (!sim->domain->box.shear.on)
		return TS_OK;
	return ts_fail(&sim->error, TS_STATE, where,
		       "%s: the box has been sheared by fix deform; use it before that fix", what);
}

void ts_domain_hold(struct ts_domain *domain)
{
	for (int k = 0; k < 3; k++) {
		domain->held_lo[k] = domain->box.lo[k];
		domain->held_hi[k] = domain->box.hi[k];
	}
	domain->held_offset = domain->box.shear.offset;
}

double ts_domain_moved(const struct ts_domain *domain)
{
	double square = 0, slid = domain->box.shear.offset - domain->held_offset;

	for (int k = 0; k < 3; k++) {
		double d = ts_box_length(&domain->box, k) - (domain->held_hi[k] - domain->held_lo[k]);

		if (ts_box_periodic(&domain->box, k))
			square += d * d;
	}
	return sqrt(square) + fabs(slid);
}

void ts_domain_reduce_shear(struct ts_domain *domain)
{
	struct ts_shear *s = &domain->box.shear;
	double length = ts_box_length(&domain->box, s->flow), turns = rint(s->offset / length);

	if (!s->on || turns == 0)
		return;
	s->offset -= turns * length;
	s->turns += (int64_t)turns;
}

bool ts_domain_all_fixed(const struct tsim *sim)
{
	bool fixed = true;

	for (int k = 0; k < 2 * sim->dimension; k++)
		fixed &= sim->domain->box.face[k / 2][k % 2] == TS_FACE_FIXED;
	return fixed;
}

/* Relative to the initial length of the box. */
static const double SHRINK_MARGIN = 1e-4;

double ts_domain_margin(const struct ts_domain *d, int dim)
{
	return SHRINK_MARGIN * (d->first_hi[dim] - d->first_lo[dim]);
}

/* "p", "f", "fs": one letter for both faces of a dimension, or one for each. */
static enum ts_status parse_faces(struct tsim *sim, const char *text, char dim, const struct ts_place *where,
				  enum ts_face face[2])
{
	static const char letters[] = "pfsm"; /* in the order of enum ts_face */
	size_t n = strlen(text);

	for (size_t side = 0; side < 2; side++) {
		const char *letter = n == 1 || n == 2 ? strchr(letters, text[n == 2 ? side : 0]) : NULL;

		if (!letter)
			return ts_fail(&sim->error, TS_SYNTAX, where,
				       "boundary: %c is '%s', expected p, f, s or m, or two of f, s, m", dim,
				       text);
		face[side] = (enum ts_face)(letter - letters);
	}
	if ((face[0] == TS_FACE_PERIODIC) != (face[1] == TS_FACE_PERIODIC))
		return ts_fail(&sim->error, TS_SYNTAX, where,
			       "boundary: %c is '%s', but both faces must be periodic or none", dim, text);
	return TS_OK;
}

enum ts_status ts_domain_read_faces(struct tsim *sim, const char *const text[3], const struct ts_place *where,
				    enum ts_face face[3][2])
{
	for (int d = 0; d < 3; d++)
		TS_TRY(parse_faces(sim, text[d], (char)('x' + d), ts_sim_word_of(sim, text[d], where),
				   face[d]));
	return TS_OK;
}

static enum ts_status check_box_in_2d(struct tsim *sim, const double lo[3], const double hi[3],
				      const struct ts_place *where)
{
	if (sim->dimension == 3)
		return TS_OK;
	if (!ts_box_periodic(&sim->domain->box, 2))
		return ts_fail(&sim->error, TS_STATE, where,
			       "dimension 2 needs a box that is periodic in z: boundary x y p");
	if (lo[2] < 0 && hi[2] > 0)
		return TS_OK;
	return ts_fail(&sim->error, TS_RANGE, where,
		       "the box reaches from z = %g to %g; with dimension 2 it must contain the plane z = 0",
		       lo[2], hi[2]);
}

enum ts_status ts_domain_set_box(struct tsim *sim, const double lo[3], const double hi[3],
				 const struct ts_place *where)
{
	struct ts_domain *d = sim->domain;

	for (int k = 0; k < 3; k++)
		if (!isfinite(lo[k]) || !isfinite(hi[k]) || !(lo[k] < hi[k]))
			return ts_fail(&sim->error, TS_RANGE, where, "the box would reach from %c = %g to %g",
				       'x' + k, lo[k], hi[k]);
	TS_TRY(check_box_in_2d(sim, lo, hi, where));
	for (int k = 0; k < 3; k++) {
		d->first_lo[k] = lo[k];
		d->first_hi[k] = hi[k];
		d->box.lo[k] = lo[k];
		d->box.hi[k] = hi[k];
		if (d->box.face[k][0] == TS_FACE_SHRINK)
			d->box.lo[k] -= ts_domain_margin(d, k);
		if (d->box.face[k][1] == TS_FACE_SHRINK)
			d->box.hi[k] += ts_domain_margin(d, k);
	}
	sim->has_box = true;
	return TS_OK;
}

double ts_domain_scale(const struct tsim *sim, int units, int dim)
{
	bool lattice = units < 0 ? sim->units == TS_UNITS_LJ : units == 0;

	return lattice ? sim->domain->lattice.spacing[dim] : 1;
}

void ts_domain_units_said(struct tsim *sim, int units, const struct ts_place *where)
{
	const double *spacing = sim->domain->lattice.spacing;
	bool matters = spacing[0] != 1 || spacing[1] != 1 || spacing[2] != 1;

	if (units >= 0 || !matters || sim->domain->units_warned)
		return;
	sim->domain->units_warned = true;
	ts_warn(&sim->log, where, "%s; say `units lattice` or `units box`",
		sim->units == TS_UNITS_LJ ? "with units lj lengths are multiplied by the lattice spacings, "
					    "as in LAMMPS; LIGGGHTS takes them as they are"
					  : "lengths are taken as they are, as in LIGGGHTS; LAMMPS "
					    "multiplies them by the lattice spacings");
}

static enum ts_status init_domain(struct ts_instance *self, struct tsim *sim)
{
	struct ts_domain *d = self->state;

	for (int k = 0; k < 3; k++)
		d->drift[k] = 0; /* fix deform sets it again */
	d->shear_drift = 0;
	(void)sim;
	if (!(d->lattice.constant > 0))
		ts_lattice_clear(&d->lattice);
	return TS_OK;
}

static void release_domain(struct ts_instance *self)
{
	ts_lattice_release(&((struct ts_domain *)self->state)->lattice);
}

static void fingerprint_domain(const struct ts_instance *self, const struct tsim *sim, struct ts_hash *hash)
{
	const struct ts_domain *d = self->state;

	(void)sim;
	ts_hash_add(hash, d->box.lo, sizeof d->box.lo);
	ts_hash_add(hash, d->box.hi, sizeof d->box.hi);
	ts_hash_add(hash, d->box.face, sizeof d->box.face);
	if (d->box.shear.on)
		ts_hash_add(hash, &d->box.shear.offset, sizeof d->box.shear.offset);
}

static enum ts_status report_box(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report)
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
	ts_report_line(report, "box", "(%g %g %g) to (%g %g %g), faces %.8s", d->box.lo[0], d->box.lo[1],
		       d->box.lo[2], d->box.hi[0], d->box.hi[1], d->box.hi[2], faces);
	if (d->box.shear.on)
		ts_report_line(report, "box", "images across %c displaced along %c by %g",
			       'x' + d->box.shear.gradient, 'x' + d->box.shear.flow,
			       d->box.shear.offset + (double)d->box.shear.turns *
							     ts_box_length(&d->box, d->box.shear.flow));
	return TS_OK;
}

/* Only of sheared boxes. */
static enum ts_status archive_shear(struct ts_domain *d, struct ts_archive *a)
{
	struct ts_shear *s = &d->box.shear;
	double number[5] = { s->flow, s->gradient, s->offset, (double)s->turns, d->held_offset };

	if (ts_archive_writing(a) ? !s->on : !ts_archive_has(a, "shear"))
		return TS_OK;
	TS_TRY(ts_archive_fixed(a, "shear", TS_SAVED_F64, number, 5));
	if (!(number[0] >= 0 && number[0] < number[1] && number[1] <= 2 && fabs(number[3]) < TS_TURNS_MOST &&
	      isfinite(number[2]) && isfinite(number[4])))
		return TS_DAMAGED;
	*s = (struct ts_shear){ .on = true,
				.flow = (int)number[0],
				.gradient = (int)number[1],
				.offset = number[2],
				.turns = (int64_t)number[3] };
	d->held_offset = number[4];
	return TS_OK;
}

static enum ts_status archive_box_at_rebuild(struct ts_domain *d, struct ts_archive *a)
{
	double held[6];

	for (int k = 0; k < 3; k++) {
		held[k] = d->held_lo[k];
		held[3 + k] = d->held_hi[k];
	}
	TS_TRY(ts_archive_fixed(a, "held", TS_SAVED_F64, held, 6));
	for (int k = 0; k < 3; k++) {
		d->held_lo[k] = held[k];
		d->held_hi[k] = held[3 + k];
	}
	return TS_OK;
}

static void list_settings(const struct ts_instance *self, const struct tsim *sim, struct ts_str *out)
{
	static const char letters[] = "pfsm"; /* in the order of enum ts_face */
	const struct ts_domain *d = self->state;
	char faces[12] = "";
	bool periodic = true;

	(void)sim;
	for (int k = 0; k < 6; k++) {
		faces[k + k / 2] = letters[d->box.face[k / 2][k % 2]];
		faces[k + k / 2 + 1] = k % 2 && k < 5 ? ' ' : '\0';
		periodic &= d->box.face[k / 2][k % 2] == TS_FACE_PERIODIC;
	}
	ts_setting(out, periodic, "boundary %s", faces);
}

static enum ts_status archive_domain(struct ts_instance *self, struct tsim *sim, struct ts_archive *a)
{
	struct ts_domain *d = self->state;

	TS_TRY(ts_lattice_archive(&d->lattice, sim, a));
	if (!ts_archive_writing(a) && !ts_archive_has(a, "held")) /* files of version 1 */
		ts_domain_hold(d);
	else
		TS_TRY(archive_box_at_rebuild(d, a));
	if (archive_shear(d, a) != TS_OK)
		return ts_fail(&sim->error, TS_DAMAGED, NULL, "impossible shear of the simulation box");
	if (ts_archive_writing(a))
		return TS_OK;
	for (int k = 0; k < 3; k++)
		if (!(d->box.lo[k] < d->box.hi[k]) || !isfinite(d->box.hi[k] - d->box.lo[k]) ||
		    !(d->first_lo[k] < d->first_hi[k]) || d->box.face[k][0] > TS_FACE_MINIMUM ||
		    d->box.face[k][1] > TS_FACE_MINIMUM ||
		    ts_box_periodic(&d->box, k) != (d->box.face[k][1] == TS_FACE_PERIODIC))
			return ts_fail(&sim->error, TS_DAMAGED, NULL, "impossible simulation box");
	sim->has_box = true;
	return TS_OK;
}

static const struct ts_saved saved[] = {
	TS_SAVE_F64(struct ts_domain, box.lo),	 TS_SAVE_F64(struct ts_domain, box.hi),
	TS_SAVE_I32(struct ts_domain, box.face), TS_SAVE_F64(struct ts_domain, first_lo),
	TS_SAVE_F64(struct ts_domain, first_hi), TS_SAVED_ROWS_END,
};

const struct ts_system_style ts_domain_system = {
	.style = { .name = "domain",
		   .kind = TS_KIND_SYSTEM,
		   .summary = "the simulation box and its faces",
		   .state_size = sizeof(struct ts_domain),
		   .saved = saved,
		   .archive = archive_domain,
		   .fingerprint = fingerprint_domain,
		   .init = init_domain,
		   .ranks = TS_RANKS_ROWLESS,
		   .plan = report_box,
		   .fini = release_domain },
	.slot = offsetof(struct tsim, domain),
	.settings = list_settings,
};
