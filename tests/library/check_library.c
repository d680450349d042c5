/* The C library: numbers, variables, particles, manual; what tsim.h promises. */
#include <gsl/gsl_errno.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "deck.h"
#include "packing.h"

#include "base/alloc.h"

static struct tsim *sim;

static void open_sim(void)
{
	sim = packing_open();
}

static void close_sim(void)
{
	packing_close(sim);
}

/* ---- what is the program's own */

static void handler_of_program(const char *reason, const char *file, int line, int code)
{
	(void)reason;
	(void)file;
	(void)line;
	(void)code;
}

START_TEST(handler_of_gsl_stays)
{
	gsl_error_handler_t *before = gsl_set_error_handler(handler_of_program);
	struct tsim *fluid = tsim_open();

	deck(fluid, "units si\nregion b block 0 1 0 1 0 1 units box\ncreate_box 1 b\ntimestep 1e-3\n"
		    "flow_style projection cells 8 8 8 viscosity 0.1 density 1\nflow_grid x geometric 1.2\n"
		    "pressure_style direct\nrun 1\n");
	ck_assert(gsl_set_error_handler(before) == handler_of_program);
	tsim_close(fluid);
}
END_TEST

/* ---- numbers */

START_TEST(tables)
{
	size_t n = tsim_count(sim), rows, columns;
	struct tsim_table t = TSIM_INIT(struct tsim_table);
	struct tsim_output o = TSIM_INIT(struct tsim_output);
	double *x = calloc(n, sizeof *x), *copy = calloc(3 * n, sizeof *copy), samples[4];

	deck(sim, "run 30\n");
	ck_assert_int_eq(tsim_evaluate(sim, "2*PI", TSIM_SCALAR, &t), 0);
	DECK_NEAR(t.data[0], 6.28318530717958647693, 0);
	ck_assert_int_eq(tsim_extent(sim, "f_trace", TSIM_VECTOR, &rows, &columns), 0);
	ck_assert(rows == 4 && columns == 1);
	ck_assert_int_eq(tsim_read(sim, "f_trace", TSIM_VECTOR, samples, 4, 1), 0);
	DECK_NEAR(samples[3], deck_value(sim, "c_k"), 0);
	ck_assert_int_eq(tsim_evaluate(sim, "c_x", TSIM_PER_PARTICLE, &t), 0);
	ck_assert(t.rows == n && t.columns == 3);
	ck_assert_int_eq(tsim_column_read(sim, "x", x, n), 0);
	for (size_t i = 0; i < n; i++)
		DECK_NEAR(t.data[3 * i + 1], x[i], 0);
	ck_assert_int_eq(tsim_read(sim, "c_x", TSIM_PER_PARTICLE, copy, n, 3), 0);
	ck_assert_int_eq(tsim_evaluate(sim, "c_x[2]", TSIM_PER_PARTICLE, &t), 0);
	ck_assert(t.rows == n && t.columns == 1);
	DECK_NEAR(t.data[n - 1], x[n - 1], 0);
	ck_assert_int_eq(tsim_evaluate(sim, "radius", TSIM_PER_PARTICLE, &t), 0);
	DECK_NEAR(t.data[n / 2], 0.0523 / 2, 0);
	deck(sim, "variable w atom x*2\n");
	ck_assert_int_eq(tsim_evaluate(sim, "v_w", TSIM_PER_PARTICLE, &t), 0);
	DECK_NEAR(t.data[5], 2 * x[5], 0);
	deck(sim, "fix two all vector 5 c_k c_nc\nrun 10\n");
	ck_assert_int_eq(tsim_evaluate(sim, "f_two", TSIM_ARRAY, &t), 0);
	ck_assert(t.rows == 3 && t.columns == 2);
	DECK_NEAR(t.data[4], deck_value(sim, "c_k"), 0);
	ck_assert_int_eq(tsim_evaluate(sim, "f_two[2]", TSIM_VECTOR, &t), 0);
	ck_assert(t.rows == 3 && t.columns == 1);
	DECK_NEAR(t.data[2], deck_value(sim, "c_nc"), 0);
	ck_assert_int_eq(tsim_output(sim, "f_two", 0, &o), 0);
	ck_assert_int_eq(o.shape, TSIM_ARRAY);
	/* refusals */
	ck_assert_int_eq(tsim_read(sim, "c_x", TSIM_PER_PARTICLE, copy, n, 2), TSIM_RANGE);
	ck_assert_ptr_nonnull(strstr(tsim_error(sim), "and 3 columns, the array"));
	tsim_error_clear(sim);
	ck_assert_int_eq(tsim_evaluate(sim, "c_k", TSIM_LOCAL, &t), TSIM_STATE);
	tsim_error_clear(sim);
	ck_assert_int_eq(tsim_evaluate(sim, "c_nix", TSIM_VECTOR, &t), TSIM_UNKNOWN);
	tsim_error_clear(sim);
	ck_assert_int_eq(tsim_evaluate(sim, "c_k", (enum tsim_shape)77, &t), TSIM_RANGE);
	tsim_error_clear(sim);
	ck_assert_int_eq(tsim_output(sim, "c_x", 0, &o), 0);
	ck_assert_int_eq(o.shape, TSIM_PER_PARTICLE);
	ck_assert_int_eq(tsim_output(sim, "c_x", 99, &o), TSIM_UNKNOWN);
	free(x);
	free(copy);
}
END_TEST

