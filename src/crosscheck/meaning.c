#include "crosscheck/meaning.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

#include "base/banned.h"

enum { QUANTITIES = 12, TITLE = 8 };

/* Columns of compute pair/gran/local. Both programs write them in this order, whatever the order of the
 * keywords. `partner`: distance to the column of the other partner. The number of history values depends on
 * the contact law. */
static const struct {
	const char *name;
	int width, partner; /* number of columns; 0: all that follow */
	enum ts_swap_rule swap_rule;
	bool usual; /* written if there are no keywords */
} quantities[QUANTITIES] = {
	{ "pos", 6, 3, TS_SWAP_PARTNER, true },
	{ "vel", 6, 3, TS_SWAP_PARTNER, true },
	{ "id", 3, 1, TS_SWAP_PARTNER, true }, /* the third: whether the contact is across a periodic face */
	{ "force", 3, 0, TS_SWAP_SIGN, true },
	{ "force_normal", 3, 0, TS_SWAP_SIGN, false },
	{ "force_tangential", 3, 0, TS_SWAP_SIGN, false },
	{ "torque", 3, 0, TS_SWAP_UNKNOWN, false },
	{ "history", 0, 0, TS_SWAP_EITHER_SIGN, true },
	{ "contactArea", 1, 0, TS_SWAP_INVARIANT, true },
	{ "delta", 1, 0, TS_SWAP_INVARIANT, false },
	{ "contactPoint", 3, 0, TS_SWAP_INVARIANT, false },
	{ "heatFlux", 1, 0, TS_SWAP_SIGN, false },
};

/* Keywords of thermo_style that include the elastic energy of contacts. */
static const struct {
	const char *keyword, *title;
} energies[] = {
	{ "pe", "PotEng" },    { "etotal", "TotEng" },	   { "epair", "E_pair" },
	{ "evdwl", "E_vdwl" }, { "enthalpy", "Enthalpy" }, { "econserve", "Econserve" },
};
enum { ENERGIES = sizeof energies / sizeof *energies };

/* Columns that a compute pair/gran/local writes. */
struct contacts {
	bool wanted[QUANTITIES];
	bool known;
};

static enum ts_status store_entry(struct ts_meanings *m, struct ts_map *map, const char *key, void *value)
{
	const char *kept = ts_pool_get(m->pool, key);

	return kept ? ts_map_set(map, kept, value) : ts_nomem(m->err);
}

static enum ts_status read_contact_columns(struct ts_meanings *m, const char *const *word, size_t n)
{
	struct contacts *c = ts_arena_alloc(&m->arena, 1, sizeof *c),
			*before = ts_map_get(&m->contacts, word[1]);

	if (!c)
		return ts_nomem(m->err);
	*c = (struct contacts){ .known = true };
	for (int q = 0; q < QUANTITIES; q++)
		c->wanted[q] = n == 4 && quantities[q].usual;
	for (size_t k = 4; k < n; k++) {
		int q = 0;

		while (q < QUANTITIES && !ts_streq(quantities[q].name, word[k]))
			q++;
		c->known &= q < QUANTITIES;
		if (q < QUANTITIES)
			c->wanted[q] = true;
	}
	if (before) /* an ID that is used twice, after `clear` */
		c->known &= before->known && memcmp(before->wanted, c->wanted, sizeof c->wanted) == 0;
	return store_entry(m, &m->contacts, word[1], c);
}

/* Whether a formula refers to such an energy by name. */
static bool names_energy(const struct ts_meanings *m, const char *formula)
{
	char name[64];

	while (*formula) {
		size_t n = 0;

		while (isalnum((unsigned char)formula[n]) || formula[n] == '_')
			n++;
		snprintf(name, sizeof name, "%.*s", (int)(n < sizeof name ? n : 0), formula);
		if (n && ts_map_get(&m->differs, name))
			return true;
		for (int k = 0; k < ENERGIES; k++)
			if (ts_streq(energies[k].keyword, name))
				return true;
		formula += n + !n;
	}
	return false;
}

static bool refers_to_energy(const struct ts_meanings *m, const char *const *word, size_t n)
{
	if (ts_streq(word[0], "compute"))
		return ts_streq(word[3], "pe") || ts_streq(word[3], "pe/atom");
	for (size_t k = 3; k < n && ts_streq(word[0], "variable"); k++)
		if (names_energy(m, word[k]))
			return true;
	return false;
}

/* The title of a column of the thermo output is truncated and without "c_"; two columns may have the same. */
static enum ts_status store_title(struct ts_meanings *m, const char *kept)
{
	char title[TITLE + 1];
	const char *before;

	snprintf(title, sizeof title, "%s", kept + 2);
	before = ts_map_get(&m->titles, title);
	return store_entry(m, &m->titles, title,
			   (void *)(uintptr_t)(!before || before == kept ? kept : "two"));
}

enum ts_status ts_meanings_read_command(struct ts_meanings *m, const char *const *word, size_t n)
{
	static const char *const commands[] = { "compute", "fix", "variable" };
	char name[64];
	const char *kept;
	size_t k = 0;

	while (k < 3 && n && !ts_streq(commands[k], word[0]))
		k++;
	if (k == 3 || n < 4)
		return TS_OK;
	snprintf(name, sizeof name, "%c_%.60s", word[0][0], word[1]);
	kept = ts_pool_get(m->pool, name);
	if (!kept)
		return ts_nomem(m->err);
	TS_TRY(store_title(m, kept));
	if (refers_to_energy(m, word, n))
		TS_TRY(ts_map_set(&m->differs, kept, m));
	return k == 0 && ts_streq(word[3], "pair/gran/local") ? read_contact_columns(m, word, n) : TS_OK;
}

