/* Fix massflow/mesh: mass and number of particles that pass a mesh. */
#include "base/sort.h"
#include "box/domain.h"
#include "core/ranks.h"
#include "core/unclaimed_state.h"
#include "geom/box_images.h"
#include "io/csv.h"
#include "mesh/mesh_surface.h"
#include "mesh/mesh_touch.h"
#include "mesh/mesh_tree.h"
#include "neigh/neigh.h"
#include "particle/columns.h"
#include "particle/particles.h"
#include "particle/quantity.h"
#include "particle/rank_sums.h"
#include "rigid/rigid.h"
#include "thermo/thermo.h"
#include "wall/mesh_sieve.h"

#include <inttypes.h>
#include <stdlib.h>

#include "core/sim.h"

#include "base/banned.h"

/* Totals that had passed at a time. */
struct mark {
	double mass, number, time;
};

/* Passage of a particle through a triangle, as all ranks get it. */
struct passage {
	int32_t triangle, tag;
	int32_t body; /* its rigid body, or 0 */
	int32_t held; /* 1: by the sieve */
	double part;  /* of the particle in the mass of its body */
	double mass, radius, x[3], v[3];
	double property; /* that is summed, or 0 */
};

/* A member of a body that a particle has passed with. */
struct member {
	int32_t body, tag;
	bool done; /* it has passed, too */
};

struct state {
	/* arguments */
	const char *mesh, *file, *append, *property;
	double side[3], outlet[3];
	int count;
	int64_t interval;
	bool inside_out, screen, write_time, deletes;
	struct ts_mesh_sieve sieve;
	bool warned; /* that the sieve is too soft */

	struct ts_mesh_surface *surface;
	struct ts_mesh_tree tree;
	uint64_t moves; /* surface->moves when the tree was built */
	struct ts_mesh_list list;
	struct ts_parcel passages; /* struct passage, in this step */
	size_t column;		   /* particle column with the marks */
	size_t summed, component;  /* particle column and component of sum_property */
	struct ts_textfile out;
	/* saved */
	double mass, number, deleted_mass, deleted_number, sum;
	struct mark before; /* totals at the start of the present interval */
	int64_t *doomed;    /* ids of particles that have passed and will be deleted at the next rebuild */
	size_t ndoomed, capacity;
};

enum { ONCE, MULTIPLE };
static const char *const count_names[] = { "once", "multiple", NULL };

/* Marks of particles, output as f_massflow_ID. */
enum { UNKNOWN = -1, INSIDE = 0, OUTSIDE = 1, DONE = 2 };

/* ---- before a run ---- */

static bool has_side(const struct state *s)
{
	return !isnan(s->side[0]);
}

static enum ts_status check_words(struct ts_instance *self, struct tsim *sim)
{
	const struct state *s = self->state;
	bool point = !isnan(s->outlet[0]);

	if (has_side(s) == point)
		return ts_fail(&sim->error, TS_SYNTAX, &self->where,
			       "fix massflow/mesh: expected one of vec_side, point_at_outlet, found %s",
			       point ? "both" : "none");
	if (point && s->count != ONCE)
		return ts_fail(&sim->error, TS_SYNTAX, ts_instance_word(self, "point_at_outlet"),
			       "fix massflow/mesh: point_at_outlet requires `count once`");
	if (s->inside_out && !point)
		return ts_fail(&sim->error, TS_SYNTAX, ts_instance_word(self, "inside_out"),
			       "fix massflow/mesh: inside_out has a meaning with point_at_outlet only");
	if (s->deletes && s->count != ONCE)
		return ts_fail(&sim->error, TS_SYNTAX, ts_instance_word(self, "delete_atoms"),
			       "fix massflow/mesh: delete_atoms requires `count once`");
	return ts_textfile_choose(&sim->error, ts_instance_word(self, "append"), self->style->name, s->file,
				  s->append);
}

static enum ts_status check_side(struct ts_instance *self, struct tsim *sim)
{
	const struct state *s = self->state;
	const struct ts_mesh *m = &s->surface->mesh;
	double length = ts_norm(s->side);
	size_t bend;

