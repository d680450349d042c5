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

int ts_ground_of(const struct tsim *sim, size_t i, struct ts_ground_springs *sum,
		 const struct ts_instance **last)
{
	const struct ts_instances *fixes = &sim->instances[TS_KIND_FIX];
	int n = 0;

	memset(sum, 0, sizeof *sum);
	*last = NULL;
	for (size_t k = 0; k < fixes->n; k++)
		if (add_fix(fixes->item[k], sim, i, sum)) {
			*last = fixes->item[k];
			n++;
		}
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

/* Of members of rigid bodies the mass is that of the particle, not of the body. */
static bool is_estimated(const struct tsim *sim, size_t i, const struct ts_ground_springs *sum)
{
	return sum->estimated || ts_rigid_member(sim->particles, i);
}

/* "fix spring/self a, fix viscous b" */
static void name_fixes(const struct tsim *sim, size_t i, struct ts_str *names)
{
	const struct ts_instances *fixes = &sim->instances[TS_KIND_FIX];
	struct ts_ground_springs sum = { .turning = 0 };

	for (size_t k = 0; k < fixes->n; k++)
		if (add_fix(fixes->item[k], sim, i, &sum))
			ts_str_addf(names, "%sfix %s %s", names->length ? ", " : "",
				    fixes->item[k]->style->name, fixes->item[k]->id);
}

static enum ts_status report_particle(struct ts_plan_report *report, struct tsim *sim, size_t i)
{
	const struct ts_particles *p = sim->particles;
	const struct ts_instance *last;
	struct ts_ground_springs sum;
	struct ts_str names = { 0 };
	const int n = ts_ground_of(sim, i, &sum, &last);
	enum ts_status status;

	name_fixes(sim, i, &names);
	status = ts_report_limit(report, limit_of(&sum),
				 !is_estimated(sim, i, &sum) && !sim->run.clamped && !sim->run.explicit_euler,
				 &last->where, "%s%s, on particle %d of type %d at (%.4g %.4g %.4g)",
				 names.text ? names.text : "fixes", n > 1 ? " together" : "", p->tag[i],
				 p->type[i], p->x[i][0], p->x[i][1], p->x[i][2]);
	ts_str_release(&names);
	return status;
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
		struct ts_ground_springs sum;
		bool estimated;
		int n;

		if (!(p->mask[i] & moved || ts_rigid_member(p, i)) || p->mask[i] & prescribed)
			continue;
		n = ts_ground_of(sim, i, &sum, &last);
		if (!n || (n == 1 && last->style->plan)) /* which reports it */
			continue;
		estimated = is_estimated(sim, i, &sum);
		if (limit_of(&sum) < least[estimated]) {
			least[estimated] = limit_of(&sum);
			at[estimated] = i;
		}
	}
	for (int k = 0; k < 2; k++)
		if (isfinite(least[k]))
			TS_TRY(report_particle(report, sim, at[k]));
	return TS_OK;
}
