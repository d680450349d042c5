#include <inttypes.h>
#include <math.h>
#include <string.h>

#include "box/domain.h"
#include "core/ranks.h"
#include "core/report.h"
#include "math/constants.h"
#include "particle/identity.h"
#include "particle/particles.h"
#include "particle/rank_sums.h"

#include "base/banned.h"

enum { NCUTTERS = 4 };

/* The cutters, in the order of ids, and the body particle. */
struct bit_particles {
	int32_t tag[NCUTTERS + 1];	/* 0: no body */
	int32_t cutter[NCUTTERS], body; /* indices; -1: none, or a particle of another rank */
};

/* What is known of all cutters, also of those of other ranks. */
struct cutters {
	double z[NCUTTERS], vz[NCUTTERS], f[NCUTTERS][3];
};

struct bit {
	double centre[2], diameter, wob, spring, clearance, damping;
	struct ts_number omega;
	int body_group;
	/* saved */
	double angle;
	/* outputs of the last step */
	double tangential, radial, axial, torque;
	struct bit_particles index;
	struct cutters all;
};

static void sort_into(struct bit_particles *index, const struct ts_particles *p, int n, size_t i)
{
	int at = n < NCUTTERS ? n : NCUTTERS - 1;

	for (; at && p->tag[index->cutter[at - 1]] > p->tag[i]; at--)
		index->cutter[at] = index->cutter[at - 1];
	index->cutter[at] = (int32_t)i;
}

/* Finds them by their groups; returns the number of cutters. */
static int find_all(const struct ts_instance *self, const struct ts_particles *p)
{
	struct bit *b = self->state;
	int n = 0;

	b->index.body = -1;
	for (size_t i = 0; i < p->n; i++) {
		if (b->body_group >= 0 && ts_in_group(p, i, b->body_group))
			b->index.body = (int32_t)i;
		else if (ts_in_group(p, i, self->group))
			sort_into(&b->index, p, n++, i);
	}
	for (int k = 0; k < NCUTTERS && k < n; k++)
		b->index.tag[k] = p->tag[b->index.cutter[k]];
	b->index.tag[NCUTTERS] = b->index.body < 0 ? 0 : p->tag[b->index.body];
	return n;
}

/* Finds those of this rank, of the particles that all ranks have found before; returns the number of cutters. */
static enum ts_status find_own(struct tsim *sim, struct bit_particles *index, int *n, bool *body)
{
	struct ts_identities map;
	int64_t found[2] = { 0, 0 };

	TS_TRY(ts_identities(sim, false, &map));
	for (int k = 0; k < NCUTTERS; k++) {
		index->cutter[k] = ts_identity_row(&map, index->tag[k]);
		found[0] += index->cutter[k] >= 0;
	}
	index->body = ts_identity_row(&map, index->tag[NCUTTERS]);
	found[1] = index->body >= 0;
	for (int k = 0; k < 2; k++)
		ts_rank_sums_count(sim, &found[k]);
	*n = (int)found[0];
	*body = found[1] > 0;
	return TS_OK;
}

static enum ts_status find_particles(struct ts_instance *self, struct tsim *sim)
{
	struct bit *b = self->state;
	bool body;
	int n;

	if (sim->division) {
		TS_TRY(find_own(sim, &b->index, &n, &body));
	} else {
		n = find_all(self, sim->particles);
		body = b->index.body >= 0;
	}
	if (n != NCUTTERS)
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "fix drill/bit: its group has %d cutters, expected %d particles%s", n,
			       NCUTTERS, sim->run.inside ? ": the bit has left the box" : "");
	if (b->body_group >= 0 && !body)
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "fix drill/bit: the body group is empty, expected one particle%s",
			       sim->run.inside ? ": the bit has left the box" : "");
	return TS_OK;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	if (ts_box_periodic(&sim->domain->box, 2))
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "fix drill/bit: the box is periodic along z, along which the bit moves; take "
			       "`boundary ... f`");
	return find_particles(self, sim);
}