	if (!(length > 0))
		return ts_fail(&sim->error, TS_RANGE, ts_instance_word(self, "vec_side"),
			       "fix massflow/mesh: vec_side has no length");
	if (!ts_mesh_planar(m, &bend))
		return ts_fail(&sim->error, TS_RANGE, ts_instance_word(self, s->mesh),
			       "fix massflow/mesh: mesh %s is not planar (see its triangle %zu), which "
			       "vec_side needs; for others use point_at_outlet",
			       s->mesh, bend / 3 + 1);
	for (size_t t = 0; t < m->n; t++)
		if (!(fabs(ts_dot(m->normal[t], s->side)) > 1e-5 * length))
			return ts_fail(&sim->error, TS_RANGE, ts_instance_word(self, "vec_side"),
				       "fix massflow/mesh: vec_side lies in the plane of the mesh and does "
				       "not say which of its sides is meant");
	return TS_OK;
}

/* `fresh`: the fix has just been defined, perhaps anew; no particle is marked, unless a restart file says so. */
static enum ts_status add_mark_column(struct ts_instance *self, struct tsim *sim, bool fresh)
{
	struct state *s = self->state;
	struct ts_particles *p = sim->particles;
	const double first = UNKNOWN;
	size_t known = p->ncolumns;
	char name[128];

	snprintf(name, sizeof name, "massflow_%.100s", self->id);
	TS_TRY(ts_particles_add_column(sim, name, 1, TS_COL_NAMED, &s->column));
	TS_TRY(ts_particles_column_initial(sim, s->column, &first));
	if (s->column == known || (fresh && !ts_unclaimed_exists(sim, self)))
		ts_particles_fill_initial(&p->column[s->column], 0, p->n);
	return TS_OK;
}

static enum ts_status find_property(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	const struct ts_column *column;

	if (!s->property)
		return TS_OK;
	column = ts_particles_named_column(sim->particles, s->property, &s->component);
	if (!column)
		return ts_fail(&sim->error, TS_UNKNOWN, ts_instance_word(self, s->property),
			       "fix massflow/mesh: no fix property/atom keeps a number '%s'", s->property);
	s->summed = (size_t)(column - sim->particles->column);
	return TS_OK;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	struct ts_word mesh = { .text = s->mesh, .place = *ts_instance_word(self, s->mesh) };
	const bool fresh = !s->surface;

	if (fresh)
		s->before.time = ts_sim_time(sim);
	TS_TRY(check_words(self, sim));
	sim->neigh->skin_observed |=
		s->deletes; /* particles are deleted at rebuilds, whose steps depend on it */
	TS_TRY(ts_mesh_surface_require(sim, &mesh, &s->surface));
	ts_mesh_tree_release(&s->tree);
	if (has_side(s))
		TS_TRY(check_side(self, sim));
	TS_TRY(add_mark_column(self, sim, fresh));
	TS_TRY(ts_mesh_sieve_init(self, sim, &s->sieve));
	return find_property(self, sim);
}

static enum ts_status begin_table(struct state *s, struct tsim *sim)
{
	static const char *const names[] = { "diameter", "x", "y", "z", "vx", "vy", "vz" };
	struct ts_str row = { 0 };

	ts_csv_text(&row, "id");
	if (s->write_time)
		ts_csv_text(&row, "time");
	ts_csv_names(&row, names, sizeof names / sizeof *names);
	ts_csv_end(&row);
	return ts_csv_begin(&s->out, sim, &row);
}

static enum ts_status write_table_row(struct state *s, struct tsim *sim, const struct passage *p)
{
	struct ts_str row = { 0 };

	ts_csv_int(&row, p->tag);
	if (s->write_time)
		ts_csv_real(&row, ts_sim_time(sim));
	ts_csv_real(&row, 2 * p->radius);
	for (int d = 0; d < 3; d++)
		ts_csv_real(&row, p->x[d]);
	for (int d = 0; d < 3; d++)
		ts_csv_real(&row, p->v[d]);
	ts_csv_end(&row);
	return ts_csv_write(&s->out, sim, &row);
}

