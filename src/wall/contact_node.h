/* Nodes of a quadrature over the time of a contact that is computed as a whole, not step by step: the integral of f dt over
 * the contact is the sum of f duration. */
#ifndef TS_WALL_CONTACT_NODE_H
#define TS_WALL_CONTACT_NODE_H

#include <stddef.h>

struct ts_contact_node {
	double time;	 /* since the touch */
	double duration; /* weight, time */
	double overlap;
	double force[3];    /* on the particle */
	double velocity[3]; /* of its centre relative to the surface at the contact point */
	double omega[3];    /* of the particle */
	double shift[3];    /* of its centre along the surface since the touch, length */
};

struct ts_contact_nodes {
	struct ts_contact_node *item;
	size_t n, capacity;
};

#endif
