/* Fix lubrication: forces of thin layers of fluid between particles, and between particles and walls. */
#include "law/lubrication.h"

#include <inttypes.h>

#include "base/alloc.h"
#include "base/parallel.h"
#include "core/ranks.h"
#include "core/report.h"
#include "mesh/mesh_motion.h"
#include "neigh/neigh.h"
#include "particle/particles.h"
#include "particle/sphere_shape.h"
#include "wall/primitive_wall.h"
#include "wall/wall.h"

#include "base/banned.h"

struct state {
	struct ts_lubrication law;
	struct ts_words walls;

	const struct ts_wall **wall; /* [walls.n] Owned */
	size_t wall_capacity;
	/* pairs whose gap may become less than `outer` before the next rebuild */
	struct ts_contact_list pairs;
	/* of all particles at the last force computation: smallest gap (length), largest rate (1/time) */
	double gap, rate;
};

/* ---- definition */

static enum ts_status check_impacts(struct tsim *sim, const struct ts_word *word, const struct ts_wall *wall)
{
	if (!wall->exact)
		return TS_OK;
	return ts_fail(&sim->error, TS_STATE, &word->place,
		       "fix lubrication: the wall %s has `impact exact`, which carries particles through an "
		       "impact as if there were no fluid; use `impact resolved`",
		       word->text);
}

/* Whether the fix makes or moves this surface, and integrates its motion under the forces on it. */
static bool is_driven_by(const struct ts_instance *fix, const struct ts_instance *surface)
{
	const struct ts_style *style = fix->style;

	if (fix == surface)
		return style->hook[TS_STAGE_INITIAL_INTEGRATE] && style->hook[TS_STAGE_FINAL_INTEGRATE];
	return style->family && ts_streq(style->family, TS_FAMILY_MESH_MOVER) &&
	       style->hook[TS_STAGE_FINAL_INTEGRATE] &&
	       ts_streq(((const struct ts_mesh_mover *)fix->state)->mesh, surface->id);
}

/* A surface does not get the reaction of the layers: its motion must not depend on the forces on it. */
static enum ts_status check_motion(struct tsim *sim, const struct ts_word *word, const struct ts_wall *wall)
{
	const struct ts_instances *fixes = &sim->instances[TS_KIND_FIX];

	for (size_t k = 0; k < ts_wall_surfaces(wall); k++) {
		const struct ts_instance *surface = ts_wall_surface(wall, k);

		for (size_t m = 0; m < fixes->n; m++)
			if (surface != wall->by && is_driven_by(fixes->item[m], surface))
				return ts_fail(&sim->error, TS_STATE, &word->place,
					       "fix lubrication: surface %s of the wall %s moves under the "
					       "forces on it (fix %s %s), which do not include those of "
					       "lubrication; use a prescribed motion (fix move/mesh)",
					       surface->id, word->text, fixes->item[m]->style->name,
					       fixes->item[m]->id);
	}
	return check_impacts(sim, word, wall);
}

/* A wall of planes, a height field or meshes. */
static enum ts_status check_shape(struct tsim *sim, const struct ts_word *word, const struct ts_wall *wall)
{
	const struct ts_primitive_wall *primitive = ts_primitive_wall_of(wall);
	bool near = wall->shape->near != NULL;
	struct ts_primitive_plane plane;

	for (int k = 0; primitive && k < primitive->n; k++)
		near &= ts_primitive_wall_plane(sim, primitive, k, &plane);
	if (near)
		return check_motion(sim, word, wall);
	return ts_fail(&sim->error, TS_STATE, &word->place,
		       "fix lubrication: the wall %s is not made of planes (xplane, yplane, zplane), a "
		       "height field or meshes; lubrication at cylinders and regions is not supported",
		       word->text);
}

static enum ts_status find_wall(struct tsim *sim, const struct ts_word *word, struct ts_wall **out)
{
	const struct ts_instance *fix = ts_sim_find(sim, TS_KIND_FIX, word->text);

