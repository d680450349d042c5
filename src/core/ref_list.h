/* Inputs as users write them after a style's name, one or many:
 *
 *   x vx radius ...   a number of each particle          c_ID  f_ID  v_NAME   an output, a variable
 *   step ke vol ...   a number of the table of the log    c_ID[3]              one column or element
 *                                                         c_ID[*]  c_ID[2*4]   several of them
 *
 * The style says which shapes it can use and evaluates input by input, or all into one table. */
#ifndef TS_CORE_REF_LIST_H
#define TS_CORE_REF_LIST_H

#include "core/value.h"

struct ts_ref_input {
	const char *name; /* one of those a `*` stood for: "c_ID[3]" */
	struct ts_place where;
	enum ts_shape shape; /* what it gives here */
	bool quantity;	     /* x, vx ...: no ref */
	struct ts_ref ref;
};

/* Zero-initialise; ts_ref_list_release when done. */
struct ts_ref_list {
	struct ts_ref_input *item;
	size_t n;
	struct ts_table column;
};

/* Bits for the shapes a style can use. */
#define TS_WANT(shape) (1u << TS_##shape)

/* Copies the words, each with a `*` in its brackets replaced by what it stands for. The shapes say
 * whether [*] are elements or columns. */
enum ts_status ts_refs_expand(struct tsim *sim, struct ts_arena *arena, struct ts_words words,
			      unsigned shapes, struct ts_words *out);

/* One name: of the shapes wanted, the one with most numbers is taken (PERATOM, LOCAL, ARRAY, VECTOR,
 * SCALAR). `what` names the owner in messages ("fix ave/time"). input->name and ->where are set. */
enum ts_status ts_ref_input_resolve(struct tsim *sim, const char *what, unsigned shapes,
				    struct ts_ref_input *input);

/* For the init of a style: the first call copies the words to the arena, every call finds anew what
 * the names stand for. */
enum ts_status ts_ref_list_init(struct tsim *sim, const char *what, struct ts_arena *arena,
				struct ts_words words, unsigned shapes, struct ts_ref_list *list);
/* Variables among the words of a fix, compute or dump: are their formulas right, as far as names and
 * shapes tell? */
enum ts_status ts_refs_check(struct tsim *sim, const struct ts_instance *inst);
void ts_ref_list_release(struct ts_ref_list *list);

/* The numbers of one input: one column; of an ARRAY all columns. */
enum ts_status ts_ref_input_eval(struct tsim *sim, const struct ts_ref_input *input, struct ts_table *out);
enum ts_status ts_ref_input_scalar(struct tsim *sim, const struct ts_ref_input *input, double *out);
/* One row of numbers, one for each input; all inputs are SCALAR. */
enum ts_status ts_ref_list_scalars(struct tsim *sim, const struct ts_ref_list *list, double *out);
/* A column for each input; an input of another length than the first is an error. */
enum ts_status ts_ref_list_table(struct tsim *sim, struct ts_ref_list *list, struct ts_table *out);

#endif
