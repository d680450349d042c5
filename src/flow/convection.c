#include "flow/convection.h"

#include "base/banned.h"

const struct ts_convection_scheme ts_convection_schemes[TS_NCONVECTION] = {
	[TS_CONVECTION_DONOR] = { .name = "donor",
				  .help = "fraction gamma upwind, the rest central",
				  .order = 1,
				  .decay = 2,
				  .difference = true },
	[TS_CONVECTION_CENTRAL] = { .name = "central",
				    .help = "linear between the neighbours",
				    .order = 2,
				    .difference = true },
	/* B. P. Leonard, Comput. Meth. Appl. Mech. Eng. 19 (1979) 59 */
	[TS_CONVECTION_QUICK] = { .name = "quick",
				  .help = "a parabola through one point downstream and two upstream",
				  .order = 3,
				  .decay = 1 },
	/* M. A. Alves, P. J. Oliveira & F. T. Pinho, Int. J. Numer. Meth. Fluids 41 (2003) 47 */
	[TS_CONVECTION_CUBISTA] = { .name = "cubista",
				    .help = "quick, bounded by the neighbouring values",
				    .order = 3,
				    .bounded = true,
				    .decay = 2 },
};

const char *const ts_convection_names[] = {
	[TS_CONVECTION_DONOR] = "donor", [TS_CONVECTION_CENTRAL] = "central",
	[TS_CONVECTION_QUICK] = "quick", [TS_CONVECTION_CUBISTA] = "cubista",
	[TS_NCONVECTION] = NULL,
};
const char *const ts_flow_form_names[] = {
	[TS_FORM_VOLUME] = "fv", [TS_FORM_DIFFERENCE] = "fd", [TS_FORM_CONSERVATIVE] = "conservative", NULL
};
