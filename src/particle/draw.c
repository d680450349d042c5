#include "particle/draw.h"

#include <math.h>
#include <stdlib.h>

#include "base/sort.h"
#include "math/rng.h"
#include "particle/particles.h"

#include "base/banned.h"

static int compare_draws(const void *a, const void *b)
{
	const struct ts_draw *p = a, *q = b;

	if (p->number != q->number)
		return p->number < q->number ? -1 : 1;
	return (p->tag > q->tag) - (p->tag < q->tag);
}

enum ts_status ts_draw(struct tsim *sim, const unsigned char *chosen, int64_t seed, struct ts_draw **out,
		       size_t *n)
{
	const struct ts_particles *p = sim->particles;
	struct ts_draw *draw = ts_alloc(p->n, sizeof *draw);

	*n = 0;
	*out = draw;
	if (!draw)
		return ts_nomem(&sim->error);
	for (size_t i = 0; i < p->n; i++) {
		struct ts_rng rng = ts_rng_start((uint64_t)seed, (uint64_t)p->tag[i]);

		if (chosen[i])
			draw[(*n)++] = (struct ts_draw){ ts_rng_uniform(&rng), p->tag[i], (int32_t)i };
	}
	ts_sort(draw, *n, sizeof *draw, compare_draws);
	return TS_OK;
}

size_t ts_draw_below(const struct ts_draw *draw, size_t n, double probability)
{
	size_t below = 0;

	while (below < n && draw[below].number < probability)
		below++;
	return below;
}

size_t ts_draw_part(size_t n, double part)
{
	return (size_t)floor(part * (double)n + 0.5);
}
