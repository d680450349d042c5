#include "average/chunk_average.h"

#include <math.h>
#include <string.h>

#include "core/group.h"
#include "core/units.h"
#include "io/csv.h"
#include "math/vec3.h"
#include "particle/particles.h"

#include "base/banned.h"

enum { ALL, SAMPLE, NONE };
const char *const ts_chunk_norms[] = { [ALL] = "all", [SAMPLE] = "sample", [NONE] = "none", NULL };

/* What is averaged: a per-particle number, or one of these keywords. */
enum kind { VALUE, DENSITY_NUMBER, DENSITY_MASS, TEMPERATURE, GRANULAR };
static const char *const kinds[] = {
	[VALUE] = "", "density/number", "density/mass", "temp", "temp/granular"
};

struct ts_chunk_column {
	enum kind kind;
	struct ts_ref_input input;
};

static enum ts_status read_columns(struct ts_instance *self, struct tsim *sim)
{
	struct ts_chunk_average *s = self->state;
	struct ts_words words;

	TS_TRY(ts_refs_expand(sim, &self->arena, s->words, TS_WANT(PERATOM), &words));
	s->ncolumns = words.n;
	s->column = ts_arena_alloc(&self->arena, words.n, sizeof *s->column);
	if (!s->column)
		return ts_nomem(&sim->error);
	for (size_t k = 0; k < words.n; k++) {
		struct ts_chunk_column *c = &s->column[k];

		c->input.name = words.word[k].text;
		c->input.where = words.word[k].place;
		for (enum kind kind = DENSITY_NUMBER; kind <= GRANULAR; kind++)
			if (ts_streq(c->input.name, kinds[kind]))
				c->kind = kind;
	}
	return TS_OK;
}

enum ts_status ts_chunk_average_init(struct ts_instance *self, struct tsim *sim)
{
	struct ts_chunk_average *s = self->state;
	char what[64];

	snprintf(what, sizeof what, "fix %s", self->style->name);
	TS_TRY(ts_average_init(self, sim, &s->average));
	s->file.blocks = true;
	TS_TRY(ts_average_file_init(self, sim, &s->file));
	if (!s->column)
		TS_TRY(read_columns(self, sim));
	for (size_t k = 0; k < s->ncolumns; k++)
		if (s->column[k].kind == VALUE)
			TS_TRY(ts_ref_input_resolve(sim, what, TS_WANT(PERATOM), &s->column[k].input));
	return TS_OK;
}

static void count_and_velocity(const struct tsim *sim, size_t i, size_t chunk, const void *context,
			       double *term)
{
	(void)chunk, (void)context;
	for (int d = 0; d < 3; d++)
		term[d] = sim->particles->v[i][d];
	term[3] = 1;
}

/* |v - u|^2/D of each particle with u the mean velocity of its chunk: its mean is the granular temperature. */
static enum ts_status gather_fluctuations(struct ts_instance *self, struct tsim *sim,
					  const struct ts_chunks *c, size_t column)
{
	struct ts_chunk_average *s = self->state;
	const struct ts_particles *p = sim->particles;

	if (ts_chunk_sum(c, self->group, 4, count_and_velocity, NULL, &s->sums) != TS_OK)
		return ts_nomem(&sim->error);
	for (size_t i = 0; i < p->n; i++) {
		double *value = &s->peratom.data[i * s->ncolumns + column];
		const double *sum;

		*value = 0;
		if (!c->id[i] || !ts_in_group(p, i, self->group))
			continue;
		sum = s->sums.data + 4 * (size_t)(c->id[i] - 1);
		for (int d = 0; d < 3; d++)
			*value += pow(p->v[i][d] - sum[d] / sum[3], 2) / sim->dimension;
	}
	return TS_OK;
}

/* Evaluates the number of each particle that is summed for each column. */
static enum ts_status gather_columns(struct ts_instance *self, struct tsim *sim, const struct ts_chunks *c)
{
	struct ts_chunk_average *s = self->state;
	const struct ts_particles *p = sim->particles;
	size_t m = s->ncolumns;

