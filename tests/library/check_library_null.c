/* Every function of tsim.h with NULL for each of its pointers, and for all of them: it tells or
 * does nothing, and never crashes. A function without a row here fails. */
#include <ctype.h>
#include <stdlib.h>
#include <string.h>

#include "asserts.h"
#include "deck.h"
#include "tsim.h"

/* Pointers of a call by number, 0 the simulation; those with a bit in `null` are NULL. */
static unsigned null;
#define P(k, pointer) (null & 1u << (k) ? NULL : (pointer))
#define S P(0, sim)

static struct tsim *sim;
static double number[64];
static const char contacts[] =
	"pair_style spring/dashpot\npair_coeff * * stiffness 2385 restitution 0.5\nrun 0\n";
static int32_t id[64] = { 1, 2 };
static unsigned char member[64];
static char text[200];
static int whole;
static size_t size, columns;
static const char *name;

static int nothing(struct tsim *of, void *data)
{
	(void)of, (void)data;
	return 0;
}

static int told(const char *what)
{
	return what != NULL;
}

static const double *values;
static const char *const table_file = "check_library_null.csv";

static const char *write_table(void)
{
	FILE *file = fopen(table_file, "w");

	ck_assert_ptr_nonnull(file);
	fputs("a,b\n1,2\n", file);
	fclose(file);
	return table_file;
}

