/* Command write_data: writes box and particles to a data file. */
#include "bond/bonds.h"
#include "box/domain.h"
#include "contact/pair.h"
#include "core/written_files.h"
#include "io/series.h"
#include "particle/molecule.h"
#include "particle/user_columns.h"
#include "restart/data.h"

#include "base/banned.h"

struct write_data {
	const char *file;
	bool nocoeff, nofix;
	int pairs;
};
enum { II, IJ };
static const char *const pair_choices[] = { "ii", "ij", NULL };

static void add_coeff(const struct tsim *sim, const struct ts_coeffs *c, size_t k, const char *types,
		      struct ts_str *out)
{
	struct ts_str record = { 0 };

	ts_args_record(sim, c->rows, ts_coeff(c, k), &record);
	ts_str_addf(out, "%s %s\n", types, ts_str_text(&record));
	out->failed |= record.failed;
	ts_str_release(&record);
}

static bool all_given(const struct ts_pair *pair, bool diagonal)
{
	for (int a = 1; a <= pair->ntypes; a++)
		for (int b = a; b <= (diagonal ? a : pair->ntypes); b++)
			if (!pair->coeffs.given[a * (pair->ntypes + 1) + b])
				return false;
	return true;
}

/* Styles with `pair_coeff * *` only have no coefficients: LIGGGHTS and LAMMPS write no section for them. */
static bool has_coefficients(const struct ts_coeffs *c)
{
	return c->rows && c->rows->type != TS_ARG_END;
}

static void add_pair_coeffs(const struct tsim *sim, int pairs, struct ts_str *out)
{
	const struct ts_instance *inst = ts_sim_only(sim, TS_KIND_PAIR);
	const struct ts_pair *pair = inst ? inst->state : NULL;
	char types[32];

	if (!pair || !pair->ntypes || !has_coefficients(&pair->coeffs) || !all_given(pair, pairs == II))
		return;
	ts_str_addf(out, "\n%s # %s\n\n", pairs == II ? "Pair Coeffs" : "PairIJ Coeffs", inst->style->name);
	for (int a = 1; a <= pair->ntypes; a++) {
		for (int b = a; b <= (pairs == II ? a : pair->ntypes); b++) {
			snprintf(types, sizeof types, pairs == II ? "%d" : "%d %d", a, b);
			add_coeff(sim, &pair->coeffs, (size_t)(a * (pair->ntypes + 1) + b), types, out);
		}
	}
}

static void add_bond_coeffs(const struct tsim *sim, struct ts_str *out)
{
	const struct ts_instance *inst = ts_sim_only(sim, TS_KIND_BOND);
	const struct ts_bond *bond = inst ? inst->state : NULL;
	char type[16];

	for (int t = 1; bond && t <= sim->bonds->ntypes; t++)
		if ((size_t)t >= bond->coeffs.n || !bond->coeffs.given[t])
			return;
	if (!bond || !sim->bonds->ntypes)
		return;
	ts_str_addf(out, "\nBond Coeffs # %s\n\n", inst->style->name);
	for (int t = 1; t <= sim->bonds->ntypes; t++) {
		snprintf(type, sizeof type, "%d", t);
		add_coeff(sim, &bond->coeffs, (size_t)t, type, out);
	}
}

static enum ts_status write_bonds(struct tsim *sim, struct ts_textfile *out)
{
	struct ts_bonds *b = sim->bonds;

	ts_bonds_sort(b);
	if (b->n)
		TS_TRY(ts_textfile_printf(out, "\nBonds\n\n"));
	for (size_t k = 0; k < b->n; k++)
		TS_TRY(ts_textfile_printf(out, "%zu %d %d %d\n", k + 1, b->type[k], b->tag[k][0],
					  b->tag[k][1]));
	return TS_OK;
}

/* Writes a section for each fix property/atom. */
static enum ts_status write_columns(struct tsim *sim, struct ts_textfile *out)
{
	const struct ts_instances *fixes = &sim->instances[TS_KIND_FIX];

