/* The loop over bonds that transmit moments, a row of eight bonds at a time. */
#include "base/clones.h"
TS_UNROLLED

#include "bond/bond_loop.h"
#include "bond/bond_moment.h"
#include "bond/bond_shares.h"
#include "law/bond_softening.h"

#include "base/banned.h"

/* ROWS: that are loaded, computed and stored together. Loads of eight numbers that follow stores of four too
 * closely would wait for these. */
enum { LANES = TS_BOND_ROW_LANES, ROWS = 4 };

/* Both ends of the bonds of a row: differences second minus first partner, and states of both. */
struct row {
	double d[3][LANES], v[3][LANES];
	double q[2][4][LANES], omega[2][4][LANES];
	double force[3][LANES], torque[2][3][LANES]; /* force on the second partner */
	double axial[LANES], holds[LANES];
	double reached[LANES], release[LANES], lost[LANES]; /* of bonds that soften */
} __attribute__((aligned(64)));

/* ---- inputs */

/* Of eight particles; to[3] is undefined if these are vectors of three. */
TS_INLINE void load_columns(const double *x, size_t width, const int32_t *particle, double (*to)[LANES])
{
	for (size_t half = 0; half < 2; half++) {
		ts_four column[4];

		for (size_t k = 0; k < 4; k++)
			column[k] = TS_FOUR_LOAD(x + width * (size_t)particle[4 * half + k]);
		ts_four_transpose(column);
		for (size_t c = 0; c < width; c++)
			*(ts_four *)&to[c][4 * half] = column[c];
	}
}

/* x of the second partners minus that of the first. */
TS_INLINE void load_differences(const double (*x)[3], const struct ts_bond_row *l, double (*to)[LANES])
{
	for (size_t half = 0; half < 2; half++) {
		ts_four d[4];

		for (size_t k = 0; k < 4; k++)
			d[k] = TS_FOUR_LOAD(x[l->particle[1][4 * half + k]]) -
			       TS_FOUR_LOAD(x[l->particle[0][4 * half + k]]);
		ts_four_transpose(d);
		for (int c = 0; c < 3; c++)
			*(ts_four *)&to[c][4 * half] = d[c];
	}
}

TS_INLINE void load_row(const struct ts_bond_task *t, const struct ts_bond_row *l, bool moving, struct row *r)
{
	load_differences((const double(*)[3])t->p->x, l, r->d);
	for (int s = 0; s < 2; s++)
		load_columns(t->orientation[0], 4, l->particle[s], r->q[s]);
	if (!moving)
		return;
	load_differences((const double(*)[3])t->p->v, l, r->v);
	if (t->drift)
		ts_bond_add_drifts(t, l->particle[1], l->particle[0], r->d, r->v);
	for (int s = 0; s < 2; s++)
		load_columns(t->p->omega[0], 3, l->particle[s], r->omega[s]);
}

TS_INLINE void apply_nearest_image(const struct ts_box *box, struct row *r)
{
	for (int c = 0; c < 3; c++) {
		double length = ts_box_length(box, c);

		if (!ts_box_periodic(box, c))
			continue;
#pragma omp simd
		for (size_t k = 0; k < LANES; k++)
			r->d[c][k] -= length * rint(r->d[c][k] / length);
	}
}

/* ---- the law */

/* Which parts of the law the bonds need. */
struct parts {
	bool moving, softens;
};

TS_INLINE void ends_of(const struct row *r, const struct ts_bond_row *l, size_t k, bool moving,
		       struct ts_bond_ends *s)
{
	s->d = (struct ts_xyz){ r->d[0][k], r->d[1][k], r->d[2][k] };
	for (int p = 0; p < 2; p++)
		s->q[p] = ts_wxyz_product((struct ts_wxyz){ r->q[p][0][k], r->q[p][1][k], r->q[p][2][k],
							    r->q[p][3][k] },
					  (struct ts_wxyz){ l->frame[p][0][k], l->frame[p][1][k],
							    l->frame[p][2][k], l->frame[p][3][k] });
	if (!moving)
		return;
	s->v = (struct ts_xyz){ r->v[0][k], r->v[1][k], r->v[2][k] };
	for (int p = 0; p < 2; p++)
		s->omega[p] = (struct ts_xyz){ r->omega[p][0][k], r->omega[p][1][k], r->omega[p][2][k] };
}

/* The damage of the bond of lane k, if it holds, and its forces. */
TS_INLINE void soften(struct row *r, const struct ts_bond_softening *soft, size_t k, bool holds,
		      struct ts_bond_element *e, const struct ts_bond_ends *s, struct ts_bond_answer *a)
{
	const struct ts_bond_damage before = { soft->reached[k], soft->release[k] };
	double lost, intact;
	const struct ts_bond_damage now = ts_bond_crack(e, before, a, &lost);

