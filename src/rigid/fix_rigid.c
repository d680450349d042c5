/* Fix rigid: particles as one rigid body, or one body per group or molecule. */
#include "base/sort.h"
#include "core/unclaimed_state.h"
#include "particle/molecule.h"
#include "rigid/rigid.h"
#include "rigid/rigid_motion.h"

#include <string.h>

#include "base/banned.h"

enum { SINGLE, GROUP, MOLECULE };

struct rigid {
	int mode;
	int64_t ngroups;
	struct ts_words groups;
	struct ts_words force, torque; /* bodies, and on or off for x, y, z */
	uint8_t made;		       /* saved: the bodies exist */
	int *group;		       /* [number of groups] */
};

/* Particles, body by body: member[first[b]] .. member[first[b + 1] - 1]. Several groups can share particles;
 * that is an error when the bodies are made. */
struct members {
	size_t bodies, *first, n, capacity;
	int32_t *member;
};

/* Reads "*", a number or a range: bodies from .. to-1 of n. */
static enum ts_status read_bodies(struct tsim *sim, const struct ts_word *word, size_t n, size_t *from,
				  size_t *to)
{
	struct ts_types t;

	if (!ts_parse_types(word->text, &t) || t.lo < 1 || (size_t)(t.hi ? t.hi : t.lo) > n)
		return ts_fail(&sim->error, TS_SYNTAX, &word->place,
			       "fix rigid: expected one of the %zu bodies or *, found '%s'", n, word->text);
	*from = (size_t)t.lo - 1;
	*to = t.hi ? (size_t)t.hi : n;
	return TS_OK;
}

static enum ts_status read_switch(struct tsim *sim, const struct ts_word *word, double *free)
{
	bool on = ts_streq(word->text, "on"), off = ts_streq(word->text, "off");

	*free = on ? 1 : 0;
	return on || off ? TS_OK
			 : ts_fail(&sim->error, TS_SYNTAX, &word->place,
				   "fix rigid: expected on or off, found '%s'", word->text);
}

/* Reads "2 on on off", any number of times, to free[first .. first + 2]. */
static enum ts_status read_freedom(struct tsim *sim, struct ts_words words, size_t first,
				   struct ts_body *body, size_t n)
{
	for (size_t w = 0; w < words.n; w += 4) {
		size_t from = 0, to = 0;

		if (w + 4 > words.n)
			return ts_fail(&sim->error, TS_SYNTAX, &words.word[w].place,
				       "fix rigid: expected a body and three times on or off");
		TS_TRY(read_bodies(sim, &words.word[w], n, &from, &to));
		for (size_t b = from; b < to; b++)
			for (size_t k = 0; k < 3; k++)
				TS_TRY(read_switch(sim, &words.word[w + 1 + k], &body[b].free[first + k]));
	}
	return TS_OK;
}

static enum ts_status add_member(struct members *m, struct tsim *sim, size_t i)
{
	if (TS_GROW(m->member, m->capacity, m->n + 1) != TS_OK)
		return ts_nomem(&sim->error);
	m->member[m->n++] = (int32_t)i;
	return TS_OK;
}

/* The particles of the fix in each of its groups. */
static enum ts_status list_groups(const struct ts_instance *self, struct tsim *sim, struct members *m)
{
	const struct rigid *s = self->state;
	const struct ts_particles *p = sim->particles;

	m->bodies = s->mode == GROUP ? s->groups.n : 1;
	m->first = ts_alloc(m->bodies + 1, sizeof *m->first);
	if (!m->first)
		return ts_nomem(&sim->error);
	m->first[0] = 0;
	for (size_t b = 0; b < m->bodies; b++) {
		for (size_t i = 0; i < p->n; i++)
			if (ts_in_group(p, i, self->group) && ts_in_group(p, i, s->group[b]))
				TS_TRY(add_member(m, sim, i));
		m->first[b + 1] = m->n;
		if (m->n == m->first[b])
			return ts_fail(&sim->error, TS_STATE, &self->where,
				       "fix rigid: no particles in group %s",
				       ts_group_name(sim, s->group[b]));
	}
	return TS_OK;
}

struct numbered {
	double molecule;
	int32_t particle;
};

static int by_molecule(const void *a, const void *b)
{
	const struct numbered *x = a, *y = b;

	if (x->molecule != y->molecule)
		return x->molecule < y->molecule ? -1 : 1;
	return x->particle < y->particle ? -1 : x->particle > y->particle;
}

