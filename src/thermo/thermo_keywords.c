/* Global quantities that thermo_style and formulas can name. */
#include "thermo/thermo.h"

#include <math.h>

#include "base/clock.h"
#include "box/domain.h"
#include "core/ranks.h"
#include "core/standard.h"
#include "energy/potential_energy.h"
#include "group/kinetic_energy.h"
#include "group/temperature.h"
#include "math/exactsum.h"
#include "particle/division.h"
#include "particle/group_moments.h"
#include "particle/particles.h"
#include "particle/rank_sums.h"

#include "base/banned.h"

static enum ts_status step(struct tsim *sim, double *out)
{
	*out = (double)sim->clock.step;
	return TS_OK;
}

static enum ts_status elapsed(struct tsim *sim, double *out)
{
	*out = (double)(sim->clock.step - sim->clock.first_step + sim->clock.elapsed_before);
	return TS_OK;
}

static enum ts_status elaplong(struct tsim *sim, double *out)
{
	*out = (double)(sim->clock.step - sim->clock.ramp_first);
	return TS_OK;
}

static enum ts_status time_now(struct tsim *sim, double *out)
{
	*out = ts_sim_time(sim);
	return TS_OK;
}

static enum ts_status dt(struct tsim *sim, double *out)
{
	*out = sim->clock.dt;
	return TS_OK;
}

/* Wall time since the start of the run in seconds; 0 at its first step and outside of runs. */
static enum ts_status cpu(struct tsim *sim, double *out)
{
	bool started = sim->run.inside && sim->clock.step > sim->clock.first_step;

	*out = ts_ranks_same(sim, started ? ts_clock() - sim->clock.wall_start : 0);
	return TS_OK;
}

/* Simulated time per second of wall time, since the previous row. */
static enum ts_status tpcpu(struct tsim *sim, double *out)
{
	const struct ts_thermo *t = sim->thermo;
	double now, steps = (double)(sim->clock.step - t->last_row_step);

	TS_TRY(cpu(sim, &now));
	*out = ts_ranks_same(sim,
			     now > t->last_row_time ? steps * sim->clock.dt / (now - t->last_row_time) : 0);
	return TS_OK;
}

/* Steps per second of wall time, since the previous row. */
static enum ts_status spcpu(struct tsim *sim, double *out)
{
	TS_TRY(tpcpu(sim, out));
	*out = sim->clock.dt > 0 ? *out / sim->clock.dt : 0;
	return TS_OK;
}

static enum ts_status timeremain(struct tsim *sim, double *out)
{
	*out = ts_ranks_same(sim, sim->run.timeout > 0 ? sim->run.timeout - ts_clock() : 0);
	return TS_OK;
}

/* Of all ranks while the particles are divided. */
static double number_of_particles(const struct tsim *sim)
{
	return (double)ts_division_sum(sim, (int64_t)sim->particles->n);
}

/* Cundall number: particles * steps / wall time (1/s) of the run so far. */
static enum ts_status cundall(struct tsim *sim, double *out)
{
	double steps = (double)(sim->clock.step - sim->clock.first_step);

	TS_TRY(cpu(sim, out));
	*out = *out > 0 ? number_of_particles(sim) * steps / *out : 0;
	return TS_OK;
}

static enum ts_status cpuremain(struct tsim *sim, double *out)
{
	double done = (double)(sim->clock.step - sim->clock.first_step);
	double left = (double)(sim->clock.last_step - sim->clock.step);

	TS_TRY(cpu(sim, out));
	*out = done > 0 && left > 0 ? *out * left / done : 0;
	return TS_OK;
}

static enum ts_status atoms(struct tsim *sim, double *out)
{
	*out = number_of_particles(sim);
	return TS_OK;
}

/* thermo_modify norm yes */
static void divide_by_particles(const struct tsim *sim, double *out)
{
	double n = sim->thermo->norm ? number_of_particles(sim) : 0;

	if (n > 0)
		*out /= n;
}

static enum ts_status ke(struct tsim *sim, double *out)
{
	*out = ts_group_kinetic_energy(sim, 0);
	divide_by_particles(sim, out);
	return TS_OK;
}

static enum ts_status erotate(struct tsim *sim, double *out)
{
	*out = ts_group_all_rotation_energy(sim, 0);
	divide_by_particles(sim, out);
	return TS_OK;
}

static enum ts_status temp(struct tsim *sim, double *out)
{
	double tensor[7];
	bool replaced;

