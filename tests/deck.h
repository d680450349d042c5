/* Short scripts in tests, and their results. */
#ifndef TESTS_DECK_H
#define TESTS_DECK_H

#include <math.h>
#include <stdbool.h>
#include <stdio.h>

#include "asserts.h"
#include "tsim.h"

/* A simulation that has run the script; the test fails where the script does. */
struct tsim *deck_open(const char *format, ...) __attribute__((format(printf, 1, 2)));
/* Runs more lines. */
void deck(struct tsim *sim, const char *format, ...) __attribute__((format(printf, 2, 3)));
/* The same where failure is a result; tsim_error tells. */
bool deck_accepts(struct tsim *sim, const char *format, ...) __attribute__((format(printf, 2, 3)));

double deck_value(struct tsim *sim, const char *formula);
/* A particle column in the order of identities, whatever the order in memory; the n identities that
 * live must be the n smallest after `skip`. */
void deck_column(struct tsim *sim, const char *name, double *out, size_t n, int skip);

/* Of two simulations of spheres that turn all particles are the same, bit for bit and in the same order. */
void deck_same(const struct tsim *one, const struct tsim *other);

/* Slope of log error against log step: the order of a scheme. */
double deck_order(const double *step, const double *error, size_t n);

/* Where a test also writes what it measured: the file named by the environment variable TS_TABLE,
 * or NULL. */
FILE *deck_table(const char *title);
/* Runs the tests of one file; the value is that of main. */
int deck_main(Suite *suite);

#define DECK_LENGTH(array) (sizeof(array) / sizeof *(array))

/* |a - b| <= tolerance, with all digits said if not. */
#define DECK_NEAR(a, b, tolerance)                                                                          \
	do {                                                                                                \
		double near_a = (a), near_b = (b);                                                          \
		ck_assert_msg(fabs(near_a - near_b) <= (tolerance), "%s = %.17g, expected %.17g within %g", \
			      #a, near_a, near_b, (double)(tolerance));                                     \
	} while (0)

#endif
