#include "base/clones.h"
TS_UNROLLED

#include "math/prince_dormand.h"

#include <string.h>

#include "base/banned.h"

enum { MOST = TS_PRINCE_DORMAND_MOST, STAGES = TS_PRINCE_DORMAND_STAGES };

/* A sum over stages: that of the first one, and those from `from` to `to` - 1; the others have the weight 0. */
struct weights {
	int from, to;
	double of[STAGES];
};

static const struct weights stages[STAGES] = {
	{ 1, 1, { 0 } },
	{ 1, 1, { 1.0 / 18 } },
	{ 1, 2, { 1.0 / 48, 1.0 / 16 } },
	{ 2, 3, { 1.0 / 32, 0, 3.0 / 32 } },
	{ 2, 4, { 5.0 / 16, 0, -75.0 / 64, 75.0 / 64 } },
	{ 3, 5, { 3.0 / 80, 0, 0, 3.0 / 16, 3.0 / 20 } },
	{ 3,
	  6,
	  { 29443841.0 / 614563906, 0, 0, 77736538.0 / 692538347, -28693883.0 / 1125000000,
	    23124283.0 / 1800000000 } },
	{ 3,
	  7,
	  { 16016141.0 / 946692911, 0, 0, 61564180.0 / 158732637, 22789713.0 / 633445777,
	    545815736.0 / 2771057229, -180193667.0 / 1043307555 } },
	{ 3,
	  8,
	  { 39632708.0 / 573591083, 0, 0, -433636366.0 / 683701615, -421739975.0 / 2616292301,
	    100302831.0 / 723423059, 790204164.0 / 839813087, 800635310.0 / 3783071287 } },
	{ 3,
	  9,
	  { 246121993.0 / 1340847787, 0, 0, -37695042795.0 / 15268766246, -309121744.0 / 1061227803,
	    -12992083.0 / 490766935, 6005943493.0 / 2108947869, 393006217.0 / 1396673457,
	    123872331.0 / 1001029789 } },
	{ 3,
	  10,
	  { -1028468189.0 / 846180014, 0, 0, 8478235783.0 / 508512852, 1311729495.0 / 1432422823,
	    -10304129995.0 / 1701304382, -48777925059.0 / 3047939560, 15336726248.0 / 1032824649,
	    -45442868181.0 / 3398467696, 3065993473.0 / 597172653 } },
	{ 3,
	  11,
	  { 185892177.0 / 718116043, 0, 0, -3185094517.0 / 667107341, -477755414.0 / 1098053517,
	    -703635378.0 / 230739211, 5731566787.0 / 1027545527, 5232866602.0 / 850066563,
	    -4093664535.0 / 808688257, 3962137247.0 / 1805957418, 65686358.0 / 487910083 } },
	{ 3,
	  11,
	  { 403863854.0 / 491063109, 0, 0, -5068492393.0 / 434740067, -411421997.0 / 543043805,
	    652783627.0 / 914296604, 11173962825.0 / 925320556, -13158990841.0 / 6184727034,
	    3936647629.0 / 1978049680, -160528059.0 / 685178525, 248638103.0 / 1413531060 } },
};
static const struct weights order_8 = { 5,
					13,
					{ 14005451.0 / 335480064, 0, 0, 0, 0, -59238493.0 / 1068277825,
					  181606767.0 / 758867731, 561292985.0 / 797845732,
					  -1041891430.0 / 1371343529, 760417239.0 / 1151165299,
					  118820643.0 / 751138087, -528747749.0 / 2220607170, 1.0 / 4 } };
/* Order 8 less order 7. */
static const struct weights difference = { 5,
					   13,
					   { 14005451.0 / 335480064 - 13451932.0 / 455176623, 0, 0, 0, 0,
					     -59238493.0 / 1068277825 + 808719846.0 / 976000145,
					     181606767.0 / 758867731 - 1757004468.0 / 5645159321,
					     561292985.0 / 797845732 - 656045339.0 / 265891186,
					     -1041891430.0 / 1371343529 + 3867574721.0 / 1518517206,
					     760417239.0 / 1151165299 - 465885868.0 / 322736535,
					     118820643.0 / 751138087 - 53011238.0 / 667516719,
					     -528747749.0 / 2220607170 - 2.0 / 45, 1.0 / 4 } };

/* out = base + h sum_j w_j k_j; numbers beyond the n of the state are 0. */
TS_CLONES static void combine(const double (*restrict k)[MOST], const struct weights *w, double h,
			      const double *restrict base, double *restrict out)
{
	double sum[MOST];

#pragma omp simd
	for (int i = 0; i < MOST; i++)
		sum[i] = w->of[0] * k[0][i];
	for (int j = w->from; j < w->to; j++)
#pragma omp simd
		for (int i = 0; i < MOST; i++)
			sum[i] += w->of[j] * k[j][i];
#pragma omp simd
	for (int i = 0; i < MOST; i++)
		out[i] = base[i] + h * sum[i];
}

void ts_prince_dormand_start(struct ts_prince_dormand *s, const double *y)
{
	memset(s->y, 0, sizeof s->y);
	memset(s->k, 0, sizeof s->k);
	memcpy(s->y, y, s->n * sizeof *y);
	s->derivative(s->y, s->k[0], s->context);
}

void ts_prince_dormand_step(struct ts_prince_dormand *s, double h, double *to, double *error)
{
	static const double none[MOST];
	const double(*k)[MOST] = (const double(*)[MOST])s->k;
	double at[MOST];

	for (int j = 1; j < STAGES; j++) {
		combine(k, &stages[j], h, s->y, at);
		s->derivative(at, s->k[j], s->context);
	}
	combine(k, &order_8, h, s->y, to);
	combine(k, &difference, h, none, error);
}