	if (ts_table_resize(&s->peratom, p->n, m) != TS_OK)
		return ts_nomem(&sim->error);
	for (size_t k = 0; k < m; k++) {
		enum kind kind = s->column[k].kind;

		if (kind == VALUE)
			TS_TRY(ts_ref_input_eval(sim, &s->column[k].input, &s->one));
		if (kind == GRANULAR)
			TS_TRY(gather_fluctuations(self, sim, c, k));
		for (size_t i = 0; kind != GRANULAR && i < p->n; i++)
			s->peratom.data[i * m + k] = kind == VALUE	      ? s->one.data[i]
						     : kind == DENSITY_NUMBER ? 1
						     : kind == DENSITY_MASS
							     ? p->mass[i]
							     : p->mass[i] * ts_dot(p->v[i], p->v[i]);
	}
	return TS_OK;
}

static void row_terms(const struct tsim *sim, size_t i, size_t chunk, const void *context, double *term)
{
	const struct ts_table *peratom = context;

	(void)sim, (void)chunk;
	term[0] = 1;
	memcpy(term + 1, peratom->data + i * peratom->columns, peratom->columns * sizeof *term);
}

/* T = sum m v^2 / (k_B dof), dof = adof N + cdof samples; 0 without degrees of freedom. */
static double temperature(const struct tsim *sim, const struct ts_chunk_average *s, double twice_energy,
			  double particles, double samples)
{
	double adof = isnan(s->adof) ? sim->dimension : s->adof;
	double freedom = adof * particles + s->cdof * samples;

	return particles > 0 && freedom > 0 ? twice_energy / (freedom * ts_boltzmann(sim)) : 0;
}

/* Whether each sample is divided by itself: a temperature has no sum that `norm none` could leave undivided. */
static bool divides_samples(const struct ts_chunk_average *s, enum kind kind)
{
	return s->norm == SAMPLE || (s->norm == NONE && (kind == TEMPERATURE || kind == GRANULAR));
}

/* What one sample adds to the sum of one value in one chunk. */
static double sample_value(const struct tsim *sim, const struct ts_chunk_average *s, enum kind kind,
			   double volume, double count, double sum)
{
	if (kind == DENSITY_NUMBER || kind == DENSITY_MASS)
		return sum / volume;
	if (!divides_samples(s, kind))
		return sum;
	if (kind == TEMPERATURE)
		return temperature(sim, s, sum, count, 1);
	return count > 0 ? sum / count : 0;
}

/* Average of one value in one chunk, from the sums over all samples. */
static double average_value(const struct tsim *sim, const struct ts_chunk_average *s, enum kind kind,
			    double count, double sum)
{
	double samples = (double)s->average.repeat;

	if (kind == TEMPERATURE && s->norm == ALL)
		return temperature(sim, s, sum, count, samples);
	if ((kind == VALUE || kind == GRANULAR) && s->norm == ALL)
		return count > 0 ? sum / count : 0;
	return sum / samples;
}

static enum ts_status store_places(struct ts_chunk_average *s, struct tsim *sim, const struct ts_chunks *c)
{
	size_t coordinates = (size_t)ts_chunks_dimension(c), width = coordinates + c->compress;

	s->ncoordinates = (int64_t)coordinates;
	s->compressed = c->compress;
	if (TS_GROW(s->place, s->place_capacity, c->n * width + 1) != TS_OK) /* never NULL */
		return ts_nomem(&sim->error);
	s->place_n = c->n * width;
	for (size_t k = 0; k < c->n; k++) {
		double *row = s->place + k * width;

		if (c->compress)
			*row++ = (double)c->original[k];
		for (size_t d = 0; d < coordinates; d++)
			row[d] = ts_chunks_coordinate(c, k + 1, (int)d);
	}
	return TS_OK;
}

static enum ts_status add_sample(struct ts_instance *self, struct tsim *sim)
{
	struct ts_chunk_average *s = self->state;
	bool first = s->average.samples == 0;
	size_t width = 1 + s->ncolumns;
	struct ts_instance *owner;
	struct ts_chunks *c;

