#include "base/axes.h"

#include <stddef.h>

#include "base/banned.h"

const char *const ts_axis_names[] = { "x", "y", "z", NULL };
