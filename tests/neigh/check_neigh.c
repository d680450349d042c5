/* Contact rows against brute force over all pairs and images; history; order of particles. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "deck.h"

#include "box/domain.h"
#include "math/rng.h"
#include "neigh/contact_memory.h"
#include "neigh/neigh.h"
#include "particle/columns.h"
#include "particle/exchange.h"
#include "particle/particles.h"

enum { N = 140 };
static const double stiffness = 2385.0;

/* A random cloud; radii between 1/ratio and 1 times `large`, as many small as large in logarithm.
 */
struct cloud {
	int periodic; /* bits of the dimensions */
	double ratio, large, length[3];
	double speed;
};

static struct tsim *make_cloud(const struct cloud *c, uint64_t seed)
{
	struct tsim *sim = deck_open("units si\n"
				     "boundary %c %c %c\n"
				     "region box block 0 %g -0.3 %g 0.2 %g units box\n"
				     "create_box 2 box\n"
				     "create_atoms 1 random %d %d NULL\n"
				     "pair_style spring/dashpot\n"
				     "pair_coeff * * stiffness %g restitution 1.0\n"
				     "fix move all nve\n"
				     "timestep 1e-5\n",
				     c->periodic & 1 ? 'p' : 's', c->periodic & 2 ? 'p' : 's',
				     c->periodic & 4 ? 'p' : 's', c->length[0], c->length[1] - 0.3,
				     c->length[2] + 0.2, N, (int)seed + 10007, stiffness);
	struct ts_particles *p = sim->particles;
	struct ts_rng rng = ts_rng_start(seed, 77);

	for (size_t i = 0; i < p->n; i++) {
		p->radius[i] = c->large * pow(c->ratio, -ts_rng_uniform(&rng));
		p->mass[i] = 4000 * pow(p->radius[i], 3);
		for (int k = 0; k < 3; k++)
			p->v[i][k] = c->speed * (2 * ts_rng_uniform(&rng) - 1);
	}
	p->radius[0] = c->large; /* the box is just long enough for the largest */
	return sim;
}

/* Numbers of touching images of each pair (a <= b), and forces, all by identity. */
struct contacts {
	int count[N + 1][N + 1];
	double force[N + 1][3];
	int total;
};

static void add_image(const struct ts_particles *p, size_t i, size_t j, const double shift[3],
		      struct contacts *c)
{
	double d[3], d2 = 0, sum = p->radius[i] + p->radius[j], f;

	for (int k = 0; k < 3; k++) {
		d[k] = p->x[i][k] - (p->x[j][k] + shift[k]);
		d2 += d[k] * d[k];
	}
	if (!(d2 < sum * sum))
		return;
	f = stiffness * (sum - sqrt(d2)) / sqrt(d2);
	for (int k = 0; k < 3; k++) {
		c->force[p->tag[i]][k] += f * d[k];
		c->force[p->tag[j]][k] -= f * d[k];
	}
	c->count[p->tag[i]][p->tag[j]]++;
	if (i != j)
		c->count[p->tag[j]][p->tag[i]]++;
	c->total++;
}

/* Particles may lie outside the box by half a skin: two boxes each way. */
static void brute_force(const struct tsim *sim, struct contacts *c)
{
	const struct ts_particles *p = sim->particles;
	const struct ts_box *box = &sim->domain->box;
	int most[3];

	memset(c, 0, sizeof *c);
	for (int k = 0; k < 3; k++)
		most[k] = ts_box_periodic(box, k) ? 2 : 0;
	for (size_t i = 0; i < p->n; i++)
		for (size_t j = i; j < p->n; j++)
			for (int a = -most[0]; a <= most[0]; a++)
				for (int b = -most[1]; b <= most[1]; b++)
					for (int g = -most[2]; g <= most[2]; g++) {
						double shift[3] = { a * ts_box_length(box, 0),
								    b * ts_box_length(box, 1),
								    g * ts_box_length(box, 2) };

						if (i == j && 9 * a + 3 * b + g <= 0)
							continue;
						add_image(p, i, j, shift, c);
					}
}

