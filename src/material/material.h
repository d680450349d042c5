/* Material files: properties by name for atom types, in SI units, converted to the units of the script.
 * A `fix property/global` of the same name takes precedence.
 *
 * The value of a pair of materials is the one that either file gives for the other material (`NAME with
 * OTHER value unit`), else that of the material if both are the same, else the mean of the two values
 * with a warning. */
#ifndef TS_MATERIAL_MATERIAL_H
#define TS_MATERIAL_MATERIAL_H

#include "base/map.h"
#include "core/sim.h"

struct ts_hash;

struct ts_material_value {
	/* partner: name of another material, or NULL: value of the material itself */
	const char *name, *partner;
	double value;
	struct ts_place where;
};

struct ts_material {
	const char *name; /* name of the file without folder and ending; NULL: no material */
	struct ts_material_value *value;
	size_t n, capacity;
};

struct ts_materials {
	struct ts_material *of; /* by atom type, from 1 */
	size_t n;
	/* set of "friction of glass with steel" ...: means that a warning was printed for */
	struct ts_map warned;
};

/* Assigns the material of this file to the atom type. */
enum ts_status ts_material_read(struct tsim *sim, int type, const struct ts_word *file);

/* Value for an atom type (b = 0) or a pair of types, *found if the files give it; and the place in the
 * file. */
enum ts_status ts_material_find(struct tsim *sim, const char *name, int a, int b, bool *found, double *out);
const struct ts_place *ts_material_place(const struct tsim *sim, const char *name, int a, int b);
/* Name of the material of an atom type; NULL: none. */
const char *ts_material_name(const struct tsim *sim, int type);
/* Whether any material file contains this property. */
bool ts_material_given(const struct tsim *sim, const char *name);

void ts_materials_fingerprint(const struct ts_materials *m, struct ts_hash *hash);
void ts_materials_release(struct ts_materials *m);

#endif
