#include "rough/asperity_theory.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>
#include <math.h>

#include "base/alloc.h"
#include "math/constants.h"
#include "math/convolution.h"

#include "base/banned.h"

/* ---- moments: <|grad h|^2> = <h D h> with D = q^2, <(laplace h)^2> with D = q^4 */

struct operator
{
	int n[2];
	double size[2];
	int power; /* of q^2 */
};

static double wave_number_power(const void *context, int k, int l)
{
	const struct operator* o = context;
	double square =
		4 * TS_PI * TS_PI * (k / o->size[0] * (k / o->size[0]) + l / o->size[1] * (l / o->size[1]));

	return o->power == 1 ? square : square * square;
}

/* Mean of h D h. */
static enum ts_status mean_product(struct ts_convolution *c, const struct operator* o, const double *height,
				   double *work, double *out)
{
	size_t n = (size_t)o->n[0] * (size_t)o->n[1];
	double sum = 0;

	ts_convolution_set_spectrum(c, wave_number_power, o);
	TS_TRY(ts_convolution_apply(c, height, work));
	for (size_t k = 0; k < n; k++)
		sum += height[k] * work[k];
	*out = sum / (double)n;
	return TS_OK;
}

double ts_rough_variance(size_t n, const double *height)
{
	double mean = 0, square = 0;

	for (size_t k = 0; k < n; k++)
		mean += height[k] / (double)n;
	for (size_t k = 0; k < n; k++)
		square += (height[k] - mean) * (height[k] - mean);
	return square / (double)n;
}

enum ts_status ts_rough_moments(const int n[2], const double width[2], const double *height,
				struct ts_rough_moments *out)
{
	struct operator first = { { n[0], n[1] }, { n[0] * width[0], n[1] * width[1] }, 1 }, second = first;
	size_t cells = (size_t)n[0] * (size_t)n[1];
	double *work = ts_alloc(cells, sizeof *work);
	struct ts_convolution c;
	double slope = 0, curvature = 0;
	enum ts_status status = ts_convolution_make(&c, n, true, 1);

	second.power = 2;
	if (status == TS_OK)
		status = work ? mean_product(&c, &first, height, work, &slope) : TS_NOMEM;
	if (status == TS_OK)
		status = mean_product(&c, &second, height, work, &curvature);
	*out = (struct ts_rough_moments){ ts_rough_variance(cells, height), slope / 2, 3 * curvature / 8 };
	ts_convolution_release(&c);
	ts_free(work);
	return status;
}

/* ---- theories */

double ts_rough_persson_area(const struct ts_rough_moments *m, double pressure)
{
	return erf(pressure / sqrt(m->m2));
}

double ts_rough_bush_area(const struct ts_rough_moments *m, double pressure)
{
	return sqrt(TS_PI / m->m2) * pressure;
}

void ts_rough_asperities(const struct ts_rough_moments *m, struct ts_rough_asperities *out)
{
	double breadth = m->m0 * m->m4 / (m->m2 * m->m2);

	*out = (struct ts_rough_asperities){
		.density = m->m4 / (6 * sqrt(3) * TS_PI * m->m2),
		.radius = 3.0 / 8 * sqrt(TS_PI / m->m4),
		.deviation = sqrt((1 - 0.8968 / breadth) * m->m0),
		.offset = 4 * sqrt(m->m0 / (TS_PI * breadth)),
	};
}

/* Normal density, and its integral from t on. */
static double density(double t)
{
	return exp(-t * t / 2) / sqrt(2 * TS_PI);
}

static double tail(double t)
{
	return 0.5 * erfc(t / sqrt(2));
}

double ts_rough_greenwood_area(const struct ts_rough_asperities *a, double distance)
{
	double t = distance / a->deviation;

	return TS_PI * a->density * a->radius * a->deviation * (density(t) - t * tail(t));
}

static double overlap_load(double x, void *distance)
{
	return x * sqrt(x) * density(*(double *)distance + x);
}

/* int_0^inf x^3/2 density(t + x) dx; the density vanishes beyond 40 deviations. */
static double load_integral(double t)
{
	double from = fmax(0, -t - 40), to = fmax(1, 40 - t), value = NAN, error;
	gsl_function f = { overlap_load, &t };
	gsl_integration_workspace *work;
	gsl_error_handler_t *handler = gsl_set_error_handler_off();

	work = gsl_integration_workspace_alloc(200);
	if (work && gsl_integration_qag(&f, from, to, 0, 1e-12, 200, GSL_INTEG_GAUSS61, work, &value, &error))
		value = NAN;
	if (work)
		gsl_integration_workspace_free(work);
	gsl_set_error_handler(handler);
	return value;
}

double ts_rough_greenwood_pressure(const struct ts_rough_asperities *a, double distance)
{
	return 4.0 / 3 * a->density * sqrt(a->radius) * pow(a->deviation, 1.5) *
	       load_integral(distance / a->deviation);
}

double ts_rough_greenwood_distance(const struct ts_rough_asperities *a, double pressure)
{
	double low = -a->deviation, high = 35 * a->deviation;

	while (ts_rough_greenwood_pressure(a, low) < pressure && low > -1e6 * a->deviation)
		low *= 2;
	if (!(ts_rough_greenwood_pressure(a, low) >= pressure &&
	      ts_rough_greenwood_pressure(a, high) < pressure))
		return NAN;
	for (;;) { /* the pressure falls with the distance: bisection */
		double middle = low + 0.5 * (high - low);

		if (!(middle > low && middle < high))
			return middle;
		if (ts_rough_greenwood_pressure(a, middle) >= pressure)
			low = middle;
		else
			high = middle;
	}
}
