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

enum { MOST = 2000 };

/* Forces of a field on the particles of this rank, the same on all of them. */
static int give_field(struct tsim *sim, void *data)
{
	double z[MOST], f[3 * MOST], due, energy = 0.5;
	size_t n = tsim_count(sim);

	(void)data;
	if (n > MOST || tsim_external(sim, "field", "due", &due, 1) || tsim_column_read(sim, "z", z, n))
		return 1;
	for (size_t i = 0; i < n; i++) {
		f[3 * i] = 1e-5 * z[i];
		f[3 * i + 1] = -2e-6;
		f[3 * i + 2] = 1e-4 / (1 + 100 * z[i]);
	}
	if (due == 1 && tsim_external(sim, "field", "force", f, 3 * n))
		return 1;
	return tsim_external(sim, "field", "energy", &energy, 1);
}

static int add_force(struct tsim *sim, void *data)
{
	double f[MOST], v[MOST];
	size_t n = tsim_count(sim);

	(void)data;
	if (n > MOST || tsim_column_read(sim, "fx", f, n) || tsim_column_read(sim, "vy", v, n))
		return 1;
	for (size_t i = 0; i < n; i++)
		f[i] -= 1e-5 * v[i];
	return tsim_column_write(sim, "fx", f, n);
}

/* Counts, in data, the particles in the steps that ranks do with their own alone, of all ranks. */
static int turn(struct tsim *sim, void *data)
{
	double w[MOST], id[MOST], divided, step;
	size_t n = tsim_count(sim);

	if (n > MOST || tsim_column_read(sim, "vz", w, n) || tsim_column_read(sim, "id", id, n) ||
	    tsim_setting(sim, "divided", &divided) || tsim_value(sim, "step", &step))
		return 1;
	*(double *)data += divided == 1 ? (double)n : 0;
	for (size_t i = 0; i < n; i++)
		w[i] *= (int)id[i] % 3 == (int)step % 3 ? 0.999 : 1;
	return tsim_column_write(sim, "vz", w, n);
}

static int ask_for_all(struct tsim *sim, void *data)
{
	double ke;

	(void)data;
	return tsim_value(sim, "ke", &ke);
}

static int give_rank(struct tsim *sim, void *data)
{
	return tsim_external(sim, "field", "energy", data, 1);
}

static int stop(struct tsim *sim, void *data)
{
	double step = 0;

	return tsim_value(sim, "step", &step) || (*(double *)data == 1 && step > 150) ? 7 : 0;
}

/* Functions that act in steps; `what`: a fault of them. */
static void act(struct tsim *sim, const char *what, int rank)
{
	double number = rank, seen = 0, all = 0;
	size_t n = tsim_count(sim);

	if (done(sim, tsim_line(sim, "fix field all external pf/callback 2 1")) ||
	    done(sim, tsim_on_step(sim, TSIM_BEFORE_FORCE, give_field, NULL)) ||
	    done(sim, tsim_on_step(sim, TSIM_AFTER_FORCE, add_force, NULL)) ||
	    done(sim, tsim_on_step(sim, TSIM_END_OF_STEP, turn, &seen)) ||
	    (!strcmp(what, "all") && done(sim, tsim_on_step(sim, TSIM_END_OF_STEP, ask_for_all, NULL))) ||
	    (!strcmp(what, "energy") && done(sim, tsim_on_step(sim, TSIM_AFTER_FORCE, give_rank, &number))) ||
	    (!strcmp(what, "stop") && done(sim, tsim_on_step(sim, TSIM_END_OF_STEP, stop, &number))) ||
	    done(sim, tsim_line(sim, "run 100")))
		MPI_Abort(MPI_COMM_WORLD, 1);
	MPI_Allreduce(&seen, &all, 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
	if (tsim_setting(sim, "ranks", &number) || all < (number > 1 ? 90 * (double)n : 0) ||
	    all > 100 * (double)n)
		printf("rank %d: %g particles of %zu in 100 steps\n", rank, all, n);
}

/* The program computes a fluid: each process gives the same coefficients and velocities to all particles. */
static int couple(struct tsim *sim)
{
	double x[MOST], k[MOST];
	size_t n = tsim_count(sim);

	if (n > MOST || tsim_column_read(sim, "x", x, n))
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
	double ke, drag, f[MOST], all[MOST];
	int rank, status;
	size_t n;

	if (argc > 2 && !strcmp(argv[2], "without")) /* before MPI is there */
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
	if (n > MOST || done(sim, tsim_value(sim, "ke", &ke)) ||
	    done(sim, tsim_value(sim, "f_fluid[3]", &drag)) || done(sim, tsim_gather(sim, "fz", NULL, f, n)))
		MPI_Abort(MPI_COMM_WORLD, 1);
	memcpy(all, f, sizeof *all * n);
	MPI_Bcast(all, (int)(n), MPI_DOUBLE, 0, MPI_COMM_WORLD);
	if (memcmp(all, f, sizeof *all * n) != 0)
		printf("rank %d has other forces\n", rank);
	/* Errors outside of steps are returned to all. */
	status = tsim_line(sim, "nonsense");
	if (status != TSIM_UNKNOWN)
		printf("rank %d: an error of a line is %d\n", rank, status);
	tsim_error_clear(sim);
	if (tsim_mpi_join(sim, NULL) != TSIM_STATE)
		printf("rank %d joins twice\n", rank);
	tsim_error_clear(sim);
	act(sim, argc > 2 ? argv[2] : "", rank);
	if (done(sim, tsim_value(sim, "ke+f_field", &ke)) || done(sim, tsim_gather(sim, "vz", NULL, f, n)))
		MPI_Abort(MPI_COMM_WORLD, 1);
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
