#include "region/region.h"

#include <math.h>
#include <string.h>

#include "box/domain.h"
#include "core/ranks.h"
#include "core/uses.h"
#include "math/vec3.h"

#include "base/banned.h"

const char *const ts_region_sides[] = { "in", "out", NULL };
const char *const ts_region_units[] = { "lattice", "box", NULL };

static const struct ts_region_style *style_of(const struct ts_instance *region)
{
	return (const struct ts_region_style *)region->style;
}

/* ---- motion */

/* Rotation matrix of an angle about a unit vector (Rodrigues' formula). */
static void rotation_matrix(const double axis[3], double angle, double turn[3][3])
{
	double c = cos(angle), s = sin(angle);

	for (int i = 0; i < 3; i++)
		for (int j = 0; j < 3; j++)
			turn[i][j] = (1 - c) * axis[i] * axis[j] + (i == j ? c : 0);
	for (int i = 0; i < 3; i++) {
		int j = (i + 1) % 3, k = (i + 2) % 3;

		turn[k][j] += s * axis[i];
		turn[j][k] -= s * axis[i];
	}
}

/* Transforms x to the frame of the shape as it was defined: y = turn^T (x - shift - pivot) + pivot. */
static void to_shape_frame(const struct ts_region *r, const double x[3], double y[3])
{
	double d[3];

	for (int k = 0; k < 3; k++)
		d[k] = x[k] - r->shift[k] - r->pivot[k];
	for (int k = 0; k < 3; k++)
		y[k] = r->pivot[k] + r->turn[0][k] * d[0] + r->turn[1][k] * d[1] + r->turn[2][k] * d[2];
}

enum ts_status ts_region_update(struct ts_instance *region, struct tsim *sim)
{
	struct ts_region *r = region ? region->state : NULL;
	double angle = 0;

	if (!region)
		return TS_OK;
	if (style_of(region)->update)
		TS_TRY(style_of(region)->update(region, sim));
	if (!r->moves)
		return TS_OK;
	for (int k = 0; k < 3; k++)
		TS_TRY(ts_number_now(sim, &r->move[k], &region->where, &r->shift[k]));
	TS_TRY(ts_number_now(sim, &r->angle, &region->where, &angle));
	rotation_matrix(r->axis, angle, r->turn);
	r->turned = angle;
	return TS_OK;
}

bool ts_region_contains(const struct ts_instance *region, const double x[3])
{
	const struct ts_region *r = region->state;
	double y[3];

	if (r->moves) {
		to_shape_frame(r, x, y);
		x = y;
	}
	return style_of(region)->contains(region, x) != (r->side == 1);
}

static double depth_by(ts_region_depth_fn *depth, const struct ts_instance *region, const double x[3])
{
	const struct ts_region *r = region->state;
	double y[3];

	if (!depth)
		return NAN;
	if (r->moves) {
		to_shape_frame(r, x, y);
		x = y;
	}
	return r->side == 1 ? -depth(region, x) : depth(region, x);
}

double ts_region_depth(const struct ts_instance *region, const double x[3])
{
	return depth_by(style_of(region)->depth, region, x);
}

double ts_region_depth_at_edges(const struct ts_instance *region, const double x[3])
{
	const struct ts_region_style *style = style_of(region);

	return depth_by(style->depth_at_edges ? style->depth_at_edges : style->depth, region, x);
}

void ts_region_depth_slope(ts_region_depth_fn *depth, const struct ts_instance *region, const double x[3],
			   double step, double out[3])
{
	for (int k = 0; k < 3; k++) {
		double low[3] = { x[0], x[1], x[2] }, high[3] = { x[0], x[1], x[2] };

		low[k] -= step;
		high[k] += step;
		out[k] = depth(region, high) - depth(region, low);
	}
}

double ts_region_radial(const struct ts_instance *region, const double x[3])
{
	const struct ts_region *r = region->state;
	double y[3];

	if (!style_of(region)->radial || r->side == 1)
		return NAN;
	if (r->moves) {
		to_shape_frame(r, x, y);
		x = y;
	}
	return style_of(region)->radial(region, x);
}

/* ---- surface */

int ts_region_faces(const struct ts_instance *region)
{
	const struct ts_region_style *style = style_of(region);
	const struct ts_instance *member;
	int sum = 0;

	if (!style->contact_points || !style->member)
		return style->contact_points ? style->faces : 0;
	for (int64_t k = 0; (member = style->member(region, k)); k++) {
		int faces = ts_region_faces(member);

		if (!faces)
			return 0;
		sum += faces;
	}
	return sum;
}

