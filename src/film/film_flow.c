/* The surfaces of flow_style reynolds: heights from numbers, formulas and voxel fields, and their rates. */
#include "film/film_plane.h"

#include <math.h>

#include "flow/flow_arguments.h"
#include "voxel/voxel_surface.h"

#include "base/banned.h"

enum ts_status ts_film_flow_require(struct tsim *sim, const char *who, const struct ts_place *where,
				    struct ts_film_flow **out)
{
	struct ts_instance *flow = ts_sim_only(sim, TS_KIND_FLOW);

	*out = NULL;
	if (!flow || !flow->style->family || !ts_streq(flow->style->family, TS_FAMILY_FILM))
		return ts_fail(&sim->error, TS_STATE, where,
			       "%s needs a film: use flow_style reynolds before it", who);
	*out = flow->state;
	return TS_OK;
}

struct ts_instance *ts_film_flow_below(const struct tsim *sim, const struct ts_instance *plane)
{
	struct ts_instance *flow = ts_sim_only(sim, TS_KIND_FLOW);
	const struct ts_film_flow *film;

	if (!flow || !flow->style->family || !ts_streq(flow->style->family, TS_FAMILY_FILM))
		return NULL;
	film = flow->state;
	return film->surface[1].plane_id && ts_streq(film->surface[1].plane_id, plane->id) ? flow : NULL;
}

static enum ts_status find_plane(struct ts_instance *self, struct tsim *sim, struct ts_film_surface *s)
{
	const struct ts_place *where = ts_instance_word(self, s->plane_id);
	struct ts_instance *fix = ts_sim_find(sim, TS_KIND_FIX, s->plane_id);

	if (s->voxel || !s->height.null)
		return ts_fail(&sim->error, TS_SYNTAX, where,
			       "flow_style reynolds: the upper surface is given twice, by `upper_wafer %s` "
			       "and by `%s`; fix wafer has a plane face",
			       s->plane_id, s->voxel ? "upper_voxel" : "upper");
	if (!fix)
		return ts_fail(&sim->error, TS_UNKNOWN, where,
			       "flow_style reynolds: there is no fix '%s'; expected the ID of a fix wafer "
			       "defined before",
			       s->plane_id);
	if (!fix->style->family || !ts_streq(fix->style->family, TS_FAMILY_FILM_PLANE))
		return ts_fail(&sim->error, TS_STATE, where,
			       "flow_style reynolds: fix '%s' is of style %s, expected wafer", s->plane_id,
			       fix->style->name);
	s->plane_fix = fix;
	return TS_OK;
}

static enum ts_status find_field(struct ts_instance *self, struct tsim *sim, struct ts_film_surface *s)
{
	struct ts_word id = { .text = s->voxel, .place = *ts_instance_word(self, s->voxel) };

	TS_TRY(ts_voxel_surface_require(sim, &id, &s->field));
	if (s->field->field.axis[2] != 2)
		return ts_fail(&sim->error, TS_STATE, &id.place,
			       "flow_style reynolds: the normal of fix '%s' is not z, the normal of the film",
			       s->voxel);
	return TS_OK;
}

enum ts_status ts_film_surface_find(struct ts_instance *self, struct tsim *sim, struct ts_film_surface *s,
				    const char *name)
{
	bool upper = ts_streq(name, "upper");

	s->plane_fix = NULL;
	if (s->plane_id)
		return find_plane(self, sim, s);
	if (upper && s->voxel && s->height.null)
		return ts_fail(&sim->error, TS_SYNTAX, ts_instance_word(self, s->voxel),
			       "flow_style reynolds: from which height do the columns of '%s' hang? Give "
			       "`upper` and a height",
			       s->voxel);
	if (!s->voxel && s->height.null)
		return ts_fail(&sim->error, TS_SYNTAX, &self->where,
			       "flow_style reynolds: where is the %s surface? Give `%s` and a height or "
			       "v_NAME",
			       name, name);
	if (!s->voxel)
		return TS_OK;
	if (!upper && !s->height.null)
		return ts_fail(&sim->error, TS_SYNTAX, ts_instance_word(self, s->voxel),
			       "flow_style reynolds: the %s surface is given twice, as a height and as '%s'",
			       name, s->voxel);
	return find_field(self, sim, s);
}

