/* Fix wear/formula: the volume that an impact removes is a formula of the script. */
#include "core/script_api.h"
#include "math/constants.h"
#include "wear/wear_material.h"

#include "base/banned.h"

enum quantity {
	SPEED,
	ANGLE,
	NORMAL,
	TANGENTIAL,
	MASS,
	DIAMETER,
	HARDNESS,
	FORCE,
	OVERLAP,
	DURATION,
	SLIP,
	QUANTITIES
};
static const char *const quantity_names[] = { "speed",	 "angle",    "normal",	 "tangential",
					      "mass",	 "diameter", "hardness", "force",
					      "overlap", "duration", "slip",	 NULL };

struct setting {
	int quantity;
	const char *name;
};

struct state {
	struct ts_wear wear;
	struct ts_number volume;
	struct ts_words set;
	double hardness;

	double found_hardness;
	struct tsim *sim;		  /* during a step */
	enum ts_status status;		  /* of the evaluations in this step */
	const char *variable[QUANTITIES]; /* internal-style variables that receive them; NULL: none */
};

static double quantity_of(const struct state *s, const struct ts_impact_event *e, enum quantity q)
{
	switch (q) {
	case SPEED:
		return ts_impact_speed(e);
	case ANGLE:
		return ts_impact_angle(e) * 180 / TS_PI;
	case NORMAL:
		return ts_impact_normal_speed(e);
	case TANGENTIAL:
		return ts_impact_tangential_speed(e);
	case MASS:
		return e->mass;
	case DIAMETER:
		return 2 * e->radius;
	case HARDNESS:
		return s->found_hardness;
	case FORCE:
		return e->peak_force;
	case OVERLAP:
		return e->peak_overlap;
	case DURATION:
		return e->duration;
	default:
		return e->slip;
	}
}

static enum ts_status evaluate(const struct ts_instance *self, const struct ts_impact_event *e, double *out)
{
	const struct state *s = self->state;
	struct tsim *sim = s->sim;

	for (int q = 0; q < QUANTITIES; q++)
		if (s->variable[q])
			TS_TRY(sim->script_api->set(sim->script_api_data, s->variable[q], &self->where,
						    quantity_of(s, e, (enum quantity)q)));
	TS_TRY(ts_number_now(sim, &s->volume, &self->where, out));
	if (isfinite(*out) && *out >= 0)
		return TS_OK;
	return ts_fail(&sim->error, TS_RANGE, &self->where,
		       "fix wear/formula: the volume is %g for an impact of particle %.0f at the speed %g "
		       "and %g degrees, expected a finite number that is not negative",
		       *out, e->tag, ts_impact_speed(e), ts_impact_angle(e) * 180 / TS_PI);
}

static double remove_by_impact(const struct ts_instance *self, const struct ts_impact_event *e)
{
	struct state *s = self->state;
	double volume = 0;

	if (s->status == TS_OK)
		s->status = evaluate(self, e, &volume);
	return s->status == TS_OK ? volume : 0;
}

static const struct ts_wear_law law = { .impact = remove_by_impact };

static enum ts_status step(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	s->sim = sim;
	s->status = TS_OK;
	TS_TRY(ts_wear_step(self, sim));
	return s->status;
}

static const struct ts_arg setting_rows[] = {
	TS_ENUM("quantity", struct setting, quantity, quantity_names, .flags = TS_POSITIONAL,
		.help = "of the impact"),
	TS_WORD("name", struct setting, name, .flags = TS_POSITIONAL,
		.help = "internal-style variable that gets it"),
	TS_ARGS_END,
};

/* A variable that takes the number which it has already is of style internal. */
static enum ts_status require_internal(struct tsim *sim, const struct ts_word *name)
{
	const struct ts_script_api *api = sim->script_api;
	double number;

	TS_TRY(api->scalar(sim->script_api_data, name->text, &name->place, &number));
	return api->set(sim->script_api_data, name->text, &name->place, number);
}

static enum ts_status read_settings(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	for (int q = 0; q < QUANTITIES; q++)
		s->variable[q] = NULL;
	for (size_t k = 0; k < s->set.n; k += 2) {
		struct ts_words pair = ts_words_from(s->set, k);
		struct setting one = { 0 };

		if (pair.n > 2)
			pair.n = 2;
		TS_TRY(ts_args_parse(sim, "fix wear/formula: set", setting_rows, pair, &self->where,
				     &self->arena, &one));
		if (s->variable[one.quantity])
			return ts_fail(&sim->error, TS_SYNTAX, &pair.word[0].place,
				       "fix wear/formula: set %s %s: variable '%s' gets this quantity "
				       "already; name that one in the formula",
				       quantity_names[one.quantity], one.name, s->variable[one.quantity]);
		TS_TRY(require_internal(sim, &pair.word[1]));
		s->variable[one.quantity] = one.name;
	}
	return TS_OK;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	TS_TRY(ts_wear_init(self, sim, &law));
	TS_TRY(read_settings(self, sim));
	if (s->variable[HARDNESS])
		return ts_wear_hardness(self, sim, s->hardness, &s->found_hardness);
	return TS_OK;
}

static const struct ts_arg args[] = {
	TS_WEAR_ARGS(struct state, wear),
	TS_NUMBER("volume", struct state, volume, .unit = "length^3",
		  .help = "that an impact removes: v_NAME of an equal-style variable, or a number"),
	TS_SOME_KEYWORD("set", struct state, set, TS_REPEAT,
			.help = "QUANTITY NAME: internal-style variable that is set to a quantity of the "
				"impact before the volume is evaluated; may be repeated, each quantity once"),
	TS_WEAR_HARDNESS_ARG(struct state, hardness),
	TS_ARGS_END,
};

TS_STYLE(fix, ts_style, ts_fix_wear_formula)
const struct ts_style ts_fix_wear_formula = {
	.name = "wear/formula",
	.kind = TS_KIND_FIX,
	.summary = "wear of a surface by a formula of the impact",
	.doc = "The variable of `volume` is evaluated once for each impact, after the internal-style "
	       "variables of `set` have been set to its quantities:\n\n"
	       "    speed      V, velocity\n"
	       "    angle      between velocity and surface, degrees; 90 is a normal impact\n"
	       "    normal     V sin(angle), velocity\n"
	       "    tangential V cos(angle), velocity\n"
	       "    mass       of the particle\n"
	       "    diameter   of the particle, length\n"
	       "    hardness   of the surface, pressure\n"
	       "    force      largest normal force of the contact\n"
	       "    overlap    largest overlap, length\n"
	       "    duration   of the contact, time\n"
	       "    slip       path of the contact point along the surface, length\n\n"
	       "The run ends with an error if a volume is negative or not a number." TS_WEAR_DOC
	       "Related: fix wear/oka, fix wear/bitter, fix wear/zhao/chang, fix wear/archard.",
	.example =
		"variable v internal 0\n"
		"variable a internal 0\n"
		"variable m internal 0\n"
		"variable lost equal 1e-14*v_m*v_v^2.4*sin(v_a*PI/180)\n"
		"fix target all wall/gran model hertz primitive type 2 zplane 0\n"
		"fix scar all wear/formula surface target volume v_lost set speed v set angle a set mass m",
	.args = args,
	.state_size = sizeof(struct state),
	TS_WEAR_SLOTS,
	.observes = TS_OBSERVES_IMPACTS,
	.init = init,
	.late = { [TS_LATE_CONTACTS] = step },
	.fini = ts_wear_fini,
};
