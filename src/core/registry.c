#include "core/sim.h"

#include "base/banned.h"

const char *ts_kind_name(enum ts_kind kind)
{
#define TS_KIND_TEXT(name, text) [TS_KIND_##name] = text,
	static const char *const names[TS_NKIND] = { TS_KIND_LIST(TS_KIND_TEXT) };
#undef TS_KIND_TEXT
	return names[kind];
}

const struct ts_style *ts_style_find(enum ts_kind kind, const char *name)
{
	for (const struct ts_style *const *s = ts_style_table; *s; s++)
		if ((*s)->kind == kind && ts_streq((*s)->name, name))
			return *s;
	return NULL;
}

enum ts_status ts_style_require(struct tsim *sim, enum ts_kind kind, const struct ts_word *name,
				const struct ts_style **out)
{
	struct ts_suggest suggest = ts_suggest_start(name->text);
	const char *suggestion;

	*out = ts_style_find(kind, name->text);
	if (*out)
		return TS_OK;
	for (const struct ts_style *const *s = ts_style_table; *s; s++)
		if ((*s)->kind == kind)
			ts_suggest_try(&suggest, (*s)->name);
	suggestion = ts_suggest_text(&suggest);
	return ts_fail(&sim->error, TS_UNKNOWN, &name->place, "unknown %s%s '%s'%s%s",
		       ts_kind_name(kind), kind == TS_KIND_COMMAND ? "" : " style", name->text,
		       *suggestion ? suggestion : "; for a list: tsim -help ",
		       *suggestion ? "" : ts_kind_name(kind));
}