static enum ts_status setup(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	const char *path = s->file ? s->file : s->append;

	if (!path || ts_textfile_is_open(&s->out))
		return TS_OK;
	TS_TRY(ts_textfile_open(&s->out, sim, ts_instance_word(self, path), path, s->append != NULL));
	if (ts_csv_is(path))
		return begin_table(s, sim);
	TS_TRY(ts_textfile_printf(&s->out, "# ID %sdiameter x y z u v w  (ex ey ez, color)\n",
				  s->write_time ? "time  " : ""));
	return ts_textfile_flush(&s->out);
}

/* ---- counting ---- */

static enum ts_status write_passage(struct state *s, struct tsim *sim, const struct passage *p)
{
	char text[256], time[40] = "";

	snprintf(text, sizeof text, "%4.4g %4.4g %4.4g %4.4g %4.4g %4.4g %4.4g", 2 * p->radius, p->x[0],
		 p->x[1], p->x[2], p->v[0], p->v[1], p->v[2]);
	if (s->write_time)
		snprintf(time, sizeof time, " %4.4g  ", ts_sim_time(sim));
	if (s->screen)
		ts_log(&sim->log, " %" PRId32 " %s%s \n", p->tag, time, text);
	if (!ts_textfile_is_open(&s->out))
		return TS_OK;
	if (ts_csv_is(s->file ? s->file : s->append))
		return write_table_row(s, sim, p);
	TS_TRY(ts_textfile_printf(&s->out, "%" PRId32 " %s%s\n", p->tag, time, text));
	return ts_textfile_flush(&s->out);
}

static double *particle_mark(const struct state *s, const struct tsim *sim, size_t i)
{
	return (double *)sim->particles->column[s->column].data + i;
}

/* A member of a rigid body counts by its fraction of the mass of the body. */
static double body_fraction(const struct tsim *sim, size_t i)
{
	const struct ts_body *body = ts_rigid_body_of(sim, i);

	return body ? sim->particles->mass[i] / body->mass : 1;
}

static double summed_property(const struct state *s, const struct tsim *sim, size_t i)
{
	const struct ts_column *column = &sim->particles->column[s->summed];

	return ((const double *)column->data)[i * column->width + s->component];
}

static enum ts_status mark_for_deletion(struct state *s, struct tsim *sim, int32_t tag)
{
	if (TS_GROW(s->doomed, s->capacity, s->ndoomed + 1) != TS_OK)
		return ts_nomem(&sim->error);
	s->doomed[s->ndoomed++] = tag;
	return TS_OK;
}

static const struct passage *passages_of(const struct state *s, size_t *n)
{
	*n = s->passages.n / sizeof(struct passage);
	return (const struct passage *)(const void *)s->passages.data;
}

static void warn_of_soft_sieve(struct ts_instance *self, struct tsim *sim, const struct passage *p)
{
	struct state *s = self->state;

	if (!p->held || s->warned)
		return;
	s->warned = true;
	ts_warn(&sim->log, ts_instance_word(self, "sieveStiffness"),
		"fix massflow/mesh %s: particle %" PRId32
		" has got through the sieve that held it: it needs a higher "
		"sieveStiffness (once told)",
		self->id, p->tag);
}

static enum ts_status count_passage(struct state *s, struct tsim *sim, const struct passage *p)
{
	s->mass += p->mass;
	s->number += p->part;
	s->sum += p->property;
	TS_TRY(write_passage(s, sim, p));
	return s->deletes && !p->body ? mark_for_deletion(s, sim, p->tag) : TS_OK;
}

/* ---- bodies that have passed */

static int by_body(const void *a, const void *b)
{
	const struct member *p = a, *q = b;

	if (p->body != q->body)
		return p->body < q->body ? -1 : 1;
	return (p->tag > q->tag) - (p->tag < q->tag);
}

/* Appends the members, among the particles of this rank, of the body of a passage. */
static enum ts_status add_members(const struct state *s, const struct tsim *sim, int32_t body,
				  struct ts_parcel *out)
{
	const struct ts_rigid *r = sim->rigid;
	size_t b = body ? ts_rigid_find(r, body) : r->n;

