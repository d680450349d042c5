/* Fixes couple/cfd and its family: a program that uses the library computes the fluid and the force on
 * each particle, as with LIGGGHTS. Data are exchanged in columns of the particles, which the program reads
 * and writes by name; without such a program they stay zero.
 *
 * The names are those of LIGGGHTS: dragforce (3), Ksl, uf (3), convectiveHeatFlux. */
#include "average/particle_tally.h"
#include "core/report.h"

#include <math.h>

#include "heat/heat.h"
#include "particle/columns.h"
#include "particle/particles.h"

#include "base/banned.h"

enum { MOST = 3 };

/* ---- fix couple/cfd: declares the coupling */

#define FAMILY_PARTNER "coupled program"

struct partner {
	int64_t every;
	bool mpi, warned;
	const char *file;
};

static enum ts_status init_couple_cfd(struct ts_instance *self, struct tsim *sim)
{
	const struct partner *s = self->state;

	if (!s->file)
		return TS_OK;
	return ts_fail(&sim->error, TS_STATE, ts_instance_word(self, "file"),
		       "fix couple/cfd: exchange through files is not supported; use `mpi`, and let a "
		       "program with the library (doc/library.md) read and write the values");
}

static enum ts_status warn_without_program(struct ts_instance *self, struct tsim *sim)
{
	struct partner *s = self->state;

	if (!sim->run.in_pieces && !sim->outside && !s->warned)
		ts_warn(&sim->log, &self->where,
			"fix couple/cfd: no program is coupled: dragforce, Ksl, uf and convectiveHeatFlux "
			"have the values of the script, otherwise 0");
	s->warned = true;
	return TS_OK;
}

/* ---- fixes that act on particles, each with its columns */

struct field {
	const char *name;
	size_t width;
};

struct force {
	struct ts_particle_tally total; /* the force on each particle in this step */
	const struct field *field;	/* the columns that it exchanges */
	int nfields;
	double alpha; /* CrankNicolson; NaN: explicit */
	double first; /* couple/cfd/convection: initial temperature, unused if fix heat/gran gives one */
	const char *weight;
	bool implicit, ready;
	size_t column[MOST];
};

enum { DRAG, COEFFICIENT, VELOCITY }; /* indices of columns; a heat flux is the only column of its fix */
static const struct field force_fields[] = { { "dragforce", 3 }, { "Ksl", 1 }, { "uf", 3 } };
static const struct field heat_field = { "convectiveHeatFlux", 1 };

static double *particle_column(const struct force *s, const struct tsim *sim, int k, size_t i)
{
	const struct ts_column *c = &sim->particles->column[s->column[k]];

	return (double *)c->data + i * c->width;
}

static bool program_attached(const struct tsim *sim)
{
	size_t k = 0;

	return ts_sim_next_of(sim, TS_KIND_FIX, FAMILY_PARTNER, &k);
}

static enum ts_status add_columns(struct ts_instance *self, struct tsim *sim, const struct field *field,
				  int n)
{
	struct force *s = self->state;
	const double zero[3] = { 0 };

	s->field = field;
	s->nfields = n;
	if (!program_attached(sim))
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "fix %s needs a fix couple/cfd before it: `fix cfd all couple/cfd "
			       "couple_every 10 mpi`",
			       self->style->name);
	for (int k = 0; k < n && !s->ready; k++) {
		struct ts_particles *p = sim->particles;
		size_t known = p->ncolumns;

		TS_TRY(ts_particles_add_column(sim, field[k].name, field[k].width, TS_COL_NAMED,
					       &s->column[k]));
		if (p->column[s->column[k]].width != field[k].width)
			return ts_fail(&sim->error, TS_STATE, &self->where,
				       "fix %s: '%s' has %zu numbers of each particle already, expected %zu",
				       self->style->name, field[k].name, p->column[s->column[k]].width,
				       field[k].width);
		if (s->column[k] != known) /* column of a fix property/atom: keeps its values */
			continue;
		TS_TRY(ts_particles_column_initial(sim, s->column[k], zero));
		ts_particles_fill_initial(&p->column[s->column[k]], 0, p->n);
	}
	s->ready = true;
	return TS_OK;
}