START_TEST(variables)
{
	char text[8];
	size_t length, k = 0;

	ck_assert_int_eq(tsim_variable(sim, "given", "2.385"), 0);
	deck(sim, "variable given index 1\n");
	DECK_NEAR(deck_value(sim, "v_given"), 2.385, 0);
	ck_assert_int_eq(tsim_variable_set(sim, "name", "string", "wide ${open}"), 0);
	ck_assert_int_eq(tsim_variable_text(sim, "name", text, sizeof text, &length), 0);
	ck_assert_str_eq(text, "wide ${");
	ck_assert_uint_eq(length, 12);
	ck_assert_int_eq(tsim_variable_set(sim, "name", "equal", "2*v_given"), 0);
	DECK_NEAR(deck_value(sim, "v_name"), 4.77, 1e-15);
	ck_assert_int_eq(tsim_variable_number(sim, "third", 1.0 / 3), 0);
	DECK_NEAR(deck_value(sim, "v_third"), 1.0 / 3, 0);
	ck_assert_int_eq(tsim_variable_number(sim, "third", -1e-300), 0);
	DECK_NEAR(deck_value(sim, "v_third"), -1e-300, 0);
	while (tsim_variable_name(sim, k))
		k++;
	ck_assert_uint_eq(k, 3);
	ck_assert_int_eq(tsim_variable_text(sim, "thirt", text, sizeof text, NULL), TSIM_UNKNOWN);
	ck_assert_ptr_nonnull(strstr(tsim_error(sim), "did you mean 'third'"));
	tsim_error_clear(sim);
	ck_assert_int_eq(tsim_variable_number(sim, "third", NAN), TSIM_RANGE);
	tsim_error_clear(sim);
	ck_assert_int_eq(tsim_variable_set(sim, "a b", "equal", "1"), TSIM_SYNTAX);
	tsim_error_clear(sim);
	ck_assert_int_ne(tsim_variable_set(sim, "name", "eqal", "1"), 0); /* the old one stays */
	tsim_error_clear(sim);
	ck_assert_int_ne(tsim_variable_set(sim, "name", "file", "no/such/file"), 0);
	tsim_error_clear(sim);
	DECK_NEAR(deck_value(sim, "v_name"), 4.77, 1e-15);
}
END_TEST

/* ---- particles */

START_TEST(every_quantity_can_be_read_and_written_back)
{
	size_t n = tsim_count(sim), written = 0;
	double *value = calloc(n, sizeof *value), *again = calloc(n, sizeof *again);
	const char *name;

	for (size_t k = 0; (name = tsim_quantity_name(k)); k++) {
		int status;

		ck_assert_int_eq(tsim_column_read(sim, name, value, n), 0);
		status = tsim_column_write(sim, name, value, n);
		ck_assert(status == 0 || status == TSIM_STATE);
		tsim_error_clear(sim);
		if (status)
			continue;
		written++;
		ck_assert_int_eq(tsim_column_read(sim, name, again, n), 0);
		for (size_t i = 0; i < n; i++)
			DECK_NEAR(again[i], value[i], 1e-15 * fabs(value[i]));
	}
	ck_assert_uint_ge(written, 17);
	free(value);
	free(again);
}
END_TEST

