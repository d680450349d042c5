#include "particle/particles.h"

#include "box/domain.h"
#include "core/fingerprint.h"
#include "core/ranks.h"
#include "core/report.h"
#include "geom/box.h"
#include "material/property.h"
#include "particle/columns.h"
#include "particle/crowd.h"
#include "particle/division.h"
#include "particle/quantity.h"

#include "base/banned.h"

/* Type of a column's numbers in restart files, by their C type. */
#define SAVED_TYPE(type) \
	_Generic((type)0, double : TS_SAVED_F64, int32_t : TS_SAVED_I32, uint32_t : TS_SAVED_I32)

static enum ts_status describe_columns(struct tsim *sim, struct ts_particles *p)
{
#define COLUMN_ROW(id, name_, ctype, width_, flags_) \
	{ .name = #name_,                            \
	  .type = SAVED_TYPE(ctype),                 \
	  .element = sizeof(ctype),                  \
	  .width = (width_),                         \
	  .flags = (flags_),                         \
	  .bound = (void **)(void *)&p->name_ },
	const struct ts_column builtin[] = { TS_COLUMN_LIST(COLUMN_ROW) };
#undef COLUMN_ROW

	if (TS_GROW(p->column, p->column_capacity, TS_NCOLUMN_BUILTIN) != TS_OK)
		return ts_nomem(&sim->error);
	for (size_t k = 0; k < TS_NCOLUMN_BUILTIN; k++)
		p->column[k] = builtin[k];
	p->ncolumns = TS_NCOLUMN_BUILTIN;
	return TS_OK;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct ts_particles *p = self->state;

	if (!p->ncolumns) {
		TS_TRY(describe_columns(sim, p));
		p->lost_policy = TS_LOST_WARN;
		sim->generation++;
		p->holds = &sim->holds;
		sim->materials = &p->materials;
	}
	if (sim->full & TS_FULL_COLUMNS)
		return ts_particles_need(sim, (1u << TS_NCOLUMN_BUILTIN) - 1);
	return ts_particles_need(sim, sim->columns);
}

enum ts_status ts_particles_require_types(struct tsim *sim, const char *who, const struct ts_types *types,
					  const struct ts_place *where)
{
	int most = sim->particles->ntypes;

	if (types->lo <= most && types->hi <= most)
		return TS_OK;
	return ts_fail(&sim->error, TS_RANGE, where,
		       "%s: particle type %d does not exist, create_box made %d", who,
		       types->hi > most ? types->hi : types->lo, most);
}

enum ts_status ts_particles_make_box(struct tsim *sim, int ntypes, const double lo[3], const double hi[3],
				     const struct ts_place *where)
{
	struct ts_particles *p = sim->particles;
	double *type_mass = ts_alloc((size_t)ntypes + 1, sizeof *type_mass);
	enum ts_status status;

	if (!type_mass)
		return ts_nomem(&sim->error);
	status = ts_domain_set_box(sim, lo, hi, where);
	if (status != TS_OK) {
		ts_free(type_mass);
		return status;
	}
	ts_free(p->type_mass);
	p->type_mass = type_mass;
	p->ntypes = ntypes;
	return TS_OK;
}

static void fini(struct ts_instance *self)
{
	struct ts_particles *p = self->state;

	for (size_t k = 0; k < p->ncolumns; k++) {
		ts_shared_buffer_free(p->holds, p->column[k].data);
		ts_free(p->column[k].initial);
	}
	ts_free(p->column);
	ts_free(p->type_mass);
	ts_materials_release(&p->materials);
	ts_division_free(p->division);
	ts_free(p->ghost_owner);
	ts_free(p->ghost_shift);
	ts_free(p->row_of_tag);
	ts_free(p->sorted_tags);
}

static enum ts_status archive_groups(struct tsim *sim, struct ts_archive *a)
{
	for (int g = 1; g < TS_MAX_GROUPS; g++) {
		char name[24];
		const char *text = sim->groups.name[g] ? sim->groups.name[g] : "";

		snprintf(name, sizeof name, "group%d", g);
		TS_TRY(ts_archive_string(a, name, &text));
		sim->groups.name[g] = *text ? text : NULL;
	}
	return TS_OK;
}

