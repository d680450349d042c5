/* -crosscheck: outputs of two programs read, paired and compared. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "asserts.h"
#include "crosscheck/difference_report.h"
#include "core/life.h"
#include "crosscheck/inputs.h"
#include "crosscheck/meaning.h"
#include "crosscheck/outputs.h"
#include "base/process.h"
#include "library/tsim_tables.h"

static struct tsim *sim;
static struct ts_str root;
static long balance;

static void set_up(void)
{
	balance = ts_alloc_balance();
	sim = ts_sim_new(&ts_tables);
	ck_assert_ptr_nonnull(sim);
	ck_assert_int_eq(ts_folder_scratch(&root, &sim->error), TS_OK);
	ck_assert_int_eq(chdir(root.text), 0);
	mkdir("a", 0777);
	mkdir("b", 0777);
}

static void tear_down(void)
{
	ck_assert_int_eq(chdir("/"), 0);
	ts_folder_remove(root.text);
	ck_assert_int_ne(access(root.text, F_OK), 0);
	ts_str_release(&root);
	ts_sim_free(sim);
	ck_assert_int_eq(ts_alloc_balance(), balance);
}

static void put(const char *path, const char *text)
{
	FILE *file = fopen(path, "w");

	ck_assert_ptr_nonnull(file);
	ck_assert_int_ge(fputs(text, file), 0);
	ck_assert_int_eq(fclose(file), 0);
}

static const char *const one_file[] = { "out", NULL };

static struct ts_pairing compared(enum ts_frame_kind kind, const char *a, const char *b)
{
	struct ts_pairing p = {
		.name = "out", .kind = kind, .folder = { "a", "b" }, .file = { one_file, one_file }
	};

	put("a/out", a);
	put("b/out", b);
	ck_assert_msg(ts_compare(&p, 1e-6, &sim->error, sim->pool) == TS_OK, "%s", sim->error.message);
	return p;
}

static const struct ts_compared *column(const struct ts_pairing *p, const char *name)
{
	for (size_t k = 0; k < p->columns; k++)
		if (ts_streq(p->column[k].name, name))
			return &p->column[k];
	ck_abort_msg("no column %s", name);
	return NULL;
}

START_TEST(digits_of_words)
{
	static const struct {
		const char *word;
		double value;
		int digits, decimals;
		bool padded;
	} cases[] = {
		{ "2.385", 2.385, 4, 3, false },    { "-0.00120", -0.0012, 3, 5, true },
		{ "17", 17, 2, -1, false },	    { "1e+06", 1e6, 1, 0, false },
		{ "1.50e-3", 1.5e-3, 3, 2, false }, { "0", 0, 0, -1, false },
	};

	for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
		struct ts_printed p = ts_printed(cases[k].word);

		ck_assert_msg(p.value == cases[k].value && p.digits == cases[k].digits &&
				      p.decimals == cases[k].decimals && p.padded == cases[k].padded,
			      "%s: %g %d %d %d", cases[k].word, p.value, p.digits, p.decimals, p.padded);
	}
	ck_assert(ts_printed("nan").value == ts_printed("-nan").value);
	ck_assert(ts_printed("Fe").value != ts_printed("Al").value);
}
END_TEST

/* What stands between the tables is passed over, of whichever program. */
START_TEST(thermo_of_screens)
{
	struct ts_pairing p =
		compared(TS_FRAMES_THERMO,
			 "tsim 0.1.0\n    Step KinEng CPU 1\n 0 1.5 0 7\nhello 3\n 10 2.5 0.1 7\n"
			 "Loop time of 3 on 1 procs\n4605.6 ns per step\nNlocal: 1\n"
			 "  Step Atoms rotation\n 10 5 3\n 20 5 3\nLoop time of 1\n",
			 "LIGGGHTS (Version)\nMemory usage = 5 Mbytes\n    Step KinEng CPU 1\n 0 1.5 0 7\n"
			 " 10 2.50003 0.2 7\nLoop time of 3 on 1 procs\nHistogram: 1 0 0 0 0 0 0\n"
			 "  Step Atoms c_rotation_all\n 10 5 3\n 20 6 3\nLoop time of 1\n");
	const struct ts_compared *ke = column(&p, "KinEng"), *atoms = column(&p, "Atoms");

	ck_assert_uint_eq(p.frames, 4);
	ck_assert(p.wall_times_skipped);
	ck_assert_uint_eq(p.columns, 5);
	ck_assert_uint_eq(column(&p, "rotation")->side[TS_PEER].n, 2);
	ck_assert_int_eq(ke->at, 10);
	/* 3e-5 minus one unit of the sixth digit, over a range of 1.00003 */
	ck_assert_double_eq_tol(ke->most, (3e-5 - 1e-5) / 1.00003, 1e-10);
	ck_assert(ke->diverged && atoms->diverged && !column(&p, "1")->diverged);
	ck_assert_int_eq(atoms->diverged_at, 20);
	ck_assert_double_eq_tol(atoms->most, 1, 1e-12);
	ts_compare_release(&p);
}
END_TEST

