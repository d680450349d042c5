/* Readers of mesh files: what programs really write, and what is broken. */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <zlib.h>

#include "asserts.h"
#include "base/status.h"
#include "base/str.h"
#include "mesh/mesh_read.h"

static struct ts_error err;
static struct ts_pool *pool;
static struct ts_triangles soup;

static void start(void)
{
	err = (struct ts_error){ 0 };
	pool = ts_pool_new();
	ck_assert_ptr_nonnull(pool);
}

static void stop(void)
{
	ts_triangles_release(&soup);
	ts_pool_free(pool);
}

static void expect_n(const char *name, const char *bytes, size_t size, size_t n)
{
	ts_triangles_release(&soup);
	ts_mesh_parse(&soup, &err, pool, name, bytes, size);
	ck_assert_str_eq(err.message, "");
	ck_assert_uint_eq(soup.n, n);
}

static void expect(const char *name, const char *text, size_t n)
{
	expect_n(name, text, strlen(text), n);
}

static void corner(size_t t, int k, double x, double y, double z)
{
	ck_assert_double_eq(soup.t[t].v[k][0], x);
	ck_assert_double_eq(soup.t[t].v[k][1], y);
	ck_assert_double_eq(soup.t[t].v[k][2], z);
}

/* line 0: the file has no lines, or the message is about all of it */
static void refuse_n(const char *name, const char *bytes, size_t size, int line, const char *message)
{
	ts_error_clear(&err);
	ts_triangles_release(&soup);
	ck_assert_int_ne(ts_mesh_parse(&soup, &err, pool, name, bytes, size), TS_OK);
	ck_assert_msg(strstr(err.message, message), "%s: %s", bytes, err.message);
	ck_assert_int_eq(err.place.line, line);
	ck_assert_ptr_nonnull(strstr(err.place.file, name));
}

static void refuse(const char *name, const char *text, int line, const char *message)
{
	refuse_n(name, text, strlen(text), line, message);
}

#define FACET                                                                                    \
	"facet normal 0 0 1\n outer loop\n  vertex 2.385 0 0\n  vertex 2.385 1.7 0\n  vertex 0 " \
	"1.7 -0.31\n endloop\nendfacet\n"

START_TEST(stl_text)
{
	expect("a.stl", "solid lid\n" FACET FACET "endsolid lid\n", 2);
	corner(0, 0, 2.385, 0, 0);
	corner(1, 2, 0, 1.7, -0.31);
	ck_assert_str_eq(soup.t[1].solid, "lid");
	ck_assert_int_eq(soup.t[0].line, 2);
	ck_assert_int_eq(soup.t[1].line, 9);
	/* several solids, names with blanks and signs, no end */
	expect("a.stl", "solid a b#c\n" FACET "endsolid\n\n solid\n" FACET "solid z\r\n" FACET, 3);
	ck_assert_str_eq(soup.t[0].solid, "a b#c");
	ck_assert_str_eq(soup.t[1].solid, "");
	ck_assert_str_eq(soup.t[2].solid, "z");
	/* other case, DOS and Macintosh lines, exponents, tabs, a byte order mark, a comment */
	expect("a.stl",
	       "\xef\xbb\xbfSOLID X\r\n\tFACET NORMAL -1.0E+000 nan 0\r\n OUTER LOOP\r\n VERTEX 1.25e-001 "
	       "+2.5E+001 -.5\r\nVERTEX 1.D0 2.d-1 3\r\nVertex 4 5 6 # peak\r\nENDLOOP ENDFACET\r\nENDSOLID "
	       "X",
	       1);
	corner(0, 0, 0.125, 25, -0.5);
	corner(0, 1, 1, 0.2, 3);
	expect("a.stl",
	       "solid\rfacet normal 0 0 1\router loop\rvertex 0 0 0\rvertex 1 0 0\rvertex 0 1 "
	       "0\rendloop\rendfacet\rendsolid\r",
	       1);
	ck_assert_int_eq(soup.t[0].line, 2);
	/* neither a head nor loops nor normals */
	expect("a.stl", "facet vertex 0 0 0 vertex 1 0 0 vertex 0 1 0 endfacet", 1);
}
END_TEST