	r->reached[k] = holds ? now.reached : before.reached;
	r->release[k] = holds ? now.release : before.release;
	r->lost[k] = holds ? lost : 0;
	intact = ts_bond_intact(e->rupture, r->reached[k]);
	ts_bond_soften(intact, s, a);
	for (int m = 0; m < TS_BOND_MODES; m++)
		e->c[m] *= intact;
}

TS_INLINE long evaluate(struct row *r, const struct ts_bond_row *l, const struct ts_bond_sections *c,
			const struct ts_bond_dashpots *dashpots, const struct ts_bond_softening *soft,
			size_t k, struct parts with)
{
	const bool moving = with.moving, softens = with.softens;
	struct ts_bond_element e = { .length = l->length[k],
				     .fraction = l->fraction[k],
				     .k = { c->k[0][k], c->k[1][k], c->k[2][k], c->k[3][k] },
				     .c = { moving ? dashpots->c[0][k] : 0, moving ? dashpots->c[1][k] : 0,
					    moving ? dashpots->c[2][k] : 0, moving ? dashpots->c[3][k] : 0 },
				     .per_area = c->per_area[k],
				     .per_moment = c->per_moment[k],
				     .per_torque = c->per_torque[k],
				     .lever = c->lever[k],
				     .tension = c->tension[k],
				     .shear = c->shear[k],
				     .compression = c->compression[k],
				     .onset = softens ? soft->onset[k] : 0,
				     .rupture = softens ? soft->rupture[k] : 0,
				     .shear_rupture = softens ? soft->shear_rupture[k] : 0,
				     .friction = softens ? soft->friction[k] : 0 };
	struct ts_bond_ends s;
	struct ts_bond_answer a;
	bool holds;
	double whole;

	ends_of(r, l, k, moving, &s);
	ts_bond_elastic(&e, &s, &a);
	ts_bond_stress(&e, &a);
	if (softens)
		ts_bond_rub(ts_bond_intact(e.rupture, soft->reached[k]), &a, &e);
	holds = ts_bond_holds(&e, &a);
	if (softens)
		soften(r, soft, k, holds, &e, &s, &a);
	if (moving)
		ts_bond_viscous(&e, &s, &a);
	whole = holds ? 1 : 0;
	r->axial[k] = holds ? a.axial : a.load[TS_BOND_NORMAL];
	r->holds[k] = whole;
	r->force[0][k] = whole * a.force.x;
	r->force[1][k] = whole * a.force.y;
	r->force[2][k] = whole * a.force.z;
	for (int p = 0; p < 2; p++) {
		r->torque[p][0][k] = whole * a.torque[p].x;
		r->torque[p][1][k] = whole * a.torque[p].y;
		r->torque[p][2][k] = whole * a.torque[p].z;
	}
	return !holds;
}

TS_INLINE long evaluate_row(struct row *restrict r, const struct ts_bond_row *restrict l,
			    const struct ts_bond_sections *restrict c,
			    const struct ts_bond_dashpots *restrict dashpots,
			    const struct ts_bond_softening *restrict soft, struct parts with)
{
	long broken = 0;

#pragma omp simd reduction(+ : broken)
	for (size_t k = 0; k < LANES; k++)
		broken += evaluate(r, l, c, dashpots, soft, k, with);
	return broken;
}

/* ---- results */

TS_INLINE void store_columns(double (*from)[LANES], size_t half, ts_four to[4])
{
	for (int c = 0; c < 3; c++)
		to[c] = *(const ts_four *)&from[c][4 * half];
	to[3] = (ts_four){ 0 };
	ts_four_transpose(to);
}

TS_INLINE void store_results(struct row *r, const uint32_t *slot, struct ts_bond_result *result)
{
	for (size_t half = 0; half < 2; half++) {
		ts_four force[4], torque[2][4];

		store_columns(r->force, half, force);
		for (int s = 0; s < 2; s++)
			store_columns(r->torque[s], half, torque[s]);
		for (size_t k = 0; k < 4; k++) {
			struct ts_bond_result *to = &result[slot[4 * half + k]];

			*(ts_four *)to->force = force[k];
			for (int s = 0; s < 2; s++)
				*(ts_four *)to->torque[s] = torque[s][k];
		}
	}
}