#define DUMP(step, n, rows)                                   \
	"ITEM: TIMESTEP\n" step "\nITEM: NUMBER OF ATOMS\n" n \
	"\nITEM: BOX BOUNDS ff ff ff\n0 1\n0 1\n0 1\nITEM: ATOMS id vx vy \n" rows

/* Rows are matched by identity, frames by step. */
START_TEST(dumps)
{
	struct ts_pairing p = compared(TS_FRAMES_DUMP,
				       DUMP("0", "2", "1 1.25 0\n2 2.385 0\n") DUMP("5", "1", "1 1 0\n")
					       DUMP("10", "2", "1 4.5 1e-17\n2 3.25 0\n"),
				       DUMP("0", "2", "2 2.385 0\n1 1.25 0\n")
					       DUMP("10", "3", "3 0 0\n2 3.75 0\n1 4.5 0\n"));
	const struct ts_compared *vx = column(&p, "vx"), *vy = column(&p, "vy");

	ck_assert_uint_eq(p.frames, 2);
	ck_assert_uint_eq(p.unmatched_frames[TS_SELF], 1);
	ck_assert_uint_eq(p.unmatched_frames[TS_PEER], 0);
	ck_assert_uint_eq(p.unmatched_rows, 1);
	ck_assert_int_eq(p.unmatched_at, 5);
	ck_assert_double_eq_tol(vx->most, 0.5 / 4.5, 1e-5);
	ck_assert_int_eq(vx->at, 10);
	ck_assert_msg(vy->most < 1e-15 && !vy->diverged, "round-off in a component that is zero");
	ts_compare_release(&p);
}
END_TEST

#define CONTACTS(n, rows)                                                                                \
	"ITEM: TIMESTEP\n0\nITEM: NUMBER OF ENTRIES\n" n                                                 \
	"\nITEM: BOX BOUNDS ff ff ff\n0 1\n0 1\n0 1\nITEM: ENTRIES c_c[1] c_c[4] c_c[7] c_c[8] c_c[10] " \
	"c_c[13] c_c[16]\n" rows

static struct ts_pairing compared_contacts(struct ts_meanings *m, const char *a, const char *b)
{
	static const char *const line[] = { "compute", "c",  "all", "pair/gran/local", "history", "torque",
					    "force",   "id", "pos" };
	struct ts_pairing p = { .name = "out",
				.kind = TS_FRAMES_DUMP,
				.folder = { "a", "b" },
				.file = { one_file, one_file },
				.meanings = m };

	*m = (struct ts_meanings){ .err = &sim->error, .pool = sim->pool };
	ck_assert_int_eq(ts_meanings_read_command(m, line, 9), TS_OK);
	put("a/out", a);
	put("b/out", b);
	ck_assert_int_eq(ts_compare(&p, 1e-6, &sim->error, sim->pool), TS_OK);
	ts_meanings_release(m);
	return p;
}

/* Columns: x of both partners, both ids, force, torque, history. The second contact stands the other way
 * round. */
