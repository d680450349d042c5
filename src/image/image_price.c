/* What pictures cost: memory, number of frames. */
#include <inttypes.h>

#include "core/report.h"
#include "image/image.h"

#include "base/banned.h"

/* Frames of a run that are worth a warning; more are those of a rerun, whose last step is not known. */
static const int64_t MANY = 100000, NO_END = INT64_C(1000000000000);

double ts_image_memory(const struct ts_image *s)
{
	const double pixels = (double)s->size.width * (double)s->size.height,
		     samples = s->fsaa ? 4 * pixels : 0;

	return 3 * pixels + 3 * samples + (s->ssao.on ? 4 * (s->fsaa ? samples : pixels) : 0);
}

void ts_image_warn_frames(struct ts_instance *self, struct tsim *sim, double bytes)
{
	const struct ts_image *s = self->state;
	const struct ts_dump_common *d = &s->common;
	const int64_t frames = d->variable ? 0 : ts_report_count(sim, d->every);

	if (d->frames != 1 || !sim->run.inside || frames <= MANY || frames >= NO_END)
		return;
	if (bytes > 0)
		ts_warn(&sim->log, &self->where,
			"dump %s: this run writes %" PRId64 " pictures, one in %" PRId64
			" steps, about %.2g GB in all",
			self->id, frames, d->every, 1e-9 * bytes * (double)frames);
	else
		ts_warn(&sim->log, &self->where,
			"dump %s: this run draws %" PRId64 " pictures, one in %" PRId64 " steps", self->id,
			frames, d->every);
}
