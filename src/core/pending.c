#include "core/pending.h"

#include <ctype.h>
#include <string.h>

#include "core/sim.h"

#include "base/banned.h"

struct ts_pending {
	struct ts_pending *next;
	enum ts_kind kind;
	const char *style, *id; /* in the pool */
	unsigned char *bytes;
	size_t n;
};

static void pending_free(struct ts_pending *p)
{
	ts_free(p->bytes);
	ts_free(p);
}

enum ts_status ts_pending_add(struct tsim *sim, enum ts_kind kind, const char *style,
			      const char *id, const unsigned char *bytes, size_t n)
{
	struct ts_pending *p = ts_alloc(1, sizeof *p);

	if (!p)
		return ts_nomem(&sim->error);
	p->kind = kind;
	p->style = ts_pool_get(sim->pool, style);
	p->id = ts_pool_get(sim->pool, id);
	p->bytes = ts_alloc(n, 1);
	p->n = n;
	if (!p->style || !p->id || !p->bytes) {
		pending_free(p);
		return ts_nomem(&sim->error);
	}
	memcpy(p->bytes, bytes, n);
	p->next = sim->pending;
	sim->pending = p;
	return TS_OK;
}

static enum ts_status restore(struct tsim *sim, struct ts_instance *inst,
			      const struct ts_pending *p)
{
	struct ts_archive *archive = ts_archive_new(sim, false);
	const char *kind = ts_kind_name(p->kind);
	enum ts_status status;

	if (!archive)
		return ts_nomem(&sim->error);
	status = ts_archive_from(archive, p->bytes, p->n);
	if (status == TS_OK)
		status = ts_archive_instance(archive, inst, sim);
	ts_archive_free(archive);
	if (status == TS_OK)
		ts_log(&sim->log,
		       "Resetting global state of %c%s %s%sStyle %s from restart file info\n",
		       toupper((unsigned char)kind[0]), kind + 1, p->id, *p->id ? " " : "",
		       p->style);
	return status;
}

enum ts_status ts_pending_apply(struct tsim *sim, struct ts_instance *inst)
{
	for (struct ts_pending **p = &sim->pending; *p; p = &(*p)->next) {
		struct ts_pending *found = *p;
		enum ts_status status;

		if (found->kind != inst->style->kind || !ts_streq(found->id, inst->id) ||
		    !ts_streq(found->style, inst->style->name))
			continue;
		status = restore(sim, inst, found);
		*p = found->next;
		pending_free(found);
		return status;
	}
	return TS_OK;
}

void ts_pending_free(struct tsim *sim)
{
	while (sim->pending) {
		struct ts_pending *p = sim->pending;

		sim->pending = p->next;
		pending_free(p);
	}
}
