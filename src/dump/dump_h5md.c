/* Dump h5md: trajectories of particles in an HDF5 file. */
#include <string.h>

#include "box/domain.h"
#include "core/sim.h"
#include "dump/dump.h"
#include "io/h5md.h"
#include "io/h5out.h"
#include "io/series.h"

#include "base/banned.h"

/* A quantity of the file: columns of the dump. */
struct element {
	const char *name;
	size_t components;
	int64_t every; /* frames between those that have it */
};

struct state {
	struct ts_dump_common common;
	struct ts_words words;
	struct ts_words names;	 /* of the columns */
	struct element *element; /* [nelements] */
	size_t nelements;
	struct ts_h5md_element *written; /* [nelements] those of the present frame */
	const char *author;
	const char *file_from; /* ID of a dump whose file this one shares; NULL: none */
	struct ts_table merged;
};

/* The words of LAMMPS, and the names of H5MD. */
static const struct {
	const char *name, *column[3];
	size_t components;
} known[] = {
	{ "position", { "x", "y", "z" }, 3 },
	{ "image", { "ix", "iy", "iz" }, 3 },
	{ "velocity", { "vx", "vy", "vz" }, 3 },
	{ "force", { "fx", "fy", "fz" }, 3 },
	{ "species", { "type" }, 1 },
};
enum { NKNOWN = sizeof known / sizeof *known };

static enum ts_status add_columns(struct ts_instance *self, struct tsim *sim, const char *const *column,
				  size_t n, const struct ts_place *where)
{
	struct state *s = self->state;

	for (size_t k = 0; k < n; k++) {
		struct ts_word word = { .text = column[k], .place = *where };

		if (ts_words_append(&self->arena, (struct ts_words){ &word, 1 }, &s->names) != TS_OK)
			return ts_nomem(&sim->error);
	}
	return TS_OK;
}

/* Adds one of the known quantities, or a column. */
static enum ts_status add_element(struct ts_instance *self, struct tsim *sim, const struct ts_word *word)
{
	struct state *s = self->state;
	const char *const *column = &word->text;
	size_t components = 1;

	for (int k = 0; k < NKNOWN; k++)
		if (ts_streq(word->text, known[k].name)) {
			column = known[k].column;
			components = known[k].components;
		}
	for (size_t k = 0; k < s->nelements; k++)
		if (ts_streq(s->element[k].name, word->text))
			return ts_fail(&sim->error, TS_SYNTAX, &word->place, "dump h5md: '%s' is named twice",
				       word->text);
	s->element[s->nelements++] = (struct element){ word->text, components, 1 };
	return add_columns(self, sim, column, components, &word->place);
}

static enum ts_status read_every(struct state *s, struct tsim *sim, struct ts_words rest)
{
	struct element *e = &s->element[s->nelements - 1];

	if (s->nelements > 1 && rest.n > 1 && ts_parse_int(rest.word[1].text, &e->every) && e->every > 0)
		return TS_OK;
	return ts_fail(&sim->error, TS_SYNTAX, &rest.word[0].place,
		       "dump h5md: `every` must follow a quantity, and be followed by a number of frames > "
		       "0");
}

/* `box`, `create_group`: accepted as in LAMMPS, where yes is the default, too. */
static enum ts_status read_answer(struct tsim *sim, struct ts_words rest)
{
	if (rest.n > 1 && ts_streq(rest.word[1].text, "yes"))
		return TS_OK;
	return ts_fail(&sim->error, TS_SYNTAX, &rest.word[rest.n > 1].place,
		       "dump h5md: `%s` must be followed by yes: the file has the box and its groups",
		       rest.word[0].text);
}

static enum ts_status read_word(struct ts_instance *self, struct tsim *sim, struct ts_words rest,
				size_t *taken)
{
	struct state *s = self->state;
	const char *word = rest.word[0].text, **text = NULL;

	*taken = 2;
	if (ts_streq(word, "every"))
		return read_every(s, sim, rest);
	if (ts_streq(word, "box") || ts_streq(word, "create_group"))
		return read_answer(sim, rest);
	if (ts_streq(word, "author"))
		text = &s->author;
	if (ts_streq(word, "file_from"))
		text = &s->file_from;
	if (text && rest.n < 2)
		return ts_fail(&sim->error, TS_SYNTAX, &rest.word[0].place,
			       "dump h5md: `%s` must be followed by a %s", word,
			       text == &s->author ? "name" : "dump ID");
	if (text) {
		*text = rest.word[1].text;
		return TS_OK;
	}
	*taken = 1;
	return add_element(self, sim, &rest.word[0]);
}

