/* One number out of one for each particle of a group, or each row of a local table: what computes reduce
 * and reduce/region share. */
#ifndef TS_AVERAGE_REDUCE_H
#define TS_AVERAGE_REDUCE_H

#include "core/ref_list.h"
#include "core/sim.h"

/* First member of the state. */
struct ts_reduce {
	int mode, inputs;
	struct ts_words words, replace;
	bool at_run_end;	    /* accepted: outputs are always those of now */
	struct ts_instance *region; /* NULL: everywhere */
	struct ts_ref_list input;
	int64_t *instead; /* of input k the value where input instead[k] is extreme; -1: its own */
	struct ts_table each, other;
	struct tsim *sim; /* evaluation may need memory */
};
#define TS_REDUCE_ARGS(T)                                                                                  \
	TS_ENUM("mode", T, reduce.mode, ts_reduction_names, .flags = TS_POSITIONAL,                        \
		.help = "what is made of the values"),                                                     \
		TS_LIST("values", T, reduce.words,                                                         \
			.help = "x, vx, fx, radius ..., c_ID, c_ID[k], c_ID[*], f_ID, f_ID[k] or v_name"), \
		TS_ENUM("inputs", T, reduce.inputs, ts_reduce_inputs, .fallback = "any",                   \
			.help = "whether outputs that have both are taken per particle or as "             \
				"local tables"),                                                           \
		TS_BOOL("update_on_run_end", T, reduce.at_run_end, .fallback = "no",                       \
			.help = "accepted: outputs are always those of now"),                              \
		TS_REST_KEYWORD("replace", T, reduce.replace,                                              \
				.help = "comes last: numbers m n of two inputs, with min or max; "         \
					"of input m the value is taken where input n is extreme; "         \
					"again `replace m n` for more")
extern const char *const ts_reduce_inputs[];
extern const struct ts_value ts_reduce_values[];

/* Slots of struct ts_style. */
enum ts_status ts_reduce_init(struct ts_instance *self, struct tsim *sim);
void ts_reduce_fini(struct ts_instance *self);

#endif