/* In two dimensions particles are discs, and their density is mass per area (set, create_atoms). */
START_TEST(density_of_discs)
{
	struct tsim *plane = tsim_open();
	const double density = 7.3, radius = 0.29;
	double value;

	deck(plane,
	     "units si\ndimension 2\nboundary f f p\nregion b block -1 1 -1 1 -0.5 0.5 units box\n"
	     "create_box 1 b\ncreate_atoms 1 single 0.1 0.2 0 units box\nset group all diameter 0.46\n");
	ck_assert_int_eq(tsim_column_write(plane, "density", &density, 1), 0);
	ck_assert_int_eq(tsim_column_read(plane, "mass", &value, 1), 0);
	DECK_NEAR(value, 7.3 * 3.14159265358979323846 * 0.23 * 0.23, 1e-15);
	ck_assert_int_eq(tsim_column_write(plane, "radius", &radius, 1), 0);
	ck_assert_int_eq(tsim_column_read(plane, "mass", &value, 1), 0);
	DECK_NEAR(value, 7.3 * 3.14159265358979323846 * 0.29 * 0.29, 1e-15);
	ck_assert_int_eq(tsim_column_read(plane, "density", &value, 1), 0);
	DECK_NEAR(value, 7.3, 1e-15);
	tsim_close(plane);
}
END_TEST

START_TEST(columns_of_the_script)
{
	const double two = 2.385, bad = NAN;
	struct tsim_view v = TSIM_INIT(struct tsim_view);
	int32_t id = 9;
	double back = 0;

	deck(sim, "fix p all property/atom d_heat d2_pair 2\n");
	ck_assert_msg(!tsim_scatter(sim, "d2_pair[2]", &id, &two, 1), "%s", tsim_error(sim));
	ck_assert_int_eq(tsim_scatter(sim, "d_heat", &id, &two, 1), 0);
	ck_assert_int_eq(tsim_gather(sim, "d2_pair[2]", &id, &back, 1), 0);
	DECK_NEAR(back, two, 0);
	ck_assert_int_eq(tsim_column_view(sim, "d2_pair", &v), 0);
	ck_assert(v.width == 2 && v.writable);
	ck_assert_int_eq(tsim_scatter(sim, "d2_pair[3]", &id, &two, 1), TSIM_UNKNOWN);
	tsim_error_clear(sim);
	ck_assert_int_eq(tsim_scatter(sim, "d_heat", &id, &bad, 1), TSIM_RANGE);
}
END_TEST

START_TEST(values_are_checked)
{
	static const struct {
		const char *name;
		double value;
		int status;
	} cases[] = {
		{ "x", NAN, TSIM_RANGE },     { "vx", INFINITY, TSIM_RANGE }, { "type", 3, TSIM_RANGE },
		{ "type", 1.5, TSIM_RANGE },  { "type", 0, TSIM_RANGE },      { "radius", 0, TSIM_RANGE },
		{ "mass", -1, TSIM_RANGE },   { "ix", 0.5, TSIM_RANGE },      { "ix", 1e10, TSIM_RANGE },
		{ "id", 7, TSIM_STATE },      { "radios", 1, TSIM_UNKNOWN },  { "density", 2385, TSIM_OK },
		{ "omegaz", 2.385, TSIM_OK }, { "type", 2, TSIM_OK },
	};
	int32_t id = 3, none[2] = { 3, 999999 };
	double x[2] = { 0 };

	for (size_t k = 0; k < DECK_LENGTH(cases); k++) {
		ck_assert_int_eq(tsim_scatter(sim, cases[k].name, &id, &cases[k].value, 1), cases[k].status);
		tsim_error_clear(sim);
	}
	DECK_NEAR(deck_value(sim, "type[3]"), 2, 0);
	DECK_NEAR(deck_value(sim, "omegaz[3]"), 2.385, 0);
	ck_assert_int_eq(tsim_gather(sim, "x", none, x, 2), TSIM_UNKNOWN);
	tsim_error_clear(sim);
	ck_assert_int_eq(tsim_column_read(sim, "x", x, 2), TSIM_RANGE);
}
END_TEST

