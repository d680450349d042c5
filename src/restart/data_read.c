/* Data files: reads a file into struct ts_data. */
#include "base/sort.h"
#include "restart/data.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#include "geom/box.h"

#include "base/banned.h"

/* Particle ids are indices of a table, which limits them. */
enum { LARGEST_TAG = INT32_MAX - 1, MOST_TYPES = 10000 };

struct reader {
	struct tsim *sim;
	struct ts_lines *l;
	struct ts_data *d;
	const char *style;	      /* arguments of atom_style */
	bool found[3], more;	      /* bounds of the box in x, y, z; there is a current line */
	struct ts_data_atom **by_tag; /* [natoms] sorted by id, once section Atoms is read */
};

/* ---- header ---- */

struct header_row {
	const char *words; /* that follow the number */
	size_t values;	   /* numbers in the line */
	size_t offset;	   /* of the count in struct ts_data; NOWHERE: not stored */
	int64_t largest;   /* 0: not supported by tsim */
};

#define NOWHERE SIZE_MAX
static const struct header_row header_rows[] = {
	{ "atoms", 1, offsetof(struct ts_data, natoms), INT32_MAX },
	{ "bonds", 1, offsetof(struct ts_data, nbonds), INT32_MAX },
	{ "atom types", 1, offsetof(struct ts_data, ntypes), MOST_TYPES },
	{ "bond types", 1, offsetof(struct ts_data, nbond_types), MOST_TYPES },
	{ "angles", 1, NOWHERE, 0 },
	{ "dihedrals", 1, NOWHERE, 0 },
	{ "impropers", 1, NOWHERE, 0 },
	{ "angle types", 1, NOWHERE, 0 },
	{ "dihedral types", 1, NOWHERE, 0 },
	{ "improper types", 1, NOWHERE, 0 },
	{ "ellipsoids", 1, NOWHERE, 0 },
	{ "lines", 1, NOWHERE, 0 },
	{ "triangles", 1, NOWHERE, 0 },
	{ "bodies", 1, NOWHERE, 0 },
	{ "extra bond per atom", 1, NOWHERE, INT32_MAX },
	{ "extra angle per atom", 1, NOWHERE, INT32_MAX },
	{ "extra dihedral per atom", 1, NOWHERE, INT32_MAX },
	{ "extra improper per atom", 1, NOWHERE, INT32_MAX },
	{ "extra special per atom", 1, NOWHERE, INT32_MAX },
};

static enum ts_status read_count(struct reader *r, const struct header_row *row)
{
	int64_t value;
	char what[64];

	snprintf(what, sizeof what, "the number of %s", row->words);
	TS_TRY(ts_lines_int(r->l, 0, what, 0, INT64_MAX, &value));
	if (value > row->largest)
		return ts_lines_fail(r->l, TS_RANGE, 0, "%s is %" PRId64 ", but there can be %" PRId64 "%s",
				     what, value, row->largest,
				     row->largest ? "" : ": not supported by tsim");
	if (row->offset != NOWHERE)
		*(int64_t *)((char *)r->d + row->offset) = value;
	return TS_OK;
}

static enum ts_status read_bounds(struct reader *r, int dim)
{
	TS_TRY(ts_lines_real(r->l, 0, "the lower bound", &r->d->lo[dim]));
	TS_TRY(ts_lines_real(r->l, 1, "the upper bound", &r->d->hi[dim]));
	r->found[dim] = true;
	if (r->d->lo[dim] < r->d->hi[dim])
		return TS_OK;
	return ts_lines_fail(r->l, TS_RANGE, 1, "the upper bound %s is not above the lower bound %s",
			     r->l->word[1], r->l->word[0]);
}

static enum ts_status read_tilt(struct reader *r)
{
	for (size_t k = 0; k < 3; k++) {
		double tilt;

		TS_TRY(ts_lines_real(r->l, k, "the tilt", &tilt));
		if (tilt != 0)
			return ts_lines_fail(r->l, TS_RANGE, k,
					     "the box is tilted by %s, but tsim's boxes are right-angled",
					     r->l->word[k]);
	}
	return TS_OK;
}

/* Whether a header line contains a text of the keyword `fix`; fix property/atom needs no header lines. */
static bool is_ignored_header(const struct reader *r)
{
	for (size_t j = 0; j < r->d->nsections; j++) {
		const char *text = r->d->section[j].header;

		for (size_t k = 0; text && k < r->l->nwords; k++)
			if (strstr(r->l->word[k], text))
				return true;
	}
	return false;
}

