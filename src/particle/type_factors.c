#include "particle/type_factors.h"

#include "particle/particles.h"

#include "base/banned.h"

enum ts_status ts_type_factors(struct tsim *sim, const char *what, struct ts_arena *arena,
			       struct ts_words words, double **out)
{
	int ntypes = sim->particles->ntypes;
	double *factor = ts_arena_alloc(arena, (size_t)ntypes + 1, sizeof *factor);

	if (!factor)
		return ts_nomem(&sim->error);
	for (int t = 0; t <= ntypes; t++)
		factor[t] = 1;
	for (size_t k = 0; k < words.n; k += 2) {
		const struct ts_word *word = &words.word[k];
		int64_t type;
		double value;

		if (!ts_parse_int(word->text, &type) || type < 1 || type > ntypes)
			return ts_fail(&sim->error, TS_RANGE, &word->place,
				       "%s: scale: '%s' is not a type, they go from 1 to %d", what,
				       word->text, ntypes);
		if (k + 1 == words.n || !ts_parse_real(word[1].text, &value) || !(value > 0))
			return ts_fail(&sim->error, TS_RANGE, &word->place,
				       "%s: scale %s is followed by a number > 0", what, word->text);
		factor[type] = value;
	}
	*out = factor;
	return TS_OK;
}
