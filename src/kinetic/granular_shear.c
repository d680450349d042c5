#include "kinetic/granular_shear.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>
#include <gsl/gsl_multiroots.h>
#include <math.h>

#include "math/constants.h"

#include "base/banned.h"

/* Points by angle: twice as many change the results of the tests by less than 1e-13. */
enum { ORDER = 32 };

static const int row[TS_SHEAR_COMPONENTS] = { 0, 1, 2, 0 }, column[TS_SHEAR_COMPONENTS] = { 0, 1, 2, 1 };

/* ---- collisions */

/* Moments m = 0 .. 3 of the positive part of a Gaussian. */
static void positive_moments(double mean, double deviation, double j[4])
{
	double x = mean / deviation;

	j[0] = erfc(-x * sqrt(0.5)) / 2;
	j[1] = mean * j[0] + deviation * exp(-x * x / 2) / sqrt(2 * TS_PI);
	j[2] = mean * j[1] + deviation * deviation * j[0];
	j[3] = mean * j[2] + 2 * deviation * deviation * j[1];
}

/* Adds what pairs contribute whose line of centres is k; `weight` is that of the quadrature. */
static void add_direction(const double k[3], double weight, double eta, double rate,
			  const double moment[TS_SHEAR_COMPONENTS], struct ts_shear_collisions *out)
{
	double along[3] = { moment[TS_SHEAR_XX] * k[0] + moment[TS_SHEAR_XY] * k[1],
			    moment[TS_SHEAR_XY] * k[0] + moment[TS_SHEAR_YY] * k[1],
			    moment[TS_SHEAR_ZZ] * k[2] }; /* K.k */
	double variance = 2 * (along[0] * k[0] + along[1] * k[1] + along[2] * k[2]), j[4];

	positive_moments(-rate * k[0] * k[1], sqrt(variance), j);
	for (int c = 0; c < TS_SHEAR_COMPONENTS; c++) {
		double kk = k[row[c]] * k[column[c]];

		out->source[c] +=
			weight *
			(eta * eta * j[3] * kk -
			 2 * eta * j[1] * (along[row[c]] * k[column[c]] + along[column[c]] * k[row[c]]));
		out->stress[c] += weight * eta / 2 * j[2] * kk;
	}
	out->dissipation += weight * eta * (1 - eta) / 2 * j[3];
	out->rate += weight * j[1];
}

void ts_shear_collisions(const struct ts_gas *gas, double nu, double rate,
			 const double moment[TS_SHEAR_COMPONENTS], int order, struct ts_shear_collisions *out)
{
	gsl_integration_glfixed_table *gauss = gsl_integration_glfixed_table_alloc((size_t)order);
	double slope, often = 6 * nu / TS_PI * ts_gas_radial(gas, nu, &slope); /* n g0 d^3 */

	*out = (struct ts_shear_collisions){ .rate = 0 };
	if (!gauss) {
		*out = (struct ts_shear_collisions){ .rate = NAN, .source = { NAN, NAN, NAN, NAN } };
		return;
	}
	/* k and -k, k_z and -k_z contribute the same: angles from 0 to pi, the upper half of the points of Gauss */
	for (int a = 0; a < order / 2; a++) {
		double z, weight, s;

		gsl_integration_glfixed_point(-1, 1, (size_t)a, &z, &weight, gauss);
		s = sqrt(1 - z * z);
		for (int b = 0; b < order; b++) {
			double angle = TS_PI * (b + 0.5) / order;
			double k[3] = { s * cos(angle), s * sin(angle), z };

			add_direction(k, 4 * weight * TS_PI / order * often, (1 + gas->restitution) / 2, rate,
				      moment, out);
		}
	}
	gsl_integration_glfixed_table_free(gauss);
	for (int c = 0; c < TS_SHEAR_COMPONENTS; c++)
		out->stress[c] *= nu;
	out->dissipation *= nu;
}

/* ---- steady flow */

/* Unknown are K_yy = p^2, K_xx = p^2 (q^2 + r^2), K_zz = p^2 t^2, K_xy = p^2 r by ln p, ln q, ln t and r, so that K is
 * positive definite. */
