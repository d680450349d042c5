/* Fixes wear/zhao/chang and wear/zhao/chang/contact: the groove and the crater of an indenting particle. */
#include "law/erosion_bitter.h"
#include "law/erosion_zhao_chang.h"
#include "wear/wear_material.h"

#include "base/banned.h"

static const char *const forces[] = { "hertz", "plastic", NULL };
static const char *const sections[] = { "limit", "segment", NULL };

struct state {
	struct ts_wear wear;
	double hardness, crater, yield, factor;
	int force, section;
	struct ts_wear_moduli moduli;

	double found_hardness;
};

static struct ts_erosion_zhao_chang law_of(const struct state *s, double type)
{
	return (struct ts_erosion_zhao_chang){ .modulus = s->moduli.of[(int)type],
					       .hardness = s->found_hardness,
					       .crater = s->crater,
					       .plastic = s->force == 1,
					       .segment = s->section == 1 };
}

/* `y` is the largest pressure of the elastic contact at yield; the density is that of a sphere. */
static void set_yield_speed(const struct state *s, const struct ts_impact_event *e,
			    struct ts_erosion_zhao_chang *one)
{
	double volume = 4.0 / 3.0 * TS_PI * e->radius * e->radius * e->radius;

	if (s->yield > 0)
		one->yield_speed = ts_erosion_yield_speed(s->yield, e->mass / volume, one->modulus);
}

static double remove_by_impact(const struct ts_instance *self, const struct ts_impact_event *e)
{
	const struct state *s = self->state;
	struct ts_erosion_zhao_chang one = law_of(s, e->type);
	struct ts_erosion_impact i = ts_wear_erosion_impact(e);

	set_yield_speed(s, e, &one);
	return s->factor * ts_erosion_zhao_chang_volume(&one, &i);
}

static double remove_crater(const struct ts_instance *self, const struct ts_impact_event *e)
{
	const struct state *s = self->state;
	struct ts_erosion_zhao_chang one = law_of(s, e->type);
	struct ts_erosion_impact i = ts_wear_erosion_impact(e);

	set_yield_speed(s, e, &one);
	return s->factor * ts_zhao_crater_volume(&one, &i);
}

static double remove_by_slide(const struct ts_instance *self, const struct ts_wear_slide *c)
{
	const struct state *s = self->state;
	struct ts_erosion_zhao_chang one = law_of(s, c->type);

	return s->factor * ts_zhao_slide_volume(&one, 2 * c->radius, c->normal_force, c->slip);
}

static const struct ts_wear_law of_impacts = { .impact = remove_by_impact };
static const struct ts_wear_law of_contacts = { .impact = remove_crater, .slide = remove_by_slide };

static enum ts_status find_materials(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	TS_TRY(ts_wear_hardness(self, sim, s->hardness, &s->found_hardness));
	return ts_wear_moduli_find(self, sim, &s->moduli);
}

static enum ts_status init_impacts(struct ts_instance *self, struct tsim *sim)
{
	TS_TRY(ts_wear_init(self, sim, &of_impacts));
	return find_materials(self, sim);
}

static enum ts_status init_contacts(struct ts_instance *self, struct tsim *sim)
{
	TS_TRY(ts_wear_init(self, sim, &of_contacts));
	return find_materials(self, sim);
}

static void fini(struct ts_instance *self)
{
	ts_wear_moduli_release(&((struct state *)self->state)->moduli);
	ts_wear_fini(self);
}

#define MATERIAL_ARGS                                                                                    \
	TS_WEAR_ARGS(struct state, wear), TS_WEAR_HARDNESS_ARG(struct state, hardness),                  \
		TS_WEAR_MODULUS_ARG(struct state, moduli.given),                                         \
		TS_REAL("crater", struct state, crater, .fallback = "0.02", .range = TS_FRACTION,        \
			.unit = "", .help = "fraction c of the crater's volume that is removed"),        \
		TS_REAL("yield", struct state, yield, .fallback = "0", .range = TS_NOT_NEGATIVE,         \
			.unit = "pressure",                                                              \
			.help = "largest pressure of the elastic contact at yield, 1.6 times the yield " \
				"stress of a metal: slower impacts leave no crater"),                    \
		TS_ENUM("section", struct state, section, sections, .fallback = "limit",                 \
			.help = "of the groove: limit of shallow grooves, or circular segment")

