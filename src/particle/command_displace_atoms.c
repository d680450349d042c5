/* Command displace_atoms: displaces particles. */
#include "base/axes.h"
#include "core/sim.h"

#include <math.h>

#include "box/domain.h"
#include "core/number_or_peratom.h"
#include "math/ramp.h"
#include "math/rng.h"
#include "math/vec3.h"
#include "particle/exchange.h"
#include "particle/orientation.h"
#include "particle/particles.h"
#include "region/region.h"

#include "base/banned.h"

enum { MOVE, RAMP, RANDOM, ROTATE };

struct state {
	int group, mode, units;
	struct ts_number shift[3];
	int component, dim; /* of ramp */
	double d[2], at[2]; /* of ramp: displacements and coordinates of both ends */
	double most[3];	    /* of random: largest displacement */
	int64_t seed;
	double point[3], axis[3], angle; /* of rotate; degrees */
};

static enum ts_status displace_by_vector(struct tsim *sim, const struct state *s,
					 const struct ts_place *where)
{
	struct ts_particles *p = sim->particles;
	struct ts_number_or_peratom shift[3] = { { 0 } };
	enum ts_status status = TS_OK;

	for (int d = 0; d < 3 && status == TS_OK; d++)
		status = ts_number_or_peratom_now(sim, &s->shift[d], where, &shift[d]);
	for (size_t i = 0; i < p->n && status == TS_OK; i++)
		for (int d = 0; ts_in_group(p, i, s->group) && d < 3; d++)
			p->x[i][d] +=
				ts_domain_scale(sim, s->units, d) * ts_number_or_peratom_of(&shift[d], i);
	for (int d = 0; d < 3; d++)
		ts_number_or_peratom_release(&shift[d]);
	return status;
}

static enum ts_status displace_by_ramp(struct tsim *sim, const struct state *s, const struct ts_place *where)
{
	struct ts_particles *p = sim->particles;
	double scale = ts_domain_scale(sim, s->units, s->component);
	double along = ts_domain_scale(sim, s->units, s->dim);

	if (s->at[0] == s->at[1])
		return ts_fail(&sim->error, TS_RANGE, where, "displace_atoms ramp: both ends lie at %g",
			       s->at[0]);
	for (size_t i = 0; i < p->n; i++)
		if (ts_in_group(p, i, s->group))
			p->x[i][s->component] += scale * ts_ramp(p->x[i][s->dim] / along, s->at, s->d);
	return TS_OK;
}

/* Random numbers are functions of seed and tag, so they do not depend on the order in memory. */
static void displace_randomly(struct tsim *sim, const struct state *s)
{
	struct ts_particles *p = sim->particles;

	for (size_t i = 0; i < p->n; i++) {
		struct ts_rng rng = ts_rng_start((uint64_t)s->seed, (uint64_t)p->tag[i]);

		for (int d = 0; ts_in_group(p, i, s->group) && d < 3; d++)
			p->x[i][d] += ts_domain_scale(sim, s->units, d) * s->most[d] *
				      (2 * ts_rng_uniform(&rng) - 1);
	}
}

/* Rotation by the angle t about the axis e through P: x -> P + C + A cos t + B sin t, where x - P = C + A
 * with C along e and A perpendicular to it, B = e x A. */
static enum ts_status rotate_positions(struct tsim *sim, const struct state *s, const struct ts_place *where)
{
	struct ts_particles *p = sim->particles;
	double axis[3], a[3], b[3], point[3], angle = s->angle * acos(-1.0) / 180;

	if (!(ts_norm(s->axis) > 0))
		return ts_fail(&sim->error, TS_RANGE, where,
			       "displace_atoms rotate: the axis is zero, expected a direction");
	if (sim->dimension == 2 && (s->axis[0] != 0 || s->axis[1] != 0))
		return ts_fail(&sim->error, TS_RANGE, where,
			       "displace_atoms rotate: in two dimensions the axis is along z");
	ts_scale(1 / ts_norm(s->axis), s->axis, axis);
	for (int d = 0; d < 3; d++)
		point[d] = ts_domain_scale(sim, s->units, d) * s->point[d];
	for (size_t i = 0; i < p->n; i++) {
		double along;

		if (!ts_in_group(p, i, s->group))
			continue;
		ts_sub(p->x[i], point, a);
		along = ts_dot(a, axis);
		ts_axpy(-along, axis, a);
		ts_cross(axis, a, b);
		for (int d = 0; d < 3; d++)
			p->x[i][d] = point[d] + along * axis[d] + cos(angle) * a[d] + sin(angle) * b[d];
		ts_orientation_turn(sim, i, axis, angle);
	}
	return TS_OK;
}

