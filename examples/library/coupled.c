/* A press: tsim computes a column of grains, this program the servo that presses on it.
 *
 * The uppermost grain is the ram. In each step the servo reads the force on it and moves it with a
 * velocity in proportion to what is missing to the wanted force F: v = (F - measured)/viscosity. At rest
 * each of the n contacts, springs of stiffness k in a row, is shortened by F/k, so the ram stands at
 * n (d - F/k) above the grain at the bottom.
 *
 *   cc coupled.c $(pkg-config --cflags --libs tsim) -o coupled */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include <tsim.h>

enum { GRAINS = 7, CONTACTS = GRAINS - 1 };

static const double diameter = 0.02385, stiffness = 2.385e4, force = 3.85;

static const char box[] = "units si\n"
			  "boundary f f f\n"
			  "region box block -0.1 0.1 -0.1 0.1 -0.1 0.3 units box\n"
			  "create_box 1 box\n";
static const char physics[] = "pair_style spring/dashpot\n"
			      "pair_coeff * * stiffness ${k} restitution 0.3\n"
			      "fix move grains nve\n"
			      "fix ground bottom freeze\n"
			      "timestep 1e-5\n";

struct press {
	int32_t ram; /* identity of the grain */
	double viscosity;
	double measured;
};

/* At the end of each step: the force is that of this step, the velocity acts in the next. */
static int servo(struct tsim *sim, void *data)
{
	struct press *press = data;
	double f, v, z, dt;

	if (tsim_gather(sim, "fz", &press->ram, &f, 1) || tsim_gather(sim, "z", &press->ram, &z, 1))
		return 1;
	press->measured = f;
	v = -(force - f) / press->viscosity;
	tsim_clock(sim, NULL, NULL, &dt);
	z += v * dt; /* nobody else moves the ram */
	return tsim_scatter(sim, "vz", &press->ram, &v, 1) || tsim_scatter(sim, "z", &press->ram, &z, 1);
}

/* The grains, touching, from the bottom up, and the groups of those that are not free. */
static int make_grains(struct tsim *sim, int32_t *id)
{
	double x[3 * GRAINS] = { 0 }, radius[GRAINS], density[GRAINS];
	unsigned char bottom[GRAINS] = { [0] = 1 }, grains[GRAINS];
	struct tsim_particles made = TSIM_INIT(struct tsim_particles);

	for (int k = 0; k < GRAINS; k++) {
		x[3 * k + 2] = k * diameter;
		radius[k] = diameter / 2;
		density[k] = 2385;
		grains[k] = k < GRAINS - 1;
	}
	made.n = GRAINS;
	made.x = x;
	made.radius = radius;
	made.density = density;
	return tsim_create(sim, &made, id) || tsim_group_set(sim, "bottom", bottom, GRAINS) ||
	       tsim_group_set(sim, "grains", grains, GRAINS);
}

/* The box, then the grains, then what needs their groups. */
static int prepare(struct tsim *sim, struct press *press)
{
	int32_t id[GRAINS];

	if (tsim_text(sim, box, "box") || make_grains(sim, id) || tsim_variable_number(sim, "k", stiffness) ||
	    tsim_text(sim, physics, "physics"))
		return 1;
	press->ram = id[GRAINS - 1];
	press->viscosity = 5 * sqrt(stiffness * 0.017); /* slow against waves in the column */
	return tsim_on_step(sim, TSIM_END_OF_STEP, servo, press);
}

/* Until the force stands still. */
static int run(struct tsim *sim, const struct press *press)
{
	for (int k = 0; k < 1000; k++) {
		if (tsim_step(sim, 200))
			return 1;
		if (fabs(press->measured - force) < 1e-10 * force)
			return 0;
	}
	return 0;
}

static int result(const char *name, double value, double reference, double tolerance)
{
	int ok = fabs(value - reference) <= tolerance * fabs(reference);

	printf("RESULT %s %.6g %.6g %.3g %s\n", name, value, reference, tolerance, ok ? "ok" : "off");
	return !ok;
}

int main(void)
{
	struct tsim *sim = tsim_open();
	struct press press = { 0 };
	double z;
	int bad;

	if (!sim || prepare(sim, &press) || run(sim, &press) || tsim_gather(sim, "z", &press.ram, &z, 1)) {
		fputs(tsim_error(sim), stderr);
		tsim_close(sim);
		return EXIT_FAILURE;
	}
	bad = result("force", press.measured, force, 1e-9);
	bad |= result("height", z, CONTACTS * (diameter - force / stiffness), 1e-9);
	tsim_close(sim);
	return bad ? EXIT_FAILURE : EXIT_SUCCESS;
}