static enum ts_status archive_dynamic_groups(struct tsim *sim, struct ts_particles *p, struct ts_archive *a)
{
	for (int bit = 1; bit < TS_MAX_GROUPS; bit++) {
		struct ts_dynamic_group *g = &p->dynamic[bit];
		const char *region = g->region ? g->region : "";
		const char *variable = g->variable ? g->variable : "";
		int64_t numbers[2] = { g->every, g->parent };
		char name[40];

		snprintf(name, sizeof name, "dynamic%d", bit);
		if (!ts_archive_has(a, name) || (ts_archive_writing(a) && !g->every))
			continue;
		TS_TRY(ts_archive_fixed(a, name, TS_SAVED_I64, numbers, 2));
		snprintf(name, sizeof name, "dynamic%d_region", bit);
		TS_TRY(ts_archive_string(a, name, &region));
		snprintf(name, sizeof name, "dynamic%d_variable", bit);
		TS_TRY(ts_archive_string(a, name, &variable));
		if (numbers[0] < 1 || numbers[1] < 0 || numbers[1] >= TS_MAX_GROUPS)
			return ts_fail(&sim->error, TS_DAMAGED, NULL, "impossible dynamic group");
		*g = (struct ts_dynamic_group){ .every = numbers[0],
						.parent = (int)numbers[1],
						.region = *region ? region : NULL,
						.variable = *variable ? variable : NULL };
	}
	return TS_OK;
}

static enum ts_status archive_columns(struct tsim *sim, struct ts_particles *p, struct ts_archive *a)
{
	for (size_t k = 0; k < p->ncolumns; k++) {
		struct ts_column *c = &p->column[k];

		if (!(c->flags & TS_COL_SAVED) || (ts_archive_writing(a) && !c->active))
			continue;
		if (!ts_archive_has(a, c->name))
			continue;
		if (k < TS_NCOLUMN_BUILTIN)
			TS_TRY(ts_particles_need(sim, 1u << k));
		TS_TRY(ts_archive_fixed(a, c->name, c->type, c->data, p->n * c->width));
	}
	return TS_OK;
}

/* Checks a restored state for what all other code assumes: finite numbers, radius and mass > 0, known types
 * and tags. */
static enum ts_status check_particles(struct tsim *sim, const struct ts_particles *p)
{
	for (size_t i = 0; i < p->n; i++) {
		double sum = p->radius[i] + p->mass[i];
		bool far = false;

		for (int d = 0; d < 3; d++) {
			sum += p->x[i][d] + p->v[i][d];
			far |= p->image[i][d] < -TS_TURNS_MOST || p->image[i][d] > TS_TURNS_MOST;
		}
		if (far || p->type[i] < 1 || p->type[i] > p->ntypes || p->tag[i] < 1 ||
		    p->tag[i] > p->max_tag || !(p->radius[i] > 0) || !(p->mass[i] > 0) || !isfinite(sum))
			return ts_fail(&sim->error, TS_DAMAGED, NULL,
				       "particle %zu has an impossible identity, type, size or place", i + 1);
	}
	return TS_OK;
}

static enum ts_status archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a)
{
	struct ts_particles *p = self->state;
	int64_t n = (int64_t)p->n;
	int32_t ntypes = p->ntypes;
	size_t capacity = p->type_mass ? (size_t)p->ntypes + 1 : 0, count = capacity;

