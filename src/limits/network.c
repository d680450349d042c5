/* The highest frequency is where contacts are stiff and many and bodies are light: no squared angular
 * frequency is larger than the largest s_a + s_b of two bodies in contact,
 *
 *   s_a = sum over the contacts of a of k times the acceleration of a at the contact by a unit force there
 *
 * (W. N. Anderson, T. D. Morley, Linear Multilinear Algebra 18 (1985) 141). So it is enough to compute a few
 * local networks: around each of the PLACES bodies with the largest s, the fastest mode of the NODES_MOST
 * bodies that are nearest in the contact graph, with all others fixed (limits/lanczos.h). */
#include "limits/network.h"

#include <math.h>
#include <string.h>

#include "base/parallel.h"
#include "bond/bond_moment.h"
#include "box/domain.h"
#include "contact/limits.h"
#include "integrate/integrators.h"
#include "limits/ground.h"
#include "limits/lanczos.h"
#include "math/rigid_turn.h"
#include "particle/prescribed.h"
#include "particle/sphere_shape.h"
#include "rigid/rigid.h"
#include "wall/wall.h"

#include "base/banned.h"

enum { NODES_MOST = 512, PLACES = 2 };
/* upper bound of the ratio of the frequencies with and without slip: k_t (1 + m R^2/I) <= 3.5 k_n */
static const double SLIP_FACTOR = 1.9;

struct network {
	struct tsim *sim;
	const struct ts_pair *pair; /* pair style, or NULL */
	const struct ts_instance *bond;
	double *k;		  /* by candidate pair: stiffness, damping included; 0: does not touch */
	double *score;		  /* by node: s */
	int32_t *local_index;	  /* by node: its index in `node` + 1; 0: not in the local network */
	int32_t node[NODES_MOST]; /* local network: nodes are numbered particles first, then rigid bodies */
	int n;
	/* bits of the groups that integrators move, and of those with prescribed motion */
	uint32_t moving, prescribed;
	bool rotates;  /* particles rotate */
	bool grounded; /* with the slot `ground` of fixes; else contacts and bonds alone */
	struct ts_lanczos modes;
};

/* ---- nodes ---- */

/* 0 if the particle is immobile or has a prescribed motion. */
static double inverse_mass(const struct network *w, size_t i)
{
	const struct ts_particles *p = w->sim->particles;

	return p->mask[i] & w->moving && !(p->mask[i] & w->prescribed) ? p->imass[i] : 0;
}

static size_t local_of(const struct ts_particles *p, size_t i)
{
	return i < p->n ? i : (size_t)p->ghost_owner[i - p->n];
}

/* The node of particle i (local or ghost): itself or its rigid body. */
static size_t node_of(const struct network *w, size_t i)
{
	const struct ts_particles *p = w->sim->particles;
	const struct ts_body *body;

	i = local_of(p, i);
	body = ts_rigid_body_of(w->sim, i);
	return body ? p->n + (size_t)(body - w->sim->rigid->body) : i;
}

/* The particles of a node, *n of them. */
static const int32_t *members_of(const struct network *w, const int32_t *node, size_t *n)
{
	const struct ts_rigid *r = w->sim->rigid;
	size_t b = (size_t)*node - w->sim->particles->n;

	*n = 1;
	if ((size_t)*node < w->sim->particles->n)
		return node;
	*n = r->start[b + 1] - r->start[b];
	return r->member + r->start[b];
}

/* Vector from the centre of its rigid body to the centre of particle i; 0 for single particles. */
static void arm_to(const struct network *w, size_t i, double arm[3])
{
	const struct ts_particles *p = w->sim->particles;
	const struct ts_body *body = ts_rigid_body_of(w->sim, local_of(p, i));
	double m[3][3];

	arm[0] = arm[1] = arm[2] = 0;
	if (!body)
		return;
	ts_quaternion_matrix(body->q, m);
	ts_rotate(m, p->body_x[local_of(p, i)], arm);
}

