#include "wall/primitive_wall.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "box/domain.h"
#include "core/sim.h"
#include "math/constants.h"
#include "neigh/coincide.h"
#include "neigh/drift_frame.h"
#include "wall/exact_surface.h"
#include "wall/wall_coincide.h"
#include "wall/wall_queue.h"

#include "base/banned.h"

enum { NSHAPES = TS_PRIMITIVE_SHAPES, MOST = TS_MOST_PRIMITIVES };
static const char *const shape_names[NSHAPES] = { "xplane",    "yplane",    "zplane",
						  "xcylinder", "ycylinder", "zcylinder" };

/* ---- arguments ---- */

static bool is_position(const struct ts_word *word)
{
	double number;

	return ts_streq(word->text, "NULL") || ts_parse_real(word->text, &number);
}

/* A word behind enough numbers that is none itself is a misspelled keyword. */
static enum ts_status refuse_keyword(const struct ts_instance *self, struct tsim *sim,
				     const struct ts_word *word)
{
	struct ts_suggest suggest = ts_suggest_start(word->text);

	for (const struct ts_arg *row = self->style->args; row->type != TS_ARG_END; row++)
		if (!(row->flags & TS_POSITIONAL))
			ts_suggest_try(&suggest, row->name);
	return ts_fail(&sim->error, TS_UNKNOWN, &word->place, "fix wall/gran: unknown keyword '%s'%s",
		       word->text, ts_suggest_text(&suggest));
}

/* Parses `least` to `most` numbers, starting at word `first`. The word NULL, for a plane that does not exist,
 * becomes NaN. */
static enum ts_status parse_numbers(const struct ts_instance *self, struct tsim *sim, struct ts_words words,
				    size_t first, const char *what, const char *expected, size_t least,
				    size_t most, double *out)
{
	bool good = words.n >= first + least && words.n <= first + most;
	size_t bad = words.n - 1;

	for (size_t k = first + least; k < words.n; k++)
		if (!is_position(&words.word[k]))
			return refuse_keyword(self, sim, &words.word[k]);
	for (size_t k = first; good && k < words.n; k++) {
		double *number = &out[k - first];

		*number = NAN;
		if (first == 0 && most == MOST && ts_streq(words.word[k].text, "NULL"))
			continue;
		good = ts_parse_real(words.word[k].text, number) && isfinite(*number);
		bad = k;
	}
	if (good)
		return TS_OK;
	return ts_fail(&sim->error, TS_SYNTAX, &words.word[bad].place,
		       "fix wall/gran: %s takes %s, found '%s'", what, expected, words.word[bad].text);
}

/* `zplane z` or, as in LAMMPS, `zplane lo hi` of which either may be NULL. */
static enum ts_status read_plane(const struct ts_instance *self, struct tsim *sim,
				 struct ts_primitive_wall *w, int shape)
{
	double at[MOST];
	struct ts_words words = w->shape_words[shape];

	TS_TRY(parse_numbers(self, sim, words, 0, shape_names[shape],
			     "one position, or two of which either may be NULL", 1, MOST, at));
	w->n = 0;
	for (size_t k = 0; k < words.n; k++)
		if (!isnan(at[k]))
			w->primitive[w->n++] = (struct ts_primitive){ .shape = (enum ts_primitive_shape)shape,
								      .position = at[k] };
	return TS_OK;
}

/* `zcylinder radius x y` or, as in LAMMPS, `zcylinder radius`. */
static enum ts_status read_cylinder(const struct ts_instance *self, struct tsim *sim,
				    struct ts_primitive_wall *w, int shape)
{
	struct ts_words words = w->shape_words[shape];
	double value[3] = { 0 };

	TS_TRY(parse_numbers(self, sim, words, 0, shape_names[shape],
			     "a radius, or a radius and the centre along the next two axes",
			     words.n == 1 ? 1 : 3, 3, value));
	if (!(value[0] > 0))
		return ts_fail(&sim->error, TS_RANGE, &words.word[0].place,
			       "fix wall/gran: the radius of a cylinder must be > 0");
	w->n = 1;
	w->primitive[0] = (struct ts_primitive){ .shape = (enum ts_primitive_shape)shape,
						 .radius = value[0],
						 .centre = { value[1], value[2] } };
	return TS_OK;
}

