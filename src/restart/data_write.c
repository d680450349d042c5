/* Data files: writes a file. Numbers have as many digits as are needed to read back the same bits. */
#include "restart/data.h"

#include <math.h>

#include "box/domain.h"
#include "io/decimal.h"
#include "particle/exchange.h"
#include "particle/group_moments.h"
#include "particle/identity.h"
#include "particle/molecule.h"
#include "particle/sphere_shape.h"
#include "particle/user_columns.h"

#include "base/banned.h"

/* Smallest density within 3 ulp of mass / volume for which density * volume == mass; false: there is none. */
static bool find_density(double mass, double volume, double *out)
{
	enum { AROUND = 3 };
	double density = mass / volume;

	for (int k = 0; k < AROUND; k++)
		density = nextafter(density, 0);
	for (int k = 0; k <= 2 * AROUND; k++, density = nextafter(density, INFINITY)) {
		if (density * volume != mass)
			continue;
		*out = density;
		return true;
	}
	return false;
}

/* Density from which read_data computes the same mass; if rounding allows none, a density that is written
 * unchanged after it is read back. */
static double density_of(double mass, double volume)
{
	double density = mass / volume;

	if (!find_density(mass, volume, &density))
		find_density(density * volume, volume, &density);
	return density;
}

static void add_number(struct ts_str *out, double value)
{
	char text[TS_DECIMAL_SIZE + 1] = " ";

	ts_str_add_n(out, text, 1 + ts_decimal_shortest(value, text + 1));
}

static void add_whole(struct ts_str *out, const char *before, int value)
{
	char text[TS_DECIMAL_SIZE];

	ts_str_add(out, before);
	ts_str_add_n(out, text, ts_decimal_lld(value, text));
}

static void add_header(struct tsim *sim, struct ts_str *out, struct ts_data_counts counts)
{
	ts_str_addf(out, "LAMMPS data file by tsim\n\n%zu atoms\n%d atom types\n", sim->particles->n,
		    sim->particles->ntypes);
	if (counts.bond_types)
		ts_str_addf(out, "%zu bonds\n%d bond types\n", counts.bonds, counts.bond_types);
	ts_str_add(out, "\n");
	for (int d = 0; d < 3; d++) {
		struct ts_str line = { 0 };
		double lo, hi;

		ts_exchange_fitted_faces(sim, d, &lo, &hi);
		add_number(&line, lo);
		add_number(&line, hi);
		out->failed |= line.failed; /* else it begins with a blank */
		if (!line.failed)
			ts_str_addf(out, "%s %clo %chi\n", line.text + 1, 'x' + d, 'x' + d);
		ts_str_release(&line);
	}
}

static void add_atom(struct ts_str *out, const struct tsim *sim, size_t i, bool hybrid)
{
	const struct ts_particles *p = sim->particles;
	const double *molecule = ts_particles_molecules(p);
	int32_t image[3];
	double x[3];

	ts_wrapped(sim, i, x, image);
	add_whole(out, "", p->tag[i]);
	add_whole(out, " ", p->type[i]);
	for (int k = 0; k < 2; k++) {
		if (!k == hybrid) {
			for (int d = 0; d < 3; d++)
				add_number(out, x[d]);
		} else {
			add_number(out, 2 * p->radius[i]);
			add_number(out, density_of(p->mass[i], ts_particle_volume(sim, p->radius[i])));
		}
	}
	if (hybrid)
		add_whole(out, " ", molecule ? (int)molecule[i] : 0);
	for (int d = 0; d < 3; d++)
		add_whole(out, " ", image[d]);
	ts_str_add_n(out, "\n", 1);
}

static void add_velocity(struct ts_str *out, const struct ts_particles *p, size_t i)
{
	static const double zero[3];
	const double *omega = p->omega ? p->omega[i] : zero;

	add_whole(out, "", p->tag[i]);
	for (int d = 0; d < 6; d++)
		add_number(out, d < 3 ? p->v[i][d] : omega[d - 3]);
	ts_str_add(out, "\n");
}

enum ts_status ts_data_write(struct tsim *sim, struct ts_textfile *out, struct ts_data_counts counts)
{
	struct ts_particles *p = sim->particles;
	bool hybrid = counts.bond_types > 0 || counts.molecules;
	struct ts_str text = { 0 };
	struct ts_identities map;
	enum ts_status status = TS_OK;

	TS_TRY(ts_identities(sim, true, &map));
	add_header(sim, &text, counts);
	for (int section = 0; p->n && section < 2 && status == TS_OK; section++) {
		ts_str_add(&text, section	      ? "\nVelocities\n\n"
				  : counts.bond_types ? "\nAtoms # hybrid sphere bond\n\n"
				  : hybrid	      ? "\nAtoms # hybrid sphere molecular\n\n"
						      : "\nAtoms # sphere\n\n");
		for (size_t k = 0; k < map.n && status == TS_OK; k++) {
			if (section)
				add_velocity(&text, p, (size_t)map.row[k]);
			else
				add_atom(&text, sim, (size_t)map.row[k], hybrid);
			if (text.length < 1 << 16)
				continue;
			status = ts_textfile_write(out, ts_str_text(&text), text.length);
			ts_str_clear(&text);
		}
	}
	if (status == TS_OK)
		status = text.failed ? ts_nomem(&sim->error)
				     : ts_textfile_write(out, ts_str_text(&text), text.length);
	ts_str_release(&text);
	return status;
}

static enum ts_status add_section(struct tsim *sim, const struct ts_user_columns *columns,
				  const struct ts_identities *map, double *value, struct ts_str *out)
{
	const struct ts_particles *p = sim->particles;

	ts_str_addf(out, "\n%s\n\n", columns->title);
	for (size_t k = 0; k < map->n; k++) {
		ts_user_columns_get(p, columns, (size_t)map->row[k], value);
		add_whole(out, "", p->tag[map->row[k]]);
		for (size_t j = 0; j < columns->width; j++)
			add_number(out, value[j]);
		ts_str_add(out, "\n");
	}
	return out->failed ? ts_nomem(&sim->error) : TS_OK;
}

enum ts_status ts_data_write_columns(struct tsim *sim, struct ts_textfile *out,
				     const struct ts_user_columns *columns)
{
	struct ts_str text = { 0 };
	struct ts_identities map;
	double *value;
	enum ts_status status;

	if (!columns->title || !sim->particles->n)
		return TS_OK;
	TS_TRY(ts_identities(sim, true, &map));
	value = ts_alloc(columns->width, sizeof *value);
	if (!value)
		return ts_nomem(&sim->error);
	status = add_section(sim, columns, &map, value, &text);
	if (status == TS_OK)
		status = ts_textfile_write(out, ts_str_text(&text), text.length);
	ts_free(value);
	ts_str_release(&text);
	return status;
}
