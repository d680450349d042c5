/* A contact across a periodic face has two entries, that of each particle, which differ by rounding; any other contact has one,
 * which both ranks have if its particles are on two. It changes from one sort to the other only where one of its particles is
 * wrapped. One rank then has both entries, and so do here the ranks of both particles: each sends those of these contacts to
 * the other one. All other rows stay where their particles stay. */
#include "particle/turning.h"

#include "box/domain.h"
#include "particle/carrier_rows.h"

#include "base/banned.h"

/* Whether particle i will be wrapped. */
static bool turns(const struct tsim *sim, size_t i)
{
	const struct ts_particles *p = sim->particles;
	bool is = false;

	for (int d = 0; d < 3; d++) {
		double x = p->x[i][d];
		int32_t image = p->image[i][d];

		if (ts_box_periodic(&sim->domain->box, d))
			(void)ts_box_wrap(&sim->domain->box, d, &x, &image);
		is |= image != p->image[i][d];
	}
	return is;
}

struct turning {
	struct ts_leaving tags;
	size_t capacity;
	unsigned char *own; /* by particle of this rank */
};

static enum ts_status note(struct turning *t, int32_t tag)
{
	TS_TRY(TS_GROW(t->tags.tag, t->capacity, t->tags.n + 1));
	t->tags.tag[t->tags.n++] = tag;
	return TS_OK;
}

static enum ts_status note_own(const struct tsim *sim, struct turning *t)
{
	const struct ts_particles *p = sim->particles;

	t->own = ts_alloc(p->n, 1);
	if (!t->own)
		return TS_NOMEM;
	for (size_t i = 0; i < p->n; i++) {
		t->own[i] = turns(sim, i);
		if (t->own[i])
			TS_TRY(note(t, p->tag[i]));
	}
	return TS_OK;
}

/* One byte of each copy. */
static enum ts_status note_copies(struct tsim *sim, struct turning *t)
{
	const struct ts_particles *p = sim->particles;
	struct ts_copies *c = &sim->division->copies;
	const int32_t *row = c->row;
	size_t ghost = p->n;

	for (int r = 0; r < sim->world->n; r++) {
		c->out[r].n = c->in[r].n = 0;
		if (!ts_parcel_extend(&c->out[r], c->sent[r]) || !ts_parcel_extend(&c->in[r], c->received[r]))
			return TS_NOMEM;
		for (size_t k = 0; k < c->sent[r]; k++)
			c->out[r].data[k] = t->own[*row++];
	}
	ts_world_swap(sim->world, c->out, c->in);
	for (int r = 0; r < sim->world->n; r++)
		for (size_t k = 0; k < c->received[r]; k++, ghost++)
			if (c->in[r].data[k])
				TS_TRY(note(t, p->tag[ghost]));
	return TS_OK;
}

static enum ts_status find_turning(struct tsim *sim, struct turning *t)
{
	TS_TRY(note_own(sim, t));
	TS_TRY(note_copies(sim, t));
	ts_carried_sort(&t->tags);
	return TS_OK;
}

static enum ts_status exchange_rows(struct tsim *sim, const struct turning *t)
{
	struct ts_division *d = sim->division;
	struct ts_instance *inst;
	struct ts_copy_map copy;
	enum ts_status status = ts_copy_map_make(sim, &copy) == TS_OK ? TS_OK : ts_nomem(&sim->error);
	int kind = 0;
	size_t k = 0;

	while (status == TS_OK && (inst = ts_carrier_next(sim, &kind, &k))) {
		struct ts_carried *rows;

		if (TS_GROW(d->turned, d->turned_capacity, d->nturned + 1) != TS_OK) {
			status = ts_nomem(&sim->error);
			break;
		}
		rows = &d->turned[d->nturned++];
		*rows = (struct ts_carried){ 0 };
		if (!inst->style->carrier->turn)
			continue;
		status = inst->style->carrier->turn(inst, sim, &t->tags, rows);
		if (status == TS_OK)
			status = ts_carrier_rows_send_home(sim, rows, &copy);
	}
	ts_copy_map_release(&copy);
	return status;
}

enum ts_status ts_turning_exchange(struct tsim *sim)
{
	struct turning t = { .own = NULL };
	enum ts_status status;

	ts_turning_forget(sim->division);
	status = find_turning(sim, &t) == TS_OK ? exchange_rows(sim, &t) : ts_nomem(&sim->error);
	ts_free(t.tags.tag);
	ts_free(t.own);
	return status;
}

bool ts_turning_found(const struct ts_division *d)
{
	bool some = false;

	for (size_t k = 0; k < d->nturned; k++)
		some |= d->turned[k].rows.n > 0;
	return some;
}

enum ts_status ts_turning_add(struct tsim *sim)
{
	struct ts_division *d = sim->division;

	for (size_t k = 0; k < d->nturned; k++)
		if (ts_parcel_add(&d->carried[k].rows, d->turned[k].rows.data, d->turned[k].rows.n) != TS_OK)
			return ts_nomem(&sim->error);
	ts_turning_forget(d);
	return TS_OK;
}

void ts_turning_forget(struct ts_division *d)
{
	for (size_t k = 0; k < d->nturned; k++)
		ts_parcel_release(&d->turned[k].rows);
	d->nturned = 0;
}
