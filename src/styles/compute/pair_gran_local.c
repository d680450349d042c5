/* Compute: contacts in the columns of LIGGGHTS. */
#include "core/name_list.h"
#include "math/vec3.h"
#include "neigh/contact_list.h"

#include <math.h>
#include <string.h>

#include "base/banned.h"

/* Writes the numbers of one quantity. */
typedef void quantity_fn(const struct tsim *sim, const struct ts_contact_view *v, double *out);

static void pos(const struct tsim *sim, const struct ts_contact_view *v, double *out)
{
	memcpy(out, sim->particles->x[v->a], 3 * sizeof *out);
	memcpy(out + 3, sim->particles->x[v->b], 3 * sizeof *out);
}

static void vel(const struct tsim *sim, const struct ts_contact_view *v, double *out)
{
	memcpy(out, sim->particles->v[v->a], 3 * sizeof *out);
	memcpy(out + 3, sim->particles->v[v->b], 3 * sizeof *out);
}

static void id(const struct tsim *sim, const struct ts_contact_view *v, double *out)
{
	out[0] = sim->particles->tag[v->a];
	out[1] = sim->particles->tag[v->b];
	out[2] = v->image;
}

static void force(const struct tsim *sim, const struct ts_contact_view *v, double *out)
{
	(void)sim;
	memcpy(out, v->force, 3 * sizeof *out);
}

static void force_normal(const struct tsim *sim, const struct ts_contact_view *v, double *out)
{
	double along = v->distance > 0 ? ts_dot(v->force, v->d) / v->distance / v->distance : 0;

	(void)sim;
	ts_scale(along, v->d, out);
}

static void force_tangential(const struct tsim *sim, const struct ts_contact_view *v, double *out)
{
	double normal[3];

	force_normal(sim, v, normal);
	ts_sub(v->force, normal, out);
}

static void history(const struct tsim *sim, const struct ts_contact_view *v, double *out)
{
	const struct ts_rows *rows = &sim->neigh->rows;

	for (size_t k = 0; k < rows->history_width; k++)
		out[k] = rows->history[v->row * rows->history_width + k] *
			 (v->sign < 0 ? rows->history_sign[k] : 1);
}

/* Of the circle in which the two spheres meet. */
static void contact_area(const struct tsim *sim, const struct ts_contact_view *v, double *out)
{
	const double pi = 3.14159265358979323846;
	double a = sim->particles->radius[v->a], b = sim->particles->radius[v->b], r = v->distance;

	out[0] = -pi / 4 * ((r - a - b) * (r + a - b) * (r - a + b) * (r + a + b)) / (r * r);
}

static void delta(const struct tsim *sim, const struct ts_contact_view *v, double *out)
{
	out[0] = sim->particles->radius[v->a] + sim->particles->radius[v->b] - v->distance;
}

/* Divides the line of centres as the radii are to each other; on the side of the first partner. */
static void contact_point(const struct tsim *sim, const struct ts_contact_view *v, double *out)
{
	double a = sim->particles->radius[v->a], b = sim->particles->radius[v->b];

	for (int k = 0; k < 3; k++)
		out[k] = sim->particles->x[v->a][k] - v->d[k] * (a / (a + b));
}

/* In the order of the output, whatever the order of the words. */
static const struct quantity {
	const char *name;
	quantity_fn *write;
	size_t width; /* 0: as many as the contact law remembers */
	bool usual;   /* written when no word is given */
} quantities[] = {
	{ "pos", pos, 6, true },
	{ "vel", vel, 6, true },
	{ "id", id, 3, true },
	{ "force", force, 3, true },
	{ "force_normal", force_normal, 3, false },
	{ "force_tangential", force_tangential, 3, false },
	{ "history", history, 0, true },
	{ "contactArea", contact_area, 1, true },
	{ "delta", delta, 1, false },
	{ "contactPoint", contact_point, 3, false },
	{ .name = NULL },
};
enum { NQUANTITIES = sizeof quantities / sizeof *quantities - 1 };

struct state {
	struct ts_words words;
	struct ts_name_list list;
	bool wanted[NQUANTITIES];
	struct tsim *sim;
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	s->sim = sim;
	TS_TRY(ts_name_list_read(sim, "compute pair/gran/local", &self->arena, s->words, quantities,
				 sizeof *quantities, &s->list));
	for (int k = 0; k < NQUANTITIES; k++)
		s->wanted[k] = s->list.n == 0 && quantities[k].usual;
	for (size_t k = 0; k < s->list.n; k++)
		s->wanted[s->list.item[k]] = true;
	return TS_OK;
}

static size_t width_of(const struct tsim *sim, int k)
{
	return quantities[k].width ? quantities[k].width : sim->neigh->rows.history_width;
}

static bool wanted(const struct ts_instance *self, const struct tsim *sim, size_t r)
{
	return sim->neigh->rows.touching[r] && ts_contact_counts(sim, r, self->group);
}

static void write_row(const struct state *s, size_t r, double *out)
{
	struct ts_contact_view view;

	ts_contact_view(s->sim, r, &view);
	for (int k = 0; k < NQUANTITIES; k++) {
		if (!s->wanted[k])
			continue;
		quantities[k].write(s->sim, &view, out);
		out += width_of(s->sim, k);
	}
}

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct state *s = self->state;
	size_t columns = 0, n = 0;

	TS_TRY(ts_contacts_require(s->sim, self));
	for (int k = 0; k < NQUANTITIES; k++)
		columns += s->wanted[k] ? width_of(sim, k) : 0;
	for (size_t r = 0; r < sim->neigh->rows.n; r++)
		n += wanted(self, sim, r);
	TS_TRY(ts_table_resize(out, n, columns));
	n = 0;
	for (size_t r = 0; r < sim->neigh->rows.n; r++)
		if (wanted(self, sim, r))
			write_row(s, r, out->data + columns * n++);
	return TS_OK;
}

static const struct ts_value values[] = {
	{ "list", "", "a row for each contact", TS_LOCAL, 0, NULL, eval },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_REST_OPTIONAL("quantities", struct state, words,
			 .help = "pos, vel, id, force, force_normal, force_tangential, history, "
				 "contactArea, delta, contactPoint"),
	TS_ARGS_END,
};

TS_STYLE(compute, ts_style, ts_compute_pair_gran_local)
const struct ts_style ts_compute_pair_gran_local = {
	.name = "pair/gran/local",
	.kind = TS_KIND_COMPUTE,
	.summary = "What is known of each contact",
	.doc = "A table with a row for each contact whose partners are both in the group, and these columns, in "
	       "this\n"
	       "order whatever that of the words: pos, places of both (6); vel, velocities of both (6); id, "
	       "both ids, and\n"
	       "1 if they meet across a periodic face, else 0 (3); force on the first (3), its parts "
	       "force_normal (3) and\n"
	       "force_tangential (3); history, what the contact law remembers; contactArea, of the circle in "
	       "which the\n"
	       "spheres meet (1); delta, the overlap (1); contactPoint, which divides the line of centres as "
	       "the radii are\n"
	       "to each other (3). Without words: pos vel id force history contactArea. The partner with the "
	       "smaller id is\n"
	       "the first. Contacts are those of the last force computation, places and velocities those "
	       "of now.",
	.example = "compute c all pair/gran/local id pos force delta\n"
		   "dump d all local 100 post/contacts*.txt c_c[7] c_c[8] c_c[10] c_c[13]",
	.args = args,
	.state_size = sizeof(struct state),
	.values = values,
	.init = init,
};