/* Loads, tensions and breakage; bonds to particles before `begin` are stored by another share. */
static void store_loads(const struct row *r, const struct ts_bond_row *l, size_t begin,
			struct ts_bonds *bonds)
{
	for (size_t k = 0; k < LANES; k++) {
		size_t b = l->bond[k];

		if (l->bond[k] == TS_BOND_NONE || (size_t)l->particle[0][k] < begin ||
		    (size_t)l->particle[1][k] < begin)
			continue;
		for (int c = 0; c < 3; c++) {
			bonds->load[b].force[c] = -r->force[c][k];
			for (int s = 0; s < 2; s++)
				bonds->load[b].torque[s][c] = r->torque[s][c][k];
		}
		bonds->tension[b] = r->axial[k];
		bonds->breaks[b] = r->holds[k] == 0;
	}
}

/* Damage that has changed; in the lists of bonds by the share that stores their loads. */
static void store_damage(const struct row *r, const struct ts_bond_row *l, struct ts_bond_softening *soft,
			 size_t begin, struct ts_bonds *bonds)
{
	for (size_t k = 0; k < LANES; k++) {
		size_t b = l->bond[k];

		if (r->reached[k] == soft->reached[k] && r->release[k] == soft->release[k])
			continue;
		soft->reached[k] = r->reached[k];
		soft->release[k] = r->release[k];
		if ((size_t)l->particle[0][k] < begin || (size_t)l->particle[1][k] < begin)
			continue;
		bonds->damage[b] = (struct ts_bond_damage){ r->reached[k], r->release[k] };
		bonds->lost[b] = r->lost[k];
	}
}

/* ---- the loop */

/* Rows from .. from + n - 1, n at most ROWS, of the share whose first particle is `begin`. */
TS_INLINE long compute_rows(const struct ts_bond_task *t, size_t from, size_t n, size_t begin,
			    struct parts with)
{
	const struct ts_bond_rows *rows = &t->bonds->rows;
	const struct ts_bond_row *l = rows->row + from;
	struct row r[ROWS];
	long broken = 0;

	for (size_t k = 0; k < n; k++)
		load_row(t, &l[k], with.moving, &r[k]);
	for (size_t k = 0; k < n; k++) {
		apply_nearest_image(t->box, &r[k]);
		broken += evaluate_row(&r[k], &l[k], &rows->sections[rows->sections_of[from + k]],
				       with.moving ? &rows->dashpots[from + k] : NULL,
				       with.softens ? &rows->soft[from + k] : NULL, with);
	}
	for (size_t k = 0; k < n; k++)
		store_results(&r[k], l[k].slot, rows->result);
	for (size_t k = 0; (broken || t->store) && k < n; k++)
		store_loads(&r[k], &l[k], begin, t->bonds);
	for (size_t k = 0; with.softens && k < n; k++)
		store_damage(&r[k], &l[k], &rows->soft[from + k], begin, t->bonds);
	return broken;
}

TS_INLINE long compute_moving(const struct ts_bond_task *t, size_t from, size_t n, size_t begin)
{
	return compute_rows(t, from, n, begin, (struct parts){ .moving = true });
}

TS_INLINE long compute_undamped(const struct ts_bond_task *t, size_t from, size_t n, size_t begin)
{
	return compute_rows(t, from, n, begin, (struct parts){ .moving = false });
}

TS_INLINE long compute_softening(const struct ts_bond_task *t, size_t from, size_t n, size_t begin)
{
	return compute_rows(t, from, n, begin, (struct parts){ .softens = true });
}

TS_INLINE long compute_softening_moving(const struct ts_bond_task *t, size_t from, size_t n, size_t begin)
{
	return compute_rows(t, from, n, begin, (struct parts){ .moving = true, .softens = true });
}

TS_CLONES static long compute_shares(void *task, size_t from, size_t to)
{
	const struct ts_bond_task *t = task;
	long broken = 0;

	for (size_t k = from; k < to; k++)
		broken += t->moving ? ts_bond_compute_share(t, k, ROWS, compute_moving)
				    : ts_bond_compute_share(t, k, ROWS, compute_undamped);
	return broken;
}

TS_CLONES static long compute_soft_shares(void *task, size_t from, size_t to)
{
	const struct ts_bond_task *t = task;
	long broken = 0;

	for (size_t k = from; k < to; k++)
		broken += t->moving ? ts_bond_compute_share(t, k, ROWS, compute_softening_moving)
				    : ts_bond_compute_share(t, k, ROWS, compute_softening);
	return broken;
}

long ts_bond_compute_moments(void *task, size_t from, size_t to)
{
	const struct ts_bond_task *t = task;

	return t->softens ? compute_soft_shares(task, from, to) : compute_shares(task, from, to);
}
