/* Values that scripts and styles can read: outputs of computes and fixes, thermo keywords, variables,
 * quantities of particles.
 *
 * A style lists its outputs in a table; scripts read them as c_ID, c_ID[2], f_ID[1], v_NAME. */
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
	TS_VECTOR,     /* `columns` numbers, or one for each row          c_ID[k]              */
	TS_PERATOM,    /* a row for each local particle                   c_ID or c_ID[k]      */
	TS_LOCAL,      /* a row for each contact, bond ...                c_ID[k] in dump local */
	TS_ARRAY,      /* a table of numbers           c_ID[i][j]; its column j as a vector: c_ID[j] */
	TS_SURFACE     /* a row for each element (triangle, plane) of a surface, which is that of the slot
			* `surface`; f_ID[k] in dump mesh/vtk, and wherever TS_LOCAL is read */
};

/* A table of doubles whose memory is reused from call to call; zero-initialise. */
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
	size_t columns;			 /* 0: known only after evaluation */
	const char *const *column_names; /* may be NULL */
	/* Fills `out`, which has been resized for TS_SCALAR and, if columns > 0, for TS_VECTOR. */
	enum ts_status (*eval)(struct ts_instance *self, const struct tsim *sim, struct ts_table *out);
};
/* Whether an instance has this output of its style with the arguments it was given. */
bool ts_value_given(const struct ts_instance *inst, const struct ts_value *value);
/* The first output of that shape; for TS_LOCAL otherwise one of TS_SURFACE. NULL: none. */
const struct ts_value *ts_value_find(const struct ts_instance *inst, enum ts_shape shape);
/* The number of columns of this output, or of elements of a vector; 0: known only after evaluation. */
size_t ts_value_width(const struct ts_instance *inst, const struct ts_value *value);
/* Calls the init of a style, which finds what it points to. */
enum ts_status ts_instance_init(struct ts_instance *inst, struct tsim *sim);
/* Between runs: if styles were deleted or defined anew since the init of a compute, finds again what it reads, or says what is
 * gone. ts_value_eval calls it; those that use the state of a compute do before. */
enum ts_status ts_value_find_again(struct ts_instance *inst, struct tsim *sim);
enum ts_status ts_value_eval(struct ts_instance *inst, struct tsim *sim, const struct ts_value *value,
			     struct ts_table *out);

/* The same into the table of the instance, unless it is there already, evaluated in this epoch of the run. */
enum ts_status ts_value_cached(struct ts_instance *inst, struct tsim *sim, const struct ts_value *value);

enum ts_keyword_flags {
	TS_KEYWORD_INTEGER = 1,	 /* printed as %8ld */
	TS_KEYWORD_CONTACTS = 2, /* reads the forces of contacts */
	/* -explain: its value behind a run that is left out is known */
	TS_KEYWORD_CLOCK = 4, /* if the number of steps of the run is known */
	TS_KEYWORD_BOX = 8,   /* if no run changes the box */
	TS_KEYWORD_CONSTANT = 16,
	TS_KEYWORD_LISTS = 32,	 /* reads lists of pairs, but no forces of contacts */
	TS_KEYWORD_FLUID = 64,	 /* reads the fluid only */
	TS_KEYWORD_FIELDS = 256, /* with TS_KEYWORD_FLUID: reads its fields, of which ranks have parts */
	TS_KEYWORD_SUM =
		128 /* while the particles are divided ranks evaluate it together, each by its own ones */
};

/* A named number of a system, for thermo_style and formulas; tables are closed by .name NULL. */
struct ts_keyword {
	const char *name;  /* "vol" */
	const char *title; /* thermo column title: "Volume" */
	const char *unit, *help;
	int flags; /* enum ts_keyword_flags */
	enum ts_status (*eval)(struct tsim *sim, double *out);
};
/* To be called when an output names the keyword: sets sim->run.shows_contacts, shows_lists. */
void ts_keyword_shows(struct tsim *sim, const struct ts_keyword *keyword);
const struct ts_keyword *ts_keyword_find(const struct ts_tables *tables, const char *name);
/* Before a run: an error if the keyword can have no value in it. */
enum ts_status ts_keyword_check(struct tsim *sim, const struct ts_keyword *keyword,
				const struct ts_place *where);
/* The same for all keywords in a script word. */
void ts_keywords_scan(struct tsim *sim, const char *text);

/* Quantities of particles by script name (x, vy, radius ...), from the system that has them. */
bool ts_quantity_has(const struct tsim *sim, const char *name);
enum ts_status ts_quantity_eval(struct tsim *sim, const char *name, struct ts_table *out);
/* Whether a fix stores a column of particles under the name NAME or NAME[k]. */
bool ts_quantity_kept(const struct tsim *sim, const char *name);
void ts_quantity_suggest(const struct tsim *sim, struct ts_suggest *suggest);
struct ts_quantity {
	const char *name, *unit, *help;
};

/* A function of formulas that reads the simulation: count(group), xcm(group,x) ...; tables are closed by
 * .name NULL. Arguments are words, such as names of groups and regions. */
struct ts_function {
	const char *name, *arguments, *help;
	size_t least, most; /* number of arguments */
	enum ts_status (*eval)(struct tsim *sim, struct ts_words args, double *out);
	/* One value per local particle, in formulas of variables of style atom; eval may be NULL then. */
	enum ts_status (*peratom)(struct tsim *sim, struct ts_words args, struct ts_table *out);
};
const struct ts_function *ts_function_find(const struct ts_tables *tables, const char *name);

#endif
