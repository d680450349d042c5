/* Keywords of dump image that may be given several times, with words that a table describes. */
#ifndef TS_IMAGE_IMAGE_GROUPS_H
#define TS_IMAGE_IMAGE_GROUPS_H

#include "image/image.h"

/* First member of the struct that the words of one keyword are read into. */
struct ts_image_group {
	struct ts_word keyword;
	struct ts_words words; /* after it */
};

/* In init: reads all words of the keyword `name` into structs of that size, which are made at the first call; `rows` set
 * their fields, the others are kept. *array, *n: the structs. */
enum ts_status ts_image_read_groups(struct ts_instance *self, struct tsim *sim, const char *name,
				    const struct ts_arg *rows, struct ts_words words, size_t size,
				    void **array, size_t *n);
/* The place of a word of the group, for messages; that of the keyword if it is a default. */
const struct ts_place *ts_image_group_word(const struct ts_image_group *group, const char *text);
/* The colour that a word of the group names. */
enum ts_status ts_image_group_colour(struct ts_instance *self, struct tsim *sim,
				     const struct ts_image_group *group, const char *name,
				     struct ts_colour *out);

#endif
