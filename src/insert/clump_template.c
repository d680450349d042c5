#include "insert/clump_template.h"

#include <math.h>

#include "core/unsupported_names.h"
#include "io/lines.h"
#include "math/vec3.h"
#include "particle/sphere_shape.h"

#include "base/banned.h"

const char *const ts_clump_bonds[] = { "no", NULL };

static enum ts_status store_number(struct ts_instance *self, struct tsim *sim, const struct ts_place *where,
				   double value, size_t k, struct ts_clump *out)
{
	struct ts_clump_sphere *s = &out->sphere[k / 4];

	if (k % 4 < 3) {
		s->x[k % 4] = value;
		return TS_OK;
	}
	s->radius = value;
	if (value > 0)
		return TS_OK;
	return ts_fail(&sim->error, TS_RANGE, where,
		       "fix %s: the radius of sphere %zu is %g, expected a number > 0", self->style->name,
		       k / 4 + 1, value);
}

static enum ts_status read_lines(struct ts_instance *self, struct tsim *sim, struct ts_lines *l,
				 struct ts_clump *out)
{
	static const char *const what[] = { "x", "y", "z", "the radius" };
	size_t row = 0;
	bool more;

	TS_TRY(ts_lines_next_filled(l, &more));
	while (more) {
		if (row == out->n || l->nwords < 4)
			return ts_lines_fail(l, TS_RANGE, 0,
					     "a sphere is a line x y z r, and nspheres is %zu", out->n);
		for (size_t k = 0; k < 4; k++) {
			struct ts_place place = ts_lines_place(l, k);
			double value;

			TS_TRY(ts_lines_real(l, k, what[k], &value));
			TS_TRY(store_number(self, sim, &place, value, 4 * row + k, out));
		}
		row++;
		TS_TRY(ts_lines_next_filled(l, &more));
	}
	if (row == out->n)
		return TS_OK;
	return ts_lines_fail(l, TS_RANGE, 0, "the file ends after %zu spheres, nspheres is %zu", row, out->n);
}

static enum ts_status read_file(struct ts_instance *self, struct tsim *sim, const struct ts_word *name,
				struct ts_clump *out)
{
	struct ts_lines lines = { 0 };
	enum ts_status status =
		ts_lines_open(&lines, &sim->files, &sim->error, sim->pool, &name->place, name->text);

	if (status == TS_OK)
		status = read_lines(self, sim, &lines, out);
	ts_lines_close(&lines);
	return status;
}

static enum ts_status refuse_word(struct ts_instance *self, struct tsim *sim, const struct ts_word *word)
{
	struct ts_suggest suggest = ts_suggest_start(word->text);
	char what[80];
	const char *remark;

	snprintf(what, sizeof what, "fix %s", self->style->name);
	remark = ts_unsupported_word_remark(what, word->text);
	if (remark)
		return ts_fail(&sim->error, TS_UNKNOWN, &word->place,
			       "%s: keyword '%s' is known, but tsim does not have it: %s", what, word->text,
			       remark);
	ts_suggest_try(&suggest, "scale");
	for (const struct ts_arg *row = self->style->args; row->type != TS_ARG_END; row++)
		ts_suggest_try(&suggest, row->name);
	return ts_fail(&sim->error, TS_UNKNOWN, &word->place, "%s: unknown keyword '%s'%s", what, word->text,
		       ts_suggest_text(&suggest));
}

/* How many numbers the words begin with. */
static size_t count_numbers(struct ts_words words)
{
	double value;
	size_t n = 0;

	while (n < words.n && ts_parse_real(words.word[n].text, &value))
		n++;
	return n;
}

/* A word in place of a number is a wrong number, unless too few words follow. */
static enum ts_status read_numbers(struct ts_instance *self, struct tsim *sim, struct ts_words words,
				   struct ts_clump *out)
{
	size_t n = count_numbers(words);

