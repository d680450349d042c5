/* Positions of particles to be created, of which each of several ranks keeps those in its block. */
#include "insert/sites.h"

#include <string.h>

#include "particle/division.h"

#include "base/banned.h"

static void number_sites(struct ts_sites *sites, size_t first)
{
	for (size_t k = 0; k < sites->n; k++)
		sites->site[k].number = (int32_t)(first + k);
}

/* All ranks have all sites: each keeps a part. */
static void keep_part(const struct tsim *sim, struct ts_sites *sites)
{
	size_t first, end;

	sites->part = sim->world->rank;
	sites->parts = sim->world->n;
	first = ts_sites_first(sites, sites->n, &end);
	sites->n = end - first;
	memmove(sites->site, sites->site + first, sites->n * sizeof *sites->site);
}

static enum ts_status begin_division(struct tsim *sim, const struct ts_sites *sites)
{
	double(*x)[3] = ts_alloc(sites->n, sizeof *x);
	enum ts_status status;

	if (!x)
		return ts_nomem(&sim->error);
	for (size_t k = 0; k < sites->n; k++)
		memcpy(x[k], sites->site[k].x, sizeof x[k]);
	status = ts_division_make(sim, x, sites->n);
	ts_free(x);
	return status;
}

static enum ts_status send_sites(struct tsim *sim, struct ts_sites *sites)
{
	struct ts_new_rows rows = { sites->site, sites->n, sites->capacity, sizeof *sites->site };
	int32_t *to = ts_alloc(sites->n, sizeof *to);
	enum ts_status status;

	if (!to)
		return ts_nomem(&sim->error);
	for (size_t k = 0; k < sites->n; k++)
		to[k] = ts_division_owner(sim, sites->site[k].x);
	status = ts_division_send(sim, &rows, to);
	ts_free(to);
	sites->site = rows.row;
	sites->n = rows.n;
	sites->capacity = rows.capacity;
	return status;
}

enum ts_status ts_sites_divide(struct tsim *sim, struct ts_sites *sites, size_t *all)
{
	size_t before;

	*all = sites->n;
	if (!ts_division_can_make(sim)) {
		number_sites(sites, 0);
		return TS_OK;
	}
	if (!sites->parts)
		keep_part(sim, sites);
	TS_TRY(ts_division_count(sim, sites->n, &before, all));
	number_sites(sites, before);
	TS_TRY(begin_division(sim, sites));
	return send_sites(sim, sites);
}
