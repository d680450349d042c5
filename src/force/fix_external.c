/* Fix external: forces, energies and numbers that an outside program gives by tsim_external. */
#include "core/ranks.h"
#include "core/sim.h"
#include "energy/potential_energy.h"
#include "particle/columns.h"
#include "particle/particles.h"

#include <string.h>

#include "base/banned.h"

enum { CALLBACK, ARRAY };
enum { ENERGY = 3, WIDTH };

struct state {
	int mode;
	int64_t first, second;
	size_t column; /* of each particle: force, energy */
	double energy; /* of all particles together */
	double *vector;
	size_t nvector, capacity;
	bool given; /* the program has given forces */
};

static double *particle_row(const struct state *s, const struct tsim *sim, size_t i)
{
	return (double *)sim->particles->column[s->column].data + WIDTH * i;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	struct ts_str name = { 0 };
	enum ts_status status;

	if (s->mode == CALLBACK && !s->second)
		return ts_fail(&sim->error, TS_SYNTAX, &self->where,
			       "fix external: pf/callback lacks Napply, the steps between additions of the "
			       "forces");
	if (s->mode == ARRAY && s->second)
		return ts_fail(&sim->error, TS_SYNTAX, &self->where,
			       "fix external: pf/array takes one number, the steps between additions of the "
			       "forces");
	ts_str_addf(&name, "fix external %s", self->id);
	status = name.failed ? ts_nomem(&sim->error)
			     : ts_particles_add_column(sim, ts_str_text(&name), WIDTH, 0, &s->column);
	ts_str_release(&name);
	return status;
}

/* ---- what the program gives */

static enum ts_status check_numbers(struct tsim *sim, const char *what, size_t n, size_t expected)
{
	if (n == expected)
		return TS_OK;
	return ts_fail(&sim->error, TS_RANGE, NULL, "fix external: %zu numbers given as '%s', expected %zu",
		       n, what, expected);
}

static enum ts_status take_column(struct state *s, struct tsim *sim, const double *value, size_t first,
				  size_t count)
{
	for (size_t i = 0; i < sim->particles->n; i++)
		memcpy(particle_row(s, sim, i) + first, value + count * i, count * sizeof *value);
	return TS_OK;
}

static enum ts_status take_force(struct state *s, struct tsim *sim, double *value, size_t n)
{
	TS_TRY(check_numbers(sim, "force", n, 3 * sim->particles->n));
	s->given = true;
	return take_column(s, sim, value, 0, 3);
}

static enum ts_status take_energies(struct state *s, struct tsim *sim, double *value, size_t n)
{
	TS_TRY(check_numbers(sim, "energies", n, sim->particles->n));
	return take_column(s, sim, value, ENERGY, 1);
}

static enum ts_status take_energy(struct state *s, struct tsim *sim, double *value, size_t n)
{
	TS_TRY(check_numbers(sim, "energy", n, 1));
	s->energy = value[0];
	return TS_OK;
}

static enum ts_status take_vector(struct state *s, struct tsim *sim, double *value, size_t n)
{
	if (TS_GROW(s->vector, s->capacity, n) != TS_OK)
		return ts_nomem(&sim->error);
	if (n)
		memcpy(s->vector, value, n * sizeof *value);
	s->nvector = n;
	return TS_OK;
}

static enum ts_status tell_due(struct state *s, struct tsim *sim, double *value, size_t n)
{
	TS_TRY(check_numbers(sim, "due", n, 1));
	value[0] = s->mode == CALLBACK && sim->clock.step % s->first == 0;
	return TS_OK;
}

static const struct {
	const char *what;
	enum ts_status (*take)(struct state *s, struct tsim *sim, double *value, size_t n);
} taken[] = {
	{ "force", take_force },   { "energies", take_energies }, { "energy", take_energy },
	{ "vector", take_vector }, { "due", tell_due },
};

static enum ts_status take(struct ts_instance *self, struct tsim *sim, const char *what, double *value,
			   size_t n)
{
	struct ts_suggest suggest = ts_suggest_start(what);

	self->cached = NULL;
	for (size_t k = 0; k < sizeof taken / sizeof *taken; k++) {
		if (ts_streq(taken[k].what, what))
			return taken[k].take(self->state, sim, value, n);
		ts_suggest_try(&suggest, taken[k].what);
	}
	return ts_fail(&sim->error, TS_UNKNOWN, NULL, "fix external takes no '%s'%s", what,
		       ts_suggest_text(&suggest));
}

/* ---- a step */

static enum ts_status add_force(struct ts_instance *self, struct tsim *sim)
{
	const struct state *s = self->state;
	const struct ts_particles *p = sim->particles;
	int64_t every = s->mode == CALLBACK ? s->second : s->first;

	if (s->mode == CALLBACK && !s->given)
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "fix external: no program gives the forces; pf/callback needs a function set "
			       "by set_fix_external_callback of the Python interface, or tsim_external of "
			       "the C library");
	if (sim->clock.step % every != 0)
		return TS_OK;
#pragma omp parallel for num_threads(ts_team(sim, p->n)) schedule(static)
	for (size_t i = 0; i < p->n; i++)
		for (int k = 0; k < 3 && ts_in_group(p, i, self->group); k++)
			p->f[i][k] += particle_row(s, sim, i)[k];
	return TS_OK;
}

