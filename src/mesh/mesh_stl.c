/* STL, stereolithography: https://www.loc.gov/preservation/digital/formats/fdd/fdd000505.shtml
 *
 * Text:	solid NAME
 *		  facet normal nx ny nz
 *		    outer loop vertex x y z  vertex x y z  vertex x y z endloop
 *		  endfacet
 *		  ...
 *		endsolid NAME
 * Binary: 80 bytes of title, the number of triangles (4 bytes), then 50 bytes for each: normal and
 * corners as 12 floats, 2 bytes of attributes; little-endian.
 *
 * Programs differ in case, line ends, blanks and in what follows the last facet, so words are read
 * independently of lines. Normals are ignored: in many files they are zero or opposite to the normal by the
 * order of corners, which is used. */
#include "mesh/mesh_stl.h"

#include <inttypes.h>
#include <math.h>
#include <string.h>

#include "base/str.h"

#include "base/banned.h"

enum { TITLE = 80, HEAD = TITLE + 4, RECORD = 50 };

/* ---- binary ---- */

static uint32_t get_u32(const char *bytes)
{
	const unsigned char *b = (const unsigned char *)bytes;

	return (uint32_t)b[0] | (uint32_t)b[1] << 8 | (uint32_t)b[2] << 16 | (uint32_t)b[3] << 24;
}

static double get_float(const char *bytes)
{
	uint32_t bits = get_u32(bytes);
	float value;

	memcpy(&value, &bits, sizeof value);
	return (double)value;
}

static enum ts_status read_binary(struct ts_scan *s, struct ts_triangles *soup)
{
	uint32_t n = get_u32(s->bytes + TITLE);

	s->binary = true;
	for (uint32_t k = 0; k < n; k++) {
		struct ts_triangle t = { .solid = "" };

		TS_TRY(ts_scan_check_stop(s));
		for (size_t c = 0; c < 9; c++) {
			s->at = HEAD + (size_t)k * RECORD + 12 + 4 * c;
			t.v[c / 3][c % 3] = get_float(s->bytes + s->at);
			if (!isfinite(t.v[c / 3][c % 3]))
				return ts_scan_fail(s, TS_DAMAGED,
						    "%c of corner %zu of triangle %" PRIu32
						    " is no finite number",
						    "xyz"[c % 3], c / 3 + 1, k + 1);
		}
		if (ts_triangles_add(soup, &t) != TS_OK)
			return ts_nomem(s->err);
	}
	return TS_OK;
}

/* ---- text ---- */

/* Skips the normal, in any notation, up to the first vertex. */
static enum ts_status skip_normal(struct ts_scan *s)
{
	while (ts_scan_word(s))
		if (ts_scan_is(s, "outer") || ts_scan_is(s, "vertex"))
			break;
	if (ts_scan_is(s, "outer")) {
		TS_TRY(ts_scan_expect(s, "loop"));
		ts_scan_word(s);
	}
	return TS_OK;
}

/* Reads a facet, whose first word has been read. */
static enum ts_status read_facet(struct ts_scan *s, struct ts_triangle *t)
{
	t->line = s->line;
	TS_TRY(skip_normal(s));
	for (int k = 0; ts_scan_is(s, "vertex"); k++) {
		if (k == 3)
			return ts_scan_fail(s, TS_DAMAGED,
					    "the facet of line %d has more than three corners, but STL is "
					    "made of triangles; export the surface triangulated",
					    t->line);
		TS_TRY(ts_scan_real(s, "x of the corner", &t->v[k][0]));
		TS_TRY(ts_scan_real(s, "y of the corner", &t->v[k][1]));
		TS_TRY(ts_scan_real(s, "z of the corner", &t->v[k][2]));
		ts_scan_word(s);
		if (k < 2 && !ts_scan_is(s, "vertex"))
			return ts_scan_fail(s, TS_DAMAGED,
					    "the facet of line %d has %d corner%s, expected 3, but here is "
					    "%s",
					    t->line, k + 1, k ? "s" : "", ts_scan_found(s).text);
	}
	if (ts_scan_is(s, "endloop"))
		ts_scan_word(s);
	if (ts_scan_is(s, "endfacet"))
		return TS_OK;
	return ts_scan_fail(s, TS_DAMAGED, "the facet of line %d should end with 'endfacet', but here is %s",
			    t->line, ts_scan_found(s).text);
}