static int given(const void *geometry)
{
	const struct ts_primitive_wall *w = geometry;
	int n = 0;

	for (int k = 0; k < NSHAPES; k++)
		n += w->shape_words[k].n > 0;
	return n;
}

/* A plane normal to a periodic dimension: LAMMPS refuses it; in LIGGGHTS particles interact with it, their
 * periodic images do not. */
static enum ts_status check_periodic(struct ts_instance *self, struct tsim *sim,
				     const struct ts_primitive_wall *w, int shape)
{
	const struct ts_place *where = ts_instance_word(self, shape_names[shape]);

	if (w->lammps)
		return ts_fail(&sim->error, TS_STATE, where,
			       "fix wall/gran: a plane wall across the periodic dimension %c; let the box be "
			       "fixed there (`boundary`)",
			       'x' + shape);
	ts_warn(&sim->log, where,
		"fix wall/gran: a plane wall across the periodic dimension %c: images do not feel it, so "
		"particles pass through the face of the box, and touch each other through it; walls at both "
		"faces need `boundary` f along %c",
		'x' + shape, 'x' + shape);
	return TS_OK;
}

static enum ts_status read_shape(struct ts_instance *self, struct tsim *sim, struct ts_primitive_wall *w)
{
	int shape = 0;

	while (!w->shape_words[shape].n)
		shape++;
	if (shape >= TS_XCYLINDER)
		return read_cylinder(self, sim, w, shape);
	if (ts_sim_has_box(sim) && ts_box_periodic(&sim->domain->box, shape) && !w->n)
		TS_TRY(check_periodic(self, sim, w, shape));
	return read_plane(self, sim, w, shape);
}

static enum ts_status read_dimension(struct tsim *sim, const struct ts_word *word, const char *what, int *out)
{
	for (*out = 0; *out < 3; ++*out)
		if (word->text[0] == 'x' + *out && !word->text[1])
			return TS_OK;
	return ts_fail(&sim->error, TS_SYNTAX, &word->place,
		       "fix wall/gran: %s is along '%s', expected x, y or z", what, word->text);
}

static enum ts_status read_motion(struct ts_instance *self, struct tsim *sim, struct ts_primitive_wall *w)
{
	double value[2];

	w->wiggle_dim = -1;
	if (w->shear_words.n) {
		TS_TRY(read_dimension(sim, &w->shear_words.word[0], "shear", &w->shear_dim));
		TS_TRY(parse_numbers(self, sim, w->shear_words, 1, "shear", "a dimension and a velocity", 1,
				     1, &w->shear));
	}
	if (!w->wiggle_words.n)
		return TS_OK;
	if (w->shear_words.n)
		return ts_fail(&sim->error, TS_SYNTAX, ts_instance_word(self, "wiggle"),
			       "fix wall/gran: either wiggle or shear");
	TS_TRY(read_dimension(sim, &w->wiggle_words.word[0], "wiggle", &w->wiggle_dim));
	TS_TRY(parse_numbers(self, sim, w->wiggle_words, 1, "wiggle",
			     "a dimension, an amplitude and a period", 2, 2, value));
	w->amplitude = value[0];
	w->period = value[1];
	if (!(w->period > 0))
		return ts_fail(&sim->error, TS_RANGE, &w->wiggle_words.word[2].place,
			       "fix wall/gran: the period of wiggle must be > 0");
	if (!(w->begun > 0))
		w->origin = ts_sim_time(sim);
	w->begun = 1;
	return TS_OK;
}

static enum ts_status find(struct ts_instance *self, struct tsim *sim)
{
	struct ts_wall *wall = self->state;
	struct ts_primitive_wall *w = wall->geometry;

	if (wall->type == INT64_MIN && !wall->given)
		return ts_fail(&sim->error, TS_SYNTAX, &self->where,
			       "fix wall/gran primitive: which `type`?");
	if (wall->type == INT64_MIN) /* LAMMPS' walls have no material */
		wall->type = 1;
	w->type = (int)wall->type;
	w->lammps = wall->given;
	TS_TRY(read_shape(self, sim, w));
	TS_TRY(read_motion(self, sim, w));
	wall->moves = ts_primitive_wall_moves(w);
	wall->warm = !isnan(w->temperature);
	return ts_wall_check_type(self, sim, wall->type, "type");
}

/* ---- motion ---- */

const struct ts_primitive_wall *ts_primitive_wall_of(const struct ts_wall *w)
{
	return w->shape == &ts_primitive_wall_shape ? w->geometry : NULL;
}

