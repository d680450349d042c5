/* The component of a mixture whose distribution the computes mixing... measure: particles of some types, of a group,
 * or with a value above a limit. All other particles of the compute's group are the other component. */
#ifndef TS_BED_COMPONENT_H
#define TS_BED_COMPONENT_H

#include "core/ref_list.h"
#include "core/sim.h"

enum ts_component_kind { TS_COMPONENT_TYPE, TS_COMPONENT_GROUP, TS_COMPONENT_ABOVE };

/* First member of the state of a style, whose table of arguments has TS_COMPONENT_ROW. */
struct ts_component {
	int kind;
	struct ts_types types;
	int group;
	const char *name; /* TS_COMPONENT_ABOVE: the value, as written */
	double limit;
	struct ts_ref_input value;
	struct ts_table table; /* of `value`, reused */
	struct tsim *sim;
};
extern const struct ts_mode ts_component_modes[];
#define TS_COMPONENT_ROW(T)                                         \
	TS_MODE("component", T, component.kind, ts_component_modes, \
		.help = "which particles are the component; all others of the group are the rest")

/* In init of the style. */
enum ts_status ts_component_init(struct ts_instance *self, struct tsim *sim);
void ts_component_fini(struct ts_instance *self);

/* Prepares ts_component_has for the particles as they are now. */
enum ts_status ts_component_update(struct ts_instance *self);
/* Whether particle i belongs to the component. */
bool ts_component_has(const struct ts_component *c, size_t i);

#endif
