/* The system of contacts: what the neighbour search needs of contact laws, and the pressure keywords of
 * thermo output. */
#ifndef TS_CONTACT_CONTACT_SYSTEM_H
#define TS_CONTACT_CONTACT_SYSTEM_H

#include "core/style.h"

extern const struct ts_system_style ts_contact_system;

#endif