static enum ts_status init_force(struct ts_instance *self, struct tsim *sim)
{
	return add_columns(self, sim, force_fields, 1);
}

static enum ts_status init_implicit(struct ts_instance *self, struct tsim *sim)
{
	struct force *s = self->state;

	s->implicit = true;
	if (!s->weight || ts_streq(s->weight, "no"))
		s->alpha = NAN;
	else if (ts_streq(s->weight, "yes"))
		s->alpha = 0.5;
	else if (!ts_parse_real(s->weight, &s->alpha) || !(s->alpha >= 0 && s->alpha <= 1))
		return ts_fail(&sim->error, TS_RANGE, ts_instance_word(self, "CrankNicolson"),
			       "fix couple/cfd/force/implicit: CrankNicolson takes no, yes (0.5) or a number "
			       "from 0 to 1, found '%s'",
			       s->weight);
	return add_columns(self, sim, force_fields, 3);
}

/* F = dragforce + Ksl (uf - v); with CrankNicolson a the drag is that of the velocity (1 - a) v + a v', v'
 * being what it makes of v in this step, m (v' - v) = h Ksl (uf - (1 - a) v - a v'). */
static void coupling_force(const struct force *s, const struct tsim *sim, size_t i, double f[3])
{
	const struct ts_particles *p = sim->particles;
	const double *drag = particle_column(s, sim, DRAG, i), *uf;
	double k;

	for (int d = 0; d < 3; d++)
		f[d] = drag[d];
	if (!s->implicit)
		return;
	k = *particle_column(s, sim, COEFFICIENT, i);
	uf = particle_column(s, sim, VELOCITY, i);
	if (!isnan(s->alpha))
		k /= 1 + s->alpha * k * sim->clock.dt * p->imass[i];
	for (int d = 0; d < 3; d++)
		f[d] += k * (uf[d] - p->v[i][d]);
}

static enum ts_status post_force(struct ts_instance *self, struct tsim *sim)
{
	struct force *s = self->state;
	struct ts_particles *p = sim->particles;

	TS_TRY(ts_particle_tally_start(sim, &s->total));
#pragma omp parallel for num_threads(ts_team(sim, p->n)) schedule(static)
	for (size_t i = 0; i < p->n; i++) {
		double *f = s->total.note[i];

		if (!ts_in_group(p, i, self->group))
			continue;
		coupling_force(s, sim, i, f);
		for (int d = 0; d < 3; d++)
			p->f[i][d] += f[d];
	}
	return TS_OK;
}

/* The drag relaxes the velocity of particle i at this rate, 1/time, as far as stability goes. */
static double implicit_rate(const struct force *s, const struct tsim *sim, size_t i)
{
	return *particle_column(s, sim, COEFFICIENT, i) * sim->particles->imass[i] *
	       (isnan(s->alpha) ? 1 : 1 - 2 * fmin(s->alpha, 0.5));
}

static void add_ground(const struct ts_instance *self, const struct tsim *sim, size_t i,
		       struct ts_ground_springs *sum)
{
	const struct force *s = self->state;

	for (int d = 0; d < 3; d++)
		sum->rate[d] += implicit_rate(s, sim, i);
	sum->estimated |= !isnan(s->alpha);
}

static enum ts_status plan_force(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report)
{
	const struct force *s = self->state;
	double most = 0;

	for (size_t i = 0; s->implicit && i < sim->particles->n; i++)
		if (ts_in_group(sim->particles, i, self->group))
			most = fmax(most, implicit_rate(s, sim, i));
	if (!(most > 0))
		return TS_OK;
	return ts_report_limit(report, 2 / most, true, &self->where,
			       "fix couple/cfd/force/implicit, 2 m/Ksl");
}

