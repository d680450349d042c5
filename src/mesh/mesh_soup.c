#include "mesh/mesh_soup.h"

#include <math.h>
#include <stdio.h>

#include "geom/motion.h"
#include "mesh/mesh_admit.h"
#include "region/region.h"

#include "base/banned.h"

/* The digits that LIGGGHTS uses here: its meshes are rotated by an angle that is 1e-9 too small,
 * relatively. */
#define PI 3.14159265

/* Removes the triangles whose flag is set. */
static void remove_flagged(struct ts_triangles *soup, const unsigned char *flag)
{
	size_t kept = 0;

	for (size_t t = 0; t < soup->n; t++)
		if (!flag[t])
			soup->t[kept++] = soup->t[t];
	soup->n = kept;
}

static enum ts_status mark_outside(struct tsim *sim, struct ts_instance *region,
				   const struct ts_triangles *soup, unsigned char *flag)
{
	TS_TRY(ts_region_update(region, sim));
	for (size_t k = 0; k < 3 * soup->n; k++)
		flag[k / 3] |= !ts_region_contains(region, soup->t[k / 3].v[k % 3]);
	return TS_OK;
}

static enum ts_status exclude_listed(struct ts_instance *self, struct tsim *sim, const struct ts_words *words,
				     struct ts_triangles *soup)
{
	const struct ts_word *mode = words->word;

	if (words->n != 2 || (!ts_streq(mode->text, "read") && !ts_streq(mode->text, "write")))
		return ts_fail(&sim->error, TS_SYNTAX, ts_instance_word(self, "element_exclusion_list"),
			       "element_exclusion_list: expected `read FILE` or `write FILE`");
	if (ts_streq(mode->text, "write"))
		return TS_OK;
	return ts_mesh_exclude(sim, &words->word[1].place, words->word[1].text, soup);
}

enum ts_status ts_mesh_soup_choose(struct ts_instance *self, struct tsim *sim, const struct ts_mesh_words *w,
				   struct ts_triangles *soup)
{
	unsigned char *flag;
	enum ts_status status;

	if (w->exclusion.n)
		TS_TRY(exclude_listed(self, sim, &w->exclusion, soup));
	if (!w->region)
		return TS_OK;
	flag = ts_alloc(soup->n, 1);
	status = flag ? mark_outside(sim, w->region, soup, flag) : ts_nomem(&sim->error);
	if (status == TS_OK)
		remove_flagged(soup, flag);
	ts_free(flag);
	return status;
}

/* Adds the two triangles b a b' and a a' b' that edge a b sweeps, a' = a + shift. */
static enum ts_status extrude_edge(struct tsim *sim, const double a[3], const double b[3],
				   const double shift[3], struct ts_triangles *soup)
{
	struct ts_triangle upper = { .solid = "" }, lower = { .solid = "" };

	for (int d = 0; d < 3; d++) {
		upper.v[0][d] = b[d];
		upper.v[1][d] = lower.v[0][d] = a[d];
		lower.v[1][d] = a[d] + shift[d];
		upper.v[2][d] = lower.v[2][d] = b[d] + shift[d];
	}
	if (ts_triangles_add(soup, &upper) != TS_OK || ts_triangles_add(soup, &lower) != TS_OK)
		return ts_nomem(&sim->error);
	return TS_OK;
}

static void triangle_normal(const double x[3][3], double normal[3])
{
	double a[3], b[3];

	ts_sub(x[1], x[0], a);
	ts_sub(x[2], x[0], b);
	ts_cross(a, b, normal);
	ts_scale(1 / ts_norm(normal), normal, normal);
}

enum ts_status ts_mesh_soup_extrude(struct ts_instance *self, struct tsim *sim, const struct ts_word *id,
				    struct ts_triangles *soup)
{
	const struct ts_mesh *m;
	struct ts_mesh_surface *other;
	double shift[3];

