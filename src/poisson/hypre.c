#include "poisson/hypre.h"

#include "base/alloc.h"

#ifdef TS_WITH_HYPRE
#include <HYPRE.h>
#include <HYPRE_struct_ls.h>
#include <mpi.h>
#include <stdlib.h>
#include <string.h>

#include "base/banned.h"

struct ts_hypre {
	const struct ts_stencil *s;
	struct ts_slabs slabs; /* of ranks that divide it; always active then */
	MPI_Comm ranks;
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

bool ts_hypre_divides(void)
{
#ifdef HYPRE_SEQUENTIAL
	return false;
#else
	return true;
#endif
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

/* Corners of the range of the cells of this rank; hypre's functions take pointers to non-constant data. */
struct corners {
	int low[3], high[3];
};

static struct corners own_cells(const struct ts_hypre *h)
{
	const struct ts_stencil *s = h->s;
	size_t from, to;

	ts_slabs_own(&h->slabs, (size_t)s->n[2], &from, &to);
	return (struct corners){ .low = { 0, 0, (int)from },
				 .high = { s->n[0] - 1, s->n[1] - 1, (int)to - 1 } };
}

static void make_parts(struct ts_hypre *h)
{
	const struct ts_stencil *s = h->s;
	int offset[4][3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } }, period[3];
	struct corners own = own_cells(h);

	for (int d = 0; d < 3; d++)
		period[d] = s->periodic[d] ? s->n[d] : 0;
	HYPRE_StructGridCreate(h->ranks, s->axes, &h->grid);
	HYPRE_StructGridSetExtents(h->grid, own.low, own.high);
	HYPRE_StructGridSetPeriodic(h->grid, period);
	HYPRE_StructGridAssemble(h->grid);
	HYPRE_StructStencilCreate(s->axes, s->axes + 1, &h->stencil);
	for (int k = 0; k <= s->axes; k++)
		HYPRE_StructStencilSetElement(h->stencil, k, offset[k]);
	HYPRE_StructMatrixCreate(h->ranks, h->grid, h->stencil, &h->matrix);
	HYPRE_StructMatrixSetSymmetric(h->matrix, 1);
	HYPRE_StructMatrixInitialize(h->matrix);
	HYPRE_StructVectorCreate(h->ranks, h->grid, &h->b);
	HYPRE_StructVectorInitialize(h->b);
	HYPRE_StructVectorCreate(h->ranks, h->grid, &h->x);
	HYPRE_StructVectorInitialize(h->x);
}

struct ts_hypre *ts_hypre_make(const struct ts_stencil *s, struct ts_world *world)
{
	struct ts_hypre *h = ts_alloc(1, sizeof *h);
	size_t cells = (size_t)s->n[0] * (size_t)s->n[1] * (size_t)s->n[2];

	if (!h)
		return NULL;
	h->s = s;
	h->ranks = MPI_COMM_SELF;
	h->values = ts_alloc_aligned(cells * ((size_t)s->axes + 1), sizeof *h->values);
	if (!h->values || ts_slabs_make(&h->slabs, world, s->n[2]) != TS_OK) {
		ts_slabs_release(&h->slabs);
		ts_free(h->values);
		ts_free(h);
		return NULL;
	}
	h->slabs.active = world != NULL;
	initialize_mpi();
	if (world) /* its own, so that messages of hypre do not mix with others */
		MPI_Comm_dup(*(const MPI_Comm *)world->communicator, &h->ranks);
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
	if (h->ranks != MPI_COMM_SELF)
		MPI_Comm_free(&h->ranks);
	ts_slabs_release(&h->slabs);
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
	struct corners own = own_cells(h);
	int entry[4] = { 0, 1, 2, 3 };
	double *value = h->values;

	for (int k = own.low[2]; k <= own.high[2]; k++)
		for (int j = 0; j < s->n[1]; j++)
			for (int i = 0; i < s->n[0]; i++, value += s->axes + 1)
				fill_cell(s, ts_stencil_at(s, i, j, k), (int[3]){ i + 1, j + 1, k + 1 },
					  value);
	HYPRE_StructMatrixSetBoxValues(h->matrix, own.low, own.high, s->axes + 1, entry, h->values);
	HYPRE_StructMatrixAssemble(h->matrix);
	destroy_solver(h);
	HYPRE_StructPFMGCreate(h->ranks, &h->solver);
	HYPRE_StructPFMGSetMaxIter(h->solver, 1);
	HYPRE_StructPFMGSetTol(h->solver, 0);
	HYPRE_StructPFMGSetZeroGuess(h->solver);
	HYPRE_StructPFMGSetRelaxType(h->solver, 2); /* red-black, symmetric */
	HYPRE_StructPFMGSetNumPreRelax(h->solver, 1);
	HYPRE_StructPFMGSetNumPostRelax(h->solver, 1);
	HYPRE_StructPFMGSetup(h->solver, h->matrix, h->b, h->x);
	return HYPRE_GetError() ? TS_PHYSICS : TS_OK;
}

/* Copies the rows of this rank between a field and the values for hypre. */
static void copy_rows(struct ts_hypre *h, const double *from, double *to)
{
	const struct ts_stencil *s = h->s;
	const struct corners own = own_cells(h);
	double *value = h->values;

	for (int row = own.low[2] * s->n[1]; row < (own.high[2] + 1) * s->n[1]; row++, value += s->n[0]) {
		const size_t at = ts_stencil_row(s, row);

		if (to)
			memcpy(to + at, value, (size_t)s->n[0] * sizeof *value);
		else
			memcpy(value, from + at, (size_t)s->n[0] * sizeof *value);
	}
}

void ts_hypre_cycle(void *hypre, const double *r, double *z)
{
	struct ts_hypre *h = hypre;
	const struct ts_stencil *s = h->s;
	struct corners own = own_cells(h);
	const struct ts_slabs_field planes = { z + ts_stencil_at(s, 0, 0, 0), (size_t)s->stride[2], 0, 0 };

	copy_rows(h, r, NULL);
	HYPRE_StructVectorSetBoxValues(h->b, own.low, own.high, h->values);
	HYPRE_StructVectorAssemble(h->b);
	HYPRE_StructVectorSetConstantValues(h->x, 0);
	HYPRE_StructVectorAssemble(h->x);
	HYPRE_StructPFMGSolve(h->solver, h->matrix, h->b, h->x);
	HYPRE_ClearAllErrors(); /* one cycle is not meant to converge */
	HYPRE_StructVectorGetBoxValues(h->x, own.low, own.high, h->values);
	copy_rows(h, NULL, z);
	if (ts_slabs_ranks(s->slabs) == 1)
		ts_slabs_share(&h->slabs, &planes);
}

#else

#include "base/banned.h"

bool ts_hypre_available(void)
{
	return false;
}

bool ts_hypre_divides(void)
{
	return false;
}

struct ts_hypre *ts_hypre_make(const struct ts_stencil *s, struct ts_world *world)
{
	(void)s;
	(void)world;
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