static enum ts_status eval_sum(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	struct force *s = self->state;
	const double *sum = ts_particle_tally_sums(&s->total);

	(void)sim;
	for (int d = 0; d < 3; d++)
		out->data[d] = sum[d];
	return TS_OK;
}

static void fini(struct ts_instance *self)
{
	ts_particle_tally_release(&((struct force *)self->state)->total);
}

/* Columns that a fix shares with others of the family go to restart files with each of them. */
static enum ts_status archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a)
{
	const struct force *s = self->state;

	for (int k = 0; k < s->nfields; k++)
		TS_TRY(ts_particles_archive_column(a, sim, s->field[k].name, s->column[k]));
	return TS_OK;
}

static enum ts_status archive_force(struct ts_instance *self, struct tsim *sim, struct ts_archive *a)
{
	TS_TRY(archive(self, sim, a));
	return ts_particle_tally_archive(a, &((struct force *)self->state)->total);
}

static enum ts_status init_convection(struct ts_instance *self, struct tsim *sim)
{
	return add_columns(self, sim, &heat_field, 1);
}

/* Heat goes into the flux of fix heat/gran, which each step begins anew. */
static enum ts_status post_force_heat(struct ts_instance *self, struct tsim *sim)
{
	const struct force *s = self->state;
	const struct ts_heat *heat = ts_heat_of(sim);
	struct ts_particles *p = sim->particles;
	double *flux;

	if (!heat)
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "fix couple/cfd/convection needs fix heat/gran, whose temperatures it "
			       "changes");
	flux = p->column[heat->flux].data;
	for (size_t i = 0; i < p->n; i++)
		if (ts_in_group(p, i, self->group))
			flux[i] += *particle_column(s, sim, DRAG, i);
	return TS_OK;
}

/* ---- the styles */

static const struct ts_value sums[] = {
	{ "force", "force", "sum of the forces added in the last step", TS_VECTOR, 3, NULL, eval_sum },
	{ .name = NULL },
};

static const struct ts_arg partner_args[] = {
	TS_INT("couple_every", struct partner, every, .fallback = "1", .range = TS_POSITIVE, .unit = "steps",
	       .help = "no effect: the other program decides when data are exchanged"),
	TS_FLAG("mpi", struct partner, mpi,
		.help = "data are exchanged within one process (the only method)"),
	TS_WORD("file", struct partner, file, .flags = TS_OPTIONAL,
		.help = "exchange through files: not supported"),
	TS_ARGS_END,
};

TS_STYLE(fix, ts_style, ts_fix_couple_cfd)
const struct ts_style ts_fix_couple_cfd = {
	.name = "couple/cfd",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_OWN | TS_RANKS_OUTPUTS,
	.family = FAMILY_PARTNER,
	.summary = "Couples particles to a fluid that another program computes",
	.doc = "Must precede the fixes couple/cfd/force, couple/cfd/force/implicit and "
	       "couple/cfd/convection, which use per-particle values that the other program writes: "
	       "dragforce, Ksl, uf, convectiveHeatFlux. That program uses the C library (doc/library.md) or "
	       "Python: it writes values by tsim_column_write(sim, \"uf[1]\", numbers, n), reads positions, "
	       "velocities and radii by tsim_column_read, and advances the simulation by tsim_step. "
	       "examples/library/fluid.c is an example. Dumps and formulas refer to the values as "
	       "f_dragforce[1], f_Ksl ...; restart files contain them.\n\n"
	       "If a script is run without such a program the values are zero, as in LIGGGHTS, and a message "
	       "is printed once. For a fluid that tsim itself solves for see flow_style and fix "
	       "drag/gidaspow.\n\n"
	       "With several ranks (doc/ranks.md) the program has joined them by tsim_mpi_join; between "
	       "steps each "
	       "of its processes has all particles, and writes the same values to them.",
	.example = "fix cfd all couple/cfd couple_every 10 mpi\n"
		   "fix drag all couple/cfd/force/implicit",
	.args = partner_args,
	.state_size = sizeof(struct partner),
	.init = init_couple_cfd,
	.hook = { [TS_STAGE_SETUP] = warn_without_program },
};