	if (!fix)
		return ts_fail(&sim->error, TS_UNKNOWN, &word->place,
			       "fix lubrication: there is no fix '%s'; walls must be defined before",
			       word->text);
	if (!fix->style->family || !ts_streq(fix->style->family, TS_FAMILY_WALL))
		return ts_fail(&sim->error, TS_STATE, &word->place,
			       "fix lubrication: fix %s is no wall, but of style %s", word->text,
			       fix->style->name);
	*out = fix->state;
	return check_shape(sim, word, *out);
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	if (!(s->law.inner < s->law.outer))
		return ts_fail(&sim->error, TS_RANGE, ts_instance_word(self, "outer"),
			       "fix lubrication: outer is %g, expected more than inner, %g", s->law.outer,
			       s->law.inner);
	if (TS_GROW(s->wall, s->wall_capacity, s->walls.n) != TS_OK)
		return ts_nomem(&sim->error);
	for (size_t k = 0; k < s->walls.n; k++) {
		struct ts_wall *wall = NULL;

		TS_TRY(find_wall(sim, &s->walls.word[k], &wall));
		wall->look = fmax(wall->look, s->law.outer);
		s->wall[k] = wall;
		for (size_t l = 0; l < k; l++)
			if (s->wall[l] == s->wall[k])
				return ts_fail(&sim->error, TS_SYNTAX, &s->walls.word[k].place,
					       "fix lubrication: the wall %s is given twice",
					       s->walls.word[k].text);
	}
	if (!(s->rate > 0)) /* no forces yet */
		s->gap = INFINITY;
	sim->neigh->fix_reach = fmax(sim->neigh->fix_reach, s->law.outer);
	return TS_OK;
}

/* Members of rigid bodies: the limit of the time step would be that of the body. */
static enum ts_status list_pairs(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	const struct ts_particles *p = sim->particles;

	for (size_t i = 0; p->body && i < p->n; i++)
		if (p->body[i] && ts_in_group(p, i, self->group))
			return ts_fail(&sim->error, TS_STATE, &self->where,
				       "fix lubrication: particle %d belongs to a rigid body, which is not "
				       "supported; exclude it from the group",
				       p->tag[i]);
	s->pairs.n = 0; /* the pairs have no history to be carried over */
	return ts_contact_list_build(sim, &s->pairs, sim->neigh->built_skin + s->law.outer,
				     ts_neigh_excluded(sim));
}

/* ---- layers of one particle */

/* What the layers of a particle do to it. */
struct sums {
	double force[3], torque[3];
	double rate;	  /* bound of the rate at which they slow it down, 1/time; 0 if it is immobile */
	double least_gap; /* less than `outer`; or infinite */
};

struct task {
	const struct tsim *sim;
	const struct state *s;
	int group;
	bool forces;	    /* false: only rate and gap */
	double *gap, *rate; /* extremes of all particles; NULL if not `forces` */
};

static void add_layer(const struct task *t, size_t i, const struct ts_lubrication_pair *c, double other_imass,
		      struct sums *out)
{
	const struct ts_lubrication *law = &t->s->law;
	double imass = t->sim->particles->imass[i];

	if (!(c->gap < law->outer))
		return;
	out->least_gap = fmin(out->least_gap, c->gap);
	if (imass > 0)
		out->rate += ts_lubrication_rate(law, c->radius, c->gap, imass, 1 / ts_inertia(t->sim, i),
						 other_imass);
	if (t->forces)
		ts_lubrication_add(law, c, out->force, out->torque);
}

