/* What styles let others read: outputs of computes and fixes, thermo keywords, variables.
 *
 * A style lists its outputs in rows; scripts read them as c_ID, c_ID[2], f_ID[1], v_NAME. */
#ifndef TS_CORE_VALUE_H
#define TS_CORE_VALUE_H

#include <stddef.h>
#include <stdint.h>

#include <stdbool.h>

#include "base/status.h"
#include "base/str.h"
#include "base/words.h"

struct tsim;
struct ts_instance;
struct ts_tables;

enum ts_shape {
	TS_SCALAR = 1, /* one number                                      c_ID                 */
	TS_VECTOR,     /* `columns` numbers, or as many as rows come out  c_ID[k]              */
	TS_PERATOM,    /* rows = local particles, `columns` each          c_ID or c_ID[k]      */
	TS_LOCAL,      /* any number of rows (contacts, bonds ...)        c_ID[k] in dump local */
	TS_ARRAY,      /* a table of numbers           c_ID[i][j]; its column j as a list: c_ID[j] */
	TS_SURFACE     /* rows = triangles of a mesh, `columns` each; f_ID[k] in dump mesh/vtk, and wherever
			* TS_LOCAL is read. The style says which mesh by its slot `surface`. */
};

/* A table of doubles that grows and is reused from call to call; zero-initialise. */
struct ts_table {
	double *data; /* data[row * columns + column] */
	size_t rows, columns, capacity;
};
enum ts_status ts_table_resize(struct ts_table *table, size_t rows, size_t columns);
void ts_table_release(struct ts_table *table);

/* One row of a style's output table; the list is closed by .name NULL. */
struct ts_value {
	const char *name, *unit, *help;
	enum ts_shape shape;
	size_t columns;			 /* 0: not known before evaluation */
	const char *const *column_names; /* may be NULL */
	/* Fills `out` (already resized for TS_SCALAR and, with columns > 0, TS_VECTOR). */
	enum ts_status (*eval)(struct ts_instance *self, const struct tsim *sim, struct ts_table *out);
};
/* Whether an instance has this output of its style, with its arguments. */
bool ts_value_given(const struct ts_instance *inst, const struct ts_value *value);
/* The first output of that shape; of TS_LOCAL else one of TS_SURFACE. NULL: none. */
const struct ts_value *ts_value_find(const struct ts_instance *inst, enum ts_shape shape);
enum ts_status ts_value_eval(struct ts_instance *inst, struct tsim *sim, const struct ts_value *value,
			     struct ts_table *out);

/* The same into the table of the instance, where it stays as long as nothing changes. */
enum ts_status ts_value_held(struct ts_instance *inst, struct tsim *sim, const struct ts_value *value);

/* A name that stands for a number or a list of numbers. */
enum ts_ref_kind {
	TS_REF_KEYWORD,
	TS_REF_COMPUTE,
	TS_REF_FIX,
	TS_REF_VARIABLE,
	TS_REF_COLUMN /* f_NAME: what some fix keeps of each particle under that name */
};
struct ts_keyword;
struct ts_ref {
	enum ts_ref_kind kind;
	const char *name;
	uint64_t removals;	  /* sim->removals when it was resolved */
	struct ts_instance *inst; /* compute or fix */
	const struct ts_keyword *keyword;
	const char *variable, *quantity;
	long index;  /* k of [k], counted from 1; 0: none given */
	long column; /* j of [i][j]; 0: none given */
};

/* Resolves a name. `name` must outlive the ref (arg tables copy it to the owner's arena). Should what it
 * names be deleted and defined anew, the ref goes on with the new one. */
enum ts_status ts_ref_resolve(struct tsim *sim, const char *name, const struct ts_place *where,
			      struct ts_ref *ref);
enum ts_status ts_ref_scalar(struct tsim *sim, const struct ts_ref *ref, const struct ts_place *where,
			     double *out);
/* One value per local particle, in local order. A scalar is repeated. */
enum ts_status ts_ref_peratom(struct tsim *sim, const struct ts_ref *ref, const struct ts_place *where,
			      struct ts_table *out);
/* A whole global vector (c_ID, f_ID without index), or column j of an array (c_ID[j]). */
enum ts_status ts_ref_vector(struct tsim *sim, const struct ts_ref *ref, const struct ts_place *where,
			     struct ts_table *out);
/* One column of a local table: c_ID[k], or c_ID where it has one column. */
enum ts_status ts_ref_local(struct tsim *sim, const struct ts_ref *ref, const struct ts_place *where,
			    struct ts_table *out);
/* Before it is asked for a number for the first time: is the formula of a variable right, as far as names
 * and shapes tell? */
enum ts_status ts_ref_reads(struct tsim *sim, const struct ts_ref *ref, const struct ts_place *where);
/* Which of the shapes a ref can give: bit (1 << shape) set. */
unsigned ts_ref_shapes(const struct tsim *sim, const struct ts_ref *ref);

enum ts_keyword_flags {
	TS_KEYWORD_INTEGER = 1,	 /* printed as %8ld */
	TS_KEYWORD_CONTACTS = 2, /* looks at the forces of contacts */
	/* what is known of it before a run that changes it: */
	TS_KEYWORD_CLOCK = 4, /* all, if it is known how many steps are made */
	TS_KEYWORD_BOX = 8,   /* all, if nothing changes the box */
	TS_KEYWORD_CONSTANT = 16
};

/* A named number of a system, usable in thermo_style and expressions; closed by .name NULL. */
struct ts_keyword {
	const char *name;  /* "vol" */
	const char *title; /* thermo column title: "Volume" */
	const char *unit, *help;
	int flags; /* enum ts_keyword_flags */
	enum ts_status (*eval)(struct tsim *sim, double *out);
};
const struct ts_keyword *ts_keyword_find(const struct ts_tables *tables, const char *name);
/* Notes what keywords in a line of the script may look at later: see sim->shows_contacts. */
void ts_keywords_named(struct tsim *sim, const char *text);

/* Per-particle numbers by script name (x, vy, radius ...), from whichever system has them. */
bool ts_quantity_has(const struct tsim *sim, const char *name);
enum ts_status ts_quantity_eval(struct tsim *sim, const char *name, struct ts_table *out);
/* Whether a fix keeps numbers of particles under the name NAME or NAME[k]. */
bool ts_quantity_kept(const struct tsim *sim, const char *name);
void ts_quantity_suggest(const struct tsim *sim, struct ts_suggest *suggest);
struct ts_quantity {
	const char *name, *unit, *help;
};

/* A function of expressions that needs the simulation: count(group), xcm(group,x) ...; closed by
 * .name NULL. Arguments come as words, since groups and regions are no numbers. */
struct ts_function {
	const char *name, *arguments, *help;
	size_t least, most; /* number of arguments */
	enum ts_status (*eval)(struct tsim *sim, struct ts_words args, double *out);
	/* One value per local particle, in formulas of particles; eval may be NULL then. */
	enum ts_status (*peratom)(struct tsim *sim, struct ts_words args, struct ts_table *out);
};
const struct ts_function *ts_function_find(const struct ts_tables *tables, const char *name);

/* Whether some system has a material property of that name (property/global of LIGGGHTS). */
bool ts_property_has(const struct tsim *sim, const char *name);

#endif