static void set_ground(const struct network *w, size_t node, struct ts_lanczos_body *b)
{
	const struct ts_instance *last;
	struct ts_ground_springs g;

	if (!w->grounded || !(b->inverse_mass > 0))
		return;
	ts_ground_of(w->sim, node, &g, &last);
	for (int d = 0; d < 3; d++)
		b->spring[d] = g.frequency2[d] / b->inverse_mass;
	b->drag[0] = fmax(fmax(g.rate[0], g.rate[1]), g.rate[2]) / b->inverse_mass;
	b->drag[1] = w->rotates ? g.turning * ts_inertia(w->sim, node) : 0;
}

static struct ts_lanczos_body body_of_node(const struct network *w, size_t node)
{
	const struct tsim *sim = w->sim;
	const struct ts_particles *p = sim->particles;
	struct ts_lanczos_body b = { 0 };
	double m[3][3];

	if (node < p->n) {
		b.inverse_mass = inverse_mass(w, node);
		for (int d = 0; d < 3 && w->rotates && b.inverse_mass > 0; d++)
			b.inverse_inertia[d][d] = 1 / ts_inertia(sim, node);
		set_ground(w, node, &b);
		return b;
	}
	b.inverse_mass = 1 / sim->rigid->body[node - p->n].mass;
	ts_quaternion_matrix(sim->rigid->body[node - p->n].q, m);
	for (int k = 0; k < 3; k++) {
		double moment = sim->rigid->body[node - p->n].inertia[k];

		for (int a = 0; a < 3 && moment > 0; a++)
			for (int c = 0; c < 3; c++)
				b.inverse_inertia[a][c] += m[a][k] * m[c][k] / moment;
	}
	return b;
}

/* ---- contacts ---- */

/* Geometry of pair r; false: it does not touch. */
static bool contact_case(const struct network *w, size_t r, struct ts_contact_case *c, double n[3])
{
	const struct ts_particles *p = w->sim->particles;
	const struct ts_contact_list *contacts = &w->sim->neigh->contacts;
	size_t i = (size_t)contacts->i[r], j = (size_t)contacts->j[r];
	double sum = p->radius[i] + p->radius[j], distance;

	ts_sub(p->x[i], p->x[j], n);
	distance = ts_dot(n, n);
	if (!(distance < sum * sum) || !(distance > 0))
		return false;
	distance = sqrt(distance);
	ts_scale(1 / distance, n, n);
	*c = (struct ts_contact_case){ ts_pair_model(w->pair, p->type[i], p->type[j]),
				       ts_pair_law(w->pair, p->type[i], p->type[j]),
				       p->radius[i] * p->radius[j] / sum,
				       1 / (p->imass[i] + p->imass[j]),
				       sum - distance,
				       0 };
	return true;
}

static double effective_stiffness(const struct network *w, const struct ts_normal *f)
{
	return f->kn + 2 * f->gamman / w->sim->clock.dt;
}

static void compute_stiffness_share(void *context, size_t from, size_t to)
{
	const struct network *w = context;

	for (size_t r = from; r < to; r++) {
		struct ts_contact_case c;
		struct ts_normal f;
		double n[3];

		w->k[r] = 0;
		if (!contact_case(w, r, &c, n))
			continue;
		f = ts_granular_constants_at(c.model, c.law, c.r_eff, c.m_eff, c.overlap);
		w->k[r] = effective_stiffness(w, &f);
	}
}

/* The spring and dashpot with the same limit as the bond: h = 2 (sqrt(k m + c^2/4) - c/2)/k for any m. */
static void bond_spring(const struct network *w, size_t b, double *k, double *c)
{
	const struct ts_bond_style *style = ts_bond_style_of(w->bond);
	const struct ts_bond *bond = w->bond->state;
	const void *coeff = ts_coeff(&bond->coeffs, (size_t)w->sim->bonds->type[b]);
	double rest = w->sim->bonds->rest[b], h = style->limit(coeff, rest, 1, false);

	*k = style->stiffness(coeff, rest);
	*c = fmax((4 - h * h * *k) / (2 * h), 0);
	if (*c < 1e-9 * h * *k) /* round-off */
		*c = 0;
}

/* ---- scores of the nodes */

