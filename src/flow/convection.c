#include "flow/convection.h"

#include "base/banned.h"

const char *const ts_convection_names[] = {
	[TS_CONVECTION_DONOR] = "donor",     [TS_CONVECTION_CENTRAL] = "central",
	[TS_CONVECTION_QUICK] = "quick",     [TS_CONVECTION_CUBISTA] = "cubista",
	[TS_NCONVECTION] = NULL,
};
const char *const ts_form_names[] = { [TS_FORM_VOLUME] = "fv", [TS_FORM_DIFFERENCE] = "fd", NULL };
