#include "base/clones.h"
TS_UNROLLED

#include "contact/substep_stages.h"

#include "base/banned.h"

/* Contacts whose motion is integrated, those that may end before those that begin. The numbers of lanes are whole
 * vectors, the last ones repeat the last contact. */
struct motions {
	double mass[TS_BATCH], g[TS_BATCH], k[TS_BATCH], c[TS_BATCH], at[TS_BATCH]; /* struct ts_impact */
	double q[TS_BATCH], v[TS_BATCH];					    /* state */
	double span[TS_BATCH];			     /* time to integrate over */
	double start_q[TS_BATCH], start_v[TS_BATCH]; /* of the part in which the contact ends */
	double time[TS_BATCH]; /* at the begin of the part in which the contact ends; else the whole span */
	double lo[TS_BATCH], hi[TS_BATCH], f[TS_BATCH], g1[TS_BATCH], found[TS_BATCH]; /* of regula falsi */
	/* all bits set if: the contact lasts; it ended; its end is being searched for */
	long long lasts[TS_BATCH], ended[TS_BATCH], searched[TS_BATCH];
	enum ts_impact_damping damping;
	bool no_tension;
} __attribute__((aligned(64)));

enum { LANES = 8 };

TS_INLINE void impact_of(const struct motions *w, size_t k, bool hertz, bool no_tension, struct ts_impact *o)
{
	*o = (struct ts_impact){ .mass = w->mass[k],
				 .g = w->g[k],
				 .k = w->k[k],
				 .c = w->c[k],
				 .at = w->at[k],
				 .hertz = hertz,
				 .damping = w->damping,
				 .no_tension = no_tension };
}

/* ---- one contact; as in law/impact.h */

TS_INLINE void advance_at(struct motions *w, size_t k, bool hertz, bool no_tension, double part)
{
	struct ts_impact o;
	double q = w->q[k], v = w->v[k];

	(void)part;
	impact_of(w, k, hertz, no_tension, &o);
	ts_impact_rk4_step(&o, w->span[k] / TS_IMPACT_PARTS, &q, &v);
	w->q[k] = q;
	w->v[k] = v;
}

/* The criterion of the end at the start. */
TS_INLINE void judge_at(struct motions *w, size_t k, bool hertz, bool no_tension, double part)
{
	struct ts_impact o;

	(void)part;
	impact_of(w, k, hertz, no_tension, &o);
	w->f[k] = ts_impact_end_criterion(&o, w->q[k], w->v[k]);
}

/* One part of ts_impact_integrate_to_end. Criteria are kept: f before and g1 after the part. */
TS_INLINE void advance_to_end_at(struct motions *w, size_t k, bool hertz, bool no_tension, double part)
{
	double length = w->span[k] / TS_IMPACT_PARTS, q = w->q[k], v = w->v[k], q1 = q, v1 = v, criterion;
	double time = w->time[k], f = w->f[k], g1 = w->g1[k];
	long long lasts = w->lasts[k], ended;
	struct ts_impact o;

	impact_of(w, k, hertz, no_tension, &o);
	ts_impact_rk4_step(&o, length, &q1, &v1);
	criterion = ts_impact_end_criterion(&o, q1, v1);
	ended = -(long long)!(criterion > 0) & lasts;
	lasts &= ~ended;
	w->time[k] = ended ? part * length : time;
	w->q[k] = lasts ? q1 : q;
	w->v[k] = lasts ? v1 : v;
	w->f[k] = lasts ? criterion : f;
	w->g1[k] = ended ? criterion : g1;
	w->lasts[k] = lasts;
	w->ended[k] |= ended;
}