/* Whether all ranks have this number; all call it. */
static bool agree(struct tsim *sim, double number)
{
	double range[2] = { number, -number };

	ts_ranks_most_of(sim, range, 2);
	return !(range[0] > -range[1]);
}

/* Numbers that are not of single particles are those of the whole simulation, which all ranks give. */
static enum ts_status check_ranks(struct ts_instance *self, struct tsim *sim)
{
	const struct state *s = self->state;
	bool same = agree(sim, s->energy) & agree(sim, (double)s->nvector);

	for (size_t k = 0; same && k < s->nvector; k++)
		same = agree(sim, s->vector[k]);
	if (same)
		return TS_OK;
	return ts_fail(&sim->error, TS_STATE, &self->where,
		       "fix external: energy and vector are of all particles, but ranks have given different "
		       "numbers, this one the energy %g and %zu other numbers",
		       s->energy, s->nvector);
}

static enum ts_status archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a)
{
	struct state *s = self->state;

	TS_TRY(ts_archive_array(a, "vector", TS_SAVED_F64, (void **)&s->vector, &s->capacity, &s->nvector));
	return ts_particles_archive_column(a, sim, "particles", s->column);
}

static const struct ts_saved saved[] = {
	TS_SAVE_F64(struct state, energy),
	TS_SAVED_ROWS_END,
};

static enum ts_status eval_energy(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	(void)sim;
	out->data[0] = ((const struct state *)self->state)->energy;
	return TS_OK;
}

static enum ts_status eval_vector(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct state *s = self->state;

	(void)sim;
	TS_TRY(ts_table_resize(out, 1, s->nvector));
	if (s->nvector)
		memcpy(out->data, s->vector, s->nvector * sizeof *out->data);
	return TS_OK;
}

static enum ts_status eval_particles(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct state *s = self->state;
	size_t n = sim->particles->n;

	TS_TRY(ts_table_resize(out, n, WIDTH));
	if (n)
		memcpy(out->data, particle_row(s, sim, 0), WIDTH * n * sizeof *out->data);
	return TS_OK;
}

static void fini(struct ts_instance *self)
{
	ts_free(((struct state *)self->state)->vector);
}

static const char *const modes[] = { "pf/callback", "pf/array", NULL };
static const struct ts_arg args[] = {
	TS_ENUM("mode", struct state, mode, modes, .flags = TS_POSITIONAL,
		.help = "pf/callback: a function of the program computes the forces; pf/array: the program "
			"sets them between runs or in functions called in each step"),
	TS_INT("N", struct state, first, .flags = TS_POSITIONAL, .range = TS_WITHIN, .lo = 1, .hi = 1e15,
	       .help = "pf/callback: steps between calls of the function (Ncall); pf/array: steps between "
		       "additions of the forces (Napply)"),
	TS_INT("Napply", struct state, second, .flags = TS_POSITIONAL, .range = TS_WITHIN, .lo = 0,
	       .hi = 1e15, .fallback = "0",
	       .help = "pf/callback only: steps between additions of the forces"),
	TS_ARGS_END,
};

static const char *const components[] = { "fx", "fy", "fz", "energy", NULL };
static const struct ts_value values[] = {
	{ "energy", "energy", "the energy that the program has given for all particles together", TS_SCALAR,
	  1, NULL, eval_energy },
	{ "vector", "", "the numbers that the program has given", TS_VECTOR, 0, NULL, eval_vector },
	{ "particles", "", "force and energy of each particle as the program has given them", TS_PERATOM,
	  WIDTH, components, eval_particles },
	{ .name = NULL },
};

TS_STYLE(fix, ts_style, ts_fix_external)
const struct ts_style ts_fix_external = {
	.name = "external",
	.kind = TS_KIND_FIX,
	.summary = "Adds forces that an outside program computes",
	.purpose = "Forces computed in Python or C: control loops, forces fitted elsewhere, coupling of two "
		   "programs.",
	.doc = "A program that runs tsim as a library gives a force to each particle: by a function that is "
	       "called in each step divisible by Ncall (pf/callback), or as an array that keeps its values "
	       "until it is changed (pf/array). The forces on the particles of the group are added in each "
	       "step divisible by Napply, in the order of fixes in the script. They belong to particles: "
	       "they move with them in memory, are kept in restart files, and those of new particles are "
	       "0.\n\n"
	       "In Python: set_fix_external_callback, fix_external_get_force, "
	       "fix_external_set_energy_global, fix_external_set_energy_peratom, "
	       "fix_external_set_vector_length, fix_external_set_vector, with the meaning that LAMMPS' "
	       "manual gives them (doc/python.md). In C: tsim_external (doc/library.md).\n\n"
	       "On several ranks a function gives the forces of the particles that its process has in that "
	       "step. "
	       "Energy and vector are those of all particles: each process gives the same numbers.\n\n"
	       "The energy counts in compute pe if `fix_modify ID energy yes` is set. Virials are not taken: "
	       "pressures are of contacts, bonds and motion. With pf/callback, a run without a function is "
	       "an error.",
	.example = "fix push all external pf/callback 1 1\nfix field grains external pf/array 1",
	.args = args,
	.ranks = TS_RANKS_OWN | TS_RANKS_OUTPUTS,
	.join = check_ranks,
	.state_size = sizeof(struct state),
	.saved = saved,
	.archive = archive,
	.values = values,
	.energy = ts_energy_output,
	.take = take,
	.init = init,
	.hook = { [TS_STAGE_POST_FORCE] = add_force },
	.fini = fini,
};
