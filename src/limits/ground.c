#include "limits/ground.h"

#include <math.h>
#include <string.h>

#include "base/str.h"
#include "core/report.h"
#include "integrate/integrators.h"
#include "particle/prescribed.h"
#include "rigid/rigid.h"

#include "base/banned.h"

/* Adds what the fix adds; false: no spring or dashpot. */
static bool add_fix(const struct ts_instance *fix, const struct tsim *sim, size_t i,
		    struct ts_ground_springs *sum)
{
	struct ts_ground_springs own = { .turning = 0 };
	bool acts;

	if (!fix->style->ground || !ts_in_group(sim->particles, i, fix->group))
		return false;
	fix->style->ground(fix, sim, i, &own);
	acts = own.turning > 0;
	for (int d = 0; d < 3; d++) {
		sum->frequency2[d] += own.frequency2[d];
		sum->rate[d] += own.rate[d];
		acts |= own.frequency2[d] > 0 || own.rate[d] > 0;
	}
	sum->turning += own.turning;
	sum->added += own.added;
	sum->estimated |= own.estimated;
	return acts;
}

int ts_ground_of(const struct tsim *sim, size_t i, struct ts_ground_springs *sum)
{
	const struct ts_instances *fixes = &sim->instances[TS_KIND_FIX];
	int n = 0;

	memset(sum, 0, sizeof *sum);
	for (size_t k = 0; k < fixes->n; k++)
		n += add_fix(fixes->item[k], sim, i, sum);
	return n;
}

int ts_ground_fixes(const struct tsim *sim, const struct ts_instance **last)
{
	const struct ts_instances *fixes = &sim->instances[TS_KIND_FIX];
	int n = 0;

	*last = NULL;
	for (size_t k = 0; k < fixes->n; k++)
		if (fixes->item[k]->style->ground) {
			*last = fixes->item[k];
			n++;
		}
	return n;
}

/* h = 2 (sqrt(w^2 + g^2) - g)/w^2 with 2 g = rate (limits/lanczos.h), without the difference. */
static double stable_step(double frequency2, double rate)
{
	return 2 / (sqrt(frequency2 + 0.25 * rate * rate) + 0.5 * rate);
}

static double limit_of(const struct ts_ground_springs *s)
{
	double limit = stable_step(0, s->turning);

	for (int d = 0; d < 3; d++)
		limit = fmin(limit,
			     stable_step(s->frequency2[d] / (1 + s->added), s->rate[d] / (1 + s->added)));
	return limit;
}

struct names {
	int n;
	const struct ts_instance *last;
	struct ts_str list; /* "fix spring/self a, fix viscous b" */
};

static void find_names(const struct tsim *sim, size_t i, struct names *names)
{
	const struct ts_instances *fixes = &sim->instances[TS_KIND_FIX];
	struct ts_ground_springs sum = { .turning = 0 };

	for (size_t k = 0; k < fixes->n; k++)
		if (add_fix(fixes->item[k], sim, i, &sum)) {
			names->last = fixes->item[k];
			ts_str_addf(&names->list, "%sfix %s %s", names->n++ ? ", " : "",
				    names->last->style->name, names->last->id);
		}
}

static enum ts_status report_particle(struct ts_plan_report *report, struct tsim *sim, size_t i, double limit,
				      bool estimated)
{
	const struct ts_particles *p = sim->particles;
	struct names names = { 0 };
	enum ts_status status;

	find_names(sim, i, &names);
	status = ts_report_limit(report, limit, !estimated && !sim->run.clamped && !sim->run.explicit_euler,
				 &names.last->where, "%s%s, on particle %d of type %d at (%.4g %.4g %.4g)",
				 names.list.text ? names.list.text : "fixes", names.n > 1 ? " together" : "",
				 p->tag[i], p->type[i], p->x[i][0], p->x[i][1], p->x[i][2]);
	ts_str_release(&names.list);
	return status;
}

/* Sets *sum to that of particle i. Returns whether no fix reports its limit in its slot `plan`. */
static bool is_unreported(const struct tsim *sim, size_t i, struct ts_ground_springs *sum)
{
	const struct ts_instances *fixes = &sim->instances[TS_KIND_FIX];
	bool unreported = false;
	int n = 0;

	memset(sum, 0, sizeof *sum);
	for (size_t k = 0; k < fixes->n; k++)
		if (add_fix(fixes->item[k], sim, i, sum)) {
			unreported |= !fixes->item[k]->style->plan;
			n++;
		}
	return n > 1 || unreported;
}

enum ts_status ts_ground_report(struct ts_plan_report *report, struct tsim *sim)
{
	const struct ts_particles *p = sim->particles;
	const uint32_t moved = ts_integrated_groups(sim, TS_MOVES | TS_OBEYS),
		       prescribed = ts_prescribed(sim);
	double least[2] = { INFINITY, INFINITY }; /* exact, estimated */
	size_t at[2] = { 0, 0 };
	const struct ts_instance *last;

	if (!ts_ground_fixes(sim, &last))
		return TS_OK;
	for (size_t i = 0; i < p->n; i++) {
		bool in_body = ts_rigid_member(p, i);
		struct ts_ground_springs sum;

		if (!(p->mask[i] & moved || in_body) || p->mask[i] & prescribed ||
		    !is_unreported(sim, i, &sum))
			continue;
		sum.estimated |= in_body;
		if (limit_of(&sum) < least[sum.estimated]) {
			least[sum.estimated] = limit_of(&sum);
			at[sum.estimated] = i;
		}
	}
	for (int k = 0; k < 2; k++)
		if (isfinite(least[k]))
			TS_TRY(report_particle(report, sim, at[k], least[k], k == 1));
	return TS_OK;
}
