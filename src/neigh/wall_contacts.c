#include "neigh/wall_contacts.h"

#include <stdlib.h>
#include <string.h>

#include "particles/particles.h"

#include "base/banned.h"

void ts_wall_contacts_start(struct ts_wall_contacts *c, struct ts_wall_rebuild *rebuild,
			    size_t width)
{
	rebuild->old = *c;
	*c = (struct ts_wall_contacts){ .width = width };
}

enum ts_status ts_wall_contacts_add(struct tsim *sim, struct ts_wall_contacts *c, size_t i,
				    int element)
{
	size_t n = c->n + 1;

	if (TS_GROW(c->row, c->row_capacity, n) != TS_OK ||
	    TS_GROW(c->key, c->key_capacity, n) != TS_OK ||
	    TS_GROW(c->memory, c->memory_capacity, n * c->width) != TS_OK)
		return ts_nomem(&sim->error);
	c->row[c->n] = (int32_t)i;
	c->key[c->n][0] = sim->particles->tag[i];
	c->key[c->n][1] = element;
	for (size_t k = 0; k < c->width; k++)
		c->memory[c->n * c->width + k] = 0;
	c->n++;
	return TS_OK;
}

static int compare(const void *a, const void *b)
{
	const int32_t *x = a, *y = b;

	if (x[0] != y[0])
		return x[0] < y[0] ? -1 : 1;
	return (x[1] > y[1]) - (x[1] < y[1]);
}

/* Walls are asked in the order of particles in memory, which a rebuild may change: the old keys are
 * listed in order, each with its place, and looked up. */
static int32_t (*sorted_keys(const struct ts_wall_contacts *c))[3]
{
	int32_t(*list)[3] = ts_alloc(c->n, sizeof *list);

	for (size_t k = 0; list && k < c->n; k++) {
		list[k][0] = c->key[k][0];
		list[k][1] = c->key[k][1];
		list[k][2] = (int32_t)k;
	}
	if (list)
		qsort(list, c->n, sizeof *list, compare);
	return list;
}

enum ts_status ts_wall_contacts_finish(struct tsim *sim, struct ts_wall_contacts *c,
				       struct ts_wall_rebuild *rebuild)
{
	const struct ts_wall_contacts *old = &rebuild->old;
	bool carry = old->n && c->n && c->width && old->width == c->width;
	int32_t(*list)[3] = carry ? sorted_keys(old) : NULL;

	for (size_t k = 0; list && k < c->n; k++) {
		const int32_t *found = bsearch(c->key[k], list, old->n, sizeof *list, compare);

		if (found)
			memcpy(ts_wall_memory(c, k), ts_wall_memory(old, (size_t)found[2]),
			       c->width * sizeof *c->memory);
	}
	ts_wall_contacts_release(&rebuild->old);
	if (carry && !list)
		return ts_nomem(&sim->error);
	ts_free(list);
	return TS_OK;
}

void ts_wall_contact_part(struct ts_wall_contacts *c, size_t k)
{
	if (c->width)
		memset(ts_wall_memory(c, k), 0, c->width * sizeof *c->memory);
}

enum ts_status ts_wall_contacts_archive(struct ts_archive *archive, struct tsim *sim,
					struct ts_wall_contacts *c)
{
	int64_t size[2] = { (int64_t)c->n, (int64_t)c->width };

	if (!ts_archive_has(archive, "contacts")) /* walls of version 1 remember nothing */
		return TS_OK;
	TS_TRY(ts_archive_fixed(archive, "contacts", TS_SAVED_I64, size, 2));
	if (size[0] < 0 || size[0] > INT32_MAX || size[1] < 0 || size[1] > 1024)
		return ts_fail(&sim->error, TS_DAMAGED, NULL, "impossible contacts with a wall");
	if (!ts_archive_writing(archive)) {
		ts_wall_contacts_release(c);
		c->n = (size_t)size[0];
		c->width = (size_t)size[1];
		if (TS_GROW(c->row, c->row_capacity, c->n) != TS_OK ||
		    TS_GROW(c->key, c->key_capacity, c->n) != TS_OK ||
		    TS_GROW(c->memory, c->memory_capacity, c->n * c->width) != TS_OK)
			return ts_nomem(&sim->error);
	}
	TS_TRY(ts_archive_fixed(archive, "contact_keys", TS_SAVED_I32, c->key, 2 * c->n));
	return ts_archive_fixed(archive, "contact_memory", TS_SAVED_F64, c->memory,
				c->n * c->width);
}

void ts_wall_contacts_release(struct ts_wall_contacts *c)
{
	ts_free(c->row);
	ts_free(c->key);
	ts_free(c->memory);
	*c = (struct ts_wall_contacts){ 0 };
}
