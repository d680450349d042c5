/* Words of flow_style reynolds with words of their own: edges, roughness, viscosity. */
#include "film/flow_reynolds.h"

#include <math.h>

#include "box/domain.h"
#include "flow/fluid.h"

#include "base/banned.h"

static const char *const edges[] = { "xlo", "xhi", "ylo", "yhi", NULL };

struct edge_word {
	int edge;
};
static const struct ts_arg edge_rows[] = {
	TS_ENUM("edge", struct edge_word, edge, edges, .flags = TS_POSITIONAL),
	TS_ARGS_END,
};

static enum ts_status refuse_edge(struct ts_instance *self, struct tsim *sim, int k, const char *why)
{
	return ts_fail(&sim->error, TS_STATE, ts_instance_word(self, edges[k]),
		       "flow_style reynolds: the edge %s %s", edges[k], why);
}

enum ts_status ts_reynolds_check_faces(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_box *box = &sim->domain->box;

	for (int k = 0; k < 4; k++)
		if (box->face[k / 2][k % 2] != TS_FACE_FIXED && box->face[k / 2][k % 2] != TS_FACE_PERIODIC)
			return ts_fail(&sim->error, TS_STATE, &self->where,
				       "flow_style reynolds: the film ends at the faces of the box, but %s "
				       "follows the particles: use `boundary f f ...` or p along x and y",
				       edges[k]);
	return TS_OK;
}

static enum ts_status read_edge(struct ts_instance *self, struct tsim *sim, const char *what,
				struct ts_words words, size_t k, int *edge)
{
	struct ts_words one = ts_words_from(words, k);
	struct edge_word word = { 0 };

	one.n = 1;
	TS_TRY(ts_args_parse(sim, what, edge_rows, one, &words.word[k].place, &self->arena, &word));
	*edge = word.edge;
	return TS_OK;
}

/* Edges of periodic axes at which the film ends nevertheless: a wafer above a pad that goes on. */
static enum ts_status read_open(struct ts_instance *self, struct tsim *sim, bool open[4])
{
	struct ts_reynolds *s = self->state;

	for (size_t k = 0; k < s->open.n; k++) {
		int edge;

		TS_TRY(read_edge(self, sim, "flow_style reynolds: open", s->open, k, &edge));
		if (!ts_box_periodic(&sim->domain->box, edge / 2))
			return refuse_edge(self, sim, edge,
					   "is open, but the box is not periodic there: it is open anyway, "
					   "or closed");
		open[edge] = true;
	}
	for (int d = 0; d < 2; d++)
		if (open[2 * d] != open[2 * d + 1])
			return refuse_edge(self, sim, 2 * d + open[2 * d],
					   "is not open, but the opposite one is; expected both");
	return TS_OK;
}

enum ts_status ts_reynolds_read_edges(struct ts_instance *self, struct tsim *sim)
{
	struct ts_reynolds *s = self->state;
	struct ts_film *f = &s->flow.film;
	bool open[4] = { false };

	TS_TRY(read_open(self, sim, open));
	for (int k = 0; k < 4; k++) {
		bool given = !isnan(s->edge[k / 2][k % 2]);

		f->edge[k / 2][k % 2] = TS_FILM_PRESSURE;
		f->edge_pressure[k / 2][k % 2] = given ? s->edge[k / 2][k % 2] : s->ambient;
		if (!ts_box_periodic(&sim->domain->box, k / 2) || open[k])
			continue;
		f->edge[k / 2][k % 2] = TS_FILM_PERIODIC;
		if (given)
			return refuse_edge(self, sim, k,
					   "has a pressure, but the box is periodic there and the edge is "
					   "not `open`");
	}
	for (size_t k = 0; k < s->closed.n; k++) {
		int edge;

		TS_TRY(read_edge(self, sim, "flow_style reynolds: closed", s->closed, k, &edge));
		if (f->edge[edge / 2][0] == TS_FILM_PERIODIC)
			return refuse_edge(self, sim, edge, "is closed, but the box is periodic there");
		if (!isnan(s->edge[edge / 2][edge % 2]))
			return refuse_edge(self, sim, edge, "is closed, and a pressure is given there");
		f->edge[edge / 2][edge % 2] = TS_FILM_NO_FLOW;
	}
	return TS_OK;
}

static const char *const peklenik_numbers[] = { "1/9", "1/6", "1/3", "1", "3", "6", "9", NULL };

