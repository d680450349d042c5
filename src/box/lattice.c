#include "box/lattice.h"

#include <math.h>
#include <string.h>

#include "math/vec3.h"

#include "base/banned.h"

#define SQRT3 1.7320508075688772
#define SQRT_8_3 1.632993161855452

enum { SC, BCC, FCC, HCP, DIAMOND, SQ, SQ2, HEX, NNAMED };

const char *const ts_lattice_names[] = { "sc",	"bcc", "fcc",  "hcp",	 "diamond", "sq",
					 "sq2", "hex", "none", "custom", NULL };

struct named {
	int dimension;
	double edge[3]; /* edges of the orthogonal cell */
	size_t nbasis;
	double basis[8][3];
};

static const struct named named[NNAMED] = {
	[SC] = { 3, { 1, 1, 1 }, 1, { { 0, 0, 0 } } },
	[BCC] = { 3, { 1, 1, 1 }, 2, { { 0, 0, 0 }, { 0.5, 0.5, 0.5 } } },
	[FCC] = { 3, { 1, 1, 1 }, 4, { { 0, 0, 0 }, { 0.5, 0.5, 0 }, { 0.5, 0, 0.5 }, { 0, 0.5, 0.5 } } },
	[HCP] = { 3,
		  { 1, SQRT3, SQRT_8_3 },
		  4,
		  { { 0, 0, 0 }, { 0.5, 0.5, 0 }, { 0.5, 5. / 6, 0.5 }, { 0, 1. / 3, 0.5 } } },
	[DIAMOND] = { 3,
		      { 1, 1, 1 },
		      8,
		      { { 0, 0, 0 },
			{ 0, 0.5, 0.5 },
			{ 0.5, 0, 0.5 },
			{ 0.5, 0.5, 0 },
			{ 0.25, 0.25, 0.25 },
			{ 0.25, 0.75, 0.75 },
			{ 0.75, 0.25, 0.75 },
			{ 0.75, 0.75, 0.25 } } },
	[SQ] = { 2, { 1, 1, 1 }, 1, { { 0, 0, 0 } } },
	[SQ2] = { 2, { 1, 1, 1 }, 2, { { 0, 0, 0 }, { 0.5, 0.5, 0 } } },
	[HEX] = { 2, { 1, SQRT3, 1 }, 2, { { 0, 0, 0 }, { 0.5, 0.5, 0 } } },
};

int ts_lattice_dimension(int style)
{
	return style >= 0 && style < NNAMED ? named[style].dimension : 0;
}

enum ts_status ts_lattice_add_basis(struct ts_lattice *l, const double point[3])
{
	TS_TRY(TS_GROW(l->basis, l->capacity, l->nbasis + 1));
	memcpy(l->basis[l->nbasis++], point, sizeof *l->basis);
	return TS_OK;
}

enum ts_status ts_lattice_start(struct ts_lattice *l, int style)
{
	const struct named *n = style >= 0 && style < NNAMED ? &named[style] : NULL;

	l->style = style;
	l->constant = 1;
	l->nbasis = 0;
	for (int i = 0; i < 3; i++) {
		l->origin[i] = 0;
		for (int j = 0; j < 3; j++) {
			l->turn[i][j] = i == j;
			l->edge[i][j] = i == j ? (n ? n->edge[i] : 1) : 0;
		}
	}
	for (size_t k = 0; n && k < n->nbasis; k++)
		TS_TRY(ts_lattice_add_basis(l, n->basis[k]));
	ts_lattice_finish(l);
	return TS_OK;
}

void ts_lattice_clear(struct ts_lattice *l)
{
	(void)ts_lattice_start(l, -1); /* cannot fail: no points */
}

double ts_lattice_cell_volume(const struct ts_lattice *l)
{
	double c[3];

	ts_cross(l->edge[1], l->edge[2], c);
	return ts_dot(l->edge[0], c);
}

void ts_lattice_to_space(const struct ts_lattice *l, const double cell[3], double x[3])
{
	double y[3];

	for (int d = 0; d < 3; d++)
		y[d] = l->constant *
		       (l->edge[0][d] * cell[0] + l->edge[1][d] * cell[1] + l->edge[2][d] * cell[2]);
	for (int d = 0; d < 3; d++)
		x[d] = ts_dot(l->turn[d], y) + l->spacing[d] * l->origin[d];
}