static const struct ts_arg impact_args[] = {
	MATERIAL_ARGS,
	TS_ENUM("force", struct state, force, forces, .fallback = "hertz",
		.help = "during an impact: that of the elastic contact, or pi d H delta until the particle "
			"stops"),
	TS_WEAR_FACTOR_ARG(struct state, factor),
	TS_ARGS_END,
};
static const struct ts_arg contact_args[] = {
	MATERIAL_ARGS,
	TS_WEAR_FACTOR_ARG(struct state, factor),
	TS_ARGS_END,
};

#define LAW_DOC                                                                                            \
	"A particle of the diameter d that is pressed by the force F into a surface of the hardness H "    \
	"indents it by delta, the larger of the elastic and the plastic indentation,\n\n"                  \
	"    (3 F/(4 E* sqrt(d/2)))^(2/3)  and  F/(pi d H)\n\n"                                            \
	"and ploughs a groove of the section A = (4/3) sqrt(d) delta^(3/2) (`section limit`) or of the "   \
	"circular segment of the depth delta. The volume removed is A times the path of sliding. An "      \
	"impact at the normal speed n also removes the fraction c of the volume of the plastic crater, c " \
	"m (n^2 - K^2)/(2 H); K is the speed at which the largest elastic pressure is `yield`, 0 by "      \
	"default. Without this term no material is removed at 90 degrees. The default c = 0.02 gives at "  \
	"90 degrees about the volume that fix wear/oka gives for silica on steel; c is to be fitted to "   \
	"measured volumes.\n\n"

TS_STYLE(fix, ts_style, ts_fix_wear_zhao_chang)
const struct ts_style ts_fix_wear_zhao_chang = {
	.name = "wear/zhao/chang",
	.kind = TS_KIND_FIX,
	.summary = "wear of a surface by the groove and the crater of each impact (Zhao, Chang)",
	.doc = LAW_DOC
	"The section is integrated over the duration of each impact with the tangential speed t at its "
	"begin. `force hertz`: with the force of an elastic impact, the elastic groove being 2 sqrt(2) m n "
	"t/E*; the volumes are those of fix wear/zhao/chang/contact with model hertz without damping and "
	"friction. On metals at 100 m/s they are about twice those of `force plastic`, as the surface does "
	"not bear the elastic force. `force plastic`: with the force pi d H delta, until the particle stops; "
	"the groove grows as n^1.5 t." TS_WEAR_DOC
	"Related: fix wear/oka, fix wear/archard, fix wear/finnie.",
	.example = "fix target all wall/gran model hertz primitive type 2 zplane 0\n"
		   "fix scar all wear/zhao/chang surface target hardness 1.1e9 modulus 5.3e10 crater 0.05",
	.cite = "Y. Zhao, L. Chang, Wear 252 (2002) 220; K. L. Johnson, Contact Mechanics, 1985, 11.4",
	.args = impact_args,
	.state_size = sizeof(struct state),
	TS_WEAR_SLOTS,
	.observes = TS_OBSERVES_IMPACTS,
	.init = init_impacts,
	.late = { [TS_LATE_CONTACTS] = ts_wear_step },
	.fini = fini,
};

TS_STYLE(fix, ts_style, ts_fix_wear_zhao_chang_contact)
const struct ts_style ts_fix_wear_zhao_chang_contact = {
	.name = "wear/zhao/chang/contact",
	.kind = TS_KIND_FIX,
	.summary = "wear of a surface by the groove of each contact, step by step (Zhao, Chang)",
	.doc = LAW_DOC "The groove is summed in each step over the contacts, with their normal force and the "
		       "path of the contact point in the step: also for particles that slide or roll on the "
		       "surface. The crater belongs to the impact. " TS_WEAR_EXACT TS_WEAR_DOC
		       "Related: fix wear/oka, fix wear/archard, fix wear/finnie.",
	.example =
		"fix pad all wall/gran model hertz primitive type 2 zplane 0\n"
		"fix polish all wear/zhao/chang/contact surface pad hardness 1.1e9 modulus 5.3e10 crater 0",
	.cite = "Y. Zhao, L. Chang, Wear 252 (2002) 220; K. L. Johnson, Contact Mechanics, 1985, 11.4",
	.args = contact_args,
	.state_size = sizeof(struct state),
	TS_WEAR_SLOTS,
	.observes = TS_OBSERVES_IMPACTS | TS_OBSERVES_CONTACTS | TS_OBSERVES_BRIEF,
	.init = init_contacts,
	.late = { [TS_LATE_CONTACTS] = ts_wear_step },
	.fini = fini,
};
