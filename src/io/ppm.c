#include "io/ppm.h"

#include <stdio.h>
#include <string.h>

#include "io/replace.h"

#include "base/banned.h"

enum ts_status ts_ppm_write(struct tsim *sim, const char *path, const struct ts_place *where, uint32_t width,
			    uint32_t height, const unsigned char *rgb)
{
	struct ts_replace file = { 0 };
	enum ts_status status = ts_replace_begin(&file, sim, where, path);
	char head[48];

	snprintf(head, sizeof head, "P6\n%u %u\n255\n", (unsigned)width, (unsigned)height);
	if (status == TS_OK)
		status = ts_replace_write(&file, head, strlen(head));
	if (status == TS_OK)
		status = ts_replace_write(&file, rgb, 3 * (size_t)width * height);
	if (status == TS_OK)
		status = ts_replace_commit(&file, false);
	ts_replace_abandon(&file);
	return status;
}
