#include "insert/stream.h"

#include <math.h>
#include <string.h>

#include "base/banned.h"

enum { PLACE, START = 3, RELEASE, DRIFT, VELOCITY = 8, OMEGA = 11, NUMBERS = 14 };

/* Index of the quantity, from 0; -1: another name, or there is no fix insert/stream. */
static int quantity_index(const struct tsim *sim, const char *name)
{
	static const char ours[] = "release_fix_insert_stream[";
	char index[4] = "";
	size_t k = 0, digits;
	int64_t column;

	if (strncmp(name, ours, strlen(ours)) != 0)
		return -1;
	name += strlen(ours);
	digits = strcspn(name, "]");
	if (digits >= sizeof index || !ts_streq(name + digits, "]"))
		return -1;
	memcpy(index, name, digits);
	if (!ts_parse_int(index, &column) || column < 1 || column > NUMBERS ||
	    !ts_sim_next_of(sim, TS_KIND_FIX, TS_FAMILY_STREAM, &k))
		return -1;
	return (int)column - 1;
}

static double stream_value(const struct ts_stream *stream, const struct tsim *sim, const double *memory,
			   int k)
{
	double first = (double)(sim->clock.step - stream->age); /* step of age 0 */

	return k < START      ? memory[TS_STREAM_PLACE + k]
	       : k == START   ? first + memory[TS_STREAM_START]
	       : k == RELEASE ? first + fabs(memory[TS_STREAM_RELEASE])
	       : k < VELOCITY ? stream->drift[k - DRIFT]
	       : k < OMEGA    ? memory[TS_STREAM_VELOCITY + k - VELOCITY]
			      : stream->base.omega[k - OMEGA];
}

static double particle_value(const struct tsim *sim, size_t i, int k)
{
	const struct ts_instance *inst;

	for (size_t n = 0; (inst = ts_sim_next_of(sim, TS_KIND_FIX, TS_FAMILY_STREAM, &n));) {
		const struct ts_stream *stream = inst->state;
		const double *memory = ts_stream_record(stream, sim, i);

		if (memory[TS_STREAM_START] > 0)
			return stream_value(stream, sim, memory, k);
	}
	return 0;
}

static bool has_quantity(const struct tsim *sim, const char *name)
{
	return quantity_index(sim, name) >= 0;
}

static enum ts_status quantity(struct tsim *sim, const char *name, struct ts_table *out)
{
	size_t n = sim->particles->n;
	int k = quantity_index(sim, name);

	if (ts_table_resize(out, n, 1) != TS_OK)
		return ts_nomem(&sim->error);
	for (size_t i = 0; i < n; i++)
		out->data[i] = particle_value(sim, i, k);
	return TS_OK;
}

const struct ts_system_style ts_stream_system = {
	.style = { .name = "stream",
		   .kind = TS_KIND_SYSTEM,
		   .summary = "quantities of the particles of a stream" },
	.no_instance = true,
	.has_quantity = has_quantity,
	.keeps_quantity = has_quantity,
	.quantity = quantity,
};