static void moment_of(const gsl_vector *x, double moment[TS_SHEAR_COMPONENTS])
{
	double yy = exp(2 * gsl_vector_get(x, 0)), r = gsl_vector_get(x, 3);

	moment[TS_SHEAR_YY] = yy;
	moment[TS_SHEAR_XX] = yy * (exp(2 * gsl_vector_get(x, 1)) + r * r);
	moment[TS_SHEAR_ZZ] = yy * exp(2 * gsl_vector_get(x, 2));
	moment[TS_SHEAR_XY] = yy * r;
}

/* The balance of the second moment by K_yy. */
static int residual(const gsl_vector *x, void *data, gsl_vector *out)
{
	static const double work[TS_SHEAR_COMPONENTS][TS_SHEAR_COMPONENTS] = {
		[TS_SHEAR_XX][TS_SHEAR_XY] = 2, [TS_SHEAR_XY][TS_SHEAR_YY] = 1
	};
	const struct ts_granular_shear *s = data;
	double moment[TS_SHEAR_COMPONENTS];
	struct ts_shear_collisions now;

	moment_of(x, moment);
	ts_shear_collisions(&s->gas, s->solids, 1, moment, ORDER, &now);
	for (size_t c = 0; c < TS_SHEAR_COMPONENTS; c++) {
		double sum = now.source[c];

		for (int k = 0; k < TS_SHEAR_COMPONENTS; k++)
			sum -= work[c][k] * moment[k];
		sum /= moment[TS_SHEAR_YY];
		if (!isfinite(sum))
			return GSL_EDOM;
		gsl_vector_set(out, c, sum);
	}
	return GSL_SUCCESS;
}

static void set_flow(struct ts_granular_shear *s, const gsl_vector *x)
{
	const double *k = s->moment, *p = s->stress;

	moment_of(x, s->moment);
	s->temperature = (k[TS_SHEAR_XX] + k[TS_SHEAR_YY] + k[TS_SHEAR_ZZ]) / 3;
	ts_shear_collisions(&s->gas, s->solids, 1, s->moment, ORDER, &s->collisions);
	for (int c = 0; c < TS_SHEAR_COMPONENTS; c++)
		s->stress[c] = s->solids * k[c] + s->collisions.stress[c];
	s->imbalance = fabs(s->collisions.dissipation / p[TS_SHEAR_XY] + 1);
}

/* Powell's hybrid method until it stops to improve. */
static enum ts_status iterate(struct ts_granular_shear *s, gsl_multiroot_fsolver *solver, gsl_vector *x)
{
	gsl_multiroot_function balance = { residual, TS_SHEAR_COMPONENTS, s };
	struct ts_gas lun = s->gas;
	int code;

	lun.theory = TS_GAS_LUN;
	gsl_vector_set_zero(x);
	gsl_vector_set(x, 0, log(ts_gas_sheared_temperature(&lun, s->solids)) / 2);
	gsl_vector_set(x, 3, -0.3 * sqrt(1 - lun.restitution));
	code = gsl_multiroot_fsolver_set(solver, &balance, x);
	for (int k = 0; k < 400 && code == GSL_SUCCESS; k++)
		code = gsl_multiroot_fsolver_iterate(solver);
	/* no progress is what an exact solution ends with */
	if (gsl_multiroot_test_residual(solver->f, 1e-9) != GSL_SUCCESS)
		return TS_PHYSICS;
	set_flow(s, solver->x);
	return TS_OK;
}

enum ts_status ts_granular_shear_solve(struct ts_granular_shear *s)
{
	gsl_error_handler_t *handler = gsl_set_error_handler_off();
	gsl_multiroot_fsolver *solver =
		gsl_multiroot_fsolver_alloc(gsl_multiroot_fsolver_hybrids, TS_SHEAR_COMPONENTS);
	gsl_vector *x = gsl_vector_alloc(TS_SHEAR_COMPONENTS);
	enum ts_status status = solver && x ? iterate(s, solver, x) : TS_NOMEM;

	if (solver)
		gsl_multiroot_fsolver_free(solver);
	if (x)
		gsl_vector_free(x);
	gsl_set_error_handler(handler);
	return status;
}
