/* Wavefront OBJ: lines `v x y z` with points and `f i j k ...` with polygons, of which each corner is i,
 * i/j, i//k or i/j/k: the point, counted from 1 or, negative, from the last one back, its texture and its
 * normal. Polygons are split into triangles that share their first corner. All other lines are ignored. */
#include "mesh/mesh_obj.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "base/str.h"

#include "base/banned.h"

struct obj {
	struct ts_scan *s;
	struct ts_triangles *soup;
	double (*point)[3];
	size_t npoints, capacity;
	const char *part; /* name of the last object `o` or group `g` */
};

static enum ts_status read_point(struct obj *o)
{
	static const char *const what[] = { "x of the point", "y of the point", "z of the point" };

	if (TS_GROW(o->point, o->capacity, o->npoints + 1) != TS_OK)
		return ts_nomem(o->s->err);
	for (int k = 0; k < 3; k++) {
		if (!ts_scan_word_in_line(o->s))
			return ts_scan_fail(o->s, TS_DAMAGED, "the point ends before its %c", "xyz"[k]);
		TS_TRY(ts_scan_this_real(o->s, what[k], &o->point[o->npoints][k]));
	}
	o->npoints++;
	return TS_OK;
}

/* Converts the last word to the coordinates of a corner. */
static enum ts_status read_corner(struct obj *o, double *out)
{
	size_t n = 0;
	char text[24];
	int64_t index;

	while (n < o->s->length && o->s->word[n] != '/')
		n++;
	snprintf(text, sizeof text, "%.*s", n < sizeof text ? (int)n : 0, o->s->word);
	if (!ts_parse_int(text, &index) || index == 0)
		return ts_scan_fail(o->s, TS_SYNTAX, "%s is no corner, expected the number of a point",
				    ts_scan_found(o->s).text);
	if (index > 0 ? (uint64_t)index > o->npoints : (uint64_t)-index > o->npoints)
		return ts_scan_fail(o->s, TS_RANGE,
				    "the face needs point %" PRId64 ", but there are %zu so far", index,
				    o->npoints);
	memcpy(out, o->point[index > 0 ? index - 1 : (int64_t)o->npoints + index], 3 * sizeof *out);
	return TS_OK;
}

static enum ts_status read_face(struct obj *o)
{
	struct ts_triangle t = { .solid = o->part, .line = o->s->line };
	int n = 0;

	while (ts_scan_word_in_line(o->s)) {
		if (n > 2)
			memcpy(t.v[1], t.v[2], sizeof t.v[1]);
		TS_TRY(read_corner(o, t.v[n < 2 ? n : 2]));
		if (++n > 2 && ts_triangles_add(o->soup, &t) != TS_OK)
			return ts_nomem(o->s->err);
	}
	if (n < 3)
		return ts_scan_fail(o->s, TS_DAMAGED, "the face has %d corner%s, expected 3 or more", n,
				    n == 1 ? "" : "s");
	return TS_OK;
}

static enum ts_status read_line(struct obj *o)
{
	if (ts_scan_is(o->s, "v"))
		return read_point(o);
	if (ts_scan_is(o->s, "f"))
		return read_face(o);
	if (ts_scan_is(o->s, "o") || ts_scan_is(o->s, "g"))
		o->part = ts_scan_rest(o->s);
	return o->part ? TS_OK : ts_nomem(o->s->err);
}

enum ts_status ts_obj_read(struct ts_scan *s, struct ts_triangles *soup)
{
	struct obj o = { .s = s, .soup = soup, .part = "" };
	enum ts_status status = TS_OK;

	s->comments = true;
	while (status == TS_OK && ts_scan_word(s)) {
		status = ts_scan_check_stop(s);
		if (status == TS_OK)
			status = read_line(&o);
		while (status == TS_OK && ts_scan_word_in_line(s)) /* ignore colours, weights etc. */
			;
	}
	ts_free(o.point);
	return status;
}
