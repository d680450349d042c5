#include "math/gsl.h"

#include <gsl/gsl_errno.h>

#include "base/banned.h"

void ts_math_init(void)
{
	gsl_set_error_handler_off();
}
