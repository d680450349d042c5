/* Kinds, styles, their manual pages and arguments. */
#include "library/library.h"

#include "library/tsim_tables.h"
#include "manual/help.h"

#include "base/banned.h"

const char *tsim_kind(size_t k)
{
	size_t kind = TS_KIND_COMMAND + k; /* systems have no names in scripts */

	return kind < TS_NKIND ? ts_kind_name((enum ts_kind)kind) : NULL;
}

static bool find_kind(const char *name, enum ts_kind *out)
{
	return name && ts_kind_find(name, out) && *out != TS_KIND_SYSTEM;
}

const char *tsim_style(const char *kind, size_t k, const char **summary)
{
	enum ts_kind number;

	if (!find_kind(kind, &number))
		return NULL;
	for (const struct ts_style *const *s = ts_tables.styles; *s; s++) {
		if ((*s)->kind != number || k-- != 0)
			continue;
		if (summary)
			*summary = (*s)->summary;
		return (*s)->name;
	}
	return NULL;
}

static const struct ts_style *find_style(const char *kind, const char *style, struct ts_str *why)
{
	struct ts_suggest suggest;
	const struct ts_style *found;
	enum ts_kind number;

	if (!kind || !style) {
		ts_str_addf(why, "the argument %s is NULL", kind ? "style" : "kind");
		return NULL;
	}
	suggest = ts_suggest_start(kind);
	if (!find_kind(kind, &number)) {
		for (size_t k = 0; tsim_kind(k); k++)
			ts_suggest_try(&suggest, tsim_kind(k));
		ts_str_addf(why, "there is no kind '%s'%s", kind, ts_suggest_text(&suggest));
		return NULL;
	}
	found = ts_style_find(&ts_tables, number, style);
	if (found)
		return found;
	suggest = ts_suggest_start(style);
	for (size_t k = 0; tsim_style(kind, k, NULL); k++)
		ts_suggest_try(&suggest, tsim_style(kind, k, NULL));
	ts_str_addf(why, "there is no %s '%s'%s", kind, style, ts_suggest_text(&suggest));
	return NULL;
}

int tsim_help(const char *kind, const char *style, int markdown, char *out, size_t room, size_t *length)
{
	struct ts_str text = { 0 };
	const struct ts_style *found = find_style(kind, style, &text);
	bool bad;

	if (found)
		ts_help_page(found, markdown, &text);
	bad = text.failed;
	ts_library_copy(ts_str_text(&text), out, out ? room : 0, length);
	ts_str_release(&text);
	if (room && !out)
		return TSIM_RANGE;
	if (bad)
		return TSIM_NOMEM;
	return found ? TSIM_OK : TSIM_UNKNOWN;
}

/* The k-th row in the order of the manual page; k counts down. */
static const struct ts_arg *find_argument(const struct ts_arg *row, size_t *k, const char **mode)
{
	for (; row && row->type != TS_ARG_END; row++) {
		if (*k == 0)
			return row;
		--*k;
		for (const struct ts_mode *m = row->modes; m && m->name; m++) {
			const char *outer = *mode;
			const struct ts_arg *found;

			*mode = m->name;
			found = find_argument(m->args, k, mode);
			if (found)
				return found;
			*mode = outer;
		}
	}
	return NULL;
}

static const char *type_name(const struct ts_arg *row)
{
	static const char *const names[] = {
		[TS_ARG_REAL] = "number",
		[TS_ARG_INT] = "whole number",
		[TS_ARG_BOOL] = "yes or no",
		[TS_ARG_FLAG] = "keyword without value",
		[TS_ARG_WORD] = "word",
		[TS_ARG_ENUM] = "one of the choices",
		[TS_ARG_VEC3] = "3 numbers",
		[TS_ARG_COORD] = "number, INF or EDGE",
		[TS_ARG_NUMBER] = "number or v_NAME",
		[TS_ARG_TYPES] = "types",
		[TS_ARG_GROUP] = "group",
		[TS_ARG_REGION] = "region",
		[TS_ARG_REF] = "reference",
		[TS_ARG_MODE] = "mode",
		[TS_ARG_REST] = "words",
	};

	return row->type < sizeof names / sizeof *names ? names[row->type] : "";
}

int tsim_argument(const char *kind, const char *style, size_t k, struct tsim_argument *out)
{
	struct ts_str ignored = { 0 };
	const struct ts_style *found = find_style(kind, style, &ignored);
	const char *mode = NULL;
	const struct ts_arg *row = found ? find_argument(found->args, &k, &mode) : NULL;
	struct tsim_argument full;

	ts_str_release(&ignored);
	if (!row)
		return TSIM_UNKNOWN;
	if (!out)
		return TSIM_RANGE;
	full = (struct tsim_argument){
		.name = row->name,
		.help = row->help ? row->help : "",
		.type = type_name(row),
		.unit = row->unit ? row->unit : "",
		.fallback = row->fallback,
		.mode = mode,
		.positional = (row->flags & TS_POSITIONAL) != 0,
		.optional = (row->flags & TS_OPTIONAL) || row->fallback || row->type == TS_ARG_FLAG,
		.nullable = (row->flags & TS_NULLABLE) != 0,
		.least = -INFINITY,
		.most = INFINITY,
		.positive = row->range == TS_POSITIVE,
		.choices = row->choices,
	};
	if (row->range == TS_WITHIN) {
		full.least = row->lo;
		full.most = row->hi;
	} else if (row->range != TS_ANY) {
		full.least = 0;
		full.most = row->range == TS_FRACTION ? 1 : INFINITY;
	}
	ts_library_copy_struct(out, &full, sizeof full);
	return TSIM_OK;
}