START_TEST(partners_in_the_other_order)
{
	static const char here[] = CONTACTS("2", "0.5 1.5 1 2 7.5 0.25 3.5\n2.5 4.5 3 5 1.5 0.75 2.5\n");
	static const struct {
		const char *row, *parts;
	} cases[] = {
		{ "4.5 2.5 5 3 -1.5 0.75 2.5\n", NULL },
		{ "4.5 2.5 5 3 -1.5 0.625 -2.5\n", NULL }, /* another arm; a memory that turns, too */
		{ "4.5 2.5 5 3 1.5 0.75 2.5\n", "c_c[10]" },
		{ "2.5 4.5 5 3 -1.5 0.75 2.5\n", "c_c[1]" },
		{ "4.5 2.5 5 3 -1.5 0.75 2.25\n", "c_c[16]" },
		{ "2.5 4.5 3 5 -1.5 0.75 2.5\n", "c_c[10]" }, /* in the same order signs count */
		{ "2.5 4.5 3 5 1.5 0.625 2.5\n", "c_c[13]" },
		{ "2.5 4.5 3 5 1.5 0.75 -2.5\n", "c_c[16]" },
	};

	for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
		struct ts_meanings m;
		struct ts_pairing p;
		char there[400];

		snprintf(there, sizeof there, CONTACTS("2", "%s0.5 1.5 1 2 7.5 0.25 3.5\n"), cases[k].row);
		p = compared_contacts(&m, here, there);
		ck_assert_uint_eq(p.unmatched_rows, 0);
		ck_assert_uint_eq(p.swapped, k < 5);
		for (size_t n = 0; n < p.columns; n++)
			ck_assert_msg(p.column[n].diverged ==
					      (cases[k].parts &&
					       (ts_streq(p.column[n].name, cases[k].parts) ||
						(k == 3 && ts_streq(p.column[n].name, "c_c[4]")))),
				      "%zu: %s", k, p.column[n].name);
		ts_compare_release(&p);
	}
}
END_TEST

/* Frames without rows in both are no difference; of one that only one program fills, the rows are alone. */
START_TEST(empty_frames)
{
	struct ts_meanings m;
	struct ts_pairing p = compared_contacts(&m, CONTACTS("0", ""), CONTACTS("0", ""));
	struct ts_str text = { 0 };

	ck_assert_uint_eq(p.frames, 1);
	ck_assert(p.columns == 7 && !ts_compare_lacks(&p.column[0], TS_SELF) &&
		  !ts_compare_lacks(&p.column[0], TS_PEER));
	ts_report_pairing(&p, false, "peer", &text);
	ck_assert_str_eq(ts_str_text(&text), "\nout: 1 step, empty in both\n");
	ts_str_release(&text);
	ts_compare_release(&p);
	p = compared_contacts(&m, CONTACTS("1", "0.5 1.5 1 2 7.5 0.25 3.5\n"), CONTACTS("0", ""));
	ck_assert_uint_eq(p.unmatched_rows, 1);
	ck_assert_int_eq(p.unmatched_at, 0);
	ts_compare_release(&p);
}
END_TEST

/* By the script: the energy of contacts and what is made of it. */
START_TEST(differences_on_purpose)
{
	static const char *const lines[][5] = {
		{ "compute", "stored_energy", "all", "pe" },
		{ "compute", "one", "all", "pe/atom" },
		{ "compute", "other", "all", "ke" },
		{ "variable", "sum", "equal", "c_stored_energy+1" },
		{ "variable", "more", "equal", "2*v_sum" },
		{ "variable", "plain", "equal", "c_other+peak" },
		{ "variable", "total", "equal", "etotal/atoms" },
		{ "compute", "x", "all", "pe" },
		{ "variable", "x", "equal", "1+1" },
	};
	struct ts_meanings m = { .err = &sim->error, .pool = sim->pool };
	static const struct {
		enum ts_frame_kind kind;
		const char *column;
		bool differs;
	} cases[] = {
		{ TS_FRAMES_THERMO, "stored_e", true }, { TS_FRAMES_THERMO, "PotEng", true },
		{ TS_FRAMES_THERMO, "KinEng", false },	{ TS_FRAMES_TEXT, "c_stored_energy", true },
		{ TS_FRAMES_DUMP, "c_one", true },	{ TS_FRAMES_DUMP, "c_other", false },
		{ TS_FRAMES_TEXT, "v_sum", true },	{ TS_FRAMES_TEXT, "v_more", true },
		{ TS_FRAMES_THERMO, "plain", false },	{ TS_FRAMES_THERMO, "total", true },
		{ TS_FRAMES_TEXT, "c_x", true },	{ TS_FRAMES_TEXT, "PotEng", false },
		{ TS_FRAMES_THERMO, "x", false }, /* it may be either */
	};

	for (size_t k = 0; k < sizeof lines / sizeof *lines; k++)
		ck_assert_int_eq(ts_meanings_read_command(&m, lines[k], 4), TS_OK);
	for (size_t k = 0; k < sizeof cases / sizeof *cases; k++)
		ck_assert_msg(ts_meanings_differ(&m, cases[k].kind, cases[k].column) == cases[k].differs,
			      "%s", cases[k].column);
	ts_meanings_release(&m);
}
END_TEST

