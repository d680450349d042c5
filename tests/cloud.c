#include "cloud.h"

const double CLOUD_BOX = 0.11;
static const double SPACING = 0.0261;

static double noise(int *count)
{
	/* multiples of the golden ratio: spread evenly, no two alike */
	double t = 0.61803398874989485 * ++*count;

	return 2 * (t - floor(t)) - 1;
}

struct cloud cloud_start(void)
{
	struct cloud c;
	int count = 0;

	for (int i = 0; i < CLOUD; i++) {
		int cell[3] = { i % CLOUD_EDGE, i / CLOUD_EDGE % CLOUD_EDGE, i / CLOUD_EDGE / CLOUD_EDGE };

		c.r[i] = 0.0101 + 0.0019 * noise(&count);
		c.m[i] = 0.013 + 0.009 * noise(&count);
		for (int k = 0; k < 3; k++) {
			c.x[k][i] = SPACING * (cell[k] - 0.5 * (CLOUD_EDGE - 1)) + 5e-4 * noise(&count);
			c.v[k][i] = -10 * c.x[k][i] + 0.4 * noise(&count);
		}
	}
	return c;
}

struct tsim *cloud_open(const char *boundary, const char *options, const char *integrator, struct cloud start)
{
	double b = CLOUD_BOX / 2;
	struct tsim *sim = deck_open("units si\n"
				     "boundary %s\n"
				     "region box block %g %g %g %g %g %g units box\n"
				     "create_box 1 box\n"
				     "neighbor 0.004 bin\n"
				     "pair_style spring/dashpot %s\n"
				     "pair_coeff * * stiffness 2.385e4 restitution 0.63\n"
				     "fix move all %s\n"
				     "timestep 1.1e-5",
				     boundary, -b, b, -b, b, -b, b, options, integrator);

	for (int i = 0; i < CLOUD; i++)
		deck(sim,
		     "create_atoms 1 single %.17g %.17g %.17g\n"
		     "set atom %d diameter %.17g mass %.17g vx %.17g vy %.17g vz %.17g",
		     start.x[0][i], start.x[1][i], start.x[2][i], i + 1, 2 * start.r[i], start.m[i],
		     start.v[0][i], start.v[1][i], start.v[2][i]);
	deck(sim, "run 0");
	return sim;
}

struct cloud cloud_read(struct tsim *sim, int skip)
{
	static const char *const names[2][3] = { { "x", "y", "z" }, { "vx", "vy", "vz" } };
	struct cloud c;

	for (int k = 0; k < 3; k++) {
		deck_column(sim, names[0][k], c.x[k], CLOUD, skip);
		deck_column(sim, names[1][k], c.v[k], CLOUD, skip);
	}
	deck_column(sim, "mass", c.m, CLOUD, skip);
	deck_column(sim, "radius", c.r, CLOUD, skip);
	return c;
}