	TS_TRY(s->source(self, sim, &owner, &c));
	if (first)
		ts_chunks_hold(c, ts_average_until(&s->average, sim));
	TS_TRY(ts_chunks_assign(owner, c, first ? TS_CHUNK_FIRST_SAMPLE : TS_CHUNK_NEXT_SAMPLE));
	TS_TRY(gather_columns(self, sim, c));
	if (ts_chunk_sum(c, self->group, width, row_terms, &s->peratom, &s->sums) != TS_OK)
		return ts_nomem(&sim->error);
	if (first) {
		TS_TRY(ts_average_resize(self, sim, &s->average, c->n * width));
		TS_TRY(store_places(s, sim, c));
		for (size_t k = 0; k < s->average.n; k++)
			s->average.sum[k] = 0;
	}
	if (c->n * width != s->average.n)
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "fix %s %s: the number of chunks has changed from %zu to %zu between the "
			       "samples of one average; use `ids nfreq` of compute chunk/atom",
			       self->style->name, self->id, s->average.n / width, c->n);
	for (size_t k = 0; k < c->n; k++) {
		double *to = s->average.sum + k * width, *from = s->sums.data + k * width;
		double volume = ts_chunks_volume(c, k + 1);

		to[0] += from[0];
		for (size_t j = 1; j < width; j++)
			to[j] += sample_value(sim, s, s->column[j - 1].kind, volume, from[0], from[j]);
	}
	return TS_OK;
}

static void complete_average(struct ts_chunk_average *s, const struct tsim *sim)
{
	size_t width = 1 + s->ncolumns;

	for (size_t k = 0; k < s->average.n; k += width) {
		double *sum = s->average.sum + k;

		for (size_t j = 1; j < width; j++)
			sum[j] = average_value(sim, s, s->column[j - 1].kind, sum[0], sum[j]);
		sum[0] /= (double)s->average.repeat;
	}
	ts_average_combine(&s->average);
}

static enum ts_status add_titles(struct ts_instance *self, struct tsim *sim)
{
	struct ts_chunk_average *s = self->state;
	const char *words = s->spatial ? "Spatial-averaged" : "Chunk-averaged";
	struct ts_str line = { 0 };
	bool failed;

	ts_str_addf(&line, "# %s data for fix %s and group %s", words, self->id,
		    ts_group_name(sim, self->group));
	ts_average_file_title(&s->file, 0, ts_str_text(&line));
	ts_average_file_title(&s->file, 1,
			      s->spatial ? "# Timestep Number-of-bins"
					 : "# Timestep Number-of-chunks Total-count");
	ts_str_clear(&line);
	ts_str_addf(&line, "# %s%s", s->spatial ? "Bin" : "Chunk", s->compressed ? " OrigID" : "");
	if (s->spatial && s->ncoordinates == 1)
		ts_str_add(&line, " Coord");
	for (int64_t d = 1; d <= s->ncoordinates && !(s->spatial && s->ncoordinates == 1); d++)
		ts_str_addf(&line, " Coord%d", (int)d);
	ts_str_add(&line, " Ncount");
	for (size_t k = 0; k < s->ncolumns; k++)
		ts_str_addf(&line, " %s", s->column[k].input.name);
	ts_average_file_title(&s->file, 2, ts_str_text(&line));
	failed = line.failed;
	ts_str_release(&line);
	return failed ? ts_nomem(&sim->error) : TS_OK;
}

static enum ts_status add_csv_names(struct ts_chunk_average *s, struct tsim *sim)
{
	struct ts_str *text = &s->file.text;
	char name[24];

	ts_csv_text(text, "step");
	ts_csv_text(text, s->spatial ? "bin" : "chunk");
	if (s->compressed)
		ts_csv_text(text, "original");
	for (int64_t d = 1; d <= s->ncoordinates; d++) {
		snprintf(name, sizeof name, "coord%d", (int)d);
		ts_csv_text(text, name);
	}
	ts_csv_text(text, "count");
	for (size_t k = 0; k < s->ncolumns; k++)
		ts_csv_text(text, s->column[k].input.name);
	return ts_average_file_names_done(sim, &s->file);
}

/* The first line of an average, which a table does not have. */
static void add_sums(struct ts_chunk_average *s, const struct tsim *sim, size_t n, size_t width)
{
	double total = 0;

	if (s->file.csv)
		return;
	ts_str_addf(&s->file.text, "%lld %zu", (long long)sim->clock.step, n);
	for (size_t k = 0; k < n; k++)
		total += s->average.result[k * width];
	if (!s->spatial)
		ts_str_addf(&s->file.text, " %g", total * (double)ts_average_weight(&s->average));
	ts_str_add(&s->file.text, "\n");
}

static enum ts_status write_result(struct ts_instance *self, struct tsim *sim)
{
	struct ts_chunk_average *s = self->state;
	size_t width = 1 + s->ncolumns, n = s->average.n / width;
	size_t places = n ? s->place_n / n : 0;
	bool titles;