	for (size_t k = b < r->n ? r->start[b] : 0; b < r->n && k < r->start[b + 1]; k++) {
		size_t i = (size_t)r->member[k];
		struct member m = { .body = body };

		if (i >= sim->particles->n)
			continue;
		m.tag = sim->particles->tag[i];
		m.done = *particle_mark(s, sim, i) > DONE - 0.5;
		TS_TRY(ts_parcel_add(out, &m, sizeof m));
	}
	return TS_OK;
}

/* The members of n bodies of passages, those of one together. */
static enum ts_status mark_whole_bodies(struct state *s, struct tsim *sim, struct member *m, size_t n)
{
	ts_sort(m, n, sizeof *m, by_body);
	for (size_t k = 0, end; k < n; k = end) {
		bool done = true;

		for (end = k; end < n && m[end].body == m[k].body; end++)
			done &= m[end].done;
		for (size_t j = k; done && j < end; j++)
			TS_TRY(mark_for_deletion(s, sim, m[j].tag));
	}
	return TS_OK;
}

/* Marks the bodies for deletion all of whose members have passed. */
static enum ts_status delete_bodies(struct state *s, struct tsim *sim)
{
	struct ts_parcel mine = { 0 }, all = { 0 };
	size_t n;
	const struct passage *p = passages_of(s, &n);
	enum ts_status status = ts_rigid_list(sim);

	for (size_t k = 0; k < n && status == TS_OK; k++)
		status = add_members(s, sim, p[k].body, &mine);
	if (status == TS_OK && sim->division)
		status = ts_world_share(sim->world, &mine, &all);
	if (status == TS_OK) {
		struct ts_parcel *of = sim->division ? &all : &mine;

		status = mark_whole_bodies(s, sim, (struct member *)(void *)of->data,
					   of->n / sizeof(struct member));
	}
	ts_parcel_release(&mine);
	ts_parcel_release(&all);
	return status;
}

/* Passages of all ranks, in the order of one. */
static enum ts_status count_passages(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	size_t n;
	const struct passage *p = passages_of(s, &n);
	bool bodies = false;

	for (size_t k = 0; k < n; k++) {
		warn_of_soft_sieve(self, sim, &p[k]);
		TS_TRY(count_passage(s, sim, &p[k]));
		bodies |= p[k].body != 0;
	}
	return s->deletes && bodies ? delete_bodies(s, sim) : TS_OK;
}

/* ---- passages */

/* Whether x is on the outer side of the mesh; `at`: the point of the mesh nearest to x. */
static bool is_outside(const struct state *s, const double x[3], const struct ts_mesh_contact_point *at)
{
	double towards[3], side;

	if (has_side(s))
		return at->distance * ts_dot(at->n, s->side) > 0;
	ts_sub(s->outlet, x, towards);
	side = at->distance * ts_dot(at->n, towards);
	return s->inside_out ? side < 0 : side > 0;
}

/* Updates the mark of a particle near a triangle; whether it passes now. Beyond a rim of the mesh it may
 * get to the inner side, but it does not pass there. */
static bool update_mark(const struct state *s, double *mark, enum ts_mesh_part part, bool outside)
{
	bool inside_before = *mark > INSIDE - 0.5 && *mark < INSIDE + 0.5;

	if (*mark > DONE - 0.5)
		return false;
	if (!outside) {
		*mark = INSIDE;
		return false;
	}
	if (part == TS_MESH_FACE) {
		*mark = s->count == ONCE ? DONE : OUTSIDE;
		return inside_before;
	}
	if (*mark < INSIDE - 0.5)
		*mark = OUTSIDE;
	return false;
}

static enum ts_status add_passage(struct state *s, struct tsim *sim, int32_t triangle, size_t i)
{
	const struct ts_particles *p = sim->particles;
	struct passage passage = { .triangle = triangle,
				   .tag = p->tag[i],
				   .body = ts_rigid_member(p, i) ? p->body[i] : 0,
				   .held = ts_mesh_sieve_holds(&s->sieve, sim, i),
				   .part = body_fraction(sim, i),
				   .mass = p->mass[i],
				   .radius = p->radius[i] };