	TS_TRY(ts_mesh_surface_require(sim, id, &other));
	if (isnan(other->extrusion) || other == self->state)
		return ts_fail(&sim->error, TS_STATE, &id->place, "mesh %s: mesh %s has no extrude_planar",
			       self->id, id->text);
	m = &other->mesh;
	soup->file = ts_pool_get(sim->pool, id->text);
	if (!soup->file)
		return ts_nomem(&sim->error);
	for (size_t t = 0; t < m->n; t++) {
		const double(*x)[3] =
			other->home ? (const double(*)[3])other->home[t] : (const double(*)[3])m->x[t];

		triangle_normal(x, shift);
		ts_scale(-other->extrusion, shift, shift);
		for (int k = 0; k < 3; k++)
			if (m->neighbour[t][k] == -1)
				TS_TRY(extrude_edge(sim, x[k], x[(k + 1) % 3], shift, soup));
	}
	return TS_OK;
}

struct transform {
	double factor, shift[3], axis[3], angle;
};

static const struct ts_arg scale_rows[] = {
	TS_REAL("factor", struct transform, factor, .flags = TS_POSITIONAL, .help = "factor"),
	TS_ARGS_END,
};
static const struct ts_arg move_rows[] = {
	TS_VEC3("shift", struct transform, shift, .flags = TS_POSITIONAL, .help = "x y z"),
	TS_ARGS_END,
};
static const struct ts_arg rotate_rows[] = {
	TS_VEC3("axis", struct transform, axis, .help = "direction"),
	TS_REAL("angle", struct transform, angle, .help = "degrees"),
	TS_ARGS_END,
};

/* Each keyword sets a rigid motion or a factor, which apply_transform applies to all corners. */
static enum ts_status set_scale(struct transform *t, struct ts_motion *m, double *factor)
{
	(void)m;
	*factor = t->factor;
	return TS_OK;
}

static enum ts_status set_shift(struct transform *t, struct ts_motion *m, double *factor)
{
	(void)factor;
	ts_scale(1, t->shift, m->shift);
	return TS_OK;
}

static enum ts_status set_rotation(struct transform *t, struct ts_motion *m, double *factor)
{
	double length = ts_norm(t->axis);

	(void)factor;
	if (!(length > 0))
		return TS_RANGE;
	ts_scale(1 / length, t->axis, t->axis);
	ts_motion_set_turn(m, t->axis, t->angle * PI / 180);
	return TS_OK;
}

static const struct transform_word {
	const char *name;
	size_t nwords;
	const struct ts_arg *rows;
	enum ts_status (*set)(struct transform *t, struct ts_motion *m, double *factor);
} transform_words[] = {
	{ "scale", 1, scale_rows, set_scale },
	{ "move", 3, move_rows, set_shift },
	{ "rotate", 6, rotate_rows, set_rotation },
};

static enum ts_status apply_transform(struct ts_instance *self, struct tsim *sim,
				      const struct transform_word *word, const struct ts_word *at,
				      struct ts_words args, struct ts_triangles *soup)
{
	struct ts_motion motion = ts_motion_none();
	struct transform t = { 0 };
	double factor = 1;
	char what[80];

	snprintf(what, sizeof what, "fix %s: %s", self->style->name, word->name);
	if (args.n > word->nwords)
		args.n = word->nwords;
	TS_TRY(ts_args_parse(sim, what, word->rows, args, &at->place, &self->arena, &t));
	if (word->set(&t, &motion, &factor) != TS_OK)
		return ts_fail(&sim->error, TS_RANGE, &at->place, "%s: the axis has no length", what);
	for (size_t k = 0; k < 3 * soup->n; k++) {
		double *x = soup->t[k / 3].v[k % 3];

		ts_scale(factor, x, x);
		ts_motion_apply(&motion, x, x);
	}
	return TS_OK;
}

enum ts_status ts_mesh_soup_transform(struct ts_instance *self, struct tsim *sim, struct ts_triangles *soup)
{
	const struct ts_words *words = &self->words;
	size_t n = sizeof transform_words / sizeof *transform_words;

	for (size_t k = 0; k < words->n; k++) {
		const char *before = k > 0 ? words->word[k - 1].text : "";

		if (ts_streq(before, "file") || ts_streq(before, "fix") || ts_streq(before, "region"))
			continue; /* a file, fix or region may be named like a keyword */
		for (size_t j = 0; j < n; j++)
			if (ts_streq(words->word[k].text, transform_words[j].name))
				TS_TRY(apply_transform(self, sim, &transform_words[j], &words->word[k],
						       ts_words_from(*words, k + 1), soup));
	}
	return TS_OK;
}