/* *known: the line is a header line; otherwise the header has ended before it. */
static enum ts_status read_header_line(struct reader *r, bool *known)
{
	static const char *const bounds[] = { "xlo xhi", "ylo yhi", "zlo zhi" };
	const struct ts_lines *l = r->l;

	*known = true;
	for (int dim = 0; dim < 3; dim++)
		if (l->nwords == 4 && ts_lines_match(l, 2, bounds[dim]))
			return read_bounds(r, dim);
	if (l->nwords == 6 && ts_lines_match(l, 3, "xy xz yz"))
		return read_tilt(r);
	for (size_t k = 0; k < sizeof header_rows / sizeof *header_rows; k++)
		if (l->nwords > 1 && ts_lines_match(l, 1, header_rows[k].words))
			return read_count(r, &header_rows[k]);
	*known = is_ignored_header(r);
	return TS_OK;
}

static enum ts_status check_header(struct reader *r)
{
	for (int dim = 0; dim < 3; dim++)
		if (!r->found[dim])
			return ts_lines_fail(r->l, TS_DAMAGED, SIZE_MAX,
					     "the header ends here, but has no line `LO HI %clo %chi` with "
					     "the bounds of the box",
					     'x' + dim, 'x' + dim);
	if (r->d->natoms && !r->d->ntypes)
		return ts_lines_fail(r->l, TS_DAMAGED, SIZE_MAX,
				     "the header ends here, but has no line `N atom types`");
	return TS_OK;
}

/* The first line is the title and is ignored. */
static enum ts_status read_header(struct reader *r)
{
	bool known = true;

	TS_TRY(ts_lines_next(r->l, &r->more));
	if (!r->more)
		return ts_lines_fail(r->l, TS_DAMAGED, SIZE_MAX, "the file is empty");
	while (known) {
		TS_TRY(ts_lines_next_filled(r->l, &r->more));
		if (!r->more)
			break;
		TS_TRY(read_header_line(r, &known));
	}
	return check_header(r);
}

/* ---- sections ---- */

/* Makes a command of the current line, with `repeat` copies of its first word in front. */
static enum ts_status make_command(struct reader *r, const char *command, size_t repeat, struct ts_words *out)
{
	size_t n = r->l->nwords, first = 1 + repeat;
	struct ts_word *word = ts_arena_alloc(&r->d->arena, n + first, sizeof *word);

	if (!word)
		return ts_nomem(&r->sim->error);
	for (size_t k = 0; k < n + first; k++) {
		size_t from = k < first ? 0 : k - first;

		word[k].place = ts_lines_place(r->l, from);
		word[k].text = k ? ts_arena_strdup(&r->d->arena, r->l->word[from]) : command;
		if (!word[k].text)
			return ts_nomem(&r->sim->error);
	}
	*out = (struct ts_words){ word, n + first };
	return TS_OK;
}

/* A line "type args" of Pair Coeffs means pair_coeff type type args: repeat = 1. */
static enum ts_status read_coeff(struct reader *r, const char *command, size_t repeat)
{
	struct ts_data *d = r->d;

	if (TS_GROW(d->coeff, d->coeff_capacity, d->ncoeff + 1) != TS_OK)
		return ts_nomem(&r->sim->error);
	TS_TRY(make_command(r, command, repeat, &d->coeff[d->ncoeff].words));
	d->ncoeff++;
	return TS_OK;
}

static enum ts_status read_pair_coeff(struct reader *r)
{
	return read_coeff(r, "pair_coeff", 1);
}

static enum ts_status read_pair_ij_coeff(struct reader *r)
{
	return read_coeff(r, "pair_coeff", 0);
}

static enum ts_status read_bond_coeff(struct reader *r)
{
	return read_coeff(r, "bond_coeff", 0);
}

/* The line must end after n words. */
static enum ts_status check_length(struct reader *r, size_t n)
{
	if (r->l->nwords <= n)
		return TS_OK;
	return ts_lines_fail(r->l, TS_SYNTAX, n, "'%.60s' is one word too many, expected %zu", r->l->word[n],
			     n);
}

static enum ts_status read_mass(struct reader *r)
{
	struct ts_data *d = r->d;
	int64_t type;
	double value;