/* What a call returns is the status of functions that have one; of others 0. */
#define VOID(call) ((call), 0)
#define ROWS                                                                                                \
	ROW(tsim_error, 0, VOID(tsim_error(S)))                                                             \
	ROW(tsim_error_where, 0, VOID(tsim_error_where(S, P(1, &place))))                                   \
	ROW(tsim_error_clear, 0, VOID(tsim_error_clear(S)))                                                 \
	ROW(tsim_status_text, 0, VOID(tsim_status_text(-7)))                                                \
	ROW(tsim_open, 0, VOID(tsim_close(tsim_open())))                                                    \
	ROW(tsim_close, 0, VOID(tsim_close(NULL)))                                                          \
	ROW(tsim_open_with, 3, tsim_open_with(P(0, &options), P(1, &opened)))                               \
	ROW(tsim_screen, 0, VOID(tsim_screen(S, NULL)))                                                     \
	ROW(tsim_log, 1, tsim_log(S, NULL))                                                                 \
	ROW(tsim_on_log, 0, VOID(tsim_on_log(S, NULL, NULL)))                                               \
	ROW(tsim_line, 3, tsim_line(S, P(1, "print a")))                                                    \
	ROW(tsim_string, 3, tsim_string(S, P(1, "print a")))                                                \
	ROW(tsim_text, 7, tsim_text(S, P(1, "print a"), P(2, "b")))                                         \
	ROW(tsim_file, 3, tsim_file(S, P(1, "/dev/null")))                                                  \
	ROW(tsim_stream, 7, tsim_stream(S, P(1, empty), P(2, "b")))                                         \
	ROW(tsim_check_report, 7, tsim_check_report(S, P(1, &whole), P(2, text), sizeof text, P(3, &size))) \
	ROW(tsim_has_quit, 0, VOID(tsim_has_quit(S, P(1, &whole))))                                         \
	ROW(tsim_stop, 0, VOID((tsim_stop(S), tsim_error_clear(sim))))                                      \
	ROW(tsim_step, 1, tsim_step(S, 1))                                                                  \
	ROW(tsim_on_step, 3, tsim_on_step(S, TSIM_END_OF_STEP, P(1, nothing), P(2, text)))                  \
	ROW(tsim_off_step, 3, tsim_off_step(S, TSIM_END_OF_STEP, P(1, nothing), NULL))                      \
	ROW(tsim_value, 7, tsim_value(S, P(1, "ke"), P(2, number)))                                         \
	ROW(tsim_evaluate, 7, tsim_evaluate(S, P(1, "x"), TSIM_PER_PARTICLE, P(2, &table)))                 \
	ROW(tsim_read, 7, tsim_read(S, P(1, "x"), TSIM_PER_PARTICLE, P(2, number), 2, 1))                   \
	ROW(tsim_extent, 15, tsim_extent(S, P(1, "x"), TSIM_PER_PARTICLE, P(2, &size), P(3, &columns)))     \
	ROW(tsim_output, 7, tsim_output(S, P(1, "c_total"), 0, P(2, &output)))                              \
	ROW(tsim_variable, 7, tsim_variable(S, P(1, "a"), P(2, "b")))                                       \
	ROW(tsim_variable_set, 15, tsim_variable_set(S, P(1, "a"), P(2, "string"), P(3, "b")))              \
	ROW(tsim_variable_number, 3, tsim_variable_number(S, P(1, "n"), 2.385))                             \
	ROW(tsim_variable_text, 7, tsim_variable_text(S, P(1, "n"), P(2, text), sizeof text, P(3, &size)))  \
	ROW(tsim_variable_name, 0, VOID(tsim_variable_name(S, 0)))                                          \
	ROW(tsim_count, 0, VOID(tsim_count(S)))                                                             \
	ROW(tsim_column_read, 7, tsim_column_read(S, P(1, "x"), P(2, number), 2))                           \
	ROW(tsim_column_write, 7, tsim_column_write(S, P(1, "vx"), P(2, number), 2))                        \
	ROW(tsim_gather, 7, tsim_gather(S, P(1, "x"), P(3, id), P(2, number), 2))                           \
	ROW(tsim_scatter, 7, tsim_scatter(S, P(1, "vx"), P(3, id), P(2, number), 2))                        \
	ROW(tsim_quantity_name, 0, VOID(tsim_quantity_name(0)))                                             \
	ROW(tsim_column_view, 7, tsim_column_view(S, P(1, "x"), P(2, &view)))                               \
	ROW(tsim_hold, 1, tsim_hold(S, NULL))                                                               \
	ROW(tsim_release, 0, VOID(tsim_release(S, P(1, text))))                                             \
	ROW(tsim_generation, 0, VOID(tsim_generation(S)))                                                   \
	ROW(tsim_column_name, 0, VOID(tsim_column_name(S, 0)))                                              \
	ROW(tsim_pairs, 7, (tsim_string(sim, contacts), tsim_pairs(S, P(1, id), 1, P(2, &size))))           \
	ROW(tsim_external, 15,                                                                              \
	    (tsim_string(sim, "fix given all external pf/array 1"),                                         \
	     tsim_external(S, P(1, "given"), P(2, "energy"), P(3, number), 1)))                             \
	ROW(tsim_create, 3, tsim_create(S, P(1, &particles), P(2, id)))                                     \
	ROW(tsim_delete, 3, tsim_delete(S, P(1, id), 1))                                                    \
	ROW(tsim_group_bit, 7, tsim_group_bit(S, P(1, "all"), P(2, &whole)))                                \
	ROW(tsim_group_name, 0, VOID(tsim_group_name(S, 0)))                                                \
	ROW(tsim_group_get, 7, tsim_group_get(S, P(1, "all"), P(2, member), 2))                             \
	ROW(tsim_group_set, 7, tsim_group_set(S, P(1, "some"), P(2, member), 2))                            \
	ROW(tsim_box, 0, VOID(tsim_box(S, P(1, &box))))                                                     \
	ROW(tsim_clock, 0, VOID(tsim_clock(S, NULL, P(1, number), P(2, number))))                           \
	ROW(tsim_setting, 7, tsim_setting(S, P(1, "dt"), P(2, number)))                                     \
	ROW(tsim_setting_name, 0, VOID(tsim_setting_name(0, P(1, &name))))                                  \
	ROW(tsim_live, 0, VOID(tsim_live(S, P(1, "compute"), 0, P(2, &name))))                              \
	ROW(tsim_on_row, 0, VOID(tsim_on_row(S, NULL, NULL)))                                               \
	ROW(tsim_tables, 7, tsim_tables(S, P(1, write_table()), P(2, &size)))                               \
	ROW(tsim_table, 3, (tsim_tables(sim, write_table(), &size), tsim_table(S, 0, P(1, &sheet))))        \
	ROW(tsim_table_column, 1,                                                                           \
	    (tsim_tables(sim, write_table(), &size),                                                        \
	     tsim_table_column(S, 0, 1, P(1, &name), P(2, &values))))                                       \
	ROW(tsim_feature, 0, VOID(tsim_feature(0, P(1, &name))))                                            \
	ROW(tsim_version, 0, VOID(tsim_version()))                                                          \
	ROW(tsim_kind, 0, VOID(tsim_kind(0)))                                                               \
	ROW(tsim_style, 0, VOID(told(tsim_style(P(1, "fix"), 0, P(2, &name)))))                             \
	ROW(tsim_help, 7, tsim_help(P(0, "fix"), P(1, "nve"), 0, P(2, text), sizeof text, P(3, &size)))     \
	ROW(tsim_argument, 7, tsim_argument(P(0, "fix"), P(1, "gravity"), 0, P(2, &argument)))

