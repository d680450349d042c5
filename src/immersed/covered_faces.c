#include "immersed/covered_faces.h"

#include <string.h>

#include "base/alloc.h"

#include "base/banned.h"

static enum ts_status append(struct ts_covered_faces *faces, const struct ts_covered_face *more, size_t n)
{
	TS_TRY(TS_GROW(faces->face, faces->capacity, faces->n + n));
	if (n)
		memcpy(faces->face + faces->n, more, n * sizeof *more);
	faces->n += n;
	return TS_OK;
}

enum ts_status ts_covered_faces_find(struct ts_covered_faces *faces, const struct ts_immersed *ib)
{
	TS_TRY(TS_GROW(faces->face, faces->capacity, ib->npoints - ib->nouter));
	for (int c = 0; c < 3; c++) {
		for (size_t k = ib->first[c]; k < ib->first[c + 1]; k++)
			if (!ib->point[k].outside)
				faces->face[faces->n++] =
					(struct ts_covered_face){ ib->point[k].at, ib->point[k].target };
		faces->first[c + 1] = faces->n;
	}
	return TS_OK;
}

void ts_covered_faces_release(struct ts_covered_faces *faces)
{
	ts_free(faces->face);
	*faces = (struct ts_covered_faces){ 0 };
}

/* Of each body and axis their number, and the faces. */
static enum ts_status pack(const struct ts_covered_faces *list, size_t bodies, struct ts_parcel *out)
{
	for (size_t body = 0; body < bodies; body++)
		for (int c = 0; c < 3; c++) {
			const size_t first = list[body].first[c], n = list[body].first[c + 1] - first;

			TS_TRY(ts_parcel_add(out, &n, sizeof n));
			if (n)
				TS_TRY(ts_parcel_add(out, &list[body].face[first], n * sizeof *list->face));
		}
	return TS_OK;
}

/* `read`: bytes that have been read of the parcel of each rank. */
static enum ts_status unpack(struct ts_covered_faces *list, size_t bodies, const struct ts_parcel *in,
			     int ranks, size_t *read)
{
	for (size_t body = 0; body < bodies; body++)
		for (int c = 0; c < 3; c++) {
			for (int r = 0; r < ranks; r++) {
				const unsigned char *at = in[r].data + read[r];
				size_t n;

				memcpy(&n, at, sizeof n);
				TS_TRY(append(&list[body],
					      (const struct ts_covered_face *)(const void *)(at + sizeof n),
					      n));
				read[r] += sizeof n + n * sizeof *list->face;
			}
			list[body].first[c + 1] = list[body].n;
		}
	return TS_OK;
}

static enum ts_status send(struct ts_world *world, struct ts_covered_faces *list, size_t bodies,
			   struct ts_parcel *out, struct ts_parcel *in, size_t *read)
{
	TS_TRY(pack(list, bodies, out));
	for (size_t body = 0; body < bodies; body++)
		ts_covered_faces_release(&list[body]);
	TS_TRY(ts_world_deliver(world, out, in));
	return world->rank == 0 ? unpack(list, bodies, in, world->n, read) : TS_OK;
}

enum ts_status ts_covered_faces_gather(struct ts_world *world, struct ts_covered_faces *list, size_t bodies)
{
	const size_t ranks = (size_t)world->n;
	struct ts_parcel *out = ts_alloc(ranks, sizeof *out), *in = ts_alloc(ranks, sizeof *in);
	size_t *read = ts_alloc(ranks, sizeof *read);
	enum ts_status status = out && in && read ? send(world, list, bodies, out, in, read) : TS_NOMEM;

	for (size_t r = 0; r < ranks; r++) {
		if (out)
			ts_parcel_release(&out[r]);
		if (in)
			ts_parcel_release(&in[r]);
	}
	ts_free(out);
	ts_free(in);
	ts_free(read);
	return status;
}
