/* Command set: gives particles properties. */
#include "core/sim.h"

#include <math.h>

#include "particles/body.h"
#include "particles/particles.h"
#include "particles/region.h"

#include "base/banned.h"

enum { ATOM, TYPE, GROUP, REGION };

/* What can be set, in the order in which it is applied. */
enum { TO_TYPE, DIAMETER, DENSITY, MASS, X, Y, Z, VX, VY, VZ, OMEGAX, OMEGAY, OMEGAZ, NPROPERTIES };

struct state {
	int mode, group;
	struct ts_types range;
	struct ts_instance *region;
	struct ts_number value[NPROPERTIES];
};

static const char *const names[NPROPERTIES] = { "type",	  "diameter", "density", "mass", "x",
						"y",	  "z",	      "vx",	 "vy",	 "vz",
						"omegax", "omegay",   "omegaz" };

static bool selected(const struct tsim *sim, const struct state *s, size_t i)
{
	const struct ts_particles *p = sim->particles;
	int32_t number = s->mode == ATOM ? p->tag[i] : p->type[i];

	if (s->mode == GROUP)
		return ts_in_group(p, i, s->group);
	if (s->mode == REGION)
		return ts_region_contains(s->region, p->x[i]);
	return number >= s->range.lo && (number <= s->range.hi || s->range.hi == 0);
}

static const char *problem(const struct ts_particles *p, int what, double value)
{
	if (!isfinite(value))
		return "a finite number";
	if ((what == DIAMETER || what == DENSITY || what == MASS) && !(value > 0))
		return "a number > 0";
	if (what == TO_TYPE && !(value >= 1 && value <= p->ntypes && value == floor(value)))
		return "a type, 1 or more and at most what create_box says";
	return NULL;
}

static void apply(struct tsim *sim, size_t i, int what, double value)
{
	struct ts_particles *p = sim->particles;
	double density = p->mass[i] / ts_body_volume(sim, p->radius[i]);

	switch (what) {
	case TO_TYPE:
		p->type[i] = (int32_t)value;
		break;
	case DIAMETER: /* at constant density */
		p->radius[i] = 0.5 * value;
		p->mass[i] = density * ts_body_volume(sim, p->radius[i]);
		break;
	case DENSITY:
		p->mass[i] = value * ts_body_volume(sim, p->radius[i]);
		break;
	case MASS:
		p->mass[i] = value;
		break;
	case X:
	case Y:
	case Z:
		p->x[i][what - X] = value;
		break;
	case VX:
	case VY:
	case VZ:
		p->v[i][what - VX] = value;
		break;
	default:
		p->omega[i][what - OMEGAX] = value;
		break;
	}
}

/* The value for each particle; constants need no table. */
static enum ts_status evaluate(struct tsim *sim, const struct ts_number *number,
			       const struct ts_place *where, struct ts_table *table,
			       double *constant)
{
	const struct ts_host *host = sim->host;

	table->rows = 0;
	if (number->variable && host->is_peratom(sim->host_data, number->variable))
		return host->peratom(sim->host_data, number->variable, where, table);
	return ts_number_now(sim, number, where, constant);
}

static enum ts_status set_one(struct tsim *sim, const struct state *s, const unsigned char *chosen,
			      int what, const struct ts_place *where, struct ts_table *table)
{
	struct ts_particles *p = sim->particles;
	double constant = 0;

	TS_TRY(evaluate(sim, &s->value[what], where, table, &constant));
	for (size_t i = 0; i < p->n; i++) {
		double value = table->rows ? table->data[i] : constant;
		const char *expected;

		if (!chosen[i])
			continue;
		expected = problem(p, what, value);
		if (expected)
			return ts_fail(&sim->error, TS_RANGE, where,
				       "set: %s of particle %d would be %g, expected %s",
				       names[what], p->tag[i], value, expected);
		apply(sim, i, what, value);
	}
	return TS_OK;
}

