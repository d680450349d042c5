/* Data files: enters the contents of a file in the simulation. */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>

#include "box/domain.h"
#include "core/ranks.h"
#include "particle/columns.h"
#include "particle/division.h"
#include "particle/identity.h"
#include "particle/molecule.h"
#include "particle/particles.h"
#include "particle/sphere_shape.h"
#include "restart/data.h"

#include "base/banned.h"

/* All errors are found before anything is changed. */
static enum ts_status refuse_line(struct tsim *sim, const struct ts_data *data, int line, const char *format,
				  ...) __attribute__((format(printf, 4, 5)));
static enum ts_status refuse_line(struct tsim *sim, const struct ts_data *data, int line, const char *format,
				  ...)
{
	struct ts_place place = { .file = data->file, .line = line };
	char text[200];
	va_list args;

	va_start(args, format);
	vsnprintf(text, sizeof text, format, args);
	va_end(args);
	return ts_fail(&sim->error, TS_RANGE, &place, "%s", text);
}

static enum ts_status check_position(struct tsim *sim, const struct ts_data *data, const struct ts_box *box,
				     const struct ts_data_atom *a, const double shift[3])
{
	for (int d = 0; d < 3; d++) {
		double x = a->x[d] + shift[d];

		if ((box->face[d][0] == TS_FACE_FIXED && x < box->lo[d]) ||
		    (box->face[d][1] == TS_FACE_FIXED && x > box->hi[d]))
			return refuse_line(sim, data, a->line,
					   "%c = %g lies outside the box, whose face is fixed", "xyz"[d], x);
		if (!(fabs(x - box->lo[d]) <= 1e9 * ts_box_length(box, d)))
			return refuse_line(sim, data, a->line,
					   "a coordinate of %g is too far from the box, which is %g long", x,
					   ts_box_length(box, d));
	}
	return TS_OK;
}

static enum ts_status check_atoms(struct tsim *sim, const struct ts_data *data, const struct ts_box *box,
				  int ntypes, const struct ts_data_options *o)
{
	struct ts_identities map;

	TS_TRY(ts_identities(sim, false, &map));
	for (size_t k = 0; k < data->n; k++) {
		const struct ts_data_atom *a = &data->atom[k];
		int64_t tag = a->tag + o->tag_offset, type = a->type + o->type_offset;

		if (tag < 1 || tag > INT32_MAX - 1)
			return refuse_line(sim, data, a->line, "id %d with its offset is %lld", (int)a->tag,
					   (long long)tag);
		if (type < 1 || type > ntypes)
			return refuse_line(sim, data, a->line,
					   "type %d with its offset is more than the %d there are",
					   (int)a->type, ntypes);
		if (ts_identity_row(&map, tag) >= 0)
			return refuse_line(sim, data, a->line,
					   "there is a particle %lld already: use `add append`",
					   (long long)tag);
		if (!data->layout.sized && !(data->mass && data->mass[a->type] > 0))
			return refuse_line(sim, data, a->line,
					   "type %d has no mass: a section Masses is needed", (int)a->type);
		TS_TRY(check_position(sim, data, box, a, o->shift));
	}
	return TS_OK;
}

/* Extends an existing box to contain that of the file. */
static void extend_box(const struct ts_data *data, const double shift[3], struct ts_domain *domain)
{
	for (int d = 0; d < 3; d++) {
		domain->box.lo[d] = fmin(domain->box.lo[d], data->lo[d] + shift[d]);
		domain->box.hi[d] = fmax(domain->box.hi[d], data->hi[d] + shift[d]);
		domain->first_lo[d] = fmin(domain->first_lo[d], domain->box.lo[d]);
		domain->first_hi[d] = fmax(domain->first_hi[d], domain->box.hi[d]);
	}
}

/* Where the particle is, in a periodic box, and its image flags there. */
static void find_place(const struct tsim *sim, const struct ts_data_atom *a, const double shift[3],
		       double x[3], int32_t image[3])
{
	const struct ts_box *box = &sim->domain->box;

	for (int d = 0; d < 3; d++) {
		x[d] = a->x[d] + shift[d];
		image[d] = a->image[d];
		if (ts_box_periodic(box, d))
			(void)ts_box_wrap(box, d, &x[d], &image[d]);
	}
}

static void set_atom(struct tsim *sim, const struct ts_data *data, const struct ts_data_atom *a,
		     const struct ts_data_options *o, size_t i)
{
	struct ts_particles *p = sim->particles;

	p->tag[i] = (int32_t)(a->tag + o->tag_offset);
	p->type[i] = (int32_t)(a->type + o->type_offset);
	p->radius[i] = 0.5 * a->diameter;
	p->mass[i] =
		data->layout.sized ? a->density * ts_particle_volume(sim, p->radius[i]) : data->mass[a->type];
	p->mask[i] |= 1u << o->group;
	find_place(sim, a, o->shift, p->x[i], p->image[i]);
	for (int d = 0; d < 3; d++) {
		p->v[i][d] = a->v[d];
		if (p->omega)
			p->omega[i][d] = a->omega[d];
	}
	if (p->tag[i] > p->max_tag)
		p->max_tag = p->tag[i];
}

