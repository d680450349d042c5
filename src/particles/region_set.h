/* What the regions that combine others share. */
#ifndef TS_PARTICLES_REGION_SET_H
#define TS_PARTICLES_REGION_SET_H

#include "particles/region.h"

struct ts_region_set {
	struct ts_region region;
	int64_t n;
	struct ts_words names;
	struct ts_instance **member;
};
extern const struct ts_arg ts_region_set_args[];
enum ts_status ts_region_set_init(struct ts_instance *self, struct tsim *sim);
enum ts_status ts_region_set_update(struct ts_instance *self, struct tsim *sim);

#endif
