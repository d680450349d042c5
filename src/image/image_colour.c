/* Colours of a picture by name, and of the elements of surfaces. */
#include <math.h>

#include "image/image_surfaces.h"

#include "base/banned.h"

enum ts_status ts_image_find_colour(struct tsim *sim, const struct ts_image *s, const struct ts_word *word,
				    struct ts_colour *out)
{
	struct ts_suggest suggest = ts_suggest_start(word->text);

	if (ts_colour_find(&s->palette, word->text, out))
		return TS_OK;
	ts_colour_suggest(&s->palette, &suggest);
	return ts_fail(&sim->error, TS_UNKNOWN, &word->place,
		       "dump image: there is no color '%s'%s; `dump_modify color` defines others, and "
		       "0xRRGGBB is one, too",
		       word->text, suggest.best ? ts_suggest_text(&suggest) : "");
}

struct ts_colour ts_image_element_colour(const struct ts_image_surface *s, size_t element)
{
	const double value = element < s->values.rows ? s->values.data[element] : 0;

	if (!s->values.rows)
		return s->colour;
	return isnan(value) ? ts_colour_of_hex(TS_IMAGE_NAN)
			    : ts_colour_map_at(s->map, s->range[0], s->range[1], value);
}
