/* A hash table from strings to pointers. */
#ifndef TS_BASE_MAP_H
#define TS_BASE_MAP_H

#include <stddef.h>

#include "base/status.h"

struct ts_map_entry {
	const char *key; /* NULL: free slot */
	void *value;
};

/* Zero-initialise. Keys are not copied: they must outlive their entries. */
struct ts_map {
	struct ts_map_entry *slot; /* open addressing, linear probing */
	size_t size, used;
};

void *ts_map_get(const struct ts_map *map, const char *key); /* NULL if there is none */
/* Adds or replaces an entry. */
enum ts_status ts_map_set(struct ts_map *map, const char *key, void *value);
void ts_map_remove(struct ts_map *map, const char *key);
void ts_map_release(struct ts_map *map);

#endif