bool ts_primitive_wall_moves(const struct ts_primitive_wall *w)
{
	return w->n && (int)w->primitive[0].shape == w->wiggle_dim;
}

/* A (1 - cos(2 pi t/T)), as in LAMMPS. */
static double displacement_at(const struct ts_primitive_wall *w, double time)
{
	double phase = 2 * TS_PI / w->period * (time - w->origin);

	return ts_primitive_wall_moves(w) ? w->amplitude * (1 - cos(phase)) : 0;
}

static double displacement(const struct ts_primitive_wall *w, const struct tsim *sim)
{
	return displacement_at(w, ts_sim_time(sim));
}

static double wiggle_velocity(const struct ts_primitive_wall *w, const struct tsim *sim)
{
	double omega = 2 * TS_PI / w->period;

	return w->amplitude * omega * sin(omega * (ts_sim_time(sim) - w->origin));
}

/* Adds the velocity of a cylinder that rotates about its axis, at distance d from the axis. LIGGGHTS:
 * angular velocity `shear` times d, with the components of d interchanged for ycylinder, which `legacy
 * yes` reproduces. LAMMPS' manual: speed `shear`, clockwise as seen from the tip of the axis; its program
 * (29 Sep 2021) also adds the velocity along the shear dimension. */
static void add_rotation_velocity(const struct ts_primitive_wall *w, const struct tsim *sim, int axis,
				  const double x[3], double v[3])
{
	const double *centre = w->primitive[0].centre;
	int a = (axis + 1) % 3, b = (axis + 2) % 3;
	double da = x[a] - centre[0], db = x[b] - centre[1], r = sqrt(da * da + db * db);

	if (w->lammps) {
		v[a] += r > 0 ? w->shear * db / r : 0;
		v[b] -= r > 0 ? w->shear * da / r : 0;
	} else if (sim->legacy == TS_LEGACY_LIGGGHTS && axis == 1) {
		v[0] += w->shear * db;
		v[2] -= w->shear * da;
	} else {
		v[a] -= w->shear * db;
		v[b] += w->shear * da;
	}
}

/* A cylinder about its axis. */
static bool rotates(const struct ts_primitive_wall *w)
{
	const int shape = (int)w->primitive[0].shape;

	return w->shear_words.n && shape >= TS_XCYLINDER && shape % 3 != w->shear_dim;
}

/* Of all places, without the rotation. */
static void common_velocity(const struct ts_primitive_wall *w, const struct tsim *sim, double v[3])
{
	for (int d = 0; d < 3; d++)
		v[d] = w->velocity[d];
	if (w->wiggle_dim >= 0)
		v[w->wiggle_dim] += wiggle_velocity(w, sim);
	if (w->shear_words.n && !rotates(w))
		v[w->shear_dim] += w->shear;
}

static void surface_velocity(const struct ts_primitive_wall *w, const struct tsim *sim, const double x[3],
			     double v[3])
{
	common_velocity(w, sim, v);
	if (rotates(w))
		add_rotation_velocity(w, sim, (int)w->primitive[0].shape % 3, x, v);
}

/* Element k displaced along its normal by `moved`. */
static struct ts_primitive displaced_primitive(const struct ts_primitive_wall *w, int k, double moved)
{
	struct ts_primitive primitive = w->primitive[k];

	primitive.position += moved;
	return primitive;
}

/* Mean curvature of the surface as seen from x, 1/(2 R_c) for a cylinder, as in LAMMPS. LIGGGHTS treats
 * cylinders as flat. */
static double surface_curvature(const struct ts_primitive_wall *w, const double n[3], const double x[3])
{
	int axis = (int)w->primitive[0].shape % 3, a = (axis + 1) % 3, b = (axis + 2) % 3;
	const double *centre = w->primitive[0].centre;
	double out = n[a] * (x[a] - centre[0]) + n[b] * (x[b] - centre[1]);

	if (!w->lammps || (int)w->primitive[0].shape < TS_XCYLINDER)
		return 0;
	return (out > 0 ? 0.5 : -0.5) / w->primitive[0].radius;
}

/* ---- stages ---- */

/* The list of contacts is valid while the particles have moved less than half the skin relative to the frame, and the
 * wall less than what the frame leaves of the other half. */