START_TEST(stl_text_broken)
{
	refuse("a.stl", "", 0, "too few");
	refuse("a.stl", "solid x\nendsolid x\n", 0, "no triangles");
	refuse("a.stl", "solid x\n" FACET "facet normal 0 0 1\n outer loop\n vertex 0 0 0\n", 12,
	       "the facet of line 9 has 1 corner, expected 3, but here is the end of the file");
	refuse("a.stl", "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0\nvertex 1 0 0\n", 5,
	       "z of the corner should be a number, but here is 'vertex'");
	refuse("a.stl", "solid\nfacet normal 0 0 1\nouter loop\nvertex 0,5 0 1\n", 4,
	       "x of the corner should be a number, but here is '0,5'");
	refuse("a.stl",
	       "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nvertex 0 1 "
	       "0\n",
	       7, "more than three corners");
	refuse("a.stl", "solid\n" FACET "shell\n", 9, "but here is 'shell'");
	refuse("a.stl", "solid\nfacet normal 0 0 1\nouter circle\n", 3, "expected 'loop'");
	refuse("a.stl", "solid\nfacet normal 0 0 1\nvertex 0 0 nan\n", 3, "'nan'");
	refuse("a.stl", "solid\nfacet normal 0 0 1\nvertex 0 0 1e999\n", 3, "'1e999'");
	refuse("a.stl", "<html><body>404</body>", 0, "no STL file");
	refuse("a.stl",
	       "<html><body>The page that you asked for is not where it was, so here is some text, which is "
	       "much longer than a binary head would be, but no file of triangles at all",
	       0, "cut short, or no STL file");
}
END_TEST

static void put_float(char *to, double value)
{
	float f = (float)value;
	uint32_t bits;

	memcpy(&bits, &f, 4);
	for (int k = 0; k < 4; k++)
		to[k] = (char)(bits >> (8 * k) & 255);
}

/* Two triangles as binary STL; returns the size. */
static size_t binary_stl(char *to, const char *title)
{
	memset(to, 0, 184);
	memcpy(to, title, strlen(title));
	to[80] = 2;
	for (int t = 0; t < 2; t++)
		for (int k = 0; k < 9; k++)
			put_float(to + 84 + 50 * t + 12 + 4 * k, 0.25 * k + 10 * t);
	return 184;
}

START_TEST(stl_binary)
{
	char bytes[256] = { 0 };
	size_t n = binary_stl(bytes, "made by hand");

	expect_n("b.stl", bytes, n, 2);
	corner(1, 2, 11.5, 11.75, 12);
	ck_assert_int_eq(soup.t[1].line, 0);
	expect_n("b.stl", bytes, n + 30, 2); /* more behind it */
	binary_stl(bytes, "solid facet of many lies");
	expect_n("b.stl", bytes, n, 2);
	expect_n("b.stl", bytes, n + 30, 2);
	refuse_n("b.stl", bytes, n - 1, 0, "2 triangles and 184 bytes, but there are 183");
	refuse_n("b.stl", bytes, 84, 0, "2 triangles and 184 bytes, but there are 84");
	put_float(bytes + 84 + 50 + 12 + 16, (double)INFINITY);
	refuse_n("b.stl", bytes, n, 0, "y of corner 2 of triangle 2 is no finite number");
	ck_assert_str_eq(err.place.file, "b.stl, byte 162");
	binary_stl(bytes, "none");
	bytes[80] = 0;
	refuse_n("b.stl", bytes, 84, 0, "no triangles");
}
END_TEST

START_TEST(obj)
{
	expect("c.obj",
	       "# cube\nmtllib x.mtl\no box\nv 0 0 0\nv 1 0 0 1.0\nv 1 1.5 0 0.1 0.2 0.3\nv 0 1.5 0\n"
	       "vt 0 0\nvn 0 0 1\ns off\nf 1 2 3\nf 1/1 2/1 3/1\ng side\nf 1//1 3//1 4//1\nf -4/1/1 -3/1/1 "
	       "-2/1/1 -1/1/1\nl 1 2\n",
	       5);
	corner(0, 2, 1, 1.5, 0);
	corner(2, 2, 0, 1.5, 0);
	corner(3, 2, 1, 1.5, 0);
	corner(4, 0, 0, 0, 0);
	corner(4, 1, 1, 1.5, 0);
	corner(4, 2, 0, 1.5, 0);
	ck_assert_str_eq(soup.t[0].solid, "box");
	ck_assert_str_eq(soup.t[4].solid, "side");
	ck_assert_int_eq(soup.t[4].line, 15);
	refuse("c.obj", "v 0 0 0\nv 1 0 0\nf 1 2 3\n", 3, "needs point 3, but there are 2 so far");
	refuse("c.obj", "v 0 0 0\nf 1 -2 3\n", 2, "needs point -2");
	refuse("c.obj", "v 0 0 0\nf 0 1 1\n", 2, "'0' is no corner");
	refuse("c.obj", "v 0 0 0\nf a/1 1 1\n", 2, "'a/1' is no corner");
	refuse("c.obj", "v 0 0 0\nf 1 1\n", 2, "2 corners, expected 3 or more");
	refuse("c.obj", "v 0 0\nf 1 1 1\n", 1, "ends before its z");
	refuse("c.obj", "v 0 0 x\n", 1, "'x'");
	refuse("c.obj", "v 0 0 0\n", 0, "no triangles");
}
END_TEST

