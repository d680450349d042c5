/* Compute fabric: anisotropy of the directions of contacts, of their lengths and of their forces. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "contact/contact_view.h"
#include "core/name_list.h"
#include "math/exactsum.h"
#include "math/vec3.h"
#include "particle/group_moments.h"

#include "base/banned.h"

enum tensor { CONTACT, BRANCH, NORMAL, TANGENTIAL, SHEAR, NTENSORS };
static const char *const attributes[] = { "contact",	      "branch",	     "force/normal",
					  "force/tangential", "force/shear", NULL };

struct state {
	int cutoff;
	struct ts_words words;	 /* attributes */
	struct ts_words include; /* `type/include LIST LIST`, may be repeated */
	struct ts_name_list list;
	bool *between; /* [ntypes + 1][ntypes + 1] whether contacts of these types count; NULL: all do */
	struct tsim *sim;
};

/* Types of a list such as `1,3*4`: marks them. */
static enum ts_status mark_types(struct tsim *sim, const struct ts_word *word, bool *marked)
{
	const char *at = word->text;

	for (;;) {
		char part[32];
		size_t n = strcspn(at, ",");
		struct ts_types t;

		snprintf(part, sizeof part, "%.*s", (int)(n < sizeof part ? n : sizeof part - 1), at);
		if (n >= sizeof part || !ts_parse_types(part, &t))
			return ts_fail(&sim->error, TS_SYNTAX, &word->place,
				       "compute fabric: type/include: expected types such as 1,3*4, found "
				       "'%s'",
				       word->text);
		t.hi = t.hi ? t.hi : sim->particles->ntypes;
		if (t.lo < 1 || t.hi > sim->particles->ntypes || t.lo > t.hi)
			return ts_fail(&sim->error, TS_RANGE, &word->place,
				       "compute fabric: type/include: types are 1 to %d, found '%s'",
				       sim->particles->ntypes, word->text);
		for (int k = t.lo; k <= t.hi; k++)
			marked[k] = true;
		if (!at[n])
			return TS_OK;
		at += n + 1;
	}
}

static enum ts_status read_include(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	size_t width = (size_t)sim->particles->ntypes + 1;
	bool *marked = ts_arena_alloc(&self->arena, 2 * width, sizeof *marked);

	s->between = ts_arena_alloc(&self->arena, width * width, sizeof *s->between);
	if (!marked || !s->between)
		return ts_nomem(&sim->error);
	for (size_t k = 0; k + 1 < s->include.n; k += 2) {
		memset(marked, 0, 2 * width * sizeof *marked);
		TS_TRY(mark_types(sim, &s->include.word[k], marked));
		TS_TRY(mark_types(sim, &s->include.word[k + 1], marked + width));
		for (size_t i = 1; i < width; i++)
			for (size_t j = 1; j < width; j++)
				s->between[i * width + j] |=
					(marked[i] && marked[width + j]) || (marked[j] && marked[width + i]);
	}
	return TS_OK;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	s->sim = sim;
	sim->neigh->keep_forces = true;
	if (s->include.n % 2)
		return ts_fail(&sim->error, TS_SYNTAX, &s->include.word[s->include.n - 1].place,
			       "compute fabric: type/include needs two lists of types, as in `type/include "
			       "1,2 3*4`");
	if (s->include.n)
		TS_TRY(read_include(self, sim));
	for (size_t k = 1; k < s->words.n; k++)
		for (size_t l = 0; l < k; l++)
			if (ts_streq(s->words.word[k].text, s->words.word[l].text))
				return ts_fail(&sim->error, TS_SYNTAX, &s->words.word[k].place,
					       "compute fabric: '%s' is named twice", s->words.word[k].text);
	return ts_name_list_read(sim, "compute fabric", &self->arena, s->words, attributes,
				 sizeof *attributes, &s->list);
}

static bool is_counted(const struct ts_instance *self, const struct tsim *sim, size_t r)
{
	const struct state *s = self->state;
	const struct ts_contact_list *list = &sim->neigh->contacts;
	const struct ts_particles *p = sim->particles;
	size_t width = (size_t)p->ntypes + 1;

	if (!ts_contact_touches(list, r) || !ts_contact_counts(sim, r, self->group))
		return false;
	return !s->between || s->between[(size_t)p->type[list->i[r]] * width + (size_t)p->type[list->j[r]]];
}

/* Sums of symmetric tensors. */
struct sums {
	struct ts_exactsum term[NTENSORS][6];
	double n;
};

