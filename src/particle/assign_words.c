#include "particle/assign_words.h"

#include <math.h>
#include <string.h>

#include "box/domain.h"
#include "particle/columns.h"
#include "particle/draw.h"
#include "particle/particles.h"

#include "base/banned.h"

enum ts_status ts_assign_values(struct tsim *sim, const struct ts_number *number,
				const struct ts_place *where, struct ts_table *out)
{
	const struct ts_script_api *host = sim->script_api;
	double constant;

	if (number->variable && host->is_peratom(sim->script_api_data, number->variable))
		return host->peratom(sim->script_api_data, number->variable, where, out);
	TS_TRY(ts_number_now(sim, number, where, &constant));
	if (ts_table_resize(out, sim->particles->n, 1) != TS_OK)
		return ts_nomem(&sim->error);
	for (size_t i = 0; i < sim->particles->n; i++)
		out->data[i] = constant;
	return TS_OK;
}

static size_t count_chosen(const struct tsim *sim, const unsigned char *chosen)
{
	size_t count = 0;

	for (size_t i = 0; i < sim->particles->n; i++)
		count += chosen[i] != 0;
	return count;
}

/* ---- type/fraction, type/ratio, type/subset ---- */

struct type_choice {
	int64_t type, seed;
	double amount; /* fraction, 0 to 1, or number of particles */
};

static enum ts_status read_type_choice(struct tsim *sim, enum ts_part selection, struct ts_words w,
				       struct type_choice *out)
{
	static const char *const names[] = { "type/fraction", "type/ratio", "type/subset" };
	bool subset = selection == TS_PART_SUBSET;
	const struct ts_word *bad = NULL;

	if (w.n != 3)
		return ts_fail(&sim->error, TS_SYNTAX, &w.word[w.n ? w.n - 1 : 0].place,
			       "set: %s takes a type, a %s and a seed", names[selection],
			       subset ? "number" : "fraction");
	if (!ts_parse_int(w.word[0].text, &out->type) || out->type < 1 || out->type > sim->particles->ntypes)
		bad = &w.word[0];
	else if (!ts_parse_real(w.word[1].text, &out->amount) || !(out->amount >= 0) ||
		 (!subset && out->amount > 1) || (subset && out->amount != floor(out->amount)))
		bad = &w.word[1];
	else if (!ts_parse_int(w.word[2].text, &out->seed) || out->seed < 1)
		bad = &w.word[2];
	if (!bad)
		return TS_OK;
	return ts_fail(&sim->error, TS_RANGE, &bad->place, "set: %s is '%s', expected %s", names[selection],
		       bad->text,
		       bad == &w.word[0]   ? "a type, 1 or more and at most what create_box says"
		       : bad == &w.word[2] ? "a seed, an integer > 0"
		       : subset		   ? "how many get the type, an integer >= 0"
					   : "a fraction from 0 to 1");
}

enum ts_status ts_assign_type(struct tsim *sim, enum ts_part selection, struct ts_words words,
			      const unsigned char *chosen, size_t *count)
{
	struct ts_particles *p = sim->particles;
	struct type_choice want;
	struct ts_draw *draw;
	size_t n, wanted;

	TS_TRY(read_type_choice(sim, selection, words, &want));
	TS_TRY(ts_draw(sim, chosen, want.seed, &draw, &n));
	wanted = selection == TS_PART_SUBSET  ? (size_t)fmin(want.amount, 4e9)
		 : selection == TS_PART_EXACT ? ts_draw_part(n, want.amount)
					      : ts_draw_below(draw, n, want.amount);
	if (wanted > n) {
		ts_free(draw);
		return ts_fail(&sim->error, TS_RANGE, &words.word[1].place,
			       "set: type/subset wants %.0f particles, but only %zu are chosen", want.amount,
			       n);
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
		if (!ts_parse_int(word->text, &flag) || flag < -TS_TURNS_MOST || flag > TS_TURNS_MOST)
			return ts_fail(&sim->error, TS_SYNTAX, &word->place,
				       "set: image is '%s', expected an integer or NULL", word->text);
		if (flag && !ts_box_periodic(&sim->domain->box, d))
			return ts_fail(&sim->error, TS_STATE, &word->place,
				       "set: image is %s, but the box is not periodic in %c", word->text,
				       'x' + d);
		for (size_t i = 0; i < p->n; i++)
			if (chosen[i])
				p->image[i][d] = (int32_t)flag;
	}
	*count = count_chosen(sim, chosen);
	return TS_OK;
}

/* ---- columns added by fixes ---- */

static struct ts_column *find_column(struct ts_particles *p, const char *name, size_t n)
{
	static const char *const prefixes[] = { "", "f_", "d_", "i_", "property_" };

	for (size_t k = TS_NCOLUMN_BUILTIN; k < p->ncolumns; k++)
		for (size_t j = 0; j < sizeof prefixes / sizeof *prefixes; j++) {
			const char *known = p->column[k].name;
			size_t m = strlen(prefixes[j]);

			if (strncmp(known, prefixes[j], m) == 0 && strlen(known) == m + n &&
			    strncmp(known + m, name, n) == 0)
				return &p->column[k];
		}
	return NULL;
}

/* The index k of NAME[k], counted from 0; false if the script's index is not within 1..width. */
static bool read_component(const char *bracket, size_t width, size_t *k)
{
	size_t digits = strcspn(bracket + 1, "]");
	char number[16] = "";
	int64_t value = 0;

	if (!digits || digits >= sizeof number || !ts_streq(bracket + 1 + digits, "]"))
		return false;
	memcpy(number, bracket + 1, digits);
	if (!ts_parse_int(number, &value) || value < 1 || (size_t)value > width)
		return false;
	*k = (size_t)value - 1;
	return true;
}