	TS_TRY(ts_archive_fixed(a, "n", TS_SAVED_I64, &n, 1));
	TS_TRY(ts_archive_fixed(a, "ntypes", TS_SAVED_I32, &ntypes, 1));
	TS_TRY(ts_archive_array(a, "type_mass", TS_SAVED_F64, (void **)(void *)&p->type_mass, &capacity,
				&count));
	if (!ts_archive_writing(a)) {
		if (n < 0 || n > INT32_MAX || ntypes < 0 || (count && count != (size_t)ntypes + 1))
			return ts_fail(&sim->error, TS_DAMAGED, NULL,
				       "impossible number of particles or types");
		TS_TRY(ts_archive_expect(a, "tag", TS_SAVED_I32, (size_t)n));
		p->n = p->nghost = 0;
		TS_TRY(ts_particles_reserve(sim, (size_t)n));
		p->n = (size_t)n;
		for (size_t k = TS_NCOLUMN_BUILTIN; k < p->ncolumns; k++)
			ts_particles_fill_initial(&p->column[k], 0, p->n);
		sim->generation++;
		p->ntypes = ntypes;
		p->max_run_tag = sim->clock.step > 0 ? p->max_tag : 0;
	}
	TS_TRY(archive_groups(sim, a));
	TS_TRY(archive_dynamic_groups(sim, p, a));
	TS_TRY(archive_columns(sim, p, a));
	return ts_archive_writing(a) ? TS_OK : check_particles(sim, p);
}

static bool has_state(const struct ts_particles *p, size_t k)
{
	return p->column[k].active && !(p->column[k].flags & TS_COL_RESULT) && p->n;
}

static void hash_column(const struct ts_particles *p, size_t k, size_t n, struct ts_hash *hash)
{
	const struct ts_column *c = &p->column[k];

	ts_hash_add(hash, c->data, n * c->width * c->element);
}

/* The sum over rows of the column; it does not depend on their order. */
static uint64_t sum_column(const struct ts_particles *p, size_t k, size_t n)
{
	const struct ts_column *c = &p->column[k];
	struct ts_hash seed = ts_hash_start();

	ts_hash_text(&seed, c->name);
	return ts_hash_rows(&seed, p->tag, c->data, c->width * c->element, n);
}

/* Of restart files of older versions: by the order of the rows. Columns of styles are added in the order in which these are
 * defined, which is another one after read_restart. */
static uint64_t hash_in_order(const struct ts_particles *p, struct ts_hash *hash)
{
	uint64_t sum = 0;

	for (size_t k = 0; k < TS_NCOLUMN_BUILTIN; k++)
		if (has_state(p, k))
			hash_column(p, k, p->n, hash);
	for (size_t k = TS_NCOLUMN_BUILTIN; k < p->ncolumns; k++) {
		struct ts_hash own = ts_hash_start();

		if (!has_state(p, k))
			continue;
		ts_hash_text(&own, p->column[k].name);
		hash_column(p, k, p->n, &own);
		sum += ts_hash_value(&own);
	}
	return sum;
}

/* Adds the numbers of all ranks, modulo 2^64. */
static uint64_t sum_of_ranks(const struct tsim *sim, uint64_t number)
{
	int64_t half[2] = { (int64_t)(number & UINT32_MAX), (int64_t)(number >> 32) };

	ts_ranks_sums(sim, half, 2);
	return (uint64_t)half[0] + ((uint64_t)half[1] << 32);
}

/* A rank that has all particles for a look hashes its own ones, as without the look. */
static void fingerprint(const struct ts_instance *self, const struct tsim *sim, struct ts_hash *hash)
{
	const struct ts_particles *p = self->state;
	const bool apart = sim->division || sim->run.looks;
	const size_t n = sim->run.looks ? p->division->look.n : p->n;
	uint64_t number = n, sum = 0;

	number = apart ? sum_of_ranks(sim, number) : number;
	ts_hash_add(hash, &number, sizeof number);
	ts_materials_fingerprint(&p->materials, hash);
	if (ts_fingerprint_in_order(sim) && !apart) {
		sum = hash_in_order(p, hash);
		ts_hash_add(hash, &sum, sizeof sum);
		return;
	}
	for (size_t k = 0; k < p->ncolumns; k++)
		if (p->column[k].active && !(p->column[k].flags & TS_COL_RESULT) &&
		    !ts_particles_column_orphaned(sim, &p->column[k]))
			sum += sum_column(p, k, n);
	sum = apart ? sum_of_ranks(sim, sum) : sum;
	ts_hash_add(hash, &sum, sizeof sum);
}