	if (!d->mass)
		d->mass = ts_arena_alloc(&d->arena, (size_t)d->ntypes + 1, sizeof *d->mass);
	if (!d->mass)
		return ts_nomem(&r->sim->error);
	TS_TRY(ts_lines_int(r->l, 0, "the type", 1, d->ntypes, &type));
	TS_TRY(ts_lines_real(r->l, 1, "the mass", &value));
	if (!(value > 0))
		return ts_lines_fail(r->l, TS_RANGE, 1, "the mass is %s, expected a number > 0",
				     r->l->word[1]);
	d->mass[type] = value;
	return check_length(r, 2);
}

static enum ts_status read_positive(struct reader *r, size_t k, int column, double *out)
{
	const char *name = ts_data_column_names[column];

	TS_TRY(ts_lines_real(r->l, k, name, out));
	if (*out > 0)
		return TS_OK;
	return ts_lines_fail(r->l, TS_RANGE, k, "%s is %s, expected a number > 0", name, r->l->word[k]);
}

static void note_molecule(struct ts_data *d, int64_t id)
{
	if (id < d->molecule[0] || !d->has_molecules)
		d->molecule[0] = id;
	if (id > d->molecule[1] || !d->has_molecules)
		d->molecule[1] = id;
	d->has_molecules = true;
}

static enum ts_status read_atom_column(struct reader *r, size_t k, int column, struct ts_data_atom *a)
{
	const char *name = ts_data_column_names[column];
	int64_t number;

	switch (column) {
	case TS_DATA_ID:
		TS_TRY(ts_lines_int(r->l, k, name, 1, LARGEST_TAG, &number));
		a->tag = (int32_t)number;
		return TS_OK;
	case TS_DATA_TYPE:
		TS_TRY(ts_lines_int(r->l, k, name, 1, r->d->ntypes, &number));
		a->type = (int32_t)number;
		return TS_OK;
	case TS_DATA_MOL:
		TS_TRY(ts_lines_int(r->l, k, name, INT32_MIN, INT32_MAX, &number));
		a->molecule = (int32_t)number;
		note_molecule(r->d, number);
		return TS_OK;
	case TS_DATA_DIAMETER:
		return read_positive(r, k, column, &a->diameter);
	case TS_DATA_DENSITY:
		return read_positive(r, k, column, &a->density);
	default:
		return ts_lines_real(r->l, k, name, &a->x[column - TS_DATA_X]);
	}
}

static enum ts_status read_atom(struct reader *r)
{
	static const char *const images[] = { "image flag ix", "image flag iy", "image flag iz" };
	struct ts_data *d = r->d;
	size_t n = d->layout.n;
	struct ts_data_atom *a;

	if (TS_GROW(d->atom, d->capacity, d->n + 1) != TS_OK)
		return ts_nomem(&r->sim->error);
	a = &d->atom[d->n];
	*a = (struct ts_data_atom){ .diameter = 1, .density = 1, .line = r->l->number };
	for (size_t k = 0; k < n; k++)
		TS_TRY(read_atom_column(r, k, d->layout.column[k], a));
	for (size_t k = 0; r->l->nwords > n && k < 3; k++) {
		int64_t image;

		TS_TRY(ts_lines_int(r->l, n + k, images[k], -TS_TURNS_MOST, TS_TURNS_MOST, &image));
		a->image[k] = (int32_t)image;
	}
	d->n++;
	return check_length(r, n + 3);
}

static int compare_atoms(const void *a, const void *b)
{
	const struct ts_data_atom *p = *(const struct ts_data_atom *const *)a,
				  *q = *(const struct ts_data_atom *const *)b;

	return (p->tag > q->tag) - (p->tag < q->tag);
}

/* Sorts the particles by id; an id that occurs twice is an error. Of parts: data_join.c. */
static enum ts_status sort_atoms(struct reader *r)
{
	struct ts_data *d = r->d;

	if (d->parts)
		return TS_OK;
	r->by_tag = ts_arena_alloc(&d->arena, d->n + 1, sizeof(struct ts_data_atom *));
	if (!r->by_tag)
		return ts_nomem(&r->sim->error);
	for (size_t k = 0; k < d->n; k++)
		r->by_tag[k] = &d->atom[k];
	ts_sort(r->by_tag, d->n, sizeof(struct ts_data_atom *), compare_atoms);
	for (size_t k = 1; k < d->n; k++) {
		const struct ts_data_atom *a = r->by_tag[k - 1], *b = r->by_tag[k];
		struct ts_place place = { .file = r->l->file, .line = a->line > b->line ? a->line : b->line };

		if (a->tag == b->tag)
			return ts_fail(&r->sim->error, TS_DAMAGED, &place, "id %d occurs in line %d already",
				       a->tag, a->line < b->line ? a->line : b->line);
	}
	return TS_OK;
}

