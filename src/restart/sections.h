/* The sections of a restart file that is read: the whole file is checked before anything is restored. A file is read a second time
 * then, section by section; the sections of a pipe are all kept until then. */
#ifndef TS_RESTART_SECTIONS_H
#define TS_RESTART_SECTIONS_H

#include <stdio.h>
#include <sys/types.h>

#include "core/archive_pieces.h"
#include "core/sim.h"

/* Version 2 added the section of the script and the arguments of styles. Older versions can be read;
 * doc/restart-format.md says which changes require a new version. */
#define TS_RESTART_MAGIC_STEM "tsim restart "
#define TS_RESTART_MAGIC TS_RESTART_MAGIC_STEM "2\n"
enum {
	TS_RESTART_BYTE_ORDER_MARK = 0x01020304,
	TS_RESTART_VERSION = 2,
	TS_RESTART_MAGIC_LENGTH = sizeof TS_RESTART_MAGIC - 1
};
enum { TS_RESTART_CLOCK_SECTION = 1000, TS_RESTART_SCRIPT_SECTION = 1001, TS_RESTART_END_SECTION = 0 };
enum { TS_SECTION_NAMES = 3 };

/* Header of a section, as in the file; names and compressed bytes follow. */
struct ts_section_head {
	uint32_t kind, name_length[TS_SECTION_NAMES];
	uint64_t plain, packed; /* bytes before and after compression */
	uint32_t sum, zero;	/* crc32 of the compressed bytes; padding */
};

struct ts_section {
	struct ts_section_head head;
	char *name[TS_SECTION_NAMES]; /* style, id, group */
	off_t at;		      /* of its compressed bytes */
	unsigned char *plain;	      /* uncompressed bytes; freed once they are restored */
};

struct ts_sections {
	struct tsim *sim;
	const char *path;
	const struct ts_place *where;
	struct ts_place place;
	struct ts_arena arena;
	FILE *file;
	bool twice;	      /* it is a file */
	uint64_t left;	      /* a section cannot have more bytes */
	uint32_t sum;	      /* crc32 of all bytes read so far */
	unsigned char *piece; /* of a section */
	struct ts_section *section;
	size_t nsections, section_capacity;
	struct ts_sieve *sieve;	    /* each rank restores its own particles; NULL: all do all */
	struct ts_section whole[2]; /* then: particles and contacts of all ranks, as in the file */
	size_t system;		    /* index in the table of systems: the first that is not yet restored */
};

enum ts_status ts_sections_refuse(struct ts_sections *r, const char *why);
/* Opens the file r->path and checks it. */
enum ts_status ts_sections_open(struct ts_sections *r);
/* The bytes of a section of a file that has been checked: s->plain. */
enum ts_status ts_sections_again(struct ts_sections *r, struct ts_section *s);
/* Gives them to the taker instead, piece by piece. */
enum ts_status ts_sections_expand(struct ts_sections *r, const struct ts_section *s,
				  const struct ts_archive_taker *taker);
void ts_sections_close(struct ts_sections *r);

#endif
