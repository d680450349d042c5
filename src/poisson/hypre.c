#include "poisson/hypre.h"

#include "base/alloc.h"

#ifdef TS_WITH_HYPRE
#include <HYPRE.h>
#include <HYPRE_struct_ls.h>
#include <mpi.h>
#include <stdlib.h>

#include "base/banned.h"

struct ts_hypre {
	const struct ts_stencil *s;
	HYPRE_StructGrid grid;
	HYPRE_StructStencil stencil;
	HYPRE_StructMatrix matrix;
	HYPRE_StructVector b, x;
	HYPRE_StructSolver solver;
	double *values;
};

bool ts_hypre_available(void)
{
	return true;
}

static void finalize_mpi(void)
{
	int done = 0;

	MPI_Finalized(&done);
	if (!done)
		MPI_Finalize();
}

/* hypre needs MPI even in a single process. */
static void initialize_mpi(void)
{
	int begun = 0;

	MPI_Initialized(&begun);
	if (!begun && MPI_Init(NULL, NULL) == MPI_SUCCESS)
		atexit(finalize_mpi);
	HYPRE_Init();
}

/* Corners of the range of all cells; hypre's functions take pointers to non-constant data. */
struct corners {
	int low[3], high[3];
};

static struct corners whole_grid(const struct ts_stencil *s)
{
	return (struct corners){ .high = { s->n[0] - 1, s->n[1] - 1, s->n[2] - 1 } };
}

static void make_parts(struct ts_hypre *h)
{
	const struct ts_stencil *s = h->s;
	int offset[4][3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } }, period[3];
	struct corners all = whole_grid(s);

	for (int d = 0; d < 3; d++)
		period[d] = s->periodic[d] ? s->n[d] : 0;
	HYPRE_StructGridCreate(MPI_COMM_SELF, s->axes, &h->grid);
	HYPRE_StructGridSetExtents(h->grid, all.low, all.high);
	HYPRE_StructGridSetPeriodic(h->grid, period);
	HYPRE_StructGridAssemble(h->grid);
	HYPRE_StructStencilCreate(s->axes, s->axes + 1, &h->stencil);
	for (int k = 0; k <= s->axes; k++)
		HYPRE_StructStencilSetElement(h->stencil, k, offset[k]);
	HYPRE_StructMatrixCreate(MPI_COMM_SELF, h->grid, h->stencil, &h->matrix);
	HYPRE_StructMatrixSetSymmetric(h->matrix, 1);
	HYPRE_StructMatrixInitialize(h->matrix);
	HYPRE_StructVectorCreate(MPI_COMM_SELF, h->grid, &h->b);
	HYPRE_StructVectorInitialize(h->b);
	HYPRE_StructVectorCreate(MPI_COMM_SELF, h->grid, &h->x);
	HYPRE_StructVectorInitialize(h->x);
}

struct ts_hypre *ts_hypre_make(const struct ts_stencil *s)
{
	struct ts_hypre *h = ts_alloc(1, sizeof *h);
	size_t cells = (size_t)s->n[0] * (size_t)s->n[1] * (size_t)s->n[2];

	if (!h)
		return NULL;
	h->s = s;
	h->values = ts_alloc_aligned(cells * ((size_t)s->axes + 1), sizeof *h->values);
	if (!h->values) {
		ts_free(h);
		return NULL;
	}
	initialize_mpi();
	make_parts(h);
	return h;
}

static void destroy_solver(struct ts_hypre *h)
{
	if (h->solver)
		HYPRE_StructPFMGDestroy(h->solver);
	h->solver = NULL;
}

void ts_hypre_release(struct ts_hypre *h)
{
	if (!h)
		return;
	destroy_solver(h);
	HYPRE_StructVectorDestroy(h->x);
	HYPRE_StructVectorDestroy(h->b);
	HYPRE_StructMatrixDestroy(h->matrix);
	HYPRE_StructStencilDestroy(h->stencil);
	HYPRE_StructGridDestroy(h->grid);
	ts_free(h->values);
	ts_free(h);
}