struct roughness {
	double sigma[2];
	int peklenik;
};
static const struct ts_arg roughness_rows[] = {
	TS_REAL("SIGMA_LOWER", struct roughness, sigma[0], .flags = TS_POSITIONAL, .range = TS_NOT_NEGATIVE),
	TS_REAL("SIGMA_UPPER", struct roughness, sigma[1], .flags = TS_POSITIONAL, .range = TS_NOT_NEGATIVE),
	TS_ENUM("GAMMA", struct roughness, peklenik, peklenik_numbers, .flags = TS_POSITIONAL),
	TS_ARGS_END,
};

enum ts_status ts_reynolds_read_roughness(struct ts_instance *self, struct tsim *sim)
{
	struct ts_reynolds *s = self->state;
	struct roughness r = { .peklenik = TS_FILM_PEKLENIK_1 };

	if (s->roughness.n > 0)
		TS_TRY(ts_args_parse(sim, "flow_style reynolds: roughness", roughness_rows, s->roughness,
				     ts_instance_word(self, "roughness"), &self->arena, &r));
	s->flow.film.roughness[0] = r.sigma[0];
	s->flow.film.roughness[1] = r.sigma[1];
	s->flow.film.peklenik = (enum ts_film_peklenik)r.peklenik;
	return TS_OK;
}

static const struct ts_arg asperity_rows[] = {
	TS_REAL("DENSITY", struct ts_film_asperity, density, .flags = TS_POSITIONAL, .range = TS_POSITIVE),
	TS_REAL("RADIUS", struct ts_film_asperity, radius, .flags = TS_POSITIONAL, .range = TS_POSITIVE),
	TS_REAL("MODULUS", struct ts_film_asperity, modulus, .flags = TS_POSITIONAL, .range = TS_POSITIVE),
	TS_REAL("FRICTION", struct ts_film_asperity, friction, .flags = TS_POSITIONAL,
		.range = TS_NOT_NEGATIVE),
	TS_ARGS_END,
};

enum ts_status ts_reynolds_read_asperities(struct ts_instance *self, struct tsim *sim)
{
	struct ts_reynolds *s = self->state;

	s->flow.film.asperity = (struct ts_film_asperity){ 0 };
	if (s->asperities.n == 0)
		return TS_OK;
	if (s->roughness.n == 0)
		return ts_fail(&sim->error, TS_SYNTAX, ts_instance_word(self, "asperities"),
			       "flow_style reynolds: `asperities` are those of rough surfaces; expected "
			       "`roughness`, too");
	return ts_args_parse(sim, "flow_style reynolds: asperities", asperity_rows, s->asperities,
			     ts_instance_word(self, "asperities"), &self->arena, &s->flow.film.asperity);
}

static const struct ts_arg roelands_rows[] = {
	TS_REAL("ETA_R", struct ts_film_piezo, viscosity, .flags = TS_POSITIONAL, .range = TS_POSITIVE),
	TS_REAL("P_R", struct ts_film_piezo, pressure, .flags = TS_POSITIONAL, .range = TS_POSITIVE),
	TS_REAL("Z", struct ts_film_piezo, exponent, .flags = TS_POSITIONAL, .range = TS_POSITIVE),
	TS_ARGS_END,
};

enum ts_status ts_reynolds_read_viscosity(struct ts_instance *self, struct tsim *sim)
{
	struct ts_reynolds *s = self->state;
	struct ts_film_piezo *piezo = &s->flow.film.piezo;
	const struct ts_instance *part;
	size_t k = 0;

	*piezo = (struct ts_film_piezo){ .law = TS_FILM_CONSTANT };
	if (isnan(s->barus) && s->roelands.n == 0)
		return TS_OK;
	if (!isnan(s->barus) && s->roelands.n > 0)
		return ts_fail(&sim->error, TS_SYNTAX, ts_instance_word(self, "roelands"),
			       "flow_style reynolds: expected either `barus` or `roelands`, found both");
	part = ts_sim_next_of(sim, TS_KIND_FIX, TS_FAMILY_FLOW_PART, &k);
	if (part)
		return ts_fail(&sim->error, TS_STATE, &part->where,
			       "fix %s takes one viscosity from the flow style, but in this film it depends "
			       "on the pressure: expected flow_style reynolds without `barus` and `roelands`",
			       part->style->name);
	if (!isnan(s->barus)) {
		piezo->law = TS_FILM_BARUS;
		piezo->alpha = s->barus;
		return TS_OK;
	}
	piezo->law = TS_FILM_ROELANDS;
	return ts_args_parse(sim, "flow_style reynolds: roelands", roelands_rows, s->roelands,
			     ts_instance_word(self, "roelands"), &self->arena, piezo);
}