/* k times the acceleration at particle i of its node by a unit force there. */
static double score_share(const struct network *w, size_t i, double k)
{
	const struct ts_particles *p = w->sim->particles;
	size_t node = node_of(w, i);
	double arm[3], least;

	if (node < p->n)
		return k * inverse_mass(w, node);
	arm_to(w, i, arm);
	least = fmin(w->sim->rigid->body[node - p->n].inertia[1],
		     w->sim->rigid->body[node - p->n].inertia[2]);
	return k * (p->imass[local_of(p, i)] + (least > 0 ? ts_dot(arm, arm) / least : 0));
}

/* Bonds that transmit moments: the largest of the normal, torsional, and shear with bending parts. */
static double score_moments(const struct network *w, const struct ts_bond_element *e, int side, size_t i)
{
	double inverse = inverse_mass(w, i), rate = 2 / w->sim->clock.dt, k[TS_BOND_MODES], arm, inertia;

	if (!(inverse > 0))
		return 0;
	for (int m = 0; m < TS_BOND_MODES; m++)
		k[m] = e->k[m] + e->c[m] * rate;
	arm = (side ? 1 - e->fraction : e->fraction) * e->length;
	inertia = w->rotates ? 1 / ts_inertia(w->sim, i) : 0;
	return fmax(fmax(k[TS_BOND_NORMAL] * inverse, k[TS_BOND_TWIST] * inertia),
		    k[TS_BOND_SHEAR] * inverse +
			    (k[TS_BOND_SHEAR] * arm * arm + k[TS_BOND_BENDING]) * inertia);
}

static void score_bonds(struct network *w)
{
	const struct ts_bonds *bonds = w->sim->bonds;

	for (size_t b = 0; w->bond && b < bonds->n; b++) {
		struct ts_bond_element e;
		double k, c;

		if (bonds->transmits) {
			ts_bond_constants(w->sim, b, &e);
			for (int side = 0; side < 2; side++)
				w->score[bonds->row[b][side]] +=
					score_moments(w, &e, side, (size_t)bonds->row[b][side]);
			continue;
		}
		bond_spring(w, b, &k, &c);
		for (int side = 0; side < 2; side++)
			w->score[node_of(w, (size_t)bonds->row[b][side])] +=
				score_share(w, (size_t)bonds->row[b][side], k + 2 * c / w->sim->clock.dt);
	}
}

static void score_walls(struct network *w)
{
	const struct ts_wall *wall;

	for (size_t at = 0; (wall = ts_walls_next(w->sim, &at, NULL));)
		for (size_t k = 0; k < wall->contacts.n; k++) {
			struct ts_contact_case c;
			struct ts_normal f;

			if (!ts_wall_case(wall, w->sim, k, &c))
				continue;
			f = ts_granular_constants_at(c.model, c.law, c.r_eff, c.m_eff, c.overlap);
			w->score[node_of(w, (size_t)wall->contacts.row[k])] +=
				score_share(w, (size_t)wall->contacts.row[k], effective_stiffness(w, &f));
		}
}

/* Summed in the order of the partners' identities, as forces are: the same on any number of ranks. */
static void score_contacts(struct network *w)
{
	const struct ts_contact_list *contacts = &w->sim->neigh->contacts;
	const struct ts_gather *g = &contacts->gather;

	for (size_t i = 0; w->pair && contacts->n && i < w->sim->particles->n; i++)
		for (size_t e = g->first[i]; e < g->first[i + 1]; e++)
			if (w->k[g->entry[e] >> 1] > 0)
				w->score[node_of(w, i)] += score_share(w, i, w->k[g->entry[e] >> 1]);
}

static void sum_scores(struct network *w)
{
	size_t nodes = w->sim->particles->n + w->sim->rigid->n;

	for (size_t k = 0; k < nodes; k++) {
		w->score[k] = 0;
		w->local_index[k] = 0;
	}
	score_contacts(w);
	score_walls(w);
	score_bonds(w);
}

static double highest_score(const struct network *w, size_t *at)
{
	size_t nodes = w->sim->particles->n + w->sim->rigid->n;
	double most = 0;

	for (size_t k = 0; k < nodes; k++)
		if (w->score[k] > most) {
			most = w->score[k];
			*at = k;
		}
	return most;
}

/* ---- the local network around a node */

static void add_node(struct network *w, size_t node)
{
	if (w->n == NODES_MOST || w->local_index[node])
		return;
	w->node[w->n++] = (int32_t)node;
	w->local_index[node] = w->n;
}