static enum ts_status read_words(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	struct ts_word id = { .text = "id", .place = self->where };
	struct ts_words all;

	s->author = "not given";
	TS_TRY(ts_refs_expand(sim, &self->arena, s->words, TS_WANT(PERATOM), &all));
	s->element = ts_arena_alloc(&self->arena, all.n + 1, sizeof *s->element);
	s->written = ts_arena_alloc(&self->arena, all.n + 1, sizeof *s->written);
	if (!s->element || !s->written)
		return ts_nomem(&sim->error);
	TS_TRY(add_element(self, sim, &id));
	for (size_t k = 0, taken; k < all.n; k += taken)
		TS_TRY(read_word(self, sim, ts_words_from(all, k), &taken));
	if (s->nelements > 1)
		return TS_OK;
	return ts_fail(&sim->error, TS_SYNTAX, &self->where,
		       "dump h5md: say what to write: position, image, velocity, force, species, or columns "
		       "of dump custom");
}

/* A file has one dump, or several of different groups that name the first by `file_from`. */
static enum ts_status check_sharing(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_instances *dumps = &sim->instances[TS_KIND_DUMP];
	const struct state *s = self->state;
	struct ts_word id = { .text = s->file_from, .place = self->where };
	struct ts_instance *other = NULL;

	if (s->file_from)
		TS_TRY(ts_sim_require(sim, TS_KIND_DUMP, &id, &other));
	if (other && (other->style != self->style || other == self))
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "dump h5md: file_from needs another dump h5md, and %s is not one",
			       s->file_from);
	for (size_t k = 0; k < dumps->n; k++) {
		const struct ts_instance *with = dumps->item[k];
		const struct state *t = with->state;

		if (with == self || with->style != self->style || with->where.line > self->where.line ||
		    !(with == other || ts_streq(t->common.file, s->common.file)))
			continue;
		if (with->group == self->group)
			return ts_fail(&sim->error, TS_STATE, &self->where,
				       "dump h5md: dump %s writes the same group into '%s'", with->id,
				       t->common.file);
		if (!other)
			return ts_fail(&sim->error, TS_STATE, &self->where,
				       "dump h5md: dump %s writes '%s', too; share it by `file_from %s`",
				       with->id, t->common.file, with->id);
	}
	return TS_OK;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	if (!ts_h5out_available())
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "dump h5md: this tsim was built without HDF5 (apt-get install libhdf5-dev, "
			       "then ./configure); dump custom needs no library");
	if (!s->element)
		TS_TRY(read_words(self, sim));
	TS_TRY(check_sharing(self, sim));
	s->common.in_order = !strchr(s->common.file, '*');
	return ts_dump_columns(self, sim, s->names, false);
}

/* Columns first .. first + n - 1 as [row][n]. */
static void copy_columns(const struct ts_dump_common *d, size_t first, size_t n, double *to)
{
	for (size_t row = 0; row < d->nrows; row++)
		for (size_t k = 0; k < n; k++)
			*to++ = d->column[first + k].values.data[d->order[row]];
}

/* Fills `written` with the elements of this frame. */
static enum ts_status merge_columns(struct ts_instance *self, struct tsim *sim, size_t *n)
{
	struct state *s = self->state;
	const struct ts_dump_common *d = &s->common;
	size_t column = 0;
	double *to;

	*n = 0;
	if (ts_table_resize(&s->merged, d->nrows, d->ncolumns) != TS_OK)
		return ts_nomem(&sim->error);
	to = s->merged.data;
	for (size_t k = 0; k < s->nelements; column += s->element[k++].components) {
		const struct element *e = &s->element[k];

		if ((d->frames - 1) % e->every != 0)
			continue;
		copy_columns(d, column, e->components, to);
		s->written[(*n)++] = (struct ts_h5md_element){ e->name, to, e->components,
							       d->column[column].integer, e->every > 1 };
		to += d->nrows * e->components;
	}
	return TS_OK;
}

static void fill_box(const struct ts_box *box, struct ts_h5md_frame *frame)
{
	frame->sheared = box->shear.on;
	for (int d = 0; d < 3; d++) {
		frame->offset[d] = box->lo[d];
		frame->periodic[d] = ts_box_periodic(box, d);
		frame->edges[d][d] = ts_box_length(box, d);
	}
	if (box->shear.on)
		frame->edges[box->shear.gradient][box->shear.flow] = box->shear.offset;
}

/* The file; *fresh: it is to be replaced. */
static enum ts_status choose_file(struct ts_instance *self, struct tsim *sim, bool *fresh)
{
	struct state *s = self->state;
	struct ts_dump_common *d = &s->common;
	const struct ts_instance *other = s->file_from ? ts_sim_find(sim, TS_KIND_DUMP, s->file_from) : NULL;
	const struct state *t = other ? other->state : s;