static void add_pair(const struct task *t, size_t i, size_t j, struct sums *out)
{
	const struct ts_particles *p = t->sim->particles;
	struct ts_lubrication_pair c = { .radius = { p->radius[i], p->radius[j] } };
	double distance;

	if (!ts_in_group(p, j, t->group))
		return;
	ts_sub(p->x[i], p->x[j], c.n);
	distance = ts_norm(c.n);
	if (!(distance > 0)) /* no direction */
		return;
	ts_scale(1 / distance, c.n, c.n);
	c.gap = distance - (c.radius[0] + c.radius[1]);
	ts_sub(p->v[i], p->v[j], c.v);
	ts_scale(1, p->omega[i], c.omega[0]);
	ts_scale(1, p->omega[j], c.omega[1]);
	add_layer(t, i, &c, p->imass[j], out);
}

struct at_wall {
	const struct task *t;
	size_t i;
	struct sums *out;
};

static void add_point(void *context, const struct ts_wall_near_point *point)
{
	const struct at_wall *at = context;
	const struct ts_particles *p = at->t->sim->particles;
	struct ts_lubrication_pair c = { .radius = { p->radius[at->i], INFINITY } };

	ts_scale(1, point->n, c.n);
	c.gap = point->distance - c.radius[0];
	ts_sub(p->v[at->i], point->velocity, c.v);
	ts_scale(1, p->omega[at->i], c.omega[0]);
	add_layer(at->t, at->i, &c, 0, at->out);
}

static void add_wall(const struct task *t, size_t i, const struct ts_wall *wall, struct sums *out)
{
	const struct ts_particles *p = t->sim->particles;
	struct at_wall at = { t, i, out };

	if (ts_in_group(p, i, wall->by->group))
		wall->shape->near(wall, t->sim, i, p->radius[i] + t->s->law.outer, add_point, &at);
}

/* Pairs in the order of the identities of the partners, so that sums depend neither on threads nor on the order of
 * particles in memory; then walls in the order of the line. */
static void sum_layers(const struct task *t, size_t i, struct sums *out)
{
	const struct ts_contact_list *pairs = &t->s->pairs;
	const struct ts_gather *g = &pairs->gather;

	*out = (struct sums){ .least_gap = INFINITY };
	if (!ts_in_group(t->sim->particles, i, t->group))
		return;
	for (size_t k = pairs->n ? g->first[i] : 0; pairs->n && k < g->first[i + 1]; k++) {
		uint32_t r = g->entry[k] >> 1;

		add_pair(t, i, (size_t)(g->entry[k] & 1 ? pairs->i[r] : pairs->j[r]), out);
	}
	for (size_t k = 0; k < t->s->walls.n; k++)
		add_wall(t, i, t->s->wall[k], out);
}

/* ---- forces */

/* Velocity Verlet is stable for steps below 2/rate. */
static bool is_unstable(const struct tsim *sim, double rate)
{
	return rate * sim->clock.dt > 2;
}

/* Smallest and largest numbers do not depend on the order. */
static void keep_extremes(double gap, double rate, double *least, double *most)
{
#pragma omp critical(ts_lubrication_extremes)
	{
		*least = fmin(*least, gap);
		*most = fmax(*most, rate);
	}
}

static void add_forces_range(void *context, size_t from, size_t to)
{
	const struct task *t = context;
	const struct ts_particles *p = t->sim->particles;
	double gap = INFINITY, rate = 0;

	for (size_t i = from; i < to; i++) {
		struct sums sums;

		sum_layers(t, i, &sums);
		ts_add(p->f[i], sums.force, p->f[i]);
		ts_add(p->torque[i], sums.torque, p->torque[i]);
		gap = fmin(gap, sums.least_gap);
		rate = fmax(rate, sums.rate);
	}
	keep_extremes(gap, rate, t->gap, t->rate);
}

static enum ts_status fail_unstable(const struct ts_instance *self, struct tsim *sim, const struct task *t)
{
	const struct ts_particles *p = sim->particles;
	struct sums sums = { 0 };
	size_t i = 0;