void ts_lattice_from_space(const struct ts_lattice *l, const double x[3], double cell[3])
{
	double y[3] = { 0, 0, 0 };

	for (int d = 0; d < 3; d++)
		ts_axpy((x[d] - l->spacing[d] * l->origin[d]) / l->constant, l->turn[d], y);
	for (int k = 0; k < 3; k++)
		cell[k] = ts_dot(l->inverse[k], y);
}

/* The spacings are the lengths of the bounding box of the rotated unit cell. */
static void find_spacing(struct ts_lattice *l)
{
	double lo[3] = { INFINITY, INFINITY, INFINITY }, hi[3] = { -INFINITY, -INFINITY, -INFINITY };

	for (int d = 0; d < 3; d++)
		l->spacing[d] = 0; /* the origin does not matter */
	for (int corner = 0; corner < 8; corner++) {
		double cell[3] = { corner & 1, corner >> 1 & 1, corner >> 2 }, x[3];

		ts_lattice_to_space(l, cell, x);
		for (int d = 0; d < 3; d++) {
			lo[d] = fmin(lo[d], x[d]);
			hi[d] = fmax(hi[d], x[d]);
		}
	}
	ts_sub(hi, lo, l->spacing);
}

void ts_lattice_finish(struct ts_lattice *l)
{
	double volume = ts_lattice_cell_volume(l);

	for (int k = 0; k < 3; k++) {
		ts_cross(l->edge[(k + 1) % 3], l->edge[(k + 2) % 3], l->inverse[k]);
		ts_scale(1 / volume, l->inverse[k], l->inverse[k]);
	}
	find_spacing(l);
}

void ts_lattice_release(struct ts_lattice *l)
{
	ts_free(l->basis);
	*l = (struct ts_lattice){ 0 };
}

/* Restart files of version 1 have a named lattice along the axes. */
static enum ts_status read_version_1(struct ts_lattice *l, struct tsim *sim, struct ts_archive *a)
{
	int32_t style = -1;
	double constant = 1;

	if (ts_archive_has(a, "lattice_style") && ts_archive_has(a, "lattice")) {
		TS_TRY(ts_archive_fixed(a, "lattice_style", TS_SAVED_I32, &style, 1));
		TS_TRY(ts_archive_fixed(a, "lattice", TS_SAVED_F64, &constant, 1));
	}
	if (ts_lattice_start(l, style) != TS_OK)
		return ts_nomem(&sim->error);
	l->constant = constant > 0 ? constant : 1;
	ts_lattice_finish(l);
	return TS_OK;
}

enum ts_status ts_lattice_archive(struct ts_lattice *l, struct tsim *sim, struct ts_archive *a)
{
	size_t capacity = 3 * l->capacity, count = 3 * l->nbasis;
	int32_t style = l->style;

	if (!ts_archive_has(a, "lattice_constant"))
		return read_version_1(l, sim, a);
	TS_TRY(ts_archive_fixed(a, "lattice_style", TS_SAVED_I32, &style, 1));
	TS_TRY(ts_archive_fixed(a, "lattice_constant", TS_SAVED_F64, &l->constant, 1));
	TS_TRY(ts_archive_fixed(a, "lattice_edge", TS_SAVED_F64, l->edge, 9));
	TS_TRY(ts_archive_fixed(a, "lattice_turn", TS_SAVED_F64, l->turn, 9));
	TS_TRY(ts_archive_fixed(a, "lattice_origin", TS_SAVED_F64, l->origin, 3));
	TS_TRY(ts_archive_fixed(a, "lattice_spacing", TS_SAVED_F64, l->spacing, 3));
	TS_TRY(ts_archive_fixed(a, "lattice_inverse", TS_SAVED_F64, l->inverse, 9));
	TS_TRY(ts_archive_array(a, "lattice_basis", TS_SAVED_F64, (void **)(void *)&l->basis, &capacity,
				&count));
	l->style = style;
	l->capacity = capacity / 3;
	l->nbasis = count / 3;
	if (count % 3 == 0 && l->constant > 0 && isfinite(l->constant))
		return TS_OK;
	l->nbasis = 0;
	l->constant = 1;
	return ts_fail(&sim->error, TS_DAMAGED, NULL, "impossible lattice");
}
