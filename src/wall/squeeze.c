#include "wall/squeeze.h"

#include "math/vec3.h"
#include "particle/particles.h"

#include "base/banned.h"

static enum ts_status find_wall(struct ts_instance *self, struct tsim *sim, const char *name,
				const struct ts_wall **out)
{
	const struct ts_word id = { .text = name, .place = *ts_instance_word(self, name) };
	struct ts_instance *by;

	TS_TRY(ts_sim_require(sim, TS_KIND_FIX, &id, &by));
	if (!by->style->family || !ts_streq(by->style->family, TS_FAMILY_WALL))
		return ts_fail(&sim->error, TS_STATE, &id.place,
			       "compute %s: fix %s is of style %s, expected a fix wall/gran",
			       self->style->name, name, by->style->name);
	*out = by->state;
	if ((*out)->exact)
		return ts_fail(&sim->error, TS_STATE, &id.place,
			       "compute %s: wall %s has `impact exact`, so that its contacts are not "
			       "resolved in time",
			       self->style->name, name);
	return TS_OK;
}

enum ts_status ts_squeeze_init(struct ts_instance *self, struct tsim *sim, struct ts_squeeze *s)
{
	s->sim = sim;
	for (int k = 0; k < 2; k++)
		TS_TRY(find_wall(self, sim, s->id[k], &s->wall[k]));
	if (s->wall[0] == s->wall[1])
		return ts_fail(&sim->error, TS_STATE, ts_instance_word(self, s->id[1]),
			       "compute %s: both walls are %s: a particle is squeezed between two",
			       self->style->name, s->id[1]);
	ts_walls_want_reports(sim);
	return TS_OK;
}

void ts_squeeze_release(struct ts_squeeze *s)
{
	ts_free(s->force);
}

/* Normal force on the particle: along the line from the contact point to its centre. */
static double normal_force(const struct ts_wall_report *r, const double x[3])
{
	double n[3], distance;

	ts_sub(x, r->point, n);
	distance = ts_norm(n);
	return distance > 0 ? ts_dot(r->force, n) / distance : 0;
}

/* A fix may have been deleted since the last run. */
static enum ts_status check_walls(struct ts_instance *self, const struct ts_squeeze *s)
{
	for (int k = 0; k < 2; k++) {
		const struct ts_instance *by = ts_sim_find(s->sim, TS_KIND_FIX, s->id[k]);

		if (!by || by->state != s->wall[k])
			return ts_conflict(&s->sim->error, &self->where,
					   "compute %s %s: the wall %s has been deleted since the last run",
					   self->style->name, self->id, s->id[k]);
	}
	return TS_OK;
}

enum ts_status ts_squeeze_find_forces(struct ts_instance *self, struct ts_squeeze *s)
{
	const struct ts_particles *p = s->sim->particles;

	TS_TRY(check_walls(self, s));
	TS_TRY(ts_walls_connect(s->sim));
	if (TS_GROW(s->force, s->capacity, p->n + 1) != TS_OK)
		return ts_nomem(&s->sim->error);
	for (size_t i = 0; i < p->n; i++)
		s->force[i][0] = s->force[i][1] = 0;
	for (int side = 0; side < 2; side++) {
		const struct ts_wall_contacts *c = &s->wall[side]->contacts;

		for (size_t k = 0; k < c->n; k++) {
			const struct ts_wall_report *r = ts_wall_report(c, k);
			size_t i = (size_t)c->row[k];

			if (r && i < p->n && ts_in_group(p, i, self->group))
				s->force[i][side] += normal_force(r, p->x[i]);
		}
	}
	return TS_OK;
}