/* The particles of the fix by molecules, in the order of their numbers. */
static enum ts_status list_molecules(const struct ts_instance *self, struct tsim *sim, struct members *m)
{
	const struct ts_particles *p = sim->particles;
	const double *molecule = ts_particles_molecules(p);
	struct numbered *of = ts_alloc(p->n + 1, sizeof *of);
	size_t n = 0;

	m->first = ts_alloc(p->n + 1, sizeof *m->first);
	m->member = ts_alloc(p->n + 1, sizeof *m->member);
	if (!of || !m->first || !m->member) {
		ts_free(of);
		return ts_nomem(&sim->error);
	}
	for (size_t i = 0; i < p->n; i++)
		if (ts_in_group(p, i, self->group))
			of[n++] = (struct numbered){ molecule[i], (int32_t)i };
	ts_sort(of, n, sizeof *of, by_molecule);
	for (size_t k = 0; k < n; k++) {
		if (!k || of[k].molecule != of[k - 1].molecule)
			m->first[m->bodies++] = k;
		m->member[k] = of[k].particle;
	}
	m->first[m->bodies] = n;
	ts_free(of);
	return n ? TS_OK
		 : ts_fail(&sim->error, TS_STATE, &self->where, "fix rigid: no particles in group %s",
			   ts_group_name(sim, self->group));
}

/* Makes bodies of the members, with their freedoms from `body`; members of another body are an error. */
static enum ts_status make_bodies(struct ts_instance *self, struct tsim *sim, const struct members *m,
				  const struct ts_body *body)
{
	const struct ts_particles *p = sim->particles;

	for (size_t b = 0; b < m->bodies; b++) {
		const int32_t *member = m->member + m->first[b];
		size_t n = m->first[b + 1] - m->first[b];
		struct ts_body made;

		for (size_t k = 0; k < n; k++)
			if (ts_rigid_member(p, (size_t)member[k]))
				return ts_fail(&sim->error, TS_STATE, &self->where,
					       "fix rigid: particle %d belongs to a rigid body already",
					       p->tag[member[k]]);
		TS_TRY(ts_rigid_of_spheres(sim, member, n, &made));
		memcpy(made.free, body[b].free, sizeof made.free);
		TS_TRY(ts_rigid_add(sim, &made, ts_rigid_owner(self->id), member, n));
	}
	return TS_OK;
}

static enum ts_status create_bodies(struct ts_instance *self, struct tsim *sim, const struct members *m)
{
	const struct rigid *s = self->state;
	struct ts_body *body = ts_alloc(m->bodies, sizeof *body);
	enum ts_status status;

	if (!body)
		return ts_nomem(&sim->error);
	for (size_t b = 0; b < m->bodies; b++)
		for (int k = 0; k < 6; k++)
			body[b].free[k] = 1;
	status = read_freedom(sim, s->force, 0, body, m->bodies);
	if (status == TS_OK)
		status = read_freedom(sim, s->torque, 3, body, m->bodies);
	if (status == TS_OK) /* of a former fix with this ID */
		status = ts_rigid_dissolve(sim, ts_rigid_owner(self->id));
	if (status == TS_OK && !sim->unclaimed)
		status = ts_rigid_dissolve_orphans(sim);
	if (status == TS_OK)
		status = make_bodies(self, sim, m, body);
	ts_free(body);
	return status;
}

static enum ts_status read_groups(struct ts_instance *self, struct tsim *sim)
{
	struct rigid *s = self->state;
	size_t n = s->mode == GROUP ? s->groups.n : 1;

	if (s->mode == GROUP && (int64_t)n != s->ngroups)
		return ts_fail(&sim->error, TS_SYNTAX, &self->where,
			       "fix rigid: expected %d groups, found %zu", (int)s->ngroups, n);
	if (!s->group)
		s->group = ts_arena_alloc(&self->arena, n, sizeof *s->group);
	if (!s->group)
		return ts_nomem(&sim->error);
	s->group[0] = self->group;
	for (size_t b = 0; s->mode == GROUP && b < n; b++)
		TS_TRY(ts_group_require(sim, &s->groups.word[b], &s->group[b]));
	return TS_OK;
}

/* Creates the bodies when the fix is defined; not again before each run, nor after a restart that has
 * them. */
static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct rigid *s = self->state;
	struct members members = { 0 };
	enum ts_status status;

	TS_TRY(read_groups(self, sim));
	if (s->made || ts_unclaimed_exists(sim, self))
		return TS_OK;
	if (s->mode == MOLECULE)
		TS_TRY(ts_particles_need_molecules(sim, "fix rigid", &self->where));
	status = (s->mode == MOLECULE ? list_molecules : list_groups)(self, sim, &members);
	if (status == TS_OK)
		status = create_bodies(self, sim, &members);
	ts_free(members.first);
	ts_free(members.member);
	s->made = status == TS_OK;
	return status;
}

