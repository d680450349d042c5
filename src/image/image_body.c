#include "image/image_body.h"

#include "flow/fluid.h"

#include "base/banned.h"

enum ts_status ts_image_body_distances(struct tsim *sim, size_t n, const double (*place)[3], double reach,
				       double *distance)
{
	struct ts_instance *fix;

	for (size_t k = 0; k < n; k++)
		distance[k] = reach;
	for (size_t k = 0; (fix = ts_sim_next_of(sim, TS_KIND_FIX, TS_FAMILY_FLOW_PART, &k));) {
		const struct ts_flow_part *part = fix->state;

		if (part->distance)
			TS_TRY(part->distance(fix, sim, n, place, reach, distance));
	}
	return TS_OK;
}
