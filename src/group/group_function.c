/* Functions of formulas that sum over a group, or over its particles in a region. As in LAMMPS, positions are
 * unwrapped, and particles are points; clumps are bodies: rigid/rigid_share.h. */
#include "group/group_function.h"

#include <math.h>

#include "base/axes.h"
#include "group/group_dynamic.h"
#include "group/kinetic_energy.h"
#include "material/property.h"
#include "math/exactsum.h"
#include "math/vec3.h"
#include "particle/group_moments.h"
#include "region/region.h"
#include "rigid/mass_moments.h"

#include "base/banned.h"

/* The particles that a function sums over, their mass and centre of mass. */
struct selection {
	struct tsim *sim;
	const struct ts_particles *p;
	const struct ts_instance *region; /* NULL: everywhere */
	int group;
	double mass, centre[3];
};

typedef double term_fn(const struct selection *c, size_t i, int a, int b);

static bool is_selected(const struct selection *c, size_t i)
{
	return ts_in_group(c->p, i, c->group) && (!c->region || ts_region_contains(c->region, c->p->x[i]));
}

/* Sum of a term; exact and rounded once, so it does not depend on the order of particles. a, b:
 * components. */
static double sum_terms(const struct selection *c, term_fn *term, int a, int b)
{
	struct ts_exactsum sum = { 0 };

	for (size_t i = 0; i < c->p->n; i++)
		if (is_selected(c, i))
			ts_exactsum_add(&sum, term(c, i, a, b));
	return ts_exactsum_value(&sum);
}

static enum ts_status read_region(struct selection *c, const struct ts_word *name)
{
	struct ts_instance *region = NULL;

	TS_TRY(ts_sim_require(c->sim, TS_KIND_REGION, name, &region));
	TS_TRY(ts_region_update(region, c->sim));
	c->region = region;
	return TS_OK;
}

/* Reads the group, the first argument, and the region, argument number `most`, if it is given. */
static enum ts_status read_group(struct tsim *sim, struct ts_words args, size_t most, struct selection *c)
{
	*c = (struct selection){ .sim = sim, .p = sim->particles };
	TS_TRY(ts_group_require(sim, &args.word[0], &c->group));
	return args.n == most ? read_region(c, &args.word[most - 1]) : TS_OK;
}

static double count_term(const struct selection *c, size_t i, int a, int b)
{
	(void)c, (void)i, (void)a, (void)b;
	return 1;
}

static double mass_term(const struct selection *c, size_t i, int a, int b)
{
	(void)a, (void)b;
	return c->p->mass[i];
}

static double mass_position_term(const struct selection *c, size_t i, int a, int b)
{
	double term[4];

	(void)b;
	ts_mass_moment(c->sim, i, term);
	return term[a];
}

static double momentum_term(const struct selection *c, size_t i, int a, int b)
{
	double term[4];

	(void)b;
	ts_mass_momentum(c->sim, i, term);
	return term[a];
}

static double kinetic_energy_term(const struct selection *c, size_t i, int a, int b)
{
	(void)a, (void)b;
	return ts_kinetic_energy(c->sim, i);
}

static double force_term(const struct selection *c, size_t i, int a, int b)
{
	(void)b;
	return c->p->f[i][a];
}

static double mass_r2_term(const struct selection *c, size_t i, int a, int b)
{
	double term[6];

	(void)a, (void)b;
	ts_mass_second_moment(c->sim, i, c->centre, term);
	return term[0] + term[1] + term[2];
}

static double inertia_term(const struct selection *c, size_t i, int a, int b)
{
	double term[6];

	ts_mass_inertia(c->sim, i, c->centre, term);
	return term[a == b ? a : a + b + 2];
}

static double angular_momentum_term(const struct selection *c, size_t i, int a, int b)
{
	double term[3];

	(void)b;
	ts_mass_angular_momentum(c->sim, i, c->centre, term);
	return term[a];
}

static double torque_term(const struct selection *c, size_t i, int a, int b)
{
	double d[3];

	(void)b;
	ts_unwrapped(c->sim, i, d);
	ts_sub(d, c->centre, d);
	ts_cross(d, c->p->f[i], d);
	return d[a];
}