static void from_rows(const struct tsim *sim, struct contacts *c)
{
	const struct ts_contact_list *rows = &sim->neigh->contacts;
	const struct ts_particles *p = sim->particles;

	memset(c, 0, sizeof *c);
	for (size_t r = 0; r < rows->n; r++) {
		int a = ts_contact_tag(rows, r, 0), b = ts_contact_tag(rows, r, 1);
		bool ghost = (size_t)rows->j[r] >= p->n;

		/* asserting is dear: only what is wrong */
		if (p->tag[rows->i[r]] != a || p->tag[rows->j[r]] != b ||
		    (!ghost && ts_contact_image(rows, r) != TS_IMAGE_SELF))
			ck_abort_msg("row %zu does not fit the particles", r);
		if (!ts_contact_touches(rows, r))
			continue;
		c->count[a][b]++;
		if (!ghost)
			c->count[b][a]++;
	}
	for (int a = 1; a <= N; a++) { /* an image of oneself has a row on either side */
		if (c->count[a][a] % 2)
			ck_abort_msg("particle %d meets an image on one side only", a);
		c->count[a][a] /= 2;
	}
	for (size_t i = 0; i < p->n; i++)
		memcpy(c->force[p->tag[i]], p->f[i], sizeof p->f[i]);
}

/* Every touching pair has its row, no other row touches, and, where nothing else acts, forces are
 * the sum over all pairs. */
static int compare(const struct tsim *sim, bool forces)
{
	static struct contacts truth, found;
	double scale = 0;

	brute_force(sim, &truth);
	from_rows(sim, &found);
	for (int a = 1; a <= N; a++)
		for (int b = 1; b <= N; b++)
			if (found.count[a][b] != truth.count[a][b])
				ck_abort_msg("step %d: particles %d and %d have %d contacts, rows show %d",
					     (int)sim->clock.step, a, b, truth.count[a][b],
					     found.count[a][b]);
	for (int a = 1; a <= N; a++)
		for (int k = 0; k < 3; k++)
			scale = fmax(scale, fabs(truth.force[a][k]));
	for (int a = 1; forces && a <= N; a++)
		for (int k = 0; k < 3; k++)
			if (!(fabs(found.force[a][k] - truth.force[a][k]) <= 1e-12 * scale))
				ck_abort_msg("force %d of %d is %.17g, should be %.17g", k, a,
					     found.force[a][k], truth.force[a][k]);
	return truth.total;
}

static const double ratios[] = { 1, 10, 30 };

/* All combinations of periodic faces and radii, in boxes as short as the program accepts them. */
START_TEST(clouds)
{
	int contacts = 0;

	for (int periodic = 0; periodic < 8; periodic++) {
		struct cloud c = { periodic, ratios[_i], 0.135, { 1.1, 0.7, 0.9 }, 0 };
		struct tsim *sim = make_cloud(&c, (uint64_t)(8 * _i + periodic));

		deck(sim, "timestep 1e-9\nrun 0");
		contacts += compare(sim, true);
		deck(sim, "neighbor 0.013 bin\ntimestep 2e-9\nrun 0");
		compare(sim, true);
		tsim_close(sim);
	}
	ck_assert_int_gt(contacts, 300);
}
END_TEST

/* The largest particles just fit: 2 r + skin = 0.97 of the shortest side, so some pairs touch
 * through two faces at once. */
START_TEST(shortest_box)
{
	struct cloud c = { 7, 10, 0.24, { 0.5, 0.53, 0.51 }, 0 };
	struct tsim *sim = make_cloud(&c, (uint64_t)_i);

	deck(sim, "neighbor 0.005 bin\ntimestep 1e-9\nrun 0");
	ck_assert_int_gt(compare(sim, true), N);
	deck(sim, "neighbor 0.05 bin");
	ck_assert(!deck_accepts(sim, "run 0"));
	ck_assert_ptr_nonnull(strstr(tsim_error(sim), "the periodic box is 0.5 long"));
	tsim_close(sim);
}
END_TEST

