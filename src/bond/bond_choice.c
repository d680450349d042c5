#include "bond/bond_choice.h"

#include "math/rng.h"
#include "particle/particles.h"

#include "base/banned.h"

enum ts_status ts_bond_chance_read(struct tsim *sim, const char *what, struct ts_bond_chance *c)
{
	c->fraction = 1;
	if (!c->words.n)
		return TS_OK;
	if (c->words.n != 2 || !ts_parse_real(c->words.word[0].text, &c->fraction) || !(c->fraction >= 0) ||
	    !(c->fraction <= 1) || !ts_parse_int(c->words.word[1].text, &c->seed) || c->seed < 1)
		return ts_fail(&sim->error, TS_SYNTAX, &c->words.word[0].place,
			       "%s: expected prob FRACTION SEED, a number from 0 to 1 and one above 0", what);
	return TS_OK;
}

/* The same for any number of threads, order of particles, and after a restart. */
static bool takes(const struct tsim *sim, const struct ts_bond_chance *c, const int32_t tag[2])
{
	struct ts_rng rng;

	if (c->fraction >= 1)
		return true;
	rng = ts_rng_start((uint64_t)c->seed + UINT64_C(0x9e3779b97f4a7c15) * (uint64_t)sim->clock.step,
			   (uint64_t)(uint32_t)tag[0] << 32 | (uint32_t)tag[1]);
	return ts_rng_uniform(&rng) < c->fraction;
}

enum ts_status ts_bond_choose(struct tsim *sim, const struct ts_bond_option *option, size_t n,
			      const struct ts_bond_chance *chance, unsigned char *chosen)
{
	size_t *best = ts_alloc(sim->particles->n, sizeof *best); /* of each particle: option + 1 */

	if (!best)
		return ts_nomem(&sim->error);
	for (size_t k = 0; k < n; k++)
		for (int s = 0; s < 2; s++) {
			size_t *of = &best[option[k].row[s]];

			if (!*of || option[k].key < option[*of - 1].key)
				*of = k + 1;
		}
	for (size_t k = 0; k < n; k++)
		chosen[k] = best[option[k].row[0]] == k + 1 && best[option[k].row[1]] == k + 1 &&
			    takes(sim, chance, option[k].tag);
	ts_free(best);
	return TS_OK;
}
