/* Sampling of a fluid at any position by names of quantities: computes flow/probe, flow/line and
 * flow/plane.
 *
 * Along each axis values are interpolated by the Lagrange polynomial through the nearest 2 or 4 points;
 * for velocities along a boundary, and for scalars where it gives their value, the value on the boundary
 * is one of them. The error is of order h^2 or h^4. Vorticity is always interpolated linearly between the
 * edges on which it is defined. */
#ifndef TS_FLOW_FLOW_SAMPLING_H
#define TS_FLOW_FLOW_SAMPLING_H

#include "core/name_list.h"
#include "flow/fluid.h"
#include "flow/transported_scalars.h"

/* First member of the state of these computes. */
struct ts_flow_sampler {
	struct ts_words words; /* argument */
	int interpolation;     /* argument */
	struct ts_name_list list;
	struct ts_flow_scalar *carried; /* of each column f_ID: valid while a table is made */
	struct tsim *sim;
};
extern const char *const ts_flow_interpolations[];
#define TS_FLOW_SAMPLE_ARGS(T)                                                                             \
	TS_SOME_KEYWORD("values", T, sampler.words, 0,                                                     \
			.help = "columns: x, y, z, s (distance from the first point), vx, vy, vz, speed, " \
				"p, void, wx, wy, wz (vorticity), vorticity (its magnitude), f_ID (a "     \
				"scalar "                                                                  \
				"of fix flow/scalar); "                                                    \
				"default: vx vy vz p"),                                                    \
		TS_ENUM("interpolation", T, sampler.interpolation, ts_flow_interpolations,                 \
			.fallback = "linear", .help = "through the nearest 2 or 4 values along each axis")
#define TS_FLOW_SAMPLE_DOC                                                                               \
	"The keyword `values` selects the columns: coordinates, velocity components, speed, pressure,\n" \
	"void fraction (1 without fix void_fraction), vorticity, transported scalars. Values between\n"  \
	"the points of the grid are interpolated through the nearest 2 values along each axis, with\n"   \
	"`interpolation cubic` through 4, of which the velocity on a wall is one, and the T that fix\n"  \
	"flow/scalar gives on a face by `value`; vorticity is always interpolated linearly."

/* Reads the words as names of values, for an owner `who` ("compute flow/probe"); checks that there is a fluid. */
enum ts_status ts_flow_sampler_read(struct ts_flow_sampler *sampler, struct tsim *sim, struct ts_arena *arena,
				    const char *who, const struct ts_place *where);
/* Before samples are taken: finds the fluid and the scalar fields. */
enum ts_status ts_flow_sampler_fetch(struct ts_flow_sampler *sampler, struct tsim *sim, const char *who,
				     const struct ts_place *where, struct ts_fluid **fluid);
/* Called in the init of such a compute: reads the words, checks that there is a fluid. */
enum ts_status ts_flow_sampler_init(struct ts_instance *self, struct tsim *sim);
/* An error at `where` if x is outside the grid. */
enum ts_status ts_flow_sampler_inside(struct ts_instance *self, struct tsim *sim, const double x[3],
				      const struct ts_place *where);
/* Computes one row of the table; `s`: distance along a line. */
void ts_flow_sample(const struct ts_flow_sampler *sampler, const struct ts_fluid *fluid, const double x[3],
		    double s, double *out);
/* Finds the fluid, and makes the table for that number of rows. */
enum ts_status ts_flow_sampler_begin(struct ts_instance *self, size_t rows, struct ts_table *out,
				     struct ts_fluid **fluid);
/* The values c_ID[k], which are the first row of the table that `eval` makes. */
enum ts_status ts_flow_sampler_first_row(
	struct ts_instance *self, const struct tsim *sim, struct ts_table *out,
	enum ts_status (*eval)(struct ts_instance *self, const struct tsim *sim, struct ts_table *out));

#endif