/* A fast gas: the contacts are checked in every step, over many rebuilds and passages of the faces.
 */
START_TEST(gas)
{
	static const int faces[] = { 0, 1, 6, 7 };
	struct cloud c = { faces[_i % 4], _i < 4 ? 10 : 1, 0.071, { 0.9, 0.65, 0.71 }, 21 };
	struct tsim *sim = make_cloud(&c, (uint64_t)(100 + _i));
	int contacts = 0, builds = 0;

	/* without periodic faces a wall keeps the cloud together */
	for (int k = 0; k < 3; k++)
		if (!(c.periodic >> k & 1))
			deck(sim,
			     "fix lo%d all wall/gran primitive type 1 %cplane %g\n"
			     "fix hi%d all wall/gran primitive type 1 %cplane %g",
			     k, 'x' + k, (double[]){ 0, -0.3, 0.2 }[k], k, 'x' + k,
			     c.length[k] + (double[]){ 0, -0.3, 0.2 }[k]);
	deck(sim, "timestep 1e-5\nneighbor %g bin", _i % 2 ? 0.004 : 0.02);
	deck(sim, "pair_coeff * * stiffness %g restitution 1.0", stiffness);
	/* overlaps of the random start are let go slowly */
	deck(sim, "fix slow all viscous 0.3\nrun 800 post no\nunfix slow");
	for (size_t i = 0; i < sim->particles->n; i++)
		for (int k = 0; k < 3; k++)
			sim->particles->v[i][k] = c.speed * sin((double)sim->particles->tag[i] * (k + 1.3));
	for (int step = 0; step < 400; step++) {
		deck(sim, "run 1 post no");
		builds += (int)sim->neigh->builds - 1;
		if (step % 4 == 0) /* the brute force is the dear part */
			contacts += compare(sim, c.periodic == 7);
	}
	ck_assert_int_gt(contacts, 1000);
	ck_assert_int_gt(builds, 10);
	tsim_close(sim);
}
END_TEST

/* ---- history */

static double label(int a, int b)
{
	return a < b ? 1000 * a + b : 1000 * b + a;
}

static const signed char sign[] = { 1, -1 };

static void rebuild(struct tsim *sim)
{
	struct ts_particles *p = sim->particles;

	ck_assert_int_eq(ts_exchange_migrate(sim), TS_OK);
	ts_particles_inverse_mass(p);
	memcpy(p->xhold, p->x, p->n * sizeof *p->xhold);
	ck_assert_int_eq(ts_exchange_borders(sim, 0.4, 0.4, 0.4), TS_OK);
	ck_assert_int_eq(ts_contact_list_build(sim, &sim->neigh->contacts, 0.05, NULL), TS_OK);
}

/* Marks rows and their history: a label of the pair, and one that changes sign with the view. */
static int mark(struct tsim *sim)
{
	struct ts_contact_list *rows = &sim->neigh->contacts;
	int marked = 0;

	for (size_t r = 0; r < rows->n; r++) {
		int a = ts_contact_tag(rows, r, 0), b = ts_contact_tag(rows, r, 1);

		ts_contact_set_touching(rows, r, (a + b) % 3 != 0);
		marked += ts_contact_touches(rows, r);
	}
	ts_contacts_note_history(sim, rows);
	for (size_t r = 0; r < rows->n; r++) {
		int a = ts_contact_tag(rows, r, 0), b = ts_contact_tag(rows, r, 1);

		if (!ts_contact_touches(rows, r))
			continue;
		ts_contact_history(rows, r)[0] = label(a, b);
		ts_contact_history(rows, r)[1] = (a < b ? 1 : -1) * label(a, b);
	}
	ck_assert_uint_eq(ts_contacts_with_history(rows), (size_t)marked);
	return marked;
}