/* A contact: direction n, length and force of it; weight: 1/(1 + a_kl n_k n_l), and 1 for the contact tensor. */
static void add_contact(struct sums *sums, const struct ts_contact_view *v, const double *a, double n[3])
{
	double normal = ts_dot(v->force, n), weight = 1, shear[3];

	for (int k = 0; k < 3; k++)
		shear[k] = v->force[k] - normal * n[k];
	for (int k = 0; a && k < 6; k++)
		weight += (k < 3 ? 1 : 2) * a[k] * n[ts_tensor_row[k]] * n[ts_tensor_column[k]];
	weight = weight > 0 ? weight : NAN;
	for (int k = 0; k < 6; k++) {
		int i = ts_tensor_row[k], j = ts_tensor_column[k];
		double nn = n[i] * n[j];

		if (!a) {
			ts_exactsum_add(&sums->term[CONTACT][k], nn);
			continue;
		}
		ts_exactsum_add(&sums->term[BRANCH][k], v->distance * nn / weight);
		ts_exactsum_add(&sums->term[NORMAL][k], normal * nn / weight);
		ts_exactsum_add(&sums->term[TANGENTIAL][k], ts_norm(shear) * nn / weight);
		ts_exactsum_add(&sums->term[SHEAR][k], 0.5 * (shear[i] * n[j] + shear[j] * n[i]) / weight);
	}
	sums->n += 1;
}

/* a NULL: the contact tensor; else the others, weighted by it. */
static void sum_contacts(struct ts_instance *self, const struct tsim *sim, const double *a, struct sums *sums)
{
	for (size_t r = 0; r < sim->neigh->contacts.n; r++) {
		struct ts_contact_view view;
		double n[3];

		if (!is_counted(self, sim, r))
			continue;
		ts_contact_view(sim, r, &view);
		for (int k = 0; k < 3; k++)
			n[k] = view.distance > 0 ? view.d[k] / view.distance : 0;
		add_contact(sums, &view, a, n);
	}
}

/* factor * deviator(sum)/scale; 0 where nothing was summed. In two dimensions xx and yy share the trace. */
static void anisotropy(const struct tsim *sim, const struct ts_exactsum sum[6], double factor, double scale,
		       double a[6])
{
	int dimension = sim->dimension;
	double t[6], trace = 0;

	for (int k = 0; k < 6; k++)
		t[k] = ts_exactsum_value(&sum[k]);
	for (int k = 0; k < dimension; k++)
		trace += t[k];
	for (int k = 0; k < 6; k++)
		a[k] = fabs(scale) > 0 || isnan(scale)
			       ? factor * (t[k] - (k < dimension ? trace / dimension : 0)) / scale
			       : 0;
}

static double trace_of(const struct ts_exactsum sum[6])
{
	return ts_exactsum_value(&sum[0]) + ts_exactsum_value(&sum[1]) + ts_exactsum_value(&sum[2]);
}

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct state *s = self->state;
	/* factor of the deviator in three and in two dimensions: from the integrals of n n (n.a.n) over all directions */
	double factor = sim->dimension == 3 ? 7.5 : 4, shear = sim->dimension == 3 ? 5 : 4;
	double a[NTENSORS][6];
	struct sums *sums = ts_alloc(1, sizeof *sums);
	double normal;

	if (!sums)
		return ts_nomem(&s->sim->error);
	if (ts_contacts_forces(s->sim, self) != TS_OK) {
		ts_free(sums);
		return s->sim->error.status;
	}
	memset(sums, 0, sizeof *sums);
	sum_contacts(self, sim, NULL, sums);
	anisotropy(sim, sums->term[CONTACT], factor, sums->n, a[CONTACT]);
	sums->n = 0;
	sum_contacts(self, sim, a[CONTACT], sums);
	normal = trace_of(sums->term[NORMAL]);
	anisotropy(sim, sums->term[BRANCH], factor, trace_of(sums->term[BRANCH]), a[BRANCH]);
	anisotropy(sim, sums->term[NORMAL], factor, normal, a[NORMAL]);
	anisotropy(sim, sums->term[TANGENTIAL], shear, normal, a[TANGENTIAL]);
	anisotropy(sim, sums->term[SHEAR], shear, normal, a[SHEAR]);
	ts_free(sums);
	for (size_t k = 0; k < s->list.n; k++)
		memcpy(out->data + 6 * k, a[s->list.item[k]], sizeof *a);
	return TS_OK;
}

static enum ts_status eval_count(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	TS_TRY(ts_contacts_require(((struct state *)self->state)->sim, self));
	out->data[0] = 0;
	for (size_t r = 0; r < sim->neigh->contacts.n; r++)
		out->data[0] += is_counted(self, sim, r);
	return TS_OK;
}