/* A run must not end because an output finds nobody: the value is that of LAMMPS and LIGGGHTS, and is warned of once. */
static void warn_empty(struct selection *c, const struct ts_word *name, const char *value)
{
	if (c->sim->groups.told_empty || (c->sim->reading.explain && c->sim->reading.planned))
		return;
	c->sim->groups.told_empty = true;
	ts_warn(&c->sim->log, &name->place,
		"group '%s' has no particles%s: its centre, bounds and what follows from them are not "
		"defined; the value is %s, as in LAMMPS (said once)",
		name->text, c->region ? " in that region" : "", value);
}

static void find_mass(struct selection *c, const struct ts_word *name)
{
	c->mass = sum_terms(c, mass_term, 0, 0);
	if (!(c->mass > 0))
		warn_empty(c, name, "0");
}

/* The centre of no particles is 0. */
static void find_centre(struct selection *c, const struct ts_word *name)
{
	find_mass(c, name);
	for (int k = 0; k < 3; k++)
		c->centre[k] = c->mass > 0 ? sum_terms(c, mass_position_term, k, 0) / c->mass : 0;
}

/* *out: index of the word, such as "x" or "yz", in a list of names. */
static enum ts_status find_name(struct tsim *sim, const struct ts_word *word, const char *const *names,
				const char *expected, int *out)
{
	for (*out = 0; names[*out]; ++*out)
		if (ts_streq(word->text, names[*out]))
			return TS_OK;
	return ts_fail(&sim->error, TS_SYNTAX, &word->place, "expected %s, found '%s'", expected, word->text);
}

static enum ts_status read_dim(struct tsim *sim, const struct ts_word *word, int *dim)
{
	return find_name(sim, word, ts_axis_names, "x, y or z", dim);
}

static enum ts_status eval_sum(struct tsim *sim, struct ts_words args, term_fn *term, double *out)
{
	struct selection c;

	TS_TRY(read_group(sim, args, 2, &c));
	*out = sum_terms(&c, term, 0, 0);
	return TS_OK;
}

static enum ts_status eval_count(struct tsim *sim, struct ts_words args, double *out)
{
	return eval_sum(sim, args, count_term, out);
}

static enum ts_status eval_mass(struct tsim *sim, struct ts_words args, double *out)
{
	return eval_sum(sim, args, mass_term, out);
}

static enum ts_status eval_ke(struct tsim *sim, struct ts_words args, double *out)
{
	return eval_sum(sim, args, kinetic_energy_term, out);
}

/* (group,dim[,region]); about: terms are relative to the centre of mass. */
static enum ts_status eval_component(struct tsim *sim, struct ts_words args, term_fn *term, bool about,
				     double *out)
{
	struct selection c;
	int dim;

	TS_TRY(read_group(sim, args, 3, &c));
	TS_TRY(read_dim(sim, &args.word[1], &dim));
	if (about)
		find_centre(&c, &args.word[0]);
	*out = sum_terms(&c, term, dim, 0);
	return TS_OK;
}

static enum ts_status eval_per_mass(struct tsim *sim, struct ts_words args, term_fn *term, double *out)
{
	struct selection c;

	TS_TRY(eval_component(sim, args, term, false, out));
	TS_TRY(read_group(sim, args, 3, &c));
	find_mass(&c, &args.word[0]);
	*out = c.mass > 0 ? *out / c.mass : 0;
	return TS_OK;
}

static enum ts_status eval_xcm(struct tsim *sim, struct ts_words args, double *out)
{
	return eval_per_mass(sim, args, mass_position_term, out);
}

static enum ts_status eval_vcm(struct tsim *sim, struct ts_words args, double *out)
{
	return eval_per_mass(sim, args, momentum_term, out);
}

static enum ts_status eval_fcm(struct tsim *sim, struct ts_words args, double *out)
{
	return eval_component(sim, args, force_term, false, out);
}

static enum ts_status eval_angmom(struct tsim *sim, struct ts_words args, double *out)
{
	return eval_component(sim, args, angular_momentum_term, true, out);
}

static enum ts_status eval_torque(struct tsim *sim, struct ts_words args, double *out)
{
	return eval_component(sim, args, torque_term, true, out);
}