static bool has_moved(const struct ts_wall *wall, const struct tsim *sim)
{
	const struct ts_primitive_wall *w = wall->geometry;

	return ts_primitive_wall_moves(w) &&
	       !(fabs(displacement(w, sim) - w->built_displacement) < ts_drift_frame_room_of_walls(sim));
}

/* Distance of x from the primitive; the frequent case of a plane is computed without its normal. */
static double primitive_distance(const struct ts_primitive *at, const double x[3])
{
	double n[3];

	return at->shape <= TS_ZPLANE ? fabs(x[at->shape] - at->position) : ts_primitive_distance(at, x, n);
}

bool ts_primitive_wall_between(const struct tsim *sim, const struct ts_primitive_wall *w, int dim, double a,
			       double b, double *position)
{
	double moved = displacement(w, sim);

	for (int k = 0; k < w->n; k++) {
		*position = w->primitive[k].position + moved;
		if ((int)w->primitive[k].shape == dim && *position >= fmin(a, b) && *position <= fmax(a, b))
			return true;
	}
	return false;
}

bool ts_primitive_wall_plane(const struct tsim *sim, const struct ts_primitive_wall *w, int k,
			     struct ts_primitive_plane *out)
{
	static const double origin[3] = { 0 }; /* all points of a plane have the same velocity */

	if (w->primitive[k].shape > TS_ZPLANE)
		return false;
	out->dim = (int)w->primitive[k].shape;
	out->position = w->primitive[k].position + displacement(w, sim);
	surface_velocity(w, sim, origin, out->velocity);
	return true;
}

static enum ts_status check_displacement(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_primitive_wall *w = ((const struct ts_wall *)self->state)->geometry;
	const struct ts_particles *p = sim->particles;
	double now, travel;
	char what[80];

	if (!ts_primitive_wall_moves(w))
		return TS_OK;
	now = displacement(w, sim);
	travel = fabs(now - displacement_at(w, ts_sim_time(sim) - sim->clock.dt));
	for (size_t i = 0; travel > sim->neigh->least_radius && i < p->n; i++) {
		for (int k = 0; k < w->n; k++) {
			struct ts_primitive at = displaced_primitive(w, k, now);

			if (travel <= p->radius[i] ||
			    primitive_distance(&at, p->x[i]) > p->radius[i] + travel ||
			    !ts_wall_interacts(self, sim, i, false))
				continue;
			snprintf(what, sizeof what, "the wall %.40s", self->id);
			return ts_coincide_passed(sim, &self->where, i, travel, what);
		}
	}
	return TS_OK;
}

static double gap(const struct ts_wall *wall, const struct tsim *sim, const double x[3])
{
	const struct ts_primitive_wall *w = wall->geometry;
	double now = displacement(w, sim), least = INFINITY;

	for (int k = 0; k < w->n; k++) {
		struct ts_primitive at = displaced_primitive(w, k, now);

		least = fmin(least, primitive_distance(&at, x));
	}
	return ts_primitive_wall_moves(w)
		       ? least - fabs(now - displacement_at(w, ts_sim_time(sim) - sim->clock.dt))
		       : least;
}

static double contact_distance(const struct ts_wall *wall, const struct tsim *sim, size_t k, int *type)
{
	const struct ts_primitive_wall *w = wall->geometry;
	const struct ts_wall_contacts *c = &wall->contacts;
	struct ts_primitive at = displaced_primitive(w, c->key[k][1], displacement(w, sim));

	*type = w->type;
	return primitive_distance(&at, sim->particles->x[c->row[k]]);
}

static enum ts_status add_pairs(struct ts_instance *self, struct tsim *sim)
{
	struct ts_wall *wall = self->state;
	struct ts_primitive_wall *w = wall->geometry;
	const struct ts_particles *p = sim->particles;
	bool pulls = ts_wall_long_ranged(wall, sim);
	struct ts_primitive at[MOST];

	if (!sim->run.resuming)
		w->built_displacement = displacement(w, sim);
	for (int k = 0; k < w->n; k++)
		at[k] = displaced_primitive(w, k, w->built_displacement);
	for (size_t i = 0; i < p->n; i++) {
		double reach = p->radius[i] + sim->neigh->built_skin +
			       (pulls ? ts_wall_reach(wall, sim, p->radius[i]) : 0);

		for (int k = 0; k < w->n; k++)
			if (primitive_distance(&at[k], p->xhold[i]) < reach &&
			    ts_wall_lists(self, sim, i, 0, !isnan(w->temperature)))
				TS_TRY(ts_wall_contacts_add(sim, &wall->contacts, i, k, 0));
	}
	return TS_OK;
}

