/* References: names in scripts that refer to values of computes, fixes, variables and thermo keywords,
 * such as c_ID[2], f_ID, v_NAME, ke. */
#ifndef TS_CORE_REF_H
#define TS_CORE_REF_H

#include "core/value.h"

enum ts_ref_kind {
	TS_REF_KEYWORD,
	TS_REF_COMPUTE,
	TS_REF_FIX,
	TS_REF_VARIABLE,
	TS_REF_COLUMN /* f_NAME: a column of particles that some fix stores under that name */
};
struct ts_keyword;
struct ts_ref {
	enum ts_ref_kind kind;
	const char *name;	  /* as written, with brackets; owned by the caller */
	uint64_t removals;	  /* sim->removals when it was resolved */
	struct ts_instance *inst; /* compute or fix */
	const struct ts_keyword *keyword;
	const char *variable, *quantity;
	long index;  /* k of [k], counted from 1; 0: none given */
	long column; /* j of [i][j]; 0: none given */
};

/* The number of elements of c_thermo_press, a compute that LIGGGHTS and LAMMPS define by themselves; of other names 0. */
size_t ts_ref_standard_elements(const struct tsim *sim, const char *head);

/* Resolves a name. `name` must outlive the ref (argument tables copy it to the owner's arena). If the
 * compute or fix is deleted and defined anew, the ref refers to the new one. */
enum ts_status ts_ref_resolve(struct tsim *sim, const char *name, const struct ts_place *where,
			      struct ts_ref *ref);
enum ts_status ts_ref_scalar(struct tsim *sim, const struct ts_ref *ref, const struct ts_place *where,
			     double *out);
/* One value per local particle, in the order of storage. A scalar is repeated. */
enum ts_status ts_ref_peratom(struct tsim *sim, const struct ts_ref *ref, const struct ts_place *where,
			      struct ts_table *out);
/* A whole global vector (c_ID, f_ID without index), or column j of an array (c_ID[j]). */
enum ts_status ts_ref_vector(struct tsim *sim, const struct ts_ref *ref, const struct ts_place *where,
			     struct ts_table *out);
/* One column of a local table: c_ID[k], or c_ID where it has one column. */
enum ts_status ts_ref_local(struct tsim *sim, const struct ts_ref *ref, const struct ts_place *where,
			    struct ts_table *out);
/* Fails if no output of the compute or fix that has one of these shapes (bits 1 << shape) with the indices has an element or
 * column of its number; where their number is known only after evaluation, that tells. Not for formulas, where c_ID[k] may be
 * the value of particle k. */
enum ts_status ts_ref_check_index(struct tsim *sim, const struct ts_ref *ref, unsigned shapes,
				  const struct ts_place *where);
/* Checks names and shapes in the formula of a variable without evaluating it. */
enum ts_status ts_ref_check(struct tsim *sim, const struct ts_ref *ref, const struct ts_place *where);
/* The shapes a ref can be evaluated as: bits 1 << shape. */
unsigned ts_ref_shapes(const struct tsim *sim, const struct ts_ref *ref);

#endif