/* One step of ts_impact_find_end. */
TS_INLINE void approach_at(struct motions *w, size_t k, bool hertz, bool no_tension, double part)
{
	double lo = w->lo[k], hi = w->hi[k], f = w->f[k], g1 = w->g1[k], q = w->start_q[k], v = w->start_v[k];
	double time = lo + (hi - lo) * f / (f - g1), held;
	double last_q = w->q[k], last_v = w->v[k], last = w->found[k];
	long long searched = w->searched[k], still;
	struct ts_impact o;
	bool touches;

	(void)part;
	impact_of(w, k, hertz, no_tension, &o);
	ts_impact_rk4_step(&o, time, &q, &v);
	held = ts_impact_end_criterion(&o, q, v);
	touches = held > 0;
	w->lo[k] = touches ? time : lo;
	w->hi[k] = touches ? hi : time;
	f = touches ? held : f * 0.5;
	w->f[k] = f;
	w->g1[k] = touches ? g1 * 0.5 : held;
	still = searched & -(long long)((held != 0) & (f > 0));
	w->q[k] = searched ? q : last_q;
	w->v[k] = searched ? v : last_v;
	w->found[k] = searched ? time : last;
	w->searched[k] = still;
}
/* ---- loops over contacts */

static size_t whole_vectors(size_t n)
{
	return (n + LANES - 1) / LANES * LANES;
}

typedef void motion_fn(struct motions *restrict w, size_t n, double part);
#define MOTION_LOOP(name, what_at, hertz, no_tension)                                                      \
	TS_CLONES static void name(struct motions *restrict w, size_t n, double part)                      \
	{                                                                                                  \
		_Pragma("omp simd") for (size_t k = 0; k < n; k++) what_at(w, k, hertz, no_tension, part); \
	}
