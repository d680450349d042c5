/* Data files: text files with box, particles, velocities, bonds and coefficients, in the format of LAMMPS and
 * LIGGGHTS. The whole file is read into struct ts_data first, then entered in the simulation, so that a file
 * with an error changes nothing. */
#ifndef TS_RESTART_DATA_H
#define TS_RESTART_DATA_H

#include "core/sim.h"
#include "io/lines.h"
#include "io/textfile.h"

/* Columns of section Atoms. */
enum ts_data_column {
	TS_DATA_ID,
	TS_DATA_TYPE,
	TS_DATA_MOL, /* ignored */
	TS_DATA_DIAMETER,
	TS_DATA_DENSITY,
	TS_DATA_X,
	TS_DATA_Y,
	TS_DATA_Z,
	TS_NDATA_COLUMN
};
extern const char *const ts_data_column_names[TS_NDATA_COLUMN];

/* The columns of section Atoms for an atom style, without image flags. */
struct ts_data_layout {
	int column[TS_NDATA_COLUMN + 1]; /* enum ts_data_column */
	size_t n;
	bool sized; /* has diameter and density, hence angular velocities */
};
/* `style`: arguments of atom_style, such as "sphere" or "hybrid granular bond/gran"; false: unknown style. */
bool ts_data_layout(const char *style, struct ts_data_layout *out);

/* Error message for an atom style that is unknown or not supported. */
enum ts_status ts_data_refuse_style(struct tsim *sim, const struct ts_word *word);

struct ts_data_atom {
	int32_t tag, type, image[3];
	double diameter, density, x[3], v[3], omega[3];
	int line; /* of the file, for messages */
	int32_t molecule;
};

struct ts_data_bond {
	int32_t tag[2], type;
	int line;
};

/* A line of a section of coefficients, as a command pair_coeff or bond_coeff. */
struct ts_data_coeff {
	struct ts_words words;
};

/* A section for a fix property/atom: lines of a particle id and `width` numbers. */
struct ts_data_section {
	const char *title, *header; /* header lines that contain this text are ignored; NULL: none */
	size_t width;
	double *value; /* [n][1 + width] id and numbers */
	size_t n, capacity;
	bool seen; /* the section was read */
};

/* A line of section Velocities, where the particle may be one of another rank. */
struct ts_data_motion {
	double v[3], omega[3];
	int32_t tag;
};

/* Contents of a data file. Zero-initialise, except for the sections of fixes, part and parts. */
struct ts_data {
	const char *file;
	/* Several ranks: this one reads part `part` of so many of the lines of Atoms and Velocities, if what else there is allows it.
	 * 0 parts: all of them. */
	int part, parts;
	bool failed; /* a line of this part has an error: who reads all lines says which */
	int64_t natoms, nbonds, ntypes, nbond_types; /* from the header */
	double lo[3], hi[3];			     /* box (length) */
	struct ts_data_layout layout;
	struct ts_data_atom *atom; /* [n] in the order of the file */
	size_t n, capacity;
	bool has_molecules;	       /* lines with molecule ids have been read: */
	int64_t molecule[2];	       /* the smallest and the largest one */
	bool moving;		       /* there is a section Velocities */
	struct ts_data_motion *motion; /* [nmotion] of parts */
	size_t nmotion, motion_capacity;
	struct ts_data_bond *bond;
	size_t nbond, bond_capacity;
	struct ts_data_coeff *coeff;
	size_t ncoeff, coeff_capacity;
	double *mass; /* [1 + type]; NULL: no section Masses */
	struct ts_data_section *section;
	size_t nsections;
	struct ts_arena arena;
};

/* Reads an open file. `style`: arguments of atom_style, for files that do not name their style. */
enum ts_status ts_data_read(struct tsim *sim, struct ts_lines *lines, const char *style, struct ts_data *out);
void ts_data_release(struct ts_data *data);

enum ts_data_add { TS_DATA_NEW, TS_DATA_APPEND, TS_DATA_MERGE };
struct ts_data_options {
	int add; /* enum ts_data_add */
	int64_t type_offset, bond_type_offset, tag_offset;
	double molecule_offset; /* for molecules above 0 */
	int64_t extra_types, extra_bond_types;
	bool keep_box;	 /* an existing box is not extended */
	double shift[3]; /* added to positions and to the box (length) */
	int group;	 /* index; 0: all */
};
/* With TS_DATA_APPEND adds the largest present id to options->tag_offset, and sets molecule_offset to the largest molecule. */
void ts_data_append(const struct tsim *sim, struct ts_data_options *options);
/* Finds all errors in what would be entered. */
enum ts_status ts_data_check(struct tsim *sim, const struct ts_data *data,
			     const struct ts_data_options *options);
/* Creates box and particles, which have been checked. */
enum ts_status ts_data_apply(struct tsim *sim, struct ts_data *data, const struct ts_data_options *options);

/* Numbers of bonds and bond types for the header; the caller writes their sections. */
struct ts_data_counts {
	size_t bonds;
	int bond_types;
	bool molecules; /* section Atoms has molecule ids; it has with bonds in any case */
};
struct ts_user_columns;
/* Writes the section of a fix property/atom. */
enum ts_status ts_data_write_columns(struct tsim *sim, struct ts_textfile *out,
				     const struct ts_user_columns *columns);
/* Writes the header and the sections Atoms and Velocities. */
enum ts_status ts_data_write(struct tsim *sim, struct ts_textfile *out, struct ts_data_counts counts);

/* ---- a file of which each of several ranks has read a part */

/* Brings the lines of each particle together, on some rank, and finds errors. *ok: false, on all ranks: there are some, which who reads
 * all lines describes. */
enum ts_status ts_data_join(struct tsim *sim, struct ts_data *data, const struct ts_data_options *options,
			    bool *ok);

#endif
