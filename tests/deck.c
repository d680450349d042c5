#include "deck.h"

#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "core/sim.h"
#include "math/fit.h"
#include "particle/particles.h"

enum { LONGEST = 1 << 16, MOST = 4096 };

static bool run_text(struct tsim *sim, const char *format, va_list args)
{
	char *text = malloc(LONGEST);
	int length, failed;

	ck_assert_ptr_nonnull(text);
	length = vsnprintf(text, LONGEST, format, args);
	ck_assert_int_lt(length, LONGEST);
	failed = tsim_string(sim, text);
	free(text);
	return !failed;
}

struct tsim *deck_open(const char *format, ...)
{
	struct tsim *sim = tsim_open();
	va_list args;
	bool done;

	ck_assert_ptr_nonnull(sim);
	va_start(args, format);
	done = run_text(sim, format, args);
	va_end(args);
	ck_assert_msg(done, "%s", tsim_error(sim));
	return sim;
}

void deck(struct tsim *sim, const char *format, ...)
{
	va_list args;
	bool done;

	va_start(args, format);
	done = run_text(sim, format, args);
	va_end(args);
	ck_assert_msg(done, "%s", tsim_error(sim));
}

bool deck_accepts(struct tsim *sim, const char *format, ...)
{
	va_list args;
	bool done;

	va_start(args, format);
	done = run_text(sim, format, args);
	va_end(args);
	return done;
}

double deck_value(struct tsim *sim, const char *formula)
{
	double value = NAN;

	ck_assert_msg(!tsim_value(sim, formula, &value), "%s", tsim_error(sim));
	return value;
}

void deck_column(struct tsim *sim, const char *name, double *out, size_t n, int skip)
{
	static double id[MOST], value[MOST];

	ck_assert_uint_le(n, MOST);
	ck_assert_uint_eq(tsim_count(sim), n);
	ck_assert_msg(!tsim_column_read(sim, "id", id, n), "%s", tsim_error(sim));
	ck_assert_msg(!tsim_column_read(sim, name, value, n), "%s", tsim_error(sim));
	for (size_t i = 0; i < n; i++) {
		int tag = (int)id[i] - skip;

		ck_assert_int_ge(tag, 1);
		ck_assert_int_le(tag, (int)n);
		out[tag - 1] = value[i];
	}
}

void deck_same(const struct tsim *one, const struct tsim *other)
{
	const struct ts_particles *a = one->particles, *b = other->particles;

	ck_assert_uint_eq(a->n, b->n);
	ck_assert(!memcmp(a->tag, b->tag, a->n * sizeof *a->tag));
	ck_assert(!memcmp(a->x, b->x, a->n * sizeof *a->x));
	ck_assert(!memcmp(a->v, b->v, a->n * sizeof *a->v));
	ck_assert(!memcmp(a->omega, b->omega, a->n * sizeof *a->omega));
	ck_assert(!memcmp(a->f, b->f, a->n * sizeof *a->f));
	ck_assert(!memcmp(a->torque, b->torque, a->n * sizeof *a->torque));
}

double deck_order(const double *step, const double *error, size_t n)
{
	double x[64], y[64];
	struct ts_fit fit;

	ck_assert_uint_le(n, 64);
	for (size_t k = 0; k < n; k++) {
		x[k] = log(step[k]);
		y[k] = log(error[k]);
	}
	ck_assert(ts_fit_line(x, y, n, &fit) == TS_OK);
	return fit.slope;
}

FILE *deck_table(const char *title)
{
	const char *path = getenv("TS_TABLE");
	FILE *file = path ? fopen(path, "a") : NULL;

	ck_assert_msg(!path || file, "cannot write %s", path);
	if (file)
		fprintf(file, "%s%s", title, *title ? "\n\n" : "\n");
	return file;
}

int deck_main(Suite *suite)
{
	SRunner *runner = srunner_create(suite);
	int failed;

	srunner_run_all(runner, CK_NORMAL);
	failed = srunner_ntests_failed(runner);
	srunner_free(runner);
	return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
