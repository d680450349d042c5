#include "neigh/bonds.h"
#include "particles/particles.h"

#include "base/banned.h"

struct delete_bonds {
	int group;
};

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct delete_bonds *c = state;
	struct ts_bonds *b = sim->bonds;
	const struct ts_particles *p = sim->particles;
	unsigned char *drop = ts_alloc(b->n, 1);
	const int32_t *row_of_tag;
	size_t before = b->n;

	(void)where;
	if (!drop)
		return ts_nomem(&sim->error);
	if (ts_particles_map(sim, &row_of_tag) != TS_OK) {
		ts_free(drop);
		return TS_NOMEM;
	}
	for (size_t k = 0; k < b->n; k++) {
		int32_t i = row_of_tag[b->tag[k][0]], j = row_of_tag[b->tag[k][1]];

		drop[k] = i < 0 || j < 0 ||
			  (ts_in_group(p, (size_t)i, c->group) && ts_in_group(p, (size_t)j, c->group));
	}
	ts_bonds_delete(b, drop);
	ts_free(drop);
	ts_log(&sim->log, "Deleted %zu bonds, total bonds = %zu\n", before - b->n, b->n);
	return TS_OK;
}

static const struct ts_arg args[] = {
	TS_GROUP("group", struct delete_bonds, group, .flags = TS_POSITIONAL,
		 .help = "bonds between its particles are removed"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_delete_bonds)
const struct ts_command_style ts_command_delete_bonds = {
	.style = { .name = "delete_bonds",
		   .kind = TS_KIND_COMMAND,
		   .summary = "removes the bonds within a group",
		   .doc = "Bonds whose partners are both in the group go; they do not count as broken.",
		   .example = "delete_bonds all",
		   .args = args,
		   .state_size = sizeof(struct delete_bonds) },
	.needs_box = true,
	.run = run,
};