START_TEST(views_and_generation)
{
	struct tsim_view x = TSIM_INIT(struct tsim_view), tag = TSIM_INIT(struct tsim_view);
	size_t n = tsim_count(sim), k = 0;
	uint64_t generation = tsim_generation(sim);
	int32_t id = 5;

	ck_assert_int_eq(tsim_column_view(sim, "x", &x), 0);
	ck_assert_int_eq(tsim_column_view(sim, "tag", &tag), 0);
	ck_assert(x.generation == generation && x.count == n && x.element == 8);
	ck_assert(tag.type == TSIM_I32 && tag.element == 4 && tag.width == 1 && !tag.writable);
	((double *)x.data)[0] = 0.2385;
	ck_assert_int_eq(tsim_gather(sim, "x", tag.data, (double[1]){ 0 }, 1), 0);
	DECK_NEAR(deck_value(sim, "x[1]"), ((int32_t *)tag.data)[0] == 1 ? 0.2385 : NAN, 0);
	ck_assert_int_eq(tsim_delete(sim, &id, 1), 0);
	ck_assert_uint_ne(tsim_generation(sim), generation);
	ck_assert_uint_eq(tsim_count(sim), n - 1);
	ck_assert_int_eq(tsim_delete(sim, &id, 1), TSIM_UNKNOWN);
	tsim_error_clear(sim);
	generation = tsim_generation(sim);
	deck(sim, "clear\n");
	ck_assert_uint_gt(tsim_generation(sim), generation);
	ck_assert_int_eq(tsim_column_view(sim, "omega", &x), TSIM_STATE);
	tsim_error_clear(sim);
	ck_assert_int_eq(tsim_column_view(sim, "nix", &x), TSIM_UNKNOWN);
	while (tsim_column_name(sim, k))
		k++;
	ck_assert_uint_ge(k, 10);
}
END_TEST

/* Memory of a view outlives reordering and `clear` while it is held. */
START_TEST(held_memory)
{
	struct tsim_view x = TSIM_INIT(struct tsim_view), f = TSIM_INIT(struct tsim_view);
	const double *data;
	double first;
	int32_t id = 1;

	ck_assert_int_eq(tsim_column_view(sim, "x", &x), 0);
	ck_assert_int_eq(tsim_column_view(sim, "f", &f), 0);
	ck_assert(tsim_hold(sim, x.data) == 0 && tsim_hold(sim, x.data) == 0 && tsim_hold(sim, f.data) == 0);
	data = x.data;
	first = data[0];
	deck(sim, "run 300\n");
	ck_assert_int_eq(tsim_delete(sim, &id, 1), 0);
	deck(sim, "clear\n%s", packing);
	DECK_NEAR(data[0], first, 1);
	tsim_release(sim, x.data);
	DECK_NEAR(data[0], first, 1);
	tsim_release(sim, x.data);
	tsim_release(sim, x.data); /* once too often does no harm */
	ck_assert_int_eq(tsim_column_view(sim, "x", &x), 0);
	ck_assert_int_eq(tsim_hold(sim, x.data), 0);
}
END_TEST

START_TEST(particles_made)
{
	double x[6] = { 0.1, 0.2, 0.3, 0.2, 0.2, 0.9 }, v[6] = { 0, 0, 1, 0, 0, -1 };
	double radius[2] = { 0.01, 0.02385 }, density[2] = { 1000, 2000 };
	int32_t type[2] = { 2, 1 }, id[2];
	struct tsim_particles p = {
		.size = sizeof p, .n = 2, .x = x, .v = v, .type = type, .radius = radius, .density = density
	};
	size_t n = tsim_count(sim);
	double mass[2];

	ck_assert_int_eq(tsim_step(sim, 5), 0);
	ck_assert_msg(tsim_create(sim, &p, id) == 0, "%s", tsim_error(sim));
	ck_assert_uint_eq(tsim_count(sim), n + 2);
	ck_assert_int_eq(tsim_gather(sim, "mass", id, mass, 2), 0);
	DECK_NEAR(mass[1], 4.0 / 3 * 3.14159265358979323846 * 2000 * pow(0.02385, 3), 1e-15);
	ck_assert_int_eq(tsim_step(sim, 5), 0);
	ck_assert_int_eq(tsim_delete(sim, id, 2), 0);
	ck_assert_uint_eq(tsim_count(sim), n);
	x[4] = 7; /* outside */
	ck_assert_int_eq(tsim_create(sim, &p, id), TSIM_RANGE);
	tsim_error_clear(sim);
	x[4] = 0.2;
	type[0] = 3;
	ck_assert_int_eq(tsim_create(sim, &p, id), TSIM_RANGE);
	tsim_error_clear(sim);
	p.type = NULL;
	radius[1] = -1;
	ck_assert_int_eq(tsim_create(sim, &p, id), TSIM_RANGE);
	tsim_error_clear(sim);
	p.radius = p.density = NULL;
	ck_assert_int_eq(tsim_create(sim, &p, NULL), 0);
	ck_assert_uint_eq(tsim_count(sim), n + 2);
	p.size = offsetof(struct tsim_particles, v); /* a program built with fewer fields */
	ck_assert_int_eq(tsim_create(sim, &p, NULL), 0);
	DECK_NEAR(deck_value(sim, "count(all)"), (double)n + 4, 0);
}
END_TEST

