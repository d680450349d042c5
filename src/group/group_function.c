/* Functions of formulas that sum over a group, or over its particles in a region. As in LAMMPS, positions are
 * unwrapped, and particles are points; clumps are bodies: rigid/rigid_share.h. */
#include "group/group_function.h"

#include <math.h>
#include <string.h>

#include "base/axes.h"
#include "group/group_dynamic.h"
#include "group/kinetic_energy.h"
#include "material/property.h"
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

/* Terms of blocks of particles (ts_group_sum_blocks), about the centre of the selection where they are about a point. */
struct summand {
	ts_terms_fn *terms;
	size_t width;
};

static bool is_selected(const struct selection *c, size_t i)
{
	return ts_in_group(c->p, i, c->group) && (!c->region || ts_region_contains(c->region, c->p->x[i]));
}

struct in_region {
	const struct selection *c;
	const struct summand *summand;
};

static void terms_in_region(const struct tsim *sim, size_t from, size_t n, const void *context,
			    double (*term)[TS_TERM_BLOCK])
{
	const struct in_region *in = context;

	in->summand->terms(sim, from, n, in->c->centre, term);
	for (size_t i = 0; i < n; i++)
		for (size_t k = 0; k < in->summand->width && !is_selected(in->c, from + i); k++)
			term[k][i] = 0;
}

