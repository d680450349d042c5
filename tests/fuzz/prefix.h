/* Headers that most files include: compiled once for fuzzing, so that clang does not read them again for each file. */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include "box/domain.h"
#include "core/ranks.h"
#include "core/report.h"
#include "core/sim.h"
#include "core/style.h"
#include "math/vec3.h"
#include "neigh/neigh.h"
#include "particle/particles.h"
#include "region/region.h"