static enum ts_status find_atom(struct reader *r, size_t k, const char *what, int32_t *tag,
				struct ts_data_atom **out)
{
	struct ts_data_atom wanted = { 0 }, *key = &wanted, **found;
	int64_t number;

	TS_TRY(ts_lines_int(r->l, k, what, 1, LARGEST_TAG, &number));
	wanted.tag = *tag = (int32_t)number;
	if ((size_t)number <= r->d->n &&
	    r->by_tag[number - 1]->tag == number) { /* ids from 1 on without gaps */
		*out = r->by_tag[number - 1];
		return TS_OK;
	}
	found = bsearch(&key, r->by_tag, r->d->n, sizeof(struct ts_data_atom *), compare_atoms);
	if (!found)
		return ts_lines_fail(r->l, TS_DAMAGED, k,
				     "%s is %s, but there is no such particle in section Atoms", what,
				     r->l->word[k]);
	*out = *found;
	return TS_OK;
}

static enum ts_status read_motion(struct reader *r, double v[3], double omega[3])
{
	static const char *const names[] = { "vx", "vy", "vz", "omegax", "omegay", "omegaz" };
	size_t n = r->d->layout.sized ? 6 : 3;

	for (size_t k = 0; k < n; k++)
		TS_TRY(ts_lines_real(r->l, k + 1, names[k], k < 3 ? &v[k] : &omega[k - 3]));
	return check_length(r, n + 1);
}

static enum ts_status read_motion_apart(struct reader *r)
{
	struct ts_data *d = r->d;
	struct ts_data_motion *motion;
	int64_t number;

	if (TS_GROW(d->motion, d->motion_capacity, d->nmotion + 1) != TS_OK)
		return ts_nomem(&r->sim->error);
	motion = &d->motion[d->nmotion++];
	*motion = (struct ts_data_motion){ 0 };
	TS_TRY(ts_lines_int(r->l, 0, "id", 1, LARGEST_TAG, &number));
	motion->tag = (int32_t)number;
	return read_motion(r, motion->v, motion->omega);
}

static enum ts_status read_velocity(struct reader *r)
{
	struct ts_data_atom *a;
	int32_t tag;

	if (r->d->parts)
		return read_motion_apart(r);
	TS_TRY(find_atom(r, 0, "id", &tag, &a));
	return read_motion(r, a->v, a->omega);
}

static enum ts_status read_bond(struct reader *r)
{
	struct ts_data *d = r->d;
	struct ts_data_bond *b;
	struct ts_data_atom *a;
	int64_t number;

	if (TS_GROW(d->bond, d->bond_capacity, d->nbond + 1) != TS_OK)
		return ts_nomem(&r->sim->error);
	b = &d->bond[d->nbond];
	b->line = r->l->number;
	TS_TRY(ts_lines_int(r->l, 0, "number of the bond", 0, INT64_MAX, &number));
	TS_TRY(ts_lines_int(r->l, 1, "type of the bond", 1, d->nbond_types, &number));
	b->type = (int32_t)number;
	for (size_t k = 0; k < 2; k++)
		TS_TRY(find_atom(r, 2 + k, k ? "second particle" : "first particle", &b->tag[k], &a));
	if (b->tag[0] == b->tag[1])
		return ts_lines_fail(r->l, TS_DAMAGED, 3, "particle %d is bonded to itself", b->tag[0]);
	d->nbond++;
	return check_length(r, 4);
}

/* A line of a section for a fix property/atom. */
static enum ts_status read_user_line(struct reader *r, struct ts_data_section *s)
{
	size_t row = s->width + 1;
	struct ts_data_atom *a;
	int32_t tag;

	if (TS_GROW(s->value, s->capacity, (s->n + 1) * row) != TS_OK)
		return ts_nomem(&r->sim->error);
	TS_TRY(find_atom(r, 0, "id", &tag, &a));
	s->value[s->n * row] = tag;
	for (size_t k = 1; k < row; k++)
		TS_TRY(ts_lines_real(r->l, k, s->title, &s->value[s->n * row + k]));
	s->n++;
	return check_length(r, row);
}

