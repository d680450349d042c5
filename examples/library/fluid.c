/* A fluid that this program computes, coupled to grains of tsim by fix couple/cfd.
 *
 * The "fluid" is a plug that grains slow down: one velocity u, of mass M. Every ten steps the program
 * reads the velocities of the grains, gives each the coefficient of Stokes' drag and the velocity of the
 * fluid, and takes from the fluid what the grains have got of it since. Both go to the velocity of their
 * common momentum, with exp(-t/T), 1/T = K/m (1 + n m/M).
 *
 *   cc fluid.c $(pkg-config --cflags --libs tsim) -o fluid */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include <tsim.h>

enum { GRAINS = 5, EXCHANGES = 200, STEPS = 10 };

static const double drag = 2.385e-3, fluid_mass = 3.5e-3;

static const char grains[] = "units si\n"
			     "boundary p p p\n"
			     "region box block 0 0.1 0 0.1 0 0.1 units box\n"
			     "create_box 1 box\n"
			     "create_atoms 1 single 0.01 0.03 0.05 units box\n"
			     "create_atoms 1 single 0.03 0.05 0.07 units box\n"
			     "create_atoms 1 single 0.05 0.07 0.09 units box\n"
			     "create_atoms 1 single 0.07 0.09 0.01 units box\n"
			     "create_atoms 1 single 0.09 0.01 0.03 units box\n"
			     "set group all diameter 0.005 density 2500\n"
			     "fix cfd all couple/cfd couple_every 10 mpi\n"
			     "fix drag all couple/cfd/force/implicit\n"
			     "fix move all nve/sphere\n"
			     "timestep 1e-5\n";

/* The same number for all grains. */
static int give(struct tsim *sim, const char *name, double value)
{
	double all[GRAINS];

	for (int k = 0; k < GRAINS; k++)
		all[k] = value;
	return tsim_column_write(sim, name, all, GRAINS);
}

static int momentum_of(struct tsim *sim, double *momentum)
{
	double v[GRAINS], m[GRAINS];

	if (tsim_column_read(sim, "vx", v, GRAINS) || tsim_column_read(sim, "mass", m, GRAINS))
		return 1;
	*momentum = 0;
	for (int k = 0; k < GRAINS; k++)
		*momentum += m[k] * v[k];
	return 0;
}

static int flow(struct tsim *sim, double *u)
{
	double before, after;

	if (momentum_of(sim, &before) || give(sim, "Ksl", drag) || give(sim, "uf[1]", *u) ||
	    tsim_step(sim, STEPS) || momentum_of(sim, &after))
		return 1;
	*u -= (after - before) / fluid_mass;
	return 0;
}

int main(void)
{
	struct tsim *sim = tsim_open();
	double u = 1, m, v, dt, common, rate, expected;
	int bad = !sim || tsim_text(sim, grains, "grains") || tsim_value(sim, "mass(all)", &m);

	for (int k = 0; k < EXCHANGES && !bad; k++)
		bad = flow(sim, &u);
	bad = bad || tsim_value(sim, "vx[1]", &v);
	if (bad) {
		fprintf(stderr, "%s\n", sim ? tsim_error(sim) : "out of memory");
		return EXIT_FAILURE;
	}
	tsim_clock(sim, NULL, NULL, &dt);
	common = fluid_mass / (fluid_mass + m);
	rate = drag * GRAINS / m * (1 + m / fluid_mass);
	expected = common * (1 - exp(-rate * EXCHANGES * STEPS * dt));
	printf("grains %.6f, expected %.6f; fluid %.6f; momentum %.12f of the first\n", v, expected, u,
	       (m * v + fluid_mass * u) / fluid_mass);
	tsim_close(sim);
	return fabs(v - expected) < 1e-3 * expected && fabs(m * v + fluid_mass * u - fluid_mass) < 1e-12
		       ? EXIT_SUCCESS
		       : EXIT_FAILURE;
}