/* The loops have constants, else the compiler does not vectorise them. */
#define MOTION(name)                                                                        \
	MOTION_LOOP(name##_linear, name##_at, false, false)                                 \
	MOTION_LOOP(name##_linear_no_tension, name##_at, false, true)                       \
	MOTION_LOOP(name##_hertz, name##_at, true, false)                                   \
	MOTION_LOOP(name##_hertz_no_tension, name##_at, true, true)                         \
	static motion_fn *const name[2][2] = { { name##_linear, name##_linear_no_tension }, \
					       { name##_hertz, name##_hertz_no_tension } };
MOTION(advance)
MOTION(advance_to_end)
MOTION(judge)
MOTION(approach)

static bool any(const long long *mark, size_t n)
{
	long long bits = 0;

	for (size_t k = 0; k < n; k++)
		bits |= mark[k];
	return bits;
}

static void integrate(struct motions *w, size_t n, bool hertz)
{
	for (int part = 0; part < TS_IMPACT_PARTS; part++)
		advance[hertz][w->no_tension](w, n, part);
}

static void integrate_to_end(struct motions *w, size_t n, bool hertz, double time)
{
	size_t searched =
		0; /* lanes that have those with an end to be found; what begins is last and rarely ends */

	for (size_t k = 0; k < n; k++) {
		w->span[k] = w->time[k] = time;
		w->lasts[k] = -1;
		w->ended[k] = 0;
		w->found[k] = w->g1[k] = 0;
	}
	judge[hertz][w->no_tension](w, n, 0);
	for (int part = 0; part < TS_IMPACT_PARTS && any(w->lasts, n); part++)
		advance_to_end[hertz][w->no_tension](w, n, part);
	for (size_t k = 0; k < n; k++) {
		w->start_q[k] = w->q[k];
		w->start_v[k] = w->v[k];
		w->lo[k] = 0;
		w->hi[k] = time / TS_IMPACT_PARTS;
		w->searched[k] = -(long long)(w->f[k] > 0) & w->ended[k];
		searched = w->searched[k] ? k + 1 : searched;
	}
	for (int step = 0; step < TS_IMPACT_SEARCHES && any(w->searched, searched); step++)
		approach[hertz][w->no_tension](w, whole_vectors(searched), 0);
	for (size_t k = 0; k < n; k++)
		w->time[k] += w->found[k];
}

TS_INLINE void locate_at(struct ts_stages *s, size_t k, const struct ts_granular_model *m, double dt,
			 double *const memory[TS_LOCATED_SLIP], struct ts_substep_columns *l)
{
	struct ts_touch t = { .overlap = s->overlap[k], .m_eff = s->m_eff[k], .vn = s->vn[k] };
	struct ts_normal f = {
		.kn = s->kn[k], .gamman = s->gamman[k], .force = s->normal[k], .limit = s->limit[k]
	};
	struct ts_impact o = ts_impact_of(m, &t, &f);
	double own[TS_LOCATED_SLIP], before[TS_LOCATED_SLIP], around, force, u = -t.vn;
	double normal = f.force, limit = f.limit; /* loaded before, else the loop has branches */
	long long damped = s->touch[k] & -(long long)(f.gamman > 0), what, plain;

	for (int c = 0; c < TS_LOCATED_SLIP; c++)
		own[c] = before[c] = memory[c][k];
	what = ts_substep_of_contact(&o, dt, t.overlap, u, f.force, own, &around, &force);
	l->stage[k] = before[TS_LOCATED_STAGE];
	l->before[k] = dt;
	l->force[k] = force;
	l->g[k] = o.g;
	l->happens[k] = damped & what;
	plain = damped & -(long long)(what == TS_SUBSTEP_PLAIN);
	ts_substep_store_target(m, o.mass, u, dt, force, own, &f);
	for (int c = 0; c < TS_LOCATED_SLIP; c++)
		memory[c][k] = plain ? own[c] : before[c];
	s->normal[k] = plain ? f.force : normal;
	s->limit[k] = plain ? f.limit : limit;
	around = plain ? around : 1;
	s->gammat[k] *= around;
}

typedef void locate_fn(struct ts_stages *restrict s, size_t n, const struct ts_granular_model *restrict m,
		       double dt, double *const memory[TS_LOCATED_SLIP],
		       struct ts_substep_columns *restrict l);
#define LOCATE_LOOP(name, law, pushes)                                                                   \
	TS_CLONES static void name(struct ts_stages *restrict s, size_t n,                               \
				   const struct ts_granular_model *restrict m, double dt,                \
				   double *const memory[TS_LOCATED_SLIP],                                \
				   struct ts_substep_columns *restrict l)                                \
	{                                                                                                \
		const struct ts_granular_model own = { .normal = (law),                                  \
						       .absolute_damping = m->absolute_damping,          \
						       .no_tension = (pushes) };                         \
		double *const column[TS_LOCATED_SLIP] = { memory[0], memory[1], memory[2] };             \
                                                                                                         \
		_Pragma("omp simd") for (size_t k = 0; k < n; k++) locate_at(s, k, &own, dt, column, l); \
	}
#define LOCATE(name, law)             \
	LOCATE_LOOP(name, law, false) \
	LOCATE_LOOP(name##_no_tension, law, true)
LOCATE(locate_linear, TS_NORMAL_SPRING)
LOCATE(locate_hertz, TS_NORMAL_HERTZ)
LOCATE(locate_hertz_stiffness, TS_NORMAL_HERTZ_STIFFNESS)

/* ---- contacts that begin or end */

struct special {
	size_t at[TS_BATCH], ends,
		all;	    /* places in the batch: first those that may end, then those that begin */
	double u[TS_BATCH]; /* velocity of the last half step, corrected by the position error where it may end */
	double velocity[TS_BATCH], from[TS_BATCH]; /* guess of the velocity at t, or state after the flight */
};

static void find_special(const struct ts_substep_columns *l, size_t n, struct special *e)
{
	e->all = 0;
	for (size_t k = 0; k < n; k++)
		if (l->happens[k] == TS_SUBSTEP_MAY_END)
			e->at[e->all++] = k;
	e->ends = e->all;
	for (size_t k = 0; k < n; k++)
		if (l->happens[k] == TS_SUBSTEP_BEGINS)
			e->at[e->all++] = k;
}

static void load_motions(const struct ts_stages *s, const struct ts_substep_columns *l, double dt,
			 double *const memory[], struct special *e, struct motions *w)
{
	size_t lanes = whole_vectors(e->all);

	for (size_t k = 0; k < lanes; k++) {
		size_t last = k < e->all ? k : e->all - 1, at = e->at[last];
		bool begins = last >= e->ends;

		w->mass[k] = s->m_eff[at];
		w->g[k] = begins ? 0 : l->g[at];
		w->k[k] = s->kn[at];
		w->c[k] = s->gamman[at];
		w->at[k] = s->overlap[at];
		e->u[last] = -s->vn[at];
		if (!begins) {
			struct ts_impact o = { .mass = w->mass[k], .g = w->g[k] };

			e->u[last] += memory[TS_LOCATED_AHEAD][at] / dt;
			e->velocity[last] = ts_substep_guess(&o, dt, e->u[last], l->force[at]);
		}
		w->q[k] = begins ? 0 : w->at[k];
		w->v[k] = begins ? e->u[last] : e->velocity[last];
		w->span[k] = begins ? w->at[k] / e->u[last] : -dt;
	}
}

/* Better guesses of the velocities of the contacts that may end; they are the states to start from. */
static void guess_again(struct motions *w, double dt, struct special *e)
{
	for (size_t k = 0; k < e->ends; k++) {
		e->velocity[k] = ts_substep_better_guess(dt, w->at[k], e->u[k], w->q[k], e->velocity[k]);
		w->q[k] = w->at[k];
		w->v[k] = e->velocity[k];
	}
}

/* States at the begin of the step: what ends, from the motion that came from one step back; what begins, after its
 * flight. */
static void prepare(struct motions *w, bool hertz, double dt, struct special *e)
{
	integrate(w, whole_vectors(e->all), hertz);
	for (size_t k = e->ends; k < e->all; k++) {
		e->from[k] = w->q[k];
		e->velocity[k] = w->v[k];
	}
	guess_again(w, dt, e);
	for (int guess = 1; guess < TS_SUBSTEP_GUESSES && e->ends; guess++) {
		integrate(w, whole_vectors(e->ends), hertz);
		guess_again(w, dt, e);
	}
	for (size_t k = e->ends; k < e->all; k++) {
		w->q[k] = e->from[k];
		w->v[k] = e->velocity[k];
	}
}

/* Forces, and what the contacts remember. */
static void store_motions(struct ts_stages *s, const struct ts_granular_model *m, double dt,
			  double *const memory[], const struct special *e, const struct motions *w,
			  struct ts_substep_columns *l)
{
	for (size_t k = 0; k < e->all; k++) {
		size_t at = e->at[k];
		double own[TS_LOCATED_SLIP], u = -s->vn[at], ahead = memory[TS_LOCATED_AHEAD][at], force;
		struct ts_impact o = { .mass = w->mass[k], .g = w->g[k] };
		struct ts_substep part = { dt, 1 };
		bool ended = w->ended[k];
		struct ts_normal f;

		if (k >= e->ends) {
			force = ts_substep_begun(&o, dt, w->at[k], u, e->from[k], w->q[k], w->v[k],
						 w->time[k], ended, own, &part);
		} else {
			own[TS_LOCATED_STAGE] = ended ? TS_LOCATED_LEFT : TS_LOCATED_TOUCHES;
			own[TS_LOCATED_AHEAD] = 0;
			force = ended ? ts_substep_ended(&o, dt, u, w->v[k], w->time[k], &part)
				      : l->force[at] - ts_substep_correction(&o, dt, ahead);
		}
		ts_substep_store_target(m, o.mass, u, dt, force, own, &f);
		for (int c = 0; c < TS_LOCATED_SLIP; c++)
			memory[c][at] = own[c];
		s->normal[at] = f.force;
		s->limit[at] = f.limit;
		s->gammat[at] *= part.around;
		l->before[at] = part.before;
	}
}

/* ---- slip velocities */

TS_INLINE void slip_at(struct ts_stages *s, size_t k, const struct ts_granular_model *m, double dt,
		       double *const spring[3], double *const memory[TS_LOCATED_MEMORY],
		       struct ts_substep_columns *l)
{
	struct ts_touch t = { .m_eff = s->m_eff[k], .slip = { s->slip[0][k], s->slip[1][k], s->slip[2][k] } };
	struct ts_normal f = { .kt = s->kt[k], .gammat = s->gammat[k] };
	struct ts_substep part = { .before = l->before[k] };
	double own[TS_LOCATED_MEMORY] = { 0 }, xi[3] = { 0 };
	bool remembers = ts_tangential_remembers(m);

	for (int c = 0; c < 3; c++) {
		l->slip[c][k] = t.slip[c];
		own[TS_LOCATED_SLIP + c] = memory[TS_LOCATED_SLIP + c][k];
		if (remembers)
			xi[c] = spring[c][k];
	}
	ts_substep_advance_slip(m, &f, &part, l->stage[k], remembers, dt, own, xi, &t);
	for (int c = 0; c < 3; c++) {
		double before = remembers ? spring[c][k] : 0;

		s->slip[c][k] = t.slip[c];
		if (remembers)
			spring[c][k] = s->touch[k] ? xi[c] : before;
	}
}

TS_INLINE void target_at(struct ts_stages *s, size_t k, const struct ts_granular_model *m, double dt,
			 double *const spring[3], double *const memory[TS_LOCATED_MEMORY],
			 struct ts_substep_columns *l)
{
	struct ts_touch t = { .m_eff = s->m_eff[k] };
	double u[3], force[3], own[TS_LOCATED_MEMORY];

	(void)spring;
	for (int c = 0; c < 3; c++) {
		u[c] = l->slip[c][k];
		force[c] = s->tangential[c][k];
	}
	ts_substep_store_slip_target(m, &t, u, dt, force, own);
	for (int c = TS_LOCATED_SLIP; c < TS_LOCATED_MEMORY; c++) {
		double before = memory[c][k];

		memory[c][k] = s->touch[k] ? own[c] : before;
	}
}

typedef void slip_fn(struct ts_stages *restrict s, size_t n, const struct ts_granular_model *restrict m,
		     double dt, struct ts_substep_columns *restrict l);
#define SLIP(name, what_at, law)                                                                        \
	TS_CLONES static void name(struct ts_stages *restrict s, size_t n,                              \
				   const struct ts_granular_model *restrict m, double dt,               \
				   struct ts_substep_columns *restrict l)                               \
	{                                                                                               \
		const struct ts_granular_model own = { .tangential = (law), .plane = m->plane };        \
		double *const *at = s->memory + ts_granular_located_at(m);                              \
		double *const spring[3] = { s->memory[0], s->memory[1], s->memory[2] };                 \
		double *const memory[TS_LOCATED_MEMORY] = { at[0], at[1], at[2], at[3], at[4], at[5] }; \
                                                                                                        \
		if (!(dt > 0))                                                                          \
			return;                                                                         \
		_Pragma("omp simd") for (size_t k = 0; k < n; k++)                                      \
			what_at(s, k, &own, dt, spring, memory, l);                                     \
	}
SLIP(slip, slip_at, TS_TANGENTIAL_NO_HISTORY)
SLIP(slip_of_spring, slip_at, TS_TANGENTIAL_HISTORY)
SLIP(targets, target_at, TS_TANGENTIAL_NO_HISTORY)

void ts_substep_stage(struct ts_stages *s, size_t n, const struct ts_granular_model *m, double dt,
		      struct ts_substep_columns *l)
{
	static locate_fn *const hertzian[TS_NNORMAL][2] = {
		[TS_NORMAL_HERTZ] = { locate_hertz, locate_hertz_no_tension },
		[TS_NORMAL_HERTZ_STIFFNESS] = { locate_hertz_stiffness, locate_hertz_stiffness_no_tension },
	}, *const linear[2] = { locate_linear, locate_linear_no_tension };
	double *const *memory = s->memory + ts_granular_located_at(m);
	bool hertz = hertzian[m->normal][0];
	struct special e;
	struct motions w;

	(hertz ? hertzian[m->normal] : linear)[m->no_tension](s, n, m, dt, memory, l);
	find_special(l, n, &e);
	for (size_t k = 0; s->postpones && k < e.all; k++)
		s->touch[e.at[k]] = 0;
	if (e.all && !s->postpones) {
		w.damping = ts_impact_damping_of(m);
		w.no_tension = m->no_tension;
		load_motions(s, l, dt, memory, &e, &w);
		prepare(&w, hertz, dt, &e);
		integrate_to_end(&w, whole_vectors(e.all), hertz, dt);
		store_motions(s, m, dt, memory, &e, &w, l);
	}
	if (m->tangential != TS_TANGENTIAL_OFF)
		(ts_tangential_remembers(m) ? slip_of_spring : slip)(s, n, m, dt, l);
}

void ts_substep_stage_slip_targets(struct ts_stages *s, size_t n, const struct ts_granular_model *m,
				   double dt, const struct ts_substep_columns *l)
{
	targets(s, n, m, dt, (struct ts_substep_columns *)l);
}