/* An output for each number of attributes, as the length must be known before there are contacts. */
#define TENSORS(n)                                                                                      \
	{                                                                                               \
		"tensors", "", "xx, yy, zz, xy, xz, yz of each tensor, in the order of the attributes", \
			TS_VECTOR, 6 * (n), NULL, eval                                                  \
	}
static const struct ts_value values[] = {
	{ "contacts", "", "number of contacts that count", TS_SCALAR, 1, NULL, eval_count },
	TENSORS(1),
	TENSORS(2),
	TENSORS(3),
	TENSORS(4),
	TENSORS(5),
	{ .name = NULL },
};

static bool gives(const struct ts_instance *self, const struct ts_value *value)
{
	return value->shape != TS_VECTOR ||
	       value->columns == 6 * ((const struct state *)self->state)->words.n;
}

static const char *const cutoffs[] = { "type", "radius", NULL };

static const struct ts_arg args[] = {
	TS_ENUM("cutoff", struct state, cutoff, cutoffs, .flags = TS_POSITIONAL,
		.help = "no effect: contacts are defined by the radii"),
	TS_LIST("attributes", struct state, words,
		.help = "contact, branch, force/normal, force/tangential, force/shear"),
	TS_SOME_KEYWORD("type/include", struct state, include, TS_REPEAT,
			.help = "two lists of types, such as `1,2 3*4`: only contacts between a particle of "
				"the first and one of the second list count; given several times: those of "
				"any"),
	TS_ARGS_END,
};

TS_STYLE(compute, ts_style, ts_compute_fabric)
const struct ts_style ts_compute_fabric = {
	.name = "fabric",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE,
	.summary = "Fabric tensors: anisotropy of contacts, of their lengths and forces",
	.doc = "The contacts between particles of the group have directions n, distances of the centres l, "
	       "and forces with a normal part f_n n (f_n > 0 if repulsive) and a tangential part f_t. Their "
	       "distributions over all directions are expanded to the second order,\n\n"
	       "    P(n) = (1 + a_c:nn)/(4 pi),    l(n) = l_0 (1 + a_b:nn),    f_n(n) = f_0 (1 + a_n:nn),\n"
	       "    f_t(n) = f_0 (a_t.n - (n.a_t.n) n),\n\n"
	       "and the attributes are the traceless tensors a, xx, yy, zz, xy, xz, yz:\n\n"
	       "    contact           a_c = 15/2 dev(R),        R = <n n>, the fabric tensor of Satake\n"
	       "    branch            a_b = 15/2 dev(D)/tr(D),  D = <l n n/(1 + a_c:nn)>\n"
	       "    force/normal      a_n = 15/2 dev(N)/tr(N),  N = <f_n n n/(1 + a_c:nn)>\n"
	       "    force/shear       a_t = 5 dev(T)/tr(N),     T = <sym(f_t n)/(1 + a_c:nn)>\n"
	       "    force/tangential  5 dev(S)/tr(N),           S = <|f_t| n n/(1 + a_c:nn)>\n\n"
	       "with means over the contacts. R = I/3 + 2/15 a_c. In two dimensions (1 + a:nn)/(2 pi) is "
	       "expanded: the factors 15/2 and 5 are 4, the deviator that of xx and yy, and R = I/2 + a_c/4. "
	       "In an isotropic packing all tensors are 0; in triaxial compression along z, a_c zz > 0. "
	       "force/tangential is the tensor that LAMMPS has under this name, of the magnitudes; "
	       "force/shear has the directions and enters the stress. The ratio of stresses is about q/p = "
	       "2/5 (a_c + a_b + a_n + 3/2 a_t), each the difference of the components zz and xx.\n\n"
	       "Of particles that touch in few directions only the expansion is negative in some of them; if "
	       "a contact has such a direction, all tensors but the first are nan. Without contacts all are "
	       "0. The scalar is the number of contacts. Contacts are those of the last force computation; "
	       "those with walls do not count. compute coordination gives the contacts of a particle.",
	.example = "compute f all fabric radius contact force/normal\nthermo_style custom step c_f[*]",
	.cite = "S. Ouadfel, L. Rothenburg, Mech. Mater. 33 (2001) 201; N. Guo, J. Zhao, Comput. Geotech. 47 "
		"(2013) 1",
	.args = args,
	.state_size = sizeof(struct state),
	.values = values,
	.gives = gives,
	.init = init,
};
