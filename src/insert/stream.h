/* The stream of particles of fix insert/stream, for those who watch it. */
#ifndef TS_INSERT_STREAM_H
#define TS_INSERT_STREAM_H

#include "insert/insertion.h"
#include "particle/particles.h"

#define TS_FAMILY_STREAM "stream"

/* What a particle of the stream remembers until it goes through the face: at which age of the stream it
 * came and goes through (as a negative number when it has), its way to the face, the velocity that it gets
 * there, the place where it began. All are 0 of others. */
enum {
	TS_STREAM_START,
	TS_STREAM_RELEASE,
	TS_STREAM_WAY,
	TS_STREAM_VELOCITY,
	TS_STREAM_PLACE = TS_STREAM_VELOCITY + 3,
	TS_STREAM_MEMORY = TS_STREAM_PLACE + 3
};

/* First member of the state of every style of the family. */
struct ts_stream {
	struct ts_insertion base;
	size_t column;	 /* of the particles: TS_STREAM_MEMORY numbers */
	int64_t age;	 /* saved: steps done */
	double drift[3]; /* velocity on the way to the face */
};

static inline double *ts_stream_memory(const struct ts_stream *stream, const struct tsim *sim, size_t i)
{
	return (double *)sim->particles->column[stream->column].data + i * TS_STREAM_MEMORY;
}

/* What LIGGGHTS keeps of each particle of a stream, as quantities: release_fix_insert_stream[1] to [14],
 * place, step and velocity at which it began, the step in which it goes through the face, velocity and
 * angular velocity that it gets there. */
extern const struct ts_system_style ts_stream_system;

#endif
