/* Compute: contacts with walls in the columns of LIGGGHTS. */
#include "base/alloc.h"
#include "base/sort.h"
#include "contact/contact_columns.h"
#include "particle/particles.h"
#include "wall/wall.h"

#include <math.h>

#include "base/banned.h"

struct state {
	struct ts_contact_columns columns;
	bool primitives;
	struct tsim *sim;
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	const struct ts_wall *w;
	bool any = false;

	s->sim = sim;
	for (size_t k = 0; (w = ts_walls_next(sim, &k, NULL));)
		any |= ts_wall_meshes(w) > 0 || s->primitives;
	if (!any)
		return ts_conflict(&sim->error, &self->where,
				   "compute wall/gran/local needs a fix wall/gran before it, %s",
				   s->primitives
					   ? "and there is none"
					   : "with a mesh; `primitives yes` lists planes and cylinders, too");
	ts_walls_want_reports(sim);
	TS_TRY(ts_contact_columns_init(self, sim));
	if (s->columns.wanted[TS_CONTACT_HEAT] && !ts_heat_of(sim))
		return ts_fail(&sim->error, TS_STATE, ts_instance_word(self, "heatFlux"),
			       "compute wall/gran/local: no heat flows without a fix heat/gran");
	return TS_OK;
}

/* Into the particle, at its present temperature, as in compute pair/gran/local. */
static double heat_of_contact(const struct tsim *sim, const struct ts_wall_report *r, size_t i)
{
	const struct ts_heat *heat = ts_heat_of(sim);

	return heat && heat->ready && r->conductance > 0
		       ? r->conductance * (r->temperature - ts_heat_column(sim, heat->temperature)[i])
		       : 0;
}

/* Fills in the data of contact k of a wall. `meshes_before`: number of meshes of the walls before it. */
static void contact_facts(const struct tsim *sim, const struct ts_wall *w, size_t k, int meshes_before,
			  struct ts_contact_facts *f)
{
	const struct ts_particles *p = sim->particles;
	const struct ts_wall_report *r = &w->contacts.report[k];
	size_t i = (size_t)w->contacts.row[k];
	double distance = p->radius[i] - r->overlap;

	*f = (struct ts_contact_facts){
		.id = { r->mesh > 0 ? meshes_before + r->mesh - 1 : -1, r->triangle, p->tag[i] },
		.delta = r->overlap,
		.area = ts_contact_area_plane(p->radius[i], distance),
	};
	for (int d = 0; d < 3; d++) {
		f->pos[d] = f->point[d] = r->point[d];
		f->pos[3 + d] = p->x[i][d];
		f->vel[d] = r->velocity[d];
		f->vel[3 + d] = p->v[i][d];
		f->force[d] = r->force[d];
		f->torque[d] = r->torque[d];
		f->n[d] = distance > 0 ? (p->x[i][d] - r->point[d]) / distance : 0;
	}
	f->heat = heat_of_contact(sim, r, i);
	for (size_t m = 0; m < ts_wall_history(w, sim); m++)
		f->history[m] = ts_wall_memory(&w->contacts, k)[m];
	if (sim->legacy == TS_LEGACY_LIGGGHTS)
		ts_wall_force_now(w, sim, k, f->force, f->torque);
}

static bool is_listed(const struct ts_instance *self, const struct ts_wall *w, size_t k)
{
	const struct state *s = self->state;
	const struct ts_wall_report *r = ts_wall_report(&w->contacts, k);
	size_t i = (size_t)w->contacts.row[k];

	return r && i < s->sim->particles->n && ts_in_group(s->sim->particles, i, self->group) &&
	       (r->mesh > 0 || s->primitives);
}

struct listed {
	const struct ts_wall *wall;
	int meshes_before;
	int32_t tag;
	size_t k;
};

/* By identities of particles, and the order of the contacts of a particle: so it does not depend on how particles lie in
 * memory. */
static int by_identity(const void *one, const void *other)
{
	const struct listed *a = one, *b = other;

	if (a->tag != b->tag)
		return a->tag < b->tag ? -1 : 1;
	return a->k < b->k ? -1 : a->k > b->k;
}