int ts_region_movers(const struct ts_instance *region, const struct ts_instance **out, int room)
{
	const struct ts_region_style *style = style_of(region);
	const struct ts_instance *member;
	int n = 0;

	if (((const struct ts_region *)region->state)->moves) {
		if (room > 0)
			out[0] = region;
		n++;
	}
	for (int64_t k = 0; style->member && (member = style->member(region, k)); k++) {
		int at = n < room ? n : room;

		n += ts_region_movers(member, out ? out + at : NULL, room - at);
	}
	return n;
}

int ts_region_contact_points_all(const struct ts_instance *region, const double x[3],
				 struct ts_region_contact_point *out)
{
	const struct ts_region *r = region->state;
	double y[3];
	int n;

	if (!r->moves)
		return style_of(region)->contact_points(region, x, style_of(region)->contains(region, x),
							out);
	to_shape_frame(r, x, y);
	n = style_of(region)->contact_points(region, y, style_of(region)->contains(region, y), out);
	for (int k = 0; k < n; k++) {
		double there[3];

		for (int d = 0; d < 3; d++)
			there[d] = ts_dot(r->turn[d], out[k].n);
		for (int d = 0; d < 3; d++)
			out[k].n[d] = there[d];
		out[k].mover = region;
	}
	return n;
}

int ts_region_contact_points(const struct ts_instance *region, const double x[3],
			     struct ts_region_contact_point *out)
{
	const struct ts_region *r = region->state;

	if (!r->open && !ts_region_contains(region, x))
		return 0;
	return ts_region_contact_points_all(region, x, out);
}

bool ts_region_varies(const struct ts_instance *region)
{
	return ((const struct ts_region *)region->state)->varies;
}

bool ts_region_reshapes(const struct ts_instance *region)
{
	return ((const struct ts_region *)region->state)->reshapes;
}

bool ts_region_turns_in_place(const struct ts_instance *region)
{
	const struct ts_region_style *style = (const struct ts_region_style *)region->style;
	const struct ts_region *r = region->state;

	return !r->move_words.n && !r->reshapes && style->turns_in_place && style->turns_in_place(region);
}

/* Bounding box of the rotated and shifted bounds of the shape. */
static void transform_bounds(const struct ts_region *r, double lo[3], double hi[3])
{
	double a[3], b[3];

	for (int k = 0; k < 3; k++) {
		a[k] = lo[k] - r->pivot[k];
		b[k] = hi[k] - r->pivot[k];
	}
	for (int i = 0; i < 3; i++) {
		lo[i] = hi[i] = r->pivot[i] + r->shift[i];
		for (int j = 0; j < 3; j++) {
			double t = r->turn[i][j];

			if (t == 0) /* also if the bounds are infinite */
				continue;
			lo[i] += fmin(t * a[j], t * b[j]);
			hi[i] += fmax(t * a[j], t * b[j]);
		}
	}
}

void ts_region_bounds(const struct ts_instance *region, double lo[3], double hi[3])
{
	const struct ts_region *r = region->state;

	if (r->side == 0) {
		style_of(region)->bounds(region, lo, hi);
		if (r->moves)
			transform_bounds(r, lo, hi);
		return;
	}
	for (int d = 0; d < 3; d++) {
		lo[d] = -INFINITY;
		hi[d] = INFINITY;
	}
}

double ts_region_volume(const struct ts_instance *region)
{
	const struct ts_region *r = region->state;

	if (r->side == 1)
		return INFINITY;
	return style_of(region)->volume ? style_of(region)->volume(region) : NAN;
}

/* ---- definition */

#define MOVE_ROW(name, k)                                                                                  \
	TS_NUMBER(name, struct ts_region, move[k], .flags = TS_POSITIONAL | TS_NULLABLE, .unit = "length", \
		  .help = "v_NAME or NULL")
static const struct ts_arg move_rows[] = {
	MOVE_ROW("v_x", 0),
	MOVE_ROW("v_y", 1),
	MOVE_ROW("v_z", 2),
	TS_ARGS_END,
};

static const struct ts_arg rotate_rows[] = {
	TS_NUMBER("v_theta", struct ts_region, angle, .flags = TS_POSITIONAL, .help = "angle in radians"),
	TS_VEC3("P", struct ts_region, pivot, .flags = TS_POSITIONAL, .unit = "length",
		.help = "a point on the axis"),
	TS_VEC3("R", struct ts_region, axis, .flags = TS_POSITIONAL, .help = "direction of the axis"),
	TS_ARGS_END,
};

static enum ts_status define_motion(struct ts_instance *self, struct tsim *sim)
{
	struct ts_region *r = self->state;
	double length;

