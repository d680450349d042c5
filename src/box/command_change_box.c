/* Command change_box: changes lengths and boundary conditions of the box, and remaps particles. */
#include "core/sim.h"

#include <math.h>
#include <string.h>

#include "bond/bonds.h"
#include "box/domain.h"
#include "particle/exchange.h"
#include "particle/identity.h"
#include "particle/particles.h"
#include "region/region.h"

#include "base/banned.h"

struct state {
	int group, units;
	struct ts_words operations;
};

enum { X, Y, Z, BOUNDARY, SET, REMAP, ORTHO, TRICLINIC, XY, XZ, YZ };
enum { FINAL, DELTA, SCALE, VOLUME };

/* One operation. */
struct change {
	int what, how;
	double lo, hi, factor;
	const char *face[3];
	struct ts_words tilt;
};

/* Lower and upper faces of the box. */
struct box {
	double lo[3], hi[3];
};

struct work {
	struct tsim *sim;
	const struct state *state;
	const struct ts_place *where;
	struct ts_arena arena;
	struct box now, set; /* now: box after the operations so far; set: box from which remap starts */
	struct box before;   /* box before the last operation x, y or z that was not `volume` */
	int changed;	     /* dimension of that operation, or -1 */
	size_t crossing[3];  /* bonds that cross the periodic faces of the box before the command */
};

static double length(const struct box *b, int dim)
{
	return b->hi[dim] - b->lo[dim];
}

static void set_length(struct box *b, int dim, double to)
{
	double middle = 0.5 * (b->lo[dim] + b->hi[dim]);

	b->lo[dim] = middle - 0.5 * to;
	b->hi[dim] = middle + 0.5 * to;
}

/* ---- the operations */

/* Two consecutive `volume` operations share the correction, each by the square root, so that the ratio
 * of their lengths is kept. */
static enum ts_status keep_volume(struct work *w, int dim, bool shared)
{
	double ratio;

	if (w->changed < 0 || w->changed == dim)
		return ts_fail(&w->sim->error, TS_SYNTAX, w->where,
			       "change_box: %c volume must follow a change of another dimension", 'x' + dim);
	ratio = length(&w->before, w->changed) / length(&w->now, w->changed);
	set_length(&w->now, dim, length(&w->before, dim) * (shared ? sqrt(ratio) : ratio));
	return TS_OK;
}

static enum ts_status change_length(struct work *w, const struct change *c, bool shared)
{
	double scale = ts_domain_scale(w->sim, w->state->units, c->what);
	int dim = c->what;

	if (c->how == VOLUME)
		return keep_volume(w, dim, shared);
	w->before = w->now;
	w->changed = dim;
	if (c->how == SCALE) {
		set_length(&w->now, dim, c->factor * length(&w->now, dim));
		return TS_OK;
	}
	w->now.lo[dim] = scale * c->lo + (c->how == DELTA ? w->now.lo[dim] : 0);
	w->now.hi[dim] = scale * c->hi + (c->how == DELTA ? w->now.hi[dim] : 0);
	return TS_OK;
}

static enum ts_status count_crossing_bonds(struct work *w)
{
	const struct ts_bonds *b = w->sim->bonds;
	const struct ts_particles *p = w->sim->particles;
	const struct ts_box *box = &w->sim->domain->box;
	struct ts_identities map;

	if (b->n)
		TS_TRY(ts_identities(w->sim, false, &map));
	for (size_t k = 0; k < b->n; k++) {
		int32_t i = ts_identity_row(&map, b->tag[k][0]), j = ts_identity_row(&map, b->tag[k][1]);

		for (int d = 0; i >= 0 && j >= 0 && d < 3; d++)
			w->crossing[d] += ts_box_periodic(box, d) &&
					  fabs(p->x[i][d] - p->x[j][d]) > 0.5 * ts_box_length(box, d);
	}
	return TS_OK;
}

/* A bond across a periodic face would extend through the whole box without it. */
static enum ts_status refuse_crossing_bonds(const struct work *w, int dim)
{
	if (!w->crossing[dim])
		return TS_OK;
	return ts_fail(&w->sim->error, TS_STATE, w->where,
		       "change_box boundary: %zu bonds cross the faces of %c, which would no longer be "
		       "periodic; remove them before (delete_bonds)",
		       w->crossing[dim], 'x' + dim);
}

/* Sets the boundary styles; the image counts of dimensions that become non-periodic are set to 0. */
static enum ts_status change_faces(struct work *w, const struct change *c)
{
	struct ts_particles *p = w->sim->particles;
	struct ts_box *box = &w->sim->domain->box;
	enum ts_face face[3][2];