/* In the order of walls and by_identity. Returns the number of contacts; list NULL: only counts. */
static size_t list_contacts(const struct ts_instance *self, struct listed *list)
{
	const struct state *s = self->state;
	const struct ts_wall *w;
	int meshes_before = 0;
	size_t n = 0;

	for (size_t at = 0; (w = ts_walls_next(s->sim, &at, NULL));) {
		const size_t first = n;

		for (size_t k = 0; k < w->contacts.n; k++) {
			if (!is_listed(self, w, k))
				continue;
			if (list)
				list[n] = (struct listed){ w, meshes_before,
							   s->sim->particles->tag[w->contacts.row[k]], k };
			n++;
		}
		if (list)
			ts_sort(list + first, n - first, sizeof *list, by_identity);
		meshes_before += (int)ts_wall_meshes(w);
	}
	return n;
}

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct state *s = self->state;
	const struct ts_wall *w;
	struct listed *list;
	size_t history = 0, width, n;
	enum ts_status status;

	for (size_t at = 0; (w = ts_walls_next(sim, &at, NULL));) {
		size_t own = ts_wall_history(w, sim);

		history = own > history ? own : history;
	}
	TS_TRY(ts_walls_connect(s->sim));
	n = list_contacts(self, NULL);
	width = ts_contact_columns_width(&s->columns, history);
	list = ts_alloc(n, sizeof *list);
	status = list ? ts_table_resize(out, n, width) : ts_nomem(&s->sim->error);
	if (status == TS_OK)
		list_contacts(self, list);
	for (size_t r = 0; r < n && status == TS_OK; r++) {
		struct ts_contact_facts facts;

		contact_facts(sim, list[r].wall, list[r].k, list[r].meshes_before, &facts);
		ts_contact_columns_write(&s->columns, history, &facts, out->data + width * r);
	}
	ts_free(list);
	return status;
}

static const struct ts_value values[] = {
	{ "list", "", "one row for each contact", TS_LOCAL, 0, NULL, eval },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	{ .name = "quantities",
	  .type = TS_ARG_REST,
	  .flags = TS_POSITIONAL | TS_OPTIONAL | TS_TO_KEYWORD,
	  .offset = TS_FIELD(struct state, columns.words, struct ts_words *),
	  .help = ts_contact_columns_help },
	TS_BOOL("primitives", struct state, primitives, .fallback = "no",
		.help = "whether contacts with planes and cylinders are listed, too"),
	TS_ARGS_END,
};

TS_STYLE(compute, ts_style, ts_compute_wall_gran_local)
const struct ts_style ts_compute_wall_gran_local = {
	.name = "wall/gran/local",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE,
	.summary = "Data of each contact of a particle with a wall",
	.doc = "A table with one row for each contact of a particle of the group with a triangle of a mesh, "
	       "as compute pair/gran/local gives for contacts of particles. Whatever the order of the "
	       "keywords, the columns are in this order:\n\n"
	       "  pos                contact point and position of the particle (6)\n"
	       "  vel                velocity of the surface at the contact point and of the particle (6)\n"
	       "  id                 number of the mesh, from 0, number of the triangle, from 0, id of the "
	       "particle (3)\n"
	       "  force              force on the particle (3)\n"
	       "  force_normal       normal part of the force (3)\n"
	       "  force_tangential   tangential part of the force (3)\n"
	       "  torque             torque on the particle, with that of rolling friction (3)\n"
	       "  history            history of the contact law\n"
	       "  contactArea        area of the circle in which sphere and plane intersect (1)\n"
	       "  delta              overlap (1)\n"
	       "  contactPoint       contact point on the surface (3)\n"
	       "  heatFlux           heat conducted into the particle, energy/time (1); needs a fix "
	       "heat/gran\n\n"
	       "Meshes are numbered in the order in which fixes wall/gran name them. Without keywords: pos "
	       "vel id force history contactArea.\n\n"
	       "With `primitives yes` contacts with planes and cylinders are listed, too; their mesh is -1. "
	       "Contacts and forces are those of the last force computation, or with `legacy` as LIGGGHTS "
	       "computes them, see compute pair/gran/local. LIGGGHTS gives contactPoint as 0.\n\n"
	       "Related: fix wall/gran, compute pair/gran/local, dump local.",
	.example = "compute hits all wall/gran/local id pos force\n"
		   "dump hits all local/gran/vtk 1000 post/hits*.vtp hits",
	.args = args,
	.family = TS_FAMILY_CONTACTS,
	.state_size = sizeof(struct state),
	.values = values,
	.width = ts_contact_columns_known_width,
	.init = init,
};
