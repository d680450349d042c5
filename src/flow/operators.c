#include "flow/operators.h"

#include "base/alloc.h"

#include "base/banned.h"

enum { NARRAYS = 10 }; /* number of arrays of a line */

/* Weights of the quadratic Lagrange polynomial through points x[0..2] at y. */
static void lagrange_weights(const double x[3], double y, double weight[3])
{
	for (int k = 0; k < 3; k++) {
		int a = (k + 1) % 3, b = (k + 2) % 3;

		weight[k] = (y - x[a]) * (y - x[b]) / ((x[k] - x[a]) * (x[k] - x[b]));
	}
}

/* point: coordinates of the values; side[m]: coordinate of the side between point[m - 1] and point[m];
 * low, high: lowest and highest index of the points. */
static void make_line(struct ts_operator_line *line, const double *point, const double *side, int low,
		      int high, double **memory)
{
	double *array[NARRAYS];

	for (int k = 0; k < NARRAYS; k++, *memory += high - low + 1)
		array[k] = *memory - low;
	for (int m = low + 1; m < high; m++) {
		double width = side[m + 1] - side[m];

		array[0][m] = 1 / width;
		array[1][m] = 1 / (width * (point[m] - point[m - 1]));
		array[2][m] = 1 / (width * (point[m + 1] - point[m]));
	}
	for (int m = low + 1; m <= high; m++)
		array[3][m] = (point[m] - side[m]) / (point[m] - point[m - 1]);
	for (int m = low + 2; m <= high; m++) {
		double weight[3];

		lagrange_weights((const double[]){ point[m - 2], point[m - 1], point[m] }, side[m], weight);
		for (int k = 0; k < 3; k++)
			array[4 + k][m] = weight[k];
		if (m < high) /* no flow enters from beyond the last point */
			lagrange_weights((const double[]){ point[m + 1], point[m], point[m - 1] }, side[m],
					 weight);
		for (int k = 0; k < 3 && m < high; k++)
			array[7 + k][m] = weight[k];
	}
	*line = (struct ts_operator_line){ array[0],
					   array[1],
					   array[2],
					   array[3],
					   { array[4], array[5], array[6] },
					   { array[7], array[8], array[9] } };
}

enum ts_status ts_operators_make(struct ts_operators *operators, const struct ts_grid *grid)
{
	size_t total = 0;
	double *memory;

	for (int d = 0; d < 3; d++)
		total += (2 * NARRAYS + 2) * (size_t)(grid->n[d] + 2 * grid->ghosts[d] + 2);
	operators->memory = memory = ts_alloc(total, sizeof *memory);
	if (!memory)
		return TS_NOMEM;
	for (int d = 0; d < grid->dimensions; d++) {
		int g = grid->ghosts[d], n = grid->n[d], length = n + 2 * g + 1;
		double *centre = memory + g, *mass = memory + length + g;

		memory += 2 * length;
		make_line(&operators->centred[d], grid->centre[d], grid->face[d], -g, n + g - 1, &memory);
		/* The sides of the volume around face m are centres m - 1 and m. */
		for (int m = -g + 1; m <= n + g; m++)
			centre[m] = grid->centre[d][m - 1];
		for (int m = -g + 1; m < n + g; m++)
			mass[m] = 0.5 * grid->width[d][m - 1] / grid->gap[d][m];
		/* Face n is an unknown at an open face, where flow may enter through the side beyond it. */
		make_line(&operators->staggered[d], grid->face[d], centre, -g, n + g, &memory);
		operators->mass[d] = mass;
	}
	return TS_OK;
}

void ts_operators_release(struct ts_operators *operators)
{
	ts_free(operators->memory);
	*operators = (struct ts_operators){ 0 };
}
