#include "wall/surface.h"

#include "math/vec3.h"
#include "mesh/mesh_surface.h"
#include "voxel/voxel_surface.h"
#include "wall/primitive_wall.h"

#include "base/banned.h"

/* What surfaces of one sort have in common. `by`: the fix of the surface, after its init. */
struct ts_surface_kind {
	const char *family;
	bool (*is)(const struct ts_instance *by); /* NULL: all of the family are surfaces */
	size_t (*elements)(const struct ts_instance *by);
	double (*area)(const struct ts_instance *by, const struct tsim *sim, size_t element);
	void (*centre)(const struct ts_instance *by, const struct tsim *sim, size_t element, double out[3]);
	int (*type)(const struct ts_instance *by);
};

/* ---- meshes ---- */

static size_t count_triangles(const struct ts_instance *by)
{
	return ((const struct ts_mesh_surface *)by->state)->mesh.n;
}

static double triangle_area(const struct ts_instance *by, const struct tsim *sim, size_t element)
{
	(void)sim;
	return ((const struct ts_mesh_surface *)by->state)->mesh.area[element];
}

static void triangle_centre(const struct ts_instance *by, const struct tsim *sim, size_t element,
			    double out[3])
{
	(void)sim;
	ts_scale(1, ((const struct ts_mesh_surface *)by->state)->mesh.centre[element], out);
}

static int mesh_type(const struct ts_instance *by)
{
	return (int)((const struct ts_mesh_surface *)by->state)->type;
}

/* ---- height fields ---- */

static const struct ts_voxel_surface *field_of(const struct ts_instance *by)
{
	return by->state;
}

static size_t count_columns(const struct ts_instance *by)
{
	return (size_t)(field_of(by)->field.n[0] * field_of(by)->field.n[1]);
}

static double column_area(const struct ts_instance *by, const struct tsim *sim, size_t element)
{
	(void)sim;
	(void)element;
	return field_of(by)->field.width[0] * field_of(by)->field.width[1];
}

static void column_centre(const struct ts_instance *by, const struct tsim *sim, size_t element, double out[3])
{
	const struct ts_voxel_surface *s = field_of(by);
	const struct ts_voxel_field *f = &s->field;
	int64_t index[2] = { (int64_t)element % f->n[0], (int64_t)element / f->n[0] };

	(void)sim;
	for (int d = 0; d < 2; d++)
		out[f->axis[d]] = f->origin[d] + ((double)index[d] + 0.5) * f->width[d];
	out[f->axis[2]] = ts_voxel_heights(f)[element];
	ts_add(out, s->shift, out);
}

static int field_type(const struct ts_instance *by)
{
	return (int)field_of(by)->type;
}

/* ---- primitive walls ---- */

static const struct ts_primitive_wall *primitive_of(const struct ts_instance *by)
{
	return ((const struct ts_wall *)by->state)->primitive;
}

static bool is_primitive(const struct ts_instance *by)
{
	return primitive_of(by) != NULL;
}

static size_t count_primitives(const struct ts_instance *by)
{
	return (size_t)primitive_of(by)->n;
}

static double primitive_area(const struct ts_instance *by, const struct tsim *sim, size_t element)
{
	return ts_primitive_wall_area(primitive_of(by), sim, (int)element);
}

static void primitive_centre(const struct ts_instance *by, const struct tsim *sim, size_t element,
			     double out[3])
{
	ts_primitive_wall_centre(primitive_of(by), sim, (int)element, out);
}

static int primitive_type(const struct ts_instance *by)
{
	return ((const struct ts_wall *)by->state)->type;
}

static const struct ts_surface_kind kinds[] = {
	{ TS_FAMILY_MESH, NULL, count_triangles, triangle_area, triangle_centre, mesh_type },
	{ TS_FAMILY_VOXEL, NULL, count_columns, column_area, column_centre, field_type },
	{ TS_FAMILY_WALL, is_primitive, count_primitives, primitive_area, primitive_centre, primitive_type },
};
enum { KINDS = sizeof kinds / sizeof *kinds };

static const struct ts_surface_kind *kind_of(const struct ts_instance *by)
{
	for (int k = 0; k < KINDS; k++)
		if (by->style->family && ts_streq(by->style->family, kinds[k].family) &&
		    (!kinds[k].is || kinds[k].is(by)))
			return &kinds[k];
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
	return ts_fail(&sim->error, TS_UNKNOWN, &id->place,
		       "there is no surface '%s': expected the ID of a fix mesh/surface, a fix "
		       "surface/voxel, or "
		       "a fix wall/gran with a plane or cylinder%s",
		       id->text, ts_suggest_text(&suggest));
}

/* Walls of meshes have several surfaces: which one? */
static enum ts_status not_a_surface(struct tsim *sim, const struct ts_word *id, const struct ts_instance *fix)
{
	const struct ts_wall *w = fix->state;
	const bool wall = fix->style->family && ts_streq(fix->style->family, TS_FAMILY_WALL);

	if (wall && w->surfaces)
		return ts_fail(&sim->error, TS_STATE, &id->place,
			       "fix %s is a wall made of %s; name one of them: '%s'%s", id->text,
			       w->voxel ? "a height field" : "meshes", w->surfaces->fix(w, 0)->id,
			       w->surfaces->count(w) > 1 ? ", ..." : "");
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
	out->kind = kind_of(out->by);
	return out->kind ? TS_OK : not_a_surface(sim, id, out->by);
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

unsigned ts_surface_observers(const struct tsim *sim, const struct ts_instance *by)
{
	return observers_of_kind(sim, TS_KIND_FIX, by) | observers_of_kind(sim, TS_KIND_COMPUTE, by);
}
