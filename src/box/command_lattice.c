/* Command lattice: defines a lattice for create_atoms and for lengths in lattice units. */
#include "base/axes.h"
#include "core/sim.h"

#include <math.h>

#include "box/domain.h"
#include "box/lattice.h"
#include "math/vec3.h"

#include "base/banned.h"

struct state {
	int style;
	double scale;
	double edge[3][3], origin[3], spacing[3]; /* edge, spacing: NaN if not given */
	struct ts_words orient, basis;
};

/* `orient x 1 1 0`: the crystal direction (1 1 0) points along x. */
struct orient {
	int dim;
	int64_t index[3];
};

static const struct ts_arg orient_rows[] = {
	TS_ENUM("dim", struct orient, dim, ts_axis_names, .flags = TS_POSITIONAL, .help = "dimension"),
	TS_INT("i", struct orient, index[0], .flags = TS_POSITIONAL, .help = "along a1"),
	TS_INT("j", struct orient, index[1], .flags = TS_POSITIONAL, .help = "along a2"),
	TS_INT("k", struct orient, index[2], .flags = TS_POSITIONAL, .help = "along a3"),
	TS_ARGS_END,
};

struct point {
	double x[3];
};

#define COORDINATE(name, k)                                                                    \
	TS_REAL(name, struct point, x[k], .flags = TS_POSITIONAL, .range = TS_WITHIN, .lo = 0, \
		.hi = 0.9999999999999999, .help = "coordinate along an edge, from 0 to below 1")
static const struct ts_arg point_rows[] = {
	COORDINATE("x", 0),
	COORDINATE("y", 1),
	COORDINATE("z", 2),
	TS_ARGS_END,
};

/* Parses one group of n words of a repeated keyword. */
static enum ts_status parse_group(struct tsim *sim, const char *what, const struct ts_arg *rows,
				  struct ts_words words, size_t k, size_t n, const struct ts_place *where,
				  void *out)
{
	struct ts_arena arena = { 0 };
	struct ts_words part = ts_words_from(words, k);
	enum ts_status status;

	if (part.n > n)
		part.n = n;
	status = ts_args_parse(sim, what, rows, part, where, &arena, out);
	ts_arena_release(&arena);
	return status;
}

static enum ts_status set_orientation(struct tsim *sim, const struct state *s, struct ts_lattice *l,
				      const struct ts_place *where)
{
	double cross[3];

	for (size_t k = 0; k < s->orient.n; k += 4) {
		struct orient o = { 0 };

		TS_TRY(parse_group(sim, "lattice: orient", orient_rows, s->orient, k, 4, where, &o));
		for (int j = 0; j < 3; j++)
			l->turn[o.dim][j] = (double)o.index[j];
	}
	for (int d = 0; d < 3; d++)
		if (!(ts_norm(l->turn[d]) > 0) || ts_dot(l->turn[d], l->turn[(d + 1) % 3]) != 0)
			return ts_fail(&sim->error, TS_RANGE, where,
				       "lattice: the directions of orient must be at right angles to each "
				       "other");
	ts_cross(l->turn[0], l->turn[1], cross);
	if (!(ts_dot(cross, l->turn[2]) > 0))
		return ts_fail(&sim->error, TS_RANGE, where,
			       "lattice: the directions of orient must be right-handed: x cross y along z");
	if (sim->dimension == 2 && (l->turn[2][0] != 0 || l->turn[2][1] != 0))
		return ts_fail(&sim->error, TS_RANGE, where,
			       "lattice: with dimension 2 the crystal can be turned about z only");
	for (int d = 0; d < 3; d++)
		ts_scale(1 / ts_norm(l->turn[d]), l->turn[d], l->turn[d]);
	return TS_OK;
}

/* In two dimensions the unit cell is plane: a3 = (0 0 1), and a1, a2 and the basis have no z component. */
static enum ts_status check_plane_cell(struct tsim *sim, const struct ts_lattice *l,
				       const struct ts_place *where)
{
	bool plane = l->edge[0][2] == 0 && l->edge[1][2] == 0 && l->edge[2][0] == 0 && l->edge[2][1] == 0 &&
		     l->edge[2][2] == 1;

	for (size_t k = 0; k < l->nbasis; k++)
		plane = plane && l->basis[k][2] == 0;
	if (plane)
		return TS_OK;
	return ts_fail(&sim->error, TS_RANGE, where,
		       "lattice: with dimension 2, a1, a2 and basis have no z, and a3 is 0 0 1");
}

static enum ts_status set_custom(struct tsim *sim, const struct state *s, struct ts_lattice *l,
				 const struct ts_place *where)
{
	bool any = s->basis.n > 0;

	for (int k = 0; k < 3; k++) {
		any |= !isnan(s->edge[k][0]);
		for (int d = 0; d < 3 && !isnan(s->edge[k][0]); d++)
			l->edge[k][d] = s->edge[k][d];
	}
	if (any && s->style != TS_LATTICE_CUSTOM)
		return ts_fail(&sim->error, TS_SYNTAX, where,
			       "lattice %s: a1, a2, a3 and basis are for the style custom",
			       ts_lattice_names[s->style]);
	for (size_t k = 0; k < s->basis.n; k += 3) {
		struct point p = { { 0 } };

		TS_TRY(parse_group(sim, "lattice: basis", point_rows, s->basis, k, 3, where, &p));
		if (ts_lattice_add_basis(l, p.x) != TS_OK)
			return ts_nomem(&sim->error);
	}
	if (s->style == TS_LATTICE_CUSTOM && !l->nbasis)
		return ts_fail(&sim->error, TS_SYNTAX, where,
			       "lattice custom: no points, expected `basis x y z`");
	if (sim->dimension == 2)
		TS_TRY(check_plane_cell(sim, l, where));
	if (!(ts_lattice_cell_volume(l) > 0))
		return ts_fail(&sim->error, TS_RANGE, where,
			       "lattice: a1, a2, a3 must be right-handed: a1 . (a2 x a3) > 0");
	return TS_OK;
}