START_TEST(groups)
{
	size_t n = tsim_count(sim);
	unsigned char *member = calloc(n, 1);
	int bit;

	ck_assert_int_eq(tsim_group_get(sim, "rock", member, n), 0);
	for (size_t i = 0; i < n; i++) {
		ck_assert_uint_eq(member[i], 1);
		member[i] = i % 3 == 0;
	}
	ck_assert_int_eq(tsim_group_set(sim, "third", member, n), 0);
	DECK_NEAR(deck_value(sim, "count(third)"), (double)((n + 2) / 3), 0);
	ck_assert_int_eq(tsim_group_bit(sim, "third", &bit), 0);
	ck_assert_str_eq(tsim_group_name(sim, bit), "third");
	ck_assert_ptr_null(tsim_group_name(sim, 32));
	ck_assert_int_eq(tsim_group_set(sim, "all", member, n), TSIM_STATE);
	tsim_error_clear(sim);
	ck_assert_int_eq(tsim_group_bit(sim, "thirt", &bit), TSIM_UNKNOWN);
	free(member);
}
END_TEST

/* ---- the rest */

START_TEST(state)
{
	struct tsim_box box = TSIM_INIT(struct tsim_box);
	const char *name, *help, *style;
	int64_t step;
	double value, time, dt;

	tsim_box(sim, &box);
	ck_assert(box.exists && box.dimension == 3 && box.periodic[0] && !box.periodic[1]);
	ck_assert_int_eq(box.face[1][1], 'f');
	DECK_NEAR(box.hi[0], 0.385, 0);
	deck(sim, "run 10\n");
	tsim_clock(sim, &step, &time, &dt);
	ck_assert(step == 10);
	DECK_NEAR(time, 2e-3, 1e-18);
	DECK_NEAR(dt, 2e-4, 0);
	for (size_t k = 0; (name = tsim_setting_name(k, &help)); k++)
		ck_assert(!tsim_setting(sim, name, &value) && *help);
	ck_assert_int_eq(tsim_setting(sim, "nlocals", &value), TSIM_UNKNOWN);
	ck_assert_str_eq(tsim_live(sim, "fix", 2, &style), "floor");
	ck_assert_str_eq(style, "wall/gran");
	ck_assert_ptr_null(tsim_live(sim, "fix", 99, &style));
	ck_assert_ptr_null(tsim_live(sim, "nix", 0, &style));
}
END_TEST

START_TEST(what_there_is)
{
	char text[4096];
	size_t length, n = 0, rows = 0;
	const char *kind, *style, *summary;

	for (size_t k = 0; (kind = tsim_kind(k)); k++)
		for (size_t s = 0; (style = tsim_style(kind, s, &summary)); s++, n++) {
			struct tsim_argument a = TSIM_INIT(struct tsim_argument);

			ck_assert_int_eq(tsim_help(kind, style, 0, text, sizeof text, &length), 0);
			ck_assert(*summary && length > 20);
			for (size_t i = 0; !tsim_argument(kind, style, i, &a); i++, rows++)
				ck_assert_msg(*a.name && *a.type, "%s %s", kind, style);
		}
	ck_assert_uint_gt(n, 70);
	ck_assert_uint_gt(rows, 200);
	ck_assert_int_eq(tsim_help("fix", "gravty", 0, text, sizeof text, NULL), TSIM_UNKNOWN);
	ck_assert_str_eq(text, "there is no fix 'gravty'; did you mean 'gravity'?");
	ck_assert_int_eq(tsim_help("fics", "gravity", 0, text, 5, &length), TSIM_UNKNOWN);
	ck_assert_str_eq(text, "ther");
	ck_assert_int_eq(tsim_help("fix", "gravity", 1, NULL, 0, &length), 0);
	ck_assert_ptr_null(tsim_style("nix", 0, NULL));
	ck_assert_str_eq(tsim_status_text(TSIM_RANGE), "value out of range");
}
END_TEST