#define HEAD(form, set) "# vtk DataFile Version 3.0\na plate # 7\n" form "\nDATASET " set "\n"
#define POINTS "POINTS 5 float\n0 0 0 1 0 0\n1 1.5 0 0 1.5 0\n7 7 7\n"

START_TEST(vtk_text)
{
	expect("d.vtk",
	       HEAD("ASCII", "POLYDATA") POINTS "POLYGONS 2 9\n3 0 1 2\n4 0 1 2 3\nCELL_DATA 2\n"
						"SCALARS x float\n...\n",
	       3);
	corner(2, 1, 1, 1.5, 0);
	corner(2, 2, 0, 1.5, 0);
	ck_assert_int_eq(soup.t[2].line, 11);
	/* strips turn round; a pixel counts its corners row by row; points and lines are no surface */
	expect("d.vtk", HEAD("ASCII", "POLYDATA") POINTS "TRIANGLE_STRIPS 1 5\n4 0 1 3 2\n", 2);
	corner(1, 0, 1, 0, 0);
	corner(1, 1, 1, 1.5, 0);
	corner(1, 2, 0, 1.5, 0);
	expect("d.vtk",
	       HEAD("ASCII", "UNSTRUCTURED_GRID") POINTS
	       "CELLS 4 14\n3 0 1 2\n4 0 1 3 2\n2 0 1\n1 4\nCELL_TYPES 4\n5 8 3 1\n",
	       3);
	corner(1, 2, 1, 1.5, 0);
	/* version 5 */
	expect("d.vtk",
	       "# vtk DataFile Version 5.1\nvtk output\nASCII\nDATASET POLYDATA\nFIELD FieldData 1\nTime 1 1 "
	       "double\n0.5\n" POINTS
	       "METADATA\nINFORMATION 1\nNAME L2 LOCATION x\nDATA 2\n\nPOLYGONS 3 7\nOFFSETS vtktypeint64\n0 "
	       "3 7\nCONNECTIVITY vtktypeint64\n0 1 2 0 1 2 3\n",
	       3);
	corner(2, 2, 0, 1.5, 0);
}
END_TEST

START_TEST(vtk_broken)
{
	refuse("d.vtk", "# vtk DataFile Version 3.0\nt\nascii?\n", 3, "ASCII or BINARY");
	refuse("d.vtk", HEAD("ASCII", "RECTILINEAR_GRID"), 4, "'RECTILINEAR_GRID'");
	refuse("d.vtk", HEAD("ASCII", "POLYDATA") "POINTS 3 floot\n", 5, "'floot' is no type");
	refuse("d.vtk", HEAD("ASCII", "POLYDATA") "POINTS 3000000 float\n0 0 0", 5, "9000000 numbers");
	refuse("d.vtk", HEAD("ASCII", "POLYDATA") "POINTS 1 float\n0 0\nPOLYGONS", 7, "'POLYGONS'");
	refuse("d.vtk", HEAD("ASCII", "POLYDATA") POINTS "POLYGONS 1 4\n3 0 1 5\n", 10, "is 5");
	refuse("d.vtk", HEAD("ASCII", "POLYDATA") POINTS "POLYGONS 1 4\n4 0 1 2 3\n", 10, "is 4");
	refuse("d.vtk", HEAD("ASCII", "POLYDATA") POINTS "POLYGONS 9 4\n4 0 1 2 3\n", 9, "9 cells");
	refuse("d.vtk", HEAD("ASCII", "POLYDATA") POINTS "POLYGONS 1 3\n2 0 1\n", 0, "2 corners");
	refuse("d.vtk", HEAD("ASCII", "POLYDATA") POINTS "PLANES 1 4\n", 9, "'PLANES'");
	refuse("d.vtk", HEAD("ASCII", "UNSTRUCTURED_GRID") POINTS "CELLS 1 4\n3 0 1 2\n", 0, "CELL_TYPES");
	refuse("d.vtk", HEAD("ASCII", "UNSTRUCTURED_GRID") POINTS "CELLS 1 4\n3 0 1 2\nCELL_TYPES 2\n5 5", 11,
	       "1 cells, but 2 types");
	refuse("d.vtk", HEAD("ASCII", "UNSTRUCTURED_GRID") POINTS "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\n",
	       0, "type 10, which is no plane surface");
	refuse("d.vtk",
	       "# vtk DataFile Version 5.1\nt\nASCII\nDATASET POLYDATA\n" POINTS
	       "POLYGONS 2 3\nOFFSETS int\n0 2\nCONNECTIVITY int\n0 1 2\n",
	       11, "the offsets end at 2, but there are 3 corners");
}
END_TEST