static int64_t expected_atoms(const struct ts_data *d)
{
	return d->natoms;
}

static int64_t expected_bonds(const struct ts_data *d)
{
	return d->nbonds;
}

static int64_t expected_types(const struct ts_data *d)
{
	return d->ntypes;
}

static int64_t expected_pairs(const struct ts_data *d)
{
	return d->ntypes * (d->ntypes + 1) / 2;
}

static int64_t expected_bond_types(const struct ts_data *d)
{
	return d->nbond_types;
}

struct section {
	const char *title;
	enum ts_status (*line)(struct reader *r);     /* reads a line; NULL: not supported */
	int64_t (*expected)(const struct ts_data *d); /* number of lines */
	bool after_atoms;
	bool in_parts; /* each of several ranks reads a part of the lines */
};

static const struct section sections[] = {
	{ "Atoms", read_atom, expected_atoms, false, true },
	{ "Velocities", read_velocity, expected_atoms, true, true },
	{ "Bonds", read_bond, expected_bonds, true, false },
	{ "Masses", read_mass, expected_types, false, false },
	{ "Pair Coeffs", read_pair_coeff, expected_types, false, false },
	{ "PairIJ Coeffs", read_pair_ij_coeff, expected_pairs, false, false },
	{ "Bond Coeffs", read_bond_coeff, expected_bond_types, false, false },
	{ "Angles", NULL, NULL, false, false },
	{ "Dihedrals", NULL, NULL, false, false },
	{ "Impropers", NULL, NULL, false, false },
	{ "Angle Coeffs", NULL, NULL, false, false },
	{ "Dihedral Coeffs", NULL, NULL, false, false },
	{ "Improper Coeffs", NULL, NULL, false, false },
	{ "Ellipsoids", NULL, NULL, false, false },
	{ "Lines", NULL, NULL, false, false },
	{ "Triangles", NULL, NULL, false, false },
	{ "Bodies", NULL, NULL, false, false },
	{ "Atom Type Labels", NULL, NULL, false, false },
	{ "Bond Type Labels", NULL, NULL, false, false },
};
enum { NSECTIONS = sizeof sections / sizeof *sections };

static enum ts_status refuse_section(struct reader *r)
{
	struct ts_suggest suggest = ts_suggest_start(r->l->word[0]);
	double number;

	if (ts_parse_real(r->l->word[0], &number))
		return ts_lines_fail(r->l, TS_DAMAGED, SIZE_MAX,
				     "expected the title of a section or a line of the header: the section "
				     "above may have more lines than the header says");
	for (size_t k = 0; k < NSECTIONS; k++)
		if (sections[k].line)
			ts_suggest_try(&suggest, sections[k].title);
	return ts_lines_fail(r->l, TS_UNKNOWN, 0, "unknown section '%.60s'%s", r->l->word[0],
			     ts_suggest_text(&suggest));
}

/* `Atoms # sphere` names the style; without a comment, or with `# hybrid` alone, it is that of the script. */
static enum ts_status choose_layout(struct reader *r)
{
	const char *hint = r->l->comment;
	bool bare = ts_streq(hint, "hybrid");
	char style[256];

	snprintf(style, sizeof style, "%s", *hint && !bare ? hint : r->style);
	style[strcspn(style, "\r")] = '\0';
	if (ts_data_layout(style, &r->d->layout))
		return TS_OK;
	style[strcspn(style, " ")] = '\0';
	return ts_data_refuse_style(r->sim, &(struct ts_word){ .text = style,
							       .place = ts_lines_place(r->l, SIZE_MAX) });
}

/* The lines that this rank reads. */
static int64_t first_own(const struct ts_data *d, const struct section *s, int64_t wanted, int64_t *end)
{
	const bool parts = d->parts && s->in_parts;

	*end = parts ? wanted * (d->part + 1) / d->parts : wanted;
	return parts ? wanted * d->part / d->parts : 0;
}

/* All ranks read up to the same line: one that finds an error in a line of its part goes on, and passes the others. */
static enum ts_status read_own(struct reader *r, const struct section *s)
{
	const enum ts_status status = s->line(r);

	if (status == TS_OK || status == TS_NOMEM || !(r->d->parts && s->in_parts))
		return status;
	ts_error_clear(&r->sim->error);
	r->d->failed = true;
	return TS_OK;
}

