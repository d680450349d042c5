/* Fix recenter: keeps the centre of mass of a group at a given position. */
#include "base/axes.h"
#include "core/sim.h"

#include <math.h>

#include "box/domain.h"
#include "group/group_motion.h"
#include "math/vec3.h"
#include "particle/group_moments.h"
#include "rigid/rigid_change.h"

#include "base/banned.h"

enum { LATTICE, BOX, FRACTION };

struct state {
	const char *word[3]; /* number, INIT or NULL */
	int shifted, units;  /* shifted: group that is moved, -1: that of the fix */
	bool held[3], initial[3];
	double given[3];
	double at_first[3], shift[3]; /* saved */
	int64_t started;
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	for (int k = 0; k < 3; k++) {
		s->held[k] = !ts_streq(s->word[k], "NULL");
		s->initial[k] = ts_streq(s->word[k], "INIT");
		if (s->held[k] && !s->initial[k] && !ts_parse_real(s->word[k], &s->given[k]))
			return ts_fail(&sim->error, TS_SYNTAX, &self->where,
				       "fix recenter: %c is '%s', expected a number, INIT or NULL", 'x' + k,
				       s->word[k]);
	}
	if (sim->dimension == 2 && s->held[2])
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "fix recenter: in two dimensions z is NULL");
	if (!s->started)
		ts_group_centre(sim, self->group, s->at_first);
	s->started = 1;
	return TS_OK;
}

static double target_coordinate(const struct state *s, const struct tsim *sim, int k)
{
	const struct ts_box *box = &sim->domain->box;

	if (s->initial[k])
		return s->at_first[k];
	if (s->units == FRACTION)
		return box->lo[k] + s->given[k] * ts_box_length(box, k);
	return ts_domain_scale(sim, s->units, k) * s->given[k];
}

static enum ts_status initial_integrate(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	struct ts_particles *p = sim->particles;
	int group = s->shifted < 0 ? self->group : s->shifted;
	double centre[3];

	if (!(ts_group_mass(sim, self->group) > 0))
		return TS_OK;
	ts_group_centre(sim, self->group, centre);
	for (int k = 0; k < 3; k++)
		s->shift[k] = s->held[k] ? target_coordinate(s, sim, k) - centre[k] : 0;
#pragma omp parallel for num_threads(ts_team(sim, p->n)) schedule(static)
	for (size_t i = 0; i < p->n; i++)
		for (int k = 0; ts_in_group(p, i, group) && !ts_rigid_member(p, i) && k < 3; k++)
			p->x[i][k] += s->shift[k];
	return ts_rigid_shift(sim, group, s->shift);
}

static enum ts_status eval_distance(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	(void)sim;
	out->data[0] = ts_norm(((const struct state *)self->state)->shift);
	return TS_OK;
}

static enum ts_status eval_shift(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	(void)sim;
	for (int k = 0; k < 3; k++)
		out->data[k] = ((const struct state *)self->state)->shift[k];
	return TS_OK;
}

static const char *const units[] = { [LATTICE] = "lattice", [BOX] = "box", [FRACTION] = "fraction", NULL };

#define COMPONENT(name_, k)                                                                        \
	TS_WORD(name_, struct state, word[k], .flags = TS_POSITIONAL,                              \
		.help = "coordinate of the centre of mass: a number, INIT (that when the fix was " \
			"defined) or NULL (not controlled)")
static const struct ts_arg args[] = {
	COMPONENT("x", 0),
	COMPONENT("y", 1),
	COMPONENT("z", 2),
	TS_GROUP("shift", struct state, shifted, .flags = TS_OPTIONAL,
		 .help = "group that is shifted; default: the group of the fix"),
	TS_ENUM("units", struct state, units, units, .fallback = "lattice",
		.help = "whether coordinates are in lattice spacings, in units of length, or a fraction of "
			"the box from 0 to 1"),
	TS_ARGS_END,
};

static const struct ts_value values[] = {
	{ "distance", "length", "distance by which particles were shifted in the last step", TS_SCALAR, 1,
	  NULL, eval_distance },
	{ "shift", "length", "components of that shift", TS_VECTOR, 3, ts_axis_names, eval_shift },
	{ .name = NULL },
};

static const struct ts_saved saved[] = {
	TS_SAVE_F64(struct state, at_first),
	TS_SAVE_F64(struct state, shift),
	TS_SAVE_I64(struct state, started),
	TS_SAVED_ROWS_END,
};

TS_STYLE(fix, ts_style, ts_fix_recenter)
const struct ts_style ts_fix_recenter = {
	.name = "recenter",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_OWN | TS_RANKS_OUTPUTS,
	.summary = "Keeps the centre of mass of a group at a given position",
	.doc = "In each step, after positions have been integrated, the particles of the shifted group are "
	       "moved together so that the centre of mass of the fix's group (unwrapped positions) is at the "
	       "given coordinates. Velocities do not change. Rigid bodies with a member in the shifted group "
	       "are moved as a whole. Define the fix after the fixes that integrate.",
	.example = "fix still ball recenter INIT INIT NULL shift all",
	.args = args,
	.state_size = sizeof(struct state),
	.saved = saved,
	.values = values,
	.init = init,
	.hook[TS_STAGE_INITIAL_INTEGRATE] = initial_integrate,
};