	while (i < p->n && !is_unstable(sim, sums.rate))
		sum_layers(t, i++, &sums);
	return ts_fail(&sim->error, TS_PHYSICS, &self->where,
		       "fix lubrication: at step %" PRId64
		       " the gap at particle %d is %g, and the time step %g exceeds the stability limit %g "
		       "of its layers of fluid; use a smaller `timestep`, or a larger `inner`",
		       sim->clock.step, p->tag[i - 1], sums.least_gap, sim->clock.dt, 2 / sums.rate);
}

static enum ts_status add_forces(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	struct task task = { sim, s, self->group, true, &s->gap, &s->rate };
	size_t n = sim->particles->n;

	s->gap = INFINITY;
	s->rate = 0;
	ts_parallel(ts_team(sim, n), n, add_forces_range, &task);
	return is_unstable(sim, s->rate) && !sim->run.in_setup ? fail_unstable(self, sim, &task) : TS_OK;
}

/* ---- limits and outputs */

/* The largest rate, and the smallest gap, of all particles. */
static void find_extremes(const struct ts_instance *self, const struct tsim *sim, double *rate, double *gap)
{
	struct task task = { sim, self->state, self->group, false, NULL, NULL };

	*rate = 0;
	*gap = INFINITY;
	for (size_t i = 0; i < sim->particles->n; i++) {
		struct sums sums;

		sum_layers(&task, i, &sums);
		*rate = fmax(*rate, sums.rate);
		*gap = fmin(*gap, sums.least_gap);
	}
}

/* Of the layers of particle i. */
static void add_ground(const struct ts_instance *self, const struct tsim *sim, size_t i,
		       struct ts_ground_springs *sum)
{
	struct task task = { sim, self->state, self->group, false, NULL, NULL };
	struct sums sums;

	sum_layers(&task, i, &sums);
	for (int d = 0; d < 3; d++)
		sum->rate[d] += sums.rate;
	sum->turning += sums.rate;
	sum->estimated = true;
}

/* The largest rate of one layer with the gap `inner`, between the particle and an equal one or a plane. */
static double largest_rate(const struct ts_instance *self, const struct tsim *sim)
{
	const struct state *s = self->state;
	const struct ts_particles *p = sim->particles;
	double most = 0;

	for (size_t i = 0; i < p->n; i++) {
		double radius[2] = { p->radius[i], s->walls.n ? INFINITY : p->radius[i] };

		if (p->imass[i] > 0 && ts_in_group(p, i, self->group))
			most = fmax(most, ts_lubrication_rate(&s->law, radius, s->law.inner, p->imass[i],
							      1 / ts_inertia(sim, i),
							      s->walls.n ? 0 : p->imass[i]));
	}
	return most;
}

static enum ts_status plan(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report)
{
	const struct state *s = self->state;
	size_t before = report->nlimits;
	double rate, gap, most = largest_rate(self, sim);

	find_extremes(self, sim, &rate, &gap);
	if (rate > 0)
		TS_TRY(ts_report_limit(report, 2 / rate, true, &self->where,
				       "fix lubrication, 2/rate of the present layers, smallest gap %g",
				       gap));
	ts_report_watched(report, before);
	if (most > 0)
		TS_TRY(ts_report_limit(report, 2 / most, false, &self->where,
				       "fix lubrication, 2/rate of a layer with the gap inner, %g",
				       s->law.inner));
	if (report->limits_only)
		return TS_OK;
	report->bytes += (double)ts_contact_list_bytes(&s->pairs);
	ts_report_line(report, "lubrication", "%zu pairs within the skin, %zu walls", s->pairs.n, s->walls.n);
	return TS_OK;
}

static enum ts_status join(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	double most[2] = { -s->gap, s->rate };

	ts_ranks_most_of(sim, most, 2);
	s->gap = -most[0];
	s->rate = most[1];
	return TS_OK;
}

