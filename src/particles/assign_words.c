#include "particles/assign_words.h"

#include <math.h>
#include <string.h>

#include "particles/domain.h"
#include "particles/draw.h"
#include "particles/particles.h"

#include "base/banned.h"

enum ts_status ts_assign_values(struct tsim *sim, const struct ts_number *number,
				const struct ts_place *where, struct ts_table *out)
{
	const struct ts_host *host = sim->host;
	double constant;

	if (number->variable && host->is_peratom(sim->host_data, number->variable))
		return host->peratom(sim->host_data, number->variable, where, out);
	TS_TRY(ts_number_now(sim, number, where, &constant));
	if (ts_table_resize(out, sim->particles->n, 1) != TS_OK)
		return ts_nomem(&sim->error);
	for (size_t i = 0; i < sim->particles->n; i++)
		out->data[i] = constant;
	return TS_OK;
}

static size_t count_of(const struct tsim *sim, const unsigned char *chosen)
{
	size_t count = 0;

	for (size_t i = 0; i < sim->particles->n; i++)
		count += chosen[i] != 0;
	return count;
}

/* ---- types for a part ---- */

struct part {
	int64_t type, seed;
	double amount; /* fraction or number */
};

static enum ts_status read_part(struct tsim *sim, enum ts_part part, struct ts_words w,
				struct part *out)
{
	static const char *const names[] = { "type/fraction", "type/ratio", "type/subset" };
	bool subset = part == TS_PART_SUBSET;
	const struct ts_word *bad = NULL;

	if (w.n != 3)
		return ts_fail(&sim->error, TS_SYNTAX, &w.word[w.n ? w.n - 1 : 0].place,
			       "set: %s takes a type, a %s and a seed", names[part],
			       subset ? "number" : "fraction");
	if (!ts_parse_int(w.word[0].text, &out->type) || out->type < 1 ||
	    out->type > sim->particles->ntypes)
		bad = &w.word[0];
	else if (!ts_parse_real(w.word[1].text, &out->amount) || !(out->amount >= 0) ||
		 (!subset && out->amount > 1) || (subset && out->amount != floor(out->amount)))
		bad = &w.word[1];
	else if (!ts_parse_int(w.word[2].text, &out->seed) || out->seed < 1)
		bad = &w.word[2];
	if (!bad)
		return TS_OK;
	return ts_fail(&sim->error, TS_RANGE, &bad->place,
		       "set: %s is '%s', expected %s", names[part], bad->text,
		       bad == &w.word[0]   ? "a type, 1 or more and at most what create_box says"
		       : bad == &w.word[2] ? "a seed, an integer > 0"
		       : subset		   ? "how many get the type, an integer >= 0"
					   : "a fraction from 0 to 1");
}

enum ts_status ts_assign_type(struct tsim *sim, enum ts_part part, struct ts_words words,
			      const unsigned char *chosen, size_t *count)
{
	struct ts_particles *p = sim->particles;
	struct part want;
	struct ts_draw *draw;
	size_t n, wanted;

	TS_TRY(read_part(sim, part, words, &want));
	TS_TRY(ts_draw(sim, chosen, want.seed, &draw, &n));
	wanted = part == TS_PART_SUBSET	 ? (size_t)fmin(want.amount, 4e9)
		 : part == TS_PART_EXACT ? ts_draw_part(n, want.amount)
					 : ts_draw_below(draw, n, want.amount);
	if (wanted > n) {
		ts_free(draw);
		return ts_fail(&sim->error, TS_RANGE, &words.word[1].place,
			       "set: type/subset wants %.0f particles, but only %zu are chosen",
			       want.amount, n);
	}
	for (size_t k = 0; k < wanted; k++)
		p->type[draw[k].row] = (int32_t)want.type;
	*count = wanted;
	ts_free(draw);
	return TS_OK;
}

/* ---- image flags ---- */

