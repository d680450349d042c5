#include "base/clones.h"
TS_UNROLLED

#include "contact/law_stages.h"

#include "contact/substep_stages.h"

#include "base/banned.h"

/* Constants and columns of one stage. */
struct stage_task {
	const struct ts_granular_model *m;
	const struct ts_granular_pair *law;
	double dt;
	double *memory[3], *area; /* history columns of the stage */
	const double *radius[2], *mass[2];
	const long long *touch;
	bool wall;
};

/* The contact as the laws of one contact read it. The compiler drops loads of columns that the law does not
 * use. */
TS_INLINE void load_touch(const struct ts_stages *s, size_t k, const struct stage_task *o, struct ts_touch *t)
{
	*t = (struct ts_touch){
		.n = { s->n[0][k], s->n[1][k], s->n[2][k] },
		.distance = s->distance[k],
		.overlap = s->overlap[k],
		.radius = { o->radius[0][k], o->wall ? 0 : o->radius[1][k] },
		.mass = { o->mass[0][k], o->wall ? 0 : o->mass[1][k] },
		.r_eff = s->r_eff[k],
		.m_eff = s->m_eff[k],
		.vn = s->vn[k],
		.slip = { s->slip[0][k], s->slip[1][k], s->slip[2][k] },
		.roll = { s->roll[0][k], s->roll[1][k], s->roll[2][k] },
		.spin = { s->spin[0][k], s->spin[1][k], s->spin[2][k] },
		.solved = s->solved[k],
		.wall = o->wall,
	};
}

TS_INLINE void load_normal(const struct ts_stages *s, size_t k, struct ts_normal *f)
{
	*f = (struct ts_normal){ .kn = s->kn[k],
				 .kt = s->kt[k],
				 .gamman = s->gamman[k],
				 .gammat = s->gammat[k],
				 .limit = s->limit[k],
				 .area = s->area[k] };
}

TS_INLINE void load_memory(double *const column[], int numbers, size_t k, double *memory)
{
	for (int c = 0; c < numbers; c++)
		memory[c] = column[c][k];
}

TS_INLINE void store_memory(const struct stage_task *o, double *const column[], int numbers, size_t k,
			    const double *memory)
{
	for (int c = 0; c < numbers; c++) {
		double before = column[c][k];

		column[c][k] = o->touch[k] ? memory[c] : before;
	}
}

/* ---- one contact */

TS_INLINE void normal_at(struct ts_stages *s, size_t k, const struct stage_task *o)
{
	int numbers = o->m->normal == TS_NORMAL_HOOKE_HYSTERESIS;
	double memory[TS_NORMAL_MEMORY] = { 0 };
	struct ts_normal f;
	struct ts_touch t;

	load_touch(s, k, o, &t);
	load_memory(o->memory, numbers, k, memory);
	ts_normal_force(o->m, o->law, &t, memory, &f);
	store_memory(o, o->memory, numbers, k, memory);
	s->kn[k] = f.kn;
	s->kt[k] = f.kt;
	s->gamman[k] = f.gamman;
	s->gammat[k] = f.gammat;
	s->area[k] = f.area;
	s->normal[k] = f.force;
	s->limit[k] = f.limit;
}

TS_INLINE void cohesion_at(struct ts_stages *s, size_t k, const struct stage_task *o)
{
	struct ts_touch t;
	double pull;

	load_touch(s, k, o, &t);
	pull = ts_cohesion_force(o->m, o->law, &t);
	s->normal[k] += pull;
	s->limit[k] = o->m->reduce ? s->limit[k] + pull : s->limit[k];
}

TS_INLINE void tangential_at(struct ts_stages *s, size_t k, const struct stage_task *o)
{
	int numbers = ts_tangential_remembers(o->m) ? 3 : 0, rescales = ts_tangential_rescales(o->m);
	double xi[3] = { 0 }, last = 0, force[3];
	struct ts_normal f;
	struct ts_touch t;

	load_touch(s, k, o, &t);
	load_normal(s, k, &f);
	load_memory(o->memory, numbers, k, xi);
	load_memory(&o->area, rescales, k, &last);
	ts_tangential_force(o->m, o->law, &t, &f, o->dt, xi, &last, force);
	store_memory(o, o->memory, numbers, k, xi);
	store_memory(o, &o->area, rescales, k, &last);
	for (int c = 0; c < 3; c++)
		s->tangential[c][k] = force[c];
}