bool ts_meanings_differ(const struct ts_meanings *m, enum ts_frame_kind kind, const char *column)
{
	char name[64];

	if (!m)
		return false;
	for (int k = 0; k < ENERGIES && kind == TS_FRAMES_THERMO; k++)
		if (ts_streq(energies[k].title, column))
			return true;
	if (kind == TS_FRAMES_THERMO) {
		const char *full = ts_map_get(&m->titles, column);

		return full && ts_map_get(&m->differs, full);
	}
	snprintf(name, sizeof name, "%.*s", (int)strcspn(column, "["), column);
	return ts_map_get(&m->differs, name) != NULL;
}

/* Swap rule of column k, from 1. *partner: the column of the other partner. */
static enum ts_swap_rule swap_rule_of(const struct contacts *c, int k, int *partner)
{
	int first = 1;

	*partner = 0;
	for (int q = 0; q < QUANTITIES; q++) {
		int inner = k - first, distance = quantities[q].partner;

		if (!c->wanted[q])
			continue;
		if (!quantities[q].width)
			return quantities[q].swap_rule;
		first += quantities[q].width;
		if (k >= first)
			continue;
		if (!distance)
			return quantities[q].swap_rule;
		if (inner >= 2 * distance)
			return TS_SWAP_INVARIANT;
		*partner = inner < distance ? k + distance : k - distance;
		return TS_SWAP_PARTNER;
	}
	return TS_SWAP_INVARIANT;
}

/* Splits "c_ID[k]" into ID and k, and finds the compute; NULL if it is not a column of contacts. */
static const struct contacts *contacts_of(const struct ts_meanings *m, const char *column, char id[64],
					  int *k)
{
	const struct contacts *c;
	char rest;

	if (sscanf(column, "c_%60[^[][%d%c", id, k, &rest) != 3 || rest != ']')
		return NULL;
	c = ts_map_get(&m->contacts, id);
	return c && c->known ? c : NULL;
}

static size_t column_at(const struct ts_meanings *m, const struct ts_frame *f, const char *id, int k)
{
	char name[96];
	const char *kept;

	snprintf(name, sizeof name, "c_%s[%d]", id, k);
	kept = ts_pool_get(m->pool, name);
	return kept ? ts_frame_column(f, kept) : SIZE_MAX;
}

/* The first of its columns with the identities of the partners, from 1; 0: none. */
static int identity_column(const struct contacts *c)
{
	int first = 1;

	for (int q = 0; q < QUANTITIES && quantities[q].width; q++) {
		if (ts_streq(quantities[q].name, "id"))
			return c->wanted[q] ? first : 0;
		first += c->wanted[q] ? quantities[q].width : 0;
	}
	return 0;
}

/* Sets the swap rule of each column; *id: the columns of the identities. */
static void set_swap_rules(const struct ts_meanings *m, struct ts_frame *f, size_t id[2])
{
	char name[64];

	id[0] = id[1] = SIZE_MAX;
	for (size_t k = 0; k < f->columns; k++) {
		int at, partner, first;
		const struct contacts *c = contacts_of(m, f->name[k], name, &at);

		f->swap_rule[k] = c ? swap_rule_of(c, at, &partner) : TS_SWAP_INVARIANT;
		f->partner[k] = k;
		if (!c)
			continue;
		if (f->swap_rule[k] == TS_SWAP_PARTNER)
			f->partner[k] = column_at(m, f, name, partner);
		if (f->partner[k] == SIZE_MAX)
			f->swap_rule[k] = TS_SWAP_UNKNOWN;
		first = identity_column(c);
		for (int who = 0; who < 2 && first && (id[0] == SIZE_MAX || id[1] == SIZE_MAX); who++)
			id[who] = column_at(m, f, name, first + who);
	}
}

static void swap_partners(const struct ts_frame *f, struct ts_printed *cell)
{
	for (size_t k = 0; k < f->columns; k++) {
		size_t other = f->partner[k];

		if (f->swap_rule[k] == TS_SWAP_SIGN)
			cell[k].value = -cell[k].value;
		if (f->swap_rule[k] == TS_SWAP_PARTNER && k < other) {
			struct ts_printed swap = cell[k];

			cell[k] = cell[other];
			cell[other] = swap;
		}
	}
}

enum ts_status ts_meanings_order_partners(const struct ts_meanings *m, struct ts_frame *f)
{
	size_t id[2];

	f->has_contacts = false;
	if (!m || !f->entries || !m->contacts.used)
		return TS_OK;
	if (TS_GROW(f->swap_rule, f->swap_rule_capacity, f->columns + 1) != TS_OK ||
	    TS_GROW(f->partner, f->partner_capacity, f->columns + 1) != TS_OK ||
	    TS_GROW(f->swapped, f->swapped_capacity, f->rows + 1) != TS_OK)
		return ts_nomem(m->err);
	set_swap_rules(m, f, id);
	f->has_contacts = id[0] != SIZE_MAX && id[1] != SIZE_MAX;
	for (size_t row = 0; row < f->rows && f->has_contacts; row++) {
		struct ts_printed *cell = f->cell + row * f->columns;

		f->swapped[row] = cell[id[0]].value > cell[id[1]].value;
		if (f->swapped[row])
			swap_partners(f, cell);
	}
	return TS_OK;
}

void ts_meanings_release(struct ts_meanings *m)
{
	ts_map_release(&m->contacts);
	ts_map_release(&m->differs);
	ts_map_release(&m->titles);
	ts_arena_release(&m->arena);
}
