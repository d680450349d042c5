/* Per-particle data of fix insert/stream, also read by tracers and outputs. */
#ifndef TS_INSERT_STREAM_H
#define TS_INSERT_STREAM_H

#include "insert/insertion.h"
#include "particle/particles.h"

#define TS_FAMILY_STREAM "stream"

/* Numbers of each particle; all are 0 for particles of other origin. */
enum {
	TS_STREAM_START,    /* age of the stream when it was inserted */
	TS_STREAM_RELEASE,  /* age when it passes the face; negative afterwards */
	TS_STREAM_DISTANCE, /* initial distance to the face; -1: a copy, of a body whose first sphere has it */
	TS_STREAM_VELOCITY,			  /* velocity that it gets at the face, 3 numbers */
	TS_STREAM_PLACE = TS_STREAM_VELOCITY + 3, /* initial position, 3 numbers */
	TS_STREAM_WIDTH = TS_STREAM_PLACE + 3
};

/* First member of the state of every style of the family. */
struct ts_stream {
	struct ts_insertion base;
	size_t column;	 /* index of the column of TS_STREAM_WIDTH numbers */
	int64_t age;	 /* saved: number of steps since the fix was defined */
	double drift[3]; /* velocity of particles moving to the face */
};

/* The TS_STREAM_WIDTH numbers of particle i. */
static inline double *ts_stream_record(const struct ts_stream *stream, const struct tsim *sim, size_t i)
{
	return (double *)sim->particles->column[stream->column].data + i * TS_STREAM_WIDTH;
}

/* Per-particle quantities release_fix_insert_stream[1] to [14], as in LIGGGHTS: position and step of the
 * insertion, step in which the particle passes the face, its velocity until then, and velocity and angular
 * velocity that it gets there. */
extern const struct ts_system_style ts_stream_system;

#endif