static enum ts_status eval_gyration(struct tsim *sim, struct ts_words args, double *out)
{
	struct selection c;

	TS_TRY(read_group(sim, args, 2, &c));
	find_centre(&c, &args.word[0]);
	*out = c.mass > 0 ? sqrt(sum_terms(&c, mass_r2_term, 0, 0) / c.mass) : 0;
	return TS_OK;
}

static enum ts_status eval_inertia(struct tsim *sim, struct ts_words args, double *out)
{
	static const char *const names[] = { "xx", "yy", "zz", "xy", "yz", "xz", NULL };
	static const int first[] = { 0, 1, 2, 0, 1, 0 }, second[] = { 0, 1, 2, 1, 2, 2 };
	struct selection c;
	int k;

	TS_TRY(read_group(sim, args, 3, &c));
	TS_TRY(find_name(sim, &args.word[1], names, "xx, yy, zz, xy, yz or xz", &k));
	find_centre(&c, &args.word[0]);
	*out = sum_terms(&c, inertia_term, first[k], second[k]);
	return TS_OK;
}

static double determinant(double m[3][3])
{
	double value = 0;

	for (int k = 0; k < 3; k++) {
		int u = (k + 1) % 3, w = (k + 2) % 3;

		value += m[0][k] * (m[1][u] * m[2][w] - m[1][w] * m[2][u]);
	}
	return value;
}

/* Solves I omega = L by Cramer's rule. */
static enum ts_status eval_omega(struct tsim *sim, struct ts_words args, double *out)
{
	double tensor[3][3], whole, trace;
	struct selection c;
	int dim;

	TS_TRY(read_group(sim, args, 3, &c));
	TS_TRY(read_dim(sim, &args.word[1], &dim));
	find_centre(&c, &args.word[0]);
	*out = 0;
	if (!(c.mass > 0))
		return TS_OK;
	for (int a = 0; a < 3; a++)
		for (int b = 0; b < 3; b++)
			tensor[a][b] = sum_terms(&c, inertia_term, a, b);
	whole = determinant(tensor);
	trace = tensor[0][0] + tensor[1][1] + tensor[2][2];
	if (!(whole > 1e-12 * trace * trace * trace))
		return ts_fail(&sim->error, TS_STATE, &args.word[0].place,
			       "the particles of group '%s' lie on one line: the angular velocity about it "
			       "is not defined",
			       args.word[0].text);
	for (int a = 0; a < 3; a++)
		tensor[a][dim] = sum_terms(&c, angular_momentum_term, a, 0);
	*out = determinant(tensor) / whole;
	return TS_OK;
}

static const double OUTERMOST = 1e20; /* as LAMMPS and LIGGGHTS have it */

static enum ts_status eval_bound(struct tsim *sim, struct ts_words args, double *out)
{
	static const char *const names[] = { "xmin", "xmax", "ymin", "ymax", "zmin", "zmax", NULL };
	struct selection c;
	bool found = false;
	int side;

	TS_TRY(read_group(sim, args, 3, &c));
	TS_TRY(find_name(sim, &args.word[1], names, "xmin, xmax, ymin, ymax, zmin or zmax", &side));
	for (size_t i = 0; i < c.p->n; i++) {
		double x = c.p->x[i][side / 2];

		if (!is_selected(&c, i))
			continue;
		if (!found || (side % 2 ? x > *out : x < *out))
			*out = x;
		found = true;
	}
	if (!found) {
		*out = side % 2 ? -OUTERMOST : OUTERMOST;
		warn_empty(&c, &args.word[0], "1e20 or -1e20");
	}
	return TS_OK;
}

static enum ts_status eval_mask(const struct selection *c, struct ts_table *out)
{
	if (ts_table_resize(out, c->p->n, 1) != TS_OK)
		return ts_nomem(&c->sim->error);
	for (size_t i = 0; i < c->p->n; i++)
		out->data[i] = is_selected(c, i);
	return TS_OK;
}

static enum ts_status eval_gmask(struct tsim *sim, struct ts_words args, struct ts_table *out)
{
	struct selection c;

