#include "mesh/mesh_admit.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#include "base/sort.h"
#include "io/textfile.h"
#include "mesh/mesh_scan.h"

#include "base/banned.h"

struct admission {
	struct tsim *sim;
	const struct ts_place *where;
	const struct ts_mesh_admission *how;
	struct ts_triangles *soup;
	struct ts_mesh *mesh;
	struct ts_mesh_findings findings;
};

enum severity { FINE, WARN, REFUSE };

static enum severity severity_of(const struct ts_mesh_admission *how, enum ts_mesh_fault fault)
{
	switch (fault) {
	case TS_MESH_OPEN:
		return FINE;
	case TS_MESH_NEEDLE:
	case TS_MESH_CROWDED:
		return REFUSE;
	case TS_MESH_SHARP:
		return how->curvature_tolerant ? WARN : REFUSE;
	case TS_MESH_DUPLICATE:
		return how->heal ? WARN : REFUSE;
	default:
		return WARN;
	}
}

static bool is_left_out(const struct ts_mesh_admission *how, enum ts_mesh_fault fault)
{
	return fault == TS_MESH_COLLAPSED || (fault == TS_MESH_DUPLICATE && how->heal);
}

/* "triangle 12 (line 79)" */
static void name_triangle(struct ts_str *out, const struct ts_triangles *soup, int32_t t)
{
	const struct ts_triangle *tri = &soup->t[t];

	ts_str_addf(out, "triangle %" PRId32, t + 1);
	if (tri->line)
		ts_str_addf(out, " (line %d)", tri->line);
	if (tri->solid[0])
		ts_str_addf(out, " of '%s'", tri->solid);
}

static void describe_finding(const struct admission *a, const struct ts_mesh_finding *f, struct ts_str *out)
{
	const struct ts_mesh_fault_text *text = &ts_mesh_fault_texts[f->fault];

	ts_str_addf(out, "%s: ", a->soup->file);
	name_triangle(out, a->soup, f->triangle);
	ts_str_addf(out, " at %g %g %g %s", f->at[0], f->at[1], f->at[2], text->what);
	if (text->unit[0])
		ts_str_addf(out, ": %g %s", f->amount, text->unit);
	if (f->other >= 0) {
		ts_str_add(out, ", see ");
		name_triangle(out, a->soup, f->other);
	}
}

/* Reports a finding as a warning or an error; the first one of a fault includes the number of others. */
static enum ts_status report_finding(struct admission *a, const struct ts_mesh_finding *f, bool first)
{
	const struct ts_mesh_fault_text *text = &ts_mesh_fault_texts[f->fault];
	size_t more = a->findings.count[f->fault] - 1;
	bool refuse = severity_of(a->how, f->fault) == REFUSE;
	struct ts_str line = { 0 };
	enum ts_status status = TS_OK;

	describe_finding(a, f, &line);
	if (first && more)
		ts_str_addf(&line, "; so do %zu other%s", more, more == 1 ? "" : "s");
	if (f->fault == TS_MESH_DUPLICATE && is_left_out(a->how, f->fault))
		ts_str_addf(&line, "; left out by `heal`");
	else if (first)
		ts_str_addf(&line, "; remedy: %s", text->remedy);
	if (line.failed)
		status = ts_nomem(&a->sim->error);
	else if (refuse && !a->how->verbose)
		status = ts_fail(&a->sim->error, TS_DAMAGED, a->where, "%s", line.text);
	else
		ts_warn(&a->sim->log, a->where, "%s", line.text);
	ts_str_release(&line);
	return status;
}

/* With `verbose` all findings are reported before the mesh is refused. */
static enum ts_status report_findings(struct admission *a)
{
	size_t refused = 0;

	for (size_t k = 0; k < a->findings.n; k++) {
		const struct ts_mesh_finding *f = &a->findings.list[k];
		bool first = !k || f[-1].fault != f->fault;

		refused += severity_of(a->how, f->fault) == REFUSE;
		if (severity_of(a->how, f->fault) != FINE && (first || a->how->verbose))
			TS_TRY(report_finding(a, f, first));
	}
	if (!refused)
		return TS_OK;
	return ts_fail(&a->sim->error, TS_DAMAGED, a->where,
		       "%s: %zu faults of triangles that no wall can be made of are listed above",
		       a->soup->file, refused);
}

/* Writes the line numbers of refused triangles. */
static enum ts_status write_exclusions(struct admission *a)
{
	struct ts_textfile file = { 0 };
	enum ts_status status, closed;

	status = ts_textfile_open(&file, a->sim, a->where, a->how->exclude, false);
	for (size_t k = 0; status == TS_OK && k < a->findings.n; k++) {
		const struct ts_mesh_finding *f = &a->findings.list[k];

		if (severity_of(a->how, f->fault) == REFUSE)
			status = ts_textfile_printf(&file, "%d\n", a->soup->t[f->triangle].line);
	}
	closed = ts_textfile_close(&file);
	return status == TS_OK ? closed : status;
}