static const struct ts_arg none[] = { TS_ARGS_END };

TS_STYLE(fix, ts_style, ts_fix_couple_cfd_force)
const struct ts_style ts_fix_couple_cfd_force = {
	.name = "couple/cfd/force",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_OWN | TS_RANKS_OUTPUTS,
	.join = ts_particle_tally_join,
	.summary = "Adds a force of the fluid on each particle, given by another program",
	.doc = "f += dragforce, a vector of each particle that the program coupled to tsim writes (fix "
	       "couple/cfd). f_ID is the sum of these forces over the group.",
	.example = "fix cfd all couple/cfd couple_every 10 mpi\n"
		   "fix drag all couple/cfd/force",
	.args = none,
	.state_size = sizeof(struct force),
	.archive = archive_force,
	.values = sums,
	.init = init_force,
	.hook = { [TS_STAGE_POST_FORCE] = post_force },
	.fini = fini,
};

static const struct ts_arg implicit_args[] = {
	TS_WORD("CrankNicolson", struct force, weight, .flags = TS_OPTIONAL,
		.help = "no (the default), yes (0.5), or the weight a of the new velocity in the drag"),
	TS_ARGS_END,
};

TS_STYLE(fix, ts_style, ts_fix_couple_cfd_force_implicit)
const struct ts_style ts_fix_couple_cfd_force_implicit = {
	.name = "couple/cfd/force/implicit",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_OWN | TS_RANKS_OUTPUTS,
	.join = ts_particle_tally_join,
	.summary = "Adds a drag from coefficients and fluid velocities given by another program",
	.doc = "f += dragforce + Ksl (uf - v), evaluated in each step with the present velocity v of the "
	       "particle, so that the force follows v between two exchanges. dragforce (vector), Ksl "
	       "(scalar) and uf (vector) are values of each particle that the program coupled to tsim writes "
	       "(fix couple/cfd). With CrankNicolson a the drag is that of the velocity (1 - a) v + a v', "
	       "where v' is the velocity after a step h under the drag alone, m (v' - v) = h Ksl (uf - (1 - "
	       "a) v - a v'). Without it time steps must be shorter than 2 m/Ksl. f_ID is the sum of the "
	       "forces over the group.",
	.example = "fix cfd all couple/cfd couple_every 10 mpi\n"
		   "fix drag all couple/cfd/force/implicit CrankNicolson 0.5",
	.args = implicit_args,
	.state_size = sizeof(struct force),
	.archive = archive_force,
	.values = sums,
	.init = init_implicit,
	.hook = { [TS_STAGE_POST_FORCE] = post_force },
	.fini = fini,
	.plan = plan_force,
	.ground = add_ground,
};

static const struct ts_arg convection_args[] = {
	TS_REAL("T0", struct force, first, .flags = TS_OPTIONAL, .unit = "temperature",
		.help = "no effect: fix heat/gran says the temperature at the start"),
	TS_ARGS_END,
};

TS_STYLE(fix, ts_style, ts_fix_couple_cfd_convection)
const struct ts_style ts_fix_couple_cfd_convection = {
	.name = "couple/cfd/convection",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_OWN | TS_RANKS_OUTPUTS,
	.summary = "Adds a convective heat flux to each particle, given by another program",
	.doc = "convectiveHeatFlux, a value of each particle (energy/time) that the program coupled to tsim "
	       "writes (fix couple/cfd), is added to the heat flux of fix heat/gran. That program reads the "
	       "temperatures as Temp.",
	.example = "fix heat all heat/gran initial_temperature 300\n"
		   "fix cfd all couple/cfd couple_every 10 mpi\n"
		   "fix warm all couple/cfd/convection T0 300",
	.args = convection_args,
	.state_size = sizeof(struct force),
	.archive = archive,
	.init = init_convection,
	.hook = { [TS_STAGE_POST_FORCE] = post_force_heat },
};