static void add_partners(struct network *w, size_t i)
{
	const struct ts_contact_list *contacts = &w->sim->neigh->contacts;
	const struct ts_bonds *bonds = w->sim->bonds;

	for (size_t e = w->pair ? contacts->gather.first[i] : 0; w->pair && e < contacts->gather.first[i + 1];
	     e++) {
		size_t r = contacts->gather.entry[e] >> 1;

		if (w->k[r] > 0)
			add_node(w, node_of(w, (size_t)(contacts->gather.entry[e] & 1 ? contacts->i[r]
										      : contacts->j[r])));
	}
	for (size_t e = w->bond ? bonds->gather.first[i] : 0; w->bond && e < bonds->gather.first[i + 1]; e++)
		add_node(w, node_of(w, (size_t)bonds->row[bonds->gather.entry[e] >> 1]
							 [!(bonds->gather.entry[e] & 1)]));
}

/* ---- links of the local network */

static enum ts_status add_link(struct network *w, struct ts_link link)
{
	struct ts_lanczos *m = &w->modes;

	if (TS_GROW(m->link, m->link_capacity, m->nlinks + 1) != TS_OK)
		return ts_nomem(&w->sim->error);
	m->link[m->nlinks++] = link;
	return TS_OK;
}

/* Stiffness and damping of the contact laws. */
static void set_link_springs(const struct network *w, const struct ts_contact_case *c, size_t i, size_t j,
			     struct ts_link *link)
{
	const struct ts_particles *p = w->sim->particles;
	struct ts_normal f = ts_granular_constants_at(c->model, c->law, c->r_eff, c->m_eff, c->overlap);
	struct ts_touch t = { .r_eff = c->r_eff,
			      .m_eff = c->m_eff,
			      .overlap = c->overlap,
			      .wall = i == j,
			      .mass = { ts_rigid_inertial_mass(p, i), ts_rigid_inertial_mass(p, j) },
			      .radius = { p->radius[i], p->radius[j] } };

	link->k[TS_LINK_NORMAL] = f.kn;
	link->c[TS_LINK_NORMAL] = f.gamman;
	if (c->model->tangential != TS_TANGENTIAL_OFF && c->law->friction > 0) {
		link->k[TS_LINK_TANGENTIAL] = ts_tangential_remembers(c->model) ? f.kt : 0;
		link->c[TS_LINK_TANGENTIAL] = f.gammat;
	}
	if (ts_rolling_remembers_torque(c->model) && c->law->rolling_friction > 0) {
		/* the k_n of the law, not its derivative */
		f.kn = ts_granular_stiffens(c->model) ? f.kn / 1.5 : f.kn;
		link->k[TS_LINK_ROLLING] = ts_rolling_stiffness(c->model, c->law, &t, &f);
		if (c->model->rolling != TS_ROLLING_EPSD2)
			link->c[TS_LINK_ROLLING] =
				2 * c->law->rolling_viscosity *
				sqrt(ts_rolling_inertia(c->model, &t) * link->k[TS_LINK_ROLLING]);
	} else if (c->model->rolling == TS_ROLLING_SDS && c->law->rolling_friction > 0) {
		link->k[TS_LINK_ROLLING] = c->law->roll_stiffness * c->r_eff * c->r_eff;
		link->c[TS_LINK_ROLLING] = c->law->roll_damping * c->r_eff * c->r_eff;
	}
}

static enum ts_status add_contact_link(struct network *w, int a, size_t i, uint32_t entry)
{
	const struct ts_contact_list *contacts = &w->sim->neigh->contacts;
	const struct ts_particles *p = w->sim->particles;
	size_t r = entry >> 1, j = (size_t)(entry & 1 ? contacts->i[r] : contacts->j[r]);
	struct ts_link link = { .a = a, .b = w->local_index[node_of(w, j)] - 1 };
	struct ts_contact_case c;

	if (!(w->k[r] > 0) || !contact_case(w, r, &c, link.n))
		return TS_OK;
	if (entry & 1)
		ts_scale(-1, link.n, link.n);
	set_link_springs(w, &c, i, local_of(p, j), &link);
	arm_to(w, i, link.arm[0]);
	arm_to(w, j, link.arm[1]);
	ts_axpy(0.5 * c.overlap - p->radius[i], link.n, link.arm[0]);
	ts_axpy(p->radius[j] - 0.5 * c.overlap, link.n, link.arm[1]);
	return add_link(w, link);
}

