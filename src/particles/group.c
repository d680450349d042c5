/* Groups: named sets of particles, kept as bits of the mask column. */
#include "particles/particles.h"

#include "math/exactsum.h"

#include "base/banned.h"

int ts_group_find(const struct ts_particles *p, const char *name)
{
	for (int g = 0; g < TS_MAX_GROUPS; g++)
		if (p->group[g] && ts_streq(p->group[g], name))
			return g;
	return -1;
}

bool ts_group_exists(const struct tsim *sim, const char *name)
{
	return ts_group_find(sim->particles, name) >= 0;
}

const char *ts_group_name(const struct tsim *sim, int bit)
{
	return sim->particles->group[bit];
}

enum ts_status ts_group_require(struct tsim *sim, const struct ts_word *name, int *bit)
{
	const struct ts_particles *p = sim->particles;
	struct ts_suggest suggest = ts_suggest_start(name->text);

	*bit = ts_group_find(p, name->text);
	if (*bit >= 0)
		return TS_OK;
	for (int g = 0; g < TS_MAX_GROUPS; g++)
		if (p->group[g])
			ts_suggest_try(&suggest, p->group[g]);
	return ts_fail(&sim->error, TS_UNKNOWN, &name->place, "there is no group '%s'%s",
		       name->text, ts_suggest_text(&suggest));
}

enum ts_status ts_group_make(struct tsim *sim, const char *name, const struct ts_place *where,
			     int *bit)
{
	struct ts_particles *p = sim->particles;

	*bit = ts_group_find(p, name);
	for (int g = 1; *bit < 0 && g < TS_MAX_GROUPS; g++)
		if (!p->group[g])
			*bit = g;
	if (*bit < 0)
		return ts_fail(&sim->error, TS_RANGE, where, "no room for group '%s': there can be %d",
			       name, TS_MAX_GROUPS);
	p->group[*bit] = ts_pool_get(sim->pool, name);
	return p->group[*bit] ? TS_OK : ts_nomem(&sim->error);
}

/* Sum over a group of weight(i) * value(i), exactly rounded. */
typedef double particle_fn(const struct ts_particles *p, size_t i, int dim);

static double group_sum(const struct ts_particles *p, int group, particle_fn *value, int dim)
{
	struct ts_exactsum sum = { 0 };

	for (size_t i = 0; i < p->n; i++)
		if (ts_in_group(p, i, group))
			ts_exactsum_add(&sum, value(p, i, dim));
	return ts_exactsum_value(&sum);
}

static double one(const struct ts_particles *p, size_t i, int dim)
{
	(void)p, (void)i, (void)dim;
	return 1;
}

static double mass(const struct ts_particles *p, size_t i, int dim)
{
	(void)dim;
	return p->mass[i];
}

static double mass_x(const struct ts_particles *p, size_t i, int dim)
{
	return p->mass[i] * p->x[i][dim];
}

static double mass_v(const struct ts_particles *p, size_t i, int dim)
{
	return p->mass[i] * p->v[i][dim];
}

static double kinetic(const struct ts_particles *p, size_t i, int dim)
{
	const double *v = p->v[i];

	(void)dim;
	return 0.5 * p->mass[i] * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

static double force(const struct ts_particles *p, size_t i, int dim)
{
	return p->f[i][dim];
}

static enum ts_status plain(struct tsim *sim, struct ts_words args, particle_fn *value, double *out)
{
	int group;

	TS_TRY(ts_group_require(sim, &args.word[0], &group));
	*out = group_sum(sim->particles, group, value, 0);
	return TS_OK;
}

static enum ts_status read_dim(struct tsim *sim, const struct ts_word *word, int *dim)
{
	static const char *const names[] = { "x", "y", "z" };

	for (*dim = 0; *dim < 3; ++*dim)
		if (ts_streq(word->text, names[*dim]))
			return TS_OK;
	return ts_fail(&sim->error, TS_SYNTAX, &word->place, "'%s' is not x, y or z", word->text);
}

static enum ts_status component(struct tsim *sim, struct ts_words args, particle_fn *value,
				bool per_mass, double *out)
{
	int group, dim;
	double total;

	TS_TRY(ts_group_require(sim, &args.word[0], &group));
	TS_TRY(read_dim(sim, &args.word[1], &dim));
	*out = group_sum(sim->particles, group, value, dim);
	total = per_mass ? group_sum(sim->particles, group, mass, 0) : 1;
	if (!(total > 0))
		return ts_fail(&sim->error, TS_STATE, &args.word[0].place,
			       "group '%s' has no particles: its centre is not defined",
			       args.word[0].text);
	*out /= total;
	return TS_OK;
}

static enum ts_status eval_count(struct tsim *sim, struct ts_words args, double *out)
{
	return plain(sim, args, one, out);
}

static enum ts_status eval_mass(struct tsim *sim, struct ts_words args, double *out)
{
	return plain(sim, args, mass, out);
}

static enum ts_status eval_ke(struct tsim *sim, struct ts_words args, double *out)
{
	return plain(sim, args, kinetic, out);
}

static enum ts_status eval_xcm(struct tsim *sim, struct ts_words args, double *out)
{
	return component(sim, args, mass_x, true, out);
}

static enum ts_status eval_vcm(struct tsim *sim, struct ts_words args, double *out)
{
	return component(sim, args, mass_v, true, out);
}

static enum ts_status eval_fcm(struct tsim *sim, struct ts_words args, double *out)
{
	return component(sim, args, force, false, out);
}

static enum ts_status eval_bound(struct tsim *sim, struct ts_words args, double *out)
{
	static const char *const names[] = { "xmin", "xmax", "ymin", "ymax", "zmin", "zmax" };
	const struct ts_particles *p = sim->particles;
	bool found = false;
	int group, k;

	TS_TRY(ts_group_require(sim, &args.word[0], &group));
	for (k = 0; k < 6 && !ts_streq(args.word[1].text, names[k]); k++)
		;
	if (k == 6)
		return ts_fail(&sim->error, TS_SYNTAX, &args.word[1].place,
			       "'%s' is not one of xmin, xmax, ymin, ymax, zmin, zmax",
			       args.word[1].text);
	for (size_t i = 0; i < p->n; i++) {
		double x = p->x[i][k / 2];

		if (!ts_in_group(p, i, group))
			continue;
		if (!found || (k % 2 ? x > *out : x < *out))
			*out = x;
		found = true;
	}
	if (!found)
		return ts_fail(&sim->error, TS_STATE, &args.word[0].place,
			       "group '%s' has no particles", args.word[0].text);
	return TS_OK;
}

const struct ts_function ts_group_functions[] = {
	{ "count", "group", "number of particles in the group", 1, 1, eval_count, NULL },
	{ "mass", "group", "total mass of the group", 1, 1, eval_mass, NULL },
	{ "ke", "group", "kinetic energy of the group", 1, 1, eval_ke, NULL },
	{ "xcm", "group,dim", "centre of mass of the group, dim = x|y|z", 2, 2, eval_xcm, NULL },
	{ "vcm", "group,dim", "velocity of the centre of mass", 2, 2, eval_vcm, NULL },
	{ "fcm", "group,dim", "total force on the group", 2, 2, eval_fcm, NULL },
	{ "bound", "group,side", "extreme coordinate of centres, side = xmin|xmax|ymin...", 2, 2,
	  eval_bound, NULL },
	{ .name = NULL },
};
