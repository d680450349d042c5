/* Data files: text that holds a box, particles, velocities, bonds and coefficients, in the format of
 * LAMMPS and LIGGGHTS. Reading goes in two steps: the whole file into struct ts_data, without a look
 * at the simulation, and from there into the simulation, so a bad file changes nothing. */
#ifndef TS_RESTART_DATA_H
#define TS_RESTART_DATA_H

#include "core/sim.h"
#include "io/lines.h"
#include "io/textfile.h"

/* What a column of section Atoms holds. */
enum ts_data_column {
	TS_DATA_ID,
	TS_DATA_TYPE,
	TS_DATA_MOL, /* read and forgotten */
	TS_DATA_DIAMETER,
	TS_DATA_DENSITY,
	TS_DATA_X,
	TS_DATA_Y,
	TS_DATA_Z,
	TS_NDATA_COLUMN
};
extern const char *const ts_data_column_names[TS_NDATA_COLUMN];

/* The columns of an atom style, image flags apart. */
struct ts_data_layout {
	int column[TS_NDATA_COLUMN + 1]; /* enum ts_data_column */
	size_t n;
	bool sized; /* has diameter and density, hence angular velocities */
};
/* From the words of atom_style: "sphere", "hybrid granular bond/gran"; false: not known. */
bool ts_data_layout(const char *style, struct ts_data_layout *out);

enum ts_status ts_data_refuse_style(struct tsim *sim, const struct ts_word *word);

struct ts_data_atom {
	int32_t tag, type, image[3];
	double diameter, density, x[3], v[3], omega[3];
	int line;
};

struct ts_data_bond {
	int32_t tag[2], type;
	int line;
};

/* A line of a section of coefficients, as the words of pair_coeff or bond_coeff. */
struct ts_data_coeff {
	struct ts_words words;
};

/* A section of its own for numbers of particles: lines of an identity and so many numbers. */
struct ts_data_section {
	const char *title, *header; /* lines of the header that have this are passed over; NULL: none */
	size_t width;
	double *value; /* rows of identity and numbers */
	size_t n, capacity;
	bool seen;
};

/* Zero-initialise, but for the sections. */
struct ts_data {
	const char *file;
	int64_t natoms, nbonds, ntypes, nbond_types; /* as the header says */
	double lo[3], hi[3];
	struct ts_data_layout layout;
	struct ts_data_atom *atom;
	size_t n, capacity;
	bool moving; /* there is a section Velocities */
	struct ts_data_bond *bond;
	size_t nbond, bond_capacity;
	struct ts_data_coeff *coeff;
	size_t ncoeff, coeff_capacity;
	double *mass; /* by type; NULL: no section Masses */
	struct ts_data_section *section;
	size_t nsections;
	struct ts_arena arena;
};

/* Reads a file that is open; touches no file system. `style`: words of atom_style, for files that do
 * not name theirs. */
enum ts_status ts_data_read(struct tsim *sim, struct ts_lines *lines, const char *style, struct ts_data *out);
void ts_data_release(struct ts_data *data);

enum ts_data_add { TS_DATA_NEW, TS_DATA_APPEND, TS_DATA_MERGE };
struct ts_data_options {
	int add; /* enum ts_data_add */
	int64_t type_offset, bond_type_offset, tag_offset;
	int64_t extra_types, extra_bond_types;
	bool keep_box; /* a box there is does not grow */
	double shift[3];
	int group;
};
/* The box and the particles; adds what append adds to options->tag_offset, for the bonds. */
enum ts_status ts_data_apply(struct tsim *sim, const struct ts_data *data, struct ts_data_options *options);

/* The parts of a data file as text. `bonds` etc. are what the caller adds after them. */
struct ts_data_counts {
	size_t bonds;
	int bond_types;
};
struct ts_user_columns;
/* A section of numbers of particles, under its title. */
enum ts_status ts_data_write_columns(struct tsim *sim, struct ts_textfile *out,
				     const struct ts_user_columns *columns);
enum ts_status ts_data_write(struct tsim *sim, struct ts_textfile *out, struct ts_data_counts counts);

#endif