	for (size_t k = 0; k < fixes->n; k++)
		if (ts_streq(fixes->item[k]->style->name, "property/atom"))
			TS_TRY(ts_data_write_columns(sim, out, fixes->item[k]->state));
	return TS_OK;
}

/* Whether the molecule ids have no section of their own. */
static bool atoms_have_molecules(const struct tsim *sim, const struct write_data *c)
{
	const struct ts_instances *fixes = &sim->instances[TS_KIND_FIX];

	for (size_t k = 0; k < fixes->n && !c->nofix; k++) {
		const struct ts_user_columns *columns = fixes->item[k]->state;

		if (ts_streq(fixes->item[k]->style->name, "property/atom") && columns->title &&
		    ts_streq(columns->title, "Molecules"))
			return false;
	}
	return ts_particles_molecules(sim->particles) != NULL;
}

static enum ts_status write_contents(struct tsim *sim, const struct write_data *c, struct ts_textfile *out)
{
	struct ts_data_counts counts = { sim->bonds->n, sim->bonds->ntypes, atoms_have_molecules(sim, c) };
	struct ts_str text = { 0 };
	enum ts_status status = TS_OK;

	TS_TRY(ts_data_write(sim, out, counts));
	TS_TRY(write_bonds(sim, out));
	if (!c->nofix)
		TS_TRY(write_columns(sim, out));
	if (!c->nocoeff) {
		add_pair_coeffs(sim, c->pairs, &text);
		add_bond_coeffs(sim, &text);
	}
	status =
		text.failed ? ts_nomem(&sim->error) : ts_textfile_write(out, ts_str_text(&text), text.length);
	ts_str_release(&text);
	return status;
}

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct write_data *c = state;
	struct ts_textfile out = { 0 };
	struct ts_str path = { 0 };
	enum ts_status status;

	TS_TRY(ts_domain_refuse_shear(sim, "write_data", where));
	TS_TRY(ts_written_files_allow(sim, "write_data", c->file, where));
	if (sim->reading.explain)
		return TS_OK;
	ts_series_path(&path, c->file, (long long)sim->clock.step, 0);
	status = path.failed ? ts_nomem(&sim->error)
			     : ts_textfile_open(&out, sim, where, ts_str_text(&path), false);
	ts_str_release(&path);
	TS_TRY(status);
	status = write_contents(sim, c, &out);
	if (status != TS_OK) {
		ts_textfile_close(&out);
		return status;
	}
	return ts_textfile_close(&out);
}

static const struct ts_arg args[] = {
	TS_WORD("file", struct write_data, file, .flags = TS_POSITIONAL | TS_WRITES,
		.help = "name of the file; `*` stands for the step; compressed if it ends in .gz"),
	TS_ENUM("pair", struct write_data, pairs, pair_choices, .fallback = "ij",
		.help = "pair coefficients of equal types only (ii), or of all pairs of types (ij)"),
	TS_FLAG("nocoeff", struct write_data, nocoeff, .help = "omit pair and bond coefficients"),
	TS_FLAG("nofix", struct write_data, nofix, .help = "omit the numbers of fixes property/atom"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_write_data)
const struct ts_command_style ts_command_write_data = {
	.style = {
		.name = "write_data",
		.kind = TS_KIND_COMMAND,
		.summary = "Writes box and particles to a data file",
		.doc = "Writes a text file for read_data of tsim, LAMMPS and LIGGGHTS; LAMMPS and LIGGGHTS "
		       "can read the coefficients of few pair styles of tsim: use `nocoeff` for them. "
		       "Particles are sorted by id. Numbers have as many digits as are needed to read back "
		       "the same value, so that a file that is read and written again is the same, byte for "
		       "byte. Contact histories, equilibrium lengths of bonds, groups and fixes are not "
		       "written; use write_restart for them. If there are bonds, the columns are those of "
		       "atom_style hybrid sphere bond.",
		.example = "write_data bed.data\n"
			   "write_data rock.*.data.gz nocoeff",
		.args = args,
		.state_size = sizeof(struct write_data),
	},
	.needs_box = true,
	.run = run,
};
