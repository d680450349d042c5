/* Variables that `next` steps through a list: index, loop, and world, universe, uloop for several
 * partitions, of which tsim has one. */
#include <inttypes.h>
#include <string.h>

#include "formula/formulas.h"

#include "base/banned.h"

static enum ts_status define_list(struct ts_formulas *formulas, struct ts_variable *variable)
{
	(void)formulas;
	variable->last = (int64_t)variable->values.n - 1;
	return TS_OK;
}

static enum ts_status list_text(struct ts_formulas *formulas, struct ts_variable *variable,
				const struct ts_place *where, struct ts_str *out)
{
	(void)formulas, (void)where;
	ts_str_add(out, variable->values.word[variable->at].text);
	return TS_OK;
}

static enum ts_status list_next(struct ts_formulas *formulas, struct ts_variable *variable, bool *exhausted)
{
	(void)formulas;
	*exhausted = variable->at == variable->last;
	variable->at += !*exhausted;
	return TS_OK;
}

/* N | N1 N2, and `pad`. */
static enum ts_status define_loop(struct ts_formulas *formulas, struct ts_variable *variable)
{
	struct ts_error *error = &formulas->sim->error;
	struct ts_words values = variable->values;
	int64_t bound[2] = { 1, 0 };
	bool pad = values.n > 1 && ts_streq(values.word[values.n - 1].text, "pad");

	values.n -= pad;
	if (values.n > 2)
		return ts_fail(error, TS_SYNTAX, &values.word[2].place,
			       "a loop variable takes 'N', 'N1 N2' or 'N1 N2 pad', found '%s'",
			       values.word[2].text);
	for (size_t k = 0; k < values.n; k++)
		if (!ts_parse_int(values.word[k].text, &bound[values.n == 1 ? 1 : k]))
			return ts_fail(error, TS_SYNTAX, &values.word[k].place,
				       "expected a whole number, found '%s'", values.word[k].text);
	if (bound[1] < bound[0])
		return ts_fail(error, TS_RANGE, &values.word[0].place,
			       "the loop from %" PRId64 " to %" PRId64 " has no values", bound[0], bound[1]);
	if (pad)
		variable->pad = (int)strlen(values.word[values.n - 1].text);
	variable->at = bound[0];
	variable->last = bound[1];
	return TS_OK;
}

static enum ts_status loop_text(struct ts_formulas *formulas, struct ts_variable *variable,
				const struct ts_place *where, struct ts_str *out)
{
	(void)formulas, (void)where;
	ts_str_addf(out, "%0*" PRId64, variable->pad, variable->at);
	return TS_OK;
}

const struct ts_variable_style ts_var_index = {
	.name = "index",
	.values = "words",
	.help = "one of several words; `next` advances to the next one",
	.least = 1,
	.keeps = true,
	.define = define_list,
	.text = list_text,
	.next = list_next,
};

const struct ts_variable_style ts_var_loop = {
	.name = "loop",
	.values = "N | N1 N2 [pad]",
	.help = "an integer from 1 to N or from N1 to N2; `next` advances to the next one; pad: with leading "
		"zeros, all as long as the last",
	.least = 1,
	.most = 3,
	.keeps = true,
	.define = define_loop,
	.text = loop_text,
	.next = list_next,
};

const struct ts_variable_style ts_var_world = {
	.name = "world",
	.values = "word",
	.help = "one word for each partition; tsim has one partition",
	.least = 1,
	.most = 1,
	.keeps = true,
	.define = define_list,
	.text = list_text,
};

const struct ts_variable_style ts_var_universe = {
	.name = "universe",
	.values = "words",
	.help = "as index, since tsim has one partition",
	.least = 1,
	.keeps = true,
	.define = define_list,
	.text = list_text,
	.next = list_next,
};

const struct ts_variable_style ts_var_uloop = {
	.name = "uloop",
	.values = "N [pad]",
	.help = "as loop, since tsim has one partition",
	.least = 1,
	.most = 2,
	.keeps = true,
	.define = define_loop,
	.text = loop_text,
	.next = list_next,
};