/* A bond that transmits moments; n points from the partner to the particle. */
static void set_link_element(const struct network *w, uint32_t entry, struct ts_link *link)
{
	struct ts_bond_element e;
	double own;

	ts_bond_constants(w->sim, entry >> 1, &e);
	own = (entry & 1 ? 1 - e.fraction : e.fraction) * e.length;
	ts_scale(-own, link->n, link->arm[0]);
	ts_scale(e.length - own, link->n, link->arm[1]);
	link->bonded = true;
	link->k[TS_LINK_NORMAL] = e.k[TS_BOND_NORMAL];
	link->k[TS_LINK_TANGENTIAL] = e.k[TS_BOND_SHEAR];
	link->k[TS_LINK_ROLLING] = e.k[TS_BOND_BENDING];
	link->k[TS_LINK_TWISTING] = e.k[TS_BOND_TWIST];
	link->c[TS_LINK_NORMAL] = e.c[TS_BOND_NORMAL];
	link->c[TS_LINK_TANGENTIAL] = e.c[TS_BOND_SHEAR];
	link->c[TS_LINK_ROLLING] = e.c[TS_BOND_BENDING];
	link->c[TS_LINK_TWISTING] = e.c[TS_BOND_TWIST];
}

static enum ts_status add_bond_link(struct network *w, int a, size_t i, uint32_t entry)
{
	const struct ts_bonds *bonds = w->sim->bonds;
	size_t j = (size_t)bonds->row[entry >> 1][!(entry & 1)];
	struct ts_link link = { .a = a, .b = w->local_index[node_of(w, j)] - 1 };
	double length;

	ts_bond_separation(w->sim, i, j, link.n);
	length = ts_norm(link.n);
	if (!(length > 0))
		return TS_OK;
	ts_scale(1 / length, link.n, link.n);
	if (bonds->transmits) {
		set_link_element(w, entry, &link);
		return add_link(w, link);
	}
	bond_spring(w, entry >> 1, &link.k[TS_LINK_NORMAL], &link.c[TS_LINK_NORMAL]);
	arm_to(w, i, link.arm[0]);
	arm_to(w, j, link.arm[1]);
	return add_link(w, link);
}

static enum ts_status add_wall_links(struct network *w)
{
	const struct ts_particles *p = w->sim->particles;
	const struct ts_wall *wall;

	for (size_t at = 0; (wall = ts_walls_next(w->sim, &at, NULL));)
		for (size_t k = 0; k < wall->contacts.n; k++) {
			size_t i = (size_t)wall->contacts.row[k];
			struct ts_link link = { .a = w->local_index[node_of(w, i)] - 1, .b = -1 };
			struct ts_contact_case c;

			if (link.a < 0 || !ts_wall_case(wall, w->sim, k, &c))
				continue;
			set_link_springs(w, &c, i, i, &link);
			memcpy(link.n, wall->contacts.last[k].n, sizeof link.n);
			arm_to(w, i, link.arm[0]);
			ts_axpy(0.5 * c.overlap - p->radius[i], link.n, link.arm[0]);
			TS_TRY(add_link(w, link));
		}
	return TS_OK;
}

static enum ts_status add_links_of_particle(struct network *w, int a, size_t i)
{
	const struct ts_gather *contacts = &w->sim->neigh->contacts.gather, *bonds = &w->sim->bonds->gather;

	for (size_t e = w->pair ? contacts->first[i] : 0; w->pair && e < contacts->first[i + 1]; e++)
		TS_TRY(add_contact_link(w, a, i, contacts->entry[e]));
	for (size_t e = w->bond ? bonds->first[i] : 0; w->bond && e < bonds->first[i + 1]; e++)
		TS_TRY(add_bond_link(w, a, i, bonds->entry[e]));
	return TS_OK;
}

/* Builds the local network around a node: breadth-first, the node, its partners, their partners ... */
static enum ts_status build_local_network(struct network *w, size_t node)
{
	struct ts_lanczos *m = &w->modes;

