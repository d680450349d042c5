/* Sub-step contact detection (law/substep.h) as a stage of contacts in columns: after the normal force, and around the
 * tangential force. Contacts that begin or end in a step, usually few, are integrated together, in columns of their
 * own. The results are those of ts_substep_force for single contacts, bit for bit. */
#ifndef TS_CONTACT_SUBSTEP_STAGES_H
#define TS_CONTACT_SUBSTEP_STAGES_H

#include "contact/law_stages.h"

/* What a later stage needs to know. */
struct ts_substep_columns {
	double stage[TS_BATCH];			   /* enum ts_substep_stage, before the step */
	double before[TS_BATCH], around[TS_BATCH]; /* struct ts_substep */
	double slip[3][TS_BATCH];		   /* of the velocities of the last half step */
	double force[TS_BATCH], g[TS_BATCH];	   /* of ts_substep_of_contact */
	long long happens[TS_BATCH];		   /* enum ts_substep_case */
} __attribute__((aligned(64)));

/* Replaces the normal forces by those with detection, and the slip velocities by those of the time of the positions. */
void ts_substep_stage(struct ts_stages *s, size_t n, const struct ts_granular_model *m, double dt,
		      struct ts_substep_columns *l);

/* Stores the target slip velocities of the tangential forces. */
void ts_substep_stage_slip_targets(struct ts_stages *s, size_t n, const struct ts_granular_model *m,
				   double dt, const struct ts_substep_columns *l);

#endif