/* Each number is known on one rank: the largest of all. */
static void look_at_cutters(const struct tsim *sim, struct bit *b)
{
	const struct ts_particles *p = sim->particles;

	for (int k = 0; k < NCUTTERS; k++) {
		int32_t i = b->index.cutter[k];

		b->all.z[k] = i < 0 ? -INFINITY : p->x[i][2];
		b->all.vz[k] = i < 0 ? -INFINITY : p->v[i][2];
		for (int d = 0; d < 3; d++)
			b->all.f[k][d] = i < 0 ? -INFINITY : p->f[i][d];
	}
	ts_ranks_most_of(sim, (double *)&b->all, sizeof b->all / sizeof(double));
}

static double mean_height(const struct bit *b)
{
	double sum = 0;

	for (int k = 0; k < NCUTTERS; k++)
		sum += b->all.z[k];
	return sum / NCUTTERS;
}

static double mean_velocity(const struct bit *b)
{
	double sum = 0;

	for (int k = 0; k < NCUTTERS; k++)
		sum += b->all.vz[k];
	return sum / NCUTTERS;
}

/* Prescribes x and y of cutter k: cutters are 90 degrees apart on a circle around the axis. */
static void place_cutter(const struct bit *b, struct ts_particles *p, int k, double omega)
{
	int32_t i = b->index.cutter[k];
	double angle = b->angle + k * (TS_PI / 2), r = 0.5 * b->diameter;

	if (i < 0)
		return;
	p->x[i][0] = b->centre[0] + r * cos(angle);
	p->x[i][1] = b->centre[1] + r * sin(angle);
	p->v[i][0] = -omega * r * sin(angle);
	p->v[i][1] = omega * r * cos(angle);
}

static void place_body(const struct tsim *sim, struct bit *b)
{
	const struct ts_particles *p = sim->particles;
	double *x, *v;

	if (!b->index.tag[NCUTTERS])
		return;
	look_at_cutters(sim, b);
	if (b->index.body < 0)
		return;
	x = p->x[b->index.body];
	v = p->v[b->index.body];
	x[0] = b->centre[0];
	x[1] = b->centre[1];
	x[2] = mean_height(b) + b->clearance;
	v[0] = v[1] = 0;
	v[2] = mean_velocity(b);
}

static enum ts_status place_bit(struct ts_instance *self, struct tsim *sim)
{
	struct bit *b = self->state;
	double omega;

	TS_TRY(ts_number_now(sim, &b->omega, &self->where, &omega));
	for (int k = 0; k < NCUTTERS; k++)
		place_cutter(b, sim->particles, k, omega);
	place_body(sim, b);
	return TS_OK;
}

static enum ts_status initial_integrate(struct ts_instance *self, struct tsim *sim)
{
	struct bit *b = self->state;
	struct ts_particles *p = sim->particles;
	double dt = sim->clock.dt, omega;

	TS_TRY(ts_number_now(sim, &b->omega, &self->where, &omega));
	b->angle += omega * dt;
	for (int k = 0; k < NCUTTERS; k++) {
		int32_t i = b->index.cutter[k];

		if (i < 0)
			continue;
		p->v[i][2] += 0.5 * dt / p->mass[i] * p->f[i][2];
		p->x[i][2] += dt * p->v[i][2];
	}
	return place_bit(self, sim);
}

static enum ts_status final_integrate(struct ts_instance *self, struct tsim *sim)
{
	struct bit *b = self->state;
	struct ts_particles *p = sim->particles;

	for (int k = 0; k < NCUTTERS; k++) {
		int32_t i = b->index.cutter[k];

		if (i < 0)
			continue;
		p->v[i][2] += 0.5 * sim->clock.dt / p->mass[i] * p->f[i][2];
	}
	if (b->index.tag[NCUTTERS] || !sim->division)
		look_at_cutters(sim, b);
	if (b->index.body >= 0)
		p->v[b->index.body][2] = mean_velocity(b);
	return TS_OK;
}

/* A rebuild may change the indices of particles. The body particle is not moved by contacts. */
static enum ts_status exchange(struct ts_instance *self, struct tsim *sim)
{
	struct bit *b = self->state;

