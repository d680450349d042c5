/* Planes that cut the scene open: the keyword clip. */
#include "image/image_clip.h"

#include "base/axes.h"

#include "base/banned.h"

static const char *const sides[] = { "above", "below", NULL };

static const struct ts_arg rows[] = {
	TS_ENUM("axis", struct ts_image_clip, axis, ts_axis_names, .flags = TS_POSITIONAL,
		.help = "that the plane is perpendicular to"),
	TS_NUMBER("position", struct ts_image_clip, position, .flags = TS_POSITIONAL,
		  .help = "coordinate of the plane (length), number or variable"),
	TS_ENUM("side", struct ts_image_clip, below, sides, .flags = TS_POSITIONAL,
		.help = "what is removed: above or below that coordinate"),
	TS_ARGS_END,
};

enum ts_status ts_image_read_clips(struct ts_instance *self, struct tsim *sim)
{
	struct ts_image *d = self->state;
	void *array = d->clip;

	TS_TRY(ts_image_read_groups(self, sim, "clip", rows, d->clip_words, sizeof *d->clip, &array,
				    &d->nclips));
	d->clip = array;
	if (d->nclips > TS_SCENE_CUTS)
		return ts_fail(&sim->error, TS_RANGE, &d->clip[TS_SCENE_CUTS].group.keyword.place,
			       "dump image: %zu keywords clip, more than %d", d->nclips, TS_SCENE_CUTS);
	return TS_OK;
}

enum ts_status ts_image_add_clips(struct ts_instance *self, struct tsim *sim)
{
	struct ts_image *d = self->state;

	for (size_t n = 0; n < d->nclips; n++) {
		const struct ts_image_clip *clip = &d->clip[n];
		struct ts_scene_cut *cut = &d->scene.cut[d->scene.ncuts];
		double position;

		TS_TRY(ts_number_now(sim, &clip->position, &clip->group.keyword.place, &position));
		if (!isfinite(position))
			continue; /* nothing is beyond it */
		*cut = (struct ts_scene_cut){ .offset = clip->below ? -position : position };
		cut->normal[clip->axis] = clip->below ? -1 : 1;
		d->scene.ncuts++;
	}
	return TS_OK;
}
