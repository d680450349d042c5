/* Computes multisphere and multisphere/single: properties of rigid bodies. */
#include "rigid/rigid.h"

#include <string.h>

#include "math/quaternion.h"

#include "base/banned.h"

struct state {
	int property;
	int64_t id; /* of multisphere/single: id of the body */
};

/* A property: `columns` numbers at `offset` in struct ts_body, or written by `make`. */
struct property {
	const char *name;
	size_t columns, offset;
	void (*make)(const struct ts_rigid *r, size_t b, double *out);
};

static void write_id(const struct ts_rigid *r, size_t b, double *out)
{
	out[0] = r->id[b];
}

static void principal_axis(const struct ts_rigid *r, size_t b, int k, double *out)
{
	double m[3][3];

	ts_quaternion_matrix(r->body[b].q, m);
	for (int d = 0; d < 3; d++)
		out[d] = m[d][k];
}

static void write_ex(const struct ts_rigid *r, size_t b, double *out)
{
	principal_axis(r, b, 0, out);
}

static void write_ey(const struct ts_rigid *r, size_t b, double *out)
{
	principal_axis(r, b, 1, out);
}

static void write_ez(const struct ts_rigid *r, size_t b, double *out)
{
	principal_axis(r, b, 2, out);
}

/* F(name, field of the body), M(name, columns, function) */
/* clang-format off */
#define PROPERTY_LIST(F, M)                                                                        \
	F("xcm", x) F("vcm", v) F("fcm", force) F("torque", torque) F("quat", q)                   \
	F("angmom", spin) F("omega", omega) F("density", density) F("masstotal", mass)             \
	F("inertia", inertia) F("clumptype", kind) F("type", kind) M("id_multisphere", 1, write_id) \
	M("id", 1, write_id) M("ex_space", 3, write_ex) M("ey_space", 3, write_ey)                    \
	M("ez_space", 3, write_ez)
/* clang-format on */

#define FIELD_ROW(name, f) { name, sizeof(((struct ts_body *)0)->f) / 8, offsetof(struct ts_body, f), NULL },
#define MADE_ROW(name, columns, make) { name, columns, 0, make },
#define FIELD_NAME(name, f) name,
#define MADE_NAME(name, columns, make) name,

static const struct property properties[] = { PROPERTY_LIST(FIELD_ROW, MADE_ROW) };
static const char *const names[] = { PROPERTY_LIST(FIELD_NAME, MADE_NAME) NULL };

static void copy_property(const struct property *property, const struct ts_rigid *r, size_t b, double *to)
{
	if (property->make)
		property->make(r, b, to);
	else
		memcpy(to, (const char *)&r->body[b] + property->offset, property->columns * sizeof *to);
}

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct state *s = self->state;
	const struct property *property = &properties[s->property];
	const struct ts_rigid *r = sim->rigid;

	TS_TRY(ts_table_resize(out, r->n, property->columns));
	for (size_t b = 0; b < r->n; b++)
		copy_property(property, r, b, out->data + b * property->columns);
	return TS_OK;
}

static const struct ts_value values[] = {
	{ "bodies", "", "the property, one row per body", TS_LOCAL, 0, NULL, eval },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_ENUM("property", struct state, property, names,
		.help = "of the centre of mass: position, velocity, force, torque; orientation, angular "
			"momentum and velocity; mass, principal moments and axes; number of the template; "
			"id"),
	TS_ARGS_END,
};

TS_STYLE(compute, ts_style, ts_compute_multisphere)
const struct ts_style ts_compute_multisphere = {
	.name = "multisphere",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE,
	.summary = "A property of all rigid bodies",
	.doc = "A property of all rigid bodies, one row per body in the order of their ids, for dump local. "
	       "The group has no effect.",
	.example = "compute centres all multisphere property xcm\n"
		   "dump bodies all local 100 bodies.txt c_centres[1] c_centres[2] c_centres[3]",
	.args = args,
	.state_size = sizeof(struct state),
	.values = values,
};

/* ---- compute multisphere/single ---- */

/* All numbers are 0 if the body does not exist. */
static enum ts_status eval_one(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct state *s = self->state;
	const struct property *property = &properties[s->property];
	const struct ts_rigid *r = sim->rigid;

	TS_TRY(ts_table_resize(out, property->columns, 1));
	memset(out->data, 0, property->columns * sizeof *out->data);
	for (size_t b = 0; b < r->n; b++)
		if (r->id[b] == s->id)
			copy_property(property, r, b, out->data);
	return TS_OK;
}

static bool gives(const struct ts_instance *self, const struct ts_value *value)
{
	const struct state *s = self->state;

	return (properties[s->property].columns == 1) == (value->shape == TS_SCALAR);
}

static const struct ts_value values_of_one[] = {
	{ "number", "", "the property, if it is one number", TS_SCALAR, 1, NULL, eval_one },
	{ "numbers", "", "the property, if it has several components", TS_VECTOR, 0, NULL, eval_one },
	{ .name = NULL },
};

static const struct ts_arg args_of_one[] = {
	TS_INT("id", struct state, id, .range = TS_POSITIVE, .help = "id of the body, 1 or larger"),
	TS_ENUM("property", struct state, property, names, .help = "as for compute multisphere"),
	TS_ARGS_END,
};

TS_STYLE(compute, ts_style, ts_compute_multisphere_single)
const struct ts_style ts_compute_multisphere_single = {
	.name = "multisphere/single",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE,
	.summary = "A property of one rigid body",
	.doc = "A property of one rigid body: c_ID, or c_ID[1], c_ID[2] ... if it has several components. It "
	       "is 0 while there is no body with this id. (LIGGGHTS 3.8 always gives the first body.) The "
	       "group has no effect.",
	.example = "compute centre all multisphere/single id 1 property xcm\n"
		   "thermo_style custom step c_centre[3]",
	.args = args_of_one,
	.state_size = sizeof(struct state),
	.values = values_of_one,
	.gives = gives,
};