/* Mean, spread and distribution after parting: the same values in another order have the same profile. */
START_TEST(statistics)
{
	struct ts_pairing p = compared(TS_FRAMES_DUMP, DUMP("0", "4", "1 1 0\n2 2 0\n3 3 0\n4 4 0\n"),
				       DUMP("0", "4", "1 4 0\n2 3 1\n3 2 1\n4 1 0\n"));
	const struct ts_compared *vx = column(&p, "vx"), *vy = column(&p, "vy");

	ck_assert(vx->diverged);
	ck_assert_int_eq(ts_compare_statistics(&p, 0, &sim->error, sim->pool), TS_OK);
	ck_assert_double_eq_tol(vx->most, 1, 1e-12);
	ck_assert_double_eq_tol(vx->mean + vx->deviation + vx->quantiles, 0, 1e-12);
	/* vy and vx have one scale, 3 */
	ck_assert_double_eq_tol(vy->mean, 0.5 / 3, 1e-12);
	ck_assert_double_eq_tol(vy->deviation, 0.5 / 3, 1e-12);
	ck_assert_double_eq_tol(vy->quantiles, 0.5 / 3, 1e-12);
	ts_compare_release(&p);
}
END_TEST

/* Rows of fix ave/time and of blocks have the names of the comment above them. */
START_TEST(averages)
{
	struct ts_pairing p =
		compared(TS_FRAMES_TEXT,
			 "# Time-averaged data for fix a\n# TimeStep c_e v_q\n100 2 7\n200 3 7\n",
			 "# Time-averaged data for fix a\n# TimeStep c_e v_q\n100 2 7\n200 4 7\n");

	ck_assert_int_eq(column(&p, "c_e")->diverged_at, 200);
	ck_assert(!column(&p, "v_q")->diverged);
	ts_compare_release(&p);
	p = compared(TS_FRAMES_TEXT,
		     "# Chunks\n# Timestep Number-of-chunks\n# Chunk vx\n100 2\n1 0.5\n2 0.75\n200 1\n1 "
		     "2.5\n",
		     "# Chunks\n# Timestep Number-of-chunks\n# Chunk vx\n100 2\n1 0.5\n2 0.75\n200 1\n1 "
		     "2.75\n");
	ck_assert_uint_eq(p.frames, 2);
	ck_assert_int_eq(column(&p, "vx")->diverged_at, 200);
	ck_assert(!column(&p, "Chunk")->diverged);
	ts_compare_release(&p);
}
END_TEST

/* nan in both programs does not make other differences small; nan in one of them differs from any number. */
START_TEST(not_numbers)
{
	struct ts_pairing p = compared(TS_FRAMES_DUMP, DUMP("0", "3", "1 nan 0\n2 2 inf\n3 3 1\n"),
				       DUMP("0", "3", "1 -nan 0\n2 2.5 inf\n3 3 nan\n"));
	const struct ts_compared *vx = column(&p, "vx"), *vy = column(&p, "vy");

	ck_assert(vx->diverged && vy->diverged);
	ck_assert_double_eq_tol(vx->most, 0.5, 1e-4);
	ck_assert_double_gt(vy->most, 1);
	ck_assert_int_eq(ts_compare_statistics(&p, 0, &sim->error, sim->pool), TS_OK);
	ck_assert_double_eq_tol(vx->mean, 0.25, 1e-12);
	ts_compare_release(&p);
	p = compared(TS_FRAMES_DUMP, DUMP("0", "1", "1 nan 0\n"), DUMP("0", "1", "1 nan 0\n"));
	ck_assert(!column(&p, "vx")->diverged);
	ts_compare_release(&p);
}
END_TEST

/* Any text: words are the same or not, numbers are compared. */
START_TEST(texts)
{
	struct ts_pairing p = compared(TS_FRAMES_TEXT, "solid tsim\nvertex 1.5 2 3\nvertex 1 2 4\n",
				       "solid STL\nvertex 1.5 2 3\nvertex 1 2 5\n");

	ck_assert(column(&p, "word vertex")->diverged == false);
	ck_assert_int_eq(column(&p, "vertex (3)")->diverged_at, 3);
	ck_assert(!column(&p, "vertex (2)")->diverged);
	ts_compare_release(&p);
	p = compared(TS_FRAMES_TEXT, "ke v\n1.5 2\nat 3 end\n", "ke v\n1.5 3\nat 3 stop\n");
	ck_assert(column(&p, "v")->diverged && !column(&p, "ke")->diverged && !column(&p, "at")->diverged);
	ck_assert(column(&p, "word end")->side[TS_PEER].n == 0);
	ts_compare_release(&p);
	/* commas separate words, too */
	p = compared(TS_FRAMES_TEXT, "# t,ke,v\n0.1,2.00000000001,3\n0.2,5,3\n",
		     "# t,ke,v\n0.1,2,3\n0.2,5,4\n");
	ck_assert(column(&p, "v")->diverged && !column(&p, "ke")->diverged && !column(&p, "t")->diverged);
	ts_compare_release(&p);
}
END_TEST