static enum ts_status set_all(struct tsim *sim, const struct state *s, const unsigned char *chosen,
			      size_t count, const struct ts_place *where)
{
	struct ts_table table = { 0 };
	enum ts_status status = TS_OK;

	for (int what = 0; what < NPROPERTIES && status == TS_OK; what++) {
		if (s->value[what].null)
			continue;
		status = set_one(sim, s, chosen, what, where, &table);
		if (status == TS_OK)
			ts_log(&sim->log, "  %zu settings made for %s\n", count, names[what]);
	}
	ts_table_release(&table);
	return status;
}

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct state *s = state;
	struct ts_particles *p = sim->particles;
	unsigned char *chosen;
	enum ts_status status = TS_OK;
	size_t count = 0;

	for (int what = OMEGAX; what <= OMEGAZ; what++)
		if (!s->value[what].null)
			TS_TRY(ts_particles_need(sim, TS_NEED(OMEGA)));
	chosen = ts_alloc(p->n, 1);
	if (!chosen)
		return ts_nomem(&sim->error);
	for (size_t i = 0; i < p->n; i++)
		count += chosen[i] = selected(sim, s, i);
	status = set_all(sim, s, chosen, count, where);
	ts_free(chosen);
	ts_particles_inverse_mass(p);
	return status;
}

static const struct ts_arg by_id[] = {
	TS_TYPES("ids", struct state, range, .flags = TS_POSITIONAL,
		 .help = "identities: n, *, n*, *m or n*m"),
	TS_ARGS_END,
};

static const struct ts_arg by_type[] = {
	TS_TYPES("types", struct state, range, .flags = TS_POSITIONAL,
		 .help = "types: n, *, n*, *m or n*m"),
	TS_ARGS_END,
};

static const struct ts_arg by_group[] = {
	TS_GROUP("group", struct state, group, .flags = TS_POSITIONAL, .help = "a group"),
	TS_ARGS_END,
};

static const struct ts_arg by_region[] = {
	TS_REGION("region", struct state, region, .flags = TS_POSITIONAL, .help = "a region"),
	TS_ARGS_END,
};

static const struct ts_mode modes[] = {
	[ATOM] = { "atom", "particles with these identities", by_id },
	[TYPE] = { "type", "particles of these types", by_type },
	[GROUP] = { "group", "particles of a group", by_group },
	[REGION] = { "region", "particles whose centers lie in a region", by_region },
	{ .name = NULL },
};

#define VALUE(name, what, unit_, help_)                                                            \
	TS_NUMBER(name, struct state, value[what], .flags = TS_OPTIONAL, .unit = unit_,            \
		  .help = help_)

static const struct ts_arg args[] = {
	TS_MODE("style", struct state, mode, modes, .help = "how particles are chosen"),
	VALUE("type", TO_TYPE, "", "type"),
	VALUE("diameter", DIAMETER, "length", "diameter; the density stays"),
	VALUE("density", DENSITY, "mass/volume", "density; the diameter stays"),
	VALUE("mass", MASS, "mass", "mass; the diameter stays"),
	VALUE("x", X, "length", "x of the center"),
	VALUE("y", Y, "length", "y of the center"),
	VALUE("z", Z, "length", "z of the center"),
	VALUE("vx", VX, "velocity", "x component of the velocity"),
	VALUE("vy", VY, "velocity", "y component of the velocity"),
	VALUE("vz", VZ, "velocity", "z component of the velocity"),
	VALUE("omegax", OMEGAX, "1/time", "x component of the angular velocity"),
	VALUE("omegay", OMEGAY, "1/time", "y component of the angular velocity"),
	VALUE("omegaz", OMEGAZ, "1/time", "z component of the angular velocity"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_set)
const struct ts_command_style ts_command_set = {
	.style = {
		.name = "set",
		.kind = TS_KIND_COMMAND,
		.summary = "Gives particles properties",
		.doc = "Numbers may be v_name; an atom-style variable gives each particle a value of its own.\n"
		       "Whatever the order of the keywords, they are applied as: type, diameter, density,\n"
		       "mass, position, velocity.",
		.example = "set group all diameter 0.005 density 2500\n"
			   "set type 2 vz -1\n"
			   "set atom 1*10 diameter v_size",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.needs_box = true,
	.run = run,
};
