/* Models and constants of contact laws from the words of the style and the properties of materials. */
#ifndef TS_CONTACT_MATERIALS_H
#define TS_CONTACT_MATERIALS_H

#include "contact/material_words.h"

struct ts_granular_model ts_contact_model_of_words(const struct tsim *sim,
						   const struct ts_granular_words *words);

/* The constants of the law for types a and b, from fix property/global; `who` needs them, for messages. */
enum ts_status ts_contact_law_of_materials(struct tsim *sim, const struct ts_granular_model *model, int a,
					   int b, const char *who, const struct ts_place *where,
					   struct ts_granular_pair *out);

#endif