enum { GAP, STEP };

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct state *s = self->state;

	(void)sim;
	out->data[GAP] = s->gap;
	out->data[STEP] = s->rate > 0 ? 2 / s->rate : INFINITY;
	return TS_OK;
}

static const struct ts_saved saved[] = { TS_SAVE_F64(struct state, gap), TS_SAVE_F64(struct state, rate),
					 TS_SAVED_ROWS_END };

static void fini(struct ts_instance *self)
{
	struct state *s = self->state;

	ts_contact_list_release(&s->pairs);
	ts_free(s->wall);
}

static const struct ts_arg args[] = {
	TS_REAL("viscosity", struct state, law.viscosity, .range = TS_POSITIVE, .unit = "pressure time",
		.help = "dynamic viscosity of the fluid"),
	TS_REAL("inner", struct state, law.inner, .range = TS_POSITIVE, .unit = "length",
		.help = "smallest gap, the roughness of the surfaces: smaller gaps count as this one"),
	TS_REAL("outer", struct state, law.outer, .range = TS_POSITIVE, .unit = "length",
		.help = "gap from which on there is no force"),
	TS_SOME_KEYWORD("walls", struct state, walls, TS_REPEAT,
			.help = "IDs of fixes wall/gran made of planes, height fields or meshes; without: no "
				"walls"),
	TS_ARGS_END,
};

static const char *const components[] = { "gap", "step" };
static const struct ts_value values[] = {
	{ "layers", "",
	  "of the last force computation: smallest gap that is less than `outer` (length), infinite if there "
	  "is none; largest stable time step of the layers (time)",
	  TS_VECTOR, 2, components, eval },
	{ .name = NULL },
};

static const char *const doc_more[] = {
	"Particles and planes in contact keep the lubrication force, with the gap `inner`, in addition to "
	"the force of the contact law. Left out are the logarithmic correction of the squeeze force and all "
	"terms that remain finite as the gap closes: far from contact the force is that of a drag (fix "
	"drag/stokes), which this fix does not include. The sum is accurate where h << R. The relative "
	"rotation about the line of centres has no force. At the gap `outer` the force jumps to zero: the "
	"smaller `outer`, the larger the jump 6 pi mu R^2 v_n/outer. In two dimensions the forces are those "
	"of single spheres, as are those of contacts, and not per unit depth: with a depth D of the "
	"particles, give densities times D (masses per area), and forces of a fluid are not comparable with "
	"them. Pairs of which one particle is not in the group have no force; neither have pairs "
	"without contact forces (neigh_modify exclude, special_bonds). Forces of fluids that are solved for "
	"(flow_style) are not changed.",
	"For equal spheres the 1/h and the slip term are those of LAMMPS' pair lubricate (log 1), whose "
	"rolling term is a quarter of C. C is that of Jeffrey and Onishi; the solution of Reynolds' equation "
	"for counter-rotating spheres gives the same.",
	"The walls are fixes wall/gran with xplane, yplane or zplane, voxels, or meshes, which must be "
	"defined before; their motion (wiggle, shear, velocity, `move` of the field, fix move/mesh) counts "
	"by the velocity of the surface at its point nearest to the particle. Particles that are not in the "
	"group of the wall, or of the fix of its surface, have no layers there. Cylinders, regions, walls "
	"with `impact exact`, and members of rigid bodies are refused. The force is not part of the force on "
	"the wall, f_ID of its fix, nor of that on a mesh (fix mesh/surface/stress), nor of stresses of "
	"contacts (compute pressure, compute stress/atom). So meshes that move under the forces on them (fix "
	"move/mesh/free, fix mesh/surface/stress/servo) are refused.",
	"Height fields and meshes: each point of the surface at which the distance from the centre of the "
	"particle has a local minimum, and is less than its radius plus `outer`, has a layer: with one face "
	"one layer, at the bottom of a groove one for each face. A surface that is flat has one, wherever "
	"the particle is above its columns or triangles, and the force is that of the plane (triangles of "
	"one mesh; where flat meshes meet, each has its own). Inside a face the force is that of the plane "
	"of the face as if it were infinite. At an edge or corner the formulas of the plane are used with "
	"the normal from the nearest point: an approximation, which is too large, since fluid escapes more "
	"easily there; so is the sum over steps or asperities within the area of a layer, of radius sqrt(2 R "
	"h). Immobile particles have no layers at meshes.",
	"The force is explicit and stiff: a layer slows down a particle of mass m at the rate 6 pi mu R^2/(h "
	"m). Velocity Verlet is stable for steps below 2/rate, with the rate the largest sum over the layers "
	"of a particle (an upper bound of the rates of the system, exact for two spheres and for a sphere at "
	"a plane). A run with a larger step is refused, the plan warns if it would be too large at the gap "
	"`inner`, and a run in which the particles come so near that the step becomes too large stops with "
	"an error. The limits of several fixes lubrication are checked one by one, although their rates add "
	"up. Where a layer damps a stiff contact, with the limits h_c of the contact and h_l of the layer "
	"alone, a step h is stable if (h/h_c)^2 + h/h_l < 1: the plan reports this limit of the particles "
	"that have both, and a larger step is warned of.",
	NULL,
};