TS_INLINE void rolling_at(struct ts_stages *s, size_t k, const struct stage_task *o)
{
	int numbers = o->m->rolling > TS_ROLLING_CDT ? 3 : 0;
	double stored[3] = { 0 }, torque[3];
	struct ts_normal f;
	struct ts_touch t;

	load_touch(s, k, o, &t);
	load_normal(s, k, &f);
	load_memory(o->memory, numbers, k, stored);
	ts_rolling_torque(o->m, o->law, &t, &f, o->dt, true, stored, torque);
	store_memory(o, o->memory, numbers, k, stored);
	for (int c = 0; c < 3; c++)
		s->rolling[c][k] = torque[c];
}

TS_INLINE void twisting_at(struct ts_stages *s, size_t k, const struct stage_task *o)
{
	struct ts_normal f;
	struct ts_touch t;
	double phi;

	load_touch(s, k, o, &t);
	load_normal(s, k, &f);
	load_memory(o->memory, 1, k, &phi);
	s->twist[k] = ts_twisting_torque(o->m, o->law, &t, &f, o->dt, &phi);
	store_memory(o, o->memory, 1, k, &phi);
}

/* ---- what is computed once for equal particles, or by iteration */

TS_CLONES static void compute_hooke_stiffness(struct ts_stages *s, size_t n,
					      const struct ts_granular_pair *law)
{
	const double *r = s->r_eff, *m = s->m_eff;
	double *solved = s->solved;

#pragma omp simd
	for (size_t k = 0; k < n; k++)
		solved[k] = ts_hooke_stiffness(law, &(struct ts_touch){ .r_eff = r[k], .m_eff = m[k] });
}

/* The stiffness of hooke, which needs a power: once if R* and m* are those of all contacts. */
static void solve_hooke(struct ts_stages *s, size_t n, const struct ts_granular_pair *law)
{
	size_t same = 1;

	while (same < n && s->r_eff[same] == s->r_eff[0] && s->m_eff[same] == s->m_eff[0])
		same++;
	compute_hooke_stiffness(s, same < n ? n : 1, law);
	for (size_t k = 1; same == n && k < n; k++)
		s->solved[k] = s->solved[0];
}

/* Columns of struct ts_jkr_root. */
struct jkr_roots {
	double slope[TS_BATCH], root[TS_BATCH], s[TS_BATCH], target[TS_BATCH];
};

TS_INLINE void start_root_at(struct jkr_roots *q, size_t k)
{
	struct ts_jkr_root r;

	ts_jkr_start(&r, q->slope[k], q->root[k], q->target[k]);
	q->s[k] = r.s;
}

TS_INLINE int step_root_at(struct jkr_roots *q, size_t k)
{
	struct ts_jkr_root r = { q->slope[k], q->target[k], q->s[k] };
	int nearer = ts_jkr_step(&r);

	q->s[k] = r.s;
	return nearer;
}

TS_CLONES static void start_roots(struct jkr_roots *q, size_t n)
{
#pragma omp simd
	for (size_t k = 0; k < n; k++)
		start_root_at(q, k);
}

TS_CLONES static int step_roots(struct jkr_roots *q, size_t n)
{
	int nearer = 0;

#pragma omp simd reduction(| : nearer)
	for (size_t k = 0; k < n; k++)
		nearer |= step_root_at(q, k);
	return nearer;
}

/* Solves the radius of the JKR contact area by Newton iteration, for all contacts at once. */
static void solve_jkr(struct ts_stages *s, size_t n, const struct ts_granular_pair *law)
{
	struct jkr_roots q;

	for (size_t k = 0; k < n; k++) {
		bool same = k && s->r_eff[k] == s->r_eff[k - 1];

		q.slope[k] = same ? q.slope[k - 1] : ts_jkr_slope(law, s->r_eff[k]);
		q.root[k] = same ? q.root[k - 1] : cbrt(q.slope[k]);
		q.target[k] = s->r_eff[k] * s->overlap[k];
	}
	start_roots(&q, n);
	for (int step = 0; step < TS_JKR_STEPS && step_roots(&q, n); step++)
		;
	for (size_t k = 0; k < n; k++)
		s->solved[k] = q.s[k] * q.s[k];
}

/* Records that the surfaces of adhesive contacts have touched. */
static void mark_met(struct ts_stages *s, size_t n, double *met)
{
	for (size_t k = 0; k < n; k++)
		met[k] = s->touch[k] ? 1 : met[k];
}

/* ---- the loops: each has a constant law, so that the compiler keeps only what it needs, and some flags of
 * the model */

typedef void stage_fn(struct ts_stages *restrict s, size_t n, const struct ts_granular_model *restrict m,
		      const struct ts_granular_pair *restrict law, double dt);