/* Only fix enforce2d keeps particles in the plane, so a script may have forgotten it. */
static void warn_out_of_plane(struct tsim *sim)
{
	const struct ts_particles *p = sim->particles;

	for (size_t i = 0; sim->dimension == 2 && i < p->n; i++) {
		bool spins = p->omega && (p->omega[i][0] != 0 || p->omega[i][1] != 0);

		if (p->x[i][2] == 0 && p->v[i][2] == 0 && !spins)
			continue;
		ts_warn(&sim->log, NULL,
			"dimension 2: particle %d is out of the plane z = 0, moves out of it or turns about "
			"an axis in it; fix enforce2d keeps particles in the plane",
			p->tag[i]);
		return;
	}
}

static enum ts_status plan(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report)
{
	const struct ts_particles *p = self->state;
	double bytes = 0, saved_bytes = 0;
	struct ts_str unused = { 0 };

	warn_out_of_plane(sim);
	if (!p->n && !sim->division) /* the review has seen nothing: again before the next run */
		sim->review.made = false;
	for (size_t k = 0; k < p->ncolumns; k++) {
		const struct ts_column *c = &p->column[k];
		double size = (double)(p->capacity * c->width * c->element);

		bytes += c->active ? size : 0;
		saved_bytes += c->active ? 0 : size;
		if (!c->active)
			ts_str_addf(&unused, "%s%s", unused.length ? ", " : "", c->name);
	}
	if (unused.length)
		ts_report_left_out(report, "columns", TS_FULL_COLUMNS, saved_bytes,
				   "%s: no live style needs them", ts_str_text(&unused));
	ts_str_release(&unused);
	if (!report->limits_only)
		TS_TRY(p->check_movers(sim));
	report->bytes += bytes;
	ts_report_line(report, "particles", "%zu of %d types, %.0f bytes each", p->n, p->ntypes,
		       p->capacity ? bytes / (double)p->capacity : 0.0);
	return TS_OK;
}

static enum ts_status assign_due_groups(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_particles *p = self->state;

	return p->choose_members(sim, false);
}

/* The stage EXCHANGE is executed before the first step only if the state was changed since the last run: the
 * members of dynamic groups are then assigned again. A run that resumes keeps them. */
static enum ts_status assign_all_groups(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_particles *p = self->state;

	return sim->clock.step == sim->clock.first_step ? p->choose_members(sim, true) : TS_OK;
}

/* From now on overlaps of the particles result from contact forces. */
static enum ts_status mark_particles_run(struct ts_instance *self, struct tsim *sim)
{
	struct ts_particles *p = self->state;

	if (sim->clock.last_step > sim->clock.step + 1) /* `run 0` and `run 1` only set up forces */
		p->max_run_tag = p->max_tag;
	return TS_OK;
}

static const struct ts_saved saved[] = {
	TS_SAVE_I32(struct ts_particles, max_tag),
	TS_SAVE_I32(struct ts_particles, lost_policy),
	TS_SAVE_I64(struct ts_particles, lost),
	TS_SAVED_ROWS_END,
};

const struct ts_system_style ts_particles_system = {
	.style = { .name = "particles",
		   .kind = TS_KIND_SYSTEM,
		   .summary = "the particles and their groups",
		   .state_size = sizeof(struct ts_particles),
		   .saved = saved,
		   .archive = archive,
		   .fingerprint = fingerprint,
		   .ranks = TS_RANKS_PARTICLES | TS_RANKS_ROWLESS,
		   .init = init,
		   .plan = plan,
		   .hook = { [TS_STAGE_POST_INTEGRATE] = assign_due_groups,
			     [TS_STAGE_EXCHANGE] = assign_all_groups,
			     [TS_STAGE_SETUP] = mark_particles_run },
		   .defers = TS_DEFERS(POST_INTEGRATE),
		   .fini = fini },
	.slot = offsetof(struct tsim, particles),
	.undivided = ts_division_undivided,
	.whole_step = ts_division_whole_step,
	.crowd = ts_particles_crowd,
	.has_property = ts_property_given,
	.keeps_quantity = ts_particles_keeps_quantity,
	.has_quantity = ts_particles_has_quantity,
	.quantity = ts_particles_quantity,
	.suggest_quantity = ts_particles_suggest_quantity,
	.quantity_text = ts_particles_quantity_text,
};