enum ts_status ts_assign_image(struct tsim *sim, struct ts_words words, const unsigned char *chosen,
			       size_t *count)
{
	struct ts_particles *p = sim->particles;

	for (int d = 0; d < 3; d++) {
		const struct ts_word *word = (size_t)d < words.n ? &words.word[d] : NULL;
		int64_t flag;

		if (!word || words.n > 3)
			return ts_fail(&sim->error, TS_SYNTAX, &words.word[words.n - 1].place,
				       "set: image takes three integers, or NULL to leave one");
		if (ts_streq(word->text, "NULL"))
			continue;
		if (!ts_parse_int(word->text, &flag) || flag < -(1 << 30) || flag > 1 << 30)
			return ts_fail(&sim->error, TS_SYNTAX, &word->place,
				       "set: image is '%s', expected an integer or NULL", word->text);
		if (flag && !ts_box_periodic(&sim->domain->box, d))
			return ts_fail(&sim->error, TS_STATE, &word->place,
				       "set: image is %s, but the box is not periodic in %c",
				       word->text, 'x' + d);
		for (size_t i = 0; i < p->n; i++)
			if (chosen[i])
				p->image[i][d] = (int32_t)flag;
	}
	*count = count_of(sim, chosen);
	return TS_OK;
}

/* ---- columns of fixes ---- */

static struct ts_column *find_column(struct ts_particles *p, const char *name)
{
	static const char *const prefixes[] = { "", "f_", "d_", "i_", "property_" };

	for (size_t k = TS_NCOLUMN_BUILTIN; k < p->ncolumns; k++)
		for (size_t j = 0; j < sizeof prefixes / sizeof *prefixes; j++) {
			size_t n = strlen(prefixes[j]);

			if (strncmp(p->column[k].name, prefixes[j], n) == 0 &&
			    ts_streq(p->column[k].name + n, name))
				return &p->column[k];
		}
	return NULL;
}

static enum ts_status read_value(struct tsim *sim, const struct ts_word *word,
				 struct ts_number *out)
{
	const char *name = strncmp(word->text, "v_", 2) == 0 ? word->text + 2 : NULL;

	*out = (struct ts_number){ .variable = name };
	if (name ? sim->host && sim->host->has_variable(sim->host_data, name)
		 : ts_parse_real(word->text, &out->value))
		return TS_OK;
	return ts_fail(&sim->error, TS_SYNTAX, &word->place,
		       "set: property/atom is '%s', expected a number or v_name", word->text);
}

enum ts_status ts_assign_property(struct tsim *sim, struct ts_words words,
				  const unsigned char *chosen, size_t *count)
{
	struct ts_particles *p = sim->particles;
	struct ts_column *c = find_column(p, words.word[0].text);
	struct ts_suggest suggest = ts_suggest_start(words.word[0].text);
	struct ts_table value = { 0 };
	enum ts_status status = TS_OK;

	for (size_t k = TS_NCOLUMN_BUILTIN; k < p->ncolumns; k++)
		ts_suggest_try(&suggest, p->column[k].name);
	if (!c || c->type != TS_SAVED_F64)
		return ts_fail(&sim->error, TS_UNKNOWN, &words.word[0].place,
			       "set: no fix keeps a property '%s' of particles%s", words.word[0].text,
			       ts_suggest_text(&suggest));
	if (words.n != c->width + 1)
		return ts_fail(&sim->error, TS_SYNTAX, &words.word[0].place,
			       "set: property '%s' takes %zu number%s, but %zu are given",
			       words.word[0].text, c->width, c->width > 1 ? "s" : "", words.n - 1);
	for (size_t k = 0; k < c->width && status == TS_OK; k++) {
		struct ts_number number;

		status = read_value(sim, &words.word[k + 1], &number);
		if (status == TS_OK)
			status = ts_assign_values(sim, &number, &words.word[k + 1].place, &value);
		for (size_t i = 0; status == TS_OK && i < p->n; i++)
			if (chosen[i])
				((double *)c->data)[i * c->width + k] = value.data[i];
	}
	ts_table_release(&value);
	*count = count_of(sim, chosen);
	return status;
}