	TS_TRY(read_group(sim, args, 2, &c)); /* also of grmask */
	return eval_mask(&c, out);
}

static enum ts_status eval_rmask(struct tsim *sim, struct ts_words args, struct ts_table *out)
{
	struct selection c = { .sim = sim, .p = sim->particles };

	TS_TRY(read_region(&c, &args.word[0]));
	return eval_mask(&c, out);
}

static enum ts_status read_type(struct tsim *sim, const struct ts_word *word, int *out)
{
	int64_t type;

	if (!ts_parse_int(word->text, &type) || type < 1 || type > sim->particles->ntypes)
		return ts_fail(&sim->error, TS_RANGE, &word->place,
			       "property(): expected a particle type from 1 to %d, found '%s'",
			       sim->particles->ntypes, word->text);
	*out = (int)type;
	return TS_OK;
}

/* property(NAME,TYPE) and property(NAME,TYPE,TYPE) */
static enum ts_status eval_property(struct tsim *sim, struct ts_words args, double *out)
{
	int a = 0, b = 0;

	TS_TRY(read_type(sim, &args.word[1], &a));
	if (args.n > 2)
		TS_TRY(read_type(sim, &args.word[2], &b));
	return ts_property_value(sim, args.word[0].text, a, b, "property()", &args.word[0].place, out);
}

#define WHOLE(name_, f, help_)                                                                          \
	{                                                                                               \
		.name = (name_), .arguments = "group[,region]", .help = (help_), .least = 1, .most = 2, \
		.eval = (f)                                                                             \
	}
#define PART(name_, part, f, help_)                                                                   \
	{                                                                                             \
		.name = (name_), .arguments = "group," part "[,region]", .help = (help_), .least = 2, \
		.most = 3, .eval = (f)                                                                \
	}

static const struct ts_function functions[] = {
	WHOLE("count", eval_count, "number of particles"),
	WHOLE("mass", eval_mass, "total mass"),
	WHOLE("ke", eval_ke, "translational kinetic energy"),
	WHOLE("gyration", eval_gyration, "radius of gyration: sqrt(sum m r^2 / sum m)"),
	PART("xcm", "x|y|z", eval_xcm, "centre of mass"),
	PART("vcm", "x|y|z", eval_vcm, "velocity of the centre of mass"),
	PART("fcm", "x|y|z", eval_fcm, "total force"),
	PART("angmom", "x|y|z", eval_angmom,
	     "angular momentum about the centre of mass, without rotation of the particles other than "
	     "clumps"),
	PART("torque", "x|y|z", eval_torque, "torque of the forces about the centre of mass"),
	PART("inertia", "xx|yy|zz|xy|yz|xz", eval_inertia,
	     "inertia tensor about the centre of mass, of point masses and clumps"),
	PART("omega", "x|y|z", eval_omega, "angular velocity omega, where I omega = L"),
	PART("bound", "xmin|xmax|ymin|ymax|zmin|zmax", eval_bound,
	     "smallest or largest coordinate of centres"),
	{ .name = "property",
	  .arguments = "name,type[,type]",
	  .help = "property of a material or of a pair of materials, see fix property/global",
	  .least = 2,
	  .most = 3,
	  .eval = eval_property },
	{ .name = "gmask",
	  .arguments = "group",
	  .help = "1 for particles of the group, else 0",
	  .least = 1,
	  .most = 1,
	  .peratom = eval_gmask },
	{ .name = "rmask",
	  .arguments = "region",
	  .help = "1 for particles in the region, else 0",
	  .least = 1,
	  .most = 1,
	  .peratom = eval_rmask },
	{ .name = "grmask",
	  .arguments = "group,region",
	  .help = "1 for particles of the group in the region, else 0",
	  .least = 2,
	  .most = 2,
	  .peratom = eval_gmask },
	{ .name = NULL },
};

static void connect_groups(struct tsim *sim)
{
	sim->particles->choose_members = ts_group_choose_due;
}

const struct ts_system_style ts_groups_system = {
	.style = { .name = "groups", .kind = TS_KIND_SYSTEM, .summary = "functions of formulas over groups" },
	.no_instance = true,
	.connect = connect_groups,
	.functions = functions,
};
