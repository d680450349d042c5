/* Command change_box: other lengths and faces for the box, and particles that go with it. */
#include "core/sim.h"

#include <math.h>
#include <string.h>

#include "box/domain.h"
#include "particle/exchange.h"
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

/* The box as the operations change it one after another. */
struct box {
	double lo[3], hi[3];
};

struct work {
	struct tsim *sim;
	const struct state *state;
	const struct ts_place *where;
	struct ts_arena arena;
	struct box now, set; /* set: where remap starts from */
	struct box before;   /* the last x, y or z that was not `volume` */
	int changed;	     /* the dimension of that one, or -1 */
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

/* Two operations `volume` in a row share the correction, so that their lengths keep their ratio. */
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

static enum ts_status resize(struct work *w, const struct change *c, bool shared)
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

/* Where a dimension is no longer periodic, particles have not crossed its faces. */
static enum ts_status new_faces(struct work *w, const struct change *c)
{
	struct ts_particles *p = w->sim->particles;
	struct ts_box *box = &w->sim->domain->box;
	enum ts_face face[3][2];

	TS_TRY(ts_domain_read_faces(w->sim, c->face, w->where, face));
	for (int d = 0; d < 3; d++)
		for (size_t i = 0; ts_box_periodic(box, d) && face[d][0] && i < p->n; i++)
			p->image[i][d] = 0;
	memcpy(box->face, face, sizeof face);
	return TS_OK;
}

static void remap(struct work *w)
{
	struct ts_particles *p = w->sim->particles;

	for (size_t i = 0; i < p->n; i++)
		for (int d = 0; ts_in_group(p, i, w->state->group) && d < 3; d++)
			p->x[i][d] = w->now.lo[d] +
				     (p->x[i][d] - w->set.lo[d]) / length(&w->set, d) * length(&w->now, d);
	w->set = w->now;
}

static enum ts_status apply(struct work *w, const struct change *c, bool shared)
{
	switch (c->what) {
	case X:
	case Y:
	case Z:
		return resize(w, c, shared);
	case BOUNDARY:
		return new_faces(w, c);
	case SET:
		w->set = w->now;
		break;
	case REMAP:
		remap(w);
		break;
	case ORTHO: /* it always is */
		break;
	default:
		return ts_fail(&w->sim->error, TS_STATE, w->where,
			       "change_box: boxes with tilted faces are known, but not built");
	}
	return TS_OK;
}

/* ---- reading them */

static const struct ts_arg final_rows[] = {
	TS_REAL("lo", struct change, lo, .flags = TS_POSITIONAL, .unit = "length", .help = "lower face"),
	TS_REAL("hi", struct change, hi, .flags = TS_POSITIONAL, .unit = "length", .help = "upper face"),
	TS_ARGS_END,
};

static const struct ts_arg delta_rows[] = {
	TS_REAL("dlo", struct change, lo, .flags = TS_POSITIONAL, .unit = "length",
		.help = "shift of the lower face"),
	TS_REAL("dhi", struct change, hi, .flags = TS_POSITIONAL, .unit = "length",
		.help = "shift of the upper face"),
	TS_ARGS_END,
};

static const struct ts_arg scale_rows[] = {
	TS_REAL("factor", struct change, factor, .flags = TS_POSITIONAL, .range = TS_POSITIVE,
		.help = "factor of the length, about the middle"),
	TS_ARGS_END,
};

static const struct ts_mode hows[] = {
	[FINAL] = { "final", "the faces are at lo and hi", final_rows },
	[DELTA] = { "delta", "the faces move by dlo and dhi", delta_rows },
	[SCALE] = { "scale", "the length is multiplied", scale_rows },
	[VOLUME] = { "volume", "as much as keeps the volume before the last change", NULL },
	{ .name = NULL },
};

static const struct ts_arg resize_rows[] = {
	TS_MODE("style", struct change, how, hows, .help = "how the length is given"),
	TS_ARGS_END,
};

static const struct ts_arg boundary_rows[] = {
	TS_WORD("x", struct change, face[0], .flags = TS_POSITIONAL, .help = "faces across x"),
	TS_WORD("y", struct change, face[1], .flags = TS_POSITIONAL, .help = "faces across y"),
	TS_WORD("z", struct change, face[2], .flags = TS_POSITIONAL, .help = "faces across z"),
	TS_ARGS_END,
};

static const struct ts_arg tilt_rows[] = {
	TS_REST("tilt", struct change, tilt, .help = "not built"),
	TS_ARGS_END,
};

static const struct ts_mode changes[] = {
	[X] = { "x", "length along x", resize_rows },
	[Y] = { "y", "length along y", resize_rows },
	[Z] = { "z", "length along z", resize_rows },
	[BOUNDARY] = { "boundary", "other faces", boundary_rows },
	[SET] = { "set", "remember the box for remap", NULL },
	[REMAP] = { "remap", "move the particles as the box changed", NULL },
	[ORTHO] = { "ortho", "no effect: the box is a cuboid", NULL },
	[TRICLINIC] = { "triclinic", "known, but not built", NULL },
	[XY] = { "xy", "known, but not built", tilt_rows },
	[XZ] = { "xz", "known, but not built", tilt_rows },
	[YZ] = { "yz", "known, but not built", tilt_rows },
	{ .name = NULL },
};

static const struct ts_arg change_rows[] = {
	TS_MODE("operation", struct change, what, changes, .help = "what is changed"),
	TS_ARGS_END,
};

/* The words up to the next operation. */
static struct ts_words first_part(struct ts_words words)
{
	struct ts_words part = words;