#define STAGE(name, what_at, at, is_wall, ...)                                             \
	TS_CLONES static void name(struct ts_stages *restrict s, size_t n,                 \
				   const struct ts_granular_model *restrict m,             \
				   const struct ts_granular_pair *restrict law, double dt) \
	{                                                                                  \
		const struct ts_granular_model own = { __VA_ARGS__ };                      \
		double *const *memory = s->memory + (at);                                  \
		const struct stage_task task = { &own,                                     \
						 law,                                      \
						 dt,                                       \
						 { memory[0], memory[1], memory[2] },      \
						 s->memory[ts_granular_area_at(m)],        \
						 { s->radius[0], s->radius[1] },           \
						 { s->mass[0], s->mass[1] },               \
						 s->touch,                                 \
						 (is_wall) };                              \
                                                                                           \
		if (!(dt > 0)) /* never true: tells the compiler that dt > 0 */            \
			return;                                                            \
		_Pragma("omp simd") for (size_t k = 0; k < n; k++) what_at(s, k, &task);   \
	}

#define NORMAL(name, law)                                                                                 \
	STAGE(name, normal_at, ts_granular_depth_at(m), false, .normal = (law), .solved = true,           \
	      .damping = m->damping, .tangential = m->tangential, .no_tension = m->no_tension,            \
	      .no_tangential_damping = m->no_tangential_damping, .absolute_damping = m->absolute_damping, \
	      .tangential_stiffness_2_7 = m->tangential_stiffness_2_7)
NORMAL(spring, TS_NORMAL_SPRING)
NORMAL(hooke, TS_NORMAL_HOOKE)
NORMAL(hertz, TS_NORMAL_HERTZ)
NORMAL(hooke_stiffness, TS_NORMAL_HOOKE_STIFFNESS)
NORMAL(hooke_modulus, TS_NORMAL_HOOKE_MODULUS)
NORMAL(hertz_stiffness, TS_NORMAL_HERTZ_STIFFNESS)
NORMAL(hooke_hysteresis, TS_NORMAL_HOOKE_HYSTERESIS)
NORMAL(area_hooke, TS_NORMAL_AREA_HOOKE)
NORMAL(area_hertz, TS_NORMAL_AREA_HERTZ)
NORMAL(area_dmt, TS_NORMAL_AREA_DMT)
NORMAL(area_jkr, TS_NORMAL_AREA_JKR)