/* Sums of terms; exact and rounded once, so they do not depend on the order of particles. */
static void sum_terms(const struct selection *c, const struct summand *summand, double *out)
{
	const struct in_region in = { c, summand };

	if (c->region)
		ts_group_sum_blocks(c->sim, c->group, summand->width, terms_in_region, &in, out);
	else
		ts_group_sum_blocks(c->sim, c->group, summand->width, summand->terms, c->centre, out);
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

static void count_terms(const struct tsim *sim, size_t from, size_t n, const void *centre,
			double (*term)[TS_TERM_BLOCK])
{
	(void)sim, (void)from, (void)centre;
	for (size_t i = 0; i < n; i++)
		term[0][i] = 1;
}

static void mass_terms(const struct tsim *sim, size_t from, size_t n, const void *centre,
		       double (*term)[TS_TERM_BLOCK])
{
	(void)centre;
	memcpy(term[0], sim->particles->mass + from, n * sizeof *term[0]);
}

static void force_terms(const struct tsim *sim, size_t from, size_t n, const void *centre,
			double (*term)[TS_TERM_BLOCK])
{
	(void)centre;
	for (size_t i = 0; i < n; i++)
		for (int d = 0; d < 3; d++)
			term[d][i] = sim->particles->f[from + i][d];
}

static void mass_r2_terms(const struct tsim *sim, size_t from, size_t n, const void *centre,
			  double (*term)[TS_TERM_BLOCK])
{
	ts_mass_second_moment_terms(sim, from, n, centre, term);
	for (size_t i = 0; i < n; i++)
		term[0][i] = term[0][i] + term[1][i] + term[2][i];
}

static void torque_terms(const struct tsim *sim, size_t from, size_t n, const void *centre,
			 double (*term)[TS_TERM_BLOCK])
{
	for (size_t i = 0; i < n; i++) {
		double d[3];

		ts_unwrapped(sim, from + i, d);
		ts_sub(d, centre, d);
		ts_cross(d, sim->particles->f[from + i], d);
		for (int k = 0; k < 3; k++)
			term[k][i] = d[k];
	}
}

static const struct summand number = { count_terms, 1 }, mass = { mass_terms, 1 },
			    kinetic_energy = { ts_kinetic_energy_terms, 1 },
			    mass_position = { ts_mass_moment_terms, 4 },
			    momentum = { ts_mass_momentum_terms, 4 }, force = { force_terms, 3 },
			    mass_r2 = { mass_r2_terms, 1 }, inertia = { ts_mass_inertia_terms, 6 },
			    angular_momentum = { ts_mass_angular_momentum_terms, 3 },
			    torque = { torque_terms, 3 };

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

/* The centre of no particles is 0. */
static void find_centre(struct selection *c, const struct ts_word *name)
{
	double sum[4];

	sum_terms(c, &mass_position, sum);
	c->mass = sum[3];
	if (!(c->mass > 0))
		warn_empty(c, name, "0");
	for (int k = 0; k < 3; k++)
		c->centre[k] = c->mass > 0 ? sum[k] / c->mass : 0;
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

static enum ts_status eval_sum(struct tsim *sim, struct ts_words args, const struct summand *summand,
			       double *out)
{
	struct selection c;

	TS_TRY(read_group(sim, args, 2, &c));
	sum_terms(&c, summand, out);
	return TS_OK;
}

static enum ts_status eval_count(struct tsim *sim, struct ts_words args, double *out)
{
	return eval_sum(sim, args, &number, out);
}

static enum ts_status eval_mass(struct tsim *sim, struct ts_words args, double *out)
{
	return eval_sum(sim, args, &mass, out);
}

static enum ts_status eval_ke(struct tsim *sim, struct ts_words args, double *out)
{
	return eval_sum(sim, args, &kinetic_energy, out);
}

/* (group,dim[,region]); about: terms are relative to the centre of mass. */
static enum ts_status eval_component(struct tsim *sim, struct ts_words args, const struct summand *summand,
				     bool about, double *out)
{
	double sum[TS_MOST_TERMS];
	struct selection c;
	int dim;

	TS_TRY(read_group(sim, args, 3, &c));
	TS_TRY(read_dim(sim, &args.word[1], &dim));
	if (about)
		find_centre(&c, &args.word[0]);
	sum_terms(&c, summand, sum);
	*out = sum[dim];
	return TS_OK;
}

/* A component by the mass, the fourth term. */
static enum ts_status eval_per_mass(struct tsim *sim, struct ts_words args, const struct summand *summand,
				    double *out)
{
	struct selection c;
	double sum[4];
	int dim;

	TS_TRY(read_group(sim, args, 3, &c));
	TS_TRY(read_dim(sim, &args.word[1], &dim));
	sum_terms(&c, summand, sum);
	if (!(sum[3] > 0))
		warn_empty(&c, &args.word[0], "0");
	*out = sum[3] > 0 ? sum[dim] / sum[3] : 0;
	return TS_OK;
}

static enum ts_status eval_xcm(struct tsim *sim, struct ts_words args, double *out)
{
	return eval_per_mass(sim, args, &mass_position, out);
}

static enum ts_status eval_vcm(struct tsim *sim, struct ts_words args, double *out)
{
	return eval_per_mass(sim, args, &momentum, out);
}

static enum ts_status eval_fcm(struct tsim *sim, struct ts_words args, double *out)
{
	return eval_component(sim, args, &force, false, out);
}

static enum ts_status eval_angmom(struct tsim *sim, struct ts_words args, double *out)
{
	return eval_component(sim, args, &angular_momentum, true, out);
}

static enum ts_status eval_torque(struct tsim *sim, struct ts_words args, double *out)
{
	return eval_component(sim, args, &torque, true, out);
}

static enum ts_status eval_gyration(struct tsim *sim, struct ts_words args, double *out)
{
	struct selection c;
	double sum;

	TS_TRY(read_group(sim, args, 2, &c));
	find_centre(&c, &args.word[0]);
	sum_terms(&c, &mass_r2, &sum);
	*out = c.mass > 0 ? sqrt(sum / c.mass) : 0;
	return TS_OK;
}

static enum ts_status eval_inertia(struct tsim *sim, struct ts_words args, double *out)
{
	double sum[6];
	struct selection c;
	int k;

	TS_TRY(read_group(sim, args, 3, &c));
	TS_TRY(find_name(sim, &args.word[1], ts_tensor_names, "xx, yy, zz, xy, yz or xz", &k));
	find_centre(&c, &args.word[0]);
	sum_terms(&c, &inertia, sum);
	*out = sum[k];
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
	double tensor[3][3], sum[6], whole, trace;
	struct selection c;
	int dim;

	TS_TRY(read_group(sim, args, 3, &c));
	TS_TRY(read_dim(sim, &args.word[1], &dim));
	find_centre(&c, &args.word[0]);
	*out = 0;
	if (!(c.mass > 0))
		return TS_OK;
	sum_terms(&c, &inertia, sum);
	for (int k = 0; k < 6; k++) {
		const int a = ts_tensor_row[k], b = ts_tensor_column[k];

		tensor[a][b] = tensor[b][a] = sum[k];
	}
	whole = determinant(tensor);
	trace = tensor[0][0] + tensor[1][1] + tensor[2][2];
	if (!(whole > 1e-12 * trace * trace * trace))
		return ts_fail(&sim->error, TS_STATE, &args.word[0].place,
			       "the particles of group '%s' lie on one line: the angular velocity about it "
			       "is not defined",
			       args.word[0].text);
	sum_terms(&c, &angular_momentum, sum);
	for (int a = 0; a < 3; a++)
		tensor[a][dim] = sum[a];
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
