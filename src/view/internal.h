/* For the files of this folder. */
#ifndef TS_VIEW_INTERNAL_H
#define TS_VIEW_INTERNAL_H

#include "view/view_data.h"

/* Finds a column with numbers, or fails and says which there are. */
enum ts_status ts_view_find(const struct ts_view_data *v, const struct ts_view_file *f, const char *name,
			    size_t *column);

#endif