static enum ts_status displace(struct tsim *sim, const struct state *s, const struct ts_place *where)
{
	switch (s->mode) {
	case MOVE:
		return displace_by_vector(sim, s, where);
	case RAMP:
		return displace_by_ramp(sim, s, where);
	case ROTATE:
		return rotate_positions(sim, s, where);
	default:
		displace_randomly(sim, s);
		return TS_OK;
	}
}

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct state *s = state;

	ts_log(&sim->log, "Displacing atoms ...\n");
	ts_domain_units_said(sim, s->units, where);
	TS_TRY(displace(sim, s, where));
	TS_TRY(sim->particles->bodies_follow(sim, true, "displace_atoms", where));
	return ts_exchange_migrate(sim);
}

#define SHIFT(name, k)                                                                    \
	TS_NUMBER(name, struct state, shift[k], .flags = TS_POSITIONAL, .unit = "length", \
		  .help = "displacement, or v_NAME; an atom-style variable gives each particle its own")
static const struct ts_arg move_args[] = {
	SHIFT("dx", 0),
	SHIFT("dy", 1),
	SHIFT("dz", 2),
	TS_ARGS_END,
};

static const struct ts_arg ramp_args[] = {
	TS_ENUM("ddim", struct state, component, ts_axis_names, .flags = TS_POSITIONAL,
		.help = "direction of the displacement"),
	TS_REAL("dlo", struct state, d[0], .flags = TS_POSITIONAL, .unit = "length",
		.help = "displacement at clo and below"),
	TS_REAL("dhi", struct state, d[1], .flags = TS_POSITIONAL, .unit = "length",
		.help = "displacement at chi and above"),
	TS_ENUM("dim", struct state, dim, ts_axis_names, .flags = TS_POSITIONAL,
		.help = "coordinate on which the displacement depends"),
	TS_REAL("clo", struct state, at[0], .flags = TS_POSITIONAL, .unit = "length",
		.help = "lower coordinate"),
	TS_REAL("chi", struct state, at[1], .flags = TS_POSITIONAL, .unit = "length",
		.help = "upper coordinate"),
	TS_ARGS_END,
};

static const struct ts_arg random_args[] = {
	TS_VEC3("most", struct state, most, .flags = TS_POSITIONAL, .range = TS_NOT_NEGATIVE,
		.unit = "length", .help = "largest displacement in x, y and z, in both directions"),
	TS_INT("seed", struct state, seed, .flags = TS_POSITIONAL, .range = TS_POSITIVE,
	       .help = "seed of the random numbers"),
	TS_ARGS_END,
};

static const struct ts_arg rotate_args[] = {
	TS_VEC3("P", struct state, point, .flags = TS_POSITIONAL, .unit = "length",
		.help = "a point on the axis"),
	TS_VEC3("R", struct state, axis, .flags = TS_POSITIONAL, .help = "direction of the axis"),
	TS_REAL("theta", struct state, angle, .flags = TS_POSITIONAL, .unit = "degrees",
		.help = "angle of rotation, right-handed about the axis"),
	TS_ARGS_END,
};

static const struct ts_mode modes[] = {
	[MOVE] = { "move", "by a constant vector, or one from variables", move_args },
	[RAMP] = { "ramp", "by a displacement that varies linearly along a coordinate", ramp_args },
	[RANDOM] = { "random", "by random displacements within +-most", random_args },
	[ROTATE] = { "rotate", "about an axis", rotate_args },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_GROUP("group", struct state, group, .flags = TS_POSITIONAL,
		 .help = "particles that are displaced"),
	TS_MODE("style", struct state, mode, modes, .help = "kind of displacement"),
	TS_ENUM("units", struct state, units, ts_region_units, .flags = TS_OPTIONAL,
		.help = "whether lengths are in lattice spacings or in units of length"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_displace_atoms)
const struct ts_command_style ts_command_displace_atoms = {
	.style = {
		.name = "displace_atoms",
		.kind = TS_KIND_COMMAND,
		.summary = "Displaces particles",
		.doc = "Displaces the particles of the group once. Velocities do not change.\n\n"
		       "ramp interpolates the displacement linearly between clo and chi; it is constant\n"
		       "outside of them. random draws each component uniformly from -most to +most; the\n"
		       "numbers are functions of seed and atom ID. rotate rotates the positions in the\n"
		       "box, not the unwrapped ones, and the orientations of particles that have one\n"
		       "(bond_style parallel).\n\n"
		       "Afterwards positions are wrapped into the periodic box, particles outside of\n"
		       "fixed faces are lost (see thermo_modify lost), and faces with boundary s and m\n"
		       "are fitted to the particles.",
		.example = "displace_atoms top move 0 0 0.05 units box\n"
		       "displace_atoms all ramp x 0 0.01 z 0 0.2 units box\n"
		       "displace_atoms all random 0.001 0.001 0 86028157 units box\n"
		       "displace_atoms arm rotate 0 0 0 0 0 1 30 units box",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.needs_box = true,
	.run = run,
};