TS_STYLE(fix, ts_style, ts_fix_lubrication)
const struct ts_style ts_fix_lubrication = {
	.name = "lubrication",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_OWN | TS_RANKS_OUTPUTS,
	.join = join,
	.summary =
		"forces of thin layers of viscous fluid between particles, and between particles and walls",
	.doc = "Two spheres of radii a and b, or a sphere and a plane (b infinite), with the gap h < `outer` "
	       "between their surfaces, get the leading forces and torques of a closing gap. With R = ab/(a "
	       "+ b), n the normal and v_n the normal velocity of separation, the squeeze flow gives\n\n"
	       "  F = -6 pi mu R^2/h v_n n.\n\n"
	       "Slip and rolling along the surfaces give, with L = ln(min(a, b)/h), 0 where negative,\n\n"
	       "  S = v_t - ((a + h/2) omega_a + (b + h/2) omega_b) x n,  W = -(omega_a - omega_b) x n\n"
	       "  F = -(A S + B W),  T_a = n x ((a + h/2) (A S + B W) + B S + C W)\n"
	       "  A = 8/5 pi mu R L (2 - 3 ab/(a + b)^2),  B = 12/5 pi mu R^2 L (a - b)/(a + b)\n"
	       "  C = 24/5 pi mu R^3 L,\n\n"
	       "all logarithmic terms of the tangential resistance functions of two spheres (Jeffrey and "
	       "Onishi 1984; Kim and Karrila 1991) and of a sphere at a plane (Goldman, Cox and Brenner "
	       "1967). n points to a, and v_t is the velocity of the centre of a minus that of b, along the "
	       "surface. In both forces h is at least `inner`. A pair that moves as one rigid body has no "
	       "force; momentum and angular momentum of a pair of spheres are conserved. Particles rotate "
	       "only with an integrator of rotation (nve/sphere).",
	.doc_more = doc_more,
	.example = "fix floor all wall/gran model hertz tangential history primitive type 1 zplane 0.0\n"
		   "fix layers all lubrication viscosity 1e-3 inner 1e-5 outer 2e-4 walls floor",
	.cite = "D. J. Jeffrey, Y. Onishi, J. Fluid Mech. 139 (1984) 261",
	.args = args,
	.state_size = sizeof(struct state),
	.saved = saved,
	.columns = TS_NEED(OMEGA) | TS_NEED(TORQUE),
	.values = values,
	.init = init,
	.hook = { [TS_STAGE_POST_BUILD] = list_pairs, [TS_STAGE_POST_FORCE] = add_forces },
	.ground = add_ground,
	.plan = plan,
	.fini = fini,
};
