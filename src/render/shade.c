#include "render/shade.h"

#include <math.h>

#include "base/banned.h"

static const double PI = 3.14159265358979323846;

/* Angles of the lights (degree): around the vertical axis of the picture from the camera to the right, then upwards. */
static const double angles[3][2] = { { -45, 30 }, { 30, 0 }, { 180, 15 } };

struct ts_shade ts_shade_make(const struct ts_picture_style *style)
{
	const struct ts_lights *l = &style->lights;
	struct ts_shade s = { .ambient = (float)l->ambient,
			      .light = { (float)l->key, (float)l->fill, (float)l->back },
			      .shiny = (float)(0.5 * style->shiny),
			      .hardness = (float)(8 + 56 * style->shiny) };

	for (int k = 0; k < 3; k++) {
		const double phi = angles[k][0] * PI / 180, theta = angles[k][1] * PI / 180;

		s.direction[k][0] = (float)(cos(theta) * sin(phi));
		s.direction[k][1] = (float)sin(theta);
		s.direction[k][2] = (float)(cos(theta) * cos(phi));
	}
	for (int k = 0; k < 2; k++) {
		const double x = (double)s.direction[k][0], y = (double)s.direction[k][1],
			     z = (double)s.direction[k][2] + 1, length = sqrt(x * x + y * y + z * z);

		s.middle[k][0] = (float)(x / length);
		s.middle[k][1] = (float)(y / length);
		s.middle[k][2] = (float)(z / length);
	}
	return s;
}

static float cosine(const float a[3], const float b[3])
{
	float c = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

	return c > 0 ? c : 0;
}

/* Lambert's law; highlights by J. F. Blinn, Computer Graphics 11 (1977) 192. */
void ts_shade_surface(const struct ts_shade *s, const float n[3], const struct ts_colour *colour,
		      float out[3])
{
	float diffuse = s->ambient, highlight = 0;

	for (int k = 0; k < 3; k++)
		diffuse += s->light[k] * cosine(n, s->direction[k]);
	for (int k = 0; k < 2 && s->shiny > 0; k++)
		highlight += s->light[k] * powf(cosine(n, s->middle[k]), s->hardness);
	for (int k = 0; k < 3; k++)
		out[k] = colour->c[k] * diffuse + s->shiny * highlight;
}