	TS_TRY(find_particles(self, sim));
	if (!sim->run.rebuild) /* start of a run: the cutters may be anywhere */
		TS_TRY(place_bit(self, sim));
	if (b->index.body >= 0)
		sim->particles->imass[b->index.body] = 0;
	return TS_OK;
}

/* Sums the contact forces on the cutters: tangential > 0 opposes the rotation, radial > 0 points outwards,
 * axial > 0 lifts the bit. */
static void sum_reactions(struct bit *b, double omega)
{
	double sense = omega < 0 ? -1 : 1;

	b->tangential = b->radial = b->axial = 0;
	for (int k = 0; k < NCUTTERS; k++) {
		const double *f = b->all.f[k];
		double angle = b->angle + k * (TS_PI / 2);
		double c = cos(angle), s = sin(angle);

		b->tangential -= sense * (-s * f[0] + c * f[1]);
		b->radial += c * f[0] + s * f[1];
		b->axial += f[2];
	}
	b->torque = 0.5 * b->diameter * b->tangential;
}

/* In the stage FORCE: contact and bond forces have been added, those of other fixes have not. */
static enum ts_status measure_contacts(struct ts_instance *self, struct tsim *sim)
{
	struct bit *b = self->state;
	double omega;

	TS_TRY(ts_number_now(sim, &b->omega, &self->where, &omega));
	look_at_cutters(sim, b);
	sum_reactions(b, omega);
	return TS_OK;
}

static enum ts_status post_force(struct ts_instance *self, struct tsim *sim)
{
	const struct bit *b = self->state;
	struct ts_particles *p = sim->particles;
	double mean = mean_height(b), mean_v = mean_velocity(b);

	for (int k = 0; k < NCUTTERS; k++) {
		int32_t i = b->index.cutter[k];

		if (i >= 0)
			p->f[i][2] -= b->wob / NCUTTERS + b->spring * (p->x[i][2] - mean) +
				      b->damping * (p->v[i][2] - mean_v);
	}
	return TS_OK;
}

static enum ts_status plan(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report)
{
	const struct bit *b = self->state;
	const struct ts_particles *p = sim->particles;
	double least = INFINITY, g;

	for (int k = 0; k < NCUTTERS; k++)
		if (b->index.cutter[k] >= 0) /* else it belongs to another rank */
			least = fmin(least, p->mass[b->index.cutter[k]]);
	if ((!(b->spring > 0) && !(b->damping > 0)) || isinf(least))
		return TS_OK;
	g = b->damping / (2 * least);
	return ts_report_limit(report, 2 / (sqrt(b->spring / least + g * g) + g), true, &self->where,
			       "the coupling spring of fix drill/bit");
}

/* For outputs after the step. */
static enum ts_status join(struct ts_instance *self, struct tsim *sim)
{
	look_at_cutters(sim, self->state);
	return TS_OK;
}

/* While all ranks look at the particles indices are those of their own ones, and `join` has looked at all. */
static void look_again(const struct tsim *sim, struct bit *b)
{
	if (!sim->run.looks)
		look_at_cutters(sim, b);
}

static enum ts_status eval_height(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	look_again(sim, self->state);
	out->data[0] = mean_height(self->state);
	return TS_OK;
}

static enum ts_status eval_vector(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	struct bit *b = self->state;
	double row[7] = { 0, 0, b->tangential, b->radial, b->axial, b->torque, b->angle };

	look_again(sim, b);
	row[0] = mean_height(b);
	row[1] = mean_velocity(b);
	memcpy(out->data, row, sizeof row);
	return TS_OK;
}

