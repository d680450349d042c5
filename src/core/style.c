/* Look-up of styles by name, with the aliases of LIGGGHTS and LAMMPS. */
#include "core/style.h"

#include <string.h>

#include "core/sim.h"
#include "core/unsupported_names.h"

#include "base/banned.h"

const char *ts_kind_name(enum ts_kind kind)
{
#define TS_KIND_TEXT(name, text) [TS_KIND_##name] = text,
	static const char *const names[TS_NKIND] = { TS_KIND_LIST(TS_KIND_TEXT) };
#undef TS_KIND_TEXT
	return names[kind];
}

bool ts_kind_find(const char *name, enum ts_kind *out)
{
	for (int kind = 0; kind < TS_NKIND; kind++) {
		*out = (enum ts_kind)kind;
		if (ts_streq(ts_kind_name(*out), name))
			return true;
	}
	return false;
}

static bool is_name_of_length(const char *name, const char *text, size_t length)
{
	return strncmp(name, text, length) == 0 && name[length] == '\0';
}

/* Length of the name without the suffix of an accelerated variant of LAMMPS or LIGGGHTS (fix gravity/omp),
 * which is the style itself here. */
static size_t length_without_accelerator(const char *name)
{
	static const char *const endings[] = { "/omp", "/opt", "/kk", "/intel", "/gpu" };
	size_t n = strlen(name);

	for (size_t k = 0; k < sizeof endings / sizeof *endings; k++)
		if (ts_ends_with(name, endings[k]))
			return n - strlen(endings[k]);
	return n;
}

/* Names that LIGGGHTS, LAMMPS or other versions have for the same style. */
static const struct alias {
	enum ts_kind kind;
	const char *other, *usual;
} aliases[] = {
	{ TS_KIND_COMMAND, "create_particles", "create_atoms" },
	{ TS_KIND_COMPUTE, "contact/atom/gran", "contact/atom" },
	{ TS_KIND_COMPUTE, "rigid", "multisphere" },
	{ TS_KIND_DUMP, "atom/gz", "atom" },
	{ TS_KIND_DUMP, "atom/mpiio", "atom" },
	{ TS_KIND_DUMP, "custom/gz", "custom" },
	{ TS_KIND_DUMP, "custom/mpiio", "custom" },
	{ TS_KIND_DUMP, "local/gz", "local" },
	{ TS_KIND_DUMP, "stl", "mesh/stl" },
	{ TS_KIND_DUMP, "mesh/gran/VTK", "mesh/vtk" },
	{ TS_KIND_DUMP, "xyz/gz", "xyz" },
	{ TS_KIND_DUMP, "xyz/mpiio", "xyz" },
	{ TS_KIND_FIX, "custom_property/global", "property/global" },
	{ TS_KIND_FIX, "heat/gran/conduction", "heat/gran" },
	{ TS_KIND_FIX, "massflow/mesh/sieve", "massflow/mesh" },
	{ TS_KIND_FIX, "move/mesh/file", "move/mesh" },
	{ TS_KIND_FIX, "move/mesh/gran", "move/mesh" },
	{ TS_KIND_FIX, "nve/bpm/sphere", "nve/sphere" },
	{ TS_KIND_FIX, "nve/sphere/bpm", "nve/sphere" },
	{ TS_KIND_FIX, "property/atomtype", "property/global" },
	{ TS_KIND_FIX, "property/atomtypepair", "property/global" },
	{ TS_KIND_FIX, "rigid/nve", "rigid" },
	{ TS_KIND_FIX, "rigid/nve/small", "rigid" },
	{ TS_KIND_FIX, "rigid/small", "rigid" },
	{ TS_KIND_FIX, "particledistribution/discrete/massbased", "particledistribution/discrete" },
};
enum { NALIASES = sizeof aliases / sizeof *aliases };

static const char *resolve_alias(enum ts_kind kind, const char *name)
{
	for (size_t k = 0; k < NALIASES; k++)
		if (aliases[k].kind == kind && ts_streq(aliases[k].other, name))
			return aliases[k].usual;
	return name;
}

const char *ts_style_other_name(const struct ts_style *style, size_t k)
{
	for (size_t row = 0; row < NALIASES; row++)
		if (aliases[row].kind == style->kind && ts_streq(aliases[row].usual, style->name) && k-- == 0)
			return aliases[row].other;
	return NULL;
}

const struct ts_style *ts_style_find(const struct ts_tables *tables, enum ts_kind kind, const char *name)
{
	size_t n;

	name = resolve_alias(kind, name);
	n = length_without_accelerator(name);
	for (const struct ts_style *const *s = tables->styles; *s; s++)
		if ((*s)->kind == kind && is_name_of_length((*s)->name, name, n))
			return *s;
	return NULL;
}

/* For messages: "command", "fix style". */
static const char *kind_noun(enum ts_kind kind)
{
	return kind == TS_KIND_COMMAND ? "" : " style";
}

enum ts_status ts_style_require(struct tsim *sim, enum ts_kind kind, const struct ts_word *name,
				const struct ts_style **out)
{
	struct ts_suggest suggest = ts_suggest_start(name->text);
	const struct ts_unsupported *known = ts_unsupported_find(kind, name->text);
	const char *suggestion;

	*out = ts_style_find(sim->tables, kind, name->text);
	if (*out)
		return TS_OK;
	if (known)
		return ts_fail(&sim->error, TS_UNKNOWN, &name->place,
			       "%s%s '%s' is known from LIGGGHTS or LAMMPS, but tsim does not have it: %s",
			       ts_kind_name(kind), kind_noun(kind), name->text, known->remark);
	for (const struct ts_style *const *s = sim->tables->styles; *s; s++)
		if ((*s)->kind == kind)
			ts_suggest_try(&suggest, (*s)->name);
	for (size_t k = 0; k < NALIASES; k++)
		if (aliases[k].kind == kind)
			ts_suggest_try(&suggest, aliases[k].other);
	suggestion = ts_suggest_text(&suggest);
	return ts_fail(&sim->error, TS_UNKNOWN, &name->place, "unknown %s%s '%s'%s%s", ts_kind_name(kind),
		       kind_noun(kind), name->text, *suggestion ? suggestion : "; for a list: tsim -help ",
		       *suggestion ? "" : ts_kind_name(kind));
}