struct heard {
	int texts, warnings, progress;
	char all[1 << 14];
};

static void hear(void *data, enum tsim_log_level level, const char *text)
{
	struct heard *heard = data;
	size_t n = strlen(heard->all);

	heard->texts += level == TSIM_LOG_TEXT;
	heard->warnings += level == TSIM_LOG_WARNING;
	heard->progress += level == TSIM_LOG_PROGRESS;
	snprintf(heard->all + n, sizeof heard->all - n, "%s", text);
}

START_TEST(options_and_log)
{
	static struct heard heard;
	struct tsim_options options = {
		.size = sizeof options, .threads = 2, .on_log = hear, .on_log_data = &heard
	};
	struct tsim_error_place place = TSIM_INIT(struct tsim_error_place);
	struct tsim *other;
	double threads;

	ck_assert_int_eq(tsim_open_with(&options, &other), 0);
	ck_assert_int_eq(tsim_setting(other, "threads", &threads), 0);
	DECK_NEAR(threads, 2, 0);
	deck(other, "%s", packing);
	deck(other, "create_atoms 1 single 9 9 9 units box\nprint 'said'\nrun 50\n");
	ck_assert(heard.texts > 4 && heard.warnings == 1);
	ck_assert_ptr_nonnull(strstr(heard.all, "said\n"));
	ck_assert_ptr_nonnull(strstr(heard.all, "lies outside the box"));
	ck_assert_int_eq(tsim_text(other, "print 1\n\nprnt 2\n", "notes"), TSIM_UNKNOWN);
	tsim_error_where(other, &place);
	ck_assert(place.status == TSIM_UNKNOWN && place.line == 3 && place.column == 1 && place.length == 4);
	ck_assert_str_eq(place.file, "notes");
	ck_assert_str_eq(place.text, "prnt 2");
	tsim_close(other);
	options.threads = 5000;
	ck_assert_int_eq(tsim_open_with(&options, &other), TSIM_RANGE);
	ck_assert_ptr_nonnull(strstr(tsim_error(other), "5000 threads"));
	tsim_close(other);
	options.threads = 1;
	options.log = "/dev/null/log";
	ck_assert_int_eq(tsim_open_with(&options, &other), TSIM_IO);
	tsim_close(other);
	options = (struct tsim_options){ .size = sizeof options, .explain = 1 };
	ck_assert_int_eq(tsim_open_with(&options, &other), 0);
	deck(other, "%s", packing);
	ck_assert_int_eq(tsim_step(other, 100), 0);
	DECK_NEAR(deck_value(other, "step"), 100, 0);
	DECK_NEAR(deck_value(other, "z[1]"), 0.055, 1e-12);
	tsim_close(other);
}
END_TEST

START_TEST(check_runs_nothing)
{
	struct tsim_options options = { .size = sizeof options, .check = 1 };
	struct tsim *other;
	char report[4096];
	size_t length;
	int errors;

	ck_assert_int_eq(tsim_open_with(&options, &other), 0);
	ck_assert_int_eq(tsim_text(other, "units sj\nprnt 1\nunits si\n", "s"), 0);
	ck_assert_int_eq(tsim_check_report(other, &errors, report, sizeof report, &length), 0);
	ck_assert_int_eq(errors, 2);
	ck_assert(strlen(report) == length);
	ck_assert_ptr_nonnull(strstr(report, "s:1:7: error"));
	ck_assert_ptr_nonnull(strstr(report, "s:2:1: error"));
	tsim_close(other);
	ck_assert_int_eq(tsim_check_report(sim, &errors, report, sizeof report, NULL), TSIM_STATE);
}
END_TEST

START_TEST(quit_is_told)
{
	int status = 0;

	ck_assert(!tsim_has_quit(sim, NULL));
	deck(sim, "quit 3\nprint never\n");
	ck_assert(tsim_has_quit(sim, &status) && status == 3);
}
END_TEST

static const char tiny[] = "boundary p f f\nregion b block 0 1 0 1 0 1 units box\n"
			   "create_box 2 b\npair_style spring/dashpot\n"
			   "pair_coeff * * stiffness 100 restitution 0.5\nfix m all nve\n"
			   "compute k all ke\ncompute x all property/atom id x\ntimestep 1e-3\n";

static int do_nothing(struct tsim *s, void *data)
{
	(void)s, (void)data;
	return 0;
}

