/* Flow and shear stress in a cross-section of the film, as functions of the gap.
 *
 * With the slip lengths b1, b2 the fluid at the surfaces has the velocities U1 + b1 du/dz and U2 - b2 du/dz (C. Navier,
 * Mem. Acad. Sci. 6 (1823) 389). The parabola with these conditions has, with H = h + b1 + b2,
 *   q = h [(h/2 + b2) U1 + (h/2 + b1) U2]/H - h^2 (h^2 + 4 h (b1 + b2) + 12 b1 b2)/(12 eta H) grad p
 *   eta du/dz = eta (U2 - U1)/H - h (h/2 + b2)/H grad p at the lower surface,
 *               eta (U2 - U1)/H + h (h/2 + b1)/H grad p at the upper one. */
#include "film/internal.h"

#include "base/banned.h"

bool ts_film_is_plain(const struct ts_film *f)
{
	return !ts_film_slips(f) && !ts_film_is_rough(f);
}

struct ts_film_section ts_film_section(const struct ts_film *f, int axis, double h)
{
	double b1 = f->slip[0], b2 = f->slip[1], sheared = h + b1 + b2;
	struct ts_film_section s = { .drag = { 1 / h, 1 / h },
				     .poiseuille = h * h * h,
				     .couette = { h / 2, h / 2 },
				     .grip = { h / 2, h / 2 } };

	if (ts_film_is_rough(f))
		ts_film_add_roughness(f, axis, h, &s);
	if (!ts_film_slips(f))
		return s;
	s.drag[0] = s.drag[1] = 1 / sheared;
	s.poiseuille = h * h * (h * h + 4 * h * (b1 + b2) + 12 * b1 * b2) / sheared;
	s.couette[0] = s.grip[0] = h * (h / 2 + b2) / sheared;
	s.couette[1] = s.grip[1] = h * (h / 2 + b1) / sheared;
	return s;
}

void ts_film_slip_velocity(const struct ts_film *f, double h, double mean, const double wall[2],
			   double fluid[2])
{
	double b1 = f->slip[0], b2 = f->slip[1], low = h * wall[0] + 6 * b1 * mean;
	double high = h * wall[1] + 6 * b2 * mean;
	double scale = h * h + 4 * h * (b1 + b2) + 12 * b1 * b2;

	fluid[0] = ((h + 4 * b2) * low - 2 * b1 * high) / scale;
	fluid[1] = ((h + 4 * b1) * high - 2 * b2 * low) / scale;
}