	*fresh = !other && ((d->frames == 1 && !d->append) || strchr(d->file, '*'));
	if (other && !t->common.frames)
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "dump h5md: dump %s, whose file is shared, has not begun it yet", other->id);
	ts_series_path(&d->path, t->common.file, (long long)sim->clock.step, (int)t->common.pad);
	return d->path.failed ? ts_nomem(&sim->error) : TS_OK;
}

static enum ts_status output(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	struct ts_h5md_frame frame = { 0 };
	bool due, fresh;

	TS_TRY(ts_dump_due(self, sim, &due));
	if (!due)
		return TS_OK;
	TS_TRY(ts_dump_gather(self, sim, false));
	TS_TRY(merge_columns(self, sim, &frame.nelements));
	TS_TRY(choose_file(self, sim, &fresh));
	if (sim->reading.explain)
		return TS_OK;
	frame.group = ts_group_name(sim, self->group);
	frame.author = s->author;
	frame.step = sim->clock.step;
	frame.time = ts_sim_time(sim);
	frame.n = s->common.nrows;
	frame.element = s->written;
	fill_box(&sim->domain->box, &frame);
	TS_TRY(ts_h5md_append(sim, ts_str_text(&s->common.path), ts_instance_word(self, s->common.file),
			      &frame, fresh));
	return strchr(s->common.file, '*') ? ts_dump_keep_latest(&s->common, sim) : TS_OK;
}

static enum ts_status plan(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report)
{
	return ts_dump_price(self, sim, false, true, report);
}

static void fini(struct ts_instance *self)
{
	ts_table_release(&((struct state *)self->state)->merged);
	ts_dump_fini(self);
}

static const struct ts_arg args[] = {
	TS_INT("every", struct state, common.every, .flags = TS_POSITIONAL, .range = TS_POSITIVE,
	       .help = "steps between frames"),
	TS_WORD("file", struct state, common.file, .flags = TS_POSITIONAL | TS_WRITES | TS_SHARES,
		.help = "name of the file, usually ending in .h5; with a `*` for the step one file per "
			"frame"),
	TS_REST("words", struct state, words,
		.help = "in any order: position, image, velocity, force, species, or columns of dump custom: "
			"radius, mass, c_ID[k], f_ID[k], v_NAME ..., each with `every M`: in every M-th "
			"frame only; author NAME; file_from ID: the file is that of this dump, of another "
			"group; box yes, create_group yes: no effect"),
	TS_ARGS_END,
};

static const struct ts_saved saved[] = { TS_DUMP_SAVED(struct state), TS_SAVED_ROWS_END };

TS_STYLE(dump, ts_style, ts_dump_h5md)
const struct ts_style ts_dump_h5md = {
	.name = "h5md",
	.kind = TS_KIND_DUMP,
	.dump_words = TS_DUMP_SELECTION " refresh append",
	.ranks = TS_RANKS_WHOLE,
	.due = ts_dump_may_be_due,
	.names = ts_dump_names,
	.summary = "Trajectories of particles in an HDF5 file (H5MD)",
	.doc = "Appends frames to a file in the format H5MD 1.1 (de Buyl, Colberg and Hoefling 2014, Comput. "
	       "Phys. Commun. 185, 1546; nongnu.org/h5md), which Python (h5py), MATLAB, VMD and others "
	       "read:\n\n"
	       "  /particles/GROUP/box         edges, offset (the lower corner); attributes dimension, "
	       "boundary\n"
	       "  /particles/GROUP/NAME/value  [frame][particle], of vectors [frame][particle][3]\n"
	       "  /particles/GROUP/NAME/step   [frame]; also time\n\n"
	       "NAME is id, which is always written, position, image, velocity, force, species (the type), "
	       "or the name of the column. Particles are in the order of their ids. If their number changes, "
	       "the arrays are as long as the largest frame: particles that a frame does not have are -1 in "
	       "integers and NaN in reals. Numbers are in double precision, compressed by zlib.\n\n"
	       "The file is closed after each frame, so that it can be read during the run. A frame is "
	       "complete or missing: a run that is interrupted or fills the disk leaves a file with all "
	       "previous frames; if it is killed (SIGKILL) while it writes a frame, one quantity may have "
	       "that frame and another not. A run that is continued from a restart file appends to the file; "
	       "frames of the present step and later ones, which the interrupted run has left, are "
	       "replaced.\n\n"
	       "tsim must have been built with the HDF5 library (libhdf5-dev).",
	.example = "dump track all h5md 1000 post/rock.h5 position velocity every 10 image species radius\n"
		   "dump dust fines h5md 1000 post/rock.h5 position file_from track author \"A. Miller\"",
	.args = args,
	.state_size = sizeof(struct state),
	.saved = saved,
	.archive = ts_dump_archive,
	.init = init,
	.plan = plan,
	.hook[TS_STAGE_OUTPUT] = output,
	.defers = TS_DEFERS(OUTPUT),
	.fini = fini,
};