static enum ts_status read_lines(struct reader *r, const struct section *s)
{
	int64_t wanted = s->expected(r->d), end, first = first_own(r->d, s, wanted, &end);

	for (int64_t k = 0; k < wanted; k++) {
		const bool own = k >= first && k < end && !r->d->failed;

		TS_TRY(own ? ts_lines_next_filled(r->l, &r->more) : ts_lines_pass_filled(r->l, &r->more));
		if (!r->more)
			return ts_lines_fail(r->l, TS_DAMAGED, SIZE_MAX,
					     "the file ends after %" PRId64 " of %" PRId64
					     " lines of section %s",
					     k, wanted, s->title);
		for (int other = 0; other < NSECTIONS && r->l->nwords; other++)
			if (ts_lines_match(r->l, 0, sections[other].title))
				return ts_lines_fail(r->l, TS_DAMAGED, 0,
						     "section %s begins, but section %s has only %" PRId64
						     " of %" PRId64 " lines",
						     sections[other].title, s->title, k, wanted);
		if (own)
			TS_TRY(read_own(r, s));
	}
	return TS_OK;
}

/* Section of a fix property/atom: one line for each particle. */
static enum ts_status read_user_section(struct reader *r, struct ts_data_section *s, bool after_atoms)
{
	if (s->seen || !after_atoms)
		return ts_lines_fail(r->l, TS_DAMAGED, 0,
				     s->seen ? "there is a section %s already"
					     : "section %s must come after section Atoms",
				     s->title);
	s->seen = true;
	for (int64_t k = 0; k < r->d->natoms; k++) {
		TS_TRY(ts_lines_next_filled(r->l, &r->more));
		if (!r->more)
			return ts_lines_fail(r->l, TS_DAMAGED, SIZE_MAX,
					     "the file ends after %" PRId64 " of %" PRId64
					     " lines of section %s",
					     k, r->d->natoms, s->title);
		TS_TRY(read_user_line(r, s));
	}
	return TS_OK;
}

static enum ts_status read_section(struct reader *r, unsigned *seen)
{
	const struct section *s = NULL;

	for (size_t k = 0; k < r->d->nsections; k++)
		if (ts_lines_match(r->l, 0, r->d->section[k].title))
			return read_user_section(r, &r->d->section[k], *seen & 1u);
	for (int k = 0; k < NSECTIONS && !s; k++)
		if (ts_lines_match(r->l, 0, sections[k].title))
			s = &sections[k];
	if (!s)
		return refuse_section(r);
	if (!s->line)
		return ts_lines_fail(r->l, TS_UNKNOWN, 0, "section %s is not supported by tsim", s->title);
	if (*seen & 1u << (s - sections))
		return ts_lines_fail(r->l, TS_DAMAGED, 0, "there is a section %s already", s->title);
	if (s->after_atoms && !(*seen & 1u))
		return ts_lines_fail(r->l, TS_DAMAGED, 0, "section %s must come after section Atoms",
				     s->title);
	*seen |= 1u << (s - sections);
	if (s == sections)
		TS_TRY(choose_layout(r));
	TS_TRY(read_lines(r, s));
	r->d->moving |= s->line == read_velocity && r->d->natoms;
	return s == sections ? sort_atoms(r) : TS_OK;
}

enum ts_status ts_data_read(struct tsim *sim, struct ts_lines *lines, const char *style, struct ts_data *out)
{
	struct reader r = { .sim = sim, .l = lines, .d = out, .style = style };
	unsigned seen = 0;

	out->file = lines->file;
	TS_TRY(read_header(&r));
	if (out->nbonds || out->nbond_types || out->nsections)
		out->parts = 0;
	while (r.more) {
		TS_TRY(read_section(&r, &seen));
		TS_TRY(ts_lines_next_filled(lines, &r.more));
	}
	for (int k = 0; k < 3; k += 2)
		if (sections[k].expected(out) && !(seen & 1u << k))
			return ts_lines_fail(lines, TS_DAMAGED, SIZE_MAX, "the file ends without section %s",
					     sections[k].title);
	return TS_OK;
}

void ts_data_release(struct ts_data *d)
{
	ts_free(d->atom);
	ts_free(d->motion);
	ts_free(d->bond);
	ts_free(d->coeff);
	for (size_t k = 0; k < d->nsections; k++)
		ts_free(d->section[k].value);
	ts_arena_release(&d->arena);
	*d = (struct ts_data){ 0 };
}