	for (int d = 0; d < 3; d++) {
		passage.x[d] = p->x[i][d];
		passage.v[d] = p->v[i][d];
	}
	if (s->property)
		passage.property = passage.part * summed_property(s, sim, i);
	return ts_parcel_add(&s->passages, &passage, sizeof passage) == TS_OK ? TS_OK : ts_nomem(&sim->error);
}

/* x: the place of particle i as an image of the mesh sees it. */
static enum ts_status check_image(struct state *s, struct tsim *sim, size_t i, const double x[3],
				  double reach)
{
	double *mark = particle_mark(s, sim, i);

	if (ts_mesh_tree_near(&s->tree, &s->surface->mesh, x, reach, &s->list) != TS_OK)
		return ts_nomem(&sim->error);
	for (size_t k = 0; k < s->list.n; k++) {
		struct ts_mesh_contact_point at;
		enum ts_mesh_part part = ts_mesh_nearest(&s->surface->mesh, (size_t)s->list.item[k], x, &at);

		if (part != TS_MESH_NOTHING && at.distance <= reach)
			if (update_mark(s, mark, part, is_outside(s, x, &at)))
				TS_TRY(add_passage(s, sim, s->list.item[k], i));
	}
	return TS_OK;
}

/* A particle is near a triangle, or a periodic image of one, if the distance of its centre is at most its radius plus half
 * the skin of the neighbour list. */
static enum ts_status check_particle(struct state *s, struct tsim *sim, size_t i)
{
	const struct ts_particles *p = sim->particles;
	const struct ts_box *box = &sim->domain->box;
	const double *lo = s->tree.lo[1], *hi = s->tree.hi[1];
	double reach = p->radius[i] + 0.5 * sim->neigh->built_skin, far = 1.001 * reach, x[3];
	struct ts_box_images images;

	for (int d = 0; d < 3; d++) /* most particles are far from the whole mesh */
		if (!ts_box_periodic(box, d) && (p->x[i][d] < lo[d] - far || p->x[i][d] > hi[d] + far))
			return TS_OK;
	if (*particle_mark(s, sim, i) > DONE - 0.5)
		return TS_OK;
	images = ts_box_images(box, lo, hi, p->x[i], p->x[i], reach);
	while (ts_box_images_next(&images)) {
		ts_box_images_place(box, images.shift, p->x[i], x);
		TS_TRY(check_image(s, sim, i, x, reach));
	}
	return TS_OK;
}

/* The order of passages in LIGGGHTS. */
static int by_triangle(const void *a, const void *b)
{
	const struct passage *p = a, *q = b;

	if (p->triangle != q->triangle)
		return p->triangle < q->triangle ? -1 : 1;
	return (p->tag > q->tag) - (p->tag < q->tag);
}

static int by_tag(const void *a, const void *b)
{
	const int64_t *p = a, *q = b;

	return (*p > *q) - (*p < *q);
}

/* Whether the last step ended an averaging interval: it was a multiple of `interval`; without `interval`,
 * thermo output was written in it; with thermo output at the ends of runs only, the run began in it.
 * Reading the rates does not end an interval. */
static bool has_interval_ended(const struct state *s, const struct tsim *sim)
{
	const struct ts_thermo *t = sim->thermo;
	int64_t last = sim->clock.step - 1;

	if (s->interval > 0)
		return last % s->interval == 0;
	return t->every || t->variable ? t->counted == last + 1 : last == sim->clock.first_step;
}

/* While particles are divided: passages of all ranks. */
static enum ts_status share_passages(struct state *s, struct tsim *sim)
{
	struct ts_parcel all = { 0 };
	enum ts_status status = TS_OK;

	if (!sim->division || !(ts_ranks_most(sim, (double)s->passages.n) > 0))
		return TS_OK;
	status = ts_world_share(sim->world, &s->passages, &all);
	ts_parcel_release(&s->passages);
	s->passages = all;
	return status == TS_OK ? TS_OK : ts_nomem(&sim->error);
}

