#include "wall/surface.h"

#include "wall/wall.h"
#include "wall/wall_shapes.h"

#include "base/banned.h"

/* The wall of this fix; NULL: it is another fix. */
static const struct ts_wall *wall_of(const struct ts_instance *by)
{
	return by->style->family && ts_streq(by->style->family, TS_FAMILY_WALL) ? by->state : NULL;
}

/* A wall is a surface itself if its shape says so. */
static const struct ts_surface_kind *kind_of(const struct ts_instance *by)
{
	const struct ts_wall *w = wall_of(by);

	for (size_t k = 0; by->style->family && ts_wall_shapes[k]; k++) {
		const struct ts_wall_shape *shape = ts_wall_shapes[k];

		if (shape->surface.family && ts_streq(by->style->family, shape->surface.family) &&
		    (!w || w->shape == shape))
			return &shape->surface;
	}
	return NULL;
}

/* ---- by name ---- */

static enum ts_status unknown_surface(struct tsim *sim, const struct ts_word *id)
{
	const struct ts_instances *fixes = &sim->instances[TS_KIND_FIX];
	struct ts_suggest suggest = ts_suggest_start(id->text);

	for (size_t k = 0; k < fixes->n; k++)
		if (kind_of(fixes->item[k]))
			ts_suggest_try(&suggest, fixes->item[k]->id);
	return ts_missing(&sim->error, "fix", id->text, &id->place,
			  "there is no surface '%s': expected the ID of a fix mesh/surface, a fix "
			  "surface/voxel, or a fix wall/gran with a plane or cylinder%s",
			  id->text, ts_suggest_text(&suggest));
}

/* Walls of meshes have several surfaces: which one? */
static enum ts_status not_a_surface(struct tsim *sim, const struct ts_word *id, const struct ts_instance *fix)
{
	const struct ts_wall *w = wall_of(fix);

	if (w && ts_wall_meshes(w))
		return ts_fail(&sim->error, TS_STATE, &id->place,
			       "fix %s is a wall made of %s; name one of them: '%s'%s", id->text,
			       w->shape->made_of, ts_wall_surface(w, 0)->id,
			       ts_wall_surfaces(w) > 1 ? ", ..." : "");
	return ts_fail(&sim->error, TS_STATE, &id->place,
		       "fix %s, of style %s, has no elements: expected the ID of a fix mesh/surface, a fix "
		       "surface/voxel, or a fix wall/gran with a plane or cylinder",
		       id->text, fix->style->name);
}

enum ts_status ts_surface_require(struct tsim *sim, const struct ts_word *id, struct ts_surface *out)
{
	out->by = ts_sim_find(sim, TS_KIND_FIX, id->text);
	if (!out->by)
		return unknown_surface(sim, id);
	out->sim = sim;
	out->removals = sim->removals;
	out->kind = kind_of(out->by);
	return out->kind ? TS_OK : not_a_surface(sim, id, out->by);
}

enum ts_status ts_surface_find_again(struct ts_surface *s, const char *id, const struct ts_place *where,
				     size_t elements)
{
	const struct ts_word word = { .text = id, .place = *where };
	struct tsim *sim = s->sim;

	if (sim->run.inside || s->removals == sim->removals)
		return TS_OK;
	TS_TRY(ts_surface_require(sim, &word, s));
	if (ts_surface_elements(s) == elements)
		return TS_OK;
	return ts_fail(&sim->error, TS_STATE, where,
		       "fix %s has been defined anew, with another number of elements: `run 0` finds them",
		       id);
}

/* ---- elements ---- */

size_t ts_surface_elements(const struct ts_surface *s)
{
	return s->kind->elements(s->by);
}

double ts_surface_area(const struct ts_surface *s, const struct tsim *sim, size_t element)
{
	return s->kind->area(s->by, sim, element);
}

void ts_surface_centre(const struct ts_surface *s, const struct tsim *sim, size_t element, double out[3])
{
	s->kind->centre(s->by, sim, element, out);
}

int ts_surface_type(const struct ts_surface *s)
{
	return s->kind->type(s->by);
}

double ts_surface_temperature(const struct ts_surface *s)
{
	return s->kind->temperature(s->by);
}

/* ---- recession ---- */

enum ts_status ts_surface_check_recession(struct tsim *sim, const struct ts_surface *s,
					  const struct ts_recession *how, const struct ts_place *where)
{
	return s->kind->check_recession(sim, s->by, how, where);
}

enum ts_status ts_surface_recede(struct tsim *sim, const struct ts_surface *s, const struct ts_recession *how,
				 const struct ts_place *where, struct ts_recession_element *e, size_t n)
{
	return s->kind->recede(sim, s->by, how, where, e, n);
}

bool ts_surface_is_back(const struct ts_surface *s, size_t element, const double normal[3])
{
	return s->kind->is_back && s->kind->is_back(s->by, element, normal);
}

/* ---- observers ---- */

static unsigned observers_of_kind(const struct tsim *sim, enum ts_kind kind, const struct ts_instance *by)
{
	const struct ts_instances *list = &sim->instances[kind];
	unsigned bits = 0;

	for (size_t k = 0; k < list->n; k++) {
		const struct ts_style *style = list->item[k]->style;

		if (style->observes && style->surface(list->item[k]) == by)
			bits |= style->observes;
	}
	return bits;
}

static const struct ts_instance *observer_of_kind(const struct tsim *sim, enum ts_kind kind,
						  const struct ts_instance *by, unsigned bit, unsigned lacks)
{
	const struct ts_instances *list = &sim->instances[kind];

	for (size_t k = 0; k < list->n; k++) {
		const struct ts_style *style = list->item[k]->style;

		if (style->observes & bit && !(style->observes & lacks) &&
		    style->surface(list->item[k]) == by)
			return list->item[k];
	}
	return NULL;
}

const struct ts_instance *ts_surface_observer(const struct tsim *sim, const struct ts_instance *by,
					      unsigned bit, unsigned lacks)
{
	const struct ts_instance *found = observer_of_kind(sim, TS_KIND_FIX, by, bit, lacks);

	return found ? found : observer_of_kind(sim, TS_KIND_COMPUTE, by, bit, lacks);
}

unsigned ts_surface_observers(const struct tsim *sim, const struct ts_instance *by)
{
	return observers_of_kind(sim, TS_KIND_FIX, by) | observers_of_kind(sim, TS_KIND_COMPUTE, by);
}