	ts_lanczos_clear(m);
	for (w->n = 0, add_node(w, node); m->nbodies < (size_t)w->n; m->nbodies++) {
		size_t n;
		const int32_t *member = members_of(w, &w->node[m->nbodies], &n);

		for (size_t k = 0; k < n; k++)
			add_partners(w, (size_t)member[k]);
	}
	if (TS_GROW(m->body, m->body_capacity, (size_t)w->n) != TS_OK)
		return ts_nomem(&w->sim->error);
	for (int a = 0; a < w->n; a++) {
		size_t n;
		const int32_t *member = members_of(w, &w->node[a], &n);

		m->body[a] = body_of_node(w, (size_t)w->node[a]);
		for (size_t k = 0; k < n && m->body[a].inverse_mass > 0; k++)
			TS_TRY(add_links_of_particle(w, a, (size_t)member[k]));
	}
	return add_wall_links(w);
}

/* ---- reports */

/* Whether some body has more than one link. The limit of an isolated pair is reported elsewhere with more
 * detail (ts_contact_report_limits, single bonds), except where the contact stiffens or resists rolling. */
static bool is_coupled(const struct network *w, bool slip)
{
	const struct ts_lanczos *l = &w->modes;
	bool joined[NODES_MOST] = { false };

	for (size_t k = 0; k < l->nlinks; k++) {
		if (joined[l->link[k].a])
			return true;
		joined[l->link[k].a] = true;
	}
	return l->nlinks &&
	       (slip ? l->link->k[TS_LINK_ROLLING] > 0 : w->pair && ts_granular_stiffens(&w->pair->model));
}

static enum ts_status report_local_network(struct network *w, struct ts_plan_report *report, bool slip)
{
	const struct ts_particles *p = w->sim->particles;
	const struct ts_instance *by = w->pair ? ts_sim_only(w->sim, TS_KIND_PAIR) : w->bond;
	double limit;
	size_t n, i, links = 0;
	int worst;

	if (!is_coupled(w, slip))
		return TS_OK;
	if (ts_lanczos_limit(&w->modes, slip, w->sim->clock.dt, &limit, &worst) != TS_OK)
		return ts_nomem(&w->sim->error);
	i = (size_t)*members_of(w, &w->node[worst], &n);
	for (size_t k = 0; k < w->modes.nlinks; k++)
		links += w->modes.link[k].a == worst;
	return ts_report_limit(report, limit, !slip && !w->sim->run.clamped, &by->where,
			       slip ? "all contacts with slip and rolling, about %s %d of type %d (%zu "
				      "contacts) at (%.4g %.4g %.4g)"
				    : "all contacts together, about %s %d of type %d (%zu contacts) at (%.4g "
				      "%.4g %.4g)",
			       n > 1 ? "the body of particle" : "particle", p->tag[i], p->type[i], links,
			       p->x[i][0], p->x[i][1], p->x[i][2]);
}

/* Gershgorin: no squared angular frequency is larger than twice the largest s. */
static enum ts_status report_bound(const struct network *w, struct ts_plan_report *report, double bound)
{
	const struct ts_instance *by = w->pair ? ts_sim_only(w->sim, TS_KIND_PAIR) : w->bond;

	return ts_report_limit(report, bound, !w->sim->run.clamped, &by->where,
			       "all contacts together, at least");
}

static enum ts_status search_places(struct network *w, struct ts_plan_report *report)
{
	const bool slip = w->rotates && report->advice;

	for (int k = 0; k < PLACES; k++) {
		size_t node = 0;
		double most = highest_score(w, &node), bound = 2 / sqrt(2 * most);

		if (!(most > 0) || (k && bound > report->enough))
			return TS_OK;
		if (bound > report->enough && (!slip || bound / SLIP_FACTOR > report->enough))
			return report_bound(w, report, bound);
		if (w->sim->division) { /* its bodies may be on other ranks */
			report->undecided = true;
			return TS_OK;
		}
		TS_TRY(build_local_network(w, node));
		TS_TRY(report_local_network(w, report, false));
		if (slip)
			TS_TRY(report_local_network(w, report, true));
		for (int a = 0; a < w->n; a++) {
			w->score[w->node[a]] = 0;
			w->local_index[w->node[a]] = 0;
		}
	}
	return TS_OK;
}

