#include "render/camera.h"

#include "math/vec3.h"

#include "base/banned.h"

bool ts_camera_look(struct ts_camera *camera, double theta, double phi, const double up[3])
{
	double along, length;

	camera->towards[0] = sin(theta) * cos(phi);
	camera->towards[1] = sin(theta) * sin(phi);
	camera->towards[2] = cos(theta);
	along = ts_dot(up, camera->towards);
	for (int d = 0; d < 3; d++)
		camera->up[d] = up[d] - along * camera->towards[d];
	length = ts_norm(camera->up);
	if (!(length > 1e-9 * ts_norm(up)))
		return false;
	ts_scale(1 / length, camera->up, camera->up);
	ts_cross(camera->up, camera->towards, camera->right);
	return true;
}

void ts_camera_zoom(struct ts_camera *camera, const double box_length[3], double zoom)
{
	const double largest = fmax(fmax(box_length[0], box_length[1]), box_length[2]);

	camera->scale = camera->height * zoom / (2 * largest);
}

void ts_camera_project(const struct ts_camera *camera, const double x[3], double out[3])
{
	double d[3];

	ts_sub(x, camera->centre, d);
	out[0] = 0.5 * camera->width + camera->scale * ts_dot(d, camera->right);
	out[1] = 0.5 * camera->height - camera->scale * ts_dot(d, camera->up);
	out[2] = camera->scale * ts_dot(d, camera->towards);
}