	TS_TRY(ts_standard_value(sim, TS_STANDARD_TEMPERATURE, -1, &replaced, out));
	if (replaced)
		return TS_OK;
	ts_temperature_tensor(sim, 0, NULL, tensor);
	*out = ts_temperature(sim, tensor, &sim->thermo->freedom);
	return TS_OK;
}

static enum ts_status potential_energy(struct tsim *sim, struct ts_energy_parts parts, double *out)
{
	TS_TRY(ts_potential_energy(sim, &parts, out));
	divide_by_particles(sim, out);
	return TS_OK;
}

static enum ts_status pe(struct tsim *sim, double *out)
{
	return potential_energy(sim, (struct ts_energy_parts){ true, true, true }, out);
}

static enum ts_status epair(struct tsim *sim, double *out)
{
	return potential_energy(sim, (struct ts_energy_parts){ .pair = true }, out);
}

static enum ts_status ebond(struct tsim *sim, double *out)
{
	return potential_energy(sim, (struct ts_energy_parts){ .bond = true }, out);
}

/* Potential plus translational kinetic energy; without rotation, as in LAMMPS. */
static enum ts_status etotal(struct tsim *sim, double *out)
{
	double kinetic;

	TS_TRY(pe(sim, out));
	TS_TRY(ke(sim, &kinetic));
	*out += kinetic;
	return TS_OK;
}

/* The displacement of sheared images, within half a length of the box; 0 of a box that is not sheared so. */
static double shear_offset(const struct tsim *sim, int flow, int gradient)
{
	const struct ts_shear *s = &sim->domain->box.shear;
	double length = ts_box_length(&sim->domain->box, flow);

	if (!s->on || s->flow != flow || s->gradient != gradient)
		return 0;
	return s->offset - length * rint(s->offset / length);
}

#define SHEAR_NUMBER(name, flow, gradient)                        \
	static enum ts_status name(struct tsim *sim, double *out) \
	{                                                         \
		*out = shear_offset(sim, flow, gradient);         \
		return TS_OK;                                     \
	}
SHEAR_NUMBER(xy, 0, 1)
SHEAR_NUMBER(xz, 0, 2)
SHEAR_NUMBER(yz, 1, 2)

static enum ts_status zero(struct tsim *sim, double *out)
{
	(void)sim;
	*out = 0;
	return TS_OK;
}

static enum ts_status right_angle(struct tsim *sim, double *out)
{
	(void)sim;
	*out = 90;
	return TS_OK;
}

#define LATTICE_SPACING(d, name)                                  \
	static enum ts_status name(struct tsim *sim, double *out) \
	{                                                         \
		*out = sim->domain->lattice.spacing[d];           \
		return TS_OK;                                     \
	}
LATTICE_SPACING(0, xlat)
LATTICE_SPACING(1, ylat)
LATTICE_SPACING(2, zlat)

static enum ts_status fmax_now(struct tsim *sim, double *out)
{
	const struct ts_particles *p = sim->particles;

	*out = 0;
	for (size_t i = 0; i < p->n; i++)
		for (int d = 0; d < 3; d++)
			*out = fmax(*out, fabs(p->f[i][d]));
	*out = ts_ranks_most(sim, *out);
	return TS_OK;
}

static enum ts_status fnorm(struct tsim *sim, double *out)
{
	const struct ts_particles *p = sim->particles;
	struct ts_exactsum sum = ts_exactsum_start();

	for (size_t i = 0; i < p->n; i++)
		for (int d = 0; d < 3; d++)
			ts_exactsum_add(&sum, p->f[i][d] * p->f[i][d]);
	ts_rank_sums_merge(sim, &sum, 1);
	*out = sqrt(ts_exactsum_value(&sum));
	return TS_OK;
}

static enum ts_status vol(struct tsim *sim, double *out)
{
	*out = 1;
	for (int d = 0; d < sim->dimension; d++)
		*out *= ts_box_length(&sim->domain->box, d);
	return TS_OK;
}

static enum ts_status enthalpy(struct tsim *sim, double *out)
{
	double pressure, volume;

	TS_TRY(ts_keyword_find(sim->tables, "press")->eval(sim, &pressure));
	TS_TRY(vol(sim, &volume));
	volume *= pressure;
	divide_by_particles(sim, &volume);
	TS_TRY(etotal(sim, out));
	*out += volume;
	return TS_OK;
}

