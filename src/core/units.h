/* Physical constants and defaults in the units of the script. */
#ifndef TS_CORE_UNITS_H
#define TS_CORE_UNITS_H

#include "core/sim.h"

/* Boltzmann constant k_B [energy/temperature]; exact in si since 2019. */
static inline double ts_boltzmann(const struct tsim *sim)
{
	static const double constant[] = { [TS_UNITS_LJ] = 1,
					   [TS_UNITS_SI] = 1.380649e-23,
					   [TS_UNITS_CGS] = 1.380649e-16,
					   [TS_UNITS_MICRO] = 1.380649e-8 };

	return constant[sim->units];
}

/* Default time step [time], which `units` sets. */
static inline double ts_units_dt(enum ts_units units)
{
	static const double dt[] = {
		[TS_UNITS_LJ] = 0.005, [TS_UNITS_SI] = 1e-8, [TS_UNITS_CGS] = 1e-8, [TS_UNITS_MICRO] = 2
	};

	return dt[units];
}

/* Units of the script in SI units. */
struct ts_si_units {
	double length, mass, time; /* 0: no equivalent (lj) */
};

static inline struct ts_si_units ts_si_units(enum ts_units units)
{
	static const struct ts_si_units si[] = { [TS_UNITS_LJ] = { 0, 0, 0 },
						 [TS_UNITS_SI] = { 1, 1, 1 },
						 [TS_UNITS_CGS] = { 1e-2, 1e-3, 1 },
						 [TS_UNITS_MICRO] = { 1e-6, 1e-15, 1e-6 } };

	return si[units];
}

static inline const char *ts_units_name(enum ts_units units)
{
	static const char *const names[] = {
		[TS_UNITS_LJ] = "lj", [TS_UNITS_SI] = "si", [TS_UNITS_CGS] = "cgs", [TS_UNITS_MICRO] = "micro"
	};

	return names[units];
}

#endif
