#include "base/input_limit.h"

#include <stdlib.h>

#include "base/str.h"

#include "base/banned.h"

double ts_input_limit(void)
{
	const char *text = getenv(TS_INPUT_LIMIT);
	double value;

	return text && ts_parse_real(text, &value) && value >= 1e-6 && value <= 1e6 ? 1e9 * value : 4e9;
}

size_t ts_input_longest_line(void)
{
	return (size_t)(ts_input_limit() / 1000);
}