	if (!ts_average_file_wanted(&s->file))
		return TS_OK;
	TS_TRY(ts_average_file_begin(self, sim, &s->file, &titles));
	if (titles)
		TS_TRY(s->file.csv ? add_csv_names(s, sim) : add_titles(self, sim));
	add_sums(s, sim, n, width);
	for (size_t k = 0; k < n; k++) {
		if (s->file.csv)
			ts_csv_int(&s->file.text, sim->clock.step);
		if (s->file.csv)
			ts_csv_int(&s->file.text, (int64_t)k + 1);
		else
			ts_str_addf(&s->file.text, "  %zu", k + 1);
		for (size_t j = 0; j < places; j++)
			ts_average_file_place(&s->file, s->place[k * places + j]);
		ts_average_file_place(&s->file, s->average.result[k * width]);
		for (size_t j = 1; j < width; j++)
			ts_average_file_number(&s->file, s->average.result[k * width + j]);
		ts_str_add(&s->file.text, "\n");
	}
	return ts_average_file_end(sim, &s->file);
}

/* Before the first average the output has the current chunks with all values 0. */
enum ts_status ts_chunk_average_setup(struct ts_instance *self, struct tsim *sim)
{
	struct ts_chunk_average *s = self->state;
	struct ts_instance *owner;
	struct ts_chunks *c;

	if (s->average.n == 0) {
		TS_TRY(s->source(self, sim, &owner, &c));
		TS_TRY(ts_chunks_assign(owner, c, TS_CHUNK_NO_SAMPLE));
		TS_TRY(ts_average_resize(self, sim, &s->average, c->n * (1 + s->ncolumns)));
		TS_TRY(store_places(s, sim, c));
	}
	return ts_chunk_average_sample(self, sim);
}

enum ts_status ts_chunk_average_sample(struct ts_instance *self, struct tsim *sim)
{
	struct ts_chunk_average *s = self->state;

	if (!ts_average_due(&s->average, sim))
		return TS_OK;
	TS_TRY(add_sample(self, sim));
	if (!ts_average_sampled(&s->average, sim))
		return TS_OK;
	complete_average(s, sim);
	return write_result(self, sim);
}

enum ts_status ts_chunk_average_archive(struct ts_instance *self, struct tsim *sim,
					struct ts_archive *archive)
{
	struct ts_chunk_average *s = self->state;
	size_t width = 1 + s->ncolumns;

	TS_TRY(ts_average_archive(self, sim, archive, &s->average));
	TS_TRY(ts_archive_array(archive, "place", TS_SAVED_F64, (void **)&s->place, &s->place_capacity,
				&s->place_n));
	if (s->average.n % width || s->ncoordinates < 0 || s->ncoordinates > 3 ||
	    s->place_n != s->average.n / width * (size_t)(s->ncoordinates + (s->compressed != 0)))
		return ts_fail(&sim->error, TS_DAMAGED, &self->where,
			       "fix %s %s: the saved averages are inconsistent", self->style->name, self->id);
	return TS_OK;
}

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct ts_chunk_average *s = self->state;
	size_t width = 1 + s->ncolumns, n = s->average.n / width;
	size_t places = n ? s->place_n / n : 0;

	(void)sim;
	TS_TRY(ts_table_resize(out, n, places + width));
	for (size_t k = 0; k < n; k++) {
		double *row = out->data + k * (places + width);

		for (size_t j = 0; j < places; j++)
			row[j] = s->place[k * places + j];
		for (size_t j = 0; j < width; j++)
			row[places + j] = s->average.result[k * width + j];
	}
	return TS_OK;
}

const struct ts_value ts_chunk_average_values[] = {
	{ .name = "averages",
	  .unit = "",
	  .help = "for each chunk: with compress its original number, its coordinates, mean number of "
		  "particles, the values",
	  .shape = TS_ARRAY,
	  .eval = eval },
	{ .name = NULL },
};

void ts_chunk_average_fini(struct ts_instance *self)
{
	struct ts_chunk_average *s = self->state;

	ts_average_file_release(&s->file);
	ts_average_release(&s->average);
	ts_table_release(&s->peratom);
	ts_table_release(&s->one);
	ts_table_release(&s->sums);
	ts_free(s->place);
}
