/* Wear of a surface by the particles that hit it or slide on it: what all fixes wear/LAW have in common.
 *
 * A law is a table of two functions, numbers in, volume out. The machine calls `impact` once for each impact that has
 * ended (impact/impacts.h), `slide` for each touching contact in each step (wall/surface_contacts.h; of an impact that is
 * computed as a whole, for each node of a quadrature over its time), and sums for each
 * element what they give, beside speeds, angles and energies (wall/surface_rows.h).
 *
 * A style of a law begins its state with a struct ts_wear, its arguments with TS_WEAR_ARGS, and its table has
 *
 *	TS_WEAR_SLOTS, .observes = TS_OBSERVES_IMPACTS (a law with `slide`: | TS_OBSERVES_CONTACTS |
 *	TS_OBSERVES_BRIEF),
 *	.init: calls ts_wear_init, then checks its own arguments,
 *	.late = { [TS_LATE_CONTACTS] = ts_wear_step }, .fini = ts_wear_fini, or functions that call these */
#ifndef TS_WEAR_WEAR_H
#define TS_WEAR_WEAR_H

#include "impact/impact_event.h"
#include "wall/surface_rows.h"
#include "wear/evolution.h"

/* A touching contact in one step, or a part of an impact that is computed as a whole (wall/surface_contacts.h). */
struct ts_wear_slide {
	size_t element;	     /* of the surface */
	double type;	     /* of the particle */
	double mass, radius; /* of the particle */
	double normal_force; /* >= 0 */
	double slip;	     /* path of the contact point along the surface in this step, length */
	double work;	     /* of friction on it, energy */
	double normal[3];    /* unit vector, towards the particle */
	double velocity[3];  /* of the particle's centre relative to the surface */
};

/* Either function may be NULL. */
struct ts_wear_law {
	/* Volume that an impact removes, length^3. */
	double (*impact)(const struct ts_instance *self, const struct ts_impact_event *e);
	/* Volume that a touching contact removes in a step, length^3. */
	double (*slide)(const struct ts_instance *self, const struct ts_wear_slide *s);
};

/* Sums of one element; all numbers of type double, for restart files. */
struct ts_wear_sums {
	double hits, mass;   /* number of impacts, mass of the particles */
	double speed, angle; /* sums over impacts, angle in degrees */
	double energy, work, impulse;
	double force; /* maximum */
	double volume;
};
enum { TS_WEAR_SUMS = sizeof(struct ts_wear_sums) / sizeof(double) };

#define TS_FAMILY_WEAR "wear"

/* First member of the state of every style of TS_FAMILY_WEAR. */
struct ts_wear {
	/* arguments */
	const char *surface_id;
	double density; /* of the surface; NaN: not given */
	struct ts_evolution evolution;

	const struct ts_wear_law *law;
	struct ts_surface surface;
	struct ts_surface_rows rows; /* struct ts_wear_sums */
};

static inline const struct ts_wear_sums *ts_wear_sums(const struct ts_wear *w, size_t row)
{
	return (const struct ts_wear_sums *)(w->rows.data + row * TS_WEAR_SUMS);
}

#define TS_WEAR_SURFACE_ARG(T, f)                                                                       \
	TS_WORD("surface", T, f.surface_id, .flags = TS_STATEFUL,                                       \
		.help = "ID of a fix mesh/surface, of a fix surface/voxel, or of a fix wall/gran with " \
			"planes or a cylinder")
#define TS_WEAR_ARGS(T, f)                                                                        \
	TS_WEAR_SURFACE_ARG(T, f),                                                                \
		TS_REAL("density", T, f.density, .flags = TS_OPTIONAL, .range = TS_POSITIVE,      \
			.unit = "mass/length^3", .help = "of the surface, for the mass removed"), \
		TS_EVOLUTION_ARGS(T, f.evolution)

/* In the init of a style with TS_WEAR_ARGS: finds the surface, checks whether it can recede. */
enum ts_status ts_wear_init(struct ts_instance *self, struct tsim *sim, const struct ts_wear_law *law);
/* In the init of a style with TS_WEAR_SURFACE_ARG alone. */
enum ts_status ts_wear_find_surface(struct ts_instance *self, struct tsim *sim,
				    const struct ts_wear_law *law);

/* Slots. */
enum ts_status ts_wear_step(struct ts_instance *self, struct tsim *sim);
/* Warns if no wall is made of the surface. */
enum ts_status ts_wear_plan(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report);
const struct ts_instance *ts_wear_surface(const struct ts_instance *self);
enum ts_status ts_wear_archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *archive);
void ts_wear_fini(struct ts_instance *self);
/* Outputs: f_ID the volume, f_ID[1..12] the totals, f_ID[1..13] of each element. */
extern const struct ts_value ts_wear_values[];
/* Of a style without a law, the same without volumes: f_ID the number of impacts, f_ID[1..4] the totals, f_ID[1..10]
 * of each element. */
extern const struct ts_value ts_wear_impact_values[];
/* Manual: surfaces that evolve. */
extern const char *const ts_wear_doc_more[];
#define TS_WEAR_SLOTS                                                                                     \
	.ranks = TS_RANKS_OWN | TS_RANKS_OUTPUTS, .family = TS_FAMILY_WEAR, .doc_more = ts_wear_doc_more, \
	.surface = ts_wear_surface, .values = ts_wear_values, .archive = ts_wear_archive,                 \
	.plan = ts_wear_plan

/* In the manual of laws with `slide`. */
#define TS_WEAR_EXACT                                                                                     \
	"With `impact exact` of fix wall/gran, force times path is integrated over the whole impact; it " \
	"belongs "                                                                                        \
	"to the element that is touched first."

/* In the manual of each style: what an impact is. */
#define TS_WEAR_IMPACT_DOC                                                                                   \
	"\n\nAn impact lasts from the first to the last step in which a particle touches any element of "    \
	"the "                                                                                               \
	"surface. Its speed and angle are those of the free flight before the first contact force, "         \
	"relative "                                                                                          \
	"to the surface at the contact point; the angle is that between velocity and surface, 90 degrees "   \
	"for a normal impact. An impact belongs to the element that is touched first, of several touched "   \
	"in "                                                                                                \
	"the same step to that with the largest overlap. It is counted when it has ended: when the "         \
	"particle "                                                                                          \
	"has separated, or has been deleted or left the box in a run. Particles that touch the surface "     \
	"when "                                                                                              \
	"the first run begins make an impact only after they have left it. Two walls made of the same mesh " \
	"have impacts of their own. "
#define TS_WEAR_ELEMENTS_DOC                                                                             \
	"The elements of a mesh are its triangles, those of a height field its columns, those of a "     \
	"primitive wall its planes or cylinders, whose area is that within the box (of a cylinder of "   \
	"which no part is: all). dump mesh/vtk (of meshes), dump voxel/vtk (of height fields), dump "    \
	"local, compute reduce and formulas read values of each element. Sums over elements are exact, " \
	"as those of compute reduce. Elements without impacts have zeros. "
/* The end of the manual of each law. */
#define TS_WEAR_DOC                                                                                      \
	TS_WEAR_IMPACT_DOC                                                                               \
	"Only particles of the group wear the surface. The equations of all laws typeset: "              \
	"doc/theory-wear.md.\n\n" TS_WEAR_ELEMENTS_DOC                                                   \
	"f_ID[1..13] are those of each element, f_ID is the volume removed from the whole surface, and " \
	"f_ID[1..12] are its totals elsewhere.\n\n"

#endif
