#include "base/map.h"

#include <stdint.h>

#include "base/alloc.h"
#include "base/hash.h"
#include "base/str.h"

#include "base/banned.h"

static size_t home_slot(const struct ts_map *map, const char *key)
{
	struct ts_hash hash = ts_hash_start();

	ts_hash_text(&hash, key);
	return (size_t)(ts_hash_value(&hash) & (map->size - 1));
}

/* Slot of the key, or the free slot where it would be inserted; there always is a free one. */
static struct ts_map_entry *find_entry(const struct ts_map *map, const char *key)
{
	size_t k = home_slot(map, key);

	while (map->slot[k].key && !ts_streq(map->slot[k].key, key))
		k = (k + 1) & (map->size - 1);
	return &map->slot[k];
}

void *ts_map_get(const struct ts_map *map, const char *key)
{
	return map->size ? find_entry(map, key)->value : NULL;
}

static enum ts_status enlarge_map(struct ts_map *map)
{
	struct ts_map bigger = { .size = map->size ? 2 * map->size : 32, .used = map->used };

	bigger.slot = ts_alloc(bigger.size, sizeof *bigger.slot);
	if (!bigger.slot)
		return TS_NOMEM;
	for (size_t k = 0; k < map->size; k++)
		if (map->slot[k].key)
			*find_entry(&bigger, map->slot[k].key) = map->slot[k];
	ts_free(map->slot);
	*map = bigger;
	return TS_OK;
}

enum ts_status ts_map_set(struct ts_map *map, const char *key, void *value)
{
	struct ts_map_entry *entry;

	if (2 * map->used >= map->size)
		TS_TRY(enlarge_map(map));
	entry = find_entry(map, key);
	map->used += !entry->key;
	*entry = (struct ts_map_entry){ key, value };
	return TS_OK;
}

/* Later entries of the probe sequence are moved into the gap, so that searches do not end too early. */
void ts_map_remove(struct ts_map *map, const char *key)
{
	struct ts_map_entry *gap = map->size ? find_entry(map, key) : NULL;
	size_t mask = map->size - 1, hole, k;

	if (!gap || !gap->key)
		return;
	map->used--;
	hole = (size_t)(gap - map->slot);
	for (k = (hole + 1) & mask; map->slot[k].key; k = (k + 1) & mask) {
		if (((k - home_slot(map, map->slot[k].key)) & mask) < ((k - hole) & mask))
			continue;
		map->slot[hole] = map->slot[k];
		hole = k;
	}
	map->slot[hole] = (struct ts_map_entry){ 0 };
}

void ts_map_release(struct ts_map *map)
{
	ts_free(map->slot);
	*map = (struct ts_map){ 0 };
}