static bool has_rotation(const struct tsim *sim, const struct ts_data *data)
{
	bool has = false;

	for (size_t k = 0; k < data->n; k++)
		for (int d = 0; d < 3; d++)
			has |= data->atom[k].omega[d] != 0;
	return ts_ranks_most(sim, has) > 0;
}

/* Each rank has some of the particles: gives them to the ranks of their places. */
static enum ts_status send_atoms(struct tsim *sim, struct ts_data *data, double (*x)[3], int32_t *to)
{
	struct ts_new_rows rows = { data->atom, data->n, data->capacity, sizeof *data->atom };
	enum ts_status status = ts_division_make(sim, x, data->n);

	for (size_t k = 0; status == TS_OK && k < data->n; k++)
		to[k] = ts_division_owner(sim, x[k]);
	if (status == TS_OK)
		status = ts_division_send(sim, &rows, to);
	data->atom = rows.row;
	data->n = rows.n;
	data->capacity = rows.capacity;
	return status;
}

static enum ts_status divide_atoms(struct tsim *sim, struct ts_data *data, const double shift[3])
{
	double(*x)[3] = ts_alloc(data->n, sizeof *x);
	int32_t *to = ts_alloc(data->n, sizeof *to);
	enum ts_status status = x && to ? TS_OK : ts_nomem(&sim->error);

	for (size_t k = 0; status == TS_OK && k < data->n; k++)
		find_place(sim, &data->atom[k], shift, x[k], (int32_t[3]){ 0 });
	if (status == TS_OK)
		status = send_atoms(sim, data, x, to);
	ts_free(x);
	ts_free(to);
	return status;
}

static enum ts_status make_atoms(struct tsim *sim, const struct ts_data *data,
				 const struct ts_data_options *o)
{
	struct ts_particles *p = sim->particles;
	int32_t max_tag = p->max_tag;
	double *molecule;
	size_t first;

	if (has_rotation(sim, data))
		TS_TRY(ts_particles_need(sim, TS_NEED(OMEGA)));
	TS_TRY(ts_particles_add(sim, data->n, &first));
	p->max_tag = max_tag; /* ids are those of the file */
	for (size_t k = 0; k < data->n; k++)
		set_atom(sim, data, &data->atom[k], o, first + k);
	molecule = ts_particles_molecules_to_set(p);
	for (size_t k = 0; molecule && k < data->n; k++)
		molecule[first + k] =
			data->atom[k].molecule + (data->atom[k].molecule > 0 ? o->molecule_offset : 0);
	p->max_tag = (int32_t)ts_ranks_most(sim, p->max_tag);
	ts_particles_inverse_mass(p);
	return TS_OK;
}

/* The box with that of the file, and the number of types. */
struct wanted {
	struct ts_domain domain;
	int ntypes;
};

static struct wanted find_wanted(const struct tsim *sim, const struct ts_data *data,
				 const struct ts_data_options *o)
{
	const bool new = !sim->has_box;
	struct wanted w = { *sim->domain, sim->particles->ntypes };

	if (new)
		w.ntypes = (int)(data->ntypes + o->extra_types);
	for (int d = 0; d < 3 && new; d++) {
		w.domain.box.lo[d] = w.domain.first_lo[d] = data->lo[d] + o->shift[d];
		w.domain.box.hi[d] = w.domain.first_hi[d] = data->hi[d] + o->shift[d];
	}
	if (!o->keep_box)
		extend_box(data, o->shift, &w.domain);
	return w;
}

void ts_data_append(const struct tsim *sim, struct ts_data_options *o)
{
	if (o->add != TS_DATA_APPEND)
		return;
	o->tag_offset += sim->particles->max_tag;
	o->molecule_offset = ts_particles_most_molecule(sim);
}

enum ts_status ts_data_check(struct tsim *sim, const struct ts_data *data, const struct ts_data_options *o)
{
	const struct wanted w = find_wanted(sim, data, o);

	return check_atoms(sim, data, &w.domain.box, w.ntypes, o);
}

enum ts_status ts_data_apply(struct tsim *sim, struct ts_data *data, const struct ts_data_options *o)
{
	const struct wanted w = find_wanted(sim, data, o);
	struct ts_particles *p = sim->particles;

	if (!sim->has_box)
		TS_TRY(ts_particles_make_box(sim, w.ntypes, w.domain.box.lo, w.domain.box.hi, NULL));
	else
		*sim->domain = w.domain;
	for (int64_t t = 1; data->mass && t <= data->ntypes; t++)
		if (t + o->type_offset >= 1 && t + o->type_offset <= w.ntypes)
			p->type_mass[t + o->type_offset] = data->mass[t];
	if (data->parts)
		TS_TRY(divide_atoms(sim, data, o->shift));
	TS_TRY(make_atoms(sim, data, o));
	return data->parts ? ts_division_made(sim) : TS_OK;
}