#define COHESION(name, law)                                                        \
	STAGE(name, cohesion_at, 0, false, .cohesion = (law), .reduce = m->reduce) \
	STAGE(name##_wall, cohesion_at, 0, true, .cohesion = (law), .reduce = m->reduce)
COHESION(sjkr, TS_COHESION_SJKR)
COHESION(sjkr2, TS_COHESION_SJKR2)

#define TANGENTIAL(name, law) STAGE(name, tangential_at, 0, false, .tangential = (law))
TANGENTIAL(no_tangential, TS_TANGENTIAL_OFF)
TANGENTIAL(history, TS_TANGENTIAL_HISTORY)
TANGENTIAL(no_history, TS_TANGENTIAL_NO_HISTORY)
TANGENTIAL(incremental, TS_TANGENTIAL_INCREMENTAL)
TANGENTIAL(slider, TS_TANGENTIAL_SLIDER)
TANGENTIAL(linear, TS_TANGENTIAL_LINEAR)
TANGENTIAL(mindlin, TS_TANGENTIAL_MINDLIN)
TANGENTIAL(mindlin_force, TS_TANGENTIAL_MINDLIN_FORCE)
TANGENTIAL(mindlin_rescale, TS_TANGENTIAL_MINDLIN_RESCALE)
TANGENTIAL(mindlin_rescale_force, TS_TANGENTIAL_MINDLIN_RESCALE_FORCE)

#define ROLLING(name, law)                           \
	ROLLING_AT(name, law, false, false)          \
	ROLLING_AT(name##_torsion, law, false, true) \
	ROLLING_AT(name##_wall, law, true, false)    \
	ROLLING_AT(name##_wall_torsion, law, true, true)
#define ROLLING_AT(name, law, wall, turns)                                                            \
	STAGE(name, rolling_at, ts_granular_rolling_at(m), wall, .rolling = (law), .plane = m->plane, \
	      .torsion = (turns))
ROLLING(no_rolling, TS_ROLLING_OFF)
ROLLING(cdt, TS_ROLLING_CDT)
ROLLING(epsd, TS_ROLLING_EPSD)
ROLLING(epsd2, TS_ROLLING_EPSD2)
ROLLING(epsd3, TS_ROLLING_EPSD3)
ROLLING(sds, TS_ROLLING_SDS)

#define TWISTING(name, law) STAGE(name, twisting_at, ts_granular_twist_at(m), false, .twisting = (law))
TWISTING(twist_sds, TS_TWISTING_SDS)
TWISTING(twist_marshall, TS_TWISTING_MARSHALL)

static stage_fn *const normals[TS_NNORMAL] = {
	[TS_NORMAL_SPRING] = spring,
	[TS_NORMAL_HOOKE] = hooke,
	[TS_NORMAL_HERTZ] = hertz,
	[TS_NORMAL_HOOKE_STIFFNESS] = hooke_stiffness,
	[TS_NORMAL_HOOKE_MODULUS] = hooke_modulus,
	[TS_NORMAL_HERTZ_STIFFNESS] = hertz_stiffness,
	[TS_NORMAL_HOOKE_HYSTERESIS] = hooke_hysteresis,
	[TS_NORMAL_AREA_HOOKE] = area_hooke,
	[TS_NORMAL_AREA_HERTZ] = area_hertz,
	[TS_NORMAL_AREA_DMT] = area_dmt,
	[TS_NORMAL_AREA_JKR] = area_jkr,
};
typedef void solve_fn(struct ts_stages *s, size_t n, const struct ts_granular_pair *law);
static solve_fn *const solvers[TS_NNORMAL] = {
	[TS_NORMAL_HOOKE] = solve_hooke,
	[TS_NORMAL_HOOKE_HYSTERESIS] = solve_hooke,
	[TS_NORMAL_AREA_JKR] = solve_jkr,
};
static stage_fn *const cohesions[][2] = {
	[TS_COHESION_SJKR] = { sjkr, sjkr_wall },
	[TS_COHESION_SJKR2] = { sjkr2, sjkr2_wall },
};
static stage_fn *const tangentials[TS_NTANGENTIAL] = {
	[TS_TANGENTIAL_OFF] = no_tangential,
	[TS_TANGENTIAL_HISTORY] = history,
	[TS_TANGENTIAL_NO_HISTORY] = no_history,
	[TS_TANGENTIAL_INCREMENTAL] = incremental,
	[TS_TANGENTIAL_SLIDER] = slider,
	[TS_TANGENTIAL_LINEAR] = linear,
	[TS_TANGENTIAL_MINDLIN] = mindlin,
	[TS_TANGENTIAL_MINDLIN_FORCE] = mindlin_force,
	[TS_TANGENTIAL_MINDLIN_RESCALE] = mindlin_rescale,
	[TS_TANGENTIAL_MINDLIN_RESCALE_FORCE] = mindlin_rescale_force,
};
#define OF(name)                                         \
	{                                                \
		{ name, name##_torsion },                \
		{                                        \
			name##_wall, name##_wall_torsion \
		}                                        \
	}
static stage_fn *const rollings[][2][2] = {
	[TS_ROLLING_OFF] = OF(no_rolling), [TS_ROLLING_CDT] = OF(cdt),	   [TS_ROLLING_EPSD] = OF(epsd),
	[TS_ROLLING_EPSD2] = OF(epsd2),	   [TS_ROLLING_EPSD3] = OF(epsd3), [TS_ROLLING_SDS] = OF(sds),
};
static stage_fn *const twistings[] = {
	[TS_TWISTING_SDS] = twist_sds, [TS_TWISTING_MARSHALL] = twist_marshall
};

bool ts_stages_for(const struct ts_granular_model *m)
{
	return normals[m->normal] && !m->fades && !m->viscous && !m->multi && !ts_cohesion_bridges(m);
}

void ts_stages_compute(struct ts_stages *s, size_t n, const struct ts_granular_model *m,
		       const struct ts_granular_pair *law, double dt)
{
	struct ts_substep_columns located; /* only if m->located */

	if (solvers[m->normal])
		solvers[m->normal](s, n, law);
	normals[m->normal](s, n, m, law, dt);
	if (ts_normal_sticks(m))
		mark_met(s, n, s->memory[ts_granular_met_at(m)]);
	if (m->located)
		ts_substep_stage(s, n, m, dt, &located);
	if (m->cohesion)
		cohesions[m->cohesion][s->wall](s, n, m, law, dt);
	tangentials[m->tangential](s, n, m, law, dt);
	if (m->located && m->tangential != TS_TANGENTIAL_OFF)
		ts_substep_stage_slip_targets(s, n, m, dt, &located);
	rollings[m->rolling][s->wall][m->torsion](s, n, m, law, dt);
	if (m->twisting)
		twistings[m->twisting](s, n, m, law, dt);
}