static enum ts_status evaluate_formula(struct ts_instance *self, struct tsim *sim,
				       const struct ts_film_flow *flow, struct ts_film_surface *s)
{
	const struct ts_film *f = &flow->film;
	const char *name = s->height.variable;
	const struct ts_place *where = name ? ts_instance_word(self, name) : &self->where;

	for (int j = 0; j < f->n[1]; j++)
		for (int i = 0; i < f->n[0]; i++) {
			const double x[3] = { ts_film_centre(f, 0, i), ts_film_centre(f, 1, j), 0 };
			double *z = &s->z[ts_film_at(f, i, j)];

			if (name)
				TS_TRY(ts_flow_set_coordinates(sim, flow->set, x, where));
			TS_TRY(ts_number_now(sim, &s->height, where, z));
			if (!isfinite(*z))
				return ts_fail(&sim->error, TS_RANGE, where,
					       "flow_style reynolds: the height %s is %g at (%g, %g), which "
					       "is not a finite number",
					       name ? name : "", *z, x[0], x[1]);
		}
	return TS_OK;
}

/* The part of a cell that column i covers along an axis. */
static double overlap(const struct ts_voxel_field *field, int d, int64_t i, const double cell[2])
{
	double part =
		fmin(cell[1], ts_voxel_border(field, d, i + 1)) - fmax(cell[0], ts_voxel_border(field, d, i));

	part /= cell[1] - cell[0];
	return part > 1e-9 ? part : 0; /* borders are rounded */
}

/* Mean height of the columns over a cell, so that the gap changes continuously as the columns move; -INFINITY: some
 * are missing. */
static double mean_height(const struct ts_voxel_field *field, const double x[2], const double y[2])
{
	int64_t begin[2] = { ts_voxel_index(field, 0, x[0]) - 1, ts_voxel_index(field, 1, y[0]) - 1 };
	double sum = 0, area = 0, first = NAN; /* equal heights have exactly their mean */

	for (int64_t j = begin[1]; ts_voxel_border(field, 1, j) < y[1]; j++)
		for (int64_t i = begin[0]; ts_voxel_border(field, 0, i) < x[1]; i++) {
			double part = overlap(field, 0, i, x) * overlap(field, 1, j, y);

			if (!(part > 0))
				continue;
			if (isnan(first))
				first = ts_voxel_top(field, i, j);
			if (!isfinite(ts_voxel_top(field, i, j)))
				return -INFINITY;
			sum += part * (ts_voxel_top(field, i, j) - first);
			area += part;
		}
	return first + sum / area;
}

static enum ts_status read_columns(struct ts_instance *self, struct tsim *sim, const struct ts_film *f,
				   struct ts_film_surface *s, bool hang)
{
	const double *shift = s->field->shift;

	for (int j = 0; j < f->n[1]; j++)
		for (int i = 0; i < f->n[0]; i++) {
			const double x[2] = { f->face[0][i] - shift[0], f->face[0][i + 1] - shift[0] };
			const double y[2] = { f->face[1][j] - shift[1], f->face[1][j + 1] - shift[1] };
			double top = mean_height(&s->field->field, x, y);

			if (!isfinite(top))
				return ts_fail(&sim->error, TS_STATE, ts_instance_word(self, s->voxel),
					       "flow_style reynolds: fix '%s' has no column at (%g, %g), "
					       "where the film is",
					       s->voxel, ts_film_centre(f, 0, i), ts_film_centre(f, 1, j));
			if (hang)
				s->z[ts_film_at(f, i, j)] += shift[2] - top;
			else
				s->z[ts_film_at(f, i, j)] = top + shift[2];
		}
	return TS_OK;
}

enum ts_status ts_film_surface_evaluate(struct ts_instance *self, struct tsim *sim, struct ts_film_flow *flow,
					int side)
{
	const struct ts_film *f = &flow->film;
	struct ts_film_surface *s = &flow->surface[side];

	for (int d = 0; d < 3; d++)
		s->now[d] = s->velocity[d] + (s->voxel ? s->field->velocity[d] : 0);
	if (s->plane_fix) {
		ts_film_plane_evaluate(flow);
		return TS_OK;
	}
	if (!s->height.null)
		TS_TRY(evaluate_formula(self, sim, flow, s));
	if (s->voxel)
		TS_TRY(read_columns(self, sim, f, s, side == 1));
	for (size_t c = 0; c < ts_film_cells(f); c++)
		s->rate[c] = s->now[2];
	return TS_OK;
}
