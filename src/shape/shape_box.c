/* Shapes with flat faces only: box, plate. */
#include <math.h>

#include "shape/internal.h"
#include "shape/lathe.h"

#include "base/banned.h"

#define BOUND(k, name_, help_)                                                                        \
	TS_REAL(name_, struct ts_shape_sizes, box.bound[k], .flags = TS_POSITIONAL, .unit = "length", \
		.help = help_)

const struct ts_arg ts_shape_box_args[] = {
	BOUND(0, "xlo", "lower x"),
	BOUND(1, "xhi", "upper x"),
	BOUND(2, "ylo", "lower y"),
	BOUND(3, "yhi", "upper y"),
	BOUND(4, "zlo", "lower z"),
	BOUND(5, "zhi", "upper z"),
	TS_SOME_KEYWORD("open", struct ts_shape_sizes, box.open, 0,
			.help = "faces that are left out: xlo, xhi, ylo, yhi, zlo, zhi"),
	TS_ARGS_END,
};

const struct ts_arg ts_shape_plate_args[] = {
	TS_SHAPE_LENGTH("length", plate.length, "side along x"),
	TS_SHAPE_LENGTH("width", plate.width, "side along y"),
	TS_ARGS_END,
};

/* Bit k: face xlo, xhi, ylo ... is left out. */
static unsigned open_faces(struct ts_facets *f, const struct ts_words *words)
{
	unsigned open = 0;

	for (size_t k = 0; k < words->n; k++) {
		struct ts_suggest suggest = ts_suggest_start(words->word[k].text);
		unsigned face = 0;

		for (int i = 0; i < 6; i++) {
			ts_suggest_try(&suggest, ts_shape_box_args[i].name);
			if (ts_streq(words->word[k].text, ts_shape_box_args[i].name))
				face = 1U << i;
		}
		if (!face)
			ts_facets_fail(f, TS_UNKNOWN, "%s: `open` has no face '%s'%s", f->name,
				       words->word[k].text, ts_suggest_text(&suggest));
		open |= face;
	}
	if (open == 077)
		ts_facets_fail(f, TS_RANGE, "%s: all faces are open", f->name);
	return open;
}

/* Face 2 d + side: normal to axis d, at its lower or upper end. */
static void add_face(struct ts_facets *f, const double bound[6], const int n[3], int face)
{
	int d = face / 2, u = (d + 1) % 3, v = (d + 2) % 3;
	double corner[4][3];

	for (int k = 0; k < 4; k++) {
		corner[k][d] = bound[face];
		corner[k][u] = bound[2 * u + (k == 1 || k == 2)];
		corner[k][v] = bound[2 * v + (k > 1)];
	}
	f->reversed = face % 2 == 0;
	ts_facets_patch(f, (const double(*)[3])corner, n[u], n[v]);
	f->reversed = false;
}

void ts_shape_box(struct ts_facets *f, const struct ts_shape_sizes *s)
{
	const double *b = s->box.bound;
	unsigned open = open_faces(f, &s->box.open);
	double least = fmin(b[1] - b[0], fmin(b[3] - b[2], b[5] - b[4]));
	int n[3];

	if (!(least > 0)) {
		ts_facets_fail(f, TS_RANGE, "%s: from %g to %g, %g to %g, %g to %g has no volume", f->name,
			       b[0], b[1], b[2], b[3], b[4], b[5]);
		return;
	}
	for (int d = 0; d < 3; d++)
		n[d] = ts_facets_count(f, b[2 * d + 1] - b[2 * d], least, TS_LATHE_FLAT_ASPECT);
	for (int face = 0; face < 6; face++)
		if (!(open & 1U << face))
			add_face(f, b, n, face);
}

void ts_shape_plate(struct ts_facets *f, const struct ts_shape_sizes *s)
{
	double a = s->plate.length / 2, b = s->plate.width / 2;
	const double corner[4][3] = { { -a, -b, 0 }, { a, -b, 0 }, { a, b, 0 }, { -a, b, 0 } };

	ts_facets_patch(f, corner, ts_facets_count(f, 2 * a, 2 * b, TS_LATHE_FLAT_ASPECT),
			ts_facets_count(f, 2 * b, 2 * a, TS_LATHE_FLAT_ASPECT));
}