static enum ts_status list(struct ts_instance *self, struct tsim *sim)
{
	return ts_wall_relist(self, sim, 0, add_pairs);
}

/* ---- as a surface ---- */

static const struct ts_primitive_wall *primitives_of(const struct ts_instance *by)
{
	return ts_primitive_wall_of(by->state);
}

static size_t count_primitives(const struct ts_instance *by)
{
	return (size_t)primitives_of(by)->n;
}

static int primitive_type(const struct ts_instance *by)
{
	return primitives_of(by)->type;
}

static double primitive_temperature(const struct ts_instance *by)
{
	return primitives_of(by)->temperature;
}

static enum ts_status refuse_recession(struct tsim *sim, const struct ts_instance *by,
				       const struct ts_recession *how, const struct ts_place *where)
{
	(void)how;
	return ts_fail(&sim->error, TS_STATE, where,
		       "evolve: a plane or cylinder, as of fix %s, is one element and keeps its shape; make "
		       "the wall of a height field: `fix ID all surface/voxel constant HEIGHT ...`",
		       by->id);
}

static bool is_within(const struct ts_primitive *p, const double lo[2], const double hi[2], double angle)
{
	const double at[2] = { p->centre[0] + p->radius * cos(angle), p->centre[1] + p->radius * sin(angle) };

	return at[0] > lo[0] && at[0] < hi[0] && at[1] > lo[1] && at[1] < hi[1];
}

/* Angles at which the circle crosses the lines through the sides of a rectangle, ascending, the first again one turn later. */
static int crossings(const struct ts_primitive *p, const double lo[2], const double hi[2], double cut[9])
{
	int n = 0;

	for (int side = 0; side < 4; side++) {
		const int d = side / 2;
		const double t = ((side % 2 ? hi[d] : lo[d]) - p->centre[d]) / p->radius;

		for (int sign = -1; sign <= 1 && fabs(t) < 1; sign += 2) {
			const double turned = d * TS_PI / 2 + sign * acos(t);
			const double angle = turned > TS_PI ? turned - 2 * TS_PI : turned;
			int k = n++;

			for (; k > 0 && cut[k - 1] > angle; k--)
				cut[k] = cut[k - 1];
			cut[k] = angle;
		}
	}
	cut[n] = n ? cut[0] + 2 * TS_PI : 0;
	return n;
}

/* Sum of the angles at which a circle lies within a rectangle. */
static double angle_within(const struct ts_primitive *p, const double lo[2], const double hi[2])
{
	double cut[9], sum = 0;
	const int n = crossings(p, lo, hi, cut);

	if (n == 0)
		return is_within(p, lo, hi, 1) ? 2 * TS_PI : 0;
	for (int k = 0; k < n; k++)
		if (is_within(p, lo, hi, (cut[k] + cut[k + 1]) / 2))
			sum += cut[k + 1] - cut[k];
	return sum;
}

/* Of the part in the box; of a cylinder around the box, which grains at the corners may touch, all. */
static double primitive_area(const struct ts_instance *by, const struct tsim *sim, size_t element)
{
	const struct ts_primitive *p = &primitives_of(by)->primitive[element];
	const struct ts_box *box = &sim->domain->box;
	int axis = (int)p->shape % 3;

	if (p->shape >= TS_XCYLINDER) {
		const int side[2] = { (axis + 1) % 3, (axis + 2) % 3 };
		const double angle = angle_within(p, (double[]){ box->lo[side[0]], box->lo[side[1]] },
						  (double[]){ box->hi[side[0]], box->hi[side[1]] });

		return (angle > 0 ? angle : 2 * TS_PI) * p->radius * ts_box_length(box, axis);
	}
	return ts_box_length(box, (axis + 1) % 3) * ts_box_length(box, (axis + 2) % 3);
}

/* Of the part in the box: of a plane, or of the axis of a cylinder. */
static void primitive_centre(const struct ts_instance *by, const struct tsim *sim, size_t element,
			     double out[3])
{
	const struct ts_primitive_wall *w = primitives_of(by);
	struct ts_primitive p = displaced_primitive(w, (int)element, displacement(w, sim));
	const struct ts_box *box = &sim->domain->box;
	int axis = (int)p.shape % 3;

	for (int d = 0; d < 3; d++)
		out[d] = 0.5 * (box->lo[d] + box->hi[d]);
	if (p.shape < TS_XCYLINDER)
		out[axis] = p.position;
	for (int d = 0; p.shape >= TS_XCYLINDER && d < 2; d++)
		out[(axis + 1 + d) % 3] = p.centre[d];
}

