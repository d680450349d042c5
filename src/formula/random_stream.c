#include "formula/random_stream.h"

#include <math.h>

#include "formula/formulas.h"

#include "base/banned.h"

enum ts_status ts_random_stream_of(struct ts_formulas *s, double seed, struct ts_random_stream **out)
{
	size_t k = 0;

	if (!(seed >= 1 && seed < 9e15) || floor(seed) < seed)
		return ts_fail(&s->sim->error, TS_RANGE, NULL,
			       "the seed must be a positive whole number, found %.15g", seed);
	while (k < s->nstreams && s->stream[k].seed != (int64_t)seed)
		k++;
	if (k == s->nstreams) {
		if (TS_GROW(s->stream, s->stream_capacity, k + 1) != TS_OK)
			return ts_nomem(&s->sim->error);
		s->stream[k] = (struct ts_random_stream){ .seed = (int64_t)seed };
		s->nstreams++;
	}
	*out = &s->stream[k];
	return TS_OK;
}

/* Streams of seeds that the archive does not have stay as they are. */
static enum ts_status restore_streams(struct ts_formulas *s, const int64_t *number, size_t n)
{
	struct ts_random_stream *stream;

	for (size_t k = 0; k + 2 < n; k += 3) {
		if (number[k] < 1 || number[k + 1] < 0 || number[k + 2] < 0)
			return ts_fail(&s->sim->error, TS_DAMAGED, NULL,
				       "the streams of random numbers are damaged");
		TS_TRY(ts_random_stream_of(s, (double)number[k], &stream));
		stream->draws = number[k + 1];
		stream->rounds = number[k + 2];
	}
	return TS_OK;
}

enum ts_status ts_random_streams_archive(struct ts_formulas *s, struct ts_archive *archive)
{
	size_t n = 0, capacity = 0;
	int64_t *number = NULL;
	enum ts_status status = TS_OK;

	if (ts_archive_writing(archive) && TS_GROW(number, capacity, 3 * s->nstreams) != TS_OK)
		return ts_nomem(&s->sim->error);
	for (size_t k = 0; ts_archive_writing(archive) && k < s->nstreams; k++) {
		number[n++] = s->stream[k].seed;
		number[n++] = s->stream[k].draws;
		number[n++] = s->stream[k].rounds;
	}
	status = ts_archive_array(archive, "random", TS_SAVED_I64, (void **)&number, &capacity, &n);
	if (status == TS_OK && !ts_archive_writing(archive))
		status = restore_streams(s, number, n);
	ts_free(number);
	return status;
}
