/* Saved state: one description serves writing and reading, so a restart is exact by construction.
 *
 * A style lists the plain fields of its state in a table. Arrays of variable length are saved by
 * ts_archive_array in the style's archive function. restart/restart.c writes and reads the file. */
#ifndef TS_CORE_ARCHIVE_H
#define TS_CORE_ARCHIVE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/status.h"

struct tsim;
struct ts_instance;
struct ts_plan_report;
struct ts_archive;

enum ts_saved_type { TS_SAVED_END, TS_SAVED_F64, TS_SAVED_I64, TS_SAVED_I32, TS_SAVED_U8 };

struct ts_saved {
	const char *name;
	enum ts_saved_type type;
	size_t offset, count; /* offset in bytes; elements of a fixed array, 1 for a scalar */
};

/* A row for a number, an array, or a two-dimensional array with rows of 2 or 3 numbers; does not compile
 * for a field of another type, whose bytes would be saved wrongly. */
#define TS_SAVED_OF(T, f, type, columns)                    \
	(sizeof(((T *)0)->f) < (columns) * sizeof(type) ? 1 \
							: sizeof(((T *)0)->f) / ((columns) * sizeof(type)))
#define TS_SAVED_IS(T, f, type)                                                                          \
	_Generic(&((T *)0)->f, type * : 1, type(*)[TS_SAVED_OF(T, f, type, 1)] : 1,                      \
		 type(*)[TS_SAVED_OF(T, f, type, 2)][2] : 1, type(*)[TS_SAVED_OF(T, f, type, 3)][3] : 1, \
		 default : 0)
#define TS_SAVED_ROW(T, f, saved_type, size, matches)                                                  \
	{                                                                                              \
#f, saved_type,                                                                        \
			offsetof(T, f) +                                                               \
				0 * sizeof(struct {                                                    \
					int ok;                                                        \
					_Static_assert(matches, "saved row and field differ in type"); \
				}),                                                                    \
			sizeof(((T *)0)->f) / (size)                                                   \
	}
#define TS_SAVE_F64(T, f) TS_SAVED_ROW(T, f, TS_SAVED_F64, 8, TS_SAVED_IS(T, f, double))
#define TS_SAVE_I64(T, f) \
	TS_SAVED_ROW(T, f, TS_SAVED_I64, 8, TS_SAVED_IS(T, f, int64_t) || TS_SAVED_IS(T, f, uint64_t))
#define TS_SAVE_I32(T, f)                   \
	TS_SAVED_ROW(T, f, TS_SAVED_I32, 4, \
		     TS_SAVED_IS(T, f, int32_t) || TS_SAVED_IS(T, f, uint32_t)) /* enums, too */
#define TS_SAVE_U8(T, f) \
	TS_SAVED_ROW(T, f, TS_SAVED_U8, 1, TS_SAVED_IS(T, f, bool) || TS_SAVED_IS(T, f, uint8_t))
#define TS_SAVED_ROWS_END            \
	{                            \
		.type = TS_SAVED_END \
	}

/* An archive consists of named fields {name, type, element count, bytes}. */
bool ts_archive_writing(const struct ts_archive *archive);

/* Writes `count` elements, or reads exactly that many; a missing field, another type or another length is
 * an error (TS_DAMAGED). */
enum ts_status ts_archive_fixed(struct ts_archive *archive, const char *name, enum ts_saved_type type,
				void *data, size_t count);

/* When reading: TS_DAMAGED unless the field exists with that many elements. To be called before memory is
 * allocated for a count read from the file, which may be wrong. When writing always TS_OK. */
enum ts_status ts_archive_expect(struct ts_archive *archive, const char *name, enum ts_saved_type type,
				 size_t count);

/* Writes *count elements of *data; or reads all elements of the field, enlarging *data as ts_grow does,
 * and sets *count. */
enum ts_status ts_archive_array(struct ts_archive *archive, const char *name, enum ts_saved_type type,
				void **data, size_t *capacity, size_t *count);

/* A string; when reading it is owned by sim->pool. */
enum ts_status ts_archive_string(struct ts_archive *archive, const char *name, const char **text);

/* When reading: whether the field exists. When writing: true. */
bool ts_archive_has(const struct ts_archive *archive, const char *name);

/* Saves or restores the fields in the table `saved` of the style, then calls its archive function. */
enum ts_status ts_archive_instance(struct ts_archive *archive, struct ts_instance *inst, struct tsim *sim);

/* Archives in memory: for restart/restart.c and for state of styles not yet defined again
 * (core/unclaimed_state.h). */
struct ts_archive *ts_archive_new(struct tsim *sim, bool writing); /* NULL: out of memory */
void ts_archive_free(struct ts_archive *archive);
/* All fields as one block of bytes with a checksum, owned by the archive. */
enum ts_status ts_archive_bytes(struct ts_archive *archive, const unsigned char **bytes, size_t *n);
/* Makes the archive read from the block, which must exist as long as the archive; checks checksum and format. */
enum ts_status ts_archive_from(struct ts_archive *archive, const unsigned char *bytes, size_t n);

#endif