	if (r->move_words.n) {
		TS_TRY(ts_args_parse(sim, "region: move", move_rows, r->move_words, &self->where,
				     &self->arena, r));
		r->moves = true;
	}
	if (!r->rotate_words.n)
		return TS_OK;
	TS_TRY(ts_args_parse(sim, "region: rotate", rotate_rows, r->rotate_words, &self->where, &self->arena,
			     r));
	length = ts_norm(r->axis);
	if (!(length > 0))
		return ts_fail(&sim->error, TS_RANGE, &r->rotate_words.word[4].place,
			       "region: the axis of rotate is zero, expected a direction");
	ts_scale(1 / length, r->axis, r->axis);
	for (int k = 0; k < 3; k++)
		r->pivot[k] *= r->scale[k];
	r->moves = true;
	return TS_OK;
}

static enum ts_status define_open(struct ts_instance *self, struct tsim *sim)
{
	struct ts_region *r = self->state;
	int faces = style_of(self)->faces;

	for (size_t k = 0; k < r->open_words.n; k++) {
		const struct ts_word *word = &r->open_words.word[k];
		int64_t face;

		if (!ts_parse_int(word->text, &face) || face < 1 || face > faces)
			return ts_fail(&sim->error, TS_RANGE, &word->place,
				       "region %s: open is '%s', expected a face from 1 to %d",
				       self->style->name, word->text, faces);
		r->open |= 1u << (face - 1);
	}
	return TS_OK;
}

static size_t count_variables(struct ts_words words)
{
	size_t n = 0;

	for (size_t k = 0; k < words.n; k++)
		n += strncmp(words.word[k].text, "v_", 2) == 0;
	return n;
}

enum ts_status ts_region_init(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_domain *domain = sim->domain;
	struct ts_region *r = self->state;

	if (r->defined)
		return TS_OK;
	/* a union has no lengths of its own, unless it moves */
	if (!style_of(self)->member || r->move_words.n || r->rotate_words.n)
		ts_domain_units_said(sim, r->units, &self->where);
	for (int k = 0; k < 3; k++) {
		r->scale[k] = ts_domain_scale(sim, r->units, k);
		r->edge[0][k] = sim->has_box ? domain->box.lo[k] : NAN;
		r->edge[1][k] = sim->has_box ? domain->box.hi[k] : NAN;
		r->axis[k] = k == 2;
		r->turn[k][k] = 1;
	}
	TS_TRY(define_motion(self, sim));
	TS_TRY(define_open(self, sim));
	r->reshapes = count_variables(self->words) >
		      count_variables(r->move_words) + count_variables(r->rotate_words);
	r->varies = r->moves || r->reshapes;
	r->defined = true;
	return TS_OK;
}

enum ts_status ts_region_coord(struct ts_instance *self, struct tsim *sim, double given, int dim, double *out)
{
	const struct ts_region *r = self->state;
	double edge = r->edge[given > 0][dim];

	*out = fabs(given) == TS_EDGE ? edge : given * r->scale[dim];
	if (!isnan(*out))
		return TS_OK;
	return ts_fail(&sim->error, TS_STATE, &self->where,
		       "region %s: EDGE is a face of the box, and there is no box yet; use INF, or define "
		       "the region after create_box",
		       self->style->name);
}

enum ts_status ts_region_length(struct ts_instance *self, struct tsim *sim, const struct ts_number *given,
				int dim, double *out)
{
	const struct ts_region *r = self->state;

	TS_TRY(ts_number_now(sim, given, &self->where, out));
	*out *= r->scale[dim];
	return TS_OK;
}

/* ---- functions of formulas */

static enum ts_status eval_volume(struct tsim *sim, struct ts_words args, double *out)
{
	struct ts_instance *region;

	TS_TRY(ts_sim_require(sim, TS_KIND_REGION, &args.word[0], &region));
	TS_TRY(ts_region_update(region, sim));
	*out = ts_region_volume(region);
	if (!isnan(*out))
		return TS_OK;
	return ts_fail(&sim->error, TS_STATE, &args.word[0].place,
		       "the volume of a region of style %s is not known", region->style->name);
}

static const struct ts_function functions[] = {
	{ .name = "volume",
	  .arguments = "region",
	  .help = "exact volume of a region, for styles that provide it",
	  .least = 1,
	  .most = 1,
	  .eval = eval_volume },
	{ .name = NULL },
};

static const char *undivided(const struct tsim *sim)
{
	const struct ts_instances *regions = &sim->instances[TS_KIND_REGION];

	for (size_t k = 0; k < regions->n; k++)
		if (ts_ranks_find_shared(sim, regions->item[k]->words) &&
		    ts_uses_region(sim, regions->item[k]))
			return "the variable by which a region moves or changes";
	return NULL;
}

const struct ts_system_style ts_regions_system = {
	.style = { .name = "regions",
		   .kind = TS_KIND_SYSTEM,
		   .summary = "functions of formulas over regions" },
	.no_instance = true,
	.functions = functions,
	.undivided = undivided,
};