/* The tree of the present mesh. */
static enum ts_status renew_tree(struct state *s, struct tsim *sim)
{
	if (s->tree.n && s->moves == s->surface->moves)
		return TS_OK;
	ts_mesh_tree_release(&s->tree);
	if (ts_mesh_tree_build(&s->tree, &s->surface->mesh) != TS_OK)
		return ts_nomem(&sim->error);
	s->moves = s->surface->moves;
	return TS_OK;
}

static enum ts_status post_integrate(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	const struct ts_particles *p = sim->particles;

	if (has_interval_ended(s, sim))
		s->before = (struct mark){ s->mass, s->number, ts_sim_time(sim) - sim->clock.dt };
	s->passages.n = 0;
	TS_TRY(renew_tree(s, sim));
	for (size_t i = 0; i < p->n; i++)
		if (ts_in_group(p, i, self->group))
			TS_TRY(check_particle(s, sim, i));
	TS_TRY(share_passages(s, sim));
	ts_sort(s->passages.data, s->passages.n / sizeof(struct passage), sizeof(struct passage),
		by_triangle);
	return count_passages(self, sim);
}

static enum ts_status post_force(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	if (!ts_mesh_sieve_is(&s->sieve))
		return TS_OK;
	ts_deferred_loops_run(sim);
	TS_TRY(renew_tree(s, sim));
	return ts_mesh_sieve_add_forces(self, sim, &s->sieve, s->surface, &s->tree, &s->list);
}

static void add_ground(const struct ts_instance *self, const struct tsim *sim, size_t i,
		       struct ts_ground_springs *sum)
{
	const struct state *s = self->state;

	if (ts_mesh_sieve_is(&s->sieve))
		ts_mesh_sieve_ground(&s->sieve, sim, i, sum);
}

/* ---- deleting ---- */

/* Deletes those particles of this rank. */
static enum ts_status delete_doomed(struct state *s, struct tsim *sim, unsigned char *flag)
{
	const struct ts_particles *p = sim->particles;
	struct ts_exactsum sum[2] = { ts_exactsum_start(), ts_exactsum_start() };

	ts_sort(s->doomed, s->ndoomed, sizeof *s->doomed, by_tag);
	for (size_t i = 0; i < p->n; i++) {
		int64_t tag = p->tag[i];

		flag[i] = bsearch(&tag, s->doomed, s->ndoomed, sizeof tag, by_tag) != NULL;
		if (!flag[i])
			continue;
		ts_exactsum_add(&sum[0], body_fraction(sim, i));
		ts_exactsum_add(&sum[1], p->mass[i]);
	}
	ts_rank_sums_merge(sim, sum, 2);
	s->deleted_number += ts_exactsum_value(&sum[0]);
	s->deleted_mass += ts_exactsum_value(&sum[1]);
	return ts_particles_delete(sim, flag);
}

static enum ts_status exchange(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	unsigned char *flag;
	enum ts_status status;

	if (!s->ndoomed)
		return TS_OK;
	flag = ts_alloc(sim->particles->n, 1);
	status = flag ? delete_doomed(s, sim, flag) : ts_nomem(&sim->error);
	ts_free(flag);
	s->ndoomed = 0;
	return status;
}

/* ---- outputs ---- */

static double mean_rate(const struct state *s, const struct tsim *sim, double before, double now)
{
	double time = ts_sim_time(sim) - s->before.time;

	return time > 0.5 * sim->clock.dt ? (now - before) / time : 0;
}

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct state *s = self->state;

	TS_TRY(ts_table_resize(out, s->property ? 7 : 6, 1));
	out->data[0] = s->mass;
	out->data[1] = s->number;
	out->data[2] = mean_rate(s, sim, s->before.mass, s->mass);
	out->data[3] = mean_rate(s, sim, s->before.number, s->number);
	out->data[4] = s->deleted_mass;
	out->data[5] = s->deleted_number;
	if (s->property)
		out->data[6] = s->sum;
	return TS_OK;
}

/* Older restart files have the step instead of the time. */
static enum ts_status archive_time(struct state *s, const struct tsim *sim, struct ts_archive *a)
{
	int64_t step;