/* ---- forces ---- */

struct force_task {
	struct tsim *sim;
	struct ts_wall *wall;
	const struct ts_primitive_wall *w;
	struct ts_primitive at[MOST];
	struct ts_wall_contact_point all; /* what all contacts have in common */
	bool rotates;
};

/* A point whose distance, normal and curvature are known. */
static inline void complete_point(const struct force_task *t, const double x[3],
				  struct ts_wall_contact_point *point)
{
	struct ts_wall_contact_point all = t->all;

	memcpy(all.n, point->n, sizeof all.n);
	all.distance = point->distance;
	all.curvature = point->curvature;
	*point = all;
	if (t->rotates)
		add_rotation_velocity(t->w, t->sim, (int)t->w->primitive[0].shape % 3, x, point->velocity);
}

/* Particles that do not touch, most of a list, cost no more than their distance. */
static void compute_range(void *context, size_t from, size_t to)
{
	const struct force_task *t = context;
	const struct ts_particles *p = t->sim->particles;
	struct ts_wall_contacts *c = &t->wall->contacts;
	struct ts_wall_queue queue;

	ts_wall_queue_start(&queue, t->wall, t->sim);
	for (size_t k = from; k < to; k++) {
		const double *x = p->x[c->row[k]];
		struct ts_wall_contact_point *point = ts_wall_queue_next(&queue);

		ts_wall_prefetch_ahead(c, p, k, to);
		point->distance = ts_primitive_distance(&t->at[c->key[k][1]], x, point->n);
		point->curvature = surface_curvature(t->w, point->n, x);
		if (queue.long_ranged || point->distance < p->radius[c->row[k]])
			complete_point(t, x, point);
		if (!ts_wall_touches(&queue, k, point))
			ts_wall_contact_end(c, k);
		else
			ts_wall_enqueue_contact(&queue, k, point);
	}
	ts_wall_queue_end(&queue);
}

static struct ts_wall_contact_point common_point(const struct ts_wall *wall, const struct tsim *sim)
{
	const struct ts_primitive_wall *w = wall->geometry;
	struct ts_wall_contact_point all = { .type = w->type,
					     .observed = wall->observers[0] != 0,
					     .warm = !isnan(w->temperature),
					     .temperature = w->temperature };

	common_velocity(w, sim, all.velocity);
	return all;
}

static enum ts_status enqueue(struct ts_instance *self, struct tsim *sim)
{
	struct ts_wall *wall = self->state;
	const struct ts_primitive_wall *w = wall->geometry;
	struct force_task task = { sim, wall, w, { { 0 } }, common_point(wall, sim), rotates(w) };
	double moved = displacement(w, sim);

	for (int k = 0; k < w->n; k++)
		task.at[k] = displaced_primitive(w, k, moved);
	ts_wall_contacts_parallel(sim, &wall->contacts, compute_range, &task);
	ts_wall_finish(wall);
	return ts_coincide_wall(sim, wall);
}

/* ---- `impact exact` ---- */

/* Whether the surface has a velocity along its normal, although the wall stays in place. */
static bool pumps(const struct ts_primitive_wall *w)
{
	int dim = w->n ? (int)w->primitive[0].shape : TS_XCYLINDER;

	return dim <= TS_ZPLANE && (w->velocity[dim] != 0 || (w->shear_words.n && w->shear_dim == dim));
}

static const char *not_exact(const struct ts_wall *wall)
{
	return pumps(wall->geometry)
		       ? "the surface of a plane that stays in place has no velocity along its normal"
		       : NULL;
}

