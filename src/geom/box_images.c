#include "geom/box_images.h"

#include "base/banned.h"

/* Beyond, images are at distances at which rounding is larger than particles. */
static const double IMAGES_MOST = 1e6;

static double limited(double image)
{
	return fmin(fmax(image, -IMAGES_MOST), IMAGES_MOST);
}

struct ts_box_images ts_box_images(const struct ts_box *box, const double lo[3], const double hi[3],
				   const double from[3], const double to[3], double r)
{
	struct ts_box_images images = { 0 };

	for (int d = 0; d < 3; d++) {
		double length = ts_box_length(box, d);

		if (ts_box_periodic(box, d)) {
			images.range[d][0] = (int)ceil(limited((from[d] - r - hi[d]) / length));
			images.range[d][1] = (int)floor(limited((to[d] + r - lo[d]) / length));
		}
		images.shift[d] = images.range[d][0];
	}
	images.shift[2]--;
	return images;
}

bool ts_box_images_next(struct ts_box_images *images)
{
	for (int d = 2; d >= 0; d--) {
		if (++images->shift[d] <= images->range[d][1])
			return ts_box_images_have(images, images->shift);
		images->shift[d] = images->range[d][0];
	}
	return false;
}

bool ts_box_images_have(const struct ts_box_images *images, const int shift[3])
{
	bool have = true;

	for (int d = 0; d < 3; d++)
		have &= images->range[d][0] <= shift[d] && shift[d] <= images->range[d][1];
	return have;
}