	for (part.n = 1; part.n < words.n; part.n++)
		for (int k = 0; changes[k].name; k++)
			if (ts_streq(words.word[part.n].text, changes[k].name))
				return part;
	return part;
}

static enum ts_status next_change(struct work *w, struct ts_words *rest, struct change *c)
{
	struct ts_words part = first_part(*rest);

	*c = (struct change){ 0 };
	*rest = ts_words_from(*rest, part.n);
	return ts_args_parse(w->sim, "change_box", change_rows, part, &part.word[0].place, &w->arena, c);
}

static bool keeps_volume(const struct change *c)
{
	return c->what <= Z && c->how == VOLUME;
}

static enum ts_status apply_all(struct work *w)
{
	struct ts_words rest = w->state->operations;
	struct change c, next = { .what = -1 };
	bool last_kept = false;

	TS_TRY(next_change(w, &rest, &c));
	for (;;) {
		bool more = rest.n > 0;
		bool keeps = keeps_volume(&c), shared = keeps && last_kept;

		if (more)
			TS_TRY(next_change(w, &rest, &next));
		if (keeps && more && keeps_volume(&next) && next.what != c.what)
			shared = true;
		TS_TRY(apply(w, &c, shared));
		if (!more)
			return TS_OK;
		last_kept = keeps;
		c = next;
	}
}

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct ts_domain *domain = sim->domain;
	struct work w = { .sim = sim, .state = state, .where = where, .changed = -1 };
	enum ts_status status;

	ts_domain_units_said(sim, w.state->units, where);
	memcpy(w.now.lo, domain->box.lo, sizeof w.now.lo);
	memcpy(w.now.hi, domain->box.hi, sizeof w.now.hi);
	w.set = w.now;
	status = apply_all(&w);
	ts_arena_release(&w.arena);
	TS_TRY(status);
	TS_TRY(ts_domain_set_box(sim, w.now.lo, w.now.hi, where));
	TS_TRY(ts_exchange_migrate(sim));
	ts_log(&sim->log, "Changed box = (%g %g %g) to (%g %g %g)\n", domain->box.lo[0], domain->box.lo[1],
	       domain->box.lo[2], domain->box.hi[0], domain->box.hi[1], domain->box.hi[2]);
	return TS_OK;
}

static const struct ts_arg args[] = {
	TS_GROUP("group", struct state, group, .flags = TS_POSITIONAL, .help = "particles that remap moves"),
	TS_LIST("operations", struct state, operations,
		.help = "x, y or z final lo hi | delta dlo dhi | scale factor | volume; boundary x y z; "
			"set; remap"),
	TS_ENUM("units", struct state, units, ts_region_units, .flags = TS_OPTIONAL,
		.help = "whether lengths are given in lattice spacings or as they are"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_change_box)
const struct ts_command_style ts_command_change_box = {
	.style = {
		.name = "change_box",
		.kind = TS_KIND_COMMAND,
		.summary = "Changes lengths and faces of the box",
		.doc = "The operations act one after another. scale and volume keep the middle of the box.\n"
		       "volume makes up for the change of volume by the last x, y or z before it; two of "
		       "them in\n"
		       "a row share it, each by the square root.\n\n"
		       "Particles stay where they are unless remap says otherwise: it moves those of the "
		       "group\n"
		       "from the box at the beginning, or at the last set or remap, to the present one,\n"
		       "x -> lo' + (x - lo) l'/l.\n\n"
		       "At the end positions are wrapped into periodic faces, particles outside of fixed "
		       "faces\n"
		       "are lost (see thermo_modify lost), faces of boundary s and m are fitted to the "
		       "particles,\n"
		       "and the box is the least one of m faces. Where a dimension is no longer periodic, "
		       "the\n"
		       "counts of crossings (ix iy iz) become 0.",
		.example = "change_box all x scale 1.1 y volume z volume remap units box\n"
			   "change_box all z final 0 0.5 boundary p p f units box",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.needs_box = true,
	.run = run,
};