/* In lj units the scale is a reduced density: number of points of the cell / its volume. */
static double lattice_constant(const struct tsim *sim, const struct state *s, const struct ts_lattice *l)
{
	if (sim->units != TS_UNITS_LJ || s->style == TS_LATTICE_NONE)
		return s->scale;
	return pow((double)l->nbasis / ts_lattice_cell_volume(l) / s->scale, 1.0 / sim->dimension);
}

static enum ts_status build_lattice(struct tsim *sim, const struct state *s, struct ts_lattice *l,
				    const struct ts_place *where)
{
	int dimension = ts_lattice_dimension(s->style);

	if (dimension && dimension != sim->dimension)
		return ts_fail(&sim->error, TS_STATE, where,
			       "lattice %s has %d dimensions, the simulation has %d",
			       ts_lattice_names[s->style], dimension, sim->dimension);
	if (ts_lattice_start(l, s->style) != TS_OK)
		return ts_nomem(&sim->error);
	TS_TRY(set_custom(sim, s, l, where));
	TS_TRY(set_orientation(sim, s, l, where));
	for (int d = 0; d < 3; d++)
		if (!(s->origin[d] >= 0 && s->origin[d] < 1))
			return ts_fail(&sim->error, TS_RANGE, where,
				       "lattice: origin %g is not from 0 to below 1", s->origin[d]);
	l->constant = lattice_constant(sim, s, l);
	ts_lattice_finish(l);
	for (int d = 0; d < 3; d++) {
		l->origin[d] = s->origin[d];
		if (!isnan(s->spacing[d]))
			l->spacing[d] = s->spacing[d] * l->constant;
	}
	return TS_OK;
}

static enum ts_status define_lattice(struct tsim *sim, void *state, const struct ts_place *where)
{
	struct ts_lattice made = { 0 };
	enum ts_status status = build_lattice(sim, state, &made, where);

	if (status != TS_OK) {
		ts_lattice_release(&made);
		return status;
	}
	ts_lattice_release(&sim->domain->lattice);
	sim->domain->lattice = made;
	ts_log(&sim->log, "Lattice spacing in x,y,z = %g %g %g\n", made.spacing[0], made.spacing[1],
	       made.spacing[2]);
	return TS_OK;
}

#define EDGE(name, k)                                              \
	TS_VEC3(name, struct state, edge[k], .flags = TS_OPTIONAL, \
		.help = "edge of the unit cell in units of the lattice constant (custom)")
static const struct ts_arg args[] = {
	TS_ENUM("style", struct state, style, ts_lattice_names, .flags = TS_POSITIONAL,
		.help = "lattice style"),
	TS_REAL("scale", struct state, scale, .flags = TS_POSITIONAL, .range = TS_POSITIVE, .unit = "length",
		.help = "lattice constant; with units lj the reduced density"),
	TS_VEC3("origin", struct state, origin, .fallback = "0 0 0",
		.help = "shift of the lattice in units of the spacings, each from 0 to below 1"),
	TS_SOME_KEYWORD("orient", struct state, orient, TS_REPEAT,
			.help = "dim i j k: the direction (i j k) of the crystal points along dim, x, y or "
				"z; may be repeated"),
	TS_VEC3("spacing", struct state, spacing, .flags = TS_OPTIONAL, .range = TS_POSITIVE,
		.help = "spacings in units of the lattice constant, instead of the extent of the unit cell"),
	EDGE("a1", 0),
	EDGE("a2", 1),
	EDGE("a3", 2),
	TS_SOME_KEYWORD("basis", struct state, basis, TS_REPEAT,
			.help = "x y z: a point of the unit cell in units of its edges (custom); may be "
				"repeated"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_lattice)
const struct ts_command_style ts_command_lattice = {
	.style = {
		.name = "lattice",
		.kind = TS_KIND_COMMAND,
		.ranks = TS_RANKS_FORMULAS,
		.summary = "defines a lattice",
		.doc = "create_atoms box and create_atoms region place particles on the lattice points\n\n"
		       "  x = R c (n1 a1 + n2 a2 + n3 a3 + basis) + origin\n\n"
		       "with integers n, the lattice constant c and the rotation R given by orient. c is the "
		       "scale; with units lj the scale is a reduced density, and c = (points per cell / cell "
		       "volume / scale)^(1/dimension).\n\n"
		       "The spacings are the extents of the rotated unit cell along x, y and z. Lengths given "
		       "with `units lattice` are multiplied by the spacing of their dimension, lengths with "
		       "`units box` are not. If a command gives neither, the default is box, as in LIGGGHTS, "
		       "but lattice with units lj, as in LAMMPS; a warning is printed where this makes a "
		       "difference. The style none has no points and its spacings are the scale. Without a "
		       "lattice command the spacings are 1.\n\n"
		       "The cells of hex and hcp have the edges 1, sqrt(3) and (hcp) sqrt(8/3). The styles "
		       "sq, sq2 and hex are for dimension 2, the styles sc, bcc, fcc, hcp and diamond for "
		       "dimension 3.",
		.example = "lattice sc 0.002\n"
		       "lattice none 1.0\n"
		       "lattice fcc 0.01 orient x 1 1 0 orient y -1 1 0 orient z 0 0 1\n"
		       "lattice custom 0.01 a1 1 0 0 a2 0.5 0.9 0 a3 0 0 1 basis 0 0 0 basis 0.5 0.5 0.5",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.run = define_lattice,
};
