/* The table of the checks of the review. */
#ifndef TS_REVIEW_TABLE_H
#define TS_REVIEW_TABLE_H

#include "core/review.h"

extern const struct ts_review_check ts_review_table[]; /* closed by .name NULL */

#endif