static void open_sim(void)
{
	sim = tsim_open();
	ck_assert_ptr_nonnull(sim);
	ck_assert_int_eq(tsim_string(sim, "region b block 0 1 0 1 0 1 units box\ncreate_box 1 b\n"
					  "create_atoms 1 single 0.1 0.5 0.5 units box\n"
					  "create_atoms 1 single 0.9 0.5 0.5 units box\n"
					  "set type 1 diameter 0.1 density 2385\nfix move all nve\n"
					  "variable n equal 1\ncompute total all reduce sum x\n"),
			 0);
}

enum function {
#define ROW(function, needed, call) of_##function,
	ROWS
#undef ROW
		NFUNCTIONS
};
static const struct {
	const char *name;
	unsigned needed; /* pointers that may not be NULL */
} functions[] = {
#define ROW(function, needed, call) { #function, needed },
	ROWS
#undef ROW
};

static int call(enum function function)
{
	static const double places[] = { 0.3, 0.3, 0.3 };
	struct tsim_error_place place = { .size = sizeof place };
	struct tsim_options options = { .size = sizeof options };
	struct tsim_table table = { .size = sizeof table };
	struct tsim_output output = { .size = sizeof output };
	struct tsim_view view = { .size = sizeof view };
	struct tsim_particles particles = { .size = sizeof particles, .n = 1, .x = places };
	struct tsim_box box = { .size = sizeof box };
	struct tsim_argument argument = { .size = sizeof argument };
	struct tsim_sheet sheet = { .size = sizeof sheet };
	struct tsim *opened = NULL;
	FILE *empty = fopen("/dev/null", "r");
	int status = -1;

	switch (function) {
#define ROW(function, needed, call) \
	case of_##function:         \
		status = (call);    \
		break;
		ROWS
#undef ROW
			case NFUNCTIONS : break;
	}
	remove(table_file);
	fclose(empty);
	tsim_close(opened);
	return status;
}

/* Each pointer alone, and all of them. What is refused says which function and which argument. */
START_TEST(one_function)
{
	const unsigned needed = functions[_i].needed;

	for (unsigned k = 0; k <= 4; k++) {
		int status;

		null = k < 4 ? 1u << k : 15u;
		open_sim();
		status = call((enum function)_i);
		if (null & needed) {
			ck_assert_int_ne(status, TSIM_OK);
			if (!(null & 1) && strcmp(functions[_i].name, "tsim_open_with") != 0 &&
			    tsim_error(sim)[0])
				ck_assert_ptr_nonnull(strstr(tsim_error(sim), "NULL"));
		} else if (strcmp(functions[_i].name, "tsim_check_report") != 0 &&
			   strcmp(functions[_i].name, "tsim_off_step") != 0) {
			ck_assert_int_eq(status, TSIM_OK);
		}
		tsim_close(sim);
	}
	sim = NULL;
	ck_assert_str_eq(tsim_error(NULL), "error: out of memory\n");
}
END_TEST

static bool is_listed(const char *function)
{
	bool is = false;

	for (int k = 0; k < NFUNCTIONS; k++)
		is |= strcmp(functions[k].name, function) == 0;
	return is;
}

/* The name that stands before the first parenthesis of a line that begins with TSIM_API. */
START_TEST(all_functions_are_here)
{
	const char *top = getenv("top_srcdir");
	char line[400], path[1000];
	FILE *header;
	int n = 0;

	snprintf(path, sizeof path, "%s/src/tsim.h", top ? top : "..");
	header = fopen(path, "r");
	ck_assert_ptr_nonnull(header);
	while (fgets(line, sizeof line, header)) {
		char *end = strchr(line, '('), *begin = end;

		if (strncmp(line, "TSIM_API ", 9) != 0 || !end)
			continue;
		while (begin > line && (isalnum((unsigned char)begin[-1]) || begin[-1] == '_'))
			begin--;
		*end = '\0';
		ck_assert_msg(is_listed(begin), "%s has no row in tests/library/check_library_null.c", begin);
		n++;
	}
	fclose(header);
	ck_assert_int_eq(n, NFUNCTIONS);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("library with NULL");
	TCase *tests = tcase_create("all");

	tcase_add_loop_test(tests, one_function, 0, NFUNCTIONS);
	tcase_add_test(tests, all_functions_are_here);
	suite_add_tcase(suite, tests);
	return deck_main(suite);
}
