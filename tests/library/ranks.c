/* A program with ranks: what all of them read is the same, and equal to what one process prints. */
#include <mpi.h>
#include <stdio.h>
#include <string.h>
#include <tsim_mpi.h>

static int done(struct tsim *sim, int status)
{
	if (status)
		fputs(tsim_error(sim), stderr);
	return status;
}

static int no_step(struct tsim *sim, void *data)
{
	(void)sim, (void)data;
	return 0;
}

/* The program computes a fluid: each process gives the same coefficients and velocities to all particles. */
static int couple(struct tsim *sim)
{
	double x[2000], k[2000];
	size_t n = tsim_count(sim);

	if (n > 2000 || tsim_column_read(sim, "x", x, n))
		return 1;
	for (size_t i = 0; i < n; i++) {
		k[i] = 1e-3 * (1 + x[i]);
		x[i] = 0.2 + 10 * x[i];
	}
	return tsim_column_write(sim, "Ksl", k, n) || tsim_column_write(sim, "uf[3]", x, n) ||
	       tsim_step(sim, 20);
}

int main(int argc, char **argv)
{
	struct tsim *sim = tsim_open();
	double ke, drag, ranks, f[2000], all[2000];
	int rank, status;
	size_t n;

	if (argc > 2) /* before MPI is there */
		return tsim_mpi_join(sim, NULL) == TSIM_STATE &&
				       strstr(tsim_error(sim), "MPI is not initialised")
			       ? 0
			       : 1;
	MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &rank);
	MPI_Comm_rank(MPI_COMM_WORLD, &rank);
	tsim_screen(sim, stdout);
	if (done(sim, tsim_mpi_join(sim, NULL)) || done(sim, tsim_log(sim, "log.ranks")) ||
	    done(sim, tsim_file(sim, argv[1])) ||
	    done(sim, tsim_line(sim, "fix cfd all couple/cfd couple_every 20 mpi")) ||
	    done(sim, tsim_line(sim, "fix fluid all couple/cfd/force/implicit")) || done(sim, couple(sim)) ||
	    done(sim, couple(sim)))
		MPI_Abort(MPI_COMM_WORLD, 1);
	n = tsim_count(sim);
	if (n > 2000 || done(sim, tsim_value(sim, "ke", &ke)) ||
	    done(sim, tsim_value(sim, "f_fluid[3]", &drag)) || done(sim, tsim_gather(sim, "fz", NULL, f, n)))
		MPI_Abort(MPI_COMM_WORLD, 1);
	memcpy(all, f, sizeof *all * n);
	MPI_Bcast(all, (int)(n), MPI_DOUBLE, 0, MPI_COMM_WORLD);
	if (memcmp(all, f, sizeof *all * n) != 0)
		printf("rank %d has other forces\n", rank);
	/* Errors outside of steps are returned to all; functions that act in steps are refused. */
	status = tsim_line(sim, "nonsense");
	if (status != TSIM_UNKNOWN)
		printf("rank %d: an error of a line is %d\n", rank, status);
	tsim_error_clear(sim);
	if (tsim_mpi_join(sim, NULL) != TSIM_STATE)
		printf("rank %d joins twice\n", rank);
	tsim_error_clear(sim);
	if (tsim_setting(sim, "ranks", &ranks) == TSIM_OK && ranks > 1 &&
	    tsim_on_step(sim, TSIM_AFTER_FORCE, no_step, NULL) == TSIM_OK)
		printf("rank %d acts in steps\n", rank);
	tsim_error_clear(sim);
	if (rank == 0) {
		printf("end %zu %.17g %.17g", n, ke, drag);
		for (size_t k = 0; k < n; k += 50)
			printf(" %.17g", f[k]);
		printf("\n");
	}
	tsim_close(sim);
	MPI_Finalize();
	return 0;
}