static enum ts_status density(struct tsim *sim, double *out)
{
	double mass = ts_group_mass(sim, 0);

	TS_TRY(vol(sim, out));
	*out = *out > 0 ? mass / *out : 0;
	return TS_OK;
}

#define BOX_NUMBERS(d, lo_, hi_, l_)                             \
	static enum ts_status lo_(struct tsim *sim, double *out) \
	{                                                        \
		*out = sim->domain->box.lo[d];                   \
		return TS_OK;                                    \
	}                                                        \
	static enum ts_status hi_(struct tsim *sim, double *out) \
	{                                                        \
		*out = sim->domain->box.hi[d];                   \
		return TS_OK;                                    \
	}                                                        \
	static enum ts_status l_(struct tsim *sim, double *out)  \
	{                                                        \
		*out = ts_box_length(&sim->domain->box, d);      \
		return TS_OK;                                    \
	}
BOX_NUMBERS(0, xlo, xhi, lx)
BOX_NUMBERS(1, ylo, yhi, ly)
BOX_NUMBERS(2, zlo, zhi, lz)

/* clang-format off */
const struct ts_keyword ts_thermo_keywords[] = {
	{ "step", "Step", "", "step counter", TS_KEYWORD_INTEGER | TS_KEYWORD_CLOCK, step },
	{ "elapsed", "Elapsed", "", "steps since the start of the run", TS_KEYWORD_INTEGER | TS_KEYWORD_CLOCK, elapsed },
	{ "elaplong", "Elaplong", "", "steps since the start of the run, or since S of `run N start S`", TS_KEYWORD_INTEGER | TS_KEYWORD_CLOCK, elaplong },
	{ "part", "Part", "", "number of the partition: 0", TS_KEYWORD_INTEGER | TS_KEYWORD_CONSTANT, zero },
	{ "time", "Time", "time", "simulated time", TS_KEYWORD_CLOCK, time_now },
	{ "dt", "Dt", "time", "time step", TS_KEYWORD_CLOCK, dt },
	{ "cpu", "CPU", "s", "wall time since the start of the run", TS_KEYWORD_SUM, cpu },
	{ "tpcpu", "T/CPU", "time/s", "simulated time per second of wall time since the previous row", TS_KEYWORD_SUM, tpcpu },
	{ "spcpu", "S/CPU", "1/s", "steps per second of wall time since the previous row", TS_KEYWORD_SUM, spcpu },
	{ "cpuremain", "CPULeft", "s", "estimated wall time of the rest of the run", TS_KEYWORD_SUM, cpuremain },
	{ "timeremain", "TimeoutLeft", "s", "wall time left before `timer timeout`; 0 without it", TS_KEYWORD_SUM, timeremain },
	{ "cu", "Cu", "1/s", "Cundall number: particles times steps divided by the wall time of the run so "
	  "far", TS_KEYWORD_SUM, cundall },
	{ "atoms", "Atoms", "", "number of particles", TS_KEYWORD_INTEGER | TS_KEYWORD_SUM, atoms },
	{ "ke", "KinEng", "energy", "kinetic energy of translation", TS_KEYWORD_SUM, ke },
	{ "erotate", "RotEng", "energy", "kinetic energy of rotation, of clumps, too", TS_KEYWORD_SUM, erotate },
	{ "pe", "PotEng", "energy", "potential energy, see compute pe", TS_KEYWORD_LISTS, pe },
	{ "etotal", "TotEng", "energy", "pe + ke, without rotation", TS_KEYWORD_LISTS, etotal },
	{ "epair", "E_pair", "energy", "elastic energy of contacts, see compute pe", TS_KEYWORD_LISTS, epair },
	{ "evdwl", "E_vdwl", "energy", "the same as epair", TS_KEYWORD_LISTS, epair },
	{ "emol", "E_mol", "energy", "elastic energy of bonds", TS_KEYWORD_LISTS, ebond },
	{ "ebond", "E_bond", "energy", "the same as emol", TS_KEYWORD_LISTS, ebond },
	{ "enthalpy", "Enthalpy", "energy", "etotal + press vol", TS_KEYWORD_CONTACTS | TS_KEYWORD_LISTS, enthalpy },
	{ "ecouple", "Ecouple", "energy", "energy from thermostats: 0, it is not computed", TS_KEYWORD_CONSTANT, zero },
	{ "econserve", "Econserve", "energy", "etotal + ecouple", TS_KEYWORD_LISTS, etotal },
	{ "ecoul", "E_coul", "energy", "Coulomb energy: 0", TS_KEYWORD_CONSTANT, zero },
	{ "elong", "E_long", "energy", "long-range energy: 0", TS_KEYWORD_CONSTANT, zero },
	{ "etail", "E_tail", "energy", "tail correction beyond a cutoff: 0", TS_KEYWORD_CONSTANT, zero },
	{ "eangle", "E_angle", "energy", "energy of angles: 0", TS_KEYWORD_CONSTANT, zero },
	{ "edihed", "E_dihed", "energy", "energy of dihedrals: 0", TS_KEYWORD_CONSTANT, zero },
	{ "eimp", "E_impro", "energy", "energy of impropers: 0", TS_KEYWORD_CONSTANT, zero },
	{ "angles", "Angles", "", "number of angles: 0", TS_KEYWORD_INTEGER | TS_KEYWORD_CONSTANT, zero },
	{ "dihedrals", "Diheds", "", "number of dihedrals: 0", TS_KEYWORD_INTEGER | TS_KEYWORD_CONSTANT, zero },
	{ "impropers", "Impros", "", "number of impropers: 0", TS_KEYWORD_INTEGER | TS_KEYWORD_CONSTANT, zero },
	{ "temp", "Temp", "temperature", "sum m v^2 / (D (N - 1) k)", 0, temp },
	{ "fmax", "Fmax", "force", "largest component of a force on a particle", TS_KEYWORD_SUM, fmax_now },
	{ "fnorm", "Fnorm", "force", "Euclidean norm of the vector of all forces", TS_KEYWORD_SUM, fnorm },
	{ "vol", "Volume", "volume", "volume of the box", TS_KEYWORD_BOX, vol },
	{ "density", "Density", "density", "mass of all particles divided by the volume of the box", TS_KEYWORD_SUM, density },
	{ "lx", "Lx", "length", "length of the box along x", TS_KEYWORD_BOX, lx },
	{ "ly", "Ly", "length", "length of the box along y", TS_KEYWORD_BOX, ly },
	{ "lz", "Lz", "length", "length of the box along z", TS_KEYWORD_BOX, lz },
	{ "xlo", "Xlo", "length", "lower x of the box", TS_KEYWORD_BOX, xlo },
	{ "xhi", "Xhi", "length", "upper x of the box", TS_KEYWORD_BOX, xhi },
	{ "ylo", "Ylo", "length", "lower y of the box", TS_KEYWORD_BOX, ylo },
	{ "yhi", "Yhi", "length", "upper y of the box", TS_KEYWORD_BOX, yhi },
	{ "zlo", "Zlo", "length", "lower z of the box", TS_KEYWORD_BOX, zlo },
	{ "zhi", "Zhi", "length", "upper z of the box", TS_KEYWORD_BOX, zhi },
	{ "xy", "Xy", "length", "displacement along x of the images across the y faces (fix deform xy)", TS_KEYWORD_SUM, xy },
	{ "xz", "Xz", "length", "displacement along x of the images across the z faces (fix deform xz)", TS_KEYWORD_SUM, xz },
	{ "yz", "Yz", "length", "displacement along y of the images across the z faces (fix deform yz)", TS_KEYWORD_SUM, yz },
	{ "xlat", "Xlat", "length", "lattice spacing", TS_KEYWORD_SUM, xlat },
	{ "ylat", "Ylat", "length", "lattice spacing", TS_KEYWORD_SUM, ylat },
	{ "zlat", "Zlat", "length", "lattice spacing", TS_KEYWORD_SUM, zlat },
	{ "cella", "Cella", "length", "length of the box along x", TS_KEYWORD_SUM, lx },
	{ "cellb", "Cellb", "length", "length of the box along y", TS_KEYWORD_SUM, ly },
	{ "cellc", "Cellc", "length", "length of the box along z", TS_KEYWORD_SUM, lz },
	{ "cellalpha", "CellAlpha", "degrees", "angle of the box: 90", TS_KEYWORD_SUM, right_angle },
	{ "cellbeta", "CellBeta", "degrees", "angle of the box: 90", TS_KEYWORD_SUM, right_angle },
	{ "cellgamma", "CellGamma", "degrees", "angle of the box: 90", TS_KEYWORD_SUM, right_angle },
	{ .name = NULL },
};