static void check_marks(const struct tsim *sim, int marked)
{
	const struct ts_contact_list *rows = &sim->neigh->contacts;

	for (size_t r = 0; r < rows->n; r++) {
		int a = ts_contact_tag(rows, r, 0), b = ts_contact_tag(rows, r, 1);
		double expected = (a + b) % 3 != 0 ? label(a, b) : 0;

		if (a == b)
			continue;
		ck_assert_int_eq(ts_contact_touches(rows, r), (a + b) % 3 != 0);
		ck_assert_double_eq(ts_contact_history(rows, r)[0], expected);
		ck_assert_double_eq(ts_contact_history(rows, r)[1], (a < b ? 1 : -1) * expected);
		marked -= ts_contact_touches(rows, r);
	}
	ck_assert_int_eq(marked, 0);
}

static void shuffle(struct tsim *sim, uint64_t seed)
{
	struct ts_rng rng = ts_rng_start(seed, 5);
	int32_t order[N];
	int n = (int)sim->particles->n;

	for (int i = 0; i < n; i++)
		order[i] = i;
	for (int i = n - 1; i > 0; i--) {
		int j = (int)(ts_rng_uniform(&rng) * (i + 1));
		int32_t t = order[i];

		order[i] = order[j];
		order[j] = t;
	}
	ck_assert_int_eq(ts_particles_reorder(sim, order), TS_OK);
}

START_TEST(history)
{
	struct cloud c = { _i, 10, 0.135, { 1.1, 0.9, 0.97 }, 0 };
	struct tsim *sim = make_cloud(&c, (uint64_t)(200 + _i));
	struct ts_particles *p = sim->particles;
	int marked;

	deck(sim, "timestep 1e-9\nrun 0");
	ck_assert_int_eq(ts_contact_list_set_history(sim, &sim->neigh->contacts, 2, sign), TS_OK);
	rebuild(sim);
	marked = mark(sim);
	ck_assert_int_gt(marked, 50);
	for (int turn = 0; turn < 4; turn++) {
		shuffle(sim, (uint64_t)turn); /* who owns a row changes with it */
		rebuild(sim);
		check_marks(sim, marked);
	}
	/* All move together, through periodic faces too. Which image of a partner is seen changes
	 * with the wrapping, the pair does not. */
	for (int turn = 0; turn < 3 && _i == 0; turn++) {
		for (size_t i = 0; i < p->n; i++)
			p->x[i][turn] += 0.237;
		shuffle(sim, 31 + (uint64_t)turn);
		rebuild(sim);
		check_marks(sim, marked);
	}
	tsim_close(sim);
}
END_TEST

/* A contact is carried over while its partners pass a periodic face, one after the other. */
START_TEST(history_through_face)
{
	struct tsim *sim = deck_open("units si\nboundary p p p\n"
				     "region box block 0 1.3 0 1.2 0 1.1 units box\n"
				     "create_box 1 box\n"
				     "create_atoms 1 single 1.21 0.6 0.5 units box\n"
				     "create_atoms 1 single 1.03 0.6 0.5 units box\n"
				     "set group all diameter 0.2 density 1000\n"
				     "pair_style spring/dashpot\n"
				     "pair_coeff * * stiffness 100 restitution 0.5\n"
				     "timestep 1e-5\nrun 0");
	struct ts_contact_list *rows = &sim->neigh->contacts;

	ck_assert_int_eq(ts_contact_list_set_history(sim, rows, 2, sign), TS_OK);
	rebuild(sim);
	ck_assert_int_eq(mark(sim), 0); /* 1 + 2 is not marked: do it by hand */
	ck_assert_uint_eq(rows->n, 1);
	for (size_t r = 0; r < rows->n; r++) {
		ts_contact_set_touching(rows, r, true);
		ts_contacts_note_history(sim, rows);
		ts_contact_history(rows, r)[0] = 23.85;
		ts_contact_history(rows, r)[1] = ts_contact_tag(rows, r, 0) == 1 ? 3.7 : -3.7;
	}
	for (int step = 0; step < 30; step++) {
		for (size_t i = 0; i < 2; i++)
			sim->particles->x[i][0] += 0.0137;
		rebuild(sim);
		ck_assert_uint_ge(rows->n, 1);
		for (size_t r = 0; r < rows->n; r++) {
			ck_assert_msg(ts_contact_touches(rows, r), "lost at step %d", step);
			ck_assert_double_eq(ts_contact_history(rows, r)[0], 23.85);
			ck_assert_double_eq(ts_contact_history(rows, r)[1],
					    ts_contact_tag(rows, r, 0) == 1 ? 3.7 : -3.7);
		}
	}
	ck_assert_int_eq(sim->particles->image[0][0] + sim->particles->image[1][0], 2);
	tsim_close(sim);
}
END_TEST