/* First touch of element k. The wall moves along its normal with the mean velocity of the step. */
static bool sweep_element(const struct tsim *sim, const struct ts_primitive_wall *w, int k, double moved,
			  double speed, const struct ts_sweep *path, struct ts_exact_touch *out)
{
	struct ts_primitive at = displaced_primitive(w, k, moved);
	struct ts_sweep relative = *path;
	int dim = (int)at.shape;
	double x[3];

	if (dim <= TS_ZPLANE) {
		relative.x[dim] += speed * path->span;
		relative.v[dim] -= speed;
	}
	if (!ts_sweep_primitive(&relative, &at, &out->hit))
		return false;
	ts_scale(1, relative.x, x);
	ts_axpy(out->hit.time, relative.v, x);
	surface_velocity(w, sim, x, out->velocity);
	if (dim <= TS_ZPLANE)
		out->velocity[dim] = speed;
	ts_scale(1, x, out->point);
	ts_axpy(-path->radius, out->hit.n, out->point);
	out->curvature = surface_curvature(w, out->hit.n, x);
	out->type = w->type;
	out->surface = 0;
	out->element = (size_t)k;
	return true;
}

static enum ts_status sweep(const struct tsim *sim, const void *shape, size_t i, const struct ts_sweep *path,
			    struct ts_mesh_list *list, bool *found, struct ts_exact_touch *out)
{
	const struct ts_primitive_wall *w = shape;
	double moved = displacement(w, sim), speed = 0;

	(void)i;
	(void)list;
	*found = false;
	if (ts_primitive_wall_moves(w))
		speed = (moved - displacement_at(w, ts_sim_time(sim) - sim->clock.dt)) / sim->clock.dt;
	for (int k = 0; k < w->n; k++) {
		struct ts_exact_touch touch;

		if (!sweep_element(sim, w, k, moved, speed, path, &touch) ||
		    (*found && !(touch.hit.time < out->hit.time)))
			continue;
		*found = true;
		*out = touch;
	}
	return TS_OK;
}

static const struct ts_exact_surface exact = { .sweep = sweep };

/* ---- the shape ---- */

static void plan(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_primitive_wall *w = ((const struct ts_wall *)self->state)->geometry;

	if (w->n && w->shear_words.n && (int)w->primitive[0].shape == w->shear_dim)
		ts_warn(&sim->log, ts_instance_word(self, "shear"),
			"fix wall/gran: a shear along the normal moves no plane, only the dashpot of "
			"contacts sees the velocity");
	if (!isnan(w->temperature) && !ts_heat_of(sim))
		ts_warn(&sim->log, ts_instance_word(self, "temperature"),
			"fix wall/gran: the temperature has no effect without fix heat/gran");
}

/* Older restart files do not have these values. */
static enum ts_status archive(struct ts_archive *a, void *geometry)
{
	struct ts_primitive_wall *w = geometry;
	double wiggle[3] = { w->origin, w->built_displacement, w->begun };

	if (ts_archive_has(a, "wiggle"))
		TS_TRY(ts_archive_fixed(a, "wiggle", TS_SAVED_F64, wiggle, 3));
	w->origin = wiggle[0];
	w->built_displacement = wiggle[1];
	w->begun = wiggle[2];
	return TS_OK;
}

/* Of planes; cylinders have none. */
static void near_points(const struct ts_wall *w, const struct tsim *sim, size_t i, double reach,
			ts_wall_near_fn *take, void *context)
{
	const struct ts_primitive_wall *pw = w->geometry;
	struct ts_primitive_plane plane;

	for (int k = 0; k < pw->n && ts_primitive_wall_plane(sim, pw, k, &plane); k++) {
		double height = sim->particles->x[i][plane.dim] - plane.position;
		struct ts_wall_near_point point = { .distance = fabs(height) };

		if (!(point.distance < reach) || !(point.distance > 0))
			continue;
		point.n[plane.dim] = height < 0 ? -1 : 1;
		ts_scale(1, plane.velocity, point.velocity);
		take(context, &point);
	}
}

const struct ts_wall_shape ts_primitive_wall_shape = {
	.made_of = "planes or cylinders",
	.given = given,
	.find = find,
	.plan = plan,
	.archive = archive,
	.surfaces = ts_wall_one_surface,
	.fix = ts_wall_own_fix,
	.place = ts_wall_own_place,
	.surface = { .family = TS_FAMILY_WALL,
		     .elements = count_primitives,
		     .area = primitive_area,
		     .centre = primitive_centre,
		     .type = primitive_type,
		     .temperature = primitive_temperature,
		     .check_recession = refuse_recession },
	.list = list,
	.has_moved = has_moved,
	.check_displacement = check_displacement,
	.enqueue = enqueue,
	.distance = contact_distance,
	.gap = gap,
	.near = near_points,
	.exact = &exact,
	.not_exact = not_exact,
};
