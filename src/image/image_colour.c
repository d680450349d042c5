/* Colours of a picture by name. */
#include "image/image.h"

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
