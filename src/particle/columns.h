/* Storage of the particles' columns: rows are added, deleted and reordered; columns are made active or
 * added by styles. */
#ifndef TS_PARTICLE_COLUMNS_H
#define TS_PARTICLE_COLUMNS_H

#include "particle/particles.h"

/* Adds n particles with new consecutive tags after the local ones and drops the ghosts; *first is the
 * index of the first new one. They are in group all with v = 0, radius 0.5 and the mass of density 1; all
 * other numbers are 0 or the column's initial value. The caller sets what differs. */
enum ts_status ts_particles_add(struct tsim *sim, size_t n, size_t *first);
/* The same for n of `all` new ones, which other ranks make too: the caller gives these n rows their identities, of those from
 * max_tag - all + 1 to max_tag, which are used up. */
enum ts_status ts_particles_add_some(struct tsim *sim, size_t n, size_t all, size_t *first);
/* Deletes the local particles with flag[i] != 0 and drops the ghosts; the order of the others is kept. */
enum ts_status ts_particles_delete(struct tsim *sim, const unsigned char *flag);
/* Reorders the local particles and drops the ghosts: new index k is the old index order[k]. */
enum ts_status ts_particles_reorder(struct tsim *sim, const int32_t *order);
/* Allocates all active columns for at least this number of rows, ghosts included. */
enum ts_status ts_particles_reserve(struct tsim *sim, size_t rows);
/* Makes room for n ghosts. */
enum ts_status ts_particles_reserve_ghosts(struct tsim *sim, size_t n);

/* Activates built-in columns, filled with zeros; `columns` has the bits 1 << enum ts_column_id. */
enum ts_status ts_particles_need(struct tsim *sim, unsigned columns);
/* Whether the instance that has added the column is gone: its numbers have no meaning. */
bool ts_particles_column_orphaned(const struct tsim *sim, const struct ts_column *c);
/* Adds a column of `width` doubles per particle for a style, e.g. "f_heat", or finds it; *index is its
 * index in particles->column. */
enum ts_status ts_particles_add_column(struct tsim *sim, const char *name, size_t width, unsigned flags,
				       size_t *index);
/* Sets the `width` initial values of the column for particles that are added from now on. */
enum ts_status ts_particles_column_initial(struct tsim *sim, size_t index, const double *initial);
/* Writes the initial values, if there are some, to the rows from <= i < to. */
void ts_particles_fill_initial(struct ts_column *column, size_t from, size_t to);
/* For the archive function of a style: saves or restores the column that it added. Values are saved with
 * the tags of their particles, because the style may be defined again after particles were added or deleted
 * since the restart. Such columns are not TS_COL_SAVED. */
enum ts_status ts_particles_archive_column(struct ts_archive *archive, struct tsim *sim, const char *name,
					   size_t index);

/* Sets imass = 1/mass for all local particles; fix freeze then sets that of its particles to 0. */
void ts_particles_inverse_mass(struct ts_particles *p);

/* Whether particles may be members of bodies: the same on all ranks, while p->body is NULL on one that has had no particles. */
static inline bool ts_columns_have_bodies(const struct ts_particles *p)
{
	return p->column[TS_COL_BODY].active;
}

#endif