	TS_TRY(ts_domain_read_faces(w->sim, c->face, w->where, face));
	for (int d = 0; d < 3; d++) {
		if (!ts_box_periodic(box, d) || !face[d][0])
			continue;
		TS_TRY(refuse_crossing_bonds(w, d));
		for (size_t i = 0; i < p->n; i++)
			p->image[i][d] = 0;
	}
	memcpy(box->face, face, sizeof face);
	return TS_OK;
}

static void remap_particles(struct work *w)
{
	struct ts_particles *p = w->sim->particles;

	for (size_t i = 0; i < p->n; i++)
		for (int d = 0; ts_in_group(p, i, w->state->group) && d < 3; d++)
			p->x[i][d] = w->now.lo[d] +
				     (p->x[i][d] - w->set.lo[d]) / length(&w->set, d) * length(&w->now, d);
	w->set = w->now;
}

static enum ts_status apply_operation(struct work *w, const struct change *c, bool shared)
{
	switch (c->what) {
	case X:
	case Y:
	case Z:
		return change_length(w, c, shared);
	case BOUNDARY:
		return change_faces(w, c);
	case SET:
		w->set = w->now;
		break;
	case REMAP:
		remap_particles(w);
		break;
	case ORTHO: /* the box always is orthogonal */
		break;
	default:
		return ts_fail(&w->sim->error, TS_STATE, w->where,
			       "change_box: boxes with tilted faces are not supported");
	}
	return TS_OK;
}

/* ---- parsing */

static const struct ts_arg final_rows[] = {
	TS_REAL("lo", struct change, lo, .flags = TS_POSITIONAL, .unit = "length", .help = "low face"),
	TS_REAL("hi", struct change, hi, .flags = TS_POSITIONAL, .unit = "length", .help = "high face"),
	TS_ARGS_END,
};

static const struct ts_arg delta_rows[] = {
	TS_REAL("dlo", struct change, lo, .flags = TS_POSITIONAL, .unit = "length",
		.help = "shift of the low face"),
	TS_REAL("dhi", struct change, hi, .flags = TS_POSITIONAL, .unit = "length",
		.help = "shift of the high face"),
	TS_ARGS_END,
};

static const struct ts_arg scale_rows[] = {
	TS_REAL("factor", struct change, factor, .flags = TS_POSITIONAL, .range = TS_POSITIVE,
		.help = "factor of the length; the centre is kept"),
	TS_ARGS_END,
};

static const struct ts_mode length_styles[] = {
	[FINAL] = { "final", "faces at lo and hi", final_rows },
	[DELTA] = { "delta", "faces shifted by dlo and dhi", delta_rows },
	[SCALE] = { "scale", "length multiplied by a factor", scale_rows },
	[VOLUME] = { "volume", "length such that the volume is that before the last change", NULL },
	{ .name = NULL },
};

static const struct ts_arg resize_rows[] = {
	TS_MODE("style", struct change, how, length_styles, .help = "how the new length is given"),
	TS_ARGS_END,
};

static const struct ts_arg boundary_rows[] = {
	TS_WORD("x", struct change, face[0], .flags = TS_POSITIONAL, .help = "faces normal to x"),
	TS_WORD("y", struct change, face[1], .flags = TS_POSITIONAL, .help = "faces normal to y"),
	TS_WORD("z", struct change, face[2], .flags = TS_POSITIONAL, .help = "faces normal to z"),
	TS_ARGS_END,
};

static const struct ts_arg tilt_rows[] = {
	TS_REST("tilt", struct change, tilt, .help = "not supported"),
	TS_ARGS_END,
};

static const struct ts_mode operations[] = {
	[X] = { "x", "length along x", resize_rows },
	[Y] = { "y", "length along y", resize_rows },
	[Z] = { "z", "length along z", resize_rows },
	[BOUNDARY] = { "boundary", "boundary styles of the faces", boundary_rows },
	[SET] = { "set", "store the current box as reference of remap", NULL },
	[REMAP] = { "remap", "map the particles from the reference box to the current box", NULL },
	[ORTHO] = { "ortho", "no effect: the box is orthogonal", NULL },
	[TRICLINIC] = { "triclinic", "not supported: the box is orthogonal", NULL },
	[XY] = { "xy", "not supported: the box is orthogonal", tilt_rows },
	[XZ] = { "xz", "not supported: the box is orthogonal", tilt_rows },
	[YZ] = { "yz", "not supported: the box is orthogonal", tilt_rows },
	{ .name = NULL },
};

static const struct ts_arg change_rows[] = {
	TS_MODE("operation", struct change, what, operations, .help = "operation"),
	TS_ARGS_END,
};

