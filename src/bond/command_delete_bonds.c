#include "bond/bonds.h"
#include "particle/identity.h"
#include "particle/particles.h"

#include "base/banned.h"

enum { MULTI, BOND, ATOM, STATS };

struct delete_bonds {
	int group, mode;
	struct ts_types types;
	bool any, undo, remove, special;
};

static bool has_type(const struct ts_types *t, int32_t type)
{
	return type >= t->lo && (type <= t->hi || t->hi == 0);
}

/* i, j: local indices of the partners, -1 if a partner has left. */
static bool is_selected(const struct delete_bonds *c, const struct tsim *sim, size_t k, int32_t i, int32_t j)
{
	const struct ts_particles *p = sim->particles;
	bool in_i, in_j;

	if (i < 0 || j < 0)
		return true;
	in_i = ts_in_group(p, (size_t)i, c->group);
	in_j = ts_in_group(p, (size_t)j, c->group);
	if (!(c->any ? in_i || in_j : in_i && in_j))
		return false;
	if (c->mode == BOND)
		return has_type(&c->types, sim->bonds->type[k]);
	if (c->mode == ATOM)
		return has_type(&c->types, p->type[i]) || has_type(&c->types, p->type[j]);
	return true;
}

static enum ts_status delete_bonds_command(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct delete_bonds *c = state;
	struct ts_bonds *b = sim->bonds;
	unsigned char *drop;
	struct ts_identities map;
	size_t before = b->n;

	if (c->undo)
		return ts_fail(&sim->error, TS_STATE, where,
			       "delete_bonds: bonds are removed, not switched off: undo is not possible");
	if (c->mode == STATS) {
		ts_log(&sim->log, "%zu bonds of %d types\n", b->n, b->ntypes);
		return TS_OK;
	}
	TS_TRY(ts_identities(sim, false, &map));
	drop = ts_alloc(b->n, 1);
	if (!drop)
		return ts_nomem(&sim->error);
	for (size_t k = 0; k < b->n; k++)
		drop[k] = is_selected(c, sim, k, ts_identity_row(&map, b->tag[k][0]),
				      ts_identity_row(&map, b->tag[k][1]));
	ts_bonds_delete(b, drop);
	ts_free(drop);
	ts_log(&sim->log, "Deleted %zu bonds, total bonds = %zu\n", before - b->n, b->n);
	return TS_OK;
}

static const struct ts_arg bond_args[] = {
	TS_TYPES("bond types", struct delete_bonds, types, .flags = TS_POSITIONAL,
		 .help = "bond types: n, *, n*, *m or n*m"),
	TS_ARGS_END,
};

static const struct ts_arg atom_args[] = {
	TS_TYPES("types", struct delete_bonds, types, .flags = TS_POSITIONAL,
		 .help = "atom types: n, *, n*, *m or n*m"),
	TS_ARGS_END,
};

static const struct ts_mode modes[] = {
	[MULTI] = { "multi", "all bonds; the default", NULL },
	[BOND] = { "bond", "bonds of the given types", bond_args },
	[ATOM] = { "atom", "bonds with a partner of the given atom types", atom_args },
	[STATS] = { "stats", "no bond: prints the number of bonds", NULL },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_GROUP("group", struct delete_bonds, group, .flags = TS_POSITIONAL,
		 .help = "bonds between particles of this group are removed"),
	{ .name = "style",
	  .type = TS_ARG_MODE,
	  .flags = TS_POSITIONAL | TS_OPTIONAL,
	  .offset = TS_FIELD(struct delete_bonds, mode, int *),
	  .modes = modes,
	  .help = "which bonds" },
	TS_FLAG("any", struct delete_bonds, any, .help = "one partner in the group is sufficient"),
	TS_FLAG("remove", struct delete_bonds, remove, .help = "no effect: deleted bonds are always removed"),
	TS_FLAG("special", struct delete_bonds, special,
		.help = "no effect: the list of bonded pairs is always up to date"),
	TS_FLAG("undo", struct delete_bonds, undo, .help = "refused: removed bonds cannot be restored"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_delete_bonds)
const struct ts_command_style ts_command_delete_bonds = {
	.style = { .name = "delete_bonds",
		   .kind = TS_KIND_COMMAND,
		   .summary = "removes the bonds within a group",
		   .doc = "Removes the bonds whose partners are both in the group, or with `any` those with "
			  "one partner in the group. Bonds to particles that have left the simulation are "
			  "removed, too. Deleted bonds do not count as broken.",
		   .example = "delete_bonds all\ndelete_bonds rock bond 2 any remove",
		   .args = args,
		   .state_size = sizeof(struct delete_bonds) },
	.needs_box = true,
	.run = delete_bonds_command,
};