/* One row for each body of this fix. */
static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct ts_rigid *r = sim->rigid;
	int64_t owner = ts_rigid_owner(self->id);
	size_t n = 0;

	TS_TRY(ts_table_resize(out, r->n, 12));
	for (size_t b = 0; b < r->n; b++) {
		const struct ts_body *body = &r->body[b];
		double *row = out->data + 12 * n;

		if (r->owner[b] != owner)
			continue;
		memcpy(row, body->x, sizeof body->x);
		memcpy(row + 3, body->v, sizeof body->v);
		memcpy(row + 6, body->force, sizeof body->force);
		memcpy(row + 9, body->torque, sizeof body->torque);
		n++;
	}
	out->rows = n;
	return TS_OK;
}

static const char *const columns[] = { "x",  "y",  "z",	 "vx", "vy", "vz", "fx",
				       "fy", "fz", "tx", "ty", "tz", NULL };

static const struct ts_value values[] = {
	{ "bodies", "", "per body: centre of mass (unwrapped), its velocity, force and torque", TS_ARRAY, 12,
	  columns, eval },
	{ .name = NULL },
};

static const struct ts_arg group_rows[] = {
	TS_INT("number", struct rigid, ngroups, .flags = TS_POSITIONAL, .range = TS_POSITIVE,
	       .help = "number of groups"),
	TS_LIST("groups", struct rigid, groups, .help = "groups, one per body"),
	TS_ARGS_END,
};
static const struct ts_mode modes[] = {
	{ "single", "all particles of the group are one body", NULL },
	{ "group", "one body per group", group_rows },
	{ "molecule", "one body per molecule, in the order of their numbers", NULL },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_MODE("bodystyle", struct rigid, mode, modes, .help = "which particles form a body"),
	TS_SOME_KEYWORD("force", struct rigid, force, TS_REPEAT,
			.help = "a body, *, or a range, and on or off for x, y and z: whether it moves in "
				"this direction; may be repeated"),
	TS_SOME_KEYWORD("torque", struct rigid, torque, TS_REPEAT,
			.help = "a body, *, or a range, and on or off for x, y and z: whether it rotates "
				"about this axis; may be repeated"),
	TS_ARGS_END,
};

static const struct ts_saved saved[] = {
	TS_SAVE_U8(struct rigid, made),
	TS_SAVED_ROWS_END,
};

TS_STYLE(fix, ts_style, ts_fix_rigid)
const struct ts_style ts_fix_rigid = {
	.name = "rigid",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_WHOLE,
	.summary = "Integrates particles as one rigid body, or one body per group or molecule",
	.doc = "Creates rigid bodies when the fix is defined, from the present positions, masses, radii and "
	       "velocities of the particles. The inertia is that of spheres, which may overlap:\n\n"
	       "    M = sum m,   I = sum (0.4 m R^2 + m (d^2 1 - d d))\n\n"
	       "with the vector d from the centre of mass. The bodies are integrated by M dV/dt = F, dL/dt = "
	       "T as described for fix multisphere.\n\n"
	       "`molecule` makes a body of all particles of the group with the same molecule number, which "
	       "`fix ID all property/atom mol` and `set`, or the section Molecules of a data file, give "
	       "them. Particles that are created later belong to no body. rigid/small of LAMMPS is another "
	       "name of this fix.\n\n"
	       "Bodies follow their members: other velocities of members (`velocity`, `set`) make the body "
	       "move with their momentum and angular momentum in the next run. Bodies whose members "
	       "displace_atoms or `set` moves are displaced, or made anew where these were moved apart (a "
	       "clump is refused); change_box displaces them and keeps their shape. Other masses and "
	       "radii need the fix to be defined anew. replicate refuses bodies.\n\n"
	       "Members do not interact with each other; in contacts with others they have the mass of the "
	       "body. After unfix they are independent particles again. The particles must not be integrated "
	       "by another fix.",
	.example = "fix dumbbell pair rigid single\n"
		   "fix parts all rigid group 2 left right force 1 on on off torque * off off on",
	.args = args,
	.state_size = sizeof(struct rigid),
	.columns = TS_NEED(OMEGA) | TS_NEED(TORQUE) | TS_NEED(BODY) | TS_NEED(BODY_X),
	.saved = saved,
	.values = values,
	.init = init,
};
