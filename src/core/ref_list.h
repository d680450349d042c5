/* Inputs of styles as written in scripts, one or many:
 *
 *   x vx radius ...   a number of each particle          c_ID  f_ID  v_NAME   an output, a variable
 *   step ke vol ...   a number of the table of the log    c_ID[3]              one column or element
 *                                                         c_ID[*]  c_ID[2*4]   several of them
 *
 * The style says which shapes it accepts and evaluates inputs one by one, or all into one table. */
#ifndef TS_CORE_REF_LIST_H
#define TS_CORE_REF_LIST_H

#include "core/ref.h"

struct ts_ref_input {
	const char *name; /* with a wildcard expanded: "c_ID[3]" */
	struct ts_place where;
	enum ts_shape shape; /* the shape it is evaluated as */
	bool quantity;	     /* a quantity of particles (x, vx ...); `ref` is not used */
	struct ts_ref ref;
};

/* Zero-initialise; ts_ref_list_release when done. */
struct ts_ref_list {
	struct ts_ref_input *item;
	size_t n;
	struct ts_table column;
};

/* Bits for the shapes a style accepts. */
#define TS_WANT(shape) (1u << TS_##shape)
/* With TS_WANT(VECTOR): the name of an array alone stands for all of its columns. */
#define TS_WANT_COLUMNS (1u << 31)

/* Copies the words; one with a `*` in its brackets becomes one word for each element or column, whichever
 * the accepted shapes mean. */
enum ts_status ts_refs_expand(struct tsim *sim, struct ts_arena *arena, struct ts_words words,
			      unsigned shapes, struct ts_words *out);

/* Resolves one name; input->name and ->where are set. Of several shapes accepted the first of PERATOM,
 * LOCAL, ARRAY, VECTOR, SCALAR is taken. `what` is the name of the owner for messages ("fix ave/time"). */
enum ts_status ts_ref_input_resolve(struct tsim *sim, const char *what, unsigned shapes,
				    struct ts_ref_input *input);

/* For the init of a style: the first call expands the words into the arena, every call resolves the names
 * anew. */
enum ts_status ts_ref_list_init(struct tsim *sim, const char *what, struct ts_arena *arena,
				struct ts_words words, unsigned shapes, struct ts_ref_list *list);
/* Checks names and shapes in the formulas of variables among the arguments of a fix, compute or dump. */
enum ts_status ts_refs_check(struct tsim *sim, const struct ts_instance *inst);
void ts_ref_list_release(struct ts_ref_list *list);

/* The values of one input: one column; of an ARRAY all columns. */
enum ts_status ts_ref_input_eval(struct tsim *sim, const struct ts_ref_input *input, struct ts_table *out);
enum ts_status ts_ref_input_scalar(struct tsim *sim, const struct ts_ref_input *input, double *out);
/* One number for each input; all inputs are SCALAR. */
enum ts_status ts_ref_list_scalars(struct tsim *sim, const struct ts_ref_list *list, double *out);
/* One column for each input; all must have the length of the first. */
enum ts_status ts_ref_list_table(struct tsim *sim, struct ts_ref_list *list, struct ts_table *out);

#endif