/* The components that NAME, or NAME[k], denotes: first .. first + n - 1 of the column. */
struct column_components {
	struct ts_column *column;
	size_t first, n;
};

static enum ts_status find_components(struct tsim *sim, const struct ts_word *word,
				      struct column_components *out)
{
	struct ts_particles *p = sim->particles;
	size_t length = strcspn(word->text, "[");
	struct ts_column *c = find_column(p, word->text, length);
	struct ts_suggest suggest = ts_suggest_start(word->text);
	bool one = word->text[length] != '\0';

	for (size_t j = TS_NCOLUMN_BUILTIN; j < p->ncolumns; j++)
		ts_suggest_try(&suggest, p->column[j].name);
	if (!c || c->type != TS_SAVED_F64)
		return ts_fail(&sim->error, TS_UNKNOWN, &word->place,
			       "set: no fix keeps a property '%s' of particles%s", word->text,
			       ts_suggest_text(&suggest));
	*out = (struct column_components){ c, 0, one ? 1 : c->width };
	if (one && !read_component(word->text + length, c->width, &out->first))
		return ts_fail(&sim->error, TS_RANGE, &word->place,
			       "set: property '%.*s' has the numbers [1] to [%zu], not %s", (int)length,
			       word->text, c->width, word->text + length);
	return TS_OK;
}

/* A number, or v_NAME of a variable that exists. */
static bool read_number(const struct tsim *sim, const struct ts_word *word, struct ts_number *out)
{
	const char *name = strncmp(word->text, "v_", 2) == 0 ? word->text + 2 : NULL;

	*out = (struct ts_number){ .variable = name };
	return name ? sim->script_api && sim->script_api->has_variable(sim->script_api_data, name)
		    : ts_parse_real(word->text, &out->value);
}

enum ts_status ts_assign_omega(struct tsim *sim, struct ts_words words, const unsigned char *chosen,
			       size_t *count)
{
	struct ts_particles *p = sim->particles;
	struct ts_number number[3];
	struct ts_table table = { 0 };
	enum ts_status status = TS_OK;

	for (size_t d = 0; d < 3; d++)
		if (words.n != 3 || !read_number(sim, &words.word[d], &number[d]))
			return ts_fail(&sim->error, TS_SYNTAX, &words.word[words.n == 3 ? d : 0].place,
				       "set: omega takes three numbers or variables, v_NAME");
	TS_TRY(ts_particles_need(sim, TS_NEED(OMEGA)));
	*count = count_chosen(sim, chosen);
	for (int d = 0; d < 3 && status == TS_OK; d++) {
		status = ts_assign_values(sim, &number[d], &words.word[d].place, &table);
		for (size_t i = 0; i < p->n && status == TS_OK; i++)
			if (chosen[i])
				p->omega[i][d] = table.data[i];
	}
	ts_table_release(&table);
	return status;
}

static enum ts_status read_value(struct tsim *sim, const struct ts_word *word, struct ts_number *out)
{
	if (read_number(sim, word, out))
		return TS_OK;
	return ts_fail(&sim->error, TS_SYNTAX, &word->place,
		       "set: property/atom is '%s', expected a number or v_name", word->text);
}

static enum ts_status assign_component(struct tsim *sim, const struct ts_word *word,
				       const unsigned char *chosen, const struct column_components *to,
				       size_t k, struct ts_table *value)
{
	const struct ts_column *c = to->column;
	bool integer = strncmp(c->name, "i_", 2) == 0 || strncmp(c->name, "i2_", 3) == 0;
	struct ts_number number;

	TS_TRY(read_value(sim, word, &number));
	TS_TRY(ts_assign_values(sim, &number, &word->place, value));
	for (size_t i = 0; i < sim->particles->n; i++) {
		double x = value->data[i];

		if (chosen[i] && integer && x != floor(x))
			return ts_fail(&sim->error, TS_RANGE, &word->place, "set: %s is an integer, found %g",
				       c->name, x);
		if (chosen[i])
			((double *)c->data)[i * c->width + to->first + k] = x;
	}
	return TS_OK;
}

/* Number of words before the first that is neither a number nor v_NAME. */
static size_t count_values(struct ts_words words)
{
	size_t n = 0;
	double value;

	while (n < words.n &&
	       (strncmp(words.word[n].text, "v_", 2) == 0 || ts_parse_real(words.word[n].text, &value)))
		n++;
	return n;
}

static enum ts_status assign_column(struct tsim *sim, struct ts_words words, const unsigned char *chosen,
				    size_t *used)
{
	size_t given = count_values(ts_words_from(words, 1));
	struct ts_table value = { 0 };
	enum ts_status status = TS_OK;
	struct column_components to = { 0 };

	TS_TRY(find_components(sim, &words.word[0], &to));
	if (given < to.n && given + 1 < words.n)
		given = to.n; /* the message is about the word that is not a value */
	*used = given + 1;
	if (given != to.n)
		return ts_fail(&sim->error, TS_SYNTAX, &words.word[0].place,
			       "set: property '%s' takes %zu number%s, but %zu are given", words.word[0].text,
			       to.n, to.n > 1 ? "s" : "", given);
	for (size_t k = 0; k < to.n && status == TS_OK; k++)
		status = assign_component(sim, &words.word[k + 1], chosen, &to, k, &value);
	ts_table_release(&value);
	return status;
}

enum ts_status ts_assign_properties(struct tsim *sim, struct ts_words words, const unsigned char *chosen,
				    size_t *count)
{
	for (size_t used; words.n; words = ts_words_from(words, used))
		TS_TRY(assign_column(sim, words, chosen, &used));
	*count = count_chosen(sim, chosen);
	return TS_OK;
}