static enum ts_status read_text(struct ts_scan *s, struct ts_triangles *soup)
{
	struct ts_triangle t = { .solid = "" };

	s->comments = true;
	while (ts_scan_word(s)) {
		if (ts_scan_is(s, "facet")) {
			TS_TRY(ts_scan_check_stop(s));
			TS_TRY(read_facet(s, &t));
			if (ts_triangles_add(soup, &t) != TS_OK)
				return ts_nomem(s->err);
		} else if (ts_scan_is(s, "solid")) {
			t.solid = ts_scan_rest(s);
			if (!t.solid)
				return ts_nomem(s->err);
		} else if (ts_scan_is(s, "endsolid")) {
			if (!ts_scan_rest(s))
				return ts_nomem(s->err);
		} else {
			return ts_scan_fail(s, TS_DAMAGED,
					    "expected 'facet', 'solid' or 'endsolid', but here is %s",
					    ts_scan_found(s).text);
		}
	}
	return TS_OK;
}

/* Whether the file is text and has a line that begins with `solid` or `facet`. Lines before it are a title
 * or comments: the scan is left before the word. */
static bool find_text(struct ts_scan *s)
{
	struct ts_scan before = *s;

	if (memchr(s->bytes, '\0', s->n < 1024 ? s->n : 1024))
		return false;
	s->comments = true;
	while (ts_scan_word(s)) {
		if (ts_scan_is(s, "solid") || ts_scan_is(s, "facet")) {
			*s = before;
			return true;
		}
		while (ts_scan_word_in_line(s))
			;
		before = *s;
	}
	return false;
}

/* The length of the binary file that begins there; 0: the rest is too short for one. */
static uint64_t length_of_binary(const struct ts_scan *s, uint64_t at)
{
	uint64_t rest = s->n - at, length;

	if (rest < HEAD)
		return 0;
	length = HEAD + (uint64_t)get_u32(s->bytes + at + TITLE) * RECORD;
	return length <= rest ? length : 0;
}

/* Whether what follows the triangles that a binary file counts is more of them, or further files, not data that some
 * programs add. */
static bool has_more_triangles(const struct ts_scan *s, uint64_t at)
{
	uint64_t length;

	if ((s->n - at) % RECORD == 0)
		return true;
	while (at < s->n && (length = length_of_binary(s, at)))
		at += length;
	return at == s->n;
}

/* Binary files may begin with `solid`, too: they are recognised by their length. */
enum ts_status ts_stl_read(struct ts_scan *s, struct ts_triangles *soup)
{
	const struct ts_scan start = *s;
	uint64_t need = s->n < HEAD ? 0 : HEAD + (uint64_t)get_u32(s->bytes + TITLE) * RECORD;

	if (need == s->n && need)
		return read_binary(s, soup);
	if (find_text(s))
		return read_text(s, soup);
	*s = start;
	if (s->n < HEAD)
		return ts_scan_refuse(s, TS_DAMAGED,
				      "'%s' is no STL file: it does not begin with 'solid', and for a binary "
				      "one its %zu bytes are too few",
				      s->file, s->n);
	if (need < s->n && !memchr(s->bytes, '\0', s->n))
		return ts_scan_refuse(s, TS_DAMAGED,
				      "'%s' is no file of triangles that tsim can read: STL (text or "
				      "binary), OBJ (with the ending .obj) or legacy VTK",
				      s->file);
	if (need < s->n && has_more_triangles(s, need))
		return ts_scan_refuse(s, TS_DAMAGED,
				      "'%s' says that it has %" PRIu32 " triangles, but %" PRIu64
				      " bytes with further ones follow: were several binary files joined? "
				      "Give each of them a fix of its own",
				      s->file, get_u32(s->bytes + TITLE), s->n - need);
	if (need < s->n) /* some programs add data of their own */
		return read_binary(s, soup);
	return ts_scan_refuse(s, TS_DAMAGED,
			      "'%s' is cut short, or no STL file: as a binary one it would have %" PRIu32
			      " triangles and %" PRIu64 " bytes, but there are %zu",
			      s->file, get_u32(s->bytes + TITLE), need, s->n);
}
