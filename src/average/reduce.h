/* Reduction of the values of the particles of a group, or of the rows of a local array, to one number: shared
 * by compute reduce and compute reduce/region. */
#ifndef TS_AVERAGE_REDUCE_H
#define TS_AVERAGE_REDUCE_H

#include "core/ref_list.h"
#include "core/sim.h"

/* First member of the state. */
struct ts_reduce {
	int mode, inputs;		/* enum ts_reduction_mode; index of ts_reduce_inputs */
	struct ts_words words, replace; /* the values and the arguments of `replace` as given */
	bool at_run_end;		/* update_on_run_end: no effect */
	struct ts_instance *region;	/* NULL: everywhere */
	struct ts_ref_list input;
	int64_t *instead; /* [input] j: result k is the value of input k where input j is extreme; -1: its own
			   * reduction */
	struct ts_table values;	   /* of the input being reduced */
	struct ts_table criterion; /* of the input whose extreme row is searched */
	struct tsim *sim;	   /* inputs may allocate memory when evaluated */
};
#define TS_REDUCE_ARGS(T)                                                                                  \
	TS_ENUM("mode", T, reduce.mode, ts_reduction_names, .flags = TS_POSITIONAL,                        \
		.help = "reduction of the values"),                                                        \
		TS_LIST("values", T, reduce.words,                                                         \
			.help = "x, vx, fx, radius ..., c_ID, c_ID[k], c_ID[*], f_ID, f_ID[k] or v_name"), \
		TS_ENUM("inputs", T, reduce.inputs, ts_reduce_inputs, .fallback = "any",                   \
			.help = "for styles that have both: per-particle or local output"),                \
		TS_BOOL("update_on_run_end", T, reduce.at_run_end, .fallback = "no",                       \
			.help = "no effect: results are always those of the current step"),                \
		TS_REST_KEYWORD("replace", T, reduce.replace,                                              \
				.help = "last keyword: numbers m n of two inputs, with min or max: "       \
					"result m is input m where input n is extreme; repeat "            \
					"`replace m n` for more")
extern const char *const ts_reduce_inputs[];
extern const struct ts_value ts_reduce_values[];

/* Slots of struct ts_style. */
enum ts_status ts_reduce_init(struct ts_instance *self, struct tsim *sim);
size_t ts_reduce_width(const struct ts_instance *self);
void ts_reduce_fini(struct ts_instance *self);

#endif