/* Points and their arrays, whatever the version; corners of cells and titles are no numbers to compare. */
START_TEST(vtk_files)
{
	static const char *const file[] = { "v20.vtk", NULL };
	struct ts_pairing p = {
		.name = "v", .kind = TS_FRAMES_VTK, .folder = { "a", "b" }, .file = { file, file }
	};

	put("a/v20.vtk", "# vtk DataFile Version 3.0\ntsim 5 7\nASCII\nDATASET POLYDATA\n"
			 "POINTS 2 double\n1 2 3\n4 5 6\nVERTICES 2 4\n1 0\n1 1\nPOINT_DATA 2\n"
			 "VECTORS v double\n1 0 0 2 0 0\nSCALARS id int 1\nLOOKUP_TABLE default\n1 2\n"
			 "CELL_DATA 2\nSCALARS area double\nLOOKUP_TABLE default\n3 4\n");
	put("b/v20.vtk",
	    "# vtk DataFile Version 5.1\nGenerated by LIGGGHTS\nASCII\nDATASET POLYDATA\n"
	    "POINTS 2 float\n4 5 6 1 2 3\nVERTICES 3 2\nOFFSETS vtktypeint64\n0 1 2\n"
	    "CONNECTIVITY vtktypeint64\n0 1\nPOINT_DATA 2\nFIELD FieldData 2\nid 1 2 int\n2 1\n"
	    "v 3 2 double\n2.5 0 0\n1 0 0\nCELL_DATA 2\nFIELD FieldData 1\narea 1 2 double\n3 4\n");
	ck_assert_msg(ts_compare(&p, 1e-6, &sim->error, sim->pool) == TS_OK, "%s", sim->error.message);
	ck_assert_uint_eq(p.frames, 2);
	ck_assert_uint_eq(p.columns, 8);
	ck_assert_int_eq(column(&p, "v[1]")->diverged_at, 20);
	ck_assert(!column(&p, "x[1]")->diverged && !column(&p, "x[3]")->diverged);
	ck_assert(!column(&p, "area")->diverged && !column(&p, "v[2]")->diverged);
	ts_compare_release(&p);
}
END_TEST

static bool has(const char *const *list, size_t n, const char *name)
{
	for (size_t k = 0; k < n; k++)
		if (ts_streq(list[k], name))
			return true;
	return false;
}

/* What a script mentions is found: by name, by pattern, in what it includes, above the folder. */
START_TEST(inputs)
{
	struct ts_word words[] = { { .text = "-var" }, { .text = "which" }, { .text = "more" } };
	struct ts_inputs in = { .err = &sim->error, .pool = sim->pool };
	struct ts_str place = { 0 };
	struct stat info;

	mkdir("case", 0777);
	mkdir("case/post", 0777);
	ck_assert_int_eq(chdir("case"), 0);
	put("in.main", "include in.${which} # in.comment\nfix m all mesh/surface file ../a/m.stl\n"
		       "pair_coeff * *\nread_data 'd.${n}'\ndump d all custom 1 post/old*.txt id\n");
	put("in.more", "molecule m mol.x\n");
	put("in.comment", "");
	put("mol.x", "");
	put("d.3", "");
	put("unused", "");
	put("post/old1.txt", "");
	put("../a/m.stl", "");
	ck_assert_int_eq(ts_inputs_find(&in, "in.main", (struct ts_words){ words, 3 }), TS_OK);
	ck_assert(has(in.file, in.files, "in.main") && has(in.file, in.files, "in.more"));
	ck_assert(has(in.file, in.files, "mol.x") && has(in.file, in.files, "d.3"));
	ck_assert(has(in.file, in.files, "../a/m.stl") && has(in.folder, in.folders, "post"));
	ck_assert_uint_eq(in.files, 5);
	ck_assert_int_eq(in.up, 1);
	ck_assert_int_eq(ts_inputs_copy(&in, "copy", &place), TS_OK);
	ck_assert_str_eq(ts_str_text(&place), "copy/1");
	ck_assert(stat("copy/1/in.more", &info) == 0 && info.st_mtime == TS_INPUT_DATE);
	ck_assert(stat("copy/a/m.stl", &info) == 0 && stat("copy/1/post", &info) == 0);
	ts_str_release(&place);
	ts_inputs_release(&in);
	ck_assert_int_eq(chdir(".."), 0);
}
END_TEST