static const struct ts_arg args[] = {
	TS_REAL("x", struct bit, centre[0], .flags = TS_POSITIONAL | TS_STATEFUL, .unit = "length",
		.help = "x coordinate of the axis"),
	TS_REAL("y", struct bit, centre[1], .flags = TS_POSITIONAL | TS_STATEFUL, .unit = "length",
		.help = "y coordinate of the axis"),
	TS_REAL("diameter", struct bit, diameter, .flags = TS_STATEFUL, .range = TS_POSITIVE,
		.unit = "length", .help = "diameter of the circle of the cutters' centres"),
	TS_NUMBER("omega", struct bit, omega, .unit = "radian/time",
		  .help = "angular velocity; may be v_name"),
	TS_REAL("wob", struct bit, wob, .unit = "force",
		.help = "weight on bit; each cutter carries a quarter of it in -z"),
	TS_REAL("spring", struct bit, spring, .range = TS_NOT_NEGATIVE, .unit = "force/length",
		.help = "stiffness of the spring between each cutter and the mean height of the four"),
	TS_REAL("damping", struct bit, damping, .range = TS_NOT_NEGATIVE, .fallback = "0",
		.unit = "force/velocity", .help = "constant of the dashpot parallel to that spring"),
	TS_GROUP("body", struct bit, body_group, .flags = TS_OPTIONAL | TS_STATEFUL,
		 .help = "group of the one particle above the cutters"),
	TS_REAL("clearance", struct bit, clearance, .flags = TS_STATEFUL, .range = TS_NOT_NEGATIVE,
		.fallback = "0", .unit = "length",
		.help = "height of the body particle above the mean of the cutters"),
	TS_ARGS_END,
};

static const char *const names[] = {
	"height", "velocity", "tangential", "radial", "axial", "torque", "angle"
};
static const struct ts_value values[] = {
	{ "height", "length", "mean z of the cutters", TS_SCALAR, 1, NULL, eval_height },
	{ "state", "",
	  "height of the bit and its velocity, sums of the contact forces on the cutters (tangential > 0 "
	  "opposes the rotation, radial > 0 outwards, axial > 0 upwards), torque about the axis, angle "
	  "(radian)",
	  TS_VECTOR, 7, names, eval_vector },
	{ .name = NULL },
};

static const struct ts_saved saved[] = {
	TS_SAVE_F64(struct bit, angle), TS_SAVE_F64(struct bit, tangential), TS_SAVE_F64(struct bit, radial),
	TS_SAVE_F64(struct bit, axial), TS_SAVE_F64(struct bit, torque),     TS_SAVED_ROWS_END,
};

static enum ts_status post_build(struct ts_instance *self, struct tsim *sim)
{
	return find_particles(self, sim);
}

TS_STYLE(fix, ts_style, ts_fix_drill_bit)
const struct ts_style ts_fix_drill_bit = {
	.name = "drill/bit",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_OWN | TS_RANKS_OUTPUTS,
	.summary = "A drag bit: four rotating cutter particles under a weight on bit, and a body particle",
	.doc = "Models a drag bit. The group contains its four cutters. Their x and y are prescribed, 90 "
	       "degrees apart on a circle around the axis:\n\n"
	       "  x_k = x + D/2 cos(angle + k pi/2),  y_k = y + D/2 sin(angle + k pi/2),  k = 0 ... 3,\n\n"
	       "D being the diameter; the angle starts at 0 and grows with omega. Each cutter moves freely "
	       "in z under a quarter of the weight on bit, the contact forces, and a spring and dashpot to "
	       "the mean z of the four, which is the bit height. The `body` particle moves on the axis at "
	       "`clearance` above that height and keeps cuttings out of the space of the bit.\n\n"
	       "The fix integrates its particles itself by velocity Verlet: exclude them from fix nve, and "
	       "define this fix after those that act on the cutters. Outputs are f_ID, the bit height, and "
	       "f_ID[1..7]; forces are those of contacts with the rock, without weight and spring.",
	.example = "fix bit cutters drill/bit 5.0 5.0 diameter 5.0 omega 0.1 wob 0.2 spring 100 &\n"
		   "    body nose clearance 1.0",
	.args = args,
	.state_size = sizeof(struct bit),
	.saved = saved,
	.values = values,
	.init = init,
	.integrates = TS_MOVES,
	.hook = { [TS_STAGE_INITIAL_INTEGRATE] = initial_integrate,
		  [TS_STAGE_EXCHANGE] = exchange,
		  [TS_STAGE_POST_BUILD] = post_build,
		  [TS_STAGE_FORCE] = measure_contacts,
		  [TS_STAGE_POST_FORCE] = post_force,
		  [TS_STAGE_FINAL_INTEGRATE] = final_integrate },
	.plan = plan,
	.join = join,
};
