/* For the files of this folder. */
#ifndef TS_VIEW_INTERNAL_H
#define TS_VIEW_INTERNAL_H

#include "view/view_data.h"

/* Finds a column with numbers, or adds that of a formula, or fails and says which there are. */
enum ts_status ts_view_find(const struct ts_view_data *v, struct ts_view_file *f, const char *name,
			    size_t *column);
/* Whether a text that is no name of a column may be a formula of columns. */
bool ts_view_is_formula(const char *text);
/* Adds the column of a formula to the parts of a file. */
enum ts_status ts_view_add_formula(const struct ts_view_data *v, struct ts_view_file *f, const char *text,
				   size_t *column);

#endif