	if (n < 4 * out->n && words.n >= 4 * out->n && !ts_streq(words.word[n].text, "scale"))
		return ts_fail(&sim->error, TS_SYNTAX, &words.word[n].place, "fix %s: '%s' is not a number",
			       self->style->name, words.word[n].text);
	if (n != 4 * out->n)
		return ts_fail(&sim->error, TS_SYNTAX, &words.word[0].place,
			       "fix %s: spheres has %zu numbers, expected x y z r for each of %zu spheres",
			       self->style->name, n, out->n);
	for (size_t k = 0; k < n; k++) {
		const struct ts_word *word = &words.word[k];
		double value = 0;

		if (ts_parse_real(word->text, &value))
			TS_TRY(store_number(self, sim, &word->place, value, k, out));
	}
	return TS_OK;
}

/* The words after the spheres: none, or scale FACTOR */
static enum ts_status read_factor(struct ts_instance *self, struct tsim *sim, struct ts_words words,
				  double *factor)
{
	const char *text = words.n > 1 ? words.word[1].text : "";

	if (!words.n)
		return TS_OK;
	if (!ts_streq(words.word[0].text, "scale"))
		return refuse_word(self, sim, &words.word[0]);
	if (!ts_parse_real(text, factor) || !(*factor > 0))
		return ts_fail(&sim->error, TS_RANGE, &words.word[words.n > 1].place,
			       "fix %s: scale is '%s', expected a number > 0", self->style->name, text);
	return words.n > 2 ? refuse_word(self, sim, &words.word[2]) : TS_OK;
}

/* Reads "x y z r" n times, or "file NAME" with n such lines; optionally followed by "scale FACTOR". */
static enum ts_status read_spheres(struct ts_instance *self, struct tsim *sim, struct ts_words words,
				   int64_t n, struct ts_clump *out)
{
	bool file = words.n > 1 && ts_streq(words.word[0].text, "file");
	double factor = 1;

	out->n = (size_t)n;
	out->sphere = ts_arena_alloc(&self->arena, out->n, sizeof *out->sphere);
	if (!out->sphere)
		return ts_nomem(&sim->error);
	if (!file)
		TS_TRY(read_numbers(self, sim, words, out));
	TS_TRY(read_factor(self, sim, ts_words_from(words, file ? 2 : 4 * out->n), &factor));
	if (file)
		TS_TRY(read_file(self, sim, &words.word[1], out));
	for (size_t k = 0; k < out->n; k++) {
		for (int d = 0; d < 3; d++)
			out->sphere[k].x[d] *= factor;
		out->sphere[k].radius *= factor;
	}
	return TS_OK;
}

enum ts_status ts_clump_template_init(struct ts_instance *self, struct tsim *sim, bool centre)
{
	struct ts_clump_template *c = self->state;
	struct ts_template *t = &c->base;
	struct ts_minstd random;
	enum ts_status status;

	TS_TRY(ts_template_start(self, sim));
	if (t->density.shape != TS_SPREAD_CONSTANT)
		return ts_fail(&sim->error, TS_RANGE, ts_instance_word(self, "density"),
			       "fix %s: expected density constant, the clumps are alike", self->style->name);
	TS_TRY(read_spheres(self, sim, c->sphere_words, c->nspheres, &c->clump));
	random = ts_minstd_start(t->seed);
	status = ts_clump_measure(&c->clump, c->ntry, &random);
	if (status == TS_NOMEM)
		return ts_nomem(&sim->error);
	if (status != TS_OK)
		return ts_fail(&sim->error, TS_RANGE, ts_instance_word(self, "ntry"),
			       "fix %s: none of %lld random points lies in a sphere; raise ntry",
			       self->style->name, (long long)c->ntry);
	t->clump = &c->clump;
	t->volume = c->clump.volume;
	t->mass = t->volume * t->density.a;
	t->largest = c->clump.reach;
	t->radius = (struct ts_spread){ .a = c->clump.reach };
	t->least = INFINITY;
	for (size_t k = 0; k < c->clump.n; k++)
		t->least = fmin(t->least, c->clump.sphere[k].radius);
	t->lightest = t->density.a * ts_particle_volume(sim, t->least);
	ts_scale(1, centre ? c->clump.centre : c->clump.middle, t->origin);
	return ts_template_check_volume(self, sim);
}
