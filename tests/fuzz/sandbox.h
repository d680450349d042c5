/* Fuzzed input must not reach the machine. The linker sends every call that touches files, processes or
 * the environment through sandbox.c (options -Wl,--wrap=...). Within an input, what is written goes to
 * /dev/null, the file "input" can be read and nothing else, blocks of more than 64 MB, and with the address
 * sanitizer more than 512 MB in all, are refused, and
 * after a third of a second of processor time the simulation is asked to stop. */
#ifndef TS_FUZZ_SANDBOX_H
#define TS_FUZZ_SANDBOX_H

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

struct tsim;

void sandbox_enter(struct tsim *sim, const uint8_t *input, size_t n);
/* Shows the message of the simulation, if there is FUZZ_VERBOSE in the environment. */
void sandbox_report(struct tsim *sim);
void sandbox_leave(void);
/* A file of the machine, from within or without. */
FILE *sandbox_open(const char *path, const char *mode);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);
int LLVMFuzzerInitialize(int *argc, char ***argv);

#endif