/* ---- order in memory */

static void by_tag(const struct ts_particles *p, double (*column)[3], double out[N][3])
{
	for (size_t i = 0; i < p->n; i++)
		memcpy(out[p->tag[i] - 1], column[i], sizeof out[0]);
}

/* The same bits whatever the order of the particles in memory. */
START_TEST(order)
{
	static double x[2][N][3], v[2][N][3], f[2][N][3];
	struct cloud c = { _i, 10, 0.121, { 1.1, 0.8, 0.9 }, 3.1 };

	for (int turn = 0; turn < 2; turn++) {
		struct tsim *sim = make_cloud(&c, (uint64_t)(300 + _i));

		deck(sim, "compute nc all contacts\n"
			  "pair_coeff * * stiffness 238.5 restitution 0.7\ntimestep 2e-6");
		if (turn)
			shuffle(sim, 9);
		deck(sim, "run 100");
		ck_assert_double_gt(deck_value(sim, "c_nc"), 20);
		by_tag(sim->particles, sim->particles->x, x[turn]);
		by_tag(sim->particles, sim->particles->v, v[turn]);
		by_tag(sim->particles, sim->particles->f, f[turn]);
		tsim_close(sim);
	}
	ck_assert_mem_eq(x[0], x[1], sizeof x[0]);
	ck_assert_mem_eq(v[0], v[1], sizeof v[0]);
	ck_assert_mem_eq(f[0], f[1], sizeof f[0]);
}
END_TEST

/* neigh_modify exclude: no force, no row; frozen pairs have no row either. */
START_TEST(left_out)
{
	struct tsim *sim = deck_open("units si\nboundary s s s\n"
				     "region box block 0 1 0 1 0 1 units box\n"
				     "create_box 2 box\n"
				     "create_atoms 1 single 0.5 0.5 0.5 units box\n"
				     "create_atoms 1 single 0.57 0.5 0.5 units box\n"
				     "create_atoms 2 single 0.5 0.57 0.5 units box\n"
				     "set group all diameter 0.11 density 1000\n"
				     "pair_style spring/dashpot\n"
				     "pair_coeff * * stiffness 100 restitution 0.5\n"
				     "compute nc all contacts\n"
				     "timestep 1e-5\nrun 0");

	/* the third pair is sqrt(2) 0.07 = 0.099 apart: it touches as well */
	ck_assert_double_eq(deck_value(sim, "c_nc"), 3);
	deck(sim, "neigh_modify exclude type 1 2\nrun 0");
	ck_assert_double_eq(deck_value(sim, "c_nc"), 1);
	deck(sim, "group one type 1\nfix still one freeze\nrun 0");
	ck_assert_double_eq(deck_value(sim, "c_nc"), 0);
	tsim_close(sim);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("neigh");
	TCase *rows = tcase_create("rows"), *kept = tcase_create("history");

	tcase_set_timeout(rows, 60);
	tcase_add_loop_test(rows, clouds, 0, (int)DECK_LENGTH(ratios));
	tcase_add_loop_test(rows, shortest_box, 0, 3);
	tcase_add_loop_test(rows, gas, 0, 8);
	tcase_add_loop_test(rows, order, 0, 8);
	tcase_add_test(rows, left_out);
	tcase_add_loop_test(kept, history, 0, 8);
	tcase_add_test(kept, history_through_face);
	suite_add_tcase(suite, rows);
	suite_add_tcase(suite, kept);
	return deck_main(suite);
}