START_TEST(numbered_files_go_together)
{
	static const char *const folder[] = { "a", "b" };
	static const char *const names[] = { "d9.txt", "d10.txt", "log.x", "r" };
	struct ts_outputs o = { 0 };
	char path[40];

	for (int who = 0; who < 2; who++) {
		for (size_t k = 0; k < 4; k++) {
			snprintf(path, sizeof path, "%s/%s", folder[who], names[k]);
			put(path, k == 3 ? "\x01\x02" : k == 2 ? "tsim 0\n" : "ITEM: TIMESTEP\n");
		}
		put(who ? "b/theirs" : "a/ours", "1\n");
		ck_assert_int_eq(ts_folder_list(folder[who], 0, &o.listing[who], sim->pool, &sim->error),
				 TS_OK);
	}
	ck_assert_int_eq(ts_outputs_pair(&o, folder, &sim->error, sim->pool), TS_OK);
	ck_assert_uint_eq(o.n, 1);
	ck_assert_str_eq(o.pairing[0].name, "d*.txt");
	ck_assert_int_eq(o.pairing[0].kind, TS_FRAMES_DUMP);
	ck_assert_str_eq(o.pairing[0].file[0][0], "d9.txt");
	ck_assert_str_eq(o.pairing[0].file[0][1], "d10.txt");
	ck_assert_uint_eq(o.nskipped, 1);
	ck_assert_str_eq(o.only[TS_SELF][0], "ours");
	ck_assert_str_eq(o.only[TS_PEER][0], "theirs");
	ts_outputs_release(&o);
}
END_TEST

/* No shell reads the words; the exit status and the signal come through. */
START_TEST(processes)
{
	static const char *const quoted[] = { "printf", "%s|", "a b", "$HOME;x", NULL };
	static const char *const status[] = { "sh", "-c", "exit 7", NULL };
	static const char *const killed[] = { "sh", "-c", "kill -9 $$", NULL };
	static const char *const nothing[] = { "/no/such/program", NULL };
	const char *const *calls[] = { quoted, status, killed };
	int expected[] = { 0, 7, 137 };
	char text[40] = "";
	FILE *file;

	for (size_t k = 0; k < 3; k++) {
		struct ts_process p = { .words = calls[k], .folder = "a", .output = "said" };

		ck_assert_int_eq(ts_process_run(&p, &sim->error), TS_OK);
		ck_assert_int_eq(p.status, expected[k]);
		if (k == 0) {
			file = fopen("said", "r");
			ck_assert_uint_gt(fread(text, 1, sizeof text - 1, file), 0);
			fclose(file);
			ck_assert_str_eq(text, "a b|$HOME;x|");
		}
	}
	ck_assert_int_eq(ts_process_run(&(struct ts_process){ .words = nothing, .output = "said" },
					&sim->error),
			 TS_IO);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("crosscheck");
	TCase *tc = tcase_create("crosscheck");
	SRunner *runner = srunner_create(suite);
	int failed;

	tcase_add_checked_fixture(tc, set_up, tear_down);
	tcase_add_test(tc, digits_of_words);
	tcase_add_test(tc, thermo_of_screens);
	tcase_add_test(tc, dumps);
	tcase_add_test(tc, partners_in_the_other_order);
	tcase_add_test(tc, empty_frames);
	tcase_add_test(tc, differences_on_purpose);
	tcase_add_test(tc, statistics);
	tcase_add_test(tc, averages);
	tcase_add_test(tc, not_numbers);
	tcase_add_test(tc, texts);
	tcase_add_test(tc, vtk_files);
	tcase_add_test(tc, inputs);
	tcase_add_test(tc, numbered_files_go_together);
	tcase_add_test(tc, processes);
	suite_add_tcase(suite, tc);
	srunner_run_all(runner, CK_NORMAL);
	failed = srunner_ntests_failed(runner);
	srunner_free(runner);
	return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
