/* Command mesh_primitive: writes a file of triangles of a shape given by its sizes. */
#include <stdio.h>

#include "core/sim.h"
#include "io/textfile.h"
#include "math/vec3.h"
#include "mesh/mesh_admit.h"
#include "shape/shape.h"

#include "base/banned.h"

struct state {
	struct ts_shape_sizes shape; /* first: its rows begin here */
	const char *file;
};

/* The digits that give the same number again. */
static enum ts_status write_point(struct ts_textfile *out, const char *before, const double x[3])
{
	return ts_textfile_printf(out, "%s%.17g %.17g %.17g\n", before, x[0] + 0.0, x[1] + 0.0, x[2] + 0.0);
}

static enum ts_status write_stl(struct ts_textfile *out, const struct ts_triangles *soup,
				const struct ts_mesh *m)
{
	TS_TRY(ts_textfile_printf(out, "solid tsim\n"));
	for (size_t t = 0; t < soup->n; t++) {
		const double *n = m->normal[t];

		TS_TRY(ts_textfile_printf(out, " facet normal %g %g %g\n  outer loop\n", n[0], n[1], n[2]));
		for (int k = 0; k < 3; k++)
			TS_TRY(write_point(out, "   vertex ", soup->t[t].v[k]));
		TS_TRY(ts_textfile_printf(out, "  endloop\n endfacet\n"));
	}
	return ts_textfile_printf(out, "endsolid tsim\n");
}

/* Each corner once, as the mesh has it. */
static enum ts_status write_vtk_points(struct ts_textfile *out, const struct ts_triangles *soup,
				       const struct ts_mesh *m)
{
	size_t next = 0;

	TS_TRY(ts_textfile_printf(out, "POINTS %zu double\n", m->nvertices));
	for (size_t c = 0; c < 3 * soup->n; c++)
		if ((size_t)m->vertex[c / 3][c % 3] == next) {
			TS_TRY(write_point(out, "", soup->t[c / 3].v[c % 3]));
			next++;
		}
	return TS_OK;
}

static enum ts_status write_vtk(struct ts_textfile *out, const struct ts_triangles *soup,
				const struct ts_mesh *m)
{
	TS_TRY(ts_textfile_printf(out, "# vtk DataFile Version 3.0\ntsim\nASCII\nDATASET POLYDATA\n"));
	TS_TRY(write_vtk_points(out, soup, m));
	TS_TRY(ts_textfile_printf(out, "POLYGONS %zu %zu\n", soup->n, 4 * soup->n));
	for (size_t t = 0; t < soup->n; t++)
		TS_TRY(ts_textfile_printf(out, "3 %d %d %d\n", m->vertex[t][0], m->vertex[t][1],
					  m->vertex[t][2]));
	return TS_OK;
}

typedef enum ts_status write_fn(struct ts_textfile *out, const struct ts_triangles *soup,
				const struct ts_mesh *m);

static const struct format {
	const char *ending;
	write_fn *write;
} formats[] = {
	{ ".stl", write_stl },
	{ ".stl.gz", write_stl },
	{ ".vtk", write_vtk },
	{ ".vtk.gz", write_vtk },
};

static const struct format *find_format(const char *file)
{
	for (size_t k = 0; k < sizeof formats / sizeof *formats; k++)
		if (ts_ends_with(file, formats[k].ending))
			return &formats[k];
	return NULL;
}

static enum ts_status write_file(struct tsim *sim, const struct state *s, const struct ts_place *where,
				 const struct ts_triangles *soup, const struct ts_mesh *m)
{
	struct ts_textfile out = { 0 };
	enum ts_status status, closed;

	TS_TRY(ts_textfile_open(&out, sim, where, s->file, false));
	status = find_format(s->file)->write(&out, soup, m);
	closed = ts_textfile_close(&out);
	return status == TS_OK ? closed : status;
}

static void print_report(struct tsim *sim, const struct state *s, const struct ts_mesh *m, size_t rim,
			 double chord)
{
	char volume[48] = "";

	if (!rim)
		snprintf(volume, sizeof volume, ", volume %.6g", ts_mesh_volume(m));
	ts_log(&sim->log,
	       "mesh_primitive: %s: %zu triangles, %zu corners, area %.6g%s%s; curved faces within %.3g\n",
	       s->file, m->n, m->nvertices, ts_mesh_area(m), volume, rim ? ", with a rim" : "", chord);
}

