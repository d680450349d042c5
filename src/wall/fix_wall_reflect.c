/* Fix wall/reflect: planes that reflect the centres of particles. */
#include "core/sim.h"

#include <string.h>

#include "box/domain.h"
#include "particle/particles.h"
#include "region/region.h"

#include "base/banned.h"

enum { NFACES = 6 };

struct state {
	const char *word[NFACES]; /* as written: a number, EDGE, v_NAME, or NULL */
	struct ts_number at[NFACES];
	int units;
	bool told; /* that bodies are not reflected */
};

static const char *const faces[] = { "xlo", "xhi", "ylo", "yhi", "zlo", "zhi" };

static enum ts_status read_face(struct ts_instance *self, struct tsim *sim, int k)
{
	struct state *s = self->state;
	const char *word = s->word[k], *name = word + 2;

	if (ts_box_periodic(&sim->domain->box, k / 2))
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "fix wall/reflect: no wall can be at %s, the box is periodic there", faces[k]);
	if (sim->dimension == 2 && k / 2 == 2)
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "fix wall/reflect: no wall can be at %s in two dimensions", faces[k]);
	s->at[k].variable = NULL;
	if (ts_streq(word, "EDGE") || ts_parse_real(word, &s->at[k].value))
		return TS_OK;
	if (strncmp(word, "v_", 2) == 0 && sim->script_api &&
	    sim->script_api->has_variable(sim->script_api_data, name)) {
		s->at[k].variable = name;
		return ts_number_check(sim, &s->at[k], ts_instance_word(self, word));
	}
	return ts_fail(&sim->error, TS_SYNTAX, &self->where,
		       "fix wall/reflect: %s is '%s', expected a number, EDGE or v_NAME", faces[k], word);
}

/* Members follow their body, whatever velocity they get. */
static void doubt_bodies(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	const struct ts_particles *p = sim->particles;
	size_t members = 0;

	for (size_t i = 0; i < p->n; i++)
		members += p->body && p->body[i] && ts_in_group(p, i, self->group);
	if (members && !s->told)
		ts_warn(&sim->log, &self->where,
			"fix wall/reflect: %zu particles of its group belong to rigid bodies, which it does "
			"not reflect",
			members);
	s->told |= members > 0;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	const struct state *s = self->state;
	int n = 0;

	for (int k = 0; k < NFACES; k++) {
		if (!s->word[k])
			continue;
		TS_TRY(read_face(self, sim, k));
		n++;
	}
	if (n) {
		doubt_bodies(self, sim);
		return TS_OK;
	}
	return ts_fail(&sim->error, TS_SYNTAX, &self->where,
		       "fix wall/reflect: expected at least one of xlo, xhi, ylo, yhi, zlo, zhi");
}

static enum ts_status face_position(struct ts_instance *self, struct tsim *sim, int k, double *at)
{
	const struct state *s = self->state;
	const struct ts_box *box = &sim->domain->box;

	if (ts_streq(s->word[k], "EDGE")) {
		*at = k % 2 ? box->hi[k / 2] : box->lo[k / 2];
		return TS_OK;
	}
	TS_TRY(ts_number_now(sim, &s->at[k], &self->where, at));
	*at *= ts_domain_scale(sim, s->units, k / 2);
	return TS_OK;
}

static void reflect_particles(const struct ts_instance *self, struct tsim *sim, int k, double at)
{
	struct ts_particles *p = sim->particles;
	int dim = k / 2;

#pragma omp parallel for num_threads(ts_team(sim, p->n)) schedule(static)
	for (size_t i = 0; i < p->n; i++) {
		double beyond = k % 2 ? p->x[i][dim] - at : at - p->x[i][dim];

		if (!(beyond > 0) || !ts_in_group(p, i, self->group))
			continue;
		p->x[i][dim] = k % 2 ? at - beyond : at + beyond;
		p->v[i][dim] = -p->v[i][dim];
	}
}

static enum ts_status post_integrate(struct ts_instance *self, struct tsim *sim)
{
	const struct state *s = self->state;
	double at;

	for (int k = 0; k < NFACES; k++) {
		if (!s->word[k])
			continue;
		TS_TRY(face_position(self, sim, k, &at));
		reflect_particles(self, sim, k, at);
	}
	return TS_OK;
}

#define FACE(k, name_)                                                                                  \
	TS_WORD(name_, struct state, word[k], .flags = TS_OPTIONAL,                                     \
		.help = "position of a wall at this face: a coordinate, EDGE (the face of the box) or " \
			"v_NAME")
static const struct ts_arg args[] = {
	FACE(0, "xlo"),
	FACE(1, "xhi"),
	FACE(2, "ylo"),
	FACE(3, "yhi"),
	FACE(4, "zlo"),
	FACE(5, "zhi"),
	TS_ENUM("units", struct state, units, ts_region_units, .flags = TS_OPTIONAL,
		.help = "lattice: coordinates are in lattice spacings; box: in units of length"),
	TS_ARGS_END,
};

TS_STYLE(fix, ts_style, ts_fix_wall_reflect)
const struct ts_style ts_fix_wall_reflect = {
	.name = "wall/reflect",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_OWN,
	.summary = "Walls that reflect the centres of particles",
	.doc = "If the centre of a particle has passed the wall by the distance d in a step, it is placed at "
	       "d in front of the wall, and the velocity component normal to the wall is reversed. The "
	       "radius of the particle has no effect; see fix wall/gran for walls that interact with the "
	       "surfaces of particles. A wall can move (v_NAME), but its velocity is not transferred to "
	       "particles.",
	.example = "fix ends all wall/reflect xlo EDGE xhi 0.5\n"
		   "fix lid all wall/reflect zhi v_height units box",
	.args = args,
	.state_size = sizeof(struct state),
	.init = init,
	.hook[TS_STAGE_POST_INTEGRATE] = post_integrate,
};
