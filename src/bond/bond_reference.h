/* The state in which a bond that transmits moments is free of shear, bending and torque: that of its creation,
 * or that in which the bond style was chosen, if that is later. */
#ifndef TS_BOND_BOND_REFERENCE_H
#define TS_BOND_BOND_REFERENCE_H

#include "bond/bonds.h"

/* Makes the references if the bond style transmits moments, and drops them if not. */
enum ts_status ts_bond_reference_require(struct tsim *sim);
/* Takes the present state as reference of the bonds that have none. */
enum ts_status ts_bond_reference_complete(struct tsim *sim);
/* Bond `to` gets the reference of bond `from`; `swapped`: with its partners in the other order. */
void ts_bond_reference_copy(struct ts_bonds *bonds, size_t from, size_t to, bool swapped);
/* Warns that the command sets positions from dumps, which have no orientations: bonds that transmit moments depend on them. */
void ts_bond_reference_doubt(struct tsim *sim, const char *command, const struct ts_place *where);

#endif