	if (ts_archive_writing(a) || ts_archive_has(a, "before.time"))
		return ts_archive_fixed(a, "before.time", TS_SAVED_F64, &s->before.time, 1);
	TS_TRY(ts_archive_fixed(a, "before.step", TS_SAVED_I64, &step, 1));
	s->before.time = ts_sim_time(sim) - (double)(sim->clock.step - step) * sim->clock.dt;
	return TS_OK;
}

static enum ts_status archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a)
{
	struct state *s = self->state;
	void *doomed = s->doomed;
	enum ts_status status;

	TS_TRY(archive_time(s, sim, a));
	TS_TRY(ts_particles_archive_column(a, sim, "marks", s->column));
	if (ts_mesh_sieve_is(&s->sieve))
		TS_TRY(ts_particles_archive_column(a, sim, "sieve", s->sieve.column));
	status = ts_archive_array(a, "doomed", TS_SAVED_I64, &doomed, &s->capacity, &s->ndoomed);
	s->doomed = doomed;
	return status;
}

static void fini(struct ts_instance *self)
{
	struct state *s = self->state;

	ts_mesh_tree_release(&s->tree);
	ts_textfile_close(&s->out);
	ts_free(s->list.item);
	ts_parcel_release(&s->passages);
	ts_free(s->doomed);
}

static const struct ts_arg args[] = {
	TS_WORD("mesh", struct state, mesh, .help = "ID of the fix mesh/surface"),
	TS_VEC3("vec_side", struct state, side, .flags = TS_OPTIONAL,
		.help = "points to the outer side of a planar mesh"),
	TS_ENUM("count", struct state, count, count_names, .fallback = "multiple", .flags = TS_STATEFUL,
		.help = "once: each particle counts at most once; multiple: it counts again if it comes back "
			"and passes again"),
	TS_VEC3("point_at_outlet", struct state, outlet, .flags = TS_OPTIONAL, .unit = "length",
		.help = "a point on the outer side of any mesh"),
	TS_FLAG("inside_out", struct state, inside_out, .help = "the point is on the inner side"),
	TS_WORD("file", struct state, file, .flags = TS_OPTIONAL | TS_WRITES,
		.help = "file to which a line is written for each particle that passes; comma-separated "
			"values if it ends in .csv"),
	TS_WORD("append", struct state, append, .flags = TS_OPTIONAL | TS_WRITES,
		.help = "the same, appended to the file"),
	TS_BOOL("screen", struct state, screen, .fallback = "no",
		.help = "whether these lines are printed to screen and log"),
	TS_FLAG("writeTime", struct state, write_time, .help = "these lines include the time"),
	TS_BOOL("delete_atoms", struct state, deletes, .fallback = "no",
		.help = "whether particles that pass are deleted, at the next rebuild of the neighbour list"),
	TS_INT("interval", struct state, interval, .flags = TS_OPTIONAL | TS_STATEFUL, .range = TS_POSITIVE,
	       .help = "f_ID[3], f_ID[4] are rates since the last multiple of this number of steps, before "
		       "this one; without it, since the last thermo output"),
	TS_WORD("sum_property", struct state, property, .flags = TS_OPTIONAL | TS_STATEFUL,
		.help = "NAME or NAME[k], a value of fix property/atom that is summed over the particles "
			"that pass"),
	TS_MESH_SIEVE_ROWS(struct state, sieve),
	TS_ARGS_END,
};

static const struct ts_value values[] = {
	{ "passed", "mass, 1, mass/time, 1/time, mass, 1, that of the property",
	  "mass and number that have passed, both per time since the last thermo output, mass and number "
	  "deleted; with sum_property its sum",
	  TS_VECTOR, 0, NULL, eval },
	{ .name = NULL },
};

static const struct ts_saved saved[] = {
	TS_SAVE_F64(struct state, mass),	  TS_SAVE_F64(struct state, number),
	TS_SAVE_F64(struct state, deleted_mass),  TS_SAVE_F64(struct state, deleted_number),
	TS_SAVE_F64(struct state, sum),		  TS_SAVE_F64(struct state, before.mass),
	TS_SAVE_F64(struct state, before.number), TS_SAVED_ROWS_END,
};