/* Matrix entries of a cell: the sum of its links, and those to its upper neighbours. A singular matrix is
 * made definite by a small relative change. */
static void fill_cell(const struct ts_stencil *s, size_t at, const int upper[3], double *value)
{
	value[0] = s->inverse[at] > 0 ? 1 / s->inverse[at] : 1;
	value[0] *= s->singular ? 1 + 1e-12 : 1;
	for (int d = 0; d < s->axes; d++)
		value[d + 1] =
			upper[d] < s->n[d] || s->periodic[d] ? -s->link[d][at + (size_t)s->stride[d]] : 0;
}

enum ts_status ts_hypre_set_weights(struct ts_hypre *h)
{
	const struct ts_stencil *s = h->s;
	struct corners all = whole_grid(s);
	int entry[4] = { 0, 1, 2, 3 };
	double *value = h->values;

	for (int k = 0; k < s->n[2]; k++)
		for (int j = 0; j < s->n[1]; j++)
			for (int i = 0; i < s->n[0]; i++, value += s->axes + 1)
				fill_cell(s, ts_stencil_at(s, i, j, k), (int[3]){ i + 1, j + 1, k + 1 },
					  value);
	HYPRE_StructMatrixSetBoxValues(h->matrix, all.low, all.high, s->axes + 1, entry, h->values);
	HYPRE_StructMatrixAssemble(h->matrix);
	destroy_solver(h);
	HYPRE_StructPFMGCreate(MPI_COMM_SELF, &h->solver);
	HYPRE_StructPFMGSetMaxIter(h->solver, 1);
	HYPRE_StructPFMGSetTol(h->solver, 0);
	HYPRE_StructPFMGSetZeroGuess(h->solver);
	HYPRE_StructPFMGSetRelaxType(h->solver, 2); /* red-black, symmetric */
	HYPRE_StructPFMGSetNumPreRelax(h->solver, 1);
	HYPRE_StructPFMGSetNumPostRelax(h->solver, 1);
	HYPRE_StructPFMGSetup(h->solver, h->matrix, h->b, h->x);
	return HYPRE_GetError() ? TS_PHYSICS : TS_OK;
}

void ts_hypre_cycle(void *hypre, const double *r, double *z)
{
	struct ts_hypre *h = hypre;
	const struct ts_stencil *s = h->s;
	struct corners all = whole_grid(s);
	int rows = ts_stencil_rows(s), n = s->n[0];

	for (int row = 0; row < rows; row++)
		for (int i = 0; i < n; i++)
			h->values[row * n + i] = r[ts_stencil_row(s, row) + (size_t)i];
	HYPRE_StructVectorSetBoxValues(h->b, all.low, all.high, h->values);
	HYPRE_StructVectorAssemble(h->b);
	HYPRE_StructVectorSetConstantValues(h->x, 0);
	HYPRE_StructVectorAssemble(h->x);
	HYPRE_StructPFMGSolve(h->solver, h->matrix, h->b, h->x);
	HYPRE_ClearAllErrors(); /* one cycle is not meant to converge */
	HYPRE_StructVectorGetBoxValues(h->x, all.low, all.high, h->values);
	for (int row = 0; row < rows; row++)
		for (int i = 0; i < n; i++)
			z[ts_stencil_row(s, row) + (size_t)i] = h->values[row * n + i];
}

#else

#include "base/banned.h"

bool ts_hypre_available(void)
{
	return false;
}

struct ts_hypre *ts_hypre_make(const struct ts_stencil *s)
{
	(void)s;
	return NULL;
}

void ts_hypre_release(struct ts_hypre *h)
{
	(void)h;
}

enum ts_status ts_hypre_set_weights(struct ts_hypre *h)
{
	(void)h;
	return TS_STATE;
}

void ts_hypre_cycle(void *hypre, const double *r, double *z)
{
	(void)hypre;
	(void)r;
	(void)z;
}
#endif