/* The words of the first operation of the list. */
static struct ts_words first_operation(struct ts_words words)
{
	struct ts_words part = words;

	for (part.n = 1; part.n < words.n; part.n++)
		for (int k = 0; operations[k].name; k++)
			if (ts_streq(words.word[part.n].text, operations[k].name))
				return part;
	return part;
}

static enum ts_status parse_next_operation(struct work *w, struct ts_words *rest, struct change *c)
{
	struct ts_words part = first_operation(*rest);

	*c = (struct change){ 0 };
	*rest = ts_words_from(*rest, part.n);
	return ts_args_parse(w->sim, "change_box", change_rows, part, &part.word[0].place, &w->arena, c);
}

static bool keeps_volume(const struct change *c)
{
	return c->what <= Z && c->how == VOLUME;
}

static enum ts_status apply_operations(struct work *w)
{
	struct ts_words rest = w->state->operations;
	struct change c, next = { .what = -1 };
	bool last_kept = false;

	TS_TRY(parse_next_operation(w, &rest, &c));
	for (;;) {
		bool more = rest.n > 0;
		bool keeps = keeps_volume(&c), shared = keeps && last_kept;

		if (more)
			TS_TRY(parse_next_operation(w, &rest, &next));
		if (keeps && more && keeps_volume(&next) && next.what != c.what)
			shared = true;
		TS_TRY(apply_operation(w, &c, shared));
		if (!more)
			return TS_OK;
		last_kept = keeps;
		c = next;
	}
}

static enum ts_status change_box(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct ts_domain *domain = sim->domain;
	struct work w = { .sim = sim, .state = state, .where = where, .changed = -1 };
	enum ts_status status;

	TS_TRY(ts_domain_refuse_shear(sim, "change_box", where));
	ts_domain_units_said(sim, w.state->units, where);
	TS_TRY(ts_exchange_migrate(sim)); /* the last list may be older than the positions */
	memcpy(w.now.lo, domain->box.lo, sizeof w.now.lo);
	memcpy(w.now.hi, domain->box.hi, sizeof w.now.hi);
	w.set = w.now;
	TS_TRY(count_crossing_bonds(&w));
	status = apply_operations(&w);
	ts_arena_release(&w.arena);
	TS_TRY(status);
	TS_TRY(ts_domain_set_box(sim, w.now.lo, w.now.hi, where));
	TS_TRY(sim->particles->bodies_follow(sim, false, "change_box", where));
	TS_TRY(ts_exchange_migrate(sim));
	ts_log(&sim->log, "Changed box = (%g %g %g) to (%g %g %g)\n", domain->box.lo[0], domain->box.lo[1],
	       domain->box.lo[2], domain->box.hi[0], domain->box.hi[1], domain->box.hi[2]);
	return TS_OK;
}

static const struct ts_arg args[] = {
	TS_GROUP("group", struct state, group, .flags = TS_POSITIONAL,
		 .help = "group of particles moved by remap"),
	TS_LIST("operations", struct state, operations,
		.help = "x, y or z final lo hi | delta dlo dhi | scale factor | volume; boundary x y z; set; "
			"remap"),
	TS_ENUM("units", struct state, units, ts_region_units, .flags = TS_OPTIONAL,
		.help = "lengths in lattice spacings (lattice) or in the units of the script (box)"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_change_box)
const struct ts_command_style ts_command_change_box = {
	.style = {
		.name = "change_box",
		.kind = TS_KIND_COMMAND,
		.summary = "changes lengths and boundary conditions of the box",
		.doc = "The operations are applied one after another. scale and volume keep the centre of the "
		       "box. volume changes a length so that it compensates the change of volume by the "
		       "preceding x, y or z operation; two consecutive volume operations each compensate the "
		       "square root of it.\n\n"
		       "Particle positions do not change except by remap, which maps the particles of the "
		       "group from the reference box to the current one, x -> lo' + (x - lo) l'/l. The "
		       "reference is the box at the last set or remap, or that before the command.\n\n"
		       "Before and finally positions are wrapped into the periodic box, particles outside of fixed faces "
		       "are lost (see thermo_modify lost), faces of style s and m are fitted to the "
		       "particles, and the new box becomes the minimum box of m faces. In dimensions that are "
		       "no longer periodic the image counts (ix iy iz) are set to 0; bonds across their faces are an error.",
		.example = "change_box all x scale 1.1 y volume z volume remap units box\n"
			   "change_box all z final 0 0.5 boundary p p f units box",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.needs_box = true,
	.run = change_box,
};