static const char sieve_doc[] =
	"With sieveSize the mesh is a sieve with circular openings of diameter D at distances P = "
	"sieveSpacing, on a square lattice, that are not resolved. When a particle of diameter d touches "
	"the mesh, a random number decides whether it passes, with the probability\n\n"
	"    p = pi/4 ((D - d)/P)^2,  0 for d > D, at most 1\n\n"
	"of a particle that comes normal to the sieve and does not touch the rim of an opening. Until the "
	"contact ends it then feels no force; otherwise it is held by the force sieveStiffness times the "
	"overlap less sieveDamping times the relative velocity, both normal to the mesh, at its nearest "
	"point. There is no friction, and the mesh does not feel the force. The stiffness must be so high "
	"that the centre of no particle gets to the other side. Members of rigid bodies are held. "
	"Particles that roll over a sieve without leaving it are decided upon once. The random numbers are "
	"functions of the ID of the fix, the atom ID and the time step. f_sieve_ID of a particle is 0 away "
	"from the mesh, 1 where it is held, 2 where it passes. For openings of any shape use a mesh with "
	"holes.";

TS_STYLE(fix, ts_style, ts_fix_massflow_mesh)
const struct ts_style ts_fix_massflow_mesh = {
	.name = "massflow/mesh",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_OWN | TS_RANKS_OUTPUTS,
	.summary = "Mass and number of particles that pass a mesh, and their rates",
	.doc = "Counts particles of the group that pass a mesh from its inner to its outer side. A particle "
	       "is near the mesh if the distance of its centre is at most its radius plus half the skin of "
	       "the neighbour list. It passes when it is near a face of the mesh with its centre on the "
	       "outer side, and was on the inner side when it was near the mesh last. Particles that move "
	       "around the rim are not counted. Periodic images of the mesh count, too. The mesh is no "
	       "obstacle unless a fix wall/gran makes it a wall.\n\n"
	       "The outer side is the one to which vec_side points, or, for a mesh of any shape, the side "
	       "where\n\n"
	       "  (x - p).(point_at_outlet - x) > 0,\n\n"
	       "x being the centre and p the nearest point of the mesh. point_at_outlet and delete_atoms "
	       "need `count once`.\n\n"
	       "f_ID[1], f_ID[2]: mass and number of particles that have passed. f_ID[3], f_ID[4]: the same "
	       "per time, over the steps since the last thermo output that `thermo N` asked for, before this "
	       "step (thermo 0: since the run began), or since the last multiple of `interval`. In rows of "
	       "thermo output these are LIGGGHTS' values; in LIGGGHTS, reading them at other steps begins a "
	       "new interval, here it has no effect. f_ID[5], f_ID[6]: mass and number of deleted particles. "
	       "f_ID[7]: with sum_property, the sum of the property over the particles that have passed.\n\n"
	       "A member of a rigid body counts by its fraction of the mass of the body; delete_atoms "
	       "deletes a body when all its members have passed.\n\n"
	       "f_massflow_ID of a particle is -1 if it has not been near the mesh, 0 if it was last on the "
	       "inner side, 1 on the outer side, 2 if it has passed and is not counted again (count "
	       "once).\n\n"
	       "Related: fix mesh/surface, fix property/atom.",
	.doc_more = (const char *const[]){ sieve_doc, NULL },
	.example = "fix outlet all massflow/mesh mesh gate vec_side 0 0 -1 count once file post/outlet.txt\n"
		   "fix screen all massflow/mesh/sieve mesh deck point_at_outlet 0 0 -1 count once &\n"
		   "    sieveSize 2e-3 sieveSpacing 2.5e-3 sieveStiffness 1e3 sieveDamping 0.1",
	.args = args,
	.state_size = sizeof(struct state),
	.saved = saved,
	.archive = archive,
	.values = values,
	.init = init,
	.hook = { [TS_STAGE_POST_INTEGRATE] = post_integrate,
		  [TS_STAGE_POST_FORCE] = post_force,
		  [TS_STAGE_EXCHANGE] = exchange,
		  [TS_STAGE_SETUP] = setup },
	.defers = TS_DEFERS(POST_FORCE),
	.ground = add_ground,
	.fini = fini,
};