static size_t put(char *to, size_t at, const char *text)
{
	memcpy(to + at, text, strlen(text));
	return at + strlen(text);
}

/* Most significant byte first. */
static size_t put_big(char *to, size_t at, uint64_t bits, size_t size)
{
	for (size_t k = 0; k < size; k++)
		to[at + k] = (char)(bits >> (8 * (size - 1 - k)) & 255);
	return at + size;
}

static size_t put_double(char *to, size_t at, double value)
{
	uint64_t bits;

	memcpy(&bits, &value, 8);
	return put_big(to, at, bits, 8);
}

START_TEST(vtk_binary)
{
	char bytes[1024];
	size_t n = put(bytes, 0, HEAD("BINARY", "UNSTRUCTURED_GRID") "POINTS 4 double\n"), types;

	for (int k = 0; k < 12; k++)
		n = put_double(bytes, n, 0.35 * k);
	n = put(bytes, n, "\nCELLS 1 5\n");
	n = put_big(bytes, n, 4, 4);
	for (unsigned k = 0; k < 4; k++)
		n = put_big(bytes, n, k, 4);
	n = put(bytes, n, "\nCELL_TYPES 1\n");
	types = n;
	n = put_big(bytes, n, 9, 4);
	expect_n("e.vtk", bytes, n, 2);
	corner(1, 2, 0.35 * 9, 0.35 * 10, 0.35 * 11);
	ck_assert_int_eq(soup.t[0].line, 0);
	refuse_n("e.vtk", bytes, n - 2, 0, "should follow 1 numbers");
	put_big(bytes, types, UINT32_MAX, 4);
	refuse_n("e.vtk", bytes, n, 0, "the type of a cell is -1");
	put_big(bytes, types - 4 - strlen("\nCELL_TYPES 1\n"), 4, 4);
	refuse_n("e.vtk", bytes, n, 0, "the number of a point is 4, expected an integer from 0 to 3");
	ck_assert_ptr_nonnull(strstr(err.place.file, "e.vtk, byte "));
}
END_TEST

START_TEST(compressed_files)
{
	static const char text[] = "solid x\n" FACET "endsolid\n";
	gzFile gz = gzopen("check_mesh_files.stl.gz", "wb");
	struct ts_place where = { .file = "in.x", .line = 3 };

	ck_assert_ptr_nonnull(gz);
	gzwrite(gz, text, sizeof text - 1);
	gzclose(gz);
	ck_assert_int_eq(ts_mesh_read(&soup, NULL, &err, pool, &where, "check_mesh_files.stl.gz"), TS_OK);
	ck_assert_uint_eq(soup.n, 1);
	remove("check_mesh_files.stl.gz");
	ck_assert_int_eq(ts_mesh_read(&soup, NULL, &err, pool, &where, "check_mesh_files.stl.gz"), TS_IO);
	ck_assert_int_eq(err.place.line, 3);
}
END_TEST

/* Whatever allocation fails, it is said and nothing is lost. */
START_TEST(out_of_memory)
{
	static const char *const text[] = { "solid x\n" FACET, "v 0 0 0\nv 1 0 0\nv 0 1 0\ng x\nf 1 2 3\n",
					    HEAD("ASCII", "POLYDATA") POINTS "POLYGONS 1 4\n3 0 1 2\n" };

	for (size_t f = 0; f < 3; f++)
		for (long k = 1;; k++) {
			long before = ts_alloc_balance();
			struct ts_pool *own = ts_pool_new();
			enum ts_status status;

			ts_error_clear(&err);
			ts_alloc_fail_at(k);
			status = ts_mesh_parse(&soup, &err, own, f == 1 ? "a.obj" : "a", text[f],
					       strlen(text[f]));
			ts_alloc_fail_at(0);
			ts_triangles_release(&soup);
			ts_pool_free(own);
			ck_assert_int_eq(ts_alloc_balance(), before);
			if (status == TS_OK)
				break;
			ck_assert_int_eq(status, TS_NOMEM);
		}
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("mesh files");
	TCase *tests = tcase_create("mesh files");
	SRunner *runner;
	int failed;

	tcase_add_checked_fixture(tests, start, stop);
	tcase_add_test(tests, stl_text);
	tcase_add_test(tests, stl_text_broken);
	tcase_add_test(tests, stl_binary);
	tcase_add_test(tests, obj);
	tcase_add_test(tests, vtk_text);
	tcase_add_test(tests, vtk_broken);
	tcase_add_test(tests, vtk_binary);
	tcase_add_test(tests, compressed_files);
	tcase_add_test(tests, out_of_memory);
	suite_add_tcase(suite, tests);
	runner = srunner_create(suite);
	srunner_run_all(runner, CK_NORMAL);
	failed = srunner_ntests_failed(runner);
	srunner_free(runner);
	return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