static enum ts_status build_mesh(struct admission *a)
{
	double(*x)[3][3] = ts_alloc(a->soup->n, sizeof *x);
	enum ts_status status = x ? TS_OK : ts_nomem(&a->sim->error);

	for (size_t t = 0; x && t < a->soup->n; t++)
		memcpy(x[t], a->soup->t[t].v, sizeof x[t]);
	ts_mesh_release(a->mesh);
	if (x)
		status = ts_mesh_build(a->mesh, (const double(*)[3][3])x, a->soup->n, a->how->precision,
				       a->how->curvature);
	ts_free(x);
	if (status == TS_RANGE)
		return ts_fail(&a->sim->error, TS_RANGE, a->where,
			       "%s: %zu triangles are more than can be handled", a->soup->file, a->soup->n);
	return status == TS_NOMEM ? ts_nomem(&a->sim->error) : status;
}

static enum ts_status remove_left_out(struct admission *a)
{
	size_t n = 0;
	uint8_t *out = ts_alloc(a->soup->n, 1);

	if (!out)
		return ts_nomem(&a->sim->error);
	for (size_t k = 0; k < a->findings.n; k++)
		if (is_left_out(a->how, a->findings.list[k].fault))
			out[a->findings.list[k].triangle] = 1;
	for (size_t t = 0; t < a->soup->n; t++)
		if (!out[t])
			a->soup->t[n++] = a->soup->t[t];
	ts_free(out);
	if (n == a->soup->n)
		return TS_OK;
	a->soup->n = n;
	if (!n)
		return ts_fail(&a->sim->error, TS_DAMAGED, a->where,
			       "%s: no triangle is left: all have two corners at the same place, within the "
			       "`precision` of %g",
			       a->soup->file, a->how->precision);
	return build_mesh(a);
}

static enum ts_status admit_triangles(struct admission *a)
{
	TS_TRY(build_mesh(a));
	if (ts_mesh_examine(a->mesh, a->how->curvature, &a->findings) != TS_OK)
		return ts_nomem(&a->sim->error);
	if (a->how->exclude)
		TS_TRY(write_exclusions(a));
	TS_TRY(report_findings(a));
	return remove_left_out(a);
}

enum ts_status ts_mesh_admit(struct tsim *sim, const struct ts_place *where,
			     const struct ts_mesh_admission *how, struct ts_triangles *soup,
			     struct ts_mesh *out)
{
	struct admission a = { .sim = sim, .where = where, .how = how, .soup = soup, .mesh = out };
	enum ts_status status = admit_triangles(&a);

	ts_mesh_findings_release(&a.findings);
	if (status != TS_OK)
		ts_mesh_release(out);
	return status;
}

/* ---- lists of triangles to leave out: each line has a number of a line of the mesh file ---- */

struct lines {
	int64_t *line;
	size_t n, capacity;
};

static int by_number(const void *a, const void *b)
{
	const int64_t *p = a, *q = b;

	return (*p > *q) - (*p < *q);
}

static enum ts_status read_lines(struct ts_scan *s, struct lines *l)
{
	while (ts_scan_word(s)) {
		if (TS_GROW(l->line, l->capacity, l->n + 1) != TS_OK)
			return ts_nomem(s->err);
		TS_TRY(ts_scan_this_int(s, "the line of a triangle", 0, INT32_MAX, &l->line[l->n]));
		l->n++;
	}
	ts_sort(l->line, l->n, sizeof *l->line, by_number);
	return TS_OK;
}

static void remove_listed(const struct lines *l, struct ts_triangles *soup)
{
	size_t n = 0;

	for (size_t t = 0; t < soup->n; t++) {
		int64_t line = soup->t[t].line;

		if (!l->n || !bsearch(&line, l->line, l->n, sizeof line, by_number))
			soup->t[n++] = soup->t[t];
	}
	soup->n = n;
}

enum ts_status ts_mesh_exclude(struct tsim *sim, const struct ts_place *where, const char *path,
			       struct ts_triangles *soup)
{
	struct ts_scan s;
	struct lines l = { 0 };
	enum ts_status status = ts_scan_open(&s, &sim->files, &sim->error, sim->pool, where, path);

	if (status == TS_OK)
		status = read_lines(&s, &l);
	if (status == TS_OK)
		remove_listed(&l, soup);
	ts_free(l.line);
	ts_scan_close(&s);
	if (status == TS_OK && !soup->n)
		return ts_fail(&sim->error, TS_DAMAGED, where, "'%s' excludes all triangles", path);
	return status;
}
