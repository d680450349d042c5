#include "poisson/multigrid_slabs.h"

#include "base/banned.h"

/* Cells of a rank from which on a level is divided: with fewer the messages of its sweeps take longer than the other ranks'
 * share of them. */
enum { LEAST = 8192 };

/* Extends what is needed beside the planes from .. to - 1 by plane k; in a ring on the side that is nearer. */
static void need_plane(struct ts_multigrid_beside *beside, int from, int to, int k, int n, bool ring)
{
	int below = from - k, above = k - to + 1;

	if (k >= from && k < to)
		return;
	if (ring) {
		below = (below + n) % n;
		above = (above + n) % n;
		if (below <= above)
			above = 0;
		else
			below = 0;
	}
	beside->below = below > beside->below ? below : beside->below;
	beside->above = above > beside->above ? above : beside->above;
}

/* What ranks need of a level and of the next one to go from one to the other: the most of all ranks, as the one beside has to
 * know it. */
static void find_beside(struct ts_multigrid_level *fine, const struct ts_multigrid_level *coarse)
{
	const struct ts_multigrid_transfer *z = &fine->transfer[2];
	const int n = fine->s.n[2], m = coarse->s.n[2];
	const bool ring = fine->s.periodic[2];

	for (int r = 0; r < fine->slabs.world->n; r++) {
		const int from = (int)ts_slabs_part(&fine->slabs, r, (size_t)n),
			  to = (int)ts_slabs_part(&fine->slabs, r + 1, (size_t)n);
		const int first = (int)ts_slabs_part(&coarse->slabs, r, (size_t)m),
			  end = (int)ts_slabs_part(&coarse->slabs, r + 1, (size_t)m);

		for (int c = z->first[first]; c < z->first[end]; c++)
			need_plane(&fine->residual, from, to, z->cell[c], n, ring);
		for (int i = z->begin[first]; i < z->begin[end]; i++)
			need_plane(&fine->links, from, to, i, n, false);
		for (int i = from; i < to; i++)
			for (int side = 0; side < 2; side++) {
				const double share = side ? z->above[i] : 1 - z->above[i];
				const int c = z->below[i] + side;

				if (share != 0 && (ring || (c >= 0 && c < m)))
					need_plane(&fine->correction, first, end, (c + m) % m, m, ring);
			}
	}
}

static int most_beside(const struct ts_multigrid_beside *beside)
{
	return beside->below > beside->above ? beside->below : beside->above;
}

/* Whether ranks divide level k: its slabs have planes enough for the ranks beside. */
static bool divides(const struct ts_multigrid *m, int k, int ranks)
{
	const struct ts_multigrid_level *l = &m->level[k];
	const int thinnest = l->s.n[2] / ranks; /* or thicker */
	const int cells = l->s.n[0] * l->s.n[1] * l->s.n[2];

	if (k == m->levels - 1)
		return false;
	return thinnest >= 1 && thinnest >= most_beside(&l->residual) &&
	       most_beside(&l->links) <= (k == 0 ? TS_GRID_GHOSTS : thinnest) &&
	       (k == 0 || (thinnest >= most_beside(&m->level[k - 1].correction) && cells / ranks >= LEAST));
}

enum ts_status ts_multigrid_divide(struct ts_multigrid *m, struct ts_world *world)
{
	for (int k = 0; k < m->levels; k++) {
		struct ts_multigrid_level *l = &m->level[k];

		TS_TRY(ts_slabs_make(&l->slabs, world, l->s.n[2]));
		l->slabs.active = true; /* as they will be */
		if (k > 0)
			find_beside(l - 1, l);
	}
	while (divides(m, m->divided, world->n))
		m->divided++;
	for (int k = 0; k < m->levels; k++)
		m->level[k].slabs.active = false;
	return TS_OK;
}

void ts_multigrid_set_slabs(struct ts_multigrid *m)
{
	const bool active = ts_slabs_ranks(m->finest->slabs) > 1;

	for (int k = 0; k < m->levels; k++) {
		struct ts_multigrid_level *l = &m->level[k];

		l->slabs.active = active && k <= m->divided;
		l->s.slabs = active && k < m->divided ? &l->slabs : NULL;
	}
}

/* The faces above the last plane go with it. */
void ts_multigrid_share_links(const struct ts_multigrid_level *l)
{
	for (int d = 0; d < l->s.axes && ts_slabs_ranks(&l->slabs) > 1; d++) {
		const struct ts_slabs_field planes = { l->s.link[d] + ts_stencil_at(&l->s, 0, 0, 0),
						       (size_t)l->s.stride[2], 0, d == 2 };

		if (l->s.slabs)
			ts_slabs_share_beside(&l->slabs, &planes, l->links.below,
					      l->links.above > (d == 2) ? l->links.above : d == 2, false);
		else
			ts_slabs_share(&l->slabs, &planes);
	}
}

void ts_multigrid_share_residual(const struct ts_multigrid_level *l)
{
	const struct ts_slabs_field planes = { l->r + ts_stencil_at(&l->s, 0, 0, 0), (size_t)l->s.stride[2],
					       0, 0 };

	ts_slabs_share_beside(l->s.slabs, &planes, l->residual.below, l->residual.above, l->s.periodic[2]);
}

void ts_multigrid_share_rhs(const struct ts_multigrid_level *l)
{
	const struct ts_slabs_field planes = { l->b + ts_stencil_at(&l->s, 0, 0, 0), (size_t)l->s.stride[2],
					       0, 0 };

	if (!l->s.slabs)
		ts_slabs_share(&l->slabs, &planes);
}
