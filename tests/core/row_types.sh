#!/bin/bash
# Rows of arguments and of saved state whose type is not that of their field do not compile.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

# compiles ROW: in a table, for a state with fields of all types
compiles() {
	cat >row.c <<END
#include <stdint.h>
#include "core/arg.h"
#include "core/archive.h"
enum face { LOW, HIGH };
struct state {
	double x, v[3], turn[3][3], *pointer;
	float single;
	bool on, all[4];
	int64_t n, list[2];
	int32_t i;
	uint64_t seed;
	uint8_t byte;
	enum face face, faces[3][2];
	struct { double a; bool b; } parts;
};
extern const struct ts_saved saved[];
const struct ts_saved saved[] = { ${1} TS_SAVED_ROWS_END };
extern const struct ts_arg args[];
const struct ts_arg args[] = { ${2-} TS_ARGS_END };
END
	# shellcheck disable=SC2086
	$CC -std=c11 -I"$top_srcdir/src" $CFLAGS -fsyntax-only row.c >out 2>&1
}
right() {
	compiles "$@"
	report "compiles: $*" $? out
}
wrong() {
	! compiles "$@" && shows 'differ in type' out
	report "does not compile: $*" $? out
}
for field in x v turn parts.a; do right "TS_SAVE_F64(struct state, $field),"; done
for field in n list seed; do right "TS_SAVE_I64(struct state, $field),"; done
for field in i face faces; do right "TS_SAVE_I32(struct state, $field),"; done
for field in on all byte parts.b; do right "TS_SAVE_U8(struct state, $field),"; done

for field in pointer single on all n i face parts; do wrong "TS_SAVE_F64(struct state, $field),"; done
for field in x v i on pointer; do wrong "TS_SAVE_I64(struct state, $field),"; done
for field in x single n on; do wrong "TS_SAVE_I32(struct state, $field),"; done
for field in x n i face parts; do wrong "TS_SAVE_U8(struct state, $field),"; done

right '' 'TS_REAL("x", struct state, x, .help = "a number"),'
wrong '' 'TS_REAL("x", struct state, n, .help = "a number"),'
wrong '' 'TS_BOOL("x", struct state, i, .help = "a flag"),'
finish
