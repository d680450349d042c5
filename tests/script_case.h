/* Short scripts in tests of the language: what they print, what they reject, and where. */
#ifndef TESTS_SCRIPT_CASE_H
#define TESTS_SCRIPT_CASE_H

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "asserts.h"
#include "core/sim.h"
#include "script/internal.h"
#include "tsim.h"

/* The simulation of the running test; what it shows is caught. */
extern struct tsim *sim;

/* Fixture of each test; the end checks that all memory is returned. */
void case_setup(void);
void case_teardown(void);

/* Runs the script, which must end well, and compares what it printed. */
void expect_output(const char *script, const char *output);
/* Runs the script, which must fail at this place with this message in it. */
void expect_error(const char *script, int line, int column, int length, const char *message);
double value(const char *formula);
/* The formula has this value to round-off. */
void expect_value(const char *formula, double wanted);
void write_file(const char *path, const char *text);
/* An empty directory to work in, and back again. */
void enter_directory(void);
void leave_directory(void);
/* Runs the tests of one file; the value is that of main. */
int case_main(const char *name, void (*add)(TCase *));

#endif
