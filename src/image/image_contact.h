/* Force chains: the keyword contact. */
#ifndef TS_IMAGE_IMAGE_CONTACT_H
#define TS_IMAGE_IMAGE_CONTACT_H

#include "image/image_groups.h"

struct ts_image_contacts {
	struct ts_image_group group;
	const char *id, *colour_name;
	double width, factor; /* of the largest force, length; length by force; NaN: not given */
	struct ts_instance *compute;
	struct ts_colour colour;
	/* of the present frame */
	size_t pos, force; /* columns */
};
enum ts_status ts_image_read_contacts(struct ts_instance *self, struct tsim *sim);
enum ts_status ts_image_add_contacts(struct ts_instance *self, struct tsim *sim);

#endif