/* The score of a particle with its springs and dashpots to the ground; 0: it has none. */
static double grounded_score(const struct network *w, size_t i)
{
	const struct ts_instance *last;
	struct ts_ground_springs g;
	double frequency2 = 0, rate;

	if (!ts_ground_of(w->sim, i, &g, &last))
		return 0;
	rate = g.turning;
	for (int d = 0; d < 3; d++) {
		frequency2 = fmax(frequency2, g.frequency2[d]);
		rate = fmax(rate, g.rate[d]);
	}
	return w->score[i] + frequency2 + 2 * rate / w->sim->clock.dt;
}

/* Contacts and bonds together with what fixes put between particles and the ground (layers of fluid, springs), where a
 * particle has both: sufficient for stability, and the limit itself where all act along the same line. */
static enum ts_status report_grounded(struct network *w, struct ts_plan_report *report,
				      const struct ts_instance *by)
{
	const struct ts_particles *p = w->sim->particles;
	size_t node = 0;
	double limit, most;
	int worst;

	w->grounded = true;
	for (size_t i = 0; i < p->n; i++)
		w->score[i] = w->score[i] > 0 && inverse_mass(w, i) > 0 ? grounded_score(w, i) : 0;
	for (size_t k = 0; k < w->sim->rigid->n; k++)
		w->score[p->n + k] = 0;
	most = highest_score(w, &node);
	if (!(most > 0) || 2 / sqrt(2 * most) > report->enough)
		return TS_OK;
	if (w->sim->division) {
		report->undecided = true;
		return TS_OK;
	}
	TS_TRY(build_local_network(w, node));
	if (ts_lanczos_limit(&w->modes, false, w->sim->clock.dt, &limit, &worst) != TS_OK)
		return ts_nomem(&w->sim->error);
	return ts_report_limit(report, limit, false, &by->where,
			       "contacts together with fix %s, about particle %d at (%.4g %.4g %.4g)",
			       by->style->name, p->tag[node], p->x[node][0], p->x[node][1], p->x[node][2]);
}

static enum ts_status compute_scores(struct network *w)
{
	struct tsim *sim = w->sim;
	size_t contacts = w->pair ? sim->neigh->contacts.n : 0, nodes = sim->particles->n + sim->rigid->n;

	w->k = ts_alloc(contacts, sizeof *w->k);
	w->score = ts_alloc(nodes, sizeof *w->score);
	w->local_index = ts_alloc(nodes, sizeof *w->local_index);
	if (!w->k || !w->score || !w->local_index)
		return ts_nomem(&sim->error);
	ts_parallel(ts_team(sim, contacts), contacts, compute_stiffness_share, w);
	sum_scores(w);
	return TS_OK;
}

enum ts_status ts_network_report(struct ts_plan_report *report, struct tsim *sim)
{
	const struct ts_instance *pair = ts_sim_only(sim, TS_KIND_PAIR), *ground;
	struct network w = { .sim = sim, .pair = pair ? pair->state : NULL };
	enum ts_status status;

	w.bond = sim->bonds->n ? ts_sim_only(sim, TS_KIND_BOND) : NULL;
	w.prescribed = ts_prescribed(sim);
	w.moving = ts_integrated_groups(sim, TS_MOVES | TS_OBEYS);
	w.rotates = sim->particles->omega && sim->particles->torque;
	if (sim->run.explicit_euler || (!w.pair && !w.bond) ||
	    (w.pair && sim->neigh->contacts.particles != sim->particles->n))
		return TS_OK;
	if (sim->division && (w.bond || sim->rigid->n)) {
		report->undecided = true;
		return TS_OK;
	}
	TS_TRY(ts_rigid_list(sim));
	status = compute_scores(&w);
	if (status == TS_OK && ts_ground_fixes(sim, &ground)) {
		status = report_grounded(&w, report, ground);
		w.grounded = false;
		sum_scores(&w);
	}
	if (status == TS_OK)
		status = search_places(&w, report);
	ts_lanczos_release(&w.modes);
	ts_free(w.k);
	ts_free(w.score);
	ts_free(w.local_index);
	return status;
}
