/* From the properties of materials to the constants of contact laws; and the words that choose the
 * laws, the same for pairs and walls. */
#ifndef TS_CONTACT_MATERIALS_H
#define TS_CONTACT_MATERIALS_H

#include "contact/material_words.h"

struct ts_granular_model ts_contact_model_of_words(const struct tsim *sim,
						   const struct ts_granular_words *words);

/* The constants for two types, from the properties; `who` needs them. */
enum ts_status ts_contact_law_of_materials(struct tsim *sim, const struct ts_granular_model *model, int a,
					   int b, const char *who, const struct ts_place *where,
					   struct ts_granular_pair *out);

#endif