static enum ts_status make(struct tsim *sim, const struct state *s, const struct ts_place *where,
			   struct ts_arena *arena, struct ts_triangles *soup, struct ts_mesh *m)
{
	struct ts_mesh_admission how = { .curvature = 0, .curvature_tolerant = true };
	struct ts_mesh_findings found = { 0 };
	struct ts_shape_report report = { 0 };

	soup->file = s->file;
	TS_TRY(ts_shape_make(sim, "mesh_primitive", &s->shape, where, arena, soup, &report));
	how.precision = ts_triangles_precision(soup);
	TS_TRY(ts_mesh_admit(sim, where, &how, soup, m));
	if (ts_mesh_examine(m, 0, &found) != TS_OK)
		return ts_nomem(&sim->error);
	print_report(sim, s, m, found.count[TS_MESH_OPEN], report.chord);
	ts_mesh_findings_release(&found);
	return write_file(sim, s, where, soup, m);
}

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	struct ts_triangles soup = { 0 };
	struct ts_mesh mesh = { 0 };
	struct ts_arena arena = { 0 };
	const struct state *s = state;
	enum ts_status status;

	if (!find_format(s->file))
		return ts_fail(&sim->error, TS_RANGE, where,
			       "mesh_primitive: '%s' should end in .stl or .vtk, or these and .gz", s->file);
	status = make(sim, s, where, &arena, &soup, &mesh);
	ts_mesh_release(&mesh);
	ts_triangles_release(&soup);
	ts_arena_release(&arena);
	return status;
}

static const struct ts_arg args[] = {
	TS_WORD("file", struct state, file, .flags = TS_POSITIONAL | TS_WRITES,
		.help = "file to be written; its ending .stl or .vtk, or these with .gz, tells the format"),
	TS_SHAPE_ARGS,
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_mesh_primitive)
const struct ts_command_style ts_command_mesh_primitive = {
	.style = {
		.name = "mesh_primitive",
		.kind = TS_KIND_COMMAND,
		.summary = "Writes a mesh of a shape given by its sizes: box, hopper, drum, screw and others",
		.doc = "Writes the triangles of a shape to a file. `fix mesh/surface` and related fixes make "
		       "the same mesh, without a file, from the same words after `primitive`; this command is "
		       "for other programs, and to see area and volume, which it prints.\n\n"
		       "Each shape stands upright along z, at the origin of its own coordinates. `base` is "
		       "where this origin is put, `axis` the direction of its z. Its x then points along the "
		       "next axis of the box (y for an axis along x, z for one along y), made perpendicular "
		       "to the axis and rotated about it by `angle`. Shapes along the axes of the box have "
		       "coordinates without rounding, except for the sum with `base`. In a fix the keywords "
		       "scale, move and rotate act on all shapes of the mesh.\n\n"
		       "Corners of triangles lie on the exact surface. A circle of radius R becomes a polygon "
		       "of n segments, which is at most e = R (1 - cos(pi/n)) inside of the circle: 0.0012 R "
		       "for 64 segments. `error` chooses n, a multiple of 4, from e. Area and volume of a "
		       "cylinder are smaller by factors sin(pi/n)/(pi/n) and sin(2 pi/n)/(2 pi/n); for all "
		       "shapes this error falls as 1/n^2. A sphere consists of the faces of an icosahedron, "
		       "each divided into m^2 triangles with m = n/5, which are at most 0.29 R/m^2 inside of "
		       "the sphere.\n\n"
		       "A shape is closed unless parts are `open`; normals point outwards, so that its volume "
		       "is positive. Hoppers are open below and above, and plate and disk are single sheets. "
		       "Triangles are at most 8 times longer than wide on curved surfaces, and 50 times on "
		       "flat ones; a shape whose sizes differ so much that a triangle would have an angle "
		       "below 0.5 degrees is refused, and so are more than 2 million triangles. Shapes that "
		       "are joined by `primitive` may overlap: walls do not mind.\n\n"
		       "Shapes with open ends, `ends no` of a wedge and `periodic yes` of a screw continue "
		       "across the faces of a periodic box whose length is that of the shape.\n\n"
		       "Related: fix mesh/surface, dump mesh/stl.",
		.example = "mesh_primitive drum.stl drum radius 0.15 length 0.3 lifters 8 height 0.02 width "
			   "0.01 axis 0 1 0\n"
			   "mesh_primitive hopper.vtk hopper radius 0.1 outlet 0.02 half_angle 30 height 0.2 "
			   "segments 96\n"
			   "mesh_primitive mill.stl drum radius 0.2 length 0.1 error 1e-4 primitive box 0 0.1 "
			   "-0.01 0.01 0 0.1",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.run = run,
};
