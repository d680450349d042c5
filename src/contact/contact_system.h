/* The system of contacts: what the search for neighbours asks of their laws, and the pressure in the table
 * of the log. */
#ifndef TS_CONTACT_CONTACT_SYSTEM_H
#define TS_CONTACT_CONTACT_SYSTEM_H

#include "core/style.h"

extern const struct ts_system_style ts_contact_system;

#endif
