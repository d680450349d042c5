/* One contact, as contact laws see it: numbers in, a force out. The same functions serve pairs,
 * walls, tests and outputs; a wall is a partner of infinite mass. */
#ifndef TS_LAW_CONTACT_H
#define TS_LAW_CONTACT_H

struct ts_contact {
	double overlap; /* r_i + r_j - distance, > 0 */
	double n[3];    /* unit vector from j to i */
	double vn;      /* normal relative velocity (v_i - v_j).n, < 0 while approaching */
	double mass;    /* m* = m_i m_j / (m_i + m_j) */
};

/* A law gives the normal force on i along n, > 0 repelling. `coeff` are its coefficients, `history`
 * its memory of this contact (or NULL). */
typedef double ts_contact_law(const void *coeff, const struct ts_contact *contact, double *history);

#endif