/* Every kind of call once; the first code that is not 0. */
static int use_all(struct tsim *one)
{
	double x[9] = { 0.1, 0.1, 0.1, 0.5, 0.5, 0.5, 0.6, 0.5, 0.5 }, value[3];
	unsigned char member[3] = { 1, 0, 1 };
	struct tsim_particles p = { .size = sizeof p, .n = 3, .x = x };
	struct tsim_table t = TSIM_INIT(struct tsim_table);
	struct tsim_view v = TSIM_INIT(struct tsim_view);
	int32_t id[3];
	char text[16];
	int code;

#define FIRST(call)    \
	code = (call); \
	if (code)      \
	return code
	FIRST(tsim_string(one, tiny));
	FIRST(tsim_create(one, &p, id));
	FIRST(tsim_group_set(one, "two", member, 3));
	FIRST(tsim_scatter(one, "radius", id, (double[3]){ 0.05, 0.06, 0.05 }, 3));
	FIRST(tsim_on_step(one, TSIM_AFTER_FORCE, do_nothing, NULL));
	FIRST(tsim_step(one, 2));
	FIRST(tsim_column_view(one, "v", &v));
	FIRST(tsim_hold(one, v.data));
	FIRST(tsim_step(one, 2));
	FIRST(tsim_variable_number(one, "a", 2.385));
	FIRST(tsim_variable_set(one, "w", "atom", "x*v_a"));
	FIRST(tsim_variable_text(one, "a", text, sizeof text, NULL));
	FIRST(tsim_evaluate(one, "c_x", TSIM_PER_PARTICLE, &t));
	FIRST(tsim_evaluate(one, "v_w", TSIM_PER_PARTICLE, &t));
	FIRST(tsim_gather(one, "omegax", NULL, value, 3));
	FIRST(tsim_column_write(one, "omegax", value, 3));
	FIRST(tsim_delete(one, id, 1));
	FIRST(tsim_help("fix", "gravity", 0, text, sizeof text, NULL));
#undef FIRST
	return 0;
}

/* The k-th allocation fails, for all k: a clean error, and nothing stays behind. */
START_TEST(out_of_memory)
{
	long before = ts_alloc_balance();
	int code = TSIM_NOMEM;
	long k = 0;

	while (code) {
		struct tsim *one;

		ts_alloc_fail_at(++k);
		one = tsim_open();
		code = one ? use_all(one) : TSIM_NOMEM;
		ts_alloc_fail_at(0);
		ck_assert_msg(code == 0 || code == TSIM_NOMEM, "allocation %ld: %s", k, tsim_error(one));
		tsim_close(one);
		ck_assert_int_eq(ts_alloc_balance(), before);
	}
	ck_assert_int_gt(k, 100);
}
END_TEST

START_TEST(a_thousand_times)
{
	long before = ts_alloc_balance();

	for (int k = 0; k < 1000; k++) {
		struct tsim *one = tsim_open();

		ck_assert_ptr_nonnull(one);
		if (k % 100 == 0) {
			deck(one, "%s", packing);
			ck_assert_int_eq(tsim_step(one, 2), 0);
		}
		tsim_close(one);
	}
	ck_assert_int_eq(ts_alloc_balance(), before);
	tsim_close(NULL);
	ck_assert_str_eq(tsim_error(NULL), "error: out of memory\n");
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("library");
	TCase *tests = tcase_create("all");

	tcase_add_checked_fixture(tests, open_sim, close_sim);
	tcase_set_timeout(tests, 120);
	tcase_add_test(tests, handler_of_gsl_stays);
	tcase_add_test(tests, tables);
	tcase_add_test(tests, variables);
	tcase_add_test(tests, every_quantity_can_be_read_and_written_back);
	tcase_add_test(tests, density_of_discs);
	tcase_add_test(tests, columns_of_the_script);
	tcase_add_test(tests, values_are_checked);
	tcase_add_test(tests, views_and_generation);
	tcase_add_test(tests, held_memory);
	tcase_add_test(tests, particles_made);
	tcase_add_test(tests, groups);
	tcase_add_test(tests, state);
	tcase_add_test(tests, what_there_is);
	tcase_add_test(tests, options_and_log);
	tcase_add_test(tests, check_runs_nothing);
	tcase_add_test(tests, quit_is_told);
	tcase_add_test(tests, out_of_memory);
	tcase_add_test(tests, a_thousand_times);
	suite_add_tcase(suite, tests);
	return deck_main(suite);
}
