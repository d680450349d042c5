/* Samples of a mixture, and the statistics of the concentration of a component in them.
 *
 * With the weights w_i of the particles (1, mass or volume), sample k has the size W_k = sum w_i and the
 * concentration c_k = sum_component w_i / W_k; the mean is p = sum W_k c_k / sum W_k. Samples count by their size:
 *
 *     s^2   = sum W_k (c_k - p)^2 / sum W_k
 *     s_0^2 = p (1 - p)                                     completely segregated: all samples are pure
 *     s_r^2 = (K - 1)/(N - 1) sum_i w_i^2 (b_i - p)^2 / (N wbar^2)     completely random
 *
 * for N particles in K samples, b_i = 1 for the component and 0 for the rest, and wbar the mean of w_i. s_r^2 is the
 * expectation of s^2 over all ways to exchange particles: for w_i = 1 exactly (sampling without replacement), (K - 1)/
 * (N - 1) p (1 - p), which is p (1 - p)/n for many samples of n particles (Lacey 1954); else to first order in 1/n,
 * where it is that of Stange (1954) and Poole, Taylor & Wall (1964), p q (p w_q + q w_p)/W with the effective weights
 * w_p = sum w^2/sum w of the particles of the component and w_q of the rest. */
#ifndef TS_BED_MIXING_SAMPLES_H
#define TS_BED_MIXING_SAMPLES_H

#include "bed/component.h"
#include "particle/weight.h"

/* One particle and its sample; sorted by sample, then by id of the particle. */
struct ts_mixing_member {
	double key[3]; /* number of the chunk, or indices of the cell */
	int32_t tag, row;
};

struct ts_mixing_sample {
	size_t particles;
	double weight, concentration; /* W_k, c_k */
	double key[3];
};

struct ts_mixing_statistics {
	double mean, variance, segregated, random; /* p, s^2, s_0^2, s_r^2 */
	size_t samples, particles;		   /* K, N */
	bool defined;				   /* 0 <= s_r^2 < s_0^2: two components, 1 < K < N */
};

/* Sorts members by key and id. */
void ts_mixing_sort(struct ts_mixing_member *member, size_t n);
/* Tallies sorted members into samples, and samples of at least `least` particles into statistics. `sample` has room for
 * n samples; *nsamples is their number. */
void ts_mixing_tally(const struct ts_component *component, enum ts_weight weight,
		     const struct ts_mixing_member *member, size_t n, size_t least,
		     struct ts_mixing_sample *sample, size_t *nsamples, struct ts_mixing_statistics *out);

#endif
