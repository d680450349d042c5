/* Materials from files: properties by name for the particles of a type, in SI units, turned into those of
 * the script. Their place in the order of things: `fix property/global` of the same name goes before.
 *
 * A pair of materials has the value that either file gives for the other (`NAME with OTHER value unit`),
 * else that of the one material they both are, else the mean of their own, and that is said. */
#ifndef TS_MATERIAL_MATERIAL_H
#define TS_MATERIAL_MATERIAL_H

#include "base/map.h"
#include "core/sim.h"

struct ts_hash;

struct ts_material_value {
	const char *name, *partner; /* another material, or NULL: among its own */
	double value;
	struct ts_place where;
};

struct ts_material {
	const char *name; /* of the file, without folder and ending; NULL: none was given */
	struct ts_material_value *value;
	size_t n, capacity;
};

struct ts_materials {
	struct ts_material *of; /* by type, from 1 */
	size_t n;
	struct ts_map told; /* "friction of glass with steel": means that were said to be taken */
};

/* The type is of the material in that file from now on. */
enum ts_status ts_material_read(struct tsim *sim, int type, const struct ts_word *file);

/* The value for a type (b = 0) or a pair of types, if the files give it; and where. */
enum ts_status ts_material_find(struct tsim *sim, const char *name, int a, int b, bool *found, double *out);
const struct ts_place *ts_material_place(const struct tsim *sim, const char *name, int a, int b);
/* Of the material of a type; NULL: none was given. */
const char *ts_material_name(const struct tsim *sim, int type);
/* Whether any file gives it. */
bool ts_material_given(const struct tsim *sim, const char *name);

void ts_materials_fingerprint(const struct ts_materials *m, struct ts_hash *hash);
void ts_materials_release(struct ts_materials *m);

#endif
